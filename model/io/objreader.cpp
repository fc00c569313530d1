// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/objreader.h"

#include "model/io/textpoint.h"

namespace model::io {

namespace {

class ObjParser
{
public:
    ObjParser(std::string_view text, ParsedMesh &mesh, std::vector<Vec3d> *precise, Faces *faces)
        : mCursor(text)
        , mMesh(mesh)
        , mPositions(mesh.mesh.positions)
        , mTriangles(mesh.mesh.connectivity.triangles)
        , mPrecise(precise)
        , mFaces(faces)
    {}

    Result<bool> parse(const Progress &progress, const KnownFaces &known)
    {
        constexpr unsigned LinesBetweenChecks = 1 << 16;
        for (unsigned line = 1; !mCursor.atEnd(); ++line) {
            if (line % LinesBetweenChecks == 0 && progress.isCancelled())
                return fail(ErrorCode::Cancelled);
            mCursor.skipBlanks();
            const char next = mCursor.peekNext();
            const bool isWord = next == ' ' || next == '\t';
            Result<void> done;
            if (isWord && mCursor.peek() == 'v') {
                done = vertex();
            } else if (isWord && mCursor.peek() == 'f') {
                if (mFirstFace && startFaces(known))
                    return true;
                done = face();
            }
            if (!done)
                return fail(std::move(done.error()));
            mCursor.skipLine();
        }
        return finish();
    }

private:
    /// A vertex index beyond the vertices so far, in a line; legal if the vertex still comes.
    struct ForwardReference
    {
        std::int64_t index; // as written, 1-based
        std::uint64_t line;
    };

    Result<void> vertex()
    {
        mCursor.advance();
        Vec3f p;
        Vec3d wide;
        if (!readPoint(
                mCursor, [](TextCursor &c) { c.skipBlanksAndContinuations(); }, p, mPrecise ? &wide : nullptr))
            return mCursor.failExpected(QT_TRANSLATE_NOOP("ErrorText", "a coordinate"));
        if (!isFinite(p))
            return failAtLine(mCursor.line(), ErrorCode::NonFinite, vertexName(mPositions.size()));
        mPositions.push_back(p);
        if (mPrecise)
            mPrecise->push_back(wide);
        mMesh.facesLast = mMesh.facesLast && mFirstFace;
        return {};
    }

    /// \returns true if the faces are the known ones
    bool startFaces(const KnownFaces &known)
    {
        mFirstFace = false;
        mMesh.facesBegin = mCursor.offset();
        mMesh.mesh.connectivity.vertexCount = std::uint32_t(mPositions.size());
        return known.vertexCount == mPositions.size() && known.text == mCursor.rest();
    }

    Result<void> face()
    {
        mCursor.advance();
        std::uint32_t first = 0, previous = 0;
        mCorners.clear();
        for (unsigned corner = 0;; ++corner) {
            mCursor.skipBlanksAndContinuations();
            if (mCursor.atLineEnd() || mCursor.peek() == '#') {
                if (corner < (mFaces ? 1 : 3))
                    return mCursor.failExpected(QT_TRANSLATE_NOOP("ErrorText", "a face with at least 3 corners"));
                if (mFaces)
                    mFaces->add(mCorners);
                return {};
            }
            const Result<std::uint32_t> index = vertexIndex();
            if (!index)
                return fail(index.error());
            if (mFaces)
                mCorners.push_back(*index);
            else if (corner == 0)
                first = *index;
            else if (corner >= 2)
                mTriangles.push_back({first, previous, *index});
            previous = *index;
        }
    }

    /// One corner, "v", "v/vt", "v//vn" or "v/vt/vn".
    Result<std::uint32_t> vertexIndex()
    {
        const TextCursor start = mCursor;
        std::int64_t index = 0;
        if (!mCursor.integer(index))
            return start.failExpected(QT_TRANSLATE_NOOP("ErrorText", "a vertex number"));
        while (!mCursor.atTokenEnd() && mCursor.peek() != '\\') {
            const char c = mCursor.peek();
            if (c != '/' && c != '-' && !detail::isDigit(c))
                return start.failExpected(QT_TRANSLATE_NOOP("ErrorText", "a vertex number"));
            mCursor.advance();
        }
        const auto count = std::int64_t(mPositions.size());
        if (index < -count || index == 0 || index > MaxIndex)
            return outOfRange(index, mCursor.line());
        if (index > count && (mForward.empty() || index > mForward.back().index))
            mForward.push_back({index, mCursor.line()}); // the first one beyond any final count is in this list
        return std::uint32_t(index < 0 ? count + index : index - 1);
    }

    Result<bool> finish()
    {
        const auto count = std::int64_t(mPositions.size());
        if (mFirstFace)
            mMesh.facesBegin = mCursor.offset();
        if (count == 0 && !mFaces)
            return fail(ErrorCode::NoVertices);
        for (const ForwardReference &reference : mForward)
            if (reference.index > count)
                return outOfRange(reference.index, reference.line);
        mMesh.mesh.connectivity.vertexCount = std::uint32_t(count);
        return false;
    }

    tl::unexpected<Error> outOfRange(std::int64_t index, std::uint64_t line) const
    {
        return failAtLine(line, ErrorCode::IndexOutOfRange, std::to_string(index), std::to_string(mPositions.size()));
    }

    static std::string vertexName(std::size_t index) { return "vertex " + std::to_string(index + 1); }

    static constexpr std::int64_t MaxIndex = 0xFFFFFFFF;

    TextCursor mCursor;
    ParsedMesh &mMesh;
    std::vector<Vec3f> &mPositions;
    std::vector<Triangle> &mTriangles;
    std::vector<Vec3d> *const mPrecise;
    Faces *const mFaces;
    std::vector<std::uint32_t> mCorners; ///< of a face
    std::vector<ForwardReference> mForward;
    bool mFirstFace = true;
};

} // namespace

Result<bool> parseObj(std::string_view text, ParsedMesh &mesh, const Progress &progress, const KnownFaces &known,
                      std::vector<Vec3d> *precise, Faces *faces)
{
    mesh.clear();
    return ObjParser(text, mesh, precise, faces).parse(progress, known);
}

} // namespace model::io
