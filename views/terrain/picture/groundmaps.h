// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/terrain/picture/staletiles.h"
#include "views/terrain/picture/terrainbuffers.h"
#include "views/viewport/glpicture.h"

namespace views {

/// Textures over a terrain's domain: its heights and colours, and what of sun and sky each place sees. Worked out by
/// the GPU, and only where something changed and as far as its shadow reaches; in pieces, so that nobody waits long
/// where the processor draws. Made, used and destroyed with the same context current.
class GroundMaps final
{
public:
    /// \param pieces  along a side: a map is brought up to date in that many steps squared, at most
    GroundMaps(QOpenGLFunctions_3_3_Core &gl, const GroundFrame &frame, int pieces, QString &error);
    ~GroundMaps();
    GroundMaps(const GroundMaps &) = delete;
    GroundMaps &operator=(const GroundMaps &) = delete;

    /// Of another terrain from now on, whose frame is there already.
    void restart();
    /// Notes where vertices changed, in the scene.
    void note(const model::Box3f &changed);
    /// \param side  texels of the maps; another one starts anew
    void setSide(int side);
    int side() const { return mSide; }

    bool areHeightsStale() const { return !mHeightTiles.isEmpty(); }
    /// All heights were drawn once: nothing is missing, though something may be stale.
    bool hasHeights() const { return mHasHeights; }
    /// One step; leaves another framebuffer bound. Precondition: areHeightsStale().
    void stepHeights(TerrainBuffers &buffers);

    /// Where the ground changed since aimLight().
    const model::Box3f &lightChanges() const { return mLightChanges; }
    /// Light is to be as the ground and the sun now are. \returns where it may differ from what it is; empty: nowhere
    model::Box3f aimLight(const model::Box3f &all, model::Vec3f sun);
    bool isAimedAt(model::Vec3f sun) const { return sun == mSun && mLightChanges.isEmpty(); }
    bool isLightStale() const { return !mLightTiles.isEmpty(); }
    /// All of it was lit once.
    bool hasLight() const { return mHasLight; }
    /// One step; leaves another framebuffer bound. Preconditions: isLightStale(), !areHeightsStale().
    void stepLight();

    /// The visible sun (red) and sky (green), 0 ... 1; place.xz / half / 2 + 1 / 2.
    GLuint light() const { return mTextures[Light]; }
    /// Metres in the scene; far below everything where there is no ground.
    GLuint heights() const { return mTextures[Heights]; }
    /// As GroundPaint.
    GLuint paint() const { return mTextures[Paint]; }
    /// The number that goes with each place, see TerrainBuffers::setScalar().
    GLuint numbers() const { return mTextures[Numbers]; }

private:
    enum Texture { Heights, Paint, Numbers, Light, TextureCount };
    enum Framebuffer { HeightTarget, LightTarget, FramebufferCount };

    QRect regionOf(const model::Box3f &box) const;
    void drawInto(Framebuffer target, const QRect &region);

    QOpenGLFunctions_3_3_Core &mGl;
    const GroundFrame &mFrame;
    const int mPieces;
    ShaderProgram mHeightProgram, mLightProgram;
    GLuint mTextures[TextureCount] = {};
    GLuint mFramebuffers[FramebufferCount] = {};
    GLuint mEmptyArray = 0;
    int mSide = 0;
    StaleTiles mHeightTiles, mLightTiles;
    bool mHasHeights = false, mHasLight = false;
    model::Box3f mLightChanges;
    model::Vec3f mSun{};
    float mReach = 0; ///< metres: the longest shadow
};

} // namespace views
