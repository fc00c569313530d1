// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/terrain/picture/dirtyslots.h"
#include "views/terrain/picture/groundvertices.h"

#include <QOpenGLFunctions_3_3_Core>

#include <functional>
#include <limits>

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

    /// Sends what was noted, what is new always, of what only moved up or down no more than fits into `milliseconds`:
    /// then hasMoved() remains. Of a whole terrain no more than that either: then hasMore() remains, and triangles are
    /// there once all their vertices are. \returns whether anything was sent
    bool upload(double milliseconds);
    /// How far detail travels before other detail takes its place, metres.
    static float slideReach(const GroundFrame &frame);
    bool hasMore() const { return mIsWhole; }
    bool hasMoved() const { return mRaised.count() > 0; }
    const UploadCount &uploadCount() const { return mCount; }

    /// The box around everything uploaded, in the scene.
    const model::Box3f &box() const { return mBox; }
    /// What the last upload() changed, as high and deep as the ground has ever been near there: what it was before is
    /// in it. Empty: nothing.
    const model::Box3f &changedBox() const { return mChangedBox; }

    static constexpr std::uint32_t ChunkSize = 4096; ///< slots of triangles
    std::uint32_t chunkCount() const { return (mDrawable + ChunkSize - 1) / ChunkSize; }
    struct DrawnChunks
    {
        std::uint32_t next = 0; ///< where to go on; chunkCount() at the end
        std::uint32_t count = 0;
    };
    /// Draws the triangles of those chunks from `first` on whose box `isVisible`, but of no more than `most`.
    /// Attributes: 0 place (x, z), 1 height, 2 normal x and z, 3 colour and humidity, 4 the number, 5 the slide.
    DrawnChunks draw(const std::function<bool(const model::Box3f &)> &isVisible, std::uint32_t first = 0,
                     std::uint32_t most = std::numeric_limits<std::uint32_t>::max());
    /// Lines or triangles drawn besides, by the numbers of their vertices.
    enum class Extra : std::uint8_t { Lines, Triangles };
    void setExtra(Extra extra, const std::vector<std::uint32_t> &indices);
    std::uint32_t extraCount(Extra extra) const;
    /// Draws some of them from the `first` on. \returns the one after
    std::uint32_t drawExtra(Extra extra, std::uint32_t first, std::uint32_t most);

    /// The smallest and the largest number of a vertex that was sent since setScalar().
    float lowestScalar() const { return mLowestScalar; }
    float highestScalar() const { return mHighestScalar; }

private:
    enum Buffer { Places, Heights, Paints, Scalars, Slides, Triangles, ExtraLines, ExtraTriangles, BufferCount };
    enum VertexArray { TriangleArray, ExtraLineArray, ExtraTriangleArray, ArrayCount };

    const model::terrain::TinArrays &tin() const { return mTerrain.tin.arrays(); }
    std::uint32_t vertexSlots() const { return tin().vertexSlots(); }
    std::uint32_t triangleSlots() const { return tin().triangleSlots(); }
    void makeRoom();
    bool grow(Buffer buffer, std::size_t wanted, std::size_t slotBytes);
    void describeArrays();
    /// Sends `make(slot)` for each slot of a range.
    template <class Value, class Make>
    void send(Buffer buffer, model::terrain::SlotRange range, Make make);
    void sendAll(model::terrain::SlotRange vertices);
    void sendPaint(const std::vector<model::terrain::SlotRange> &ranges);
    void sendScalars(model::terrain::SlotRange range);
    void sendTriangles(model::terrain::SlotRange range);
    void sendNew(std::uint32_t vertices, std::uint32_t triangles);
    void sendMoved(std::uint32_t vertices, std::uint32_t most);
    void sendHeights(std::uint32_t vertices);
    void startSlides();
    void addSlide(model::terrain::VertexId v, const GroundHeight &height);
    void noteRing(model::terrain::VertexId v);
    void addToBoxes(model::terrain::VertexId v);
    void noteHeights(const model::Box3f &chunk);

    QOpenGLFunctions_3_3_Core &mGl;
    const model::terrain::Terrain &mTerrain;
    GroundVertexMaker mMaker;
    const float mReach; ///< metres that detail travels with the sand
    std::function<float(model::terrain::VertexId)> mScalar;
    GLuint mBuffers[BufferCount] = {};
    GLuint mArrays[ArrayCount] = {};
    std::size_t mCapacities[BufferCount] = {}; ///< slots
    bool mIsWhole = true;                      ///< a whole terrain is being sent, and has come to these
    std::uint32_t mNextVertex = 0, mNextTriangle = 0;
    std::uint32_t mDrawable = 0; ///< triangle slots that are complete
    GLsizei mExtraCounts[2] = {};
    DirtySlots mPlaced;  ///< vertices with another place
    DirtySlots mRaised;  ///< vertices with another height
    DirtySlots mTurned;  ///< vertices whose height or normal is to be sent
    DirtySlots mPainted; ///< vertices with other layers
    DirtySlots mTriangles;
    std::vector<model::Box3f> mBoxes; ///< of each chunk; they only grow
    model::Box3f mBox, mChangedBox;
    float mChangedLow = 0, mChangedHigh = 0; ///< of the chunks that the last upload() touched
    std::vector<GroundPaint> mPaint;         ///< of each slot, as it was sent: it seldom changes
    std::vector<float> mSentHeights;         ///< of each slot
    std::vector<GroundSlide> mSlides;        ///< of each slot, as it was sent
    std::vector<bool> mIsSliding;            ///< slots whose height was changed by sand that slides
    DirtySlots mSlid;                        ///< vertices with another slide
    std::vector<std::uint8_t> mStaging;
    float mLowestScalar = 0, mHighestScalar = 0;
    UploadCount mCount;
};

} // namespace views
