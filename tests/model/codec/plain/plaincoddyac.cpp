// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/model/codec/plain/plaincoddyac.h"

#include "tests/model/codec/plain/plainconnectivity.h"
#include "tests/model/codec/plain/plainmixing.h"

#include <cmath>

namespace tests {

namespace {

using namespace plain;

std::uint64_t size(std::int64_t x)
{
    return x < 0 ? 0 - std::uint64_t(x) : std::uint64_t(x);
}

// 4.5
struct MixedIntegers
{
    explicit MixedIntegers(std::size_t inputs)
        : models(inputs)
        , weights(113, WeightSet(inputs))
    {}

    std::int64_t decode(Range &coder, const std::vector<std::uint64_t> &contexts, unsigned g)
    {
        const auto node = [&](std::size_t j) {
            std::vector<CountedModel *> now;
            for (std::size_t i = 0; i < models.size(); ++i)
                now.push_back(&models[i][contexts[i] * 113 + j]);
            return mixed(coder, now, weights[j]);
        };
        unsigned n = 0;
        while (n < 56 && node(n))
            ++n;
        if (n == 0)
            return 0;
        const bool negative = coder.bit(signs[g]);
        std::uint64_t m = 1;
        unsigned left = n - 1;
        if (left > 0) {
            m = 2 * m + node(56 + n);
            --left;
        }
        if (left > 0) {
            m = 2 * m + coder.bit(second[n][m & 1]);
            --left;
        }
        while (left > 0) {
            const unsigned now = std::min(left, 12u);
            m = (m << now) + coder.direct(now);
            left -= now;
        }
        return negative ? -std::int64_t(m) : std::int64_t(m);
    }

    std::vector<CountedModels> models;
    std::vector<WeightSet> weights;
    Model signs[32], second[57][2];
};

std::uint64_t classOf(std::uint64_t x)
{
    return std::min(sizeOf(x), 15u);
}

// 14.2
std::vector<std::vector<std::int64_t>> lanes(const Data &stream, std::uint64_t rows, std::uint64_t columns)
{
    Range in(stream);
    MixedIntegers residuals(5);
    std::vector<std::vector<std::int64_t>> result;
    std::vector<std::uint64_t> rowBefore(columns, 0);
    for (std::uint64_t k = 0; k < rows; ++k) {
        std::vector<std::int64_t> row, found;
        std::uint64_t run = 0, lane[3] = {}, o = 0;
        for (std::uint64_t i = 0; i < columns; ++i) {
            const auto before = [&](const std::vector<std::int64_t> &values, std::uint64_t back) {
                return i >= 3 * back ? values[i - 3 * back] : 0;
            };
            if (i % 3 == 0)
                o = 0;
            const std::uint64_t s1 = size(before(found, 1)), s2 = size(before(found, 2)), s3 = size(before(found, 3));
            const std::uint64_t r = 2 * s1 + s2 + s3, a = std::min<std::uint64_t>(rowBefore[i], 0xffffffff);
            const std::int64_t residual =
                residuals.decode(in,
                                 {classOf(r) * 16 + classOf(2 * o), classOf(2 * s1) * 16 + classOf(2 * s2),
                                  classOf(run / 8) * 16 + classOf(r), classOf(a) * 16 + classOf(r + 2 * o),
                                  classOf(lane[i % 3] / 4) * 16 + classOf(o)},
                                 3 * signOf(before(found, 1)) + signOf(before(found, 2)));
            const std::int64_t c1 = before(row, 1), c2 = before(row, 2);
            row.push_back(residual + (i < 3 ? 0 : i < 6 ? c1 : 2 * c1 - c2));
            if (size(row.back()) > (std::uint64_t(1) << 53))
                throw std::string("value too large");
            found.push_back(residual);
            run += size(residual) - run / 16;
            lane[i % 3] += 2 * size(residual) - lane[i % 3] / 8;
            o += size(residual);
        }
        for (std::uint64_t i = 0; i < columns; ++i)
            rowBefore[i] = size(found[i]);
        result.push_back(row);
    }
    in.end();
    return result;
}

// 14.3
std::vector<std::vector<std::int64_t>> bands(const Data &stream, std::uint64_t rank, const PlainConnectivity &mesh)
{
    Range in(stream);
    MixedIntegers residuals(6);
    const std::size_t count = mesh.neighbours.size();
    std::vector<std::vector<std::int64_t>> values, found; // of each band
    std::vector<std::uint32_t> sums(count, 0);
    for (std::uint64_t k = 0; k < rank; ++k) {
        values.emplace_back(count);
        found.emplace_back(count);
        std::uint64_t run = 0, last = 0, older = 0;
        for (std::size_t v = 0; v < count; ++v) {
            const auto &n = mesh.neighbours[v];
            // The residual of neighbour j in the band `back` before.
            const auto residualOf = [&](std::size_t j, std::uint64_t back) {
                return n[j] >= 0 && k >= back ? found[k - back][std::size_t(n[j])] : 0;
            };
            const auto own = [&](std::uint64_t back) { return k >= back ? size(found[k - back][v]) : 0; };
            const std::uint64_t L = size(residualOf(0, 0)), R = size(residualOf(1, 0)), O = size(residualOf(2, 0));
            const std::uint64_t near = 2 * L + 2 * R + O, one = own(1), two = own(2);
            const std::uint64_t around = size(residualOf(0, 1)) + size(residualOf(1, 1)) + size(residualOf(2, 1));
            const std::uint64_t kind = n[0] < 0 ? 0 : n[0] == n[1] ? 1 : 2;
            const unsigned g =
                9 * signOf(residualOf(0, 0)) + 3 * signOf(residualOf(1, 0)) + (v > 0 ? signOf(found[k][v - 1]) : 0);
            const std::int64_t residual = residuals.decode(
                in,
                {classOf(near) * 16 + classOf(2 * one + two),
                 std::uint64_t(sizeOf((2 * near + 6 * one + 3 * two + 2 * last) / 4)) * 3 + kind,
                 classOf(2 * L + R) * 16 + classOf(run / 8), classOf(2 * last + older) * 16 + classOf(run / 8),
                 classOf(2 * one) * 16 + classOf(around), classOf(sums[v] / 4) * 16 + classOf(run / 8)},
                g);
            const auto valueOf = [&](std::size_t j) { return values[k][std::size_t(n[j])]; };
            const std::int64_t predicted = n[0] >= 0 ? valueOf(0) + valueOf(1) - valueOf(2)
                                           : v > 0   ? values[k][v - 1]
                                                     : 0;
            values[k][v] = predicted + residual;
            if (size(values[k][v]) >= (1u << 30))
                throw std::string("coefficient too large");
            constexpr std::int64_t Most = (1 << 30) - 1;
            found[k][v] = std::min(std::max(residual, -Most), Most);
            const std::uint64_t s = size(found[k][v]);
            older = last;
            last = s;
            run += s - run / 16;
            sums[v] += std::uint32_t(4 * s) - sums[v] / 4;
        }
    }
    in.end();
    return values;
}

void decode(const Data &file, PlainCoddyac &anim)
{
    std::map<std::string, Data> chunks = chunksOf(file);
    const Head head = headOf(chunks.at("HEAD"), 3);
    anim.vertices = head.vertices;
    anim.frames = head.frames;
    // 14.1
    Cursor parameters{chunks.at("CDYP")};
    parameters.varuint();
    const double step = parameters.f64(), basisStep = parameters.f64(), unit = parameters.f64();
    const std::uint64_t rank = parameters.varuint();
    const Data fineness = parameters.bytes(rank);

    const PlainConnectivity mesh = decodeConnectivityPlainly(chunks.at("CLRS"), head.vertices, head.triangles);
    anim.triangles = mesh.triangles;
    const auto means = lanes(chunks.at("MEAN"), 1, 3 * head.frames).front();
    const auto basis = lanes(chunks.at("BASE"), rank, 3 * head.frames);
    const auto coefficients = bands(chunks.at("COEF"), rank, mesh);

    // 14.4
    const double root = std::sqrt(double(head.vertices));
    for (const std::int64_t mean : means)
        anim.means.push_back(double(mean) * basisStep * unit / root);
    for (std::uint64_t k = 0; k < rank; ++k) {
        anim.basis.emplace_back();
        for (const std::int64_t u : basis[k])
            anim.basis[k].push_back(double(u) * basisStep / root * std::pow(2, fineness[k] / 4.0));
        anim.coefficients.emplace_back();
        for (const std::int64_t c : coefficients[k])
            anim.coefficients[k].push_back(double(c) * step * unit);
    }
    if (!chunks.contains("ORDR"))
        return;
    const auto places = decodeOrderPlainly(chunks.at("ORDR"), mesh.neighbours);
    for (auto &triangle : anim.triangles)
        for (std::int64_t &v : triangle)
            v = places[std::size_t(v)];
    for (auto &row : anim.coefficients) {
        const auto coded = row;
        for (std::size_t v = 0; v < coded.size(); ++v)
            row[std::size_t(places[v])] = coded[v];
    }
}

} // namespace

double PlainCoddyac::coordinate(std::uint64_t frame, std::uint64_t vertex, unsigned axis) const
{
    double sum = means[3 * frame + axis];
    for (std::size_t k = 0; k < basis.size(); ++k)
        sum += basis[k][3 * frame + axis] * coefficients[k][vertex];
    return sum;
}

double PlainCoddyac::size(std::uint64_t frame, std::uint64_t vertex, unsigned axis) const
{
    double sum = std::fabs(means[3 * frame + axis]);
    for (std::size_t k = 0; k < basis.size(); ++k)
        sum += std::fabs(basis[k][3 * frame + axis] * coefficients[k][vertex]);
    return sum;
}

PlainCoddyac decodeCoddyacPlainly(const std::vector<std::uint8_t> &file)
{
    return decodedOrError(file, &decode);
}

} // namespace tests
