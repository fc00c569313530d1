// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/animation/sequence.h"
#include "model/codec/trialencoder.h"

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace bench {

/// A sequence to be compressed, and what is prepared for it once.
struct Subject
{
    std::string name;
    std::shared_ptr<const model::Sequence> animation;

    double bpfv(std::uint64_t bytes) const
    {
        return 8.0 * double(bytes) / animation->frameCount() / animation->vertexCount();
    }
};

inline constexpr double NotMeasured = std::numeric_limits<double>::quiet_NaN();

/// One row of the table.
struct Measurement
{
    std::string codec;
    std::string setting;
    std::uint64_t bytes = 0;            ///< everything: connectivity in them
    double kgErrorPercent = 0;          ///< of what was decoded, in the order of the input
    double encodeSeconds = NotMeasured; ///< with the setting given, on the wall clock
    double decodeSeconds = NotMeasured; ///< to the positions of all frames
    double searchSeconds = NotMeasured; ///< for the setting
};

/// A codec that the table compares.
class Contender
{
public:
    virtual ~Contender() = default;
    /// The smallest that it makes of the animation with a KG error of at most `percent`; a row for each way of counting
    /// or of coding that is worth one. No row where it cannot come so close.
    virtual std::vector<Measurement> reach(const Subject &subject, double percent) = 0;
    /// One row whatever the target.
    virtual bool isLossless() const { return false; }
};

std::unique_ptr<Contender> makePredicting(model::CodecId codec); ///< ours, by the search that the program has
std::unique_ptr<Contender> makeDirect();                         ///< all predictors, both coders
std::unique_ptr<Contender> makeXzOfFloats();
std::unique_ptr<Contender> makeXzOfCells();
std::unique_ptr<Contender> makeDraco(); ///< null where the program was built without it

/// The coarsest resolution of `direct` that keeps to a KG error; nothing if none does. Searched once for each.
std::optional<std::uint32_t> directResolution(const Subject &subject, double percent);

} // namespace bench
