// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/stlreader.h"

#include "model/io/textpoint.h"

#include <algorithm>
#include <bit>

namespace model::io {

namespace {

constexpr unsigned ItemsBetweenChecks = 1 << 14;
constexpr std::size_t HeaderBytes = 84; // 80 of text, then the number of triangles
constexpr std::size_t FacetBytes = 50;  // normal, three corners, two bytes of attributes
constexpr std::size_t NormalBytes = 12;

std::uint32_t readU32(std::string_view bytes, std::size_t at)
{
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i)
        value |= std::uint32_t(std::uint8_t(bytes[at + i])) << 8 * i;
    return value;
}

char lower(char c)
{
    return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c;
}

bool equalsIgnoringCase(std::string_view a, std::string_view b)
{
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](char x, char y) { return lower(x) == lower(y); });
}

/// Binary headers may start with "solid" too, so the length decides; then whether it looks like text.
bool isText(std::string_view bytes)
{
    if (bytes.size() >= HeaderBytes && bytes.size() == HeaderBytes + FacetBytes * std::uint64_t(readU32(bytes, 80)))
        return false;
    constexpr std::size_t Looked = 256;
    const std::string_view start = bytes.substr(0, Looked);
    return std::none_of(start.begin(), start.end(), [](char c) { return c == '\0'; });
}

Result<void> parseBinary(std::string_view bytes, std::vector<Vec3f> &corners, const Progress &progress)
{
    if (bytes.size() < HeaderBytes)
        return failAtByte(bytes.size(), ErrorCode::Truncated, std::to_string(HeaderBytes),
                          std::to_string(bytes.size()));
    const std::uint64_t count = readU32(bytes, 80), needed = HeaderBytes + FacetBytes * count;
    if (bytes.size() < needed)
        return failAtByte(bytes.size(), ErrorCode::Truncated, std::to_string(needed), std::to_string(bytes.size()));
    if (bytes.size() > needed)
        return failAtByte(needed, ErrorCode::TrailingBytes, std::to_string(bytes.size() - needed));
    corners.reserve(3 * count);
    for (std::uint64_t i = 0; i < count; ++i) {
        if (i % ItemsBetweenChecks == 0 && progress.isCancelled())
            return fail(ErrorCode::Cancelled);
        std::size_t at = HeaderBytes + FacetBytes * i + NormalBytes;
        for (int corner = 0; corner < 3; ++corner) {
            Vec3f p;
            for (float *const c : {&p.x, &p.y, &p.z}) {
                *c = std::bit_cast<float>(readU32(bytes, at));
                if (!std::isfinite(*c))
                    return failAtByte(at, ErrorCode::NonFinite, "triangle " + std::to_string(i));
                at += 4;
            }
            corners.push_back(p);
        }
    }
    return {};
}

/// solid NAME { facet normal X Y Z, outer loop, { vertex X Y Z }, endloop, endfacet } endsolid NAME
class TextParser
{
public:
    TextParser(std::string_view text, std::vector<Vec3f> &corners, std::vector<Vec3d> *precise)
        : mCursor(text)
        , mCorners(corners)
        , mPrecise(precise)
    {}

    Result<void> parse(const Progress &progress)
    {
        mCursor.skipSpaceAndComments();
        if (TextCursor start = mCursor; !equalsIgnoringCase(start.token(), "solid"))
            return failAtLine(mCursor.line(), ErrorCode::BadMagic, "STL");
        bool inSolid = false;
        for (unsigned i = 1;; ++i) {
            if (i % ItemsBetweenChecks == 0 && progress.isCancelled())
                return fail(ErrorCode::Cancelled);
            mCursor.skipSpaceAndComments();
            if (mCursor.atEnd() && !inSolid)
                return {};
            const TextCursor start = mCursor;
            const std::string_view word = mCursor.token();
            if (equalsIgnoringCase(word, inSolid ? "endsolid" : "solid")) {
                inSolid = !inSolid;
                mCursor.skipLine(); // a name
            } else if (inSolid && equalsIgnoringCase(word, "facet")) {
                if (auto done = facet(); !done)
                    return done;
            } else {
                return start.failExpected(inSolid ? QT_TRANSLATE_NOOP("ErrorText", "\"facet\" or \"endsolid\"")
                                                  : QT_TRANSLATE_NOOP("ErrorText", "\"solid\""));
            }
        }
    }

private:
    Result<void> facet()
    {
        if (auto done = word("normal", QT_TRANSLATE_NOOP("ErrorText", "\"normal\"")); !done)
            return done;
        for (int i = 0; i < 3; ++i) { // unused, and some writers put "nan" there
            mCursor.skipSpaceAndComments();
            mCursor.token();
        }
        if (auto done = word("outer", QT_TRANSLATE_NOOP("ErrorText", "\"outer loop\"")); !done)
            return done;
        if (auto done = word("loop", QT_TRANSLATE_NOOP("ErrorText", "\"outer loop\"")); !done)
            return done;
        for (int corner = 0; corner < 3; ++corner)
            if (auto done = vertex(); !done)
                return done;
        if (auto done = word("endloop", QT_TRANSLATE_NOOP("ErrorText", "\"endloop\"")); !done)
            return done;
        return word("endfacet", QT_TRANSLATE_NOOP("ErrorText", "\"endfacet\""));
    }

    Result<void> vertex()
    {
        if (auto done = word("vertex", QT_TRANSLATE_NOOP("ErrorText", "\"vertex\"")); !done)
            return done;
        Vec3f p;
        Vec3d wide;
        if (!readPoint(
                mCursor, [](TextCursor &c) { c.skipSpaceAndComments(); }, p, mPrecise ? &wide : nullptr))
            return mCursor.failExpected(QT_TRANSLATE_NOOP("ErrorText", "a coordinate"));
        if (!isFinite(p))
            return failAtLine(mCursor.line(), ErrorCode::NonFinite, "triangle " + std::to_string(mCorners.size() / 3));
        mCorners.push_back(p);
        if (mPrecise)
            mPrecise->push_back(wide);
        return {};
    }

    Result<void> word(std::string_view wanted, const char *expected)
    {
        mCursor.skipSpaceAndComments();
        const TextCursor start = mCursor;
        if (!equalsIgnoringCase(mCursor.token(), wanted))
            return start.failExpected(expected);
        return {};
    }

    TextCursor mCursor;
    std::vector<Vec3f> &mCorners;
    std::vector<Vec3d> *const mPrecise;
};

std::uint64_t bitsOf(float value)
{
    // Minus zero equals zero, so they must have the same hash: adding zero makes them the same.
    return std::bit_cast<std::uint32_t>(value + 0.0f);
}
std::uint64_t bitsOf(double value)
{
    return std::bit_cast<std::uint64_t>(value + 0.0);
}

template <class Point>
std::uint64_t hashOf(Point p)
{
    std::uint64_t hash = (bitsOf(p.x) << 32 ^ bitsOf(p.x) >> 32 ^ bitsOf(p.y)) * 0x9E3779B97F4A7C15;
    hash = (hash ^ hash >> 32 ^ bitsOf(p.z)) * 0xD6E8FEB86659FD93;
    return hash ^ hash >> 32;
}

/// \param positions, connectivity  empty; written
template <class Point>
void weld(std::span<const Point> corners, std::vector<Point> &positions, Connectivity &connectivity)
{
    // Open addressing, at most half full. A slot holds a vertex plus one.
    std::vector<std::uint32_t> table(std::bit_ceil(2 * corners.size() + 1), 0);
    const std::size_t mask = table.size() - 1;
    connectivity.triangles.resize(corners.size() / 3);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        std::size_t slot = std::size_t(hashOf(corners[i])) & mask;
        while (table[slot] && positions[table[slot] - 1] != corners[i])
            slot = (slot + 1) & mask;
        if (!table[slot]) {
            positions.push_back(corners[i]);
            table[slot] = std::uint32_t(positions.size());
        }
        connectivity.triangles[i / 3][i % 3] = table[slot] - 1;
    }
    connectivity.vertexCount = std::uint32_t(positions.size());
}

} // namespace

Result<void> parseStl(std::string_view bytes, std::vector<Vec3f> &corners, const Progress &progress,
                      std::vector<Vec3d> *precise)
{
    corners.clear();
    const bool isInText = isText(bytes);
    Result<void> parsed =
        isInText ? TextParser(bytes, corners, precise).parse(progress) : parseBinary(bytes, corners, progress);
    if (parsed && corners.empty())
        return fail(ErrorCode::NoVertices);
    if (parsed && precise && !isInText) // which has 32 bits for each
        precise->assign(corners.begin(), corners.end());
    return parsed;
}

TriangleMesh weldCorners(std::span<const Vec3f> corners)
{
    TriangleMesh mesh;
    weld(corners, mesh.positions, mesh.connectivity);
    return mesh;
}

std::vector<Vec3d> weldCorners(std::span<const Vec3d> corners, Connectivity &connectivity)
{
    std::vector<Vec3d> positions;
    weld(corners, positions, connectivity);
    return positions;
}

std::size_t gatherVertices(std::span<const Vec3f> corners, std::span<const Triangle> triangles,
                           std::span<Vec3f> positions)
{
    std::uint32_t met = 0; // vertices come in the order of their first corner
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const std::uint32_t vertex = triangles[i / 3][i % 3];
        if (vertex == met)
            positions[met++] = corners[i];
        else if (positions[vertex] != corners[i])
            return i / 3;
    }
    return triangles.size();
}

} // namespace model::io
