// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>
#include <QLineEdit>

namespace views {

/// A line of input that shows when its text is refused: a red frame drawn over whatever the style draws.
class InputLine final : public QLineEdit
{
    Q_OBJECT

public:
    using QLineEdit::QLineEdit;

    bool isRefused() const { return mRefused; }
    void setRefused(bool refused);

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    bool mRefused = false;
};

/// A remark beside or below an input: quiet, or the reason of a refusal or failure (then in the refusal's colour, and
/// selectable, so that it can be copied). Follows the theme.
class HintLabel final : public QLabel
{
    Q_OBJECT

public:
    explicit HintLabel(QWidget *parent = nullptr);

    void showHint(const QString &text);
    void showRefusal(const QString &text);

protected:
    void changeEvent(QEvent *event) override;

private:
    void applyColour();

    bool mRefusal = false;
};

/// The red that is readable on the palette's window colour.
QColor refusalColour(const QPalette &palette);

} // namespace views
