// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/widgets/messagebar.h"

#include "views/widgets/icons.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>

namespace views {

namespace {

constexpr int NoteMilliseconds = 6000;

/// The colour of the strip at the left, readable on both themes; the icon says the same without colour.
QColor stripColour(MessageBar::Kind kind)
{
    switch (kind) {
    case MessageBar::Kind::Note:
        return QColor(0x4a, 0x90, 0xb8);
    case MessageBar::Kind::Warning:
        return QColor(0xd9, 0x9a, 0x2b);
    case MessageBar::Kind::Error:
        return QColor(0xc8, 0x4b, 0x42);
    }
    return {};
}

QString iconName(MessageBar::Kind kind)
{
    switch (kind) {
    case MessageBar::Kind::Note:
        return QStringLiteral("info");
    case MessageBar::Kind::Warning:
        return QStringLiteral("warning");
    case MessageBar::Kind::Error:
        return QStringLiteral("error");
    }
    return {};
}

class MessageRow final : public QWidget
{
public:
    MessageRow(MessageBar::Kind kind, const QString &text, QWidget *parent)
        : QWidget(parent)
        , mKind(kind)
        , mText(new QLabel(text, this))
    {
        auto *picture = new QToolButton(this); // a button repaints its icon when the palette changes
        picture->setIcon(icon(iconName(kind)));
        picture->setAutoRaise(true);
        picture->setFocusPolicy(Qt::NoFocus);
        picture->setAttribute(Qt::WA_TransparentForMouseEvents);
        mText->setTextFormat(Qt::PlainText); // names of files come in here
        mText->setWordWrap(true);
        mText->setTextInteractionFlags(Qt::TextSelectableByMouse);
        auto *close = new QToolButton(this);
        close->setIcon(icon(QStringLiteral("close")));
        close->setAutoRaise(true);
        close->setObjectName(QStringLiteral("closeMessage"));
        close->setToolTip(MessageBar::tr("Dismiss"));
        close->setAccessibleName(MessageBar::tr("Dismiss Message"));
        connect(close, &QToolButton::clicked, this, &QObject::deleteLater);
        auto *layout = new QHBoxLayout(this);
        layout->setContentsMargins(12, 4, 6, 4);
        layout->addWidget(picture, 0, Qt::AlignTop);
        layout->addWidget(mText, 1, Qt::AlignVCenter);
        layout->addWidget(close, 0, Qt::AlignTop);
    }

    QString text() const { return mText->text(); }

protected:
    void paintEvent(QPaintEvent *) override
    {
        QPainter painter(this);
        QColor tint = stripColour(mKind);
        tint.setAlpha(36);
        painter.fillRect(rect(), palette().color(QPalette::Base));
        painter.fillRect(rect(), tint);
        painter.fillRect(QRect(0, 0, 4, height()), stripColour(mKind));
        painter.fillRect(QRect(0, height() - 1, width(), 1), palette().color(QPalette::Mid));
    }

private:
    const MessageBar::Kind mKind;
    QLabel *mText;
};

} // namespace

MessageBar::MessageBar(QWidget *parent)
    : QWidget(parent)
    , mRows(new QVBoxLayout(this))
{
    mRows->setContentsMargins(0, 0, 0, 0);
    mRows->setSpacing(0);
}

void MessageBar::add(Kind kind, const QString &text)
{
    while (mRows->count() >= MaxMessages)
        delete mRows->itemAt(0)->widget();
    auto *row = new MessageRow(kind, text, this);
    mRows->addWidget(row);
    if (kind == Kind::Note)
        QTimer::singleShot(NoteMilliseconds, row, &QObject::deleteLater);
}

QStringList MessageBar::texts() const
{
    QStringList result;
    for (int i = 0; i < mRows->count(); ++i)
        result << static_cast<MessageRow *>(mRows->itemAt(i)->widget())->text();
    return result;
}

void MessageBar::clear()
{
    while (mRows->count() > 0)
        delete mRows->itemAt(0)->widget();
}

} // namespace views
