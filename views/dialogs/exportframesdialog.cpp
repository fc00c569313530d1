// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/dialogs/exportframesdialog.h"

#include "model/io/animationreader.h"
#include "model/io/animationwriter.h"
#include "views/dialogs/pathfield.h"
#include "views/dialogs/quantitytext.h"

#include <QComboBox>
#include <QFileInfo>
#include <QFormLayout>

namespace views {

using model::io::MeshFormat;

ExportFramesDialog::ExportFramesDialog(model::FrameSourcePtr frames, const QString &folder, std::uint32_t first,
                                       std::uint32_t last, QWidget *parent)
    : ExportDialog(tr("Export Frames"), parent)
    , mFrames(std::move(frames))
    , mFolder(new PathField(tr("Folder"), PathField::ExistingFolder, this))
    , mFormat(new QComboBox(this))
{
    mFolder->setObjectName(QStringLiteral("folder"));
    mFolder->setPath(folder);
    mFormat->setObjectName(QStringLiteral("format"));
    mFormat->setAccessibleName(tr("Format"));
    mFormat->addItem(tr("OBJ (text)"), int(MeshFormat::Obj));
    mFormat->addItem(tr("OFF (text)"), int(MeshFormat::Off));
    mFormat->addItem(tr("PLY (binary)"), int(MeshFormat::Ply));
    form().addRow(tr("F&older:"), mFolder);
    form().addRow(tr("For&mat:"), mFormat);
    mRange = new FrameRangeFields(form(), mFrames->frameCount(), first, last, this);
    connect(mFolder, &PathField::pathChanged, this, &ExportFramesDialog::refresh);
    connect(mRange, &FrameRangeFields::changed, this, &ExportFramesDialog::refresh);
    refresh();
}

QString ExportFramesDialog::problem() const
{
    const QFileInfo folder(mFolder->path());
    if (mFolder->path().isEmpty())
        return tr("Choose a folder.");
    if (folder.exists() && !folder.isDir())
        return tr("The folder is a file.");
    if (!folder.exists() && !QFileInfo(folder.absolutePath()).isDir())
        return tr("The folder that shall hold the new folder does not exist.");
    if (folder.exists() && model::io::frameFilesIn(folder.filePath()))
        return tr("The folder holds frames already. Choose another one, so that they do not mix.");
    return mRange->problem();
}

QString ExportFramesDialog::consequence() const
{
    return tr("%n file(s) will be written.", nullptr, int(mRange->count()));
}

QString ExportFramesDialog::outputPath() const
{
    return mFolder->path();
}

ExportDialog::Work ExportFramesDialog::work()
{
    return [folder = mFolder->path(), frames = mRange->applyTo(mFrames),
            format = MeshFormat(mFormat->currentData().toInt())](const model::Progress &progress) {
        return model::io::writeFrames(folder, *frames, format, progress);
    };
}

} // namespace views
