// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/codec/basis/productanimation.h"

#include "model/codec/basis/kernels.h"

#include <algorithm>
#include <cmath>

namespace model::codec {

namespace {

std::uint64_t tileCount(std::uint64_t vertices)
{
    return (vertices + TileVertices - 1) / TileVertices;
}

} // namespace

ProductAnimation::ProductAnimation(Header header, const CompressionSettings &settings, std::uint32_t basisSize,
                                   std::uint32_t rank)
    : mHeader(std::move(header))
    , mSettings(settings)
    , mBasisSize(basisSize)
    , mRank(rank)
    , mBasis(std::size_t(3) * mHeader.frameCount * rank)
    , mTiles(std::size_t(tileCount(mHeader.vertexCount)) * TileVertices * rank)
{}

void ProductAnimation::setFile(Bytes file, std::uint64_t digest)
{
    mFile = std::move(file);
    mDigest = digest;
}

void ProductAnimation::setCoefficient(std::uint32_t k, std::size_t vertex, double value)
{
    mTiles[(vertex / TileVertices * mRank + k) * TileVertices + vertex % TileVertices] = float(value);
}

float ProductAnimation::coefficient(std::uint32_t k, std::size_t vertex) const
{
    return mTiles[(vertex / TileVertices * mRank + k) * TileVertices + vertex % TileVertices];
}

void ProductAnimation::setMeans(std::span<const std::int64_t> quantized, double perUnit)
{
    mMeans.reserve(quantized.size());
    for (const std::int64_t q : quantized)
        mMeans.push_back(double(q) / perUnit);
}

void ProductAnimation::setCoefficientRow(std::uint32_t k, std::span<const std::int32_t> quantized, double perUnit)
{
    const double step = 1 / perUnit;
    for (std::size_t vertex = 0; vertex < quantized.size(); ++vertex)
        setCoefficient(k, vertex, quantized[vertex] * step);
}

bool ProductAnimation::isBounded() const
{
    std::vector<double> largest(mRank); // coefficient of each trajectory
    for (std::size_t i = 0; i < mTiles.size(); ++i) {
        double &most = largest[i / TileVertices % mRank];
        most = std::max(most, std::fabs(double(mTiles[i])));
    }
    for (std::size_t row = 0; row < mMeans.size(); ++row) {
        double sum = std::fabs(mMeans[row]);
        for (std::size_t k = 0; k < mRank; ++k)
            sum += std::fabs(double(mBasis[row * mRank + k])) * largest[k];
        if (!(sum <= MostCoordinate)) // also of infinity times 0
            return false;
    }
    return true;
}

void ProductAnimation::positions(std::uint32_t frame, std::span<Vec3f> out) const
{
    const double *mean = mMeans.data() + std::size_t(3) * frame;
    float start[6];
    for (int axis = 0; axis < 3; ++axis) {
        start[axis] = float(mean[axis]);
        start[3 + axis] = float(mean[axis] - double(start[axis]));
    }
    kernels().reconstruct(mTiles.data(), mRank, mBasis.data() + std::size_t(3) * frame * mRank, start, out.size(),
                          &out.data()->x);
}

std::size_t ProductAnimation::memoryBytes() const
{
    return sizeof *this + mFile.capacity() + mHeader.creator.capacity() + mHeader.name.capacity() +
           mHeader.extra.capacity() + mConnectivity.triangles.capacity() * sizeof(Triangle) +
           mMeans.capacity() * sizeof(double) + mBasis.capacity() * sizeof(float) + mTiles.capacity() * sizeof(float);
}

std::uint64_t ProductAnimation::neededBytes(const Header &header, std::uint32_t rank)
{
    return sizeof(ProductAnimation) + std::uint64_t(header.triangleCount) * sizeof(Triangle) +
           std::uint64_t(header.vertexCount) * sizeof(Vec3f) +
           std::uint64_t(header.frameCount) * 3 * (sizeof(double) + sizeof(std::int64_t) + rank * sizeof(float)) +
           tileCount(header.vertexCount) * TileVertices * rank * sizeof(float);
}

} // namespace model::codec
