// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/terrain/terrainbuffers.h"
#include "views/viewport/glpicture.h"

namespace views {

/// What of sun and sky each place of a terrain sees, as a texture over its domain. Worked out by the GPU from the
/// heights, and only where something changed and as far as its shadow reaches. Made, used and destroyed with the same
/// context current.
class GroundMaps final
{
public:
    GroundMaps(QOpenGLFunctions_3_3_Core &gl, const GroundFrame &frame, QString &error);
    ~GroundMaps();
    GroundMaps(const GroundMaps &) = delete;
    GroundMaps &operator=(const GroundMaps &) = delete;

    /// Brings the maps up to date; leaves another framebuffer bound. \param side  texels; another one starts anew
    /// \param changed  where vertices moved, in the scene; empty: nowhere
    void update(TerrainBuffers &buffers, int side, model::Vec3f sun, const model::Box3f &changed);
    /// Where light may change if the ground does within a box: in its shadow, and a little around.
    static model::Box3f litBox(const model::Box3f &changed, const model::Box3f &all, model::Vec3f sun);
    /// The visible sun (red) and sky (green), 0 ... 1; place.xz / half / 2 + 1 / 2.
    GLuint light() const { return mTextures[Light]; }

private:
    enum Texture { Heights, Light, TextureCount };
    struct Region
    {
        GLint x = 0, y = 0, width = 0, height = 0;
    };

    void allocate(int side);
    Region regionOf(const model::Box3f &box) const;
    void drawInto(Texture texture, const Region &region);

    QOpenGLFunctions_3_3_Core &mGl;
    const GroundFrame &mFrame;
    ShaderProgram mHeightProgram, mLightProgram;
    GLuint mTextures[TextureCount] = {};
    GLuint mFramebuffers[TextureCount] = {};
    GLuint mEmptyArray = 0;
    int mSide = 0;
    model::Vec3f mSun{};
};

} // namespace views
