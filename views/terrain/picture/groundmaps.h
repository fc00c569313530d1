// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/terrain/picture/terrainbuffers.h"
#include "views/viewport/glpicture.h"

namespace views {

/// Textures over a terrain's domain: its heights and colours, and what of sun and sky each place sees. Worked out by
/// the GPU, and only where something changed and as far as its shadow reaches. Made, used and destroyed with the same
/// context current.
class GroundMaps final
{
public:
    GroundMaps(QOpenGLFunctions_3_3_Core &gl, const GroundFrame &frame, QString &error);
    ~GroundMaps();
    GroundMaps(const GroundMaps &) = delete;
    GroundMaps &operator=(const GroundMaps &) = delete;

    /// Notes where vertices changed, in the scene.
    void note(const model::Box3f &changed);
    // These leave another framebuffer bound.
    /// Brings heights and colours up to date. \param side  texels; another one starts anew
    void updateHeights(TerrainBuffers &buffers, int side);
    /// Brings the light up to date. Precondition: so are the heights.
    void updateLight(const model::Box3f &all, model::Vec3f sun);
    /// Where the ground changed since the light was up to date.
    const model::Box3f &lightChanges() const { return mLightChanges; }
    int side() const { return mSide; }
    /// Where light may change if the ground does within a box: in its shadow, and a little around.
    static model::Box3f litBox(const model::Box3f &changed, const model::Box3f &all, model::Vec3f sun);
    /// The visible sun (red) and sky (green), 0 ... 1; place.xz / half / 2 + 1 / 2.
    GLuint light() const { return mTextures[Light]; }
    /// Metres in the scene; far below everything where there is no ground.
    GLuint heights() const { return mTextures[Heights]; }
    /// As GroundPaint.
    GLuint paint() const { return mTextures[Paint]; }

private:
    enum Texture { Heights, Paint, Light, TextureCount };
    enum Framebuffer { HeightTarget, LightTarget, FramebufferCount };
    struct Region
    {
        GLint x = 0, y = 0, width = 0, height = 0;
    };

    void allocate(int side);
    Region regionOf(const model::Box3f &box) const;
    void drawInto(Framebuffer target, const Region &region);

    QOpenGLFunctions_3_3_Core &mGl;
    const GroundFrame &mFrame;
    ShaderProgram mHeightProgram, mLightProgram;
    GLuint mTextures[TextureCount] = {};
    GLuint mFramebuffers[FramebufferCount] = {};
    GLuint mEmptyArray = 0;
    int mSide = 0;
    bool mIsNew = true;      ///< nothing is drawn yet
    bool mIsLightNew = true; ///< nor lit
    model::Box3f mHeightChanges, mLightChanges;
    model::Vec3f mSun{};
};

} // namespace views
