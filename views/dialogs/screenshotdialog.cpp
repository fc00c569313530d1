// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/dialogs/screenshotdialog.h"

#include "views/dialogs/pathfield.h"
#include "views/dialogs/picturesizefields.h"
#include "views/jobs/guicall.h"
#include "views/viewport/animationviewport.h"

#include <QFileInfo>
#include <QFormLayout>
#include <QPointer>

namespace views {

namespace {

DrawView drawingOf(AnimationViewport &shown, const FrameDataPtr &frame)
{
    return [viewport = QPointer<AnimationViewport>(&shown), frame](QSize size, const model::OrbitCamera &,
                                                                   const model::Progress &progress) {
        return callInGui(progress, [viewport, frame, size] {
            return viewport && frame ? viewport->renderPicture(*frame, size) : QImage();
        });
    };
}

} // namespace

ScreenshotDialog::ScreenshotDialog(AnimationViewport &viewport, FrameDataPtr frame, const QString &path,
                                   QWidget *parent)
    : ScreenshotDialog(viewport, drawingOf(viewport, frame), path, parent)
{}

ScreenshotDialog::ScreenshotDialog(SceneViewport &viewport, DrawView draw, const QString &path, QWidget *parent)
    : ExportDialog(tr("Save Screenshot"), parent)
    , mViewport(viewport)
    , mDraw(std::move(draw))
    , mOutput(new PathField(tr("Output File"), PathField::NewFile, this))
{
    setWindowModality(Qt::WindowModal);
    mOutput->setObjectName(QStringLiteral("output"));
    mOutput->setFileFilter(tr("PNG Pictures (%1)").arg(QStringLiteral("*.png")));
    mOutput->setPath(path);
    form().addRow(tr("&Output file:"), mOutput);
    mSize = new PictureSizeFields(form(), viewport.size() * viewport.devicePixelRatioF(), viewport.maximumPictureSize(),
                                  this);
    connect(mOutput, &PathField::pathChanged, this, &ScreenshotDialog::refresh);
    connect(mSize, &PictureSizeFields::changed, this, &ScreenshotDialog::refresh);
    refresh();
}

QString ScreenshotDialog::problem() const
{
    return !mSize->problem().isEmpty() ? mSize->problem() : newFileProblem(outputPath());
}

QString ScreenshotDialog::consequence() const
{
    return tr("%1 × %2 pixels").arg(mSize->size().width()).arg(mSize->size().height());
}

QStringList ScreenshotDialog::filesToReplace() const
{
    return QFileInfo::exists(outputPath()) ? QStringList{outputPath()} : QStringList();
}

QString ScreenshotDialog::outputPath() const
{
    return withEnding(mOutput->path(), QStringLiteral(".png"));
}

ExportDialog::Work ScreenshotDialog::work()
{
    return [draw = mDraw, size = mSize->size(), camera = mViewport.camera(),
            path = outputPath()](const model::Progress &progress) -> model::Result<void> {
        const std::optional<QImage> picture = draw(size, camera, progress);
        if (!picture)
            return model::fail(model::ErrorCode::Cancelled);
        if (picture->isNull())
            return model::fail(model::ErrorCode::OutOfMemory);
        return savePng(path, *picture, progress);
    };
}

} // namespace views
