// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <map>
#include <string>
#include <vector>

#include <zlib.h>

// What the plain decoders share: FORMAT.md 3.1, 3.2, 3.4 and 4, written from the document alone. Errors are thrown as
// std::string.
namespace tests::plain {

using Data = std::vector<std::uint8_t>;

struct Cursor
{
    const Data &data;
    std::size_t at = 0;

    std::uint8_t u8() { return data.at(at++); }
    std::uint64_t fixed(int count)
    {
        std::uint64_t result = 0;
        for (int i = 0; i < count; ++i)
            result += std::uint64_t(u8()) << (8 * i);
        return result;
    }
    double f64()
    {
        const std::uint64_t raw = fixed(8);
        double result;
        std::memcpy(&result, &raw, 8);
        return result;
    }
    std::uint64_t varuint()
    {
        std::uint64_t result = 0;
        for (int shift = 0;; shift += 7) {
            const std::uint64_t byte = u8();
            result += (byte % 128) << shift;
            if (byte < 128)
                return result;
        }
    }
    Data bytes(std::uint64_t count)
    {
        if (count > data.size() - at)
            throw std::string("too short");
        at += count;
        return {data.begin() + std::ptrdiff_t(at - count), data.begin() + std::ptrdiff_t(at)};
    }
    std::string text()
    {
        const Data raw = bytes(varuint());
        return {raw.begin(), raw.end()};
    }
};

// 4.1
struct Model
{
    std::uint32_t quick = 32768, steady = 32768;
};

struct Range
{
    explicit Range(Data stream)
        : data(std::move(stream))
    {
        for (int i = 0; i < 4; ++i)
            code = code * 256 + byte();
        if (code == 0xffffffff)
            throw std::string("corrupt start");
    }
    std::uint32_t byte()
    {
        const std::size_t at = next++;
        return at < data.size() ? data[at] : 0;
    }
    void normalize()
    {
        while (range < (1u << 24)) {
            range = range * 256;
            code = code * 256 + byte();
        }
    }
    unsigned bit(Model &m)
    {
        const std::uint32_t p = (m.quick + m.steady) >> 2;
        const std::uint32_t bound = (range >> 15) * p;
        unsigned result = 0;
        if (code < bound) {
            range = bound;
            m.quick += (65535 - m.quick) >> 4;
            m.steady += (65535 - m.steady) >> 7;
            result = 1;
        } else {
            code -= bound;
            range -= bound;
            m.quick -= m.quick >> 4;
            m.steady -= m.steady >> 7;
        }
        normalize();
        return result;
    }
    /// 4.4: with a probability of 16 bits
    unsigned decision(std::uint32_t q)
    {
        const std::uint32_t bound = (range >> 16) * q;
        const bool isOne = code < bound;
        if (isOne) {
            range = bound;
        } else {
            code -= bound;
            range -= bound;
        }
        normalize();
        return isOne;
    }
    std::uint32_t direct(unsigned n)
    {
        range = range >> n;
        const std::uint32_t value = code / range;
        if (value >= (1u << n))
            throw std::string("corrupt direct bits");
        code -= value * range;
        normalize();
        return value;
    }
    void end() const
    {
        if (next != data.size() + 3)
            throw std::string("stream does not end where it should");
    }

    Data data;
    std::uint32_t range = 0xffffffff, code = 0;
    std::size_t next = 0;
};

// 4.2
inline unsigned bits(std::uint64_t x)
{
    unsigned n = 0;
    for (; x; x /= 2)
        ++n;
    return n;
}
inline unsigned sizeOf(std::uint64_t x)
{
    if (x < 2)
        return unsigned(x);
    const unsigned n = bits(x);
    return std::min(47u, 2 * n - 2 + unsigned(x / (std::uint64_t(1) << (n - 2)) % 2));
}
inline unsigned signOf(std::int64_t x)
{
    return x == 0 ? 0 : x > 0 ? 1 : 2;
}

// 4.3
struct Integers
{
    explicit Integers(unsigned classBits)
        : c(classBits)
        , classes(48, std::vector<Model>(std::size_t(1) << classBits))
        , leading(std::size_t(1) << classBits, std::vector<Model>(4))
    {}
    std::int64_t decode(Range &coder, unsigned s, unsigned g)
    {
        unsigned node = 1;
        for (unsigned i = 0; i < c; ++i)
            node = 2 * node + coder.bit(classes[s][node]);
        const unsigned n = node - (1u << c);
        if (n == 0)
            return 0;
        const bool negative = coder.bit(signs[g]);
        unsigned left = n - 1;
        std::int64_t m = 1;
        node = 1;
        for (int times = 0; times < 2 && left > 0; ++times, --left) {
            const unsigned b = coder.bit(leading[n][node]);
            node = 2 * node + b;
            m = 2 * m + b;
        }
        while (left > 0) {
            const unsigned count = std::min(left, 12u);
            m = m * (std::int64_t(1) << count) + coder.direct(count);
            left -= count;
        }
        return negative ? -m : m;
    }
    unsigned c;
    std::vector<std::vector<Model>> classes;
    Model signs[3];
    std::vector<std::vector<Model>> leading;
};

// 3.4
inline std::vector<Data> streams(Cursor &in, std::uint64_t things, std::uint64_t perStream)
{
    std::vector<std::uint64_t> lengths;
    for (std::uint64_t i = 0; i < (things + perStream - 1) / perStream; ++i)
        lengths.push_back(in.varuint());
    std::vector<Data> result;
    for (const std::uint64_t length : lengths)
        result.push_back(in.bytes(length));
    if (in.at != in.data.size())
        throw std::string("bytes left over");
    return result;
}

// 3.3
struct Head
{
    std::uint64_t vertices = 0, triangles = 0, frames = 0;
    double rate = 0;
    std::string creator, name;
};
inline Head headOf(const Data &chunk, unsigned codec)
{
    Cursor in{chunk};
    if (in.u8() != 1)
        throw std::string("version");
    in.u8();
    if (in.varuint() != 0 || in.u8() != codec)
        throw std::string("features or codec");
    Head head;
    head.vertices = in.varuint();
    head.triangles = in.varuint();
    head.frames = in.varuint();
    head.rate = in.f64();
    head.creator = in.text();
    head.name = in.text();
    return head;
}

// 3.1, 3.2
inline std::map<std::string, Data> chunksOf(const Data &file)
{
    Cursor in{file};
    if (in.bytes(8) != Data{0x89, 0x53, 0x52, 0x41, 0x0d, 0x0a, 0x1a, 0x0a})
        throw std::string("magic");
    std::map<std::string, Data> chunks;
    for (std::string tag; tag != "TAIL";) {
        const Data raw = in.bytes(4);
        tag.assign(raw.begin(), raw.end());
        const Data payload = in.bytes(in.varuint());
        uLong crc = crc32(0, raw.data(), 4);
        if (!payload.empty())
            crc = crc32(crc, payload.data(), uInt(payload.size()));
        if (in.fixed(4) != crc)
            throw "checksum of " + tag;
        chunks[tag] = payload;
    }
    return chunks;
}

/// What `decode` makes of a file, or the text of what it throws.
template <class Animation>
Animation decodedOrError(const Data &file, void (*decode)(const Data &, Animation &))
{
    Animation anim;
    try {
        decode(file, anim);
    } catch (const std::string &error) {
        anim.error = error;
    } catch (const std::exception &error) {
        anim.error = error.what();
    }
    return anim;
}

} // namespace tests::plain
