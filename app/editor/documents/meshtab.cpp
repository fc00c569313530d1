// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/documents/meshtab.h"

#include "views/inspect/meshview.h"

#include <QEvent>
#include <QLabel>

namespace editor {

MeshTab::MeshTab(bool canDraw, QWidget *parent)
    : DocumentTab(std::make_unique<OpenMesh>(), parent)
    , mCanDraw(canDraw)
{}

QWidget *MeshTab::page()
{
    if (mPage)
        return mPage;
    if (mCanDraw) {
        mPage = mView = new views::MeshView(this);
        mView->setInspection(&document().inspection());
    } else {
        mPage = mMessage = new QLabel(this);
        mMessage->setAlignment(Qt::AlignCenter);
        mMessage->setWordWrap(true);
        retranslate();
    }
    return mPage;
}

void MeshTab::changeEvent(QEvent *event)
{
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    DocumentTab::changeEvent(event);
}

void MeshTab::retranslate()
{
    if (mMessage)
        mMessage->setText(
            tr("This machine has no OpenGL 3.3, so the mesh cannot be drawn. The inspector lists what it is "
               "made of all the same."));
}

} // namespace editor
