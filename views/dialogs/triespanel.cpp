// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/dialogs/triespanel.h"

#include "views/dialogs/compressionfields.h"
#include "views/dialogs/normalisationchoice.h"
#include "views/dialogs/quantitytext.h"
#include "views/dialogs/showinfolder.h"

#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

#include <cmath>

namespace views {

namespace {

enum Column { Settings, Size, Ratio, Bits, KgError, LargestError, Time, ColumnCount };

qint64 timeStamp(const QString &path)
{
    return QFileInfo(path).lastModified().toMSecsSinceEpoch();
}

QString ratioText(const EncodingReport &report)
{
    return QStringLiteral("%1 : 1").arg(numberText(double(report.rawBytes) / double(report.fileBytes), 1));
}

double largestErrorPercent(const model::ComparisonResult &errors)
{
    return errors.diagonal > 0 ? 100 * errors.maxVertexError / errors.diagonal : 0;
}

QString psnrText(double decibel)
{
    return std::isinf(decibel) ? QStringLiteral("∞ dB") : QStringLiteral("%1 dB").arg(numberText(decibel, 1));
}

} // namespace

TriesPanel::TriesPanel(QWidget *parent)
    : QWidget(parent)
    , mTable(new QTableWidget(0, ColumnCount, this))
    , mSummary(new QLabel(this))
    , mOpen(new QPushButton(tr("&Open"), this))
    , mShowInFolder(new QPushButton(tr("Show in &Folder"), this))
{
    mTable->setObjectName(QStringLiteral("tries"));
    mTable->setAccessibleName(tr("Encodings made so far"));
    mTable->setHorizontalHeaderLabels(
        {tr("Settings"), tr("Size"), tr("Raw : Size"), tr("bpfv"), tr("KG Error"), tr("Largest Error"), tr("Time")});
    mTable->horizontalHeaderItem(Bits)->setToolTip(tr("Bits per frame and vertex"));
    mTable->horizontalHeaderItem(KgError)->setToolTip(tr("Error of Karni and Gotsman, per cent"));
    mTable->horizontalHeaderItem(LargestError)
        ->setToolTip(tr("Largest distance of a vertex, in per cent of the animation's diagonal"));
    mTable->setEditTriggers(QAbstractItemView::NoEditTriggers);
    mTable->setSelectionBehavior(QAbstractItemView::SelectRows);
    mTable->setSelectionMode(QAbstractItemView::SingleSelection);
    mTable->setTabKeyNavigation(false);
    mTable->setWordWrap(false);
    mTable->verticalHeader()->hide();
    mTable->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 8);
    mTable->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    mTable->horizontalHeader()->setSectionResizeMode(Settings, QHeaderView::Stretch);
    mTable->setMinimumHeight(mTable->horizontalHeader()->sizeHint().height() +
                             3 * mTable->verticalHeader()->defaultSectionSize());

    mSummary->setObjectName(QStringLiteral("resultSummary"));
    mSummary->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    mSummary->setWordWrap(true);
    auto *again = new QPushButton(tr("Encode &Again with Other Settings"), this);
    mOpen->setObjectName(QStringLiteral("openResult"));
    mShowInFolder->setObjectName(QStringLiteral("showInFolder"));
    again->setObjectName(QStringLiteral("encodeAgain"));
    for (QPushButton *button : {mOpen, mShowInFolder, again})
        button->setAutoDefault(false);

    auto *buttons = new QHBoxLayout;
    buttons->addWidget(mOpen);
    buttons->addWidget(mShowInFolder);
    buttons->addWidget(again);
    buttons->addStretch(1);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(mTable, 1);
    column->addWidget(mSummary);
    column->addLayout(buttons);

    connect(mTable, &QTableWidget::itemSelectionChanged, this, &TriesPanel::showSelected);
    connect(again, &QPushButton::clicked, this, &TriesPanel::encodeAgainRequested);
    connect(mOpen, &QPushButton::clicked, this, [this] {
        const EncodingReport report = mTries[std::size_t(mTable->currentRow())].report;
        emit openRequested(report.order.output, report.original);
    });
    connect(mShowInFolder, &QPushButton::clicked, this,
            [this] { views::showInFolder(mTries[std::size_t(mTable->currentRow())].report.order.output); });
    showSelected();
}

void TriesPanel::add(const EncodingReport &report)
{
    mTries.push_back({report, timeStamp(report.order.output)});
    const int row = mTable->rowCount();
    mTable->insertRow(row);
    const QString texts[ColumnCount] = {CompressionFields::summary(report.order.settings) + QStringLiteral(", ") +
                                            normalisationText(report.order.normalisation),
                                        bytesText(report.fileBytes),
                                        ratioText(report),
                                        numberText(report.bitsPerFrameAndVertex, 3),
                                        percentText(report.errors.kgErrorPercent),
                                        percentText(largestErrorPercent(report.errors)),
                                        durationText(report.encodingSeconds)};
    for (int column = 0; column < ColumnCount; ++column) {
        auto *item = new QTableWidgetItem(texts[column]);
        if (column != Settings)
            item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
        mTable->setItem(row, column, item);
    }
    mTable->item(row, Settings)->setToolTip(report.order.output);
    mTable->setCurrentCell(row, Settings);
    mTable->scrollToItem(mTable->item(row, Settings));
    showSelected();
}

void TriesPanel::clear()
{
    mTable->setRowCount(0);
    mTries.clear();
    showSelected();
}

bool TriesPanel::hasWritten(const QString &path) const
{
    const int row = newestFor(path);
    return row >= 0 && QFileInfo::exists(path) && timeStamp(path) == mTries[std::size_t(row)].writtenAt &&
           quint64(QFileInfo(path).size()) == mTries[std::size_t(row)].report.fileBytes;
}

int TriesPanel::newestFor(const QString &path) const
{
    for (int row = int(mTries.size()) - 1; row >= 0; --row)
        if (mTries[std::size_t(row)].report.order.output == path)
            return row;
    return -1;
}

void TriesPanel::showSelected()
{
    const int row = mTable->currentRow();
    const bool isAny = row >= 0 && row < int(mTries.size());
    mShowInFolder->setEnabled(isAny);
    if (!isAny) {
        mSummary->clear();
        mOpen->setEnabled(false);
        return;
    }
    const EncodingReport &report = mTries[std::size_t(row)].report;
    const model::ComparisonResult &errors = report.errors;
    const QString file = QDir::toNativeSeparators(report.order.output);
    const bool isThere = newestFor(report.order.output) == row;
    mOpen->setEnabled(isThere);
    mOpen->setToolTip(isThere ? QString() : tr("A later try has replaced the file"));
    mSummary->setText((isThere ? tr("<b>%1</b>").arg(file.toHtmlEscaped())
                               : tr("<b>%1</b> (replaced by a later try)").arg(file.toHtmlEscaped())) +
                      QStringLiteral("<br>") +
                      tr("%1 from %2 raw (%3), %4 bits per frame and vertex, encoded in %5")
                          .arg(bytesText(report.fileBytes), bytesText(report.rawBytes), ratioText(report),
                               numberText(report.bitsPerFrameAndVertex, 3), durationText(report.encodingSeconds)) +
                      QStringLiteral("<br>") +
                      tr("KG error %1, RMSE %2, PSNR %3, largest vertex error %4 (%5 of the diagonal, in frame %6)")
                          .arg(percentText(errors.kgErrorPercent), significantText(errors.rmse),
                               psnrText(errors.psnrDb), significantText(errors.maxVertexError),
                               percentText(largestErrorPercent(errors)), countText(errors.worstFrame + 1)));
}

} // namespace views
