// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/offreader.h"

#include "model/io/textcursor.h"

namespace model::io {

namespace {

constexpr unsigned ItemsBetweenChecks = 1 << 16;

class OffParser
{
public:
    OffParser(std::string_view text, ParsedMesh &mesh, Faces *faces)
        : mCursor(text)
        , mParsed(mesh)
        , mPositions(mesh.mesh.positions)
        , mConnectivity(mesh.mesh.connectivity)
        , mFaces(faces)
    {}

    Result<bool> parse(const Progress &progress, const KnownFaces &known)
    {
        std::int64_t vertexCount = 0, faceCount = 0;
        Result<void> done = keyword();
        if (done)
            done = count(QT_TRANSLATE_NOOP("ErrorText", "the number of vertices"), MinVertexText, vertexCount);
        if (done)
            done = count(QT_TRANSLATE_NOOP("ErrorText", "the number of faces"), mFaces ? MinPointText : MinFaceText,
                         faceCount);
        if (!done)
            return fail(std::move(done.error()));
        mCursor.skipLine(); // the number of edges, which nobody needs and not everybody writes
        if (vertexCount == 0 && !mFaces)
            return fail(ErrorCode::NoVertices);

        mPositions.reserve(std::size_t(vertexCount));
        for (std::int64_t i = 0; i < vertexCount; ++i) {
            if (i % ItemsBetweenChecks == 0 && progress.isCancelled())
                return fail(ErrorCode::Cancelled);
            if (done = vertex(); !done)
                return fail(std::move(done.error()));
        }
        mConnectivity.vertexCount = std::uint32_t(vertexCount);
        mCursor.skipSpaceAndComments();
        mParsed.facesBegin = mCursor.offset();
        mParsed.announcedFaces = faceCount;
        if (known.vertexCount == vertexCount && known.announcedFaces == faceCount && known.text == mCursor.rest())
            return true;

        if (!mFaces)
            mConnectivity.triangles.reserve(std::size_t(faceCount));
        for (std::int64_t i = 0; i < faceCount; ++i) {
            if (i % ItemsBetweenChecks == 0 && progress.isCancelled())
                return fail(ErrorCode::Cancelled);
            if (done = face(); !done)
                return fail(std::move(done.error()));
        }
        return false;
    }

private:
    // What the shortest vertex "0 0 0\n" and face "3 0 0 0\n" take; the last newline may be missing.
    static constexpr std::uint64_t MinVertexText = 6;
    static constexpr std::uint64_t MinFaceText = 8;
    static constexpr std::uint64_t MinPointText = 4; ///< a face of one corner, "1 0\n"

    /// [ST][C][N][4][n]OFF; may be missing altogether.
    Result<void> keyword()
    {
        mCursor.skipSpaceAndComments();
        std::int64_t vertexCount = 0;
        if (TextCursor ahead = mCursor; ahead.integer(vertexCount) && ahead.atTokenEnd())
            return {};
        const std::uint64_t line = mCursor.line();
        std::string_view word = mCursor.token();
        for (const std::string_view prefix : {"ST", "C", "N"})
            if (word.starts_with(prefix))
                word.remove_prefix(prefix.size());
        if (word == "4OFF" || word == "nOFF" || word == "4nOFF")
            return failAtLine(line, ErrorCode::UnsupportedFeature,
                              QT_TRANSLATE_NOOP("ErrorText", "vertices with other than 3 coordinates"));
        if (word != "OFF")
            return failAtLine(line, ErrorCode::BadMagic, "OFF");
        mCursor.skipBlanks();
        if (mCursor.rest().starts_with("BINARY"))
            return failAtLine(line, ErrorCode::UnsupportedFeature,
                              QT_TRANSLATE_NOOP("ErrorText", "the binary form of OFF"));
        return {};
    }

    Result<void> count(const char *what, std::uint64_t minText, std::int64_t &value)
    {
        mCursor.skipSpaceAndComments();
        const TextCursor start = mCursor;
        if (!mCursor.integer(value) || !mCursor.atTokenEnd())
            return start.failExpected(what);
        if (value < 0 || value > MaxCount)
            return failAtLine(mCursor.line(), ErrorCode::BadValue, what, std::to_string(value),
                              "0.." + std::to_string(MaxCount));
        const std::uint64_t needed = std::uint64_t(value) * minText;
        if (needed > mCursor.left() + 1)
            return failAtLine(mCursor.line(), ErrorCode::Truncated, std::to_string(needed),
                              std::to_string(mCursor.left()));
        return {};
    }

    Result<void> vertex()
    {
        Vec3f p;
        for (float *const c : {&p.x, &p.y, &p.z}) {
            mCursor.skipSpaceAndComments();
            if (!mCursor.number(*c))
                return mCursor.failExpected(QT_TRANSLATE_NOOP("ErrorText", "a coordinate"));
        }
        if (!isFinite(p))
            return failAtLine(mCursor.line(), ErrorCode::NonFinite, "vertex " + std::to_string(mPositions.size()));
        mPositions.push_back(p);
        mCursor.skipLine();
        return {};
    }

    Result<void> face()
    {
        mCursor.skipSpaceAndComments();
        const TextCursor start = mCursor;
        std::int64_t cornerCount = 0;
        if (!mCursor.integer(cornerCount) || !mCursor.atTokenEnd() || cornerCount < (mFaces ? 1 : 3))
            return start.failExpected(QT_TRANSLATE_NOOP("ErrorText", "a face with at least 3 corners"));
        std::uint32_t first = 0, previous = 0;
        mCorners.clear();
        for (std::int64_t corner = 0; corner < cornerCount; ++corner) {
            mCursor.skipSpaceAndComments();
            std::int64_t index = 0;
            const TextCursor before = mCursor;
            if (!mCursor.integer(index) || !mCursor.atTokenEnd())
                return before.failExpected(QT_TRANSLATE_NOOP("ErrorText", "a vertex number"));
            if (index < 0 || index >= std::int64_t(mConnectivity.vertexCount))
                return failAtLine(mCursor.line(), ErrorCode::IndexOutOfRange, std::to_string(index),
                                  std::to_string(mConnectivity.vertexCount));
            if (mFaces)
                mCorners.push_back(std::uint32_t(index));
            else if (corner == 0)
                first = std::uint32_t(index);
            else if (corner >= 2)
                mConnectivity.triangles.push_back({first, previous, std::uint32_t(index)});
            previous = std::uint32_t(index);
        }
        if (mFaces)
            mFaces->add(mCorners);
        mCursor.skipLine(); // a colour
        return {};
    }

    static constexpr std::int64_t MaxCount = 0xFFFFFFFF;

    TextCursor mCursor;
    ParsedMesh &mParsed;
    std::vector<Vec3f> &mPositions;
    Connectivity &mConnectivity;
    Faces *const mFaces;
    std::vector<std::uint32_t> mCorners; ///< of a face
};

} // namespace

Result<bool> parseOff(std::string_view text, ParsedMesh &mesh, const Progress &progress, const KnownFaces &known,
                      Faces *faces)
{
    mesh.clear();
    return OffParser(text, mesh, faces).parse(progress, known);
}

} // namespace model::io
