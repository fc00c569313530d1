// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/terrain/tools/livestroke.h"

#include <algorithm>
#include <cassert>
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

/// Metres between two stamps; 0 for tools that are not stamped.
double spacingOf(const Tool &tool)
{
    return std::visit(Overloaded{[](const Imprint &t) { return t.spacing * t.radius; },
                                 [](const Rake &t) { return t.spacing * t.width / t.tines; },
                                 [](const Ramp &) { return 0.0; }, [](const Breakline &) { return 0.0; },
                                 [](const auto &t) { return t.brush.spacing * t.brush.radius; }},
                      tool);
}

/// Whether a stamp depends on where the pen goes, not only on where it is.
bool hasDirection(const Tool &tool)
{
    return std::holds_alternative<Imprint>(tool) || std::holds_alternative<Rake>(tool);
}

/// A total before and what was added to it since.
struct Since
{
    CompensatedSum start;

    double of(const CompensatedSum &now) const { return (now.sum - start.sum) + (now.lost - start.lost); }
};

} // namespace

LiveStroke::LiveStroke(const Tin &tin, const Tool &tool, const Symmetry &symmetry, OwnerId owner)
    : mTool(tool)
    , mSymmetry(symmetry)
    , mDomain(tin.domain())
    , mGround(tin)
    , mOwner(owner)
{
    mReport.nextOwner = owner;
}

Result<LiveStroke> LiveStroke::begin(const Tin &tin, const Tool &tool, const Symmetry &symmetry, OwnerId owner)
{
    const auto *imprint = std::get_if<Imprint>(&tool);
    if (!imprint) // its settings are checked where its sole is made, once
        if (const Result<void> checked = check(tool); !checked)
            return fail(checked.error());
    if (const Result<void> checked = symmetry.check(); !checked)
        return fail(checked.error());
    if (owner > VoidOwner - LargestStampCount)
        return fail(ErrorCode::LimitExceeded, "number of stamps", std::to_string(owner),
                    std::to_string(VoidOwner - LargestStampCount));
    LiveStroke stroke(tin, tool, symmetry, owner);
    if (imprint) {
        auto prepared = ImprintStroke::prepare(*imprint);
        if (!prepared)
            return fail(prepared.error());
        stroke.mImprint = std::move(*prepared);
    }
    if (const double spacing = spacingOf(tool); spacing > 0) {
        auto sampler = PathSampler::create(spacing, LargestStampCount / symmetry.count());
        if (!sampler)
            return fail(sampler.error());
        stroke.mSampler = std::move(*sampler);
    }
    return stroke;
}

bool LiveStroke::isWhole() const
{
    return !mSampler;
}

Result<void> LiveStroke::add(const PathPoint &point)
{
    assert(!mIsEnded);
    if (mSampler) {
        if (Result<void> added = mSampler->add(point); !added)
            return added;
    } else if (Result<void> checked = checkPath({&point, 1}); !checked) {
        return checked;
    }
    mPath.push_back(point);
    prepare();
    return {};
}

void LiveStroke::end()
{
    mIsEnded = true;
    if (mSampler) {
        mSampler->end();
        prepare();
    }
}

std::size_t LiveStroke::readyCount() const
{
    return hasDirection(mTool) ? mSampler->settledCount() : mSampler->poses().size();
}

bool LiveStroke::isDue() const
{
    return isWhole() ? mIsEnded && !mPath.empty() : !mPrepared.empty();
}

Point2 LiveStroke::inDomain(Point2 p) const
{
    return {std::clamp(p.x, mDomain.low.x, mDomain.high.x), std::clamp(p.y, mDomain.low.y, mDomain.high.y)};
}

bool LiveStroke::isMaskedOut(const Mask &mask, Point2 p) const
{
    if (mask.isEverywhere())
        return false;
    return mask.openAt(p) * mask.weightOf(mGround.slopeAt(inDomain(p)), mGround.heightAt(inDomain(p))) <= 0.5;
}

/// Copies that lie upon each other are stamped once.
std::vector<LiveStroke::Copy> LiveStroke::copiesOf(const StampPose &pose) const
{
    std::vector<Copy> copies;
    for (std::uint32_t i = 0; i < mSymmetry.count(); ++i) {
        const StampPose copy = mSymmetry.copyOf(pose, i);
        bool isRepeated = false;
        for (std::uint32_t k = 0; k < i; ++k)
            isRepeated = isRepeated || mSymmetry.copyOf(pose, k).at == copy.at;
        if (!isRepeated)
            copies.push_back({copy, i, 0});
    }
    return copies;
}

/// Asks the ground before the stroke about the places that have become due.
void LiveStroke::prepare()
{
    if (!mSampler)
        return;
    const std::span<const StampPose> poses = mSampler->poses();
    if (const auto *flatten = std::get_if<Flatten>(&mTool); flatten && mLevels.empty() && !poses.empty())
        for (std::uint32_t i = 0; i < mSymmetry.count(); ++i)
            mLevels.push_back(
                flatten->level.value_or(mGround.heightAt(inDomain(mSymmetry.copyOf(poses.front().at, i)))));
    const auto *imprint = std::get_if<Imprint>(&mTool);
    for (; mPreparedCount < readyCount(); ++mPreparedCount) {
        std::vector<Copy> copies = copiesOf(poses[mPreparedCount]);
        if (imprint) {
            std::erase_if(copies, [&](const Copy &copy) { return isMaskedOut(imprint->mask, copy.pose.at); });
            for (Copy &copy : copies)
                copy.sole = mImprint->soleAt(copy.pose, mGround.heightAt(inDomain(copy.pose.at)));
        }
        mPrepared.push_back(std::move(copies));
    }
}

void LiveStroke::stampAt(TinEdit &edit, const std::vector<Copy> &copies, ToolMemory &memory)
{
    for (const Copy &copy : copies) {
        std::visit(
            Overloaded{[&](const Imprint &) {
                           mImprint->stamp(edit, copy.pose, copy.sole, mOwner++, memory);
                           mReport.nextOwner = mOwner;
                       },
                       [&](const Flatten &tool) { terrain::stamp(edit, tool, copy.pose, mLevels[copy.copy], memory); },
                       [](const Ramp &) {}, [](const Breakline &) {},
                       [&](const auto &tool) { terrain::stamp(edit, tool, copy.pose, memory); }},
            mTool);
        ++mReport.stamps;
    }
    edit.settle();
}

Result<void> LiveStroke::drawWhole(TinEdit &edit, ToolMemory &memory)
{
    if (const Result<void> checked = check(Stroke{mTool, mPath, mSymmetry}); !checked)
        return checked;
    if (const auto *ramp = std::get_if<Ramp>(&mTool)) {
        for (std::uint32_t i = 0; i < mSymmetry.count(); ++i)
            makeRamp(edit, *ramp, mSymmetry.copyOf(mPath.front().at, i), mSymmetry.copyOf(mPath.back().at, i),
                     mPath.front().pressure, memory);
    } else {
        mReport.nextOwner = mOwner + 1;
        const std::vector<Point2> corners = cornersOf(mPath);
        for (std::uint32_t i = 0; i < mSymmetry.count(); ++i) {
            std::vector<Point2> copy;
            for (const Point2 p : corners)
                copy.push_back(mSymmetry.copyOf(p, i));
            if (const Result<void> done = insertBreakline(edit, std::get<Breakline>(mTool), copy, mOwner); !done)
                return fail(done.error());
        }
    }
    mReport.stamps = mSymmetry.count();
    mPath.clear();
    return {};
}

Result<void> LiveStroke::draw(TinEdit &edit, ToolMemory &memory, std::size_t most)
{
    const Ledger before = edit.tin().ledger();
    if (!isWhole()) {
        for (std::size_t i = 0; i < most && !mPrepared.empty(); ++i) {
            stampAt(edit, mPrepared.front(), memory);
            mPrepared.pop_front();
        }
    } else if (isDue()) {
        if (const Result<void> done = drawWhole(edit, memory); !done)
            return done;
    }
    const Ledger &after = edit.tin().ledger();
    mReport.added += Since{before.added}.of(after.added);
    mReport.removed += Since{before.removed}.of(after.removed);
    mReport.moved += Since{before.moved}.of(after.moved);
    if (mImprint)
        mReport.compressed = mImprint->report().compressed;
    return {};
}

void LiveStroke::note(const Edit &edit)
{
    if (mImprint && !mIsEnded)
        mGround.note(edit);
}

} // namespace model::terrain
