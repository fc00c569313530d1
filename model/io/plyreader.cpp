// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/plyreader.h"

#include "model/io/plyheader.h"

#include <bit>

namespace model::io {

namespace {

using Role = PlyProperty::Role;
using Kind = PlyElement::Kind;

/// Values of a binary file, one after the other. A read past the end gives 0 and fails.
class BinaryValues
{
public:
    BinaryValues(std::string_view bytes, std::size_t begin, bool isBigEndian)
        : mBytes(bytes)
        , mPosition(begin)
        , mSwap(isBigEndian)
    {}

    std::uint64_t left() const { return mBytes.size() - mPosition; }
    bool isAtEnd() const { return left() == 0; }

    Result<std::int64_t> integer(PlyType type)
    {
        if (const std::size_t size = sizeOf(type); left() < size)
            return truncated(size);
        switch (type) {
        case PlyType::Int8:
            return std::int8_t(bits<1>());
        case PlyType::Uint8:
            return std::uint8_t(bits<1>());
        case PlyType::Int16:
            return std::int16_t(bits<2>());
        case PlyType::Uint16:
            return std::uint16_t(bits<2>());
        case PlyType::Int32:
            return std::int32_t(bits<4>());
        default:
            return std::uint32_t(bits<4>());
        }
    }
    Result<double> coordinate(PlyType type)
    {
        if (const std::size_t size = sizeOf(type); left() < size)
            return truncated(size);
        if (type == PlyType::Float32)
            return double(std::bit_cast<float>(std::uint32_t(bits<4>())));
        if (type == PlyType::Float64)
            return std::bit_cast<double>(bits<8>());
        return double(*integer(type));
    }
    Result<void> skip(PlyType type, std::uint64_t count)
    {
        const std::uint64_t size = count * sizeOf(type); // count is below 2^32
        if (left() < size)
            return truncated(size);
        mPosition += size;
        return {};
    }
    Result<void> checkSpace(std::uint64_t size) const
    {
        if (left() < size)
            return truncated(size);
        return {};
    }

    tl::unexpected<Error> at(tl::unexpected<Error> error) const
    {
        return fail(std::move(error).value().atByte(mPosition));
    }
    tl::unexpected<Error> failExpected(const char *expected, std::int64_t found) const
    {
        return at(fail(ErrorCode::SyntaxError, expected, std::to_string(found)));
    }
    Result<void> finish() const
    {
        if (!isAtEnd())
            return at(fail(ErrorCode::TrailingBytes, std::to_string(left())));
        return {};
    }

private:
    template <std::size_t Size>
    std::uint64_t bits()
    {
        std::uint64_t value = 0;
        for (std::size_t i = 0; i < Size; ++i) {
            const auto byte = std::uint64_t(std::uint8_t(mBytes[mPosition + i]));
            value |= byte << 8 * (mSwap ? Size - 1 - i : i);
        }
        mPosition += Size;
        return value;
    }
    tl::unexpected<Error> truncated(std::uint64_t size) const
    {
        return at(fail(ErrorCode::Truncated, std::to_string(size), std::to_string(left())));
    }

    std::string_view mBytes;
    std::size_t mPosition;
    bool mSwap;
};

/// The same for the text form, whose values are separated by blanks and line ends.
class TextValues
{
public:
    TextValues(const TextCursor &cursor, bool isPrecise)
        : mCursor(cursor)
        , mIsPrecise(isPrecise)
    {}

    Result<std::int64_t> integer(PlyType)
    {
        skipSpace();
        const TextCursor start = mCursor;
        std::int64_t value = 0;
        if (!mCursor.integer(value) || !mCursor.atTokenEnd())
            return start.failExpected(QT_TRANSLATE_NOOP("ErrorText", "an integer"));
        return value;
    }
    Result<double> coordinate(PlyType)
    {
        skipSpace();
        float narrow = 0;
        double value = 0;
        if (!(mIsPrecise ? mCursor.number(value) : mCursor.number(narrow)))
            return mCursor.failExpected(QT_TRANSLATE_NOOP("ErrorText", "a coordinate"));
        return mIsPrecise ? value : double(narrow);
    }
    Result<void> skip(PlyType, std::uint64_t count)
    {
        for (std::uint64_t i = 0; i < count; ++i) {
            skipSpace();
            if (mCursor.token().empty())
                return mCursor.failExpected(QT_TRANSLATE_NOOP("ErrorText", "a value"));
        }
        return {};
    }
    Result<void> checkSpace(std::uint64_t size) const
    {
        if (size > mCursor.left() + 1)
            return at(fail(ErrorCode::Truncated, std::to_string(size), std::to_string(mCursor.left())));
        return {};
    }

    tl::unexpected<Error> at(tl::unexpected<Error> error) const
    {
        return fail(std::move(error).value().atLine(mCursor.line()));
    }
    tl::unexpected<Error> failExpected(const char *expected, std::int64_t found) const
    {
        return at(fail(ErrorCode::SyntaxError, expected, std::to_string(found)));
    }
    Result<void> finish() { return {}; }

private:
    void skipSpace()
    {
        mCursor.skipBlanks();
        while (mCursor.peek() == '\n') {
            mCursor.skipLine();
            mCursor.skipBlanks();
        }
    }

    TextCursor mCursor;
    const bool mIsPrecise;
};

template <class Values>
class ElementReader
{
public:
    ElementReader(Values values, const PlyHeader &header, TriangleMesh &mesh, std::vector<Vec3d> *precise, Faces *faces)
        : mValues(std::move(values))
        , mHeader(header)
        , mPositions(mesh.positions)
        , mTriangles(mesh.connectivity.triangles)
        , mPrecise(precise)
        , mFaces(faces)
    {}

    Result<void> readAll(const Progress &progress)
    {
        constexpr unsigned ElementsBetweenChecks = 1 << 14;
        for (const PlyElement &element : mHeader.elements) {
            if (element.properties.empty())
                continue; // nothing in the file, however many there are
            if (auto fits = mValues.checkSpace(element.count * minSize(element)); !fits)
                return fits;
            if (element.kind == Kind::Vertex)
                mPositions.reserve(element.count);
            if (element.kind == Kind::Face && !mFaces)
                mTriangles.reserve(element.count);
            for (std::uint64_t i = 0; i < element.count; ++i) {
                if (i % ElementsBetweenChecks == 0 && progress.isCancelled())
                    return fail(ErrorCode::Cancelled);
                if (auto read = readElement(element); !read)
                    return read;
            }
        }
        return mValues.finish();
    }

private:
    std::uint64_t minSize(const PlyElement &element) const
    {
        constexpr std::uint64_t MinTextValue = 2; // a digit and a separator
        return mHeader.format == PlyHeader::Format::Text ? element.properties.size() * MinTextValue
                                                         : element.minBytes();
    }

    Result<void> readElement(const PlyElement &element)
    {
        Vec3d p;
        for (const PlyProperty &property : element.properties) {
            Result<void> done;
            switch (property.role) {
            case Role::X:
                done = readCoordinate(property, p.x);
                break;
            case Role::Y:
                done = readCoordinate(property, p.y);
                break;
            case Role::Z:
                done = readCoordinate(property, p.z);
                break;
            case Role::Corners:
                done = readCorners(property);
                break;
            case Role::None:
                done = property.isList ? skipList(property) : mValues.skip(property.type, 1);
                break;
            }
            if (!done)
                return done;
        }
        if (element.kind == Kind::Vertex) {
            mPositions.push_back({float(p.x), float(p.y), float(p.z)});
            if (mPrecise)
                mPrecise->push_back(p);
        }
        return {};
    }

    Result<void> readCoordinate(const PlyProperty &property, double &value)
    {
        const Result<double> read = mValues.coordinate(property.type);
        if (!read)
            return fail(read.error());
        if (!std::isfinite(float(*read)))
            return mValues.at(fail(ErrorCode::NonFinite, "vertex " + std::to_string(mPositions.size())));
        value = *read;
        return {};
    }

    Result<std::uint64_t> readCount(const PlyProperty &property)
    {
        const Result<std::int64_t> count = mValues.integer(property.countType);
        if (!count)
            return fail(count.error());
        constexpr std::int64_t MaxCount = 0xFFFFFFFF;
        if (*count < 0 || *count > MaxCount)
            return mValues.at(fail(ErrorCode::BadValue, QT_TRANSLATE_NOOP("ErrorText", "the length of a list"),
                                   std::to_string(*count), "0.." + std::to_string(MaxCount)));
        return std::uint64_t(*count);
    }

    Result<void> skipList(const PlyProperty &property)
    {
        const Result<std::uint64_t> count = readCount(property);
        if (!count)
            return fail(count.error());
        return mValues.skip(property.type, *count);
    }

    Result<void> readCorners(const PlyProperty &property)
    {
        const Result<std::uint64_t> count = readCount(property);
        if (!count)
            return fail(count.error());
        if (*count < (mFaces ? 1 : 3))
            return mValues.failExpected(QT_TRANSLATE_NOOP("ErrorText", "a face with at least 3 corners"),
                                        std::int64_t(*count));
        std::uint32_t first = 0, previous = 0;
        mCorners.clear();
        for (std::uint64_t corner = 0; corner < *count; ++corner) {
            const Result<std::int64_t> index = mValues.integer(property.type);
            if (!index)
                return fail(index.error());
            if (*index < 0 || *index >= std::int64_t(mHeader.vertexCount))
                return mValues.at(
                    fail(ErrorCode::IndexOutOfRange, std::to_string(*index), std::to_string(mHeader.vertexCount)));
            if (mFaces)
                mCorners.push_back(std::uint32_t(*index));
            else if (corner == 0)
                first = std::uint32_t(*index);
            else if (corner >= 2)
                mTriangles.push_back({first, previous, std::uint32_t(*index)});
            previous = std::uint32_t(*index);
        }
        if (mFaces)
            mFaces->add(mCorners);
        return {};
    }

    Values mValues;
    const PlyHeader &mHeader;
    std::vector<Vec3f> &mPositions;
    std::vector<Triangle> &mTriangles;
    std::vector<Vec3d> *const mPrecise;
    Faces *const mFaces;
    std::vector<std::uint32_t> mCorners; ///< of a face
};

} // namespace

Result<void> parsePly(std::string_view bytes, TriangleMesh &mesh, const Progress &progress, std::vector<Vec3d> *precise,
                      Faces *faces)
{
    mesh.positions.clear();
    mesh.connectivity.triangles.clear();
    TextCursor cursor(bytes);
    const Result<PlyHeader> header = parsePlyHeader(cursor);
    if (!header)
        return fail(header.error());
    mesh.connectivity.vertexCount = std::uint32_t(header->vertexCount);
    if (header->vertexCount == 0 && !faces)
        return fail(ErrorCode::NoVertices);
    if (header->format == PlyHeader::Format::Text)
        return ElementReader(TextValues(cursor, precise != nullptr), *header, mesh, precise, faces).readAll(progress);
    const bool isBigEndian = header->format == PlyHeader::Format::BigEndian;
    return ElementReader(BinaryValues(bytes, cursor.offset(), isBigEndian), *header, mesh, precise, faces)
        .readAll(progress);
}

} // namespace model::io
