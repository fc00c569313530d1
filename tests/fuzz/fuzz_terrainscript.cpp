// SPDX-License-Identifier: GPL-3.0-or-later
// Terrain scripts: parsed, and the short ones played on a small terrain.
#include "model/io/terrain/terrainscript.h"
#include "model/terrain/tin/validate.h"
#include "tests/fuzz/require.h"

using namespace model;
using namespace model::io;

namespace {

/// What a step may cost: playing is not what is looked for here, and one stroke may have 100,000 stamps.
bool isCheap(const ScriptStep &step)
{
    if (const auto *const stroke = std::get_if<StrokeStep>(&step))
        return stroke->stroke.path.size() <= 4 &&
               std::all_of(stroke->stroke.path.begin(), stroke->stroke.path.end(),
                           [](const terrain::PathPoint &p) { return std::abs(p.at.x) < 20 && std::abs(p.at.y) < 20; });
    return !std::holds_alternative<ErosionStep>(step) && !std::holds_alternative<RepeatStep>(step);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    const auto script = parseScript({data, size});
    if (!script) {
        SANDREEL_REQUIRE(script.error().code == ErrorCode::SyntaxError || !script.error().args.empty());
        return 0;
    }
    if (script->steps.size() > 4 || !std::all_of(script->steps.begin(), script->steps.end(), isCheap))
        return 0;
    auto terrain = makeTerrain({10, 10, 0, 0, 0, 2, {{}}});
    SANDREEL_REQUIRE(terrain.has_value());
    (void)runScript(*script, *terrain);
    SANDREEL_REQUIRE(terrain::findDefects(terrain->tin).empty());
    return 0;
}
