// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/window/workspace.h"

#include "app/editor/documents/documenttab.h"
#include "app/editor/window/tabicon.h"

#include <QDir>
#include <QEvent>
#include <QMouseEvent>
#include <QStackedWidget>
#include <QTabBar>
#include <QTabWidget>
#include <QVBoxLayout>

namespace editor {

Workspace::Workspace(QWidget *welcome, QWidget *parent)
    : QWidget(parent)
    , mMessages(new views::MessageBar(this))
    , mStack(new QStackedWidget(this))
    , mTabs(new QTabWidget(this))
{
    mTabs->setObjectName(QStringLiteral("documentTabs"));
    mTabs->setDocumentMode(true);
    mTabs->setMovable(true);
    mTabs->setTabsClosable(true);
    mTabs->setElideMode(Qt::ElideMiddle);
    mTabs->setUsesScrollButtons(true);
    mTabs->tabBar()->setExpanding(false);
    mTabs->tabBar()->installEventFilter(this);
    connect(mTabs, &QTabWidget::currentChanged, this, &Workspace::currentChanged);
    connect(mTabs, &QTabWidget::tabCloseRequested, this, [this](int index) { emit closeRequested(*at(index)); });

    mStack->addWidget(welcome);
    mStack->addWidget(mTabs);

    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(mMessages);
    layout->addWidget(mStack, 1);
    retranslate();
}

void Workspace::add(DocumentTab *tab)
{
    mTabs->addTab(tab, QString());
    connect(&tab->document(), &Document::stateChanged, this, [this, tab] { showState(*tab); });
    connect(&tab->document(), &Document::opened, this, [this, tab] { showState(*tab); });
    connect(&tab->document().openingJob(), &views::Job::progressed, this, [this, tab] { showState(*tab); });
    connect(&tab->document().savingJob(), &views::Job::progressed, this, [this, tab] { showState(*tab); });
    showState(*tab);
    mStack->setCurrentIndex(1);
    mTabs->setCurrentWidget(tab);
}

void Workspace::remove(DocumentTab &tab)
{
    disconnect(&tab.document(), nullptr, this, nullptr);
    mTabs->removeTab(mTabs->indexOf(&tab));
    if (mTabs->count() == 0)
        mStack->setCurrentIndex(0);
    tab.deleteLater();
}

void Workspace::activate(DocumentTab &tab)
{
    mTabs->setCurrentWidget(&tab);
}

void Workspace::showNeighbour(int offset)
{
    const int count = mTabs->count();
    if (count > 0)
        mTabs->setCurrentIndex((mTabs->currentIndex() + offset + count) % count);
}

DocumentTab *Workspace::current() const
{
    return at(mTabs->currentIndex());
}

AnimationTab *Workspace::currentAnimation() const
{
    return asAnimation(current());
}

TerrainTab *Workspace::currentTerrain() const
{
    return asTerrain(current());
}

MeshTab *Workspace::currentMesh() const
{
    return asMesh(current());
}

std::vector<DocumentTab *> Workspace::tabs() const
{
    std::vector<DocumentTab *> result;
    for (int i = 0; i < mTabs->count(); ++i)
        result.push_back(at(i));
    return result;
}

DocumentTab *Workspace::at(int index) const
{
    return qobject_cast<DocumentTab *>(mTabs->widget(index));
}

void Workspace::showState(DocumentTab &tab)
{
    const int index = mTabs->indexOf(&tab);
    if (index < 0)
        return;
    Document &document = tab.document();
    QString title = document.title();
    title.replace(QLatin1Char('&'), QLatin1String("&&"));
    mTabs->setTabText(index, title);
    mTabs->setTabIcon(index, tabIcon(document));
    QString tip = document.path().isEmpty() ? document.origin() : QDir::toNativeSeparators(document.path());
    if (document.isModified())
        tip += QLatin1Char('\n') + tr("Has unsaved changes");
    mTabs->setTabToolTip(index, tip);
    if (&tab == current())
        emit currentStateChanged();
}

void Workspace::changeEvent(QEvent *event)
{
    if (event->type() == QEvent::LanguageChange) {
        retranslate();
        for (DocumentTab *tab : tabs())
            showState(*tab);
    }
    QWidget::changeEvent(event);
}

void Workspace::retranslate()
{
    mTabs->setAccessibleName(tr("Open documents"));
    mTabs->tabBar()->setAccessibleName(tr("Open documents"));
}

bool Workspace::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::MouseButtonRelease) {
        const auto *mouse = static_cast<QMouseEvent *>(event);
        const int index = mTabs->tabBar()->tabAt(mouse->position().toPoint());
        if (mouse->button() == Qt::MiddleButton && index >= 0) {
            emit closeRequested(*at(index));
            return true;
        }
    }
    return QWidget::eventFilter(watched, event);
}

} // namespace editor
