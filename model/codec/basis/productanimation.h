// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/codec/animationcodec.h"
#include "model/codec/container/container.h"

#include <limits>

namespace model::codec {

/// Sums of magnitudes up to it do not overflow a float, however they are rounded on the way.
inline constexpr double MostCoordinate = 0.999 * double(std::numeric_limits<float>::max());

/// An opened animation that is a product of basis and coefficients: each frame is its mean vertex plus the sum over k
/// of its three entries of trajectory k times the vertex's coefficient k.
class ProductAnimation final : public DecodedAnimation
{
public:
    /// \param basisSize  what basisSize() says
    /// \param rank       trajectories of the product; more where a codec keeps something beside its basis
    ProductAnimation(Header header, const CompressionSettings &settings, std::uint32_t basisSize, std::uint32_t rank);

    // The decoder fills the parts, then hands the animation out as const. Different k may be set from several threads.
    void setFile(Bytes file, std::uint64_t digest);
    void setPrefixBytes(std::vector<std::uint64_t> bytes) { mPrefixBytes = std::move(bytes); }
    void setConnectivity(Connectivity connectivity) { mConnectivity = std::move(connectivity); }
    void setMeans(std::vector<double> means) { mMeans = std::move(means); } ///< #F x 3
    void setBasis(std::uint32_t k, std::size_t row, double value) { mBasis[row * mRank + k] = float(value); }
    void setCoefficient(std::uint32_t k, std::size_t vertex, double value);
    // The same of all values at once. \param perUnit  quantisation steps in a unit
    void setMeans(std::span<const std::int64_t> quantized, double perUnit);
    template <class Integer>
    void setBasisRow(std::uint32_t k, std::span<const Integer> quantized, double perUnit)
    {
        for (std::size_t row = 0; row < quantized.size(); ++row)
            setBasis(k, row, double(quantized[row]) / perUnit);
    }
    void setCoefficientRow(std::uint32_t k, std::span<const std::int32_t> quantized, double perUnit);

    /// Trajectories of the product, with those that basisSize() does not count.
    std::uint32_t rank() const { return mRank; }
    double mean(std::size_t row) const { return mMeans[row]; }
    float basis(std::uint32_t k, std::size_t row) const { return mBasis[row * mRank + k]; }
    float coefficient(std::uint32_t k, std::size_t vertex) const;

    /// Whether no position can overflow a float. Once everything is set. O((F + V) rank)
    bool isBounded() const;

    std::uint32_t frameCount() const override { return mHeader.frameCount; }
    const Connectivity &connectivity() const override { return mConnectivity; }
    void positions(std::uint32_t frame, std::span<Vec3f> out) const override;
    double frameRate() const override { return mHeader.frameRate; }
    const std::string &name() const override { return mHeader.name; }
    std::uint64_t digest() const override { return mDigest; }
    std::size_t memoryBytes() const override;

    const CompressionSettings &settings() const override { return mSettings; }
    const std::string &creator() const override { return mHeader.creator; }
    std::uint32_t basisSize() const override { return mBasisSize; }
    std::uint64_t encodedBytes() const override { return mFile.size(); }
    const Bytes &encoded() const override { return mFile; }
    std::span<const std::uint64_t> prefixBytes() const override { return mPrefixBytes; }

    /// Bytes that an animation of this size will hold with one frame of it, its file not counted; for refusing a
    /// hostile file in time.
    static std::uint64_t neededBytes(const Header &header, std::uint32_t rank);

private:
    Header mHeader;
    CompressionSettings mSettings;
    std::uint32_t mBasisSize;
    std::uint32_t mRank;
    Bytes mFile;
    std::vector<std::uint64_t> mPrefixBytes;
    std::uint64_t mDigest = 0;
    Connectivity mConnectivity;
    std::vector<double> mMeans; ///< #F x 3
    std::vector<float> mBasis;  ///< #F x 3 x #rank: what one frame needs lies together
    std::vector<float> mTiles;  ///< coefficients, see Kernels::reconstruct
};

} // namespace model::codec
