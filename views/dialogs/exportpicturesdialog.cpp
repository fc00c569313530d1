// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/dialogs/exportpicturesdialog.h"

#include "views/dialogs/pathfield.h"
#include "views/dialogs/picturesizefields.h"
#include "views/dialogs/quantitytext.h"
#include "views/jobs/guicall.h"
#include "views/scene/picturefiles.h"
#include "views/viewport/animationviewport.h"

#include <QComboBox>
#include <QDir>
#include <QFormLayout>
#include <QPointer>

namespace views {

ExportPicturesDialog::ExportPicturesDialog(AnimationViewport &viewport, model::FrameSourcePtr frames,
                                           const QString &folder, std::uint32_t first, std::uint32_t last,
                                           QWidget *parent)
    : ExportDialog(tr("Export Pictures"), parent)
    , mViewport(viewport)
    , mFrames(std::move(frames))
    , mFolder(new PathField(tr("Folder"), PathField::ExistingFolder, this))
    , mOrder(new QComboBox(this))
{
    setWindowModality(Qt::WindowModal);
    mFolder->setObjectName(QStringLiteral("folder"));
    mFolder->setPath(folder);
    mOrder->setObjectName(QStringLiteral("order"));
    mOrder->setAccessibleName(tr("Order"));
    mOrder->addItem(tr("Forward"), int(Order::Forward));
    mOrder->addItem(tr("Backward"), int(Order::Backward));
    mOrder->addItem(tr("There and back"), int(Order::ThereAndBack));
    form().addRow(tr("F&older:"), mFolder);
    mSize = new PictureSizeFields(form(), viewport.size() * viewport.devicePixelRatioF(), viewport.maximumPictureSize(),
                                  this);
    mRange = new FrameRangeFields(form(), mFrames->frameCount(), first, last, this);
    form().addRow(tr("Or&der:"), mOrder);
    connect(mFolder, &PathField::pathChanged, this, &ExportPicturesDialog::refresh);
    connect(mSize, &PictureSizeFields::changed, this, &ExportPicturesDialog::refresh);
    connect(mRange, &FrameRangeFields::changed, this, &ExportPicturesDialog::refresh);
    connect(mOrder, &QComboBox::currentIndexChanged, this, &ExportPicturesDialog::refresh);
    refresh();
}

void ExportPicturesDialog::setOrder(Order order)
{
    mOrder->setCurrentIndex(mOrder->findData(int(order)));
}

QString ExportPicturesDialog::folderProblem(const QString &path)
{
    const QFileInfo folder(path);
    if (path.isEmpty())
        return tr("Choose a folder.");
    if (folder.exists() && !folder.isDir())
        return tr("The folder is a file.");
    if (!folder.exists() && !QFileInfo(folder.absolutePath()).isDir())
        return tr("The folder that shall hold the new folder does not exist.");
    if (folder.exists() && !QDir(folder.filePath()).entryList({QStringLiteral("frame_*.png")}).isEmpty())
        return tr("The folder holds pictures already. Choose another one, so that they do not mix.");
    return {};
}

QString ExportPicturesDialog::problem() const
{
    const QString folder = folderProblem(mFolder->path());
    if (!folder.isEmpty())
        return folder;
    return !mSize->problem().isEmpty() ? mSize->problem() : mRange->problem();
}

QString ExportPicturesDialog::consequence() const
{
    const auto pictures = int(frameOrder().size());
    return tr("%n picture(s) of %1 × %2 pixels. At %3 frames per second they last %4.", nullptr, pictures)
        .arg(mSize->size().width())
        .arg(mSize->size().height())
        .arg(numberText(mFrames->frameRate(), 3), durationText(pictures / mFrames->frameRate()));
}

QString ExportPicturesDialog::outputPath() const
{
    return mFolder->path();
}

ExportDialog::Work ExportPicturesDialog::work()
{
    const DrawFrame draw = [viewport = QPointer<AnimationViewport>(&mViewport),
                            size = mSize->size()](const FrameDataPtr &frame, const model::Progress &progress) {
        // OpenGL belongs to the GUI thread; everything else is done here.
        return callInGui(
            progress, [viewport, size, frame] { return viewport ? viewport->renderPicture(*frame, size) : QImage(); });
    };
    return [folder = mFolder->path(), frames = mFrames, order = frameOrder(), draw](const model::Progress &progress) {
        return savePictures(folder, frames, order, draw, progress);
    };
}

std::vector<std::uint32_t> ExportPicturesDialog::frameOrder() const
{
    std::vector<std::uint32_t> frames;
    for (std::uint32_t frame = mRange->first(); frame <= mRange->last(); ++frame)
        frames.push_back(frame);
    switch (Order(mOrder->currentData().toInt())) {
    case Order::Forward:
        break;
    case Order::Backward:
        frames.assign(frames.rbegin(), frames.rend());
        break;
    case Order::ThereAndBack: // so that it loops: neither end twice
        for (std::uint32_t frame = mRange->last(); frame-- > mRange->first() + 1;)
            frames.push_back(frame);
        break;
    }
    return frames;
}

} // namespace views
