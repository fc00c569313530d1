// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/dialogs/screenshotdialog.h"

#include "views/dialogs/pathfield.h"
#include "views/dialogs/picturesizefields.h"
#include "views/scene/picturefiles.h"
#include "views/viewport/animationviewport.h"

#include <QFileInfo>
#include <QFormLayout>

namespace views {

ScreenshotDialog::ScreenshotDialog(AnimationViewport &viewport, FrameDataPtr frame, const QString &path,
                                   QWidget *parent)
    : ExportDialog(tr("Save Screenshot"), parent)
    , mViewport(viewport)
    , mFrame(std::move(frame))
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
    const QImage picture = mFrame ? mViewport.renderPicture(*mFrame, mSize->size()) : QImage();
    return [picture, path = outputPath()](const model::Progress &progress) -> model::Result<void> {
        if (picture.isNull())
            return model::fail(model::ErrorCode::OutOfMemory);
        return savePng(path, picture, progress);
    };
}

} // namespace views
