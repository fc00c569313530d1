// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/plyheader.h"

#include <algorithm>
#include <optional>

namespace model::io {

namespace {

using Role = PlyProperty::Role;
using Kind = PlyElement::Kind;

std::optional<PlyType> typeOf(std::string_view name)
{
    // Old and new name of each type, in the order of PlyType.
    constexpr std::array<std::string_view, 16> Names{"char",   "int8",    "uchar",  "uint8",  "short", "int16",
                                                     "ushort", "uint16",  "int",    "int32",  "uint",  "uint32",
                                                     "float",  "float32", "double", "float64"};
    const auto at = std::find(Names.begin(), Names.end(), name);
    return at == Names.end() ? std::nullopt : std::optional(PlyType((at - Names.begin()) / 2));
}

Role roleOf(Kind element, std::string_view property, bool isList)
{
    if (element == Kind::Vertex && !isList)
        return property == "x" ? Role::X : property == "y" ? Role::Y : property == "z" ? Role::Z : Role::None;
    if (element == Kind::Face && isList && (property == "vertex_indices" || property == "vertex_index"))
        return Role::Corners;
    return Role::None;
}

class HeaderParser
{
public:
    explicit HeaderParser(TextCursor &cursor)
        : mCursor(cursor)
    {}

    Result<PlyHeader> parse()
    {
        if (mCursor.token() != "ply" || !mCursor.atLineEndAfterBlanks())
            return failAtLine(1, ErrorCode::BadMagic, "PLY");
        mCursor.skipLine();
        bool hasFormat = false;
        for (;; mCursor.skipLine()) {
            mCursor.skipBlanks();
            const TextCursor start = mCursor;
            const std::string_view word = mCursor.token();
            Result<void> done;
            if (word == "format" && !hasFormat) {
                hasFormat = true;
                done = format();
            } else if (word == "element") {
                done = element();
            } else if (word == "property" && !mHeader.elements.empty()) {
                done = property();
            } else if (word == "end_header" && hasFormat && mCursor.atLineEndAfterBlanks() && !mCursor.atEnd()) {
                break;
            } else if (word != "comment" && word != "obj_info") {
                return start.failExpected(QT_TRANSLATE_NOOP("ErrorText", "a line of a PLY header"));
            }
            if (!done)
                return fail(std::move(done.error()));
        }
        mCursor.skipLine();
        if (auto complete = checkComplete(); !complete)
            return fail(std::move(complete.error()));
        return std::move(mHeader);
    }

private:
    std::string_view nextWord()
    {
        mCursor.skipBlanks();
        return mCursor.token();
    }

    Result<void> format()
    {
        mCursor.skipBlanks();
        const TextCursor start = mCursor;
        const std::string_view name = mCursor.token();
        if (name == "ascii")
            mHeader.format = PlyHeader::Format::Text;
        else if (name == "binary_little_endian")
            mHeader.format = PlyHeader::Format::LittleEndian;
        else if (name == "binary_big_endian")
            mHeader.format = PlyHeader::Format::BigEndian;
        else
            return start.failExpected(QT_TRANSLATE_NOOP("ErrorText", "a PLY format"));
        if (const std::string_view version = nextWord(); version != "1.0")
            return failAtLine(mCursor.line(), ErrorCode::UnsupportedVersion, version, "1.0");
        return {};
    }

    Result<void> element()
    {
        PlyElement result;
        const std::string_view name = nextWord();
        result.kind = name == "vertex" ? Kind::Vertex : name == "face" ? Kind::Face : Kind::Other;
        mCursor.skipBlanks();
        const TextCursor start = mCursor;
        std::int64_t count = 0;
        if (!mCursor.integer(count) || !mCursor.atTokenEnd())
            return start.failExpected(QT_TRANSLATE_NOOP("ErrorText", "the number of elements"));
        constexpr std::int64_t MaxCount = 0xFFFFFFFF;
        if (count < 0 || count > MaxCount)
            return failAtLine(mCursor.line(), ErrorCode::BadValue,
                              QT_TRANSLATE_NOOP("ErrorText", "the number of elements"), std::to_string(count),
                              "0.." + std::to_string(MaxCount));
        result.count = std::uint64_t(count);
        if (result.kind != Kind::Other && find(result.kind))
            return failAtLine(mCursor.line(), ErrorCode::DuplicateChunk, name);
        if (name == "tristrips" && count > 0)
            return failAtLine(mCursor.line(), ErrorCode::UnsupportedFeature,
                              QT_TRANSLATE_NOOP("ErrorText", "triangle strips"));
        mHeader.elements.push_back(std::move(result));
        return {};
    }

    Result<void> property()
    {
        PlyProperty result;
        mCursor.skipBlanks();
        TextCursor start = mCursor;
        std::string_view word = mCursor.token();
        if (word == "list") {
            result.isList = true;
            mCursor.skipBlanks();
            start = mCursor;
            const auto countType = typeOf(mCursor.token());
            if (!countType || !isInteger(*countType))
                return start.failExpected(QT_TRANSLATE_NOOP("ErrorText", "an integer type"));
            result.countType = *countType;
            mCursor.skipBlanks();
            start = mCursor;
            word = mCursor.token();
        }
        const auto type = typeOf(word);
        if (!type)
            return start.failExpected(QT_TRANSLATE_NOOP("ErrorText", "a type"));
        result.type = *type;
        PlyElement &element = mHeader.elements.back();
        result.role = roleOf(element.kind, nextWord(), result.isList);
        if (result.role == Role::Corners && !isInteger(result.type))
            return start.failExpected(QT_TRANSLATE_NOOP("ErrorText", "an integer type"));
        element.properties.push_back(result);
        return {};
    }

    Result<void> checkComplete()
    {
        const auto roles = [](const PlyElement &element, Role role) {
            return std::count_if(element.properties.begin(), element.properties.end(),
                                 [role](const PlyProperty &p) { return p.role == role; });
        };
        if (const PlyElement *const vertex = find(Kind::Vertex)) {
            mHeader.vertexCount = vertex->count;
            for (const Role role : {Role::X, Role::Y, Role::Z})
                if (roles(*vertex, role) != 1)
                    return fail(ErrorCode::UnsupportedFeature,
                                QT_TRANSLATE_NOOP("ErrorText", "vertices without one x, y and z each"));
        }
        if (const PlyElement *const face = find(Kind::Face)) {
            mHeader.faceCount = face->count;
            if (face->count > 0 && roles(*face, Role::Corners) != 1)
                return fail(ErrorCode::UnsupportedFeature,
                            QT_TRANSLATE_NOOP("ErrorText", "faces without one list of vertices"));
        }
        return {};
    }

    const PlyElement *find(Kind kind) const
    {
        const auto at = std::find_if(mHeader.elements.begin(), mHeader.elements.end(),
                                     [kind](const PlyElement &e) { return e.kind == kind; });
        return at == mHeader.elements.end() ? nullptr : &*at;
    }

    TextCursor &mCursor;
    PlyHeader mHeader;
};

} // namespace

std::uint64_t PlyElement::minBytes() const
{
    std::uint64_t bytes = 0;
    for (const PlyProperty &property : properties)
        bytes += sizeOf(property.isList ? property.countType : property.type);
    return bytes;
}

Result<PlyHeader> parsePlyHeader(TextCursor &cursor)
{
    return HeaderParser(cursor).parse();
}

} // namespace model::io
