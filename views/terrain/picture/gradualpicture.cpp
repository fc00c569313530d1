// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/terrain/picture/gradualpicture.h"

#include <QElapsedTimer>

#include <algorithm>
#include <cmath>
#include <utility>

namespace views {

namespace {

QOpenGLFramebufferObjectFormat formatWith(QOpenGLFramebufferObject::Attachment attachment, int samples)
{
    QOpenGLFramebufferObjectFormat format;
    format.setAttachment(attachment);
    format.setSamples(samples);
    return format;
}

bool isSameView(const model::OrbitCamera &a, const model::OrbitCamera &b)
{
    return a.target == b.target && a.distance == b.distance && a.yaw == b.yaw && a.pitch == b.pitch &&
           a.fieldOfView == b.fieldOfView;
}

} // namespace

GradualPicture::GradualPicture(QOpenGLFunctions_3_3_Core &gl, TerrainRenderer &renderer, const StepLimits &limits,
                               int samples)
    : mGl(gl)
    , mRenderer(renderer)
    , mLimits(limits)
    , mSamples(samples)
{}

GradualPicture::~GradualPicture() = default;

void GradualPicture::setPicture(const TerrainPicture &picture)
{
    const bool isSame = picture.size == mPicture.size && picture.style == mPicture.style &&
                        picture.pixelRatio == mPicture.pixelRatio && isSameView(picture.camera, mPicture.camera);
    const bool isSameSize = picture.size == mPicture.size;
    mPicture = picture;
    mIsExactOld |= !isSame;
    mPicture.isCoarse = mLimits.coarsePixels > 0 && mIsExactOld; // then heights are wanted at once
    if (isSame)
        return;
    if (!isSameSize) {
        using Fbo = QOpenGLFramebufferObject;
        mExact = std::make_unique<Fbo>(picture.size, formatWith(Fbo::NoAttachment, 0));
        mDrawn = std::make_unique<Fbo>(picture.size, formatWith(Fbo::CombinedDepthStencil, mSamples));
        mStale.reset(picture.size, mLimits.tile.boundedTo(picture.size).expandedTo({1, 1}));
        if (mShown == Shown::Exact)
            mShown = Shown::Nothing;
    }
    mStale.addAll();
    mPart.reset();
    mIsCoarseStale = true;
}

void GradualPicture::noteChanges()
{
    const model::Box3f changes = mRenderer.takeChanges();
    if (mRenderer.takeIsAllChanged())
        mStale.addAll();
    else if (!changes.isEmpty())
        mStale.add(mRenderer.partOf(mPicture, changes));
    else
        return;
    mIsCoarseStale = true;
}

bool GradualPicture::drawCoarsely()
{
    const bool isNeeded = mLimits.coarsePixels > 0 && mIsExactOld && !mPicture.size.isEmpty();
    if (!isNeeded || !mRenderer.canBeCoarse() || mRenderer.buffers().hasMore())
        return false;
    const double pixels = double(mPicture.size.width()) * mPicture.size.height();
    const double share = std::min(1.0, std::sqrt(mLimits.coarsePixels / pixels));
    TerrainPicture coarse = mPicture;
    coarse.isCoarse = true;
    coarse.size = (QSizeF(mPicture.size) * share).toSize().expandedTo({1, 1});
    coarse.pixelRatio *= float(share);
    coarse.style.quality = std::min(coarse.style.quality, GroundQuality::Medium);
    if (!mCoarse || mCoarse->size() != coarse.size)
        mCoarse = std::make_unique<QOpenGLFramebufferObject>(
            coarse.size, formatWith(QOpenGLFramebufferObject::CombinedDepthStencil, 0));
    PartProgress progress;
    mRenderer.drawPart(coarse, mCoarse->handle(), QRect(QPoint(0, 0), coarse.size), progress,
                       std::numeric_limits<std::uint32_t>::max());
    mIsCoarseStale = false;
    mShown = Shown::Coarse;
    return true;
}

void GradualPicture::count(int pixels, std::uint32_t chunks)
{
    ++mWork.steps;
    mWork.mostPixels = std::max(mWork.mostPixels, pixels);
    mWork.mostChunks = std::max(mWork.mostChunks, chunks);
}

void GradualPicture::stepMaps()
{
    const bool hadHeights = mRenderer.hasHeights();
    const model::Box3f lit = mRenderer.stepMaps(mPicture);
    if (!lit.isEmpty())
        mStale.add(mRenderer.partOf(mPicture, lit));
    if (!hadHeights && mRenderer.hasHeights())
        mIsCoarseStale = true;
    count(0, 0);
    ++mWork.mapSteps;
}

bool GradualPicture::step()
{
    if (mRenderer.hasMapWork(mPicture)) {
        stepMaps();
        return false;
    }
    if (!mPart) {
        mPart = mStale.take();
        mProgress = {};
    }
    TerrainPicture exact = mPicture;
    exact.isCoarse = false;
    mRenderer.drawPart(exact, mDrawn->handle(), *mPart, mProgress, mLimits.chunks);
    count(mPart->width() * mPart->height(), mProgress.drawnChunks);
    if (!mProgress.isDone)
        return false;
    const QRect part = *std::exchange(mPart, std::nullopt);
    if (mIsExactOld && !mStale.isEmpty())
        return false;
    const QRect whole(QPoint(0, 0), mPicture.size);
    const QRect &ready = mIsExactOld ? whole : part;
    blit(*mDrawn, mExact->handle(), ready, ready);
    mIsExactOld = false;
    mShown = Shown::Exact;
    mPicture.isCoarse = false;
    return true;
}

bool GradualPicture::work(Kind kind)
{
    QElapsedTimer clock;
    clock.start();
    bool hasChanged = false;
    while (kind == Kind::All ? !isDone() : mRenderer.hasMapWork(mPicture)) {
        hasChanged |= step();
        if (mLimits.isWaiting)
            mGl.glFinish();
        if (double(clock.nsecsElapsed()) * 1e-6 > mLimits.milliseconds)
            break;
    }
    return hasChanged;
}

void GradualPicture::blit(const QOpenGLFramebufferObject &from, GLuint to, const QRect &source, const QRect &target)
{
    mGl.glBindFramebuffer(GL_READ_FRAMEBUFFER, from.handle());
    mGl.glBindFramebuffer(GL_DRAW_FRAMEBUFFER, to);
    mGl.glDisable(GL_SCISSOR_TEST);
    mGl.glBlitFramebuffer(source.left(), source.top(), source.right() + 1, source.bottom() + 1, target.left(),
                          target.top(), target.right() + 1, target.bottom() + 1, GL_COLOR_BUFFER_BIT,
                          source.size() == target.size() ? GL_NEAREST : GL_LINEAR);
    mGl.glBindFramebuffer(GL_FRAMEBUFFER, to);
}

void GradualPicture::show(GLuint framebuffer)
{
    const QRect whole(QPoint(0, 0), mPicture.size);
    if (mShown == Shown::Exact)
        return blit(*mExact, framebuffer, whole, whole);
    if (mShown == Shown::Coarse)
        return blit(*mCoarse, framebuffer, QRect(QPoint(0, 0), mCoarse->size()), whole);
    mGl.glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    setPictureState(mGl, mPicture.size, {});
    clearPicture(mGl);
}

QImage GradualPicture::toImage() const
{
    return mExact->toImage().convertToFormat(QImage::Format_RGB32);
}

} // namespace views
