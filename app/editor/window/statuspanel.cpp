// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/window/statuspanel.h"

#include "app/editor/documents/animationtab.h"
#include "app/editor/documents/meshtab.h"
#include "app/editor/documents/terraintab.h"
#include "app/editor/window/workspace.h"
#include "views/dialogs/quantitytext.h"
#include "views/terrain/groundinteraction.h"

#include <QLabel>
#include <QLocale>
#include <QStatusBar>

namespace editor {

namespace {

constexpr int MessageMilliseconds = 6000;

} // namespace

StatusPanel::StatusPanel(QStatusBar &bar, Workspace &workspace)
    : mBar(bar)
    , mWorkspace(workspace)
    , mHint(new QLabel(&bar))
    , mNumbers(new QLabel(&bar))
{
    mHint->setContentsMargins(6, 0, 6, 0);
    mNumbers->setContentsMargins(6, 0, 6, 0);
    mNumbers->setObjectName(QStringLiteral("statusNumbers"));
    bar.addWidget(mHint, 1);
    bar.addPermanentWidget(mNumbers);
    connect(&workspace, &Workspace::currentChanged, this, &StatusPanel::follow);
    connect(&workspace, &Workspace::currentStateChanged, this, &StatusPanel::follow);
    follow();
}

void StatusPanel::follow()
{
    disconnect(mChanges);
    if (const AnimationTab *tab = mWorkspace.currentAnimation(); tab && tab->document().isOpen())
        mChanges = connect(&tab->document().context()->document(), &model::AnimationDocument::changed, this,
                           &StatusPanel::update);
    if (const TerrainTab *tab = mWorkspace.currentTerrain(); tab && tab->document().isOpen())
        mChanges = connect(&tab->document().terrain(), &model::TerrainDocument::changed, this, &StatusPanel::update);
    if (const MeshTab *tab = mWorkspace.currentMesh(); tab && tab->document().isOpen())
        mChanges = connect(&tab->document().mesh(), &model::MeshDocument::changed, this, &StatusPanel::update);
    update();
}

void StatusPanel::showMesh(const MeshTab &tab)
{
    const QLocale locale;
    const model::PolygonMesh &mesh = *tab.document().mesh().mesh();
    QStringList parts{
        tr("V %1", "number of vertices").arg(locale.toString(qulonglong(mesh.positions.size()))),
        tr("F %1", "number of faces").arg(locale.toString(mesh.faces.faceCount())),
    };
    if (tab.document().fileBytes() > 0)
        parts << views::bytesText(tab.document().fileBytes());
    mNumbers->setVisible(true);
    mNumbers->setText(parts.join(QStringLiteral("   ")));
    mNumbers->setToolTip(tr("Vertices, faces, size of the file"));
    mHint->setText(tab.view() ? tr("Click: pick   Drag: orbit   Shift+drag: pan   Wheel: zoom") : QString());
}

void StatusPanel::update()
{
    if (const TerrainTab *tab = mWorkspace.currentTerrain(); tab && tab->document().isOpen()) {
        showTerrain(tab->document());
        return;
    }
    if (const MeshTab *tab = mWorkspace.currentMesh(); tab && tab->document().isOpen()) {
        showMesh(*tab);
        return;
    }
    const AnimationTab *tab = mWorkspace.currentAnimation();
    const bool open = tab && tab->document().isOpen();
    mNumbers->setVisible(open);
    if (!open) {
        mHint->setText(
            mWorkspace.current()
                ? QString()
                : tr("Drop an animation, a terrain, a folder of meshes, a scene or an elevation model here"));
        return;
    }
    mHint->setText(tab->viewport() ? tr("Drag: orbit   Shift+drag: pan   Wheel: zoom   Space: play") : QString());
    const model::AnimationDocument &document = tab->document().context()->document();
    const QLocale locale;
    QStringList parts{
        tr("V %1", "number of vertices").arg(locale.toString(document.vertexCount())),
        tr("T %1", "number of triangles").arg(locale.toString(qulonglong(document.connectivity().triangles.size()))),
        tr("F %1", "number of frames").arg(locale.toString(document.frameCount())),
        tr("%1 fps").arg(locale.toString(document.timing().frameRate, 'g', 5)),
    };
    if (const auto &facts = tab->document().fileFacts())
        parts << views::bytesText(facts->bytes);
    mNumbers->setText(parts.join(QStringLiteral("   ")));
    mNumbers->setToolTip(tr("Vertices, triangles, frames, frame rate, size of the file"));
}

void StatusPanel::showTerrain(const OpenTerrain &document)
{
    const QLocale locale;
    const model::terrain::Tin &tin = document.terrain().tin();
    const model::terrain::Rectangle domain = tin.domain();
    QStringList parts{
        tr("V %1", "number of vertices").arg(locale.toString(tin.vertexCount())),
        tr("T %1", "number of triangles").arg(locale.toString(tin.triangleCount())),
        tr("%1 × %2 m")
            .arg(locale.toString(domain.high.x - domain.low.x, 'g', 6),
                 locale.toString(domain.high.y - domain.low.y, 'g', 6)),
    };
    if (document.fileBytes() > 0)
        parts << views::bytesText(document.fileBytes());
    mNumbers->setVisible(true);
    mNumbers->setText(parts.join(QStringLiteral("   ")));
    mNumbers->setToolTip(tr("Vertices, triangles, width and depth, size of the file"));
    mHint->setText(readingText());
}

void StatusPanel::showReading(const std::optional<views::GroundReading> &reading)
{
    mReading = reading;
    const TerrainTab *const tab = mWorkspace.currentTerrain();
    if (!tab)
        return;
    mHint->setText(readingText());
    // Screen readers say what has changed about the widget with the focus.
    if (auto *const ground = dynamic_cast<QWidget *>(tab->ground()); ground && reading && reading->isByKeys)
        ground->setAccessibleDescription(readingText());
}

void StatusPanel::showMessage(const QString &text)
{
    mBar.showMessage(text, MessageMilliseconds);
}

QString StatusPanel::readingText() const
{
    if (!mReading)
        return tr("Drag: draw   Right drag: orbit   Wheel: zoom   F: radius   Shift+F: strength");
    const QLocale locale;
    const auto metres = [&](double value) { return locale.toString(value, 'f', 2); };
    QStringList parts{tr("x %1 m   y %2 m   height %3 m")
                          .arg(metres(mReading->point.x), metres(mReading->point.y), metres(mReading->point.z)),
                      tr("slope %1°").arg(locale.toString(mReading->slope, 'f', 1))};
    if (!mReading->material.isEmpty())
        parts << mReading->material;
    if (mReading->humidity)
        parts << tr("humidity %1").arg(views::percentText(100 * double(*mReading->humidity)));
    return parts.join(QStringLiteral("   "));
}

} // namespace editor
