// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/window/theme.h"

#include "views/widgets/icons.h"

#include <QApplication>
#include <QDockWidget>
#include <QPainter>
#include <QProxyStyle>
#include <QStyleOption>

namespace editor {

namespace {

/// The few colours that a theme is made of; everything else follows from them.
struct Colours
{
    QColor window;
    QColor base;
    QColor alternate;
    QColor button;
    QColor text;
    QColor faint; ///< disabled text
    QColor placeholder;
    QColor accent; ///< selection
    QColor onAccent;
    QColor link; ///< accent on the window's colour; icons use it
    QColor tip;
    QColor light;
    QColor midlight;
    QColor mid;
    QColor dark;
    QColor shadow;
};

QPalette paletteOf(const Colours &c)
{
    QPalette palette;
    palette.setColor(QPalette::Window, c.window);
    palette.setColor(QPalette::Base, c.base);
    palette.setColor(QPalette::AlternateBase, c.alternate);
    palette.setColor(QPalette::Button, c.button);
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::ToolTipText}) {
        palette.setColor(role, c.text);
        palette.setColor(QPalette::Disabled, role, c.faint);
    }
    palette.setColor(QPalette::BrightText, Qt::white);
    palette.setColor(QPalette::PlaceholderText, c.placeholder);
    palette.setColor(QPalette::Highlight, c.accent);
    palette.setColor(QPalette::HighlightedText, c.onAccent);
    palette.setColor(QPalette::Disabled, QPalette::Highlight, c.mid);
    palette.setColor(QPalette::Disabled, QPalette::HighlightedText, c.faint);
    palette.setColor(QPalette::Link, c.link);
    palette.setColor(QPalette::LinkVisited, c.link);
    palette.setColor(QPalette::ToolTipBase, c.tip);
    palette.setColor(QPalette::Light, c.light);
    palette.setColor(QPalette::Midlight, c.midlight);
    palette.setColor(QPalette::Mid, c.mid);
    palette.setColor(QPalette::Dark, c.dark);
    palette.setColor(QPalette::Shadow, c.shadow);
    return palette;
}

/// Fusion with our own small pictures where it has ones that fit no theme.
class Style final : public QProxyStyle
{
public:
    Style()
        : QProxyStyle(QStringLiteral("Fusion"))
    {}

    int styleHint(StyleHint hint, const QStyleOption *option, const QWidget *widget,
                  QStyleHintReturn *returned) const override
    {
        // Fusion's pictures of a cross and a tick are small bitmaps, and hardly to be seen on a dark button.
        return hint == SH_DialogButtonBox_ButtonsHaveIcons ? 0 : QProxyStyle::styleHint(hint, option, widget, returned);
    }

    void drawPrimitive(PrimitiveElement element, const QStyleOption *option, QPainter *painter,
                       const QWidget *widget) const override
    {
        if (element != PE_IndicatorTabClose) {
            QProxyStyle::drawPrimitive(element, option, painter, widget);
            return;
        }
        if (option->state & State_MouseOver) {
            QColor back = option->palette.color(QPalette::WindowText);
            back.setAlpha(option->state & State_Sunken ? 60 : 30);
            painter->setRenderHint(QPainter::Antialiasing);
            painter->setPen(Qt::NoPen);
            painter->setBrush(back);
            painter->drawRoundedRect(option->rect, 3, 3);
        }
        mClose.paint(painter, option->rect.adjusted(2, 2, -2, -2));
    }

    QIcon standardIcon(StandardPixmap pixmap, const QStyleOption *option, const QWidget *widget) const override
    {
        if (qobject_cast<const QDockWidget *>(widget) && pixmap == SP_TitleBarCloseButton)
            return mClose;
        if (qobject_cast<const QDockWidget *>(widget) && pixmap == SP_TitleBarNormalButton)
            return mFloat;
        return QProxyStyle::standardIcon(pixmap, option, widget);
    }

private:
    const QIcon mClose = views::icon(QStringLiteral("close"));
    const QIcon mFloat = views::icon(QStringLiteral("float"));
};

bool systemIsDark()
{
    // Asked once, before our own palette takes the place of the platform's.
    static const bool dark = QApplication::palette().color(QPalette::Window).lightness() < 128;
    return dark;
}

} // namespace

QPalette lightPalette()
{
    return paletteOf({.window = 0xf3f2f0,
                      .base = 0xffffff,
                      .alternate = 0xf8f7f5,
                      .button = 0xf7f6f4,
                      .text = 0x23262b,
                      .faint = 0xa3a19d,
                      .placeholder = 0x85827d,
                      .accent = 0xa5661c,
                      .onAccent = 0xffffff,
                      .link = 0x9a5b12,
                      .tip = 0xfffdf8,
                      .light = 0xffffff,
                      .midlight = 0xeae8e5,
                      .mid = 0xc9c6c1,
                      .dark = 0xa8a49e,
                      .shadow = 0x6f6b65});
}

QPalette darkPalette()
{
    return paletteOf({.window = 0x25282d,
                      .base = 0x1c1f23,
                      .alternate = 0x22252a,
                      .button = 0x30343a,
                      .text = 0xe4e2de,
                      .faint = 0x73767b,
                      .placeholder = 0x8b8e93,
                      .accent = 0xd9a452,
                      .onAccent = 0x1b1813,
                      .link = 0xe3b266,
                      .tip = 0x33373d,
                      .light = 0x3c4148,
                      .midlight = 0x353a41,
                      .mid = 0x1f2226,
                      .dark = 0x17191c,
                      .shadow = 0x0c0d0f});
}

void applyTheme(Theme theme)
{
    const bool dark = theme == Theme::Dark || (systemIsDark() && theme == Theme::System);
    if (!dynamic_cast<Style *>(QApplication::style()))
        QApplication::setStyle(new Style);
    QApplication::setPalette(dark ? darkPalette() : lightPalette());
}

} // namespace editor
