// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/inspect/inspector.h"

#include "app/editor/actions/actions.h"
#include "app/editor/actions/fileactions.h"
#include "app/editor/documents/animationtab.h"
#include "app/editor/documents/meshtab.h"
#include "app/editor/inspect/fieldoffers.h"
#include "app/editor/start/settings.h"
#include "app/editor/window/workspace.h"
#include "model/io/inspection.h"
#include "model/io/savefile.h"
#include "views/inspect/inspectordock.h"
#include "views/inspect/meshview.h"
#include "views/viewport/glsupport.h"

#include <QDockWidget>
#include <QFileDialog>
#include <QFileInfo>
#include <QJsonDocument>
#include <QMainWindow>

namespace editor {

namespace {

constexpr int ViewCount = 2; ///< beside that of the tab

model::io::InspectionTable tableOf(views::PartKind kind)
{
    switch (kind) {
    case views::PartKind::Component:
        return model::io::InspectionTable::Components;
    case views::PartKind::Hole:
        return model::io::InspectionTable::Holes;
    case views::PartKind::Handle:
        return model::io::InspectionTable::Handles;
    case views::PartKind::Problem:
        break;
    }
    return model::io::InspectionTable::Problems;
}

/// What the command line's `inspect` says: all of it as JSON, or one table as CSV.
model::Result<bool> writeReport(const QString &path, const model::PolygonMesh &mesh, model::io::InspectionTable table,
                                const model::Progress &progress)
{
    const auto found = model::io::inspectMesh(mesh.faces, mesh.positions, {.selfIntersections = true}, progress);
    if (!found)
        return model::fail(found.error());
    QByteArray text;
    if (path.endsWith(QLatin1String(".csv"), Qt::CaseInsensitive))
        text = inspectionCsv(*found, table).join(QLatin1Char('\n')).toUtf8() + '\n';
    else
        text = QJsonDocument(inspectionJson(*found)).toJson();
    const std::span bytes(reinterpret_cast<const std::uint8_t *>(text.constData()), std::size_t(text.size()));
    if (auto saved = model::io::saveBytes(path, bytes); !saved)
        return model::fail(saved.error());
    return true;
}

} // namespace

Inspector::Inspector(Actions &actions, FileActions &files, Workspace &workspace, Settings &settings,
                     QMainWindow &window)
    : mActions(actions)
    , mFiles(files)
    , mWorkspace(workspace)
    , mSettings(settings)
    , mWindow(window)
    , mDock(new views::InspectorDock(&window))
{
    for (int i = 0; i < ViewCount; ++i) {
        auto *dock = new QDockWidget(&window);
        dock->setObjectName(QStringLiteral("meshViewDock%1").arg(i + 2));
        connect(dock, &QDockWidget::visibilityChanged, this, [this, dock](bool isVisible) {
            if (isVisible)
                fill(*dock);
        });
        mViews << dock;
    }
    for (QAction *action : mDock->commands())
        actions.adopt(*action, QT_TRANSLATE_NOOP("Actions", "&Mesh"), DocumentKind::Mesh);
    connect(mDock, &views::InspectorDock::saveAsked, this, &Inspector::saveReport);
    connect(&actions[ActionId::InspectFrame], &QAction::triggered, this, &Inspector::inspectFrame);
    connect(&workspace, &Workspace::currentChanged, this, &Inspector::follow);
    connect(&workspace, &Workspace::currentStateChanged, this, &Inspector::follow);
    retranslate();
    follow();
}

void Inspector::retranslate()
{
    for (int i = 0; i < mViews.size(); ++i)
        mViews[i]->setWindowTitle(tr("Mesh View %1").arg(i + 2));
}

views::Inspection *Inspector::inspection() const
{
    MeshTab *tab = mWorkspace.currentMesh();
    return tab ? &tab->document().inspection() : nullptr;
}

void Inspector::follow()
{
    mDock->setInspection(inspection());
    for (QDockWidget *dock : mViews)
        if (auto *view = qobject_cast<views::MeshView *>(dock->widget()))
            view->setInspection(inspection());
    const AnimationTab *animation = mWorkspace.currentAnimation();
    mActions[ActionId::InspectFrame].setEnabled(animation && animation->document().isOpen());
}

void Inspector::fill(QDockWidget &dock)
{
    if (dock.widget() || !views::glSupport().isSufficient)
        return;
    auto *view = new views::MeshView(&dock);
    view->setInspection(inspection());
    dock.setWidget(view);
}

void Inspector::inspectFrame()
{
    AnimationTab *tab = mWorkspace.currentAnimation();
    if (!tab || !tab->document().isOpen())
        return;
    OpenAnimation &document = tab->document();
    const model::FrameSourcePtr frames = document.context()->document().frames();
    const auto frame = std::uint32_t(document.player().playback().frame());
    const QString name = tr("%1, frame %2").arg(document.title()).arg(frame + 1);
    mFiles.addMesh().create(name,
                            [frames, frame, original = document.player().original()](
                                const model::Progress &) -> model::Result<OpenMesh::Made> {
                                return OpenMesh::Made{{frames->frame(frame), model::Faces(frames->connectivity())},
                                                      frameFields(frames, original, frame)};
                            });
}

void Inspector::saveReport()
{
    MeshTab *tab = mWorkspace.currentMesh();
    if (!tab || !tab->document().isOpen())
        return;
    const QString json = QStringLiteral("JSON (*.json)"), csv = tr("The list that is open, as CSV (*.csv)");
    QFileDialog dialog(&mWindow, tr("Save Report"), mSettings.lastFolder(), json + QStringLiteral(";;") + csv);
    dialog.setObjectName(QStringLiteral("saveReport"));
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(QStringLiteral("json"));
    connect(&dialog, &QFileDialog::filterSelected, &dialog, [&](const QString &filter) {
        dialog.setDefaultSuffix(filter == json ? QStringLiteral("json") : QStringLiteral("csv"));
    });
    dialog.selectFile(QFileInfo(tab->document().title()).completeBaseName());
    if (dialog.exec() != QDialog::Accepted || dialog.selectedFiles().isEmpty())
        return;
    const QString path = dialog.selectedFiles().constFirst();
    mSaving.start([path, mesh = tab->document().mesh().mesh(), table = tableOf(mDock->currentList())](
                      const model::Progress &progress) { return writeReport(path, *mesh, table, progress); },
                  [this, path](const model::Result<bool> &written) {
                      const QString name = QFileInfo(path).fileName();
                      if (written)
                          mFiles.say(tr("The report is in %1.").arg(name));
                      else
                          mFiles.tell(tr("%1 was not saved.").arg(name), written.error());
                  });
}

} // namespace editor
