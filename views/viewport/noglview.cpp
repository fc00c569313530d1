// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/viewport/noglview.h"

#include "model/mesh/softwareraster.h"
#include "views/viewport/errorcolors.h"
#include "views/viewport/glsupport.h"

#include <QEvent>
#include <QLabel>
#include <QPainter>
#include <QVBoxLayout>
#include <QtConcurrentRun>

#include <algorithm>
#include <array>

namespace views {

namespace {

/// Pixels of a picture at most; drawn larger, it would take longer than a frame lasts.
constexpr int LargestSide = 640;

/// Errors as shares of `range`, as the palette wants them.
std::vector<float> shares(const std::vector<float> &errors, float range)
{
    std::vector<float> result(errors.size());
    std::transform(errors.begin(), errors.end(), result.begin(), [range](float error) { return error / range; });
    return result;
}

QImage pictureOf(const FrameData &frame, const model::OrbitCamera &camera, QSize size, float errorRange)
{
    std::array<std::array<std::uint8_t, 3>, ErrorColors.size()> palette;
    std::transform(ErrorColors.begin(), ErrorColors.end(), palette.begin(), [](QRgb color) {
        return std::array{std::uint8_t(qRed(color)), std::uint8_t(qGreen(color)), std::uint8_t(qBlue(color))};
    });
    model::RasterStyle style;
    std::vector<float> places;
    if (errorRange > 0) {
        places = shares(frame.errors, errorRange);
        style.places = places;
        style.palette = palette;
    }
    const model::Picture picture = model::drawMesh(frame.positions, frame.source->connectivity().triangles, camera,
                                                   size.width(), size.height(), style);
    return QImage(picture.rgba.data(), picture.width, picture.height, picture.width * 4, QImage::Format_RGBA8888)
        .copy();
}

} // namespace

NoGlView::NoGlView(Player &player, QWidget *parent)
    : QWidget(parent)
    , mPlayer(player)
    , mMessage(new QLabel(message()))
{
    mMessage->setWordWrap(true);
    mMessage->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    mMessage->setMargin(12);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(mMessage);
    layout->addStretch();
    connect(&mPlayer, &Player::frameReady, this, &NoGlView::request);
    connect(&mPlayer, &Player::sourceChanged, this, &NoGlView::request);
    connect(&mWatcher, &QFutureWatcherBase::finished, this, &NoGlView::drawn);
    request();
}

NoGlView::~NoGlView()
{
    mWatcher.disconnect(this);
    mWatcher.waitForFinished();
}

QString NoGlView::message() const
{
    const GlSupport &found = glSupport();
    const QString what = found.version.isEmpty()
                             ? tr("No OpenGL was found on this computer.")
                             : tr("This computer offers OpenGL %1 (%2).").arg(found.version, found.renderer);
    return what + QLatin1Char(' ') +
           tr("The 3D view needs OpenGL 3.3. Installing the newest driver of the graphics card, or Mesa's software "
              "renderer, helps. Until then the processor draws the animation, slowly; everything else works.");
}

QRect NoGlView::pictureArea() const
{
    return rect().adjusted(0, mMessage->geometry().bottom() + 1, 0, 0);
}

void NoGlView::request()
{
    const FrameDataPtr frame = mPlayer.currentFrame();
    const QSize area = pictureArea().size();
    if (!frame || area.isEmpty()) {
        mPicture = {};
        update();
        return;
    }
    if (mWatcher.isRunning()) {
        mIsOutdated = true;
        return;
    }
    mIsOutdated = false;
    const float aspect = float(area.width()) / float(area.height());
    if (frame->source != mFitted) {
        mFitted = frame->source;
        mCamera.fit(model::boundingBox(frame->positions), aspect);
    }
    const QSize size = area.scaled(LargestSide, LargestSide, Qt::KeepAspectRatio).expandedTo({1, 1});
    mDrawing = frame;
    mWatcher.setFuture(
        QtConcurrent::run([frame, camera = mCamera, size = size.boundedTo(area), range = errorRangeOf(frame.get())] {
            return pictureOf(*frame, camera, size, range);
        }));
}

void NoGlView::drawn()
{
    mPicture = mPlayer.currentFrame() ? mWatcher.result() : QImage();
    update();
    if (mDrawing && mDrawing->source == mPlayer.source())
        mPlayer.frameShown(mDrawing->frame);
    if (mIsOutdated)
        request();
}

void NoGlView::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    if (mPicture.isNull())
        return;
    painter.drawImage(pictureArea(), mPicture);
    drawErrorScale(painter, pictureArea(), true);
}

void NoGlView::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    mFitted.reset();
    request();
}

void NoGlView::changeEvent(QEvent *event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        mMessage->setText(message());
}

} // namespace views
