// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/model/codec/plain/plaindecoder.h"
#include "tests/model/codec/plain/plainreader.h"

#include <cmath>

namespace tests {

namespace {

using namespace plain;

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
void readTriangles(const Data &payload, PlainAnim &anim)
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
    std::map<std::string, Data> chunks = chunksOf(file);
    const Head head = headOf(chunks.at("HEAD"), 2);
    anim.vertices = head.vertices;
    anim.triangleCount = head.triangles;
    anim.frames = head.frames;
    anim.rate = head.rate;
    anim.creator = head.creator;
    anim.name = head.name;
    // 3.5
    Cursor parameters{chunks.at("PCAP")};
    anim.resolution = parameters.f64();
    anim.wanted = parameters.varuint();
    anim.rank = parameters.varuint();

    readTriangles(chunks.at("INDX"), anim);
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

std::vector<std::array<std::int64_t, 3>> plainTriangles(const std::vector<std::uint8_t> &payload, std::uint64_t count)
{
    PlainAnim anim;
    anim.triangleCount = count;
    readTriangles(payload, anim);
    return anim.triangles;
}

PlainAnim decodePlainly(const std::vector<std::uint8_t> &file)
{
    return decodedOrError(file, &decode);
}

} // namespace tests
