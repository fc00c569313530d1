// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/codec/connectivity/walkstatistics.h"

#include "model/codec/connectivity/meshsource.h"

namespace model::codec {

namespace {

class Counter final : public WalkObserver
{
public:
    explicit Counter(std::size_t triangleCount) { mStatistics.symbolOf.resize(triangleCount); }

    WalkStatistics take()
    {
        std::sort(mStatistics.splits.begin(), mStatistics.splits.end());
        std::sort(mStatistics.handleSplits.begin(), mStatistics.handleSplits.end());
        return std::move(mStatistics);
    }

    void startComponent() override
    {
        ++mStatistics.components;
        mLast.reset();
    }
    void triangle(std::uint32_t triangle, Clers symbol) override
    {
        ++mStatistics.symbolCounts[std::size_t(symbol)];
        mStatistics.symbolOf[triangle] = symbol;
        if (mLast)
            ++mStatistics.followCounts[std::size_t(*mLast)][std::size_t(symbol)];
        mLast = symbol;
        if (symbol == Clers::S)
            mStatistics.splits.push_back(triangle);
    }
    void handle(std::uint32_t triangle) override
    {
        mStatistics.splits.pop_back();
        mStatistics.handleSplits.push_back(triangle);
    }
    void hole(std::uint32_t triangle, std::uint32_t length) override
    {
        mStatistics.holes.push_back({length, triangle == NoTriangle ? std::nullopt : std::optional(triangle)});
    }

private:
    WalkStatistics mStatistics;
    std::optional<Clers> mLast;
};

} // namespace

Result<WalkStatistics> walkStatistics(const Connectivity &connectivity, const Progress &progress)
{
    Counter counter(connectivity.triangles.size());
    const auto encoded = encodeConnectivityWatched(connectivity, progress, &counter);
    if (!encoded)
        return fail(encoded.error());
    WalkStatistics statistics = counter.take();
    statistics.bytes = encoded->bytes.size();
    statistics.copies = encoded->coded.corners.vertexCount() - [&] {
        std::uint32_t used = 0;
        std::vector<bool> seen(connectivity.vertexCount);
        for (const Triangle &t : connectivity.triangles)
            for (const std::uint32_t v : t) {
                used += !seen[v];
                seen[v] = true;
            }
        return used;
    }();
    if (!connectivity.triangles.empty())
        statistics.bitsPerTriangle = 8.0 * double(statistics.bytes) / double(connectivity.triangles.size());
    return statistics;
}

} // namespace model::codec
