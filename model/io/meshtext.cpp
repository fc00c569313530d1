// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/meshtext.h"

#include <algorithm>
#include <charconv>

namespace model::io {

namespace {

/// Appends to a string through a buffer that always has room for one number, which std::to_chars likes best.
class TextWriter
{
public:
    explicit TextWriter(std::string &out)
        : mOut(out)
    {}
    ~TextWriter() { flush(); }
    TextWriter(const TextWriter &) = delete;
    TextWriter &operator=(const TextWriter &) = delete;

    void put(char c) { *mEnd++ = c; }
    template <class Number>
    void number(Number value)
    {
        mEnd = std::to_chars(mEnd, mEnd + MaxNumber, value).ptr;
    }
    void endLine()
    {
        put('\n');
        makeRoom();
    }
    /// To be called in lines of any number of numbers.
    void makeRoom()
    {
        if (mEnd > mBuffer + sizeof mBuffer - MaxLine)
            flush();
    }
    void flush()
    {
        mOut.append(mBuffer, mEnd);
        mEnd = mBuffer;
    }

private:
    static constexpr std::size_t MaxNumber = 40; // a float takes at most 15, a uint64 20
    static constexpr std::size_t MaxLine = 5 * MaxNumber;

    std::string &mOut;
    char mBuffer[1 << 14];
    char *mEnd = mBuffer;
};

// Faces of either kind, alike for the formats.

std::size_t faceCountOf(const Connectivity &connectivity)
{
    return connectivity.triangles.size();
}
std::span<const std::uint32_t> faceOf(const Connectivity &connectivity, std::size_t face)
{
    return connectivity.triangles[face];
}
std::size_t faceCountOf(const Faces &faces)
{
    return faces.faceCount();
}
std::span<const std::uint32_t> faceOf(const Faces &faces, std::size_t face)
{
    return faces.face(std::uint32_t(face));
}

template <class FaceList>
void formatObj(std::span<const Vec3f> positions, const FaceList &faces, std::string &out)
{
    TextWriter text(out);
    for (const Vec3f &p : positions) {
        text.put('v');
        for (const float c : {p.x, p.y, p.z}) {
            text.put(' ');
            text.number(c);
        }
        text.endLine();
    }
    for (std::size_t face = 0; face < faceCountOf(faces); ++face) {
        text.put('f');
        for (const std::uint32_t index : faceOf(faces, face)) {
            text.makeRoom();
            text.put(' ');
            text.number(std::uint64_t(index) + 1);
        }
        text.endLine();
    }
}

template <class FaceList>
void formatOff(std::span<const Vec3f> positions, const FaceList &faces, std::string &out)
{
    out = "OFF\n" + std::to_string(positions.size()) + ' ' + std::to_string(faceCountOf(faces)) + " 0\n";
    TextWriter text(out);
    for (const Vec3f &p : positions) {
        text.number(p.x);
        text.put(' ');
        text.number(p.y);
        text.put(' ');
        text.number(p.z);
        text.endLine();
    }
    for (std::size_t face = 0; face < faceCountOf(faces); ++face) {
        const std::span<const std::uint32_t> corners = faceOf(faces, face);
        text.number(corners.size());
        for (const std::uint32_t index : corners) {
            text.makeRoom();
            text.put(' ');
            text.number(index);
        }
        text.endLine();
    }
}

char *putU32(char *p, std::uint32_t value)
{
    for (int shift = 0; shift < 32; shift += 8)
        *p++ = char(value >> shift);
    return p;
}

template <class FaceList>
void formatPly(std::span<const Vec3f> positions, const FaceList &faces, std::string &out)
{
    constexpr std::size_t VertexBytes = 12, MostOfByte = 255;
    std::size_t corners = 0, longest = 0;
    for (std::size_t face = 0; face < faceCountOf(faces); ++face) {
        corners += faceOf(faces, face).size();
        longest = std::max(longest, faceOf(faces, face).size());
    }
    const bool isByte = longest <= MostOfByte;
    out = "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(positions.size()) +
          "\nproperty float x\nproperty float y\nproperty float z\nelement face " + std::to_string(faceCountOf(faces)) +
          "\nproperty list " + (isByte ? "uchar" : "uint") + " uint vertex_indices\nend_header\n";
    const std::size_t header = out.size();
    out.resize(header + positions.size() * VertexBytes + faceCountOf(faces) * (isByte ? 1 : 4) + corners * 4);
    char *p = out.data() + header;
    for (const Vec3f &position : positions)
        for (const float c : {position.x, position.y, position.z})
            p = putU32(p, std::bit_cast<std::uint32_t>(c));
    for (std::size_t face = 0; face < faceCountOf(faces); ++face) {
        const std::span<const std::uint32_t> indices = faceOf(faces, face);
        if (isByte)
            *p++ = char(indices.size());
        else
            p = putU32(p, std::uint32_t(indices.size()));
        for (const std::uint32_t index : indices)
            p = putU32(p, index);
    }
}

template <class FaceList>
void format(std::span<const Vec3f> positions, const FaceList &faces, MeshFormat meshFormat, std::string &out)
{
    out.clear();
    switch (meshFormat) {
    case MeshFormat::Obj:
        return formatObj(positions, faces, out);
    case MeshFormat::Off:
        return formatOff(positions, faces, out);
    case MeshFormat::Ply:
        return formatPly(positions, faces, out);
    }
}

} // namespace

void formatMesh(std::span<const Vec3f> positions, const Connectivity &connectivity, MeshFormat meshFormat,
                std::string &out)
{
    format(positions, connectivity, meshFormat, out);
}

void formatMesh(std::span<const Vec3f> positions, const Faces &faces, MeshFormat meshFormat, std::string &out)
{
    format(positions, faces, meshFormat, out);
}

const char *endingOf(MeshFormat format)
{
    switch (format) {
    case MeshFormat::Obj:
        return "obj";
    case MeshFormat::Off:
        return "off";
    case MeshFormat::Ply:
        return "ply";
    }
    return "";
}

} // namespace model::io
