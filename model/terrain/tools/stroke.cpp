// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/terrain/tools/stroke.h"

#include "model/terrain/tools/livestroke.h"

#include <algorithm>
#include <cmath>

namespace model::terrain {

namespace {

Result<void> check(const Imprint &tool)
{
    if (const auto prepared = ImprintStroke::prepare(tool); !prepared)
        return fail(prepared.error());
    return {};
}

} // namespace

const char *nameOf(const Tool &tool)
{
    static constexpr const char *Names[] = {"imprint", "rake",    "raise", "lower", "flatten",   "smooth", "noise",
                                            "ramp",    "restore", "pour",  "scoop", "breakline", "moisten"};
    static_assert(std::size(Names) == std::variant_size_v<Tool>);
    return Names[tool.index()];
}

namespace {

/// All but the tool's own settings.
Result<void> checkWay(const Stroke &stroke)
{
    if (const Result<void> checked = checkPath(stroke.path); !checked)
        return checked;
    if (const auto *ramp = std::get_if<Ramp>(&stroke.tool)) {
        const Point2 a = stroke.path.front().at, b = stroke.path.back().at;
        const double stamps = std::hypot(b.x - a.x, b.y - a.y) / ramp->brush.radius;
        if (!(stamps < double(LargestStampCount)))
            return fail(ErrorCode::LimitExceeded, "length of a ramp in radii", std::to_string(stamps),
                        std::to_string(LargestStampCount));
    }
    return stroke.symmetry.check();
}

} // namespace

Result<void> check(const Tool &tool)
{
    return std::visit([](const auto &t) { return check(t); }, tool);
}

Result<void> check(const Stroke &stroke)
{
    if (const Result<void> checked = check(stroke.tool); !checked)
        return checked;
    return checkWay(stroke);
}

Result<StrokeReport> draw(TinEdit &edit, const Stroke &stroke, OwnerId owner, ToolMemory &memory)
{
    auto live =
        LiveStroke::begin(edit.tin(), stroke.tool, stroke.symmetry, owner == None ? nextFreeOwner(edit.tin()) : owner);
    if (!live)
        return fail(live.error());
    if (const Result<void> checked = checkWay(stroke); !checked)
        return fail(checked.error());
    for (const PathPoint &point : stroke.path)
        if (const Result<void> added = live->add(point); !added)
            return fail(added.error());
    live->end();
    if (const Result<void> drawn = live->draw(edit, memory); !drawn)
        return fail(drawn.error());
    return live->report();
}

Result<DoneStroke> draw(Tin &tin, const Stroke &stroke, OwnerId owner, ToolMemory &memory)
{
    TinEdit edit(tin, VolumeRule::Keep); // tools give back what they owe; only rounding is left to keep
    Result<StrokeReport> report = draw(edit, stroke, owner, memory);
    if (!report)
        return fail(std::move(report.error()));
    return DoneStroke{edit.commit(), *report};
}

Result<DoneStroke> draw(Tin &tin, const Stroke &stroke, OwnerId owner)
{
    ToolMemory memory;
    return draw(tin, stroke, owner, memory);
}

OwnerId nextFreeOwner(const Tin &tin)
{
    OwnerId next = 1;
    const auto &records = tin.arrays().records;
    for (std::size_t r = 0; r < records.size(); ++r)
        if (records[r].a != None && records[r].owner != VoidOwner)
            next = std::max(next, records[r].owner + 1);
    return next;
}

Touched touchedBy(const Tin &tin, const Edit &edit)
{
    const TinArrays &arrays = tin.arrays();
    Touched touched;
    const auto unique = [](auto &ids) {
        std::sort(ids.begin(), ids.end());
        ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
    };
    for (const SlotRange range : edit.dirtyRanges(TinPart::Heights))
        for (VertexId v = range.first; v < range.first + range.count; ++v)
            if (arrays.isVertex(v))
                touched.vertices.push_back(v);
    for (const SlotRange range : edit.dirtyRanges(TinPart::Triangles))
        for (TriangleId t = range.first; t < range.first + range.count; ++t)
            for (std::uint32_t i = 0; arrays.isTriangle(t) && i < 3; ++i)
                touched.vertices.push_back(arrays.vertex(cornerOf(t, i)));
    unique(touched.vertices);
    for (const VertexId v : touched.vertices)
        forEachCornerAround(arrays, v, [&](Corner c) { touched.triangles.push_back(triangleOf(c)); });
    unique(touched.triangles);
    return touched;
}

} // namespace model::terrain
