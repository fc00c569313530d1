// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/documents/openmesh.h"

#include "app/editor/documents/framefiles.h"
#include "app/editor/inspect/fieldoffers.h"
#include "model/io/animationwriter.h"
#include "model/io/polygonreader.h"

#include <QFileInfo>

namespace editor {

namespace {

/// By the ending; OBJ for endings that are read but not written.
model::io::MeshFormat formatOf(const QString &path)
{
    const QString ending = QFileInfo(path).suffix().toLower();
    if (ending == QLatin1String("off"))
        return model::io::MeshFormat::Off;
    return ending == QLatin1String("ply") ? model::io::MeshFormat::Ply : model::io::MeshFormat::Obj;
}

} // namespace

OpenMesh::OpenMesh(QObject *parent)
    : Document(parent)
{}

OpenMesh::~OpenMesh()
{
    emit aboutToBeReplaced();
}

void OpenMesh::start(std::function<model::Result<Opened>(const model::Progress &)> work)
{
    openingJob().start(std::move(work), [this](model::Result<Opened> result) {
        if (result)
            take(std::move(*result));
        else
            emit failed(result.error());
    });
}

void OpenMesh::read(const QString &path)
{
    start([path](const model::Progress &progress) -> model::Result<Opened> {
        const FileStamp stamp = FileStamp::of(path);
        auto mesh = model::io::readPolygonMesh(path, progress);
        if (!mesh)
            return model::fail(mesh.error());
        return Opened{{std::move(*mesh), {}}, stamp, alikeFileCount(path)};
    });
}

void OpenMesh::create(const QString &name, std::function<model::Result<Made>(const model::Progress &)> make)
{
    mName = name;
    start([make = std::move(make)](const model::Progress &progress) -> model::Result<Opened> {
        auto made = make(progress);
        if (!made)
            return model::fail(made.error());
        return Opened{std::move(*made), {}, 1};
    });
}

void OpenMesh::take(Opened opened)
{
    emit aboutToBeReplaced();
    mContext.reset();
    mAlike = opened.alike;
    mDocument =
        std::make_unique<model::MeshDocument>(std::make_shared<const model::PolygonMesh>(std::move(opened.made.mesh)));
    mContext = std::make_unique<commands::MeshContext>(*mDocument);
    connect(&mContext->undoStack(), &QUndoStack::cleanChanged, this, &OpenMesh::updateModified);
    connect(mDocument.get(), &model::MeshDocument::changed, this, [this] { inspect({}); });
    inspect(std::move(opened.made.fields));
    finishOpening(opened.stamp);
}

void OpenMesh::inspect(std::vector<views::FieldOffer> moreFields)
{
    mInspection.setMesh(mDocument->mesh());
    std::vector<views::FieldOffer> fields = meshFields(mDocument->mesh());
    std::move(moreFields.begin(), moreFields.end(), std::back_inserter(fields));
    mInspection.setOffers(std::move(fields));
}

void OpenMesh::write(const QString &path)
{
    savingJob().start(
        [mesh = mDocument->mesh(), path](const model::Progress &) -> model::Result<FileStamp> {
            if (auto written = model::io::writePolygonMesh(path, *mesh, formatOf(path)); !written)
                return model::fail(written.error());
            return FileStamp::of(path);
        },
        [this, path, step = mContext->undoStack().index()](const model::Result<FileStamp> &result) {
            if (result)
                finishSaving(path, *result, step);
            else
                emit saveFailed(result.error());
        });
}

QString OpenMesh::title() const
{
    return path().isEmpty() ? mName : QFileInfo(path()).fileName();
}

QString OpenMesh::origin() const
{
    return tr("Made of an animation, not saved to a file yet");
}

QString OpenMesh::summary() const
{
    const model::PolygonMesh &mesh = *mDocument->mesh();
    return tr("%L1 vertices, %L2 faces").arg(mesh.positions.size()).arg(mesh.faces.faceCount());
}

QString OpenMesh::warning() const
{
    if (mAlike < 2)
        return {};
    return tr("It is one of %n numbered meshes in its folder. To open them as an animation, drop the folder here, or "
              "choose it in File > Prepare Animation.",
              "", mAlike);
}

bool OpenMesh::isModified() const
{
    return mContext && !mContext->undoStack().isClean();
}

} // namespace editor
