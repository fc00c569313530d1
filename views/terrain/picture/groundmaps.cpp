// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/terrain/picture/groundmaps.h"

#include <QVector3D>

#include <algorithm>
#include <cmath>
#include <utility>

namespace views {

namespace {

/// How far hills take away sky, as a share of the terrain's longer side.
constexpr float SkyReach = 0.12f;
/// Below every terrain: what lies outside it throws no shadow.
constexpr float NoGround = -1e9f;

} // namespace

GroundMaps::GroundMaps(QOpenGLFunctions_3_3_Core &gl, const GroundFrame &frame, QString &error)
    : mGl(gl)
    , mFrame(frame)
    , mHeightProgram(makeProgram({"terrain/heights.vert", "terrain/heights.frag", {}}, {}, error))
    , mLightProgram(makeProgram({"fullscreen.vert", "terrain/light.frag", {}}, {}, error))
{
    mGl.glGenTextures(TextureCount, mTextures);
    mGl.glGenFramebuffers(FramebufferCount, mFramebuffers);
    mGl.glGenVertexArrays(1, &mEmptyArray);
}

GroundMaps::~GroundMaps()
{
    mGl.glDeleteVertexArrays(1, &mEmptyArray);
    mGl.glDeleteFramebuffers(FramebufferCount, mFramebuffers);
    mGl.glDeleteTextures(TextureCount, mTextures);
}

void GroundMaps::allocate(int side)
{
    mSide = side;
    mIsNew = mIsLightNew = true;
    const struct
    {
        Texture texture;
        Framebuffer target;
        GLenum attachment;
        GLint kept;
        GLenum format, type;
    } maps[] = {{Heights, HeightTarget, GL_COLOR_ATTACHMENT0, GL_R32F, GL_RED, GL_FLOAT},
                {Paint, HeightTarget, GL_COLOR_ATTACHMENT1, GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE},
                {Light, LightTarget, GL_COLOR_ATTACHMENT0, GL_RG8, GL_RG, GL_UNSIGNED_BYTE}};
    for (const auto &[texture, target, attachment, kept, format, type] : maps) {
        mGl.glBindTexture(GL_TEXTURE_2D, mTextures[texture]);
        mGl.glTexImage2D(GL_TEXTURE_2D, 0, kept, side, side, 0, format, type, nullptr);
        for (const auto &[name, value] :
             {std::pair(GL_TEXTURE_MIN_FILTER, GL_LINEAR), std::pair(GL_TEXTURE_MAG_FILTER, GL_LINEAR),
              std::pair(GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE), std::pair(GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE)})
            mGl.glTexParameteri(GL_TEXTURE_2D, GLenum(name), value);
        mGl.glBindFramebuffer(GL_FRAMEBUFFER, mFramebuffers[target]);
        mGl.glFramebufferTexture2D(GL_FRAMEBUFFER, attachment, GL_TEXTURE_2D, mTextures[texture], 0);
    }
    mGl.glBindFramebuffer(GL_FRAMEBUFFER, mFramebuffers[HeightTarget]);
    const GLenum both[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
    mGl.glDrawBuffers(2, both);
    mGl.glBindTexture(GL_TEXTURE_2D, 0);
}

GroundMaps::Region GroundMaps::regionOf(const model::Box3f &box) const
{
    const auto texel = [this](float place, float half, float round) {
        return GLint(std::floor(std::clamp(place / half / 2 + 0.5f, 0.0f, 1.0f) * float(mSide) + round));
    };
    const GLint left = texel(box.min.x, mFrame.halfX(), -1.0f);
    const GLint low = texel(box.min.z, mFrame.halfY(), -1.0f);
    const GLint right = texel(box.max.x, mFrame.halfX(), 2.0f);
    const GLint high = texel(box.max.z, mFrame.halfY(), 2.0f);
    Region region{std::max(left, 0), std::max(low, 0), 0, 0};
    region.width = std::min(right, mSide) - region.x;
    region.height = std::min(high, mSide) - region.y;
    return region;
}

void GroundMaps::drawInto(Framebuffer target, const Region &region)
{
    mGl.glDisable(GL_DEPTH_TEST);
    mGl.glDisable(GL_BLEND);
    mGl.glDisable(GL_CULL_FACE);
    mGl.glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    mGl.glBindFramebuffer(GL_FRAMEBUFFER, mFramebuffers[target]);
    mGl.glViewport(0, 0, mSide, mSide);
    mGl.glEnable(GL_SCISSOR_TEST);
    mGl.glScissor(region.x, region.y, region.width, region.height);
}

model::Box3f GroundMaps::litBox(const model::Box3f &changed, const model::Box3f &all, model::Vec3f sun)
{
    // A change takes away sky by the square of its height over the distance: little beyond a few heights.
    const float around = 3 * changed.size().y;
    const float shadow = (changed.max.y - all.min.y) / std::max(sun.y, 0.02f);
    model::Box3f lit = changed;
    lit.add(changed.min - model::Vec3f{around, 0, around});
    lit.add(changed.max + model::Vec3f{around, 0, around});
    lit.add(changed.min - sun * shadow);
    lit.add(changed.max - sun * shadow);
    lit.min.y = std::min(lit.min.y, all.min.y);
    lit.max.y = std::max(lit.max.y, all.max.y);
    return lit;
}

void GroundMaps::note(const model::Box3f &changed)
{
    mHeightChanges.add(changed);
    mLightChanges.add(changed);
}

void GroundMaps::updateHeights(TerrainBuffers &buffers, int side)
{
    if (side != mSide)
        allocate(side);
    const model::Box3f changed = std::exchange(mHeightChanges, {});
    const bool isAll = std::exchange(mIsNew, false);
    if (!isAll && changed.isEmpty())
        return;
    drawInto(HeightTarget, isAll ? Region{0, 0, mSide, mSide} : regionOf(changed));
    mGl.glClearColor(NoGround, 0, 0, 1);
    mGl.glClear(GL_COLOR_BUFFER_BIT);
    mHeightProgram->bind();
    mHeightProgram->setUniformValue("uHalf", mFrame.halfX(), mFrame.halfY());
    buffers.draw([&](const model::Box3f &box) {
        return isAll || (box.min.x <= changed.max.x && box.max.x >= changed.min.x && box.min.z <= changed.max.z &&
                         box.max.z >= changed.min.z);
    });
    mGl.glDisable(GL_SCISSOR_TEST);
    mGl.glUseProgram(0);
}

void GroundMaps::updateLight(const model::Box3f &all, model::Vec3f sun)
{
    const model::Box3f changed = std::exchange(mLightChanges, {});
    const bool isAll = std::exchange(mIsLightNew, false) || !(sun == mSun);
    if (!isAll && changed.isEmpty())
        return;
    mSun = sun;
    const float longest = 2 * std::max(mFrame.halfX(), mFrame.halfY());
    const float relief = all.isEmpty() ? 0 : all.size().y;
    const float elevation = sun.y / std::max(std::hypot(sun.x, sun.z), 1e-6f);
    drawInto(LightTarget, isAll ? Region{0, 0, mSide, mSide} : regionOf(litBox(changed, all, sun)));
    mLightProgram->bind();
    mLightProgram->setUniformValue("uHeights", 0);
    mLightProgram->setUniformValue("uHalf", mFrame.halfX(), mFrame.halfY());
    mLightProgram->setUniformValue("uSun", QVector3D(sun.x, sun.y, sun.z));
    mLightProgram->setUniformValue("uReach", std::min(relief / std::max(elevation * 0.85f, 1e-3f), longest));
    mLightProgram->setUniformValue("uSkyReach", SkyReach * longest);
    mGl.glActiveTexture(GL_TEXTURE0);
    mGl.glBindTexture(GL_TEXTURE_2D, mTextures[Heights]);
    mGl.glBindVertexArray(mEmptyArray);
    mGl.glDrawArrays(GL_TRIANGLES, 0, 3);
    mGl.glBindVertexArray(0);
    mGl.glBindTexture(GL_TEXTURE_2D, 0);
    mGl.glDisable(GL_SCISSOR_TEST);
    mGl.glUseProgram(0);
}

} // namespace views
