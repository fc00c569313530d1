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

/// Where light may change if the ground does within a box: in its shadow, and a little around.
model::Box3f litBox(const model::Box3f &changed, const model::Box3f &all, model::Vec3f sun)
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

} // namespace

GroundMaps::GroundMaps(QOpenGLFunctions_3_3_Core &gl, const GroundFrame &frame, int pieces, QString &error)
    : mGl(gl)
    , mFrame(frame)
    , mPieces(pieces)
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

void GroundMaps::restart()
{
    mHasHeights = mHasLight = false;
    mHeightTiles.addAll();
    mLightTiles.addAll();
    mLightChanges = {};
    mSun = {};
}

void GroundMaps::setSide(int side)
{
    if (side == mSide)
        return;
    mSide = side;
    mHasHeights = mHasLight = false;
    const int piece = (side + mPieces - 1) / mPieces;
    for (StaleTiles *tiles : {&mHeightTiles, &mLightTiles}) {
        tiles->reset({side, side}, {piece, piece});
        tiles->addAll();
    }
    const struct
    {
        Texture texture;
        Framebuffer target;
        GLenum attachment;
        GLint kept;
        GLenum format, type;
    } maps[] = {{Heights, HeightTarget, GL_COLOR_ATTACHMENT0, GL_R32F, GL_RED, GL_FLOAT},
                {Paint, HeightTarget, GL_COLOR_ATTACHMENT1, GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE},
                {Numbers, HeightTarget, GL_COLOR_ATTACHMENT2, GL_R32F, GL_RED, GL_FLOAT},
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
    const GLenum all[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1, GL_COLOR_ATTACHMENT2};
    mGl.glDrawBuffers(3, all);
    mGl.glBindTexture(GL_TEXTURE_2D, 0);
}

QRect GroundMaps::regionOf(const model::Box3f &box) const
{
    const auto texel = [this](float place, float half, float round) {
        return int(std::floor(std::clamp(place / half / 2 + 0.5f, 0.0f, 1.0f) * float(mSide) + round));
    };
    return QRect(QPoint(texel(box.min.x, mFrame.halfX(), -1.0f), texel(box.min.z, mFrame.halfY(), -1.0f)),
                 QPoint(texel(box.max.x, mFrame.halfX(), 1.0f), texel(box.max.z, mFrame.halfY(), 1.0f)));
}

void GroundMaps::drawInto(Framebuffer target, const QRect &region)
{
    mGl.glDisable(GL_DEPTH_TEST);
    mGl.glDisable(GL_BLEND);
    mGl.glDisable(GL_CULL_FACE);
    mGl.glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    mGl.glBindFramebuffer(GL_FRAMEBUFFER, mFramebuffers[target]);
    mGl.glViewport(0, 0, mSide, mSide);
    mGl.glEnable(GL_SCISSOR_TEST);
    mGl.glScissor(region.x(), region.y(), region.width(), region.height());
}

void GroundMaps::note(const model::Box3f &changed)
{
    if (changed.isEmpty())
        return;
    mHeightTiles.add(regionOf(changed));
    mLightChanges.add(changed);
}

void GroundMaps::stepHeights(TerrainBuffers &buffers)
{
    const QRect region = mHeightTiles.take();
    mHasHeights |= mHeightTiles.isEmpty();
    drawInto(HeightTarget, region);
    mGl.glClearColor(NoGround, 0, 0, 1);
    mGl.glClear(GL_COLOR_BUFFER_BIT);
    mHeightProgram->bind();
    mHeightProgram->setUniformValue("uHalf", mFrame.halfX(), mFrame.halfY());
    const auto place = [this](int texel, float half) { return (2 * float(texel) / float(mSide) - 1) * half; };
    const float left = place(region.left(), mFrame.halfX()), right = place(region.right() + 1, mFrame.halfX());
    const float low = place(region.top(), mFrame.halfY()), high = place(region.bottom() + 1, mFrame.halfY());
    buffers.draw([&](const model::Box3f &box) {
        return box.min.x <= right && box.max.x >= left && box.min.z <= high && box.max.z >= low;
    });
    mGl.glDisable(GL_SCISSOR_TEST);
    mGl.glUseProgram(0);
}

model::Box3f GroundMaps::aimLight(const model::Box3f &all, model::Vec3f sun)
{
    const model::Box3f changed = std::exchange(mLightChanges, {});
    const bool isAll = !(sun == mSun);
    if (!isAll && changed.isEmpty())
        return {};
    const float longest = 2 * std::max(mFrame.halfX(), mFrame.halfY());
    const float relief = all.isEmpty() ? 0 : all.size().y;
    const float elevation = sun.y / std::max(std::hypot(sun.x, sun.z), 1e-6f);
    mSun = sun;
    mReach = std::min(relief / std::max(elevation * 0.85f, 1e-3f), longest);
    if (isAll) {
        mLightTiles.addAll();
        return all;
    }
    const model::Box3f lit = litBox(changed, all, sun);
    mLightTiles.add(regionOf(lit));
    return lit;
}

void GroundMaps::stepLight()
{
    const QRect region = mLightTiles.take();
    mHasLight |= mLightTiles.isEmpty();
    drawInto(LightTarget, region);
    mLightProgram->bind();
    mLightProgram->setUniformValue("uHeights", 0);
    mLightProgram->setUniformValue("uHalf", mFrame.halfX(), mFrame.halfY());
    mLightProgram->setUniformValue("uSun", QVector3D(mSun.x, mSun.y, mSun.z));
    mLightProgram->setUniformValue("uReach", mReach);
    mLightProgram->setUniformValue("uSkyReach", SkyReach * 2 * std::max(mFrame.halfX(), mFrame.halfY()));
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
