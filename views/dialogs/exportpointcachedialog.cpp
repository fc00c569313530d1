// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/dialogs/exportpointcachedialog.h"

#include "model/io/animationwriter.h"
#include "views/dialogs/pathfield.h"
#include "views/dialogs/quantitytext.h"

#include <QCheckBox>
#include <QFileInfo>
#include <QFormLayout>

namespace views {

namespace {

model::Result<void> writeCache(const QString &path, const QString &baseMesh, const model::FrameSource &frames,
                               const model::Progress &progress)
{
    // The mesh last: once the cache is there nothing is cancelled any more.
    if (auto written = model::io::writePc2(path, frames, progress); !written || baseMesh.isEmpty())
        return written;
    return model::io::writeMesh(baseMesh, frames.frame(0), frames.connectivity(), model::io::MeshFormat::Obj);
}

} // namespace

ExportPointCacheDialog::ExportPointCacheDialog(model::FrameSourcePtr frames, const QString &path, std::uint32_t first,
                                               std::uint32_t last, QWidget *parent)
    : ExportDialog(tr("Export Point Cache"), parent)
    , mFrames(std::move(frames))
    , mOutput(new PathField(tr("Output File"), PathField::NewFile, this))
    , mBaseMesh(new QCheckBox(tr("Write the &base mesh beside it"), this))
{
    mOutput->setObjectName(QStringLiteral("output"));
    mOutput->setFileFilter(tr("PC2 Point Caches (%1)").arg(QStringLiteral("*.pc2")));
    mOutput->setPath(path);
    mBaseMesh->setObjectName(QStringLiteral("baseMesh"));
    mBaseMesh->setChecked(true);
    mBaseMesh->setToolTip(tr("A point cache holds positions alone; the triangles are in its base mesh."));
    form().addRow(tr("&Output file:"), mOutput);
    form().addRow(QString(), mBaseMesh);
    mRange = new FrameRangeFields(form(), mFrames->frameCount(), first, last, this);
    connect(mOutput, &PathField::pathChanged, this, &ExportPointCacheDialog::refresh);
    connect(mBaseMesh, &QCheckBox::toggled, this, &ExportPointCacheDialog::refresh);
    connect(mRange, &FrameRangeFields::changed, this, &ExportPointCacheDialog::refresh);
    refresh();
}

QString ExportPointCacheDialog::problem() const
{
    return !mRange->problem().isEmpty() ? mRange->problem() : newFileProblem(outputPath());
}

QString ExportPointCacheDialog::consequence() const
{
    constexpr std::uint64_t HeaderBytes = 32;
    const std::uint64_t bytes =
        HeaderBytes + std::uint64_t(mRange->count()) * mFrames->vertexCount() * sizeof(model::Vec3f);
    return mBaseMesh->isChecked() ? tr("%1 and its base mesh %2 will be written.")
                                        .arg(bytesText(bytes), QFileInfo(baseMeshPath()).fileName())
                                  : tr("%1 will be written.").arg(bytesText(bytes));
}

QStringList ExportPointCacheDialog::filesToReplace() const
{
    QStringList files;
    for (const QString &path : {outputPath(), baseMeshPath()})
        if (!path.isEmpty() && QFileInfo::exists(path))
            files << path;
    return files;
}

QString ExportPointCacheDialog::outputPath() const
{
    return withEnding(mOutput->path(), QStringLiteral(".pc2"));
}

QString ExportPointCacheDialog::baseMeshPath() const
{
    const QString path = outputPath();
    return mBaseMesh->isChecked() && !path.isEmpty() ? path.chopped(4) + QStringLiteral(".obj") : QString();
}

ExportDialog::Work ExportPointCacheDialog::work()
{
    return [path = outputPath(), baseMesh = baseMeshPath(), frames = mRange->applyTo(mFrames)](
               const model::Progress &progress) { return writeCache(path, baseMesh, *frames, progress); };
}

} // namespace views
