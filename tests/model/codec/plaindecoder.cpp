// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/model/codec/plaindecoder.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>

#include <zlib.h>

namespace tests {

namespace {

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
unsigned bits(std::uint64_t x)
{
    unsigned n = 0;
    for (; x; x /= 2)
        ++n;
    return n;
}
unsigned sizeOf(std::uint64_t x)
{
    if (x < 2)
        return unsigned(x);
    const unsigned n = bits(x);
    return std::min(47u, 2 * n - 2 + unsigned(x / (std::uint64_t(1) << (n - 2)) % 2));
}
unsigned signOf(std::int64_t x)
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
std::vector<Data> streams(Cursor &in, std::uint64_t things, std::uint64_t perStream)
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

// 5.3
std::vector<std::int64_t> row(Range &coder, Integers &models, std::uint64_t columns, unsigned stride)
{
    std::vector<std::int64_t> value(stride), residual(stride), older(stride), magnitude(stride), result;
    std::int64_t last = 0;
    for (std::uint64_t i = 0; i < columns; ++i) {
        const std::size_t j = i % stride;
        const std::int64_t r =
            models.decode(coder, sizeOf(std::uint64_t((2 * magnitude[j] + older[j] + last) / 2)), signOf(residual[j]));
        value[j] += r;
        residual[j] = r;
        older[j] = magnitude[j];
        magnitude[j] = last = std::abs(r);
        result.push_back(value[j]);
    }
    return result;
}

std::vector<std::vector<std::int64_t>> rows(const Data &payload, std::uint64_t count, std::uint64_t columns,
                                            unsigned stride)
{
    Cursor in{payload};
    const std::uint64_t perStream = in.varuint();
    std::vector<std::vector<std::int64_t>> result;
    for (const Data &stream : streams(in, count, perStream)) {
        Range coder(stream);
        Integers models(5);
        for (std::uint64_t i = 0; i < perStream && result.size() < count; ++i)
            result.push_back(row(coder, models, columns, stride));
        coder.end();
    }
    return result;
}

// 5.1
void triangles(const Data &payload, PlainAnim &anim)
{
    Cursor in{payload};
    const std::uint64_t perStream = in.varuint();
    for (const Data &stream : streams(in, anim.triangleCount, perStream)) {
        Range coder(stream);
        std::vector<Integers> models(3, Integers(5));
        std::int64_t index[3] = {}, residual[3] = {}, magnitude[3] = {}, last = 0;
        for (std::uint64_t t = 0; t < perStream && anim.triangles.size() < anim.triangleCount; ++t) {
            for (std::size_t i = 0; i < 3; ++i) {
                const std::int64_t r =
                    models[i].decode(coder, sizeOf(std::uint64_t(magnitude[i] + last)), signOf(residual[i]));
                index[i] += r;
                residual[i] = r;
                magnitude[i] = last = std::abs(r);
            }
            anim.triangles.push_back({index[0], index[1], index[2]});
        }
        coder.end();
    }
}

void decode(const Data &file, PlainAnim &anim)
{
    // 3.1, 3.2
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
    // 3.3
    Cursor head{chunks.at("HEAD")};
    if (head.u8() != 1)
        throw std::string("version");
    head.u8();
    if (head.varuint() != 0 || head.u8() != 2)
        throw std::string("features or codec");
    anim.vertices = head.varuint();
    anim.triangleCount = head.varuint();
    anim.frames = head.varuint();
    anim.rate = head.f64();
    anim.creator = head.text();
    anim.name = head.text();
    // 3.5
    Cursor parameters{chunks.at("PCAP")};
    anim.resolution = parameters.f64();
    anim.wanted = parameters.varuint();
    anim.rank = parameters.varuint();

    triangles(chunks.at("INDX"), anim);
    Range meanCoder(chunks.at("MEAN"));
    Integers meanModels(6);
    anim.means = row(meanCoder, meanModels, 3 * anim.frames, 3);
    meanCoder.end();
    anim.basis = rows(chunks.at("BASE"), anim.rank, 3 * anim.frames, 3);
    anim.coefficients = rows(chunks.at("COEF"), anim.rank, anim.vertices, 1);
}

} // namespace

double PlainAnim::coordinate(std::uint64_t frame, std::uint64_t vertex, unsigned axis) const
{
    const std::size_t r = 3 * frame + axis;
    double sum = double(means[r]) / resolution;
    for (std::size_t k = 0; k < rank; ++k)
        sum += double(basis[k][r]) / resolution * (double(coefficients[k][vertex]) / resolution);
    return sum;
}

PlainAnim decodePlainly(const std::vector<std::uint8_t> &file)
{
    PlainAnim anim;
    try {
        decode(file, anim);
    } catch (const std::string &error) {
        anim.error = error;
    } catch (const std::exception &error) {
        anim.error = error.what();
    }
    return anim;
}

} // namespace tests
