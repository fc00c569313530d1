// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/documents/documenttab.h"

#include <QEvent>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QStackedLayout>
#include <QVBoxLayout>

namespace editor {

namespace {

constexpr int ProgressSteps = 1000;

QLabel *makeTitle(QWidget *parent)
{
    auto *label = new QLabel(parent);
    QFont font = label->font();
    font.setPointSizeF(font.pointSizeF() * 1.25);
    label->setFont(font);
    label->setAlignment(Qt::AlignCenter);
    return label;
}

} // namespace

DocumentTab::DocumentTab(std::unique_ptr<Document> document, QWidget *parent)
    : QWidget(parent)
    , mDocument(std::move(document))
    , mPages(new QStackedLayout(this))
{
    mPages->addWidget(makeOpeningPage());
    connect(mDocument.get(), &Document::opened, this, &DocumentTab::showDocument);
    connect(mDocument.get(), &Document::stateChanged, this, &DocumentTab::retranslate);
    connect(&mDocument->openingJob(), &views::Job::progressed, this,
            [this](double fraction) { mOpeningBar->setValue(int(fraction * ProgressSteps)); });
    retranslate();
}

QWidget *DocumentTab::makeOpeningPage()
{
    auto *page = new QWidget(this);
    auto *layout = new QVBoxLayout(page);
    mOpeningTitle = makeTitle(page);
    mOpeningBar = new QProgressBar(page);
    mOpeningBar->setRange(0, ProgressSteps);
    mOpeningBar->setTextVisible(false);
    mOpeningBar->setFixedWidth(320);
    mCancel = new QPushButton(page);
    mCancel->setObjectName(QStringLiteral("cancelOpening"));
    connect(mCancel, &QPushButton::clicked, mDocument.get(), &Document::cancelOpening);
    layout->addStretch();
    layout->addWidget(mOpeningTitle, 0, Qt::AlignHCenter);
    layout->addSpacing(8);
    layout->addWidget(mOpeningBar, 0, Qt::AlignHCenter);
    layout->addSpacing(8);
    layout->addWidget(mCancel, 0, Qt::AlignHCenter);
    layout->addStretch();
    return page;
}

void DocumentTab::showDocument()
{
    QWidget *shown = page();
    if (mPages->indexOf(shown) < 0)
        mPages->addWidget(shown);
    mPages->setCurrentWidget(shown);
}

void DocumentTab::changeEvent(QEvent *event)
{
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QWidget::changeEvent(event);
}

void DocumentTab::retranslate()
{
    mOpeningTitle->setText(tr("Opening %1…").arg(mDocument->title()));
    mOpeningBar->setAccessibleName(tr("Progress of opening"));
    mCancel->setText(tr("Cancel"));
}

} // namespace editor
