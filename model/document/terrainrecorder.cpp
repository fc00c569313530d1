// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/document/terrainrecorder.h"

#include <algorithm>
#include <cmath>

namespace model {

using namespace terrain;

TerrainRecorder::TerrainRecorder(const TerrainDocument &document, const RecordingLimits &limits, QObject *parent)
    : QObject(parent)
    , mDocument(document)
    , mFrameRate(limits.frameRate)
{
    const Rectangle &domain = document.tin().domain();
    const double width = domain.high.x - domain.low.x, height = domain.high.y - domain.low.y;
    // Squares, as nearly as the number of vertices allows.
    const auto most = double(std::max(limits.vertices, 4u));
    mColumns = std::uint32_t(std::clamp(std::sqrt(most * width / height), 2.0, most / 2));
    mRows = std::uint32_t(std::max(most / mColumns, 2.0));
    mPlaces.reserve(std::size_t(mColumns) * mRows);
    for (std::uint32_t row = 0; row < mRows; ++row)
        for (std::uint32_t column = 0; column < mColumns; ++column) {
            const double x = domain.low.x + width * column / (mColumns - 1);
            const double y = domain.low.y + height * row / (mRows - 1);
            mPlaces.push_back({std::min(x, domain.high.x), std::min(y, domain.high.y)});
        }
    mFrameLimit = std::uint32_t(std::clamp<std::uint64_t>(limits.bytes / (mPlaces.size() * sizeof(float)), 1, 1 << 20));
    mMiddle = document.tin().heightAt({domain.low.x + width / 2, domain.low.y + height / 2});
    sample();
    connect(&document, &TerrainDocument::changed, this,
            [this](const TerrainChange &change) { mHasChanged |= std::holds_alternative<SurfaceChanged>(change); });
    connect(&mBeat, &QTimer::timeout, this, &TerrainRecorder::takeFrame);
    mBeat.setTimerType(Qt::PreciseTimer);
    mBeat.start(int(std::lround(1000 / mFrameRate)));
}

template <class Visit>
void TerrainRecorder::forEachPlace(Visit visit) const
{
    const Tin &tin = mDocument.tin();
    VertexId near = None; // places follow one another: a short walk
    for (const Point2 &place : mPlaces) {
        const TriangleId triangle = tin.triangleAt(place, near);
        near = tin.arrays().vertex(cornerOf(triangle, 0));
        visit(place, triangle, near);
    }
}

void TerrainRecorder::sample()
{
    std::vector<float> &heights = mHeights.emplace_back();
    heights.reserve(mPlaces.size());
    forEachPlace([&](Point2 place, TriangleId, VertexId near) {
        heights.push_back(float(mDocument.tin().heightAt(place, near) - mMiddle));
    });
    mHasChanged = false;
}

void TerrainRecorder::takeFrame()
{
    if (!mHasChanged || frameCount() >= mFrameLimit)
        return;
    sample();
    emit frameTaken();
    if (frameCount() >= mFrameLimit) {
        mBeat.stop();
        emit limitReached();
    }
}

Connectivity TerrainRecorder::connectivity() const
{
    std::vector<bool> isVoid;
    forEachPlace(
        [&](Point2, TriangleId triangle, VertexId) { isVoid.push_back(mDocument.tin().arrays().isVoid(triangle)); });
    Connectivity connectivity;
    connectivity.vertexCount = std::uint32_t(mPlaces.size());
    for (std::uint32_t row = 0; row + 1 < mRows; ++row)
        for (std::uint32_t column = 0; column + 1 < mColumns; ++column) {
            const std::uint32_t a = row * mColumns + column, b = a + 1, c = a + mColumns, d = c + 1;
            if (isVoid[a] || isVoid[b] || isVoid[c] || isVoid[d])
                continue;
            // Counter-clockwise from above: z points south.
            connectivity.triangles.push_back({a, b, d});
            connectivity.triangles.push_back({a, d, c});
        }
    return connectivity;
}

FrameSourcePtr TerrainRecorder::finish(std::string name)
{
    mBeat.stop();
    if (mHasChanged && frameCount() < mFrameLimit)
        sample();
    const Rectangle &domain = mDocument.tin().domain();
    const Point2 middle{(domain.low.x + domain.high.x) / 2, (domain.low.y + domain.high.y) / 2};
    std::vector<Vec3f> places;
    places.reserve(mPlaces.size());
    for (const Point2 &place : mPlaces)
        places.push_back({float(place.x - middle.x), 0, float(middle.y - place.y)});
    return std::make_shared<HeightFrames>(connectivity(), std::move(places), std::move(mHeights), mFrameRate,
                                          std::move(name));
}

} // namespace model
