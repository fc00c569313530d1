// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/scene/framedata.h"

#include <QOpenGLFunctions_3_3_Core>

namespace views {

/// A mesh in the memory of the GPU: triangles once, positions and normals for each frame. Made, used and destroyed
/// with the same context current.
class MeshBuffers final
{
public:
    explicit MeshBuffers(QOpenGLFunctions_3_3_Core &gl);
    ~MeshBuffers();

    MeshBuffers(const MeshBuffers &) = delete;
    MeshBuffers &operator=(const MeshBuffers &) = delete;

    /// Uploads the positions and normals, the errors if there are any, and for another source than the last time the
    /// triangles. \param source  whose frame it is; as many vertices as `frame`
    void upload(const FrameData &frame, const model::FrameSourcePtr &source);

    /// Of the frame uploaded last.
    bool hasErrors() const { return mHasErrors; }

    void drawTriangles();
    /// One call of the vertex shader for each corner, without attributes; the arrays are buffer textures in units
    /// 0 (triangles), 1 (positions), 2 (normals), 3 (errors). Precondition: canDrawCorners().
    void drawCorners();
    /// False for a mesh larger than a buffer texture may be.
    bool canDrawCorners() const { return mFitsTexture; }
    /// A share of the vertices, spread over the mesh; a larger share holds the smaller.
    void drawPoints(double density);

private:
    enum Buffer { Positions, Normals, Errors, Triangles, PointOrder, BufferCount };
    enum VertexArray { TriangleArray, PointArray, EmptyArray, ArrayCount };
    enum Texture { TriangleTexture, PositionTexture, NormalTexture, ErrorTexture, TextureCount };

    void uploadConnectivity(const model::Connectivity &connectivity);
    template <class T>
    void stream(Buffer buffer, const std::vector<T> &data);
    void bind(VertexArray array);

    QOpenGLFunctions_3_3_Core &mGl;
    GLuint mBuffers[BufferCount] = {};
    GLuint mArrays[ArrayCount] = {};
    GLuint mTextures[TextureCount] = {};
    GLint mMaxTexels = 0;
    bool mFitsTexture = false;
    bool mHasErrors = false;
    std::uint32_t mVertexCount = 0;
    std::size_t mTriangleCount = 0;
    model::FrameSourcePtr mSource;
};

} // namespace views
