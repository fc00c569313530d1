// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/viewport/meshbuffers.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace views {

namespace {

constexpr GLuint ErrorLocation = 2;

/// A well mixed number for each vertex index. Source: the finalizer of MurmurHash3 (Appleby, public domain).
std::uint32_t mixed(std::uint32_t x)
{
    x = (x ^ (x >> 16)) * 0x85ebca6bu;
    x = (x ^ (x >> 13)) * 0xc2b2ae35u;
    return x ^ (x >> 16);
}

/// All vertices, in an order whose every beginning is spread over the mesh.
std::vector<std::uint32_t> spreadOrder(std::uint32_t count)
{
    std::vector<std::uint32_t> order(count);
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::sort(order, {}, mixed); // a bijection: no ties, the same order everywhere
    return order;
}

} // namespace

MeshBuffers::MeshBuffers(QOpenGLFunctions_3_3_Core &gl)
    : mGl(gl)
{
    mGl.glGenBuffers(BufferCount, mBuffers);
    mGl.glGenVertexArrays(ArrayCount, mArrays);
    mGl.glGenTextures(TextureCount, mTextures);
    mGl.glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &mMaxTexels);

    for (const auto &[array, indices] : {std::pair(TriangleArray, Triangles), std::pair(PointArray, PointOrder)}) {
        mGl.glBindVertexArray(mArrays[array]);
        mGl.glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, mBuffers[indices]);
        for (const auto &[location, buffer] : {std::pair(0u, Positions), std::pair(1u, Normals)}) {
            mGl.glBindBuffer(GL_ARRAY_BUFFER, mBuffers[buffer]);
            mGl.glVertexAttribPointer(location, 3, GL_FLOAT, GL_FALSE, sizeof(model::Vec3f), nullptr);
            mGl.glEnableVertexAttribArray(location);
        }
        mGl.glBindBuffer(GL_ARRAY_BUFFER, mBuffers[Errors]);
        mGl.glVertexAttribPointer(ErrorLocation, 1, GL_FLOAT, GL_FALSE, sizeof(float), nullptr);
    }
    mGl.glBindVertexArray(0);
}

MeshBuffers::~MeshBuffers()
{
    mGl.glDeleteTextures(TextureCount, mTextures);
    mGl.glDeleteVertexArrays(ArrayCount, mArrays);
    mGl.glDeleteBuffers(BufferCount, mBuffers);
}

void MeshBuffers::upload(const FrameData &frame, const model::FrameSourcePtr &source)
{
    if (source != mSource) {
        // Edits of one animation share its connectivity, but comparing the triangles costs more than uploading them.
        mSource = source;
        uploadConnectivity(source->connectivity());
    }
    stream(Positions, frame.positions);
    stream(Normals, frame.normals);
    mHasErrors = !frame.errors.empty();
    if (mHasErrors)
        stream(Errors, frame.errors);
}

void MeshBuffers::uploadConnectivity(const model::Connectivity &connectivity)
{
    mVertexCount = connectivity.vertexCount;
    mTriangleCount = connectivity.triangles.size();
    mFitsTexture = std::max<std::size_t>(mTriangleCount, mVertexCount) * 3 <= std::size_t(mMaxTexels);
    const std::vector<std::uint32_t> order = spreadOrder(mVertexCount);
    mGl.glBindVertexArray(0); // an element buffer bound now would become part of a vertex array
    mGl.glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, mBuffers[Triangles]);
    mGl.glBufferData(GL_ELEMENT_ARRAY_BUFFER, GLsizeiptr(mTriangleCount * sizeof(model::Triangle)),
                     connectivity.triangles.data(), GL_STATIC_DRAW);
    mGl.glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, mBuffers[PointOrder]);
    mGl.glBufferData(GL_ELEMENT_ARRAY_BUFFER, GLsizeiptr(order.size() * sizeof(std::uint32_t)), order.data(),
                     GL_STATIC_DRAW);
}

template <class T>
void MeshBuffers::stream(Buffer buffer, const std::vector<T> &data)
{
    const auto bytes = GLsizeiptr(data.size() * sizeof(T));
    mGl.glBindBuffer(GL_ARRAY_BUFFER, mBuffers[buffer]);
    // Fresh storage first: the driver need not wait until the last frame has been drawn from the old one.
    mGl.glBufferData(GL_ARRAY_BUFFER, bytes, nullptr, GL_STREAM_DRAW);
    mGl.glBufferSubData(GL_ARRAY_BUFFER, 0, bytes, data.data());
}

void MeshBuffers::bind(VertexArray array)
{
    mGl.glBindVertexArray(mArrays[array]);
    if (mHasErrors)
        mGl.glEnableVertexAttribArray(ErrorLocation);
    else // nothing may be read from a buffer that was never filled
        mGl.glDisableVertexAttribArray(ErrorLocation);
}

void MeshBuffers::drawTriangles()
{
    bind(TriangleArray);
    mGl.glDrawElements(GL_TRIANGLES, GLsizei(mTriangleCount * 3), GL_UNSIGNED_INT, nullptr);
    mGl.glBindVertexArray(0);
}

void MeshBuffers::drawCorners()
{
    const struct
    {
        Texture texture;
        GLenum format;
        Buffer buffer;
    } units[] = {{TriangleTexture, GL_R32UI, Triangles},
                 {PositionTexture, GL_R32F, Positions},
                 {NormalTexture, GL_R32F, Normals},
                 {ErrorTexture, GL_R32F, Errors}};
    for (const auto &[texture, format, buffer] : units) {
        if (texture == ErrorTexture && !mHasErrors)
            continue;
        mGl.glActiveTexture(GL_TEXTURE0 + GLenum(texture));
        mGl.glBindTexture(GL_TEXTURE_BUFFER, mTextures[texture]);
        mGl.glTexBuffer(GL_TEXTURE_BUFFER, format, mBuffers[buffer]);
    }
    mGl.glBindVertexArray(mArrays[EmptyArray]);
    mGl.glDrawArrays(GL_TRIANGLES, 0, GLsizei(mTriangleCount * 3));
    mGl.glBindVertexArray(0);
    for (int unit = TextureCount - 1; unit >= 0; --unit) { // leaves unit 0 active, as others expect
        mGl.glActiveTexture(GL_TEXTURE0 + GLenum(unit));
        mGl.glBindTexture(GL_TEXTURE_BUFFER, 0);
    }
}

void MeshBuffers::drawPoints(double density)
{
    const double count = std::ceil(std::clamp(density, 0.0, 1.0) * mVertexCount);
    bind(PointArray);
    mGl.glDrawElements(GL_POINTS, GLsizei(count), GL_UNSIGNED_INT, nullptr);
    mGl.glBindVertexArray(0);
}

} // namespace views
