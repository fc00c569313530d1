// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/animation/settingsfields.h"
#include "model/document/animationdocument.h"

#include <cmath>
#include <string>
#include <vector>

namespace tests {

/// What a document says of itself, as plain values, so that a test can break each rule by hand.
struct AnimationState
{
    std::uint32_t sourceFrameCount;
    std::vector<double> sourcePositions;
    double frameRate;
    model::Similarity placement;
    model::CompressionSettings compression;
    std::string name;

    std::uint32_t shownFrameCount;
    std::vector<double> shownSourcePositions;
    double shownFrameRate;
    model::Similarity shownPlacement;
    std::string shownName;
    bool showsSource;        ///< the frames are those of the document's source
    bool positionsAreFinite; ///< of first, middle and last frame
};

inline AnimationState stateOf(const model::AnimationDocument &document)
{
    const auto frames = document.frames();
    const auto listOf = [](std::span<const double> values) {
        return std::vector<double>(values.begin(), values.end());
    };
    bool finite = true;
    for (const std::uint32_t frame : {0u, frames->frameCount() / 2, frames->frameCount() - 1})
        for (const model::Vec3f &position : frames->frame(frame))
            finite = finite && isFinite(position);
    return {document.source()->frameCount(),
            listOf(document.timing().map.sourcePositions()),
            document.timing().frameRate,
            document.placement(),
            document.compression(),
            document.name(),
            frames->frameCount(),
            listOf(frames->timeMap().sourcePositions()),
            frames->frameRate(),
            frames->placement(),
            frames->name(),
            frames->source() == document.source(),
            finite};
}

/// The rules that hold for every document at every moment; returns the broken ones, all of them.
inline std::vector<std::string> brokenRules(const AnimationState &state)
{
    std::vector<std::string> broken;
    const auto rule = [&broken](bool holds, const char *text) {
        if (!holds)
            broken.emplace_back(text);
    };
    rule(!state.sourcePositions.empty(), "there is a frame");
    bool inSource = true;
    for (const double position : state.sourcePositions)
        inSource = inSource && position >= 0 && position <= state.sourceFrameCount - 1;
    rule(inSource, "every frame lies in the source");
    rule(state.frameRate > 0 && std::isfinite(state.frameRate), "the rate is above zero");
    bool placementIsFinite = std::isfinite(state.placement.scale);
    for (const double offset : state.placement.offset)
        placementIsFinite = placementIsFinite && std::isfinite(offset);
    rule(placementIsFinite && state.placement.scale > 0, "the placement is finite and its scale above zero");
    model::visitFields(state.compression.method, [&](const auto &field, auto value) {
        rule(field.allows(value), (std::string(field.key) + " is in range").c_str());
    });
    rule(state.shownFrameCount == state.sourcePositions.size() && state.shownSourcePositions == state.sourcePositions,
         "the frames follow the time map");
    rule(state.shownFrameRate == state.frameRate, "the frames have the rate");
    rule(state.shownPlacement == state.placement, "the frames have the placement");
    rule(state.shownName == state.name, "the frames have the name");
    rule(state.showsSource, "the frames are those of the source");
    rule(state.positionsAreFinite, "positions are finite");
    return broken;
}

inline std::vector<std::string> brokenRules(const model::AnimationDocument &document)
{
    return brokenRules(stateOf(document));
}

} // namespace tests
