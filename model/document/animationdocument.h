// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/animation/compressionsettings.h"
#include "model/animation/editedframes.h"
#include "model/document/animationchange.h"

#include <QObject>

#include <optional>

namespace model {

/// Which frames are shown, in which order and how fast.
struct Timing
{
    TimeMap map;
    double frameRate; ///< frames per second, above zero

    friend bool operator==(const Timing &, const Timing &) = default;
};

/// An animation being edited: an immutable source and, over it, everything that edits change (time map, placement,
/// name, compression settings). Knows nothing of undo, files or views: commands call the setters, each of which returns
/// the value that it replaced and emits one notice, only when something differs.
class AnimationDocument final : public QObject
{
    Q_OBJECT

public:
    /// \param settings  those of the file it was opened from, or the defaults
    explicit AnimationDocument(FrameSourcePtr source, CompressionSettings settings = {}, QObject *parent = nullptr);

    /// The animation as edited: an immutable snapshot that workers may keep.
    std::shared_ptr<const EditedFrames> frames() const { return mFrames; }
    const FrameSourcePtr &source() const { return mSource; }

    std::uint32_t frameCount() const { return mTiming.map.frameCount(); }
    std::uint32_t vertexCount() const { return mSource->vertexCount(); }
    const Connectivity &connectivity() const { return mSource->connectivity(); }
    const Timing &timing() const { return mTiming; }
    const Similarity &placement() const { return mPlacement; }
    const std::string &name() const { return mName; }
    const CompressionSettings &compression() const { return mCompression; }

    /// Precondition: every position of the map is at most source()->frameCount() - 1; rate above zero.
    Timing setTiming(Timing timing);
    /// Precondition: scale above zero.
    Similarity setPlacement(const Similarity &placement);
    std::string setName(std::string name);
    CompressionSettings setCompression(const CompressionSettings &settings);

    /// A digest of everything that is saved: equal fingerprints mean that the same file would be written.
    std::uint64_t fingerprint() const;

signals:
    void changed(const model::AnimationChange &change);

private:
    void rebuildFrames();

    const FrameSourcePtr mSource;
    Timing mTiming;
    Similarity mPlacement;
    std::string mName;
    CompressionSettings mCompression;
    std::shared_ptr<const EditedFrames> mFrames;
};

} // namespace model
