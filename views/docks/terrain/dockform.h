// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QDockWidget;
class QFormLayout;
class QLabel;
class QWidget;

namespace views {

class NumberField;

/// Makes `content` the dock's widget, with a scroll bar where it is too tall and never too narrow for it. The one
/// before is deleted.
void setScrolledWidget(QDockWidget &dock, QWidget *content);
/// A row whose label names the editor for screen readers too. \param unit  shown behind it
void addRow(QFormLayout &form, const QString &label, QWidget *editor, const QString &unit = {});
/// A row that only says something.
QLabel *addFact(QFormLayout &form, const QString &label);
void setRowVisible(QWidget *editor, bool isVisible);
/// Deletes all rows; the widgets live until the event that called has been handled.
void clearForm(QFormLayout &form);
/// Shows a value, but leaves what is being typed as it was typed.
void showNumber(NumberField &field, double value);

} // namespace views
