// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/model/codec/plain/plainconnectivity.h"

#include "tests/model/codec/plain/plainmixing.h"

namespace tests {

namespace {

using namespace plain;

constexpr std::int64_t None = -1;
constexpr std::size_t MaxEdges = 1u << 20; // of the tests

/// 12.1; a closed edge has no start.
struct Edge
{
    std::int64_t before = None, next = None, start = None, corner = None;
};

class Walk
{
public:
    Walk(const Data &stream, std::uint64_t triangles)
        : mIn(stream)
        , mCount(std::int64_t(triangles))
    {}

    // 12.2
    void run()
    {
        mHoles = count(mHoleCounts);
        if (mHoles < 0 || mHoles > 3 * mCount / 2)
            throw std::string("holes");
        mFlips = mIn.direct(1);
        while (done() < mCount) {
            const bool atHole = mHoles > 0 && counted(mIn, mStarts);
            std::int64_t gate = atHole ? hole(None, None) : firstTriangle();
            std::vector<std::pair<std::int64_t, std::int64_t>> stack; // an edge and its corner
            while (gate != None) {
                if (mOpen > 3 * (mCount - done()))
                    throw std::string("too many open edges");
                step(gate, stack);
                while (gate == None && !stack.empty()) {
                    const auto [edge, corner] = stack.back();
                    stack.pop_back();
                    if (mEdges[std::size_t(edge)].start != None && mEdges[std::size_t(edge)].corner == corner)
                        gate = edge;
                }
            }
        }
        if (mHoles != 0)
            throw std::string("holes are left");
    }

    /// 12.6 and 12.7; the stream ends here.
    PlainConnectivity result(std::uint64_t vertices)
    {
        std::vector<std::int64_t> name;
        PlainConnectivity result;
        std::int64_t named = 0;
        if (mIn.direct(1)) {
            CountedModel copies[2];
            CountedIntegers steps;
            std::int64_t last = 0;
            bool wasCopy = false;
            for (std::size_t i = 0; i < mNeighbours.size(); ++i) {
                wasCopy = counted(mIn, copies[wasCopy]);
                if (wasCopy) {
                    last += steps.decode(mIn, true);
                    if (last < 0 || last >= named)
                        throw std::string("copy of nothing");
                }
                name.push_back(wasCopy ? last : named++);
            }
        } else {
            for (std::size_t i = 0; i < mNeighbours.size(); ++i)
                name.push_back(named++);
        }
        mIn.end();
        if (named > std::int64_t(vertices))
            throw std::string("too many vertices");
        for (std::size_t t = 0; t < mCorners.size() / 3; ++t) {
            std::array<std::int64_t, 3> triangle;
            for (std::size_t i = 0; i < 3; ++i)
                triangle[i] = name[std::size_t(mCorners[3 * t + i])];
            if (mFlips && mTurned[t])
                std::swap(triangle[1], triangle[2]);
            result.triangles.push_back(triangle);
        }
        result.neighbours.assign(vertices, {None, None, None});
        std::vector<bool> isSeen(vertices, false);
        for (std::size_t i = 0; i < name.size(); ++i) {
            if (isSeen[std::size_t(name[i])])
                continue;
            isSeen[std::size_t(name[i])] = true;
            for (std::size_t j = 0; j < 3; ++j)
                if (mNeighbours[i][j] != None)
                    result.neighbours[std::size_t(name[i])][j] = name[std::size_t(mNeighbours[i][j])];
        }
        return result;
    }

private:
    std::int64_t done() const { return std::int64_t(mCorners.size() / 3); }
    std::int64_t count(CountedIntegers &models) { return models.decode(mIn, false); }
    Edge &edge(std::int64_t i) { return mEdges[std::size_t(i)]; }
    std::int64_t endOf(std::int64_t i) { return edge(edge(i).next).start; }
    static std::uint32_t capped(unsigned d) { return std::min(d, 15u); }
    std::uint32_t cappedStart(std::int64_t i) { return capped(degree(edge(i).start)); }
    bool isRim(std::int64_t i) { return edge(i).corner == None; }
    unsigned degree(std::int64_t v) const { return std::min(mDegrees[std::size_t(v)], 255u); }

    std::int64_t newVertex(std::int64_t left, std::int64_t right, std::int64_t opposite)
    {
        mNeighbours.push_back({left, right, opposite});
        mDegrees.push_back(0);
        return std::int64_t(mNeighbours.size()) - 1;
    }
    std::int64_t newEdge(std::int64_t start, std::int64_t corner)
    {
        std::int64_t i = std::int64_t(mEdges.size());
        if (!mFree.empty()) {
            i = mFree.back();
            mFree.pop_back();
        } else {
            if (mEdges.size() == MaxEdges)
                throw std::string("too many edges for a test");
            mEdges.push_back({});
        }
        edge(i) = {None, None, start, corner};
        ++mOpen;
        return i;
    }
    void close(std::int64_t i)
    {
        edge(i).start = None;
        mFree.push_back(i);
        --mOpen;
    }
    void link(std::int64_t a, std::int64_t b)
    {
        edge(a).next = b;
        edge(b).before = a;
    }

    /// A triangle and its turn; the corners are those across the gate, *after* and *before*, or None.
    std::int64_t triangle(std::int64_t a, std::int64_t b, std::int64_t c, std::int64_t behind,
                          std::int64_t afterwards = None, std::int64_t beforehand = None)
    {
        const std::int64_t corner = std::int64_t(mCorners.size());
        for (const std::int64_t v : {a, b, c}) {
            mCorners.push_back(v);
            ++mDegrees[std::size_t(v)];
        }
        if (!mFlips)
            return corner;
        std::size_t around = 0, first = turnAcross(behind), latest = 0;
        for (const std::int64_t across : {behind, afterwards, beforehand})
            around = 3 * around + turnAcross(across);
        for (std::size_t i = std::min<std::size_t>(mTurned.size(), 4); i > 0; --i)
            latest = 2 * latest + mTurned[mTurned.size() - i];
        mTurned.push_back(mixed(mIn, {&mBehind[first], &mAround[around], &mLatest[latest]}, mTurnWeights, 255, 960) !=
                          0);
        return corner;
    }
    std::size_t turnAcross(std::int64_t corner) const
    {
        return corner == None ? 2 : mTurned[std::size_t(corner / 3)] ? 1 : 0;
    }

    std::int64_t firstTriangle()
    {
        const std::int64_t a = newVertex(None, None, None), b = newVertex(a, a, a), c = newVertex(b, b, a);
        const std::int64_t corner = triangle(a, b, c, None);
        const std::int64_t ba = newEdge(b, corner + 2), ac = newEdge(a, corner + 1), cb = newEdge(c, corner);
        link(ba, ac);
        link(ac, cb);
        link(cb, ba);
        return ba;
    }

    /// \param before  l of the step
    std::int64_t hole(std::int64_t v, std::int64_t before)
    {
        const std::int64_t n = count(mHoleLengths);
        if (n < 2 || mHoles == 0 || mOpen + n > 3 * (mCount - done()))
            throw std::string("hole");
        --mHoles;
        std::int64_t c2 = before, c1 = v, first = None, last = None;
        for (std::int64_t i = 0; i < n; ++i) {
            std::int64_t vertex = v;
            if (i > 0 || v == None) {
                vertex = c1 == None   ? newVertex(None, None, None)
                         : c2 == None ? newVertex(c1, c1, c1)
                                      : newVertex(c1, c1, c2);
                c2 = c1;
                c1 = vertex;
            }
            mDegrees[std::size_t(vertex)] += 3;
            const std::int64_t now = newEdge(vertex, None);
            if (i == 0)
                first = now;
            else
                link(last, now);
            last = now;
        }
        link(last, first);
        return first;
    }

    // 12.3
    void step(std::int64_t &gate, std::vector<std::pair<std::int64_t, std::int64_t>> &stack)
    {
        const std::int64_t before = edge(gate).before, after = edge(gate).next;
        const std::int64_t l = edge(gate).start, r = edge(after).start, behind = edge(gate).corner;
        const char symbol = this->symbol(gate);
        if (symbol == 'C') {
            mustOpenOneMore();
            const std::int64_t v = behind == None ? newVertex(l, l, l) : newVertex(l, r, mCorners[std::size_t(behind)]);
            const std::int64_t corner = triangle(v, l, r, behind);
            const std::int64_t left = newEdge(l, corner + 2);
            edge(gate).start = v;
            edge(gate).corner = corner + 1;
            link(before, left);
            link(left, gate);
            link(gate, after);
            const std::int64_t p =
                std::min<std::int64_t>(std::max<std::int64_t>(mHoles * 131072 / (mCount - done() + 1), 24), 32768);
            if (mHoles > 0 && mIn.decision(std::uint32_t(p))) {
                const std::int64_t first = hole(v, l), last = edge(first).before;
                link(left, first);
                link(last, gate);
            }
        } else if (symbol == 'S') {
            mustOpenOneMore();
            const std::int64_t x = place(gate);
            const std::int64_t v = edge(x).start;
            if (v == l || v == r)
                throw std::string("S at the gate");
            const std::int64_t corner = triangle(v, l, r, behind);
            const std::int64_t left = newEdge(l, corner + 2);
            edge(gate).start = v;
            edge(gate).corner = corner + 1;
            const std::int64_t beforeX = edge(x).before;
            link(before, left);
            link(left, x);
            link(beforeX, gate);
            link(gate, after);
            stack.push_back({left, corner + 2});
        } else if (symbol == 'R') {
            const std::int64_t v = endOf(after);
            if (v == l)
                throw std::string("R at l");
            const std::int64_t corner = triangle(v, l, r, behind, edge(after).corner), beyond = edge(after).next;
            close(after);
            edge(gate).corner = corner + 2;
            link(gate, beyond);
        } else if (symbol == 'L') {
            const std::int64_t v = edge(before).start;
            if (v == r)
                throw std::string("L at r");
            const std::int64_t corner = triangle(v, l, r, behind, None, edge(before).corner),
                               beyond = edge(before).before;
            close(before);
            edge(gate).start = v;
            edge(gate).corner = corner + 1;
            link(beyond, gate);
        } else {
            triangle(edge(before).start, l, r, behind, edge(after).corner, edge(before).corner);
            close(before);
            close(after);
            close(gate);
            gate = None;
        }
    }

    void mustOpenOneMore() const
    {
        if (mOpen + 1 > 3 * (mCount - done()))
            throw std::string("too many open edges");
    }

    static std::uint32_t hash(const std::vector<std::uint32_t> &context)
    {
        std::uint32_t h = 0;
        for (const std::uint32_t x : context)
            h = (h + x + 1) * 0x9e3779b1u;
        return h;
    }

    // 12.4
    char symbol(std::int64_t gate)
    {
        const std::int64_t before = edge(gate).before, after = edge(gate).next;
        const unsigned degreeOfR = degree(edge(after).start);
        const std::uint32_t r = std::min(degreeOfR, 20u);
        const std::uint32_t l = capped(degree(edge(gate).start));
        const std::uint32_t afterEnd = capped(degree(endOf(after)));
        const std::int64_t second = edge(after).next;
        const std::uint32_t rims = std::uint32_t(isRim(before) + 2 * isRim(gate) + 4 * isRim(after) +
                                                 8 * isRim(second) + 16 * isRim(edge(second).next));
        const std::uint32_t beforeStart = capped(degree(edge(before).start));
        const std::uint32_t beyond = capped(degree(endOf(edge(after).next)));
        const std::int64_t behind = edge(gate).corner;
        const std::uint32_t b = behind == None ? 0 : capped(degree(mCorners[std::size_t(behind)]));
        const std::vector<std::vector<std::uint32_t>> contexts{{r, l},
                                                               {r, rims},
                                                               {r, mClosed, mClosedBefore},
                                                               {r, afterEnd, beyond, l},
                                                               {r, l, afterEnd, beforeStart, b},
                                                               {r, mHistory, afterEnd},
                                                               {r, mHistory % 125}};
        const std::int64_t afterNext = edge(after).next;
        const std::uint32_t loop = after == before ? 0 : afterNext == before ? 1 : 2; // two, three, more edges
        const auto ask = [&](std::uint32_t question) {
            std::vector<CountedModel *> models;
            for (std::uint32_t i = 0; i < contexts.size(); ++i) {
                const std::uint32_t number = (hash(contexts[i]) + question) * 0x9e3779b1u >> 16;
                models.push_back(&mModels[(std::uint64_t(i) << 16) + number]);
            }
            return mixed(mIn, models, mWeights[question * 3 + loop], 255, 960);
        };
        char result = 'R';
        if (ask(0))
            result = 'C';
        else if (loop == 0)
            result = 'S';
        else if (!ask(1))
            result = ask(3) ? 'L' : 'S';
        else if (loop == 1 && ask(2))
            result = 'E';
        const std::uint32_t digit = std::uint32_t(std::string("CSRLE").find(result));
        mHistory = (5 * mHistory + digit) % 15625;
        if (result == 'R') {
            mClosedBefore = mClosed;
            mClosed = capped(degreeOfR + 1);
        }
        return result;
    }

    // 12.5: the edges near the gate
    std::int64_t nearPlace(std::int64_t gate)
    {
        const std::int64_t after = edge(gate).next;
        std::int64_t lastAfter = edge(after).next, lastBefore = edge(gate).before;
        for (const int k :
             {2, 3, -2, 4, -3, 5, -4, 6, 7, -5, 8, -6, 9, 10, -7, 11, -8, 12, -9, 13, 14, -10, 15, -11, 16, -12}) {
            std::uint32_t between = 0;
            for (std::int64_t x = lastAfter; x != lastBefore && between < 4; x = edge(x).next)
                ++between;
            if (between <= 1) // the last ones are one edge, or neighbours
                return None;
            between = std::min(between - 1, 3u);
            const bool isAfter = k > 0;
            std::int64_t &x = isAfter ? lastAfter : lastBefore;
            x = isAfter ? edge(x).next : edge(x).before;
            const std::uint32_t side = isAfter ? 0 : 1, size = std::uint32_t(isAfter ? k : -k);
            const std::uint32_t d = cappedStart(x);
            const std::uint32_t inner = cappedStart(isAfter ? edge(x).before : edge(x).next);
            const std::uint32_t outer = cappedStart(isAfter ? edge(x).next : edge(x).before);
            const std::uint32_t end = cappedStart(isAfter ? after : gate);
            const std::uint32_t rims = std::uint32_t(isRim(x) + 2 * isRim(edge(x).before));
            const std::vector<std::vector<std::uint32_t>> contexts{{side, size, between},
                                                                   {side, size, d, rims},
                                                                   {side, d, outer, rims, between},
                                                                   {side, std::min(size, 3u), d, inner},
                                                                   {d, rims, end}};
            std::vector<CountedModel *> models;
            for (std::uint32_t i = 0; i < contexts.size(); ++i)
                models.push_back(&mPlaceModels[(std::uint64_t(i) << 14) + (hash(contexts[i]) >> 18)]);
            if (mixed(mIn, models, mPlaceWeights.try_emplace({side, std::min(size, 4u)}, 5).first->second, 255, 960))
                return x;
        }
        return None;
    }

    std::int64_t place(std::int64_t gate)
    {
        if (const std::int64_t x = nearPlace(gate); x != None)
            return x;
        const std::int64_t s = mPlaces.decode(mIn, true), size = s < 0 ? -s : s;
        if (size > 1000 || size > mLeft)
            throw std::string("place");
        mLeft -= size;
        if (s != 0) {
            std::int64_t x = s > 0 ? edge(gate).next : gate;
            for (std::int64_t i = 0; i < size; ++i)
                x = s > 0 ? edge(x).next : edge(x).before;
            return x;
        }
        unsigned left = bits(mEdges.size() - 1);
        std::uint64_t x = 0;
        while (left > 0) {
            const unsigned now = std::min(left, 12u);
            x = (x << now) + mIn.direct(now);
            left -= now;
        }
        if (x >= mEdges.size() || mEdges[x].start == None)
            throw std::string("number of no edge");
        return std::int64_t(x);
    }

    Range mIn;
    const std::int64_t mCount;
    std::vector<std::int64_t> mCorners; ///< the vertex of each
    std::vector<bool> mTurned;
    std::vector<std::array<std::int64_t, 3>> mNeighbours;
    std::vector<unsigned> mDegrees;
    std::vector<Edge> mEdges;
    std::vector<std::int64_t> mFree;
    std::int64_t mOpen = 0, mHoles = 0;
    std::int64_t mLeft = 65536 + 16 * mCount;
    bool mFlips = false;
    std::uint32_t mHistory = 0, mClosed = 0, mClosedBefore = 0;
    CountedIntegers mHoleCounts, mHoleLengths, mPlaces;
    CountedModel mStarts, mBehind[3], mAround[27], mLatest[16];
    WeightSet mTurnWeights{3};
    CountedModels mModels, mPlaceModels;
    std::map<std::pair<std::uint32_t, std::uint32_t>, WeightSet> mPlaceWeights;
    std::vector<WeightSet> mWeights = std::vector<WeightSet>(12, WeightSet(7));
};

} // namespace

PlainConnectivity decodeConnectivityPlainly(const std::vector<std::uint8_t> &payload, std::uint64_t vertices,
                                            std::uint64_t triangles)
{
    Walk walk(payload, triangles);
    walk.run();
    return walk.result(vertices);
}

std::vector<std::int64_t> decodeOrderPlainly(const std::vector<std::uint8_t> &payload,
                                             const std::vector<std::array<std::int64_t, 3>> &neighbours)
{
    Range in(payload);
    const std::int64_t count = std::int64_t(neighbours.size());
    std::vector<bool> isFree(neighbours.size(), true);
    const auto free = [&](std::int64_t place) { return place >= 0 && place < count && isFree[std::size_t(place)]; };
    Model hits[8][7], isNumber;
    std::size_t lastHit = 0;
    Integers distances(6);
    std::int64_t lastDistance = 0;
    std::vector<std::int64_t> places;
    for (std::size_t v = 0; v < neighbours.size(); ++v) {
        const std::int64_t p = v == 0 ? -1 : places[v - 1];
        std::int64_t near = p;
        std::vector<std::int64_t> guesses{p + 1, p - 1};
        if (neighbours[v][0] != None) {
            const auto at = [&](std::size_t i) { return places[std::size_t(neighbours[v][i])]; };
            const std::int64_t l = at(0), r = at(1), o = at(2);
            guesses = {p + 1, l + r - o, p - 1, l + 1, l - 1, r + 1, r - 1};
            near = l;
        }
        std::int64_t place = None;
        for (std::size_t i = 0; i < guesses.size() && place == None; ++i) {
            bool isNew = free(guesses[i]);
            for (std::size_t j = 0; j < i; ++j)
                isNew = isNew && guesses[j] != guesses[i];
            if (isNew && in.bit(hits[lastHit][i])) {
                place = guesses[i];
                lastHit = i;
            }
        }
        if (place == None) {
            lastHit = 7;
            if (in.bit(isNumber)) {
                std::uint64_t left = 0, n = 0;
                for (std::int64_t i = 0; i < count; ++i)
                    left += free(i);
                unsigned more = bits(left - 1);
                while (more > 0) {
                    const unsigned now = std::min(more, 12u);
                    n = (n << now) + in.direct(now);
                    more -= now;
                }
                for (std::int64_t i = 0; i < count && place == None; ++i)
                    if (free(i) && n-- == 0)
                        place = i;
            } else {
                const std::uint64_t size = std::uint64_t(lastDistance < 0 ? -lastDistance : lastDistance);
                lastDistance = distances.decode(in, sizeOf(size), signOf(lastDistance));
                place = near + lastDistance;
            }
        }
        if (!free(place))
            throw std::string("place is not free");
        isFree[std::size_t(place)] = false;
        places.push_back(place);
    }
    in.end();
    return places;
}

} // namespace tests
