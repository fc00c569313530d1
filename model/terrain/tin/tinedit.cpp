// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/terrain/tin/tinedit.h"

#include "model/terrain/tin/constraints/constraintlists.h"
#include "model/terrain/tin/removal/removal.h"
#include "model/terrain/tin/removal/ringremoval.h"

#include <algorithm>
#include <cassert>

namespace model::terrain {

namespace {

/// Begins recording before the writer asks whether somebody is.
Journal &begun(Journal &journal, const TinArrays &tin)
{
    journal.begin(tin);
    return journal;
}

} // namespace

TinEdit::TinEdit(Tin &tin, VolumeRule rule)
    : mTin(tin)
    , mArrays(tin.mArrays)
    , mRule(rule)
    , mWriter(tin.mArrays, begun(tin.mJournal, tin.mArrays))
{
    if (rule == VolumeRule::GiveBack)
        mWriter.noteReconnected();
}

TinEdit::~TinEdit()
{
    if (mIsOpen)
        rollBack();
}

VertexId TinEdit::insert(Point2 p, VertexId near)
{
    assert(mIsOpen && mTin.domain().contains(p));
    const Location location = mTin.locate(p, near);
    if (location.kind == Location::Kind::Vertex)
        return mArrays.vertex(location.corner);
    const bool hasLayers = mArrays.layerCount() > 0;
    Weights weights;
    VertexId v = None;
    if (location.kind == Location::Kind::Edge) {
        if (hasLayers)
            weights = weightsOn(mArrays, location.corner, p);
        const VertexId a = mArrays.vertex(next(location.corner)), b = mArrays.vertex(previous(location.corner));
        v = mWriter.addVertex(p, heightOn(mArrays, location.corner, p));
        mWriter.splitEdge(location.corner, v);
        if (mArrays.constraints[a] != None)
            splitRecords(mWriter, a, b, v);
    } else {
        if (hasLayers)
            weights = weightsIn(mArrays, triangleOf(location.corner), p);
        v = mWriter.addVertex(p, heightIn(mArrays, triangleOf(location.corner), p));
        mWriter.splitTriangle(triangleOf(location.corner), v);
    }
    if (hasLayers)
        mWriter.setColumn(v, weights);
    mWriter.restoreDelaunayAround(v);
    mTin.mHints.note(v, p);
    return v;
}

VertexId TinEdit::insert(Point2 p, double height, VertexId near)
{
    const VertexId v = insert(p, near);
    setHeight(v, height);
    return v;
}

bool TinEdit::canRemove(VertexId v) const
{
    return canRemoveVertex(mArrays, v);
}

void TinEdit::remove(VertexId v)
{
    assert(mIsOpen);
    const Point2 p = mArrays.points[v];
    const VertexId neighbour = mArrays.vertex(next(mArrays.corners[v]));
    removeVertex(mWriter, v);
    mTin.mHints.replace(v, p, neighbour);
}

bool TinEdit::removeInside(std::span<const VertexId> ring)
{
    assert(mIsOpen);
    RingInside inside(mArrays, ring);
    if (inside.vertices().empty())
        return false;
    inside.remove(mWriter);
    for (const VertexId v : inside.vertices())
        mTin.mHints.replace(v, mArrays.points[v], ring.front());
    return true;
}

void TinEdit::setHeight(VertexId v, double height)
{
    assert(mIsOpen);
    const double difference = height - mArrays.heights[v];
    if (difference == 0)
        return;
    const double volume = difference * areaOf(v);
    Ledger &ledger = mArrays.totals.ledger;
    if (volume > 0)
        ledger.added.add(volume);
    else
        ledger.removed.add(-volume);
    mWriter.moveSurface(v, height);
}

void TinEdit::displace(VertexId v, double height)
{
    assert(mIsOpen);
    const double before = mArrays.heights[v];
    mWriter.moveSurface(v, height);
    mWriter.leak.add((height - before) * areaOf(v));
}

void TinEdit::bookLeak(double volume)
{
    assert(mIsOpen);
    Ledger &ledger = mArrays.totals.ledger;
    if (volume > 0)
        ledger.added.add(volume);
    else
        ledger.removed.add(-volume);
    mWriter.leak.add(-volume);
}

void TinEdit::bookMoved(double volume)
{
    assert(mIsOpen && volume >= 0);
    mArrays.totals.ledger.moved.add(volume);
}

void TinEdit::giveBack(std::span<const VertexId> vertices, std::span<const double> weights)
{
    assert(mIsOpen && (weights.empty() || weights.size() == vertices.size()));
    lift(vertices, weights, -mWriter.leak.value(), std::numeric_limits<double>::infinity());
}

void TinEdit::giveBackVolume(std::span<const VertexId> vertices, double volume, std::span<const double> weights,
                             double most)
{
    assert(mIsOpen && (weights.empty() || weights.size() == vertices.size()));
    lift(vertices, weights, volume, most);
}

/// Raises `vertices`, each by its weight, so that `volume` comes under them, or as much of it as `most` allows.
void TinEdit::lift(std::span<const VertexId> vertices, std::span<const double> weights, double volume, double most)
{
    const auto weight = [&](std::size_t i) { return weights.empty() ? 1 : weights[i]; };
    std::vector<double> areas;
    areas.reserve(vertices.size());
    CompensatedSum weighted;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        areas.push_back(areaOf(vertices[i]));
        weighted.add(areas[i] * weight(i));
    }
    if (!(weighted.value() > 0))
        return;
    const double height = std::clamp(volume / weighted.value(), -most, most);
    // What the surface really gains, rounding of the heights and all, is what the leak falls by.
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const VertexId v = vertices[i];
        const double before = mArrays.heights[v];
        mWriter.moveSurface(v, before + height * weight(i));
        mWriter.leak.add((mArrays.heights[v] - before) * areas[i]);
    }
}

Edit TinEdit::end()
{
    assert(mIsOpen);
    mIsOpen = false;
    mWriter.takeReconnected();
    return mTin.mJournal.end(mArrays);
}

void TinEdit::settle()
{
    assert(mIsOpen);
    const std::vector<VertexId> reconnected = mWriter.takeReconnected();
    if (mRule == VolumeRule::GiveBack && mWriter.leak.value() != 0)
        giveBack(reconnected);
    // Nothing, or the rounding of the heights; all of it if it is to be kept.
    mArrays.totals.ledger.kept.add(mWriter.leak.value());
    mWriter.leak = {};
}

Edit TinEdit::commit()
{
    settle();
    Edit edit = end();
    if (mTin.mHints.isTooCoarse(mArrays))
        mTin.mHints.build(mArrays, mTin.mDomain);
    return edit;
}

void TinEdit::rollBack()
{
    Edit edit = end();
    mTin.swap(edit);
}

} // namespace model::terrain
