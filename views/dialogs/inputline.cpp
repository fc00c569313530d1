// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/dialogs/inputline.h"

#include <QEvent>
#include <QPainter>

namespace views {

QColor refusalColour(const QPalette &palette)
{
    const bool isDark = palette.color(QPalette::Window).lightness() < 128;
    return isDark ? QColor(255, 138, 128) : QColor(179, 38, 30);
}

void InputLine::setRefused(bool refused)
{
    if (mRefused == refused)
        return;
    mRefused = refused;
    update();
}

void InputLine::paintEvent(QPaintEvent *event)
{
    QLineEdit::paintEvent(event);
    if (!mRefused)
        return;
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(refusalColour(palette()), 2));
    painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 2, 2);
}

HintLabel::HintLabel(QWidget *parent)
    : QLabel(parent)
{
    setTextFormat(Qt::PlainText); // the text may hold file names
    applyColour();
}

void HintLabel::showHint(const QString &text)
{
    mRefusal = false;
    setText(text);
    setTextInteractionFlags(Qt::NoTextInteraction);
    applyColour();
}

void HintLabel::showRefusal(const QString &text)
{
    mRefusal = true;
    setText(text);
    setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    applyColour();
}

void HintLabel::changeEvent(QEvent *event)
{
    QLabel::changeEvent(event);
    // Not PaletteChange: that is what applyColour() causes.
    if (event->type() == QEvent::ApplicationPaletteChange || event->type() == QEvent::StyleChange)
        applyColour();
}

void HintLabel::applyColour()
{
    setPalette(QPalette()); // back to the inherited one, which may be of a new theme
    QPalette colours = palette();
    QColor colour = colours.color(QPalette::WindowText);
    if (mRefusal)
        colour = refusalColour(colours);
    else
        colour.setAlphaF(0.65f);
    colours.setColor(QPalette::WindowText, colour);
    setPalette(colours);
}

} // namespace views
