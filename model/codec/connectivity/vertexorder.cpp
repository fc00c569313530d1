// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/codec/connectivity/vertexorder.h"

#include "model/codec/entropy/integercoder.h"

#include <memory>

namespace model::codec {

namespace {

/// The places that are not taken yet: their number, the n-th of them, how many lie before one. A Fenwick tree.
class FreePlaces
{
public:
    explicit FreePlaces(std::uint32_t count)
        : mLeft(count)
        , mCounts(std::size_t(count) + 1)
        , mIsFree(count, true)
    {
        for (std::uint32_t i = 1; i <= count; ++i)
            mCounts[i] = i & (0 - i);
    }

    std::uint32_t left() const { return mLeft; }
    bool isFree(std::int64_t place) const
    {
        return place >= 0 && place < std::int64_t(mIsFree.size()) && mIsFree[std::size_t(place)];
    }
    std::uint32_t rankOf(std::uint32_t place) const
    {
        std::uint32_t rank = 0;
        for (std::uint32_t i = place; i > 0; i &= i - 1)
            rank += mCounts[i];
        return rank;
    }
    /// Precondition: rank < left().
    std::uint32_t placeOf(std::uint32_t rank) const
    {
        std::uint32_t place = 0;
        for (std::uint32_t step = std::bit_floor(std::uint32_t(mCounts.size())); step > 0; step /= 2)
            if (place + step < mCounts.size() && mCounts[place + step] <= rank) {
                place += step;
                rank -= mCounts[place];
            }
        return place;
    }
    void take(std::uint32_t place)
    {
        mIsFree[place] = false;
        --mLeft;
        for (std::uint32_t i = place + 1; i < mCounts.size(); i += i & (0 - i))
            --mCounts[i];
    }

private:
    std::uint32_t mLeft;
    std::vector<std::uint32_t> mCounts;
    std::vector<bool> mIsFree;
};

/// Prediction, contexts and coding of one place after another, for both directions.
class OrderModel
{
public:
    OrderModel(std::uint32_t count)
        : mFree(count)
        , mPlaces(count)
    {}

    /// \returns false if the stream is corrupt
    template <class Coder>
    bool code(Coder &coder, std::uint32_t vertex, const VertexNeighbours &n, std::uint32_t wanted = 0)
    {
        const std::int64_t last = vertex == 0 ? -1 : std::int64_t(mPlaces[vertex - 1]);
        std::array<std::int64_t, Guesses> guesses{last + 1, last - 1, -1, -1, -1, -1, -1};
        std::int64_t near = last;
        if (!n.isNone()) {
            const std::int64_t l = mPlaces[n.left], r = mPlaces[n.right], o = mPlaces[n.opposite];
            guesses = {last + 1, l + r - o, last - 1, l + 1, l - 1, r + 1, r - 1};
            near = l;
        }
        std::int64_t place = -1;
        for (std::size_t i = 0; i < Guesses && place < 0; ++i) {
            if (!mFree.isFree(guesses[i]) || std::find(guesses.begin(), guesses.begin() + std::ptrdiff_t(i),
                                                       guesses[i]) != guesses.begin() + std::ptrdiff_t(i))
                continue;
            const bool hit = coder.bit(mHits[mLastHit][i], guesses[i] == std::int64_t(wanted)) != 0;
            if (hit) {
                place = guesses[i];
                mLastHit = i;
            }
        }
        if (place < 0) {
            mLastHit = Guesses;
            place = codeFar(coder, near, wanted);
        }
        if (!mFree.isFree(place))
            return false;
        mPlaces[vertex] = std::uint32_t(place);
        mFree.take(std::uint32_t(place));
        return true;
    }

    std::vector<std::uint32_t> takePlaces() { return std::move(mPlaces); }

private:
    static constexpr std::size_t Guesses = 7;

    /// As a distance to a neighbour, or as the number of a free place if that is shorter.
    template <class Coder>
    std::int64_t codeFar(Coder &coder, std::int64_t near, std::uint32_t wanted)
    {
        const std::int64_t distance = std::int64_t(wanted) - near;
        const std::uint64_t magnitude = std::uint64_t(distance < 0 ? -distance : distance);
        if (coder.bit(mIsNumber, magnitude > mFree.left() / 8)) {
            unsigned left = unsigned(std::bit_width(mFree.left() - 1));
            std::uint32_t rank = mFree.isFree(wanted) ? mFree.rankOf(wanted) : 0;
            std::uint32_t result = 0;
            while (left > 0) {
                const unsigned bits = std::min(left, MaxDirectBits);
                left -= bits;
                result = result << bits | coder.direct(bits, rank >> left & ((1u << bits) - 1));
            }
            return result < mFree.left() ? std::int64_t(mFree.placeOf(result)) : -1;
        }
        const std::int64_t coded =
            codeInteger(coder, mDistances, sizeContext(mLastMagnitude), signContext(mLastDistance), distance);
        mLastDistance = coded;
        mLastMagnitude = std::uint64_t(coded < 0 ? -coded : coded);
        return std::int64_t(std::uint64_t(near) + std::uint64_t(coded)); // may leave 64 bits: no place then either
    }

    FreePlaces mFree;
    std::vector<std::uint32_t> mPlaces;
    std::array<std::array<AdaptiveBit, Guesses>, Guesses + 1> mHits;
    AdaptiveBit mIsNumber;
    IntegerModels<6> mDistances;
    std::int64_t mLastDistance = 0;
    std::uint64_t mLastMagnitude = 0;
    std::size_t mLastHit = 0;
};

} // namespace

Bytes encodeVertexOrder(std::span<const std::uint32_t> places, std::span<const VertexNeighbours> neighbours)
{
    RangeEncoder coder;
    const auto model = std::make_unique<OrderModel>(std::uint32_t(places.size()));
    for (std::uint32_t v = 0; v < places.size(); ++v)
        model->code(coder, v, neighbours[v], places[v]);
    return coder.finish();
}

Result<std::vector<std::uint32_t>> decodeVertexOrder(const Chunk &chunk, std::span<const VertexNeighbours> neighbours)
{
    RangeDecoder coder(chunk.payload);
    const auto model = std::make_unique<OrderModel>(std::uint32_t(neighbours.size()));
    for (std::uint32_t v = 0; v < neighbours.size(); ++v)
        if (coder.isBad() || !model->code(coder, v, neighbours[v]))
            return fail(Error{ErrorCode::CorruptStream, {"vertex order"}, {}, Error::None, chunk.offset});
    if (!coder.isAtEnd())
        return fail(Error{ErrorCode::CorruptStream, {"vertex order"}, {}, Error::None, chunk.offset});
    return model->takePlaces();
}

} // namespace model::codec
