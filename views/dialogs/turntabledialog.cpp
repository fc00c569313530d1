// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/dialogs/turntabledialog.h"

#include "views/dialogs/exportpicturesdialog.h"
#include "views/dialogs/numberfield.h"
#include "views/dialogs/pathfield.h"
#include "views/dialogs/picturesizefields.h"
#include "views/dialogs/quantitytext.h"
#include "views/viewport/sceneviewport.h"

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QSlider>

#include <numbers>

namespace views {

namespace {

constexpr double UsualCount = 120, LargestCount = 3600;
constexpr double PlayedAt = 24; ///< pictures per second, for the hint
constexpr QSize PreviewSize(320, 180);

} // namespace

TurntableDialog::TurntableDialog(SceneViewport &viewport, DrawView draw, const QString &folder, QWidget *parent)
    : ExportDialog(tr("Export Turntable"), parent)
    , mViewport(viewport)
    , mDraw(std::move(draw))
    , mFolder(new PathField(tr("Folder"), PathField::ExistingFolder, this))
    , mCount(new NumberField(tr("Pictures"), {2, LargestCount, 0}))
    , mDirection(new QComboBox(this))
    , mTurn(new QSlider(Qt::Horizontal, this))
    , mPreview(new QLabel(this))
{
    setWindowModality(Qt::WindowModal);
    mFolder->setObjectName(QStringLiteral("folder"));
    mFolder->setPath(folder);
    mCount->setObjectName(QStringLiteral("count"));
    mCount->setValue(UsualCount);
    mDirection->setObjectName(QStringLiteral("direction"));
    mDirection->setAccessibleName(tr("Direction"));
    mDirection->addItem(tr("The scene turns to the right"), true);
    mDirection->addItem(tr("The scene turns to the left"), false);
    mTurn->setObjectName(QStringLiteral("turn"));
    mTurn->setAccessibleName(tr("Preview"));
    mTurn->setRange(0, 359);
    mTurn->setMinimumWidth(PreviewSize.width());
    mPreview->setObjectName(QStringLiteral("preview"));
    mPreview->setFixedSize(PreviewSize);
    mPreview->setAlignment(Qt::AlignCenter);
    form().addRow(tr("F&older:"), mFolder);
    mSize = new PictureSizeFields(form(), viewport.size() * viewport.devicePixelRatioF(), viewport.maximumPictureSize(),
                                  this);
    form().addRow(tr("Pict&ures:"), mCount);
    form().addRow(tr("&Direction:"), mDirection);
    form().addRow(tr("Pre&view:"), mTurn);
    form().addRow(QString(), mPreview);
    connect(mFolder, &PathField::pathChanged, this, &TurntableDialog::refresh);
    connect(mSize, &PictureSizeFields::changed, this, &TurntableDialog::refresh);
    connect(mSize, &PictureSizeFields::changed, this, &TurntableDialog::showPreview);
    connect(mCount, &NumberField::changed, this, &TurntableDialog::refresh);
    connect(mDirection, &QComboBox::currentIndexChanged, this, &TurntableDialog::showPreview);
    connect(mTurn, &QSlider::valueChanged, this, &TurntableDialog::showPreview);
    refresh();
    showPreview();
}

model::OrbitCamera TurntableDialog::cameraOf(model::OrbitCamera first, std::size_t picture, std::size_t count,
                                             bool isClockwise)
{
    const double turn = 2 * std::numbers::pi * double(picture) / double(count);
    first.yaw += float(isClockwise ? -turn : turn);
    return first;
}

bool TurntableDialog::isClockwise() const
{
    return mDirection->currentData().toBool();
}

/// As wide for its height as the pictures will be.
QSize TurntableDialog::previewSize() const
{
    if (!mSize->problem().isEmpty())
        return PreviewSize;
    return mSize->size().scaled(PreviewSize, Qt::KeepAspectRatio).expandedTo({1, 1});
}

void TurntableDialog::showPreview()
{
    mIsPreviewOld = true;
    if (mDrawing.isRunning() || isExporting())
        return;
    mIsPreviewOld = false;
    const auto turn = std::size_t(mTurn->value());
    mDrawing.start(
        [draw = mDraw, camera = cameraOf(mViewport.camera(), turn, 360, isClockwise()),
         size = previewSize()](const model::Progress &progress) -> model::Result<QImage> {
            return draw(size, camera, progress).value_or(QImage());
        },
        [this](const model::Result<QImage> &picture) {
            if (picture && !picture->isNull())
                mPreview->setPixmap(QPixmap::fromImage(*picture));
            if (mIsPreviewOld)
                QMetaObject::invokeMethod(this, &TurntableDialog::showPreview, Qt::QueuedConnection);
        });
}

QString TurntableDialog::problem() const
{
    const QString folder = ExportPicturesDialog::folderProblem(mFolder->path());
    if (!folder.isEmpty())
        return folder;
    return !mSize->problem().isEmpty() ? mSize->problem() : mCount->value() ? QString() : mCount->problem();
}

QString TurntableDialog::consequence() const
{
    const auto pictures = int(*mCount->value());
    return tr("%n picture(s) of %1 × %2 pixels. At %3 pictures per second they last %4.", nullptr, pictures)
        .arg(mSize->size().width())
        .arg(mSize->size().height())
        .arg(numberText(PlayedAt, 3), durationText(pictures / PlayedAt));
}

QString TurntableDialog::outputPath() const
{
    return mFolder->path();
}

ExportDialog::Work TurntableDialog::work()
{
    mDrawing.cancel();
    const auto count = std::size_t(*mCount->value());
    const auto drawPicture = [draw = mDraw, size = mSize->size(), first = mViewport.camera(), count,
                              clockwise = isClockwise()](std::size_t picture, const model::Progress &progress) {
        return draw(size, cameraOf(first, picture, count, clockwise), progress);
    };
    return [folder = mFolder->path(), count, drawPicture](const model::Progress &progress) {
        return savePictures(folder, count, drawPicture, progress);
    };
}

} // namespace views
