// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/dialogs/framepreview.h"

#include "model/mesh/softwareraster.h"
#include "views/dialogs/quantitytext.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QMouseEvent>
#include <QPainter>
#include <QSlider>
#include <QVBoxLayout>

#include <algorithm>

namespace views {

using namespace model;

namespace {

RasterStyle styleFor(const QPalette &palette)
{
    RasterStyle style;
    if (palette.color(QPalette::Window).lightness() >= 128) {
        style.backgroundTop = {245, 247, 250};
        style.backgroundBottom = {205, 212, 221};
    }
    return style;
}

QImage toImage(Picture &&picture)
{
    // The image keeps the picture's memory until its last copy is gone.
    auto *kept = new Picture(std::move(picture));
    return QImage(
        kept->rgba.data(), kept->width, kept->height, kept->width * 4, QImage::Format_RGBA8888,
        [](void *data) { delete static_cast<Picture *>(data); }, kept);
}

} // namespace

FramePicture::FramePicture(QWidget *parent)
    : QWidget(parent)
{
    setMinimumSize(200, 150);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setAccessibleName(tr("Preview"));
    setToolTip(tr("Drag to turn, double-click to look from the start again"));
}

void FramePicture::setFrames(FrameSourcePtr frames, const Box3f &box)
{
    mFrames = std::move(frames);
    mBox = box;
    mFrame = 0;
    mTurned = false;
    mCamera = OrbitCamera();
    mPicture = QImage();
    setCursor(mFrames ? Qt::OpenHandCursor : Qt::ArrowCursor);
    request();
}

void FramePicture::setEmptyText(const QString &text)
{
    mEmptyText = text;
    update();
}

void FramePicture::setFrame(std::uint32_t frame)
{
    mFrame = frame;
    request();
}

void FramePicture::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    const RasterStyle style = styleFor(palette());
    const auto colour = [](const std::array<std::uint8_t, 3> &rgb) { return QColor(rgb[0], rgb[1], rgb[2]); };
    QLinearGradient background(0, 0, 0, height());
    background.setColorAt(0, colour(style.backgroundTop));
    background.setColorAt(1, colour(style.backgroundBottom));
    painter.fillRect(rect(), background);
    if (!mPicture.isNull()) {
        painter.setRenderHint(QPainter::SmoothPixmapTransform);
        painter.drawImage(rect(), mPicture);
    } else if (!mEmptyText.isEmpty()) {
        QColor text = palette().color(QPalette::WindowText);
        text.setAlphaF(0.65f);
        painter.setPen(text);
        painter.drawText(rect().adjusted(16, 16, -16, -16), Qt::AlignCenter | Qt::TextWordWrap, mEmptyText);
    }
}

void FramePicture::resizeEvent(QResizeEvent *)
{
    request();
}

void FramePicture::changeEvent(QEvent *event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange)
        request();
}

void FramePicture::mousePressEvent(QMouseEvent *event)
{
    mDragFrom = event->position();
}

void FramePicture::mouseMoveEvent(QMouseEvent *event)
{
    if (!mFrames || !event->buttons().testFlag(Qt::LeftButton))
        return;
    const QPointF moved = event->position() - mDragFrom;
    mDragFrom = event->position();
    mCamera.orbit(float(moved.x() / height()), float(moved.y() / height()));
    mTurned = true;
    request();
}

void FramePicture::mouseDoubleClickEvent(QMouseEvent *)
{
    mTurned = false;
    mCamera = OrbitCamera();
    request();
}

void FramePicture::request()
{
    if (mDrawing.isRunning())
        mOutdated = true;
    else
        draw();
}

void FramePicture::draw()
{
    mOutdated = false;
    if (!mFrames) {
        update();
        return;
    }
    const QSize size = (QSizeF(rect().size()) * devicePixelRatioF()).toSize().expandedTo({1, 1});
    if (!mTurned)
        mCamera.fit(mBox, float(size.width()) / float(size.height()));
    mDrawing.start(
        [frames = mFrames, frame = mFrame, camera = mCamera, size,
         style = styleFor(palette())](const Progress &) -> Result<QImage> {
            const std::vector<Vec3f> positions = frames->frame(frame);
            return toImage(
                drawMesh(positions, frames->connectivity().triangles, camera, size.width(), size.height(), style));
        },
        [this, drawn = mFrames](Result<QImage> image) {
            if (image && drawn == mFrames) {
                mPicture = std::move(*image);
                update();
            }
            if (mOutdated)
                draw();
        });
}

FramePreview::FramePreview(QWidget *parent)
    : QWidget(parent)
    , mPicture(new FramePicture(this))
    , mSlider(new QSlider(Qt::Horizontal, this))
    , mFrameText(new QLabel(this))
{
    mSlider->setObjectName(QStringLiteral("previewFrame"));
    mSlider->setAccessibleName(tr("Frame of the preview"));
    auto *row = new QHBoxLayout;
    row->addWidget(mSlider, 1);
    row->addWidget(mFrameText);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(mPicture, 1);
    column->addLayout(row);
    connect(mSlider, &QSlider::valueChanged, this, &FramePreview::showFrame);
    clear({});
}

void FramePreview::setFrames(FrameSourcePtr frames, const Box3f &box)
{
    const int last = int(frames->frameCount()) - 1;
    mPicture->setFrames(std::move(frames), box);
    const QSignalBlocker quiet(mSlider);
    mSlider->setRange(0, last);
    mSlider->setPageStep(std::max(1, last / 10));
    mSlider->setValue(0);
    mSlider->setEnabled(last > 0);
    showFrame(0);
}

void FramePreview::clear(const QString &text)
{
    mPicture->setFrames(nullptr, {});
    mPicture->setEmptyText(text);
    mSlider->setEnabled(false);
    mFrameText->clear();
}

void FramePreview::showFrame(int frame)
{
    mPicture->setFrame(std::uint32_t(frame));
    mFrameText->setText(
        tr("Frame %1 of %2")
            .arg(countText(std::uint64_t(frame) + 1), countText(std::uint64_t(mSlider->maximum()) + 1)));
}

} // namespace views
