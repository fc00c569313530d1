// SPDX-License-Identifier: GPL-3.0-or-later
// Based on: P. Deutsch, J.-L. Gailly, RFC 1950 and RFC 1951, 1996.
// Differs: the input is whole at the first call, so that decoding pauses only where the output is full.
#include <zlib.h>

#include <algorithm>
#include <array>
#include <new>
#include <vector>

namespace {

constexpr unsigned MostCodeBits = 15;
constexpr std::size_t WindowBytes = 32768; // a power of two
constexpr unsigned EndOfBlock = 256;
constexpr std::array<std::uint8_t, 19> OrderOfLengths{16, 17, 18, 0, 8, 7, 9, 6, 10, 5, 11, 4, 12, 3, 13, 2, 14, 1, 15};

/// A prefix code as a table: for the next 15 bits of the stream symbol and length, length 0 where no code starts so.
class PrefixCode
{
public:
    /// \returns false if the lengths are no code. An incomplete one is good with a single symbol only, as zlib has it.
    bool set(const std::uint8_t *lengths, std::size_t count, bool mayBeIncomplete)
    {
        std::array<unsigned, MostCodeBits + 1> counts{};
        for (std::size_t i = 0; i < count; ++i)
            ++counts[lengths[i]];
        counts[0] = 0;
        int left = 1;
        unsigned longest = 0, code = 0;
        std::array<unsigned, MostCodeBits + 2> next{};
        for (unsigned bits = 1; bits <= MostCodeBits; ++bits) {
            left = 2 * left - int(counts[bits]);
            if (left < 0)
                return false;
            if (counts[bits] > 0)
                longest = bits;
            code = (code + counts[bits - 1]) << 1;
            next[bits] = code;
        }
        if (left > 0 && (!mayBeIncomplete || longest > 1))
            return false;
        std::fill(mTable.begin(), mTable.end(), Entry{});
        for (std::size_t symbol = 0; symbol < count; ++symbol) {
            const unsigned bits = lengths[symbol];
            if (bits == 0)
                continue;
            unsigned reversed = 0;
            for (unsigned bit = 0, value = next[bits]++; bit < bits; ++bit, value >>= 1)
                reversed = reversed << 1 | (value & 1);
            for (std::size_t at = reversed; at < mTable.size(); at += std::size_t(1) << bits)
                mTable[at] = {std::uint16_t(symbol), std::uint8_t(bits)};
        }
        return true;
    }

    struct Entry
    {
        std::uint16_t symbol = 0;
        std::uint8_t bits = 0;
    };
    const Entry &of(unsigned next15) const { return mTable[next15]; }

private:
    std::vector<Entry> mTable = std::vector<Entry>(std::size_t(1) << MostCodeBits);
};

} // namespace

struct InflateState
{
    enum class Step : std::uint8_t { StreamHeader, BlockHeader, Stored, Codes, Check, Done, Bad };

    explicit InflateState(z_stream &s)
        : stream(s)
    {}

    // The last bytes that were written, for matches and for the checksum.
    void put(std::uint8_t byte)
    {
        *stream.next_out++ = byte;
        --stream.avail_out;
        window[written++ % WindowBytes] = byte;
        sum = (sum + byte) % 65521;
        sumOfSums = (sumOfSums + sum) % 65521;
    }

    /// Makes at least `count` bits be there, if the input has them.
    bool need(unsigned count)
    {
        while (bitCount < count && stream.avail_in > 0) {
            bits |= std::uint64_t(*stream.next_in++) << bitCount;
            --stream.avail_in;
            bitCount += 8;
        }
        return bitCount >= count;
    }
    unsigned peek(unsigned count) const { return unsigned(bits & ((std::uint64_t(1) << count) - 1)); }
    void drop(unsigned count)
    {
        bits >>= count;
        bitCount -= count;
    }
    unsigned take(unsigned count)
    {
        if (!need(count)) {
            ranOut = true;
            return 0;
        }
        const unsigned value = peek(count);
        drop(count);
        return value;
    }
    unsigned symbol(const PrefixCode &code)
    {
        need(MostCodeBits);
        const PrefixCode::Entry entry = code.of(peek(MostCodeBits));
        if (entry.bits == 0 || entry.bits > bitCount) {
            (entry.bits == 0 ? isBad : ranOut) = true;
            return EndOfBlock;
        }
        drop(entry.bits);
        return entry.symbol;
    }

    bool hasFailed() const { return isBad || ranOut; }

    Step streamHeader()
    {
        const unsigned method = take(8), flags = take(8);
        isBad = isBad || (method & 15) != 8 || method >> 4 > 7 || (method * 256 + flags) % 31 != 0 || (flags & 32) != 0;
        return Step::BlockHeader;
    }

    Step blockHeader()
    {
        if (isLast) {
            drop(bitCount % 8);
            return Step::Check;
        }
        isLast = take(1) != 0;
        switch (take(2)) {
        case 0: {
            drop(bitCount % 8);
            storedLeft = take(16);
            isBad = isBad || take(16) != (storedLeft ^ 0xffff);
            return Step::Stored;
        }
        case 1: {
            std::array<std::uint8_t, 288> lengths{};
            for (unsigned i = 0; i < lengths.size(); ++i)
                lengths[i] = i < 144 ? 8 : i < 256 ? 9 : i < 280 ? 7 : 8;
            std::array<std::uint8_t, 32> distanceLengths{};
            distanceLengths.fill(5);
            literals.set(lengths.data(), lengths.size(), false);
            distances.set(distanceLengths.data(), distanceLengths.size(), false);
            return Step::Codes;
        }
        case 2:
            readCodes();
            return Step::Codes;
        default:
            isBad = true;
            return Step::Bad;
        }
    }

    void readCodes()
    {
        const unsigned literalCount = take(5) + 257, distanceCount = take(5) + 1, lengthCount = take(4) + 4;
        if (literalCount > 286 || distanceCount > 30) {
            isBad = true;
            return;
        }
        std::array<std::uint8_t, 19> lengthsOfLengths{};
        for (unsigned i = 0; i < lengthCount; ++i)
            lengthsOfLengths[OrderOfLengths[i]] = std::uint8_t(take(3));
        isBad = isBad || !literals.set(lengthsOfLengths.data(), lengthsOfLengths.size(), false);
        std::array<std::uint8_t, 286 + 30> lengths{};
        unsigned at = 0;
        while (at < literalCount + distanceCount && !hasFailed()) {
            const unsigned what = symbol(literals);
            if (what < 16) {
                lengths[at++] = std::uint8_t(what);
                continue;
            }
            isBad = isBad || (what == 16 && at == 0);
            const std::uint8_t repeated = what == 16 && at > 0 ? lengths[at - 1] : std::uint8_t(0);
            const unsigned times = what == 16 ? 3 + take(2) : what == 17 ? 3 + take(3) : 11 + take(7);
            isBad = isBad || at + times > literalCount + distanceCount;
            for (unsigned i = 0; i < times && !hasFailed(); ++i)
                lengths[at++] = repeated;
        }
        isBad = isBad || lengths[EndOfBlock] == 0 || !literals.set(lengths.data(), literalCount, true) ||
                !distances.set(lengths.data() + literalCount, distanceCount, true);
    }

    Step stored()
    {
        while (storedLeft > 0 && stream.avail_out > 0 && !hasFailed()) {
            const unsigned byte = take(8);
            if (!hasFailed())
                put(std::uint8_t(byte));
            --storedLeft;
        }
        return storedLeft > 0 ? Step::Stored : Step::BlockHeader;
    }

    Step codes()
    {
        while (!hasFailed()) {
            for (; copyLeft > 0 && stream.avail_out > 0; --copyLeft)
                put(window[(written - copyDistance) % WindowBytes]);
            if (stream.avail_out == 0)
                return Step::Codes;
            const unsigned what = symbol(literals);
            if (hasFailed())
                break;
            if (what == EndOfBlock)
                return Step::BlockHeader;
            if (what < EndOfBlock)
                put(std::uint8_t(what));
            else
                startCopy(what - EndOfBlock - 1);
        }
        return Step::Bad;
    }

    void startCopy(unsigned lengthCode)
    {
        if (lengthCode > 28) {
            isBad = true;
            return;
        }
        const unsigned lengthBits = lengthCode < 8 || lengthCode == 28 ? 0 : (lengthCode - 4) / 4;
        const unsigned shortest = lengthCode < 8     ? lengthCode + 3
                                  : lengthCode == 28 ? 258
                                                     : ((4 + lengthCode % 4) << lengthBits) + 3;
        copyLeft = shortest + take(lengthBits);
        const unsigned distanceCode = symbol(distances);
        if (hasFailed() || distanceCode > 29) {
            isBad = true;
            return;
        }
        const unsigned distanceBits = distanceCode < 4 ? 0 : (distanceCode - 2) / 2;
        const unsigned nearest = distanceCode < 4 ? distanceCode + 1 : ((2 + distanceCode % 2) << distanceBits) + 1;
        copyDistance = nearest + take(distanceBits);
        isBad = isBad || copyDistance > written;
    }

    Step check()
    {
        std::uint32_t expected = 0;
        for (int i = 0; i < 4; ++i)
            expected = expected << 8 | take(8);
        // Whole bytes that were read ahead go back: what follows the stream is for the caller to judge.
        for (; bitCount >= 8; bitCount -= 8) {
            --stream.next_in;
            ++stream.avail_in;
        }
        isBad = isBad || expected != (sumOfSums << 16 | sum);
        return Step::Done;
    }

    int run()
    {
        while (step != Step::Done && !hasFailed()) {
            const bool writes = step == Step::Stored || step == Step::Codes;
            switch (step) {
            case Step::StreamHeader:
                step = streamHeader();
                break;
            case Step::BlockHeader:
                step = blockHeader();
                break;
            case Step::Stored:
                step = stored();
                break;
            case Step::Codes:
                step = codes();
                break;
            case Step::Check:
                step = check();
                break;
            case Step::Done:
            case Step::Bad:
                break;
            }
            if (writes && stream.avail_out == 0 && (step == Step::Stored || step == Step::Codes))
                return Z_OK;
        }
        return isBad ? Z_DATA_ERROR : ranOut ? Z_BUF_ERROR : Z_STREAM_END;
    }

    z_stream &stream;
    Step step = Step::StreamHeader;
    bool isLast = false, isBad = false, ranOut = false;
    std::uint64_t bits = 0;
    unsigned bitCount = 0;
    unsigned storedLeft = 0, copyLeft = 0;
    std::uint64_t copyDistance = 0, written = 0;
    std::uint32_t sum = 1, sumOfSums = 0;
    PrefixCode literals, distances;
    std::vector<std::uint8_t> window = std::vector<std::uint8_t>(WindowBytes);
};

int inflateInit(z_stream *stream)
{
    stream->state = new (std::nothrow) InflateState(*stream);
    return stream->state ? Z_OK : Z_MEM_ERROR;
}

int inflate(z_stream *stream, int)
{
    return stream->state->run();
}

int inflateEnd(z_stream *stream)
{
    delete stream->state;
    stream->state = nullptr;
    return Z_OK;
}
