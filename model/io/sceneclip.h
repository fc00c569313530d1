// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

struct aiAnimation;

namespace model::io {

/// The animations of a scene that play at the same time: one of glTF and FBX, all of a Collada file without clips.
/// Private to scenereader.cpp.
class SceneClip
{
public:
    /// \param animations  empty for a scene that stands still
    explicit SceneClip(std::vector<const aiAnimation *> animations);

    const std::vector<const aiAnimation *> &animations() const { return mAnimations; }

    /// Frames per second of the keys: of the usual gap in the channel with the most keys. Formats store no rate, and
    /// most exporters write a key per frame. 25 if there is nothing to see.
    double keyRate() const;

    /// Frames from the first key to the end, which may lie a rounding error before its frame; at least 1.
    double frameCount(double rate) const;

    /// Where a frame lies, in the scene's own unit of time. The first frame is at the first key: many exporters count
    /// frames from 1, and their first one would be there twice.
    double timeOf(double frame, double rate) const;

private:
    std::vector<const aiAnimation *> mAnimations;
    double mTicksPerSecond;
    double mBegin = 0; ///< ticks
    double mEnd = 0;   ///< ticks
};

} // namespace model::io
