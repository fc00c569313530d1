// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/meshtext.h"

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

void formatObj(std::span<const Vec3f> positions, const Connectivity &connectivity, std::string &out)
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
    for (const Triangle &triangle : connectivity.triangles) {
        text.put('f');
        for (const std::uint32_t index : triangle) {
            text.put(' ');
            text.number(std::uint64_t(index) + 1);
        }
        text.endLine();
    }
}

void formatOff(std::span<const Vec3f> positions, const Connectivity &connectivity, std::string &out)
{
    out = "OFF\n" + std::to_string(positions.size()) + ' ' + std::to_string(connectivity.triangles.size()) + " 0\n";
    TextWriter text(out);
    for (const Vec3f &p : positions) {
        text.number(p.x);
        text.put(' ');
        text.number(p.y);
        text.put(' ');
        text.number(p.z);
        text.endLine();
    }
    for (const Triangle &triangle : connectivity.triangles) {
        text.put('3');
        for (const std::uint32_t index : triangle) {
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

void formatPly(std::span<const Vec3f> positions, const Connectivity &connectivity, std::string &out)
{
    constexpr std::size_t VertexBytes = 12, FaceBytes = 13;
    out = "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(positions.size()) +
          "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
          std::to_string(connectivity.triangles.size()) + "\nproperty list uchar uint vertex_indices\nend_header\n";
    const std::size_t header = out.size();
    out.resize(header + positions.size() * VertexBytes + connectivity.triangles.size() * FaceBytes);
    char *p = out.data() + header;
    for (const Vec3f &position : positions)
        for (const float c : {position.x, position.y, position.z})
            p = putU32(p, std::bit_cast<std::uint32_t>(c));
    for (const Triangle &triangle : connectivity.triangles) {
        *p++ = 3;
        for (const std::uint32_t index : triangle)
            p = putU32(p, index);
    }
}

} // namespace

void formatMesh(std::span<const Vec3f> positions, const Connectivity &connectivity, MeshFormat format, std::string &out)
{
    out.clear();
    switch (format) {
    case MeshFormat::Obj:
        return formatObj(positions, connectivity, out);
    case MeshFormat::Off:
        return formatOff(positions, connectivity, out);
    case MeshFormat::Ply:
        return formatPly(positions, connectivity, out);
    }
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
