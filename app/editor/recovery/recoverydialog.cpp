// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/recovery/recoverydialog.h"

#include "model/io/terrain/recovery.h"
#include "views/dialogs/quantitytext.h"
#include "views/dialogs/terrainpicture.h"

#include <QDialogButtonBox>
#include <QDir>
#include <QLabel>
#include <QListWidget>
#include <QLocale>
#include <QMessageBox>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace editor {

namespace {

constexpr QSize PictureSize(144, 90);

QPixmap emptyPicture(const QWidget &widget)
{
    QPixmap picture(PictureSize * widget.devicePixelRatioF());
    picture.setDevicePixelRatio(widget.devicePixelRatioF());
    picture.fill(widget.palette().color(QPalette::AlternateBase));
    return picture;
}

/// The same where it is selected: else the style tints it.
QIcon iconOf(const QPixmap &picture)
{
    QIcon icon(picture);
    icon.addPixmap(picture, QIcon::Selected);
    return icon;
}

} // namespace

RecoveryDialog::RecoveryDialog(std::vector<Leftover> leftovers, QWidget *parent)
    : QDialog(parent)
    , mLeftovers(std::move(leftovers))
    , mList(new QListWidget(this))
{
    setWindowTitle(tr("Recover Terrains"));
    setObjectName(QStringLiteral("recoveryDialog"));
    resize(620, 420);
    auto *text = new QLabel(tr("Sandreel ended without saving these terrains. They can be opened as they were."), this);
    text->setWordWrap(true);
    mList->setObjectName(QStringLiteral("leftovers"));
    mList->setAccessibleName(tr("Terrains that were not saved"));
    mList->setIconSize(PictureSize);
    mList->setSpacing(4);
    mList->setSelectionMode(QAbstractItemView::ExtendedSelection);
    auto *buttons = new QDialogButtonBox(this);
    mRecover = buttons->addButton(tr("&Recover"), QDialogButtonBox::AcceptRole);
    mRecover->setObjectName(QStringLiteral("recover"));
    mDiscard = buttons->addButton(tr("&Discard…"), QDialogButtonBox::DestructiveRole);
    mDiscard->setObjectName(QStringLiteral("discard"));
    mDiscard->setAutoDefault(false);
    QPushButton *later = buttons->addButton(tr("&Later"), QDialogButtonBox::RejectRole);
    later->setObjectName(QStringLiteral("later"));
    later->setToolTip(tr("They are offered again at the next start"));
    mRecover->setDefault(true);
    auto *column = new QVBoxLayout(this);
    column->addWidget(text);
    column->addWidget(mList, 1);
    column->addWidget(buttons);
    connect(mRecover, &QPushButton::clicked, this, &RecoveryDialog::recoverSelected);
    connect(mDiscard, &QPushButton::clicked, this, &RecoveryDialog::discardSelected);
    connect(later, &QPushButton::clicked, this, &QDialog::reject);
    connect(mList, &QListWidget::itemDoubleClicked, this, &RecoveryDialog::recoverSelected);
    connect(mList, &QListWidget::itemSelectionChanged, this, [this] {
        mRecover->setEnabled(!mList->selectedItems().isEmpty());
        mDiscard->setEnabled(!mList->selectedItems().isEmpty());
    });
    fill();
    drawNext();
}

void RecoveryDialog::fill()
{
    const QPixmap empty = emptyPicture(*this);
    for (const Leftover &leftover : mLeftovers) {
        const QString name = leftover.title.isEmpty() ? tr("Without a name") : leftover.title;
        const QString place =
            leftover.path.isEmpty() ? tr("Never saved to a file") : QDir::toNativeSeparators(leftover.path);
        const QString facts = tr("%1, %2").arg(QLocale().toString(leftover.changed, QLocale::ShortFormat),
                                               views::bytesText(std::uint64_t(leftover.bytes)));
        mList->addItem(new QListWidgetItem(iconOf(empty), QStringList{name, place, facts}.join(QLatin1Char('\n'))));
    }
    mList->selectAll();
}

void RecoveryDialog::drawNext()
{
    const auto next = std::find_if(mLeftovers.begin(), mLeftovers.end(),
                                   [this](const Leftover &leftover) { return !mDrawn.contains(leftover.folder); });
    if (next == mLeftovers.end())
        return;
    mDrawn << next->folder;
    mDrawing.start(
        [journal = next->journals.constFirst(),
         size = PictureSize * devicePixelRatioF()](const model::Progress &progress) -> model::Result<QImage> {
            const auto recovered = model::io::recoverTerrain(journal, progress);
            if (!recovered)
                return model::fail(recovered.error());
            return views::drawTerrain(recovered->terrain, size, progress);
        },
        [this, folder = next->folder](const model::Result<QImage> &drawn) {
            // What cannot be drawn stays without a picture: recovering it says why.
            for (std::size_t row = 0; row < mLeftovers.size() && drawn; ++row)
                if (mLeftovers[row].folder == folder)
                    mList->item(int(row))->setIcon(iconOf(QPixmap::fromImage(*drawn)));
            drawNext();
        });
}

std::vector<int> RecoveryDialog::selectedRows() const
{
    std::vector<int> rows;
    for (int row = mList->count() - 1; row >= 0; --row)
        if (mList->item(row)->isSelected())
            rows.push_back(row);
    return rows;
}

void RecoveryDialog::recoverSelected()
{
    for (const int row : selectedRows()) {
        const Leftover leftover = mLeftovers[std::size_t(row)];
        removeRow(row);
        emit recoverRequested(leftover);
    }
    if (mLeftovers.empty())
        accept();
}

void RecoveryDialog::discardSelected()
{
    const std::vector<int> rows = selectedRows();
    QMessageBox box(QMessageBox::Question, tr("Discard"),
                    tr("%n terrain(s) cannot be recovered any more after this.", nullptr, int(rows.size())),
                    QMessageBox::Cancel, this);
    const QPushButton *discard = box.addButton(tr("Discard"), QMessageBox::DestructiveRole);
    box.setDefaultButton(QMessageBox::Cancel);
    box.exec();
    if (box.clickedButton() != discard)
        return;
    for (const int row : rows) {
        if (const auto entry = RecoveryEntry::adopt(mLeftovers[std::size_t(row)].folder))
            entry->remove();
        removeRow(row);
    }
    if (mLeftovers.empty())
        accept();
}

void RecoveryDialog::removeRow(int row)
{
    delete mList->takeItem(row);
    mLeftovers.erase(mLeftovers.begin() + row);
}

} // namespace editor
