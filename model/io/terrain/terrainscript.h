// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/io/terrain/newterrain.h"
#include "model/io/terrain/terrainimport.h"
#include "model/terrain/erosion/erosion.h"
#include "model/terrain/tools/stroke.h"

#include <variant>

namespace model::io {

// What a script does to a terrain, one step after the other. docs/terrain-script.md has the words.

struct StrokeStep
{
    terrain::Stroke stroke;
    std::optional<terrain::OwnerId> owner;
};
/// Lets material slide: for a time, or until it rests.
struct ErosionStep
{
    terrain::ErosionSettings settings;
    std::optional<double> seconds; ///< none: until it rests
    terrain::ErosionBudget budget;
};
struct MaterialStep
{
    std::uint32_t index = 0; ///< in the list; its length: a new one
    terrain::Material material;
};
struct AddLayerStep
{
    std::optional<std::uint32_t> layer;                      ///< none: on top
    std::variant<std::uint32_t, terrain::Material> material; ///< its place in the list, or one that comes into the list
    terrain::LayerSample sample;                             ///< everywhere; the bedrock gives way
};
struct RemoveLayerStep
{
    std::uint32_t layer = 0;
};
struct SimplifyStep
{
    double maxError = 0;
};
struct ValidateStep
{};
struct RepeatStep;

using ScriptStep = std::variant<StrokeStep, ErosionStep, MaterialStep, AddLayerStep, RemoveLayerStep, SimplifyStep,
                                ValidateStep, RepeatStep>;

struct RepeatStep
{
    std::uint32_t count = 1;
    std::vector<ScriptStep> steps;
};

struct TerrainScript
{
    std::variant<std::monostate, NewTerrain, QString> start; ///< QString: a file to open or import
    TerrainImportOptions import;
    std::vector<ScriptStep> steps;
};

/// \error SyntaxError (its byte), BadSetting: the path of the value, the value, what it may be
Result<TerrainScript> parseScript(std::span<const std::uint8_t> json);

/// What the steps did, in cubic metres and pieces.
struct ScriptReport
{
    std::uint64_t strokes = 0, stamps = 0, transfers = 0;
    double scooped = 0;
};

/// Carries the steps out. \error as the tools and erosion say, with the path of the step; Cancelled
/// On an error the terrain is as it was after the step before.
Result<ScriptReport> runScript(const TerrainScript &script, terrain::Terrain &terrain,
                               const Progress &progress = Progress());

} // namespace model::io
