// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/model/codec/plain/plaindirect.h"
#include "tests/model/codec/plain/plaindecoder.h"
#include "tests/model/codec/plain/plainreader.h"

#include <memory>
#include <set>
#include <tuple>

namespace tests {

namespace {

using namespace plain;

using Point = std::array<std::int64_t, 3>;
using Frame = std::vector<Point>;

// 11.2
struct Walk
{
    std::vector<std::size_t> order;
    std::vector<std::vector<std::size_t>> known;
    std::vector<std::vector<std::array<std::size_t, 3>>> para;

    Walk(const std::vector<Point> &triangles, std::size_t vertices, bool isGrowing)
        : known(vertices)
        , para(vertices)
    {
        std::vector<std::set<std::size_t>> neighbours(vertices);
        std::vector<std::array<std::size_t, 3>> edges;
        for (const Point &t : triangles)
            for (std::size_t i = 0; i < 3; ++i) {
                const std::size_t a = std::size_t(t[i]), b = std::size_t(t[(i + 1) % 3]),
                                  c = std::size_t(t[(i + 2) % 3]);
                if (a == b)
                    continue;
                neighbours[a].insert(b);
                neighbours[b].insert(a);
                edges.push_back({std::min(a, b), std::max(a, b), c});
            }
        std::vector<std::size_t> place(vertices, vertices);
        const auto take = [&](std::size_t v) {
            place[v] = order.size();
            order.push_back(v);
        };
        std::vector<std::size_t> number(vertices);
        for (std::size_t start = 0; start < vertices; ++start) {
            if (place[start] < vertices)
                continue;
            if (!isGrowing) {
                take(start);
                continue;
            }
            std::vector<std::vector<std::size_t>> pile(9);
            pile[0].push_back(start);
            for (;;) {
                std::size_t top = 9;
                while (top > 0 && pile[top - 1].empty())
                    --top;
                if (top-- == 0)
                    break;
                const std::size_t v = pile[top].back();
                pile[top].pop_back();
                if (place[v] < vertices || number[v] != top)
                    continue;
                take(v);
                for (const std::size_t n : neighbours[v])
                    if (place[n] == vertices && number[n] != 8)
                        pile[++number[n]].push_back(n);
            }
        }
        for (std::size_t v = 0; v < vertices; ++v) {
            for (const std::size_t n : neighbours[v])
                if (place[n] < place[v])
                    known[v].push_back(n);
            if (known[v].empty() && place[v] > 0)
                known[v].push_back(order[place[v] - 1]);
        }
        std::sort(edges.begin(), edges.end());
        for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
            const auto [a, b, first] = edges[i];
            auto [a2, b2, second] = edges[i + 1];
            if (a != a2 || b != b2 || first == second)
                continue;
            const std::size_t c = place[first] > place[second] ? first : second;
            const std::size_t d = c == first ? second : first;
            if (place[c] > place[a] && place[c] > place[b])
                para[c].push_back({a, b, d});
        }
    }
};

/// Where the residuals of a group come from: 11.5 and 11.6.
struct Source
{
    virtual ~Source() = default;
    virtual void startFrame() = 0;
    virtual std::int64_t weight(std::size_t axis, std::size_t feature) = 0;
    virtual std::int64_t residual(std::size_t place, std::size_t axis) = 0;
    virtual void end() = 0;
};

struct RangeSource final : Source
{
    RangeSource(const Walk &w, const Data &stream)
        : walk(w)
        , coder(stream)
        , weights(5)
        , residuals(2, std::vector<Integers>(3, Integers(5)))
        , now(w.order.size())
        , before(w.order.size())
    {}
    void startFrame() override
    {
        ++frame;
        std::swap(now, before);
    }
    std::int64_t weight(std::size_t axis, std::size_t feature) override
    {
        std::int64_t &w = known[axis][feature];
        w = std::clamp<std::int64_t>(w + weights.decode(coder, 10, 0), -32767, 32767);
        return w;
    }
    std::int64_t residual(std::size_t place, std::size_t axis) override
    {
        const std::size_t v = walk.order[place];
        std::int64_t sum = 0, s = 0;
        for (const std::size_t u : walk.known[v]) {
            sum += std::abs(now[u][axis]);
            s += now[u][axis];
        }
        const std::int64_t n = std::int64_t(walk.known[v].size());
        const std::int64_t around = n ? ((sum * (65536 / n)) >> 12) / 4 : 0;
        const std::int64_t past = frame == 1 ? around : 4 * std::abs(before[v][axis]);
        const std::int64_t beside = axis == 0   ? around
                                    : axis == 1 ? 4 * std::abs(now[v][0])
                                                : 2 * (std::abs(now[v][0]) + std::abs(now[v][1]));
        const std::int64_t e = (2 * around + past + beside) / 4;
        return now[v][axis] = residuals[frame == 1 ? 0 : 1][axis].decode(coder, sizeOf(std::uint64_t(e)), signOf(s));
    }
    void end() override { coder.end(); }

    const Walk &walk;
    Range coder;
    Integers weights;
    std::vector<std::vector<Integers>> residuals;
    Frame now, before;
    int frame = 0;
    std::int64_t known[3][6] = {};
};

struct DeflateSource final : Source
{
    DeflateSource(std::size_t vertices, std::size_t most, const Data &stream)
        : count(vertices)
        , data(most)
    {
        uLongf length = uLongf(most);
        if (uncompress(data.data(), &length, stream.data(), uLong(stream.size())) != Z_OK)
            throw std::string("zlib");
        data.resize(length);
    }
    void startFrame() override { values.clear(); }
    std::int64_t weight(std::size_t, std::size_t) override
    {
        const int low = data.at(at++), high = data.at(at++);
        return std::int16_t(low + 256 * high);
    }
    std::int64_t residual(std::size_t place, std::size_t axis) override
    {
        if (values.empty()) {
            values.resize(3 * count);
            const unsigned planes = data.at(at++);
            for (unsigned n = 0; n < planes; ++n)
                for (std::int64_t &value : values)
                    value += std::int64_t(data.at(at++)) << (8 * n);
        }
        const std::int64_t folded = values[axis * count + place];
        return folded % 2 ? -(folded + 1) / 2 : folded / 2;
    }
    void end() override
    {
        if (at != data.size())
            throw std::string("deflate: too long");
    }

    std::size_t count;
    Data data;
    std::size_t at = 0;
    std::vector<std::int64_t> values;
};

// 11.4
struct Features
{
    std::vector<std::int64_t> values;

    Features(const Walk &walk, std::size_t v, std::size_t axis, const Frame &now, const Frame *p1, const Frame *p2,
             const Frame *p3)
    {
        const auto m = [&](std::size_t u) { return now[u][axis] - (p1 ? (*p1)[u][axis] : 0); };
        const auto mean = [](std::int64_t sum, std::size_t n) {
            return n ? (sum * (65536 / std::int64_t(n))) >> 12 : std::int64_t(0);
        };
        const auto overKnown = [&](auto value) {
            std::int64_t sum = 0;
            for (const std::size_t u : walk.known[v])
                sum += value(u);
            return mean(sum, walk.known[v].size());
        };
        values.push_back(overKnown(m));
        std::int64_t sum = 0;
        for (const auto &[a, b, d] : walk.para[v])
            sum += m(a) + m(b) - m(d);
        values.push_back(walk.para[v].empty() ? values[0] : mean(sum, walk.para[v].size()));
        if (p2) {
            values.push_back(16 * ((*p1)[v][axis] - (*p2)[v][axis]));
            values.push_back(overKnown([&](std::size_t u) { return (*p1)[u][axis] - (*p2)[u][axis]; }));
        }
        if (p3) {
            values.push_back(16 * ((*p2)[v][axis] - (*p3)[v][axis]));
            values.push_back(overKnown([&](std::size_t u) { return (*p2)[u][axis] - (*p3)[u][axis]; }));
        }
    }
};

// 11.3
Frame decodeFrame(const Walk &walk, Source &source, unsigned predictor, std::int64_t resolution, const Frame *p1,
                  const Frame *p2, const Frame *p3)
{
    source.startFrame();
    std::int64_t weights[3][6] = {};
    const std::size_t count = p3 ? 6 : p2 ? 4 : 2;
    if (predictor == 4)
        for (std::size_t axis = 0; axis < 3; ++axis)
            for (std::size_t i = 0; i < count; ++i)
                weights[axis][i] = source.weight(axis, i);
    Frame now(walk.order.size());
    for (std::size_t place = 0; place < now.size(); ++place) {
        const std::size_t v = walk.order[place];
        Point before{};
        if (place > 0)
            before = now[walk.order[place - 1]];
        for (std::size_t axis = 0; axis < 3; ++axis) {
            std::int64_t prediction;
            if (predictor == 4) {
                const Features features(walk, v, axis, now, p1, p2, p3);
                std::int64_t sum = 2048;
                for (std::size_t i = 0; i < count; ++i)
                    sum += weights[axis][i] * features.values[i];
                prediction = (p1 ? (*p1)[v][axis] : 0) + std::clamp<std::int64_t>(sum >> 12, -(1 << 25), 1 << 25);
            } else if (predictor == 0 || !p1) {
                prediction = before[axis];
            } else if (predictor == 1 || !p2) {
                prediction = (*p1)[v][axis];
            } else if (predictor == 2 || !p3) {
                prediction = 2 * (*p1)[v][axis] - (*p2)[v][axis];
            } else {
                prediction = 3 * (*p1)[v][axis] - 3 * (*p2)[v][axis] + (*p3)[v][axis];
            }
            prediction = std::min(std::max<std::int64_t>(prediction, 0), resolution - 1);
            now[v][axis] = prediction + source.residual(place, axis);
            if (now[v][axis] < 0 || now[v][axis] >= resolution)
                throw std::string("value");
        }
    }
    return now;
}

void decode(const Data &file, PlainDirect &anim)
{
    std::map<std::string, Data> chunks = chunksOf(file);
    Cursor head{chunks.at("HEAD")};
    if (head.u8() != 1)
        throw std::string("version");
    head.u8();
    if (head.varuint() != 0 || head.u8() != 1)
        throw std::string("features or codec");
    const std::size_t vertices = head.varuint();
    const std::uint64_t triangles = head.varuint();
    const std::size_t frames = head.varuint();
    // 11.1
    Cursor parameters{chunks.at("DIRP")};
    const std::int64_t resolution = std::int64_t(parameters.varuint());
    const unsigned predictor = parameters.u8();
    const bool usesRange = parameters.u8() == 1;
    const std::size_t group = parameters.varuint();
    anim.cell = parameters.f64();
    for (double &middle : anim.origin)
        middle = parameters.f64();

    const Walk walk(plainTriangles(chunks.at("INDX"), triangles), vertices, predictor == 4);
    Cursor in{chunks.at("FRMS")};
    for (const Data &stream : streams(in, frames, group)) {
        std::unique_ptr<Source> source;
        if (usesRange)
            source = std::make_unique<RangeSource>(walk, stream);
        else
            source = std::make_unique<DeflateSource>(vertices, group * (37 + 12 * vertices), stream);
        const std::size_t first = anim.frames.size();
        for (std::size_t i = 0; i < group && first + i < frames; ++i) {
            const auto before = [&](std::size_t count) {
                return i >= count ? &anim.frames[first + i - count] : static_cast<const Frame *>(nullptr);
            };
            const Frame *p1 = i > 0 ? before(1) : first > 0 ? &anim.frames[0] : nullptr;
            Frame frame = decodeFrame(walk, *source, predictor, resolution, p1, before(2), before(3));
            anim.frames.push_back(std::move(frame));
        }
        source->end();
    }
}

} // namespace

PlainDirect decodeDirectPlainly(const std::vector<std::uint8_t> &file)
{
    return decodedOrError(file, &decode);
}

} // namespace tests
