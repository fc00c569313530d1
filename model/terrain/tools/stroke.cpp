// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/terrain/tools/stroke.h"

#include <algorithm>
#include <cmath>

namespace model::terrain {

namespace {

template <class... Cases>
struct Overloaded : Cases...
{
    using Cases::operator()...;
};
template <class... Cases>
Overloaded(Cases...) -> Overloaded<Cases...>;

Result<void> check(const Imprint &tool)
{
    if (const auto prepared = ImprintStroke::prepare(tool); !prepared)
        return fail(prepared.error());
    return {};
}

/// Metres between two stamps; 0 for tools that are not stamped.
double spacingOf(const Tool &tool)
{
    return std::visit(Overloaded{[](const Imprint &t) { return t.spacing * t.radius; },
                                 [](const Rake &t) { return t.spacing * t.width / t.tines; },
                                 [](const Ramp &) { return 0.0; }, [](const Breakline &) { return 0.0; },
                                 [](const auto &t) { return t.brush.spacing * t.brush.radius; }},
                      tool);
}

/// A total before and what was added to it since.
struct Since
{
    CompensatedSum start;

    double of(const CompensatedSum &now) const { return (now.sum - start.sum) + (now.lost - start.lost); }
};

/// The stamps of a stroke along its path, each with its mirrored copies at once.
class Stamper
{
public:
    Stamper(TinEdit &edit, const Symmetry &symmetry, std::vector<StampPose> poses, ToolMemory &memory)
        : mEdit(edit)
        , mSymmetry(symmetry)
        , mPoses(std::move(poses))
        , mMemory(memory)
    {}

    /// Copies that lie upon each other are stamped once.
    template <class Visit>
    void forEachPose(Visit visit)
    {
        for (const StampPose &pose : mPoses)
            for (std::uint32_t i = 0; i < mSymmetry.count(); ++i) {
                const StampPose copy = mSymmetry.copyOf(pose, i);
                bool isRepeated = false;
                for (std::uint32_t k = 0; k < i; ++k)
                    isRepeated = isRepeated || mSymmetry.copyOf(pose, k).at == copy.at;
                if (!isRepeated)
                    visit(copy, i);
            }
    }

    template <class BrushTool>
    std::uint32_t run(const BrushTool &tool)
    {
        std::uint32_t stamps = 0;
        forEachPose([&](const StampPose &pose, std::uint32_t) {
            stamp(mEdit, tool, pose, mMemory);
            ++stamps;
        });
        return stamps;
    }
    std::uint32_t run(const Flatten &tool)
    {
        std::vector<double> levels; // of each copy, before the stroke
        for (std::uint32_t i = 0; i < mSymmetry.count(); ++i)
            levels.push_back(tool.level.value_or(groundAt(mSymmetry.copyOf(mPoses.front().at, i))));
        std::uint32_t stamps = 0;
        forEachPose([&](const StampPose &pose, std::uint32_t i) {
            stamp(mEdit, tool, pose, levels[i], mMemory);
            ++stamps;
        });
        return stamps;
    }
    Result<std::uint32_t> run(const Imprint &tool, OwnerId owner, StrokeReport &report)
    {
        auto imprint = ImprintStroke::prepare(tool);
        if (!imprint)
            return fail(imprint.error());
        struct Pressed
        {
            StampPose pose;
            double sole;
        };
        std::vector<Pressed> stamps; // the ground as it is before the first
        forEachPose([&](const StampPose &pose, std::uint32_t) {
            if (isMaskedOut(tool.mask, pose.at))
                return;
            stamps.push_back({pose, imprint->soleAt(mEdit.tin(), pose)});
        });
        for (const Pressed &pressed : stamps) {
            imprint->stamp(mEdit, pressed.pose, pressed.sole, owner++, mMemory);
            report.nextOwner = owner;
        }
        report.compressed = imprint->report().compressed;
        return std::uint32_t(stamps.size());
    }

private:
    Point2 inDomain(Point2 p) const
    {
        const Rectangle &domain = mEdit.tin().domain();
        return {std::clamp(p.x, domain.low.x, domain.high.x), std::clamp(p.y, domain.low.y, domain.high.y)};
    }
    double groundAt(Point2 p) const { return mEdit.tin().heightAt(inDomain(p)); }
    bool isMaskedOut(const Mask &mask, Point2 p) const
    {
        if (mask.isEverywhere())
            return false;
        const Tin &tin = mEdit.tin();
        const double slope = slopeOf(tin.arrays(), tin.triangleAt(inDomain(p))) * 180 / M_PI;
        return mask.weightOf(slope, groundAt(p)) <= 0.5;
    }

    TinEdit &mEdit;
    const Symmetry &mSymmetry;
    const std::vector<StampPose> mPoses;
    ToolMemory &mMemory;
};

Result<std::uint32_t> run(TinEdit &edit, const Stroke &stroke, OwnerId owner, ToolMemory &memory, StrokeReport &report)
{
    const Symmetry &symmetry = stroke.symmetry;
    if (const auto *ramp = std::get_if<Ramp>(&stroke.tool)) {
        for (std::uint32_t i = 0; i < symmetry.count(); ++i)
            makeRamp(edit, *ramp, symmetry.copyOf(stroke.path.front().at, i), symmetry.copyOf(stroke.path.back().at, i),
                     stroke.path.front().pressure, memory);
        return symmetry.count();
    }
    if (const auto *breakline = std::get_if<Breakline>(&stroke.tool)) {
        report.nextOwner = owner + 1;
        const std::vector<Point2> corners = cornersOf(stroke.path);
        for (std::uint32_t i = 0; i < symmetry.count(); ++i) {
            std::vector<Point2> copy;
            for (const Point2 p : corners)
                copy.push_back(symmetry.copyOf(p, i));
            if (const Result<void> done = insertBreakline(edit, *breakline, copy, owner); !done)
                return fail(done.error());
        }
        return symmetry.count();
    }
    auto poses = resample(stroke.path, spacingOf(stroke.tool));
    if (!poses)
        return fail(poses.error());
    if (poses->size() * symmetry.count() > LargestStampCount)
        return fail(ErrorCode::LimitExceeded, "number of stamps", std::to_string(poses->size() * symmetry.count()),
                    std::to_string(LargestStampCount));
    Stamper stamper(edit, symmetry, std::move(*poses), memory);
    return std::visit(Overloaded{[&](const Imprint &tool) { return stamper.run(tool, owner, report); },
                                 [&](const Ramp &) { return Result<std::uint32_t>(0); },
                                 [&](const Breakline &) { return Result<std::uint32_t>(0); },
                                 [&](const auto &tool) { return Result<std::uint32_t>(stamper.run(tool)); }},
                      stroke.tool);
}

} // namespace

const char *nameOf(const Tool &tool)
{
    static constexpr const char *Names[] = {"imprint", "rake", "raise",   "lower", "flatten", "smooth",
                                            "noise",   "ramp", "restore", "pour",  "scoop",   "breakline"};
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

Result<void> check(const Stroke &stroke)
{
    if (const Result<void> checked = std::visit([](const auto &tool) { return check(tool); }, stroke.tool); !checked)
        return checked;
    return checkWay(stroke);
}

Result<StrokeReport> draw(TinEdit &edit, const Stroke &stroke, OwnerId owner, ToolMemory &memory)
{
    // An imprint's settings are checked where its sole is made, once.
    const Result<void> checked = std::holds_alternative<Imprint>(stroke.tool) ? checkWay(stroke) : check(stroke);
    if (!checked)
        return fail(checked.error());
    if (owner == None)
        owner = nextFreeOwner(edit.tin());
    if (owner > VoidOwner - LargestStampCount)
        return fail(ErrorCode::LimitExceeded, "number of stamps", std::to_string(owner),
                    std::to_string(VoidOwner - LargestStampCount));
    const Ledger before = edit.tin().ledger();
    StrokeReport report;
    report.nextOwner = owner;
    const Result<std::uint32_t> stamps = run(edit, stroke, owner, memory, report);
    if (!stamps)
        return fail(stamps.error());
    report.stamps = *stamps;
    const Ledger &after = edit.tin().ledger();
    report.added = Since{before.added}.of(after.added);
    report.removed = Since{before.removed}.of(after.removed);
    report.moved = Since{before.moved}.of(after.moved);
    return report;
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
