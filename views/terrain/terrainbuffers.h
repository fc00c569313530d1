// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/terrain/dirtyslots.h"
#include "views/terrain/groundvertices.h"

#include <QOpenGLFunctions_3_3_Core>

#include <functional>

namespace views {

/// Bytes sent to the GPU.
struct UploadCount
{
    std::uint64_t total = 0; ///< since the start
    std::uint64_t last = 0;  ///< by the last upload() that had something to send
};

/// A terrain in the memory of the GPU, slot for slot as the TIN has it; triangles that are free or void are
/// degenerate. After the first upload only slots that an edit wrote are sent (and the normals around them). Made, used
/// and destroyed with the same context current.
class TerrainBuffers final
{
public:
    TerrainBuffers(QOpenGLFunctions_3_3_Core &gl, const model::terrain::Terrain &terrain, const GroundFrame &frame);
    ~TerrainBuffers();
    TerrainBuffers(const TerrainBuffers &) = delete;
    TerrainBuffers &operator=(const TerrainBuffers &) = delete;

    /// Notes what an edit wrote. Needs no context.
    void note(const model::terrain::Edit &edit);
    /// Notes that every vertex looks different: materials, a number for each (setScalar).
    void noteAll();
    /// Another number for each vertex goes with it, computed when it is uploaded; null: none. All are sent again.
    void setScalar(std::function<float(model::terrain::VertexId)> scalar);

    /// Sends what was noted. Of a whole terrain, no more than fits into `milliseconds`: then hasMore() remains, and
    /// triangles are there once all their vertices are. \returns whether anything was sent
    bool upload(double milliseconds);
    bool hasMore() const { return mIsWhole; }
    const UploadCount &uploadCount() const { return mCount; }

    /// The box around everything uploaded, in the scene.
    const model::Box3f &box() const { return mBox; }
    /// What the last upload() changed; empty: nothing.
    const model::Box3f &changedBox() const { return mChangedBox; }

    /// Draws the triangles of those chunks (ChunkSize slots each) whose box `isVisible`.
    /// Attributes: 0 position, 1 normal x and z, 2 colour and humidity, 3 the number.
    void draw(const std::function<bool(const model::Box3f &)> &isVisible);
    /// Draws some triangles, or lines, by the numbers of their vertices; see setIndices().
    void drawIndices(GLenum mode);
    void setIndices(const std::vector<std::uint32_t> &indices);

    static constexpr std::uint32_t ChunkSize = 4096;

private:
    enum Buffer { Vertices, Scalars, Triangles, Others, BufferCount };
    enum VertexArray { TriangleArray, OtherArray, ArrayCount };

    const model::terrain::TinArrays &tin() const { return mTerrain.tin.arrays(); }
    std::uint32_t vertexSlots() const { return tin().vertexSlots(); }
    std::uint32_t triangleSlots() const { return tin().triangleSlots(); }
    void makeRoom();
    bool grow(Buffer buffer, std::size_t used, std::size_t wanted, std::size_t slotBytes, std::size_t &capacity);
    void describeArrays();
    void sendVertices(model::terrain::SlotRange range);
    void sendTriangles(model::terrain::SlotRange range);
    void send(Buffer buffer, std::size_t offset, const void *data, std::size_t bytes);
    void noteRing(model::terrain::VertexId v);
    void addToBoxes(model::terrain::VertexId v, model::Vec3f position);

    QOpenGLFunctions_3_3_Core &mGl;
    const model::terrain::Terrain &mTerrain;
    const GroundFrame &mFrame;
    GroundVertexMaker mMaker;
    std::function<float(model::terrain::VertexId)> mScalar;
    GLuint mBuffers[BufferCount] = {};
    GLuint mArrays[ArrayCount] = {};
    std::size_t mVertexCapacity = 0, mScalarCapacity = 0, mTriangleCapacity = 0; ///< slots
    bool mIsWhole = true; ///< a whole terrain is being sent, and has come to these
    std::uint32_t mNextVertex = 0, mNextTriangle = 0;
    std::uint32_t mDrawable = 0; ///< triangle slots that are complete
    GLsizei mIndexCount = 0;
    DirtySlots mMoved;     ///< vertices: they, and the normals around them
    DirtySlots mRepainted; ///< vertices: only they
    DirtySlots mTriangles;
    std::vector<model::Box3f> mBoxes; ///< of each chunk; they only grow
    model::Box3f mBox, mChangedBox;
    std::vector<GroundVertex> mStaging;
    std::vector<float> mScalarStaging;
    std::vector<std::uint32_t> mIndexStaging;
    UploadCount mCount;
};

} // namespace views
