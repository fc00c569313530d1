// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/terrain/picture/staletiles.h"
#include "views/terrain/picture/terrainrenderer.h"

#include <QImage>
#include <QOpenGLFramebufferObject>

#include <limits>
#include <memory>
#include <optional>

namespace views {

/// How much of a picture is drawn at once.
struct StepLimits
{
    QSize tile{1 << 16, 1 << 16};                                     ///< pixels
    std::uint32_t chunks = std::numeric_limits<std::uint32_t>::max(); ///< of TerrainBuffers::ChunkSize triangles
    double milliseconds = std::numeric_limits<double>::infinity();    ///< of one turn of the event loop
    int coarsePixels = 0;   ///< of a picture of something that moves; 0: no such pictures, exact ones are quick enough
    int mapPieces = 1;      ///< see GroundMaps
    bool isWaiting = false; ///< each step is waited for, so that a turn knows when it is enough

    /// For processors that draw: a step takes some milliseconds.
    static StepLimits software() { return {{256, 144}, 6, 8, 240'000, 8, true}; }
};

/// A picture of a terrain that is kept, and brought up to date step by step. While it is not, the last one is shown:
/// the exact one where only the ground has changed, a coarse one after the camera has moved. Made, used and destroyed
/// with the same context current.
class GradualPicture final
{
public:
    GradualPicture(QOpenGLFunctions_3_3_Core &gl, TerrainRenderer &renderer, const StepLimits &limits, int samples);
    ~GradualPicture();
    GradualPicture(const GradualPicture &) = delete;
    GradualPicture &operator=(const GradualPicture &) = delete;

    /// What is wanted. Another camera, size or style: everything is drawn anew.
    void setPicture(const TerrainPicture &picture);
    /// The renderer's changes are looked at: what shows them is drawn anew.
    void noteChanges();
    /// Draws a coarse picture, which is shown until the exact one is done. \returns false if it cannot be drawn yet, or
    /// if the exact picture shows this camera and style
    bool drawCoarsely();

    bool isDone() const { return !mPart && mStale.isEmpty() && !mRenderer.hasMapWork(mPicture); }
    /// Steps (those of the maps only, which coarse pictures need) until the turn's time is over or nothing is left.
    /// \returns whether what is shown has changed
    enum class Kind { All, Maps };
    bool work(Kind kind = Kind::All);
    /// One step; the same. Precondition: !isDone().
    bool step();
    /// Everything is to be drawn anew.
    void noteAll() { mStale.addAll(); }

    /// Copies what is there into a framebuffer of the picture's size; clears it if there is nothing yet.
    void show(GLuint framebuffer);
    /// There is something to show.
    bool hasPicture() const { return mShown != Shown::Nothing; }
    /// Precondition: isDone(), after setPicture().
    QImage toImage() const;

    /// The coarse picture is what is shown, and it is older than the ground.
    bool wantsCoarse() const { return mShown == Shown::Coarse && mIsCoarseStale; }
    /// Steps since the start, and the most that one of them drew.
    struct Work
    {
        std::uint64_t steps = 0, mapSteps = 0;
        int mostPixels = 0;
        std::uint32_t mostChunks = 0;
    };
    const Work &workDone() const { return mWork; }

private:
    enum class Shown { Nothing, Coarse, Exact };
    using Framebuffer = std::unique_ptr<QOpenGLFramebufferObject>;

    void blit(const QOpenGLFramebufferObject &from, GLuint to, const QRect &source, const QRect &target);
    void stepMaps();
    void count(int pixels, std::uint32_t chunks);

    QOpenGLFunctions_3_3_Core &mGl;
    TerrainRenderer &mRenderer;
    const StepLimits mLimits;
    const int mSamples;
    TerrainPicture mPicture;
    Framebuffer mExact;  ///< shown
    Framebuffer mDrawn;  ///< drawn into; a part of it goes to mExact once it is whole
    Framebuffer mCoarse; ///< shown, smaller
    Shown mShown = Shown::Nothing;
    bool mIsExactOld = true; ///< mExact shows another camera, size or style
    bool mIsCoarseStale = true;
    StaleTiles mStale;
    std::optional<QRect> mPart; ///< being drawn
    PartProgress mProgress;
    Work mWork;
};

} // namespace views
