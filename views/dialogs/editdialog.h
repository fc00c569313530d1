// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/animation/animationcontext.h"

#include <QDialog>

class QFormLayout;
class QPushButton;
class QVBoxLayout;

namespace views {

class HintLabel;

/// What the dialogs that change an animation have in common: a form, a line for what the change will do or why it
/// cannot be done, a button named after the change, and Cancel. Changes the document once, when it is accepted, with
/// one command. Closes by itself if the document does.
class EditDialog : public QDialog
{
    Q_OBJECT

public:
    void accept() override;

protected:
    /// \param action  the text of the button: "Trim"
    EditDialog(commands::AnimationContext &context, const QString &title, const QString &action, QWidget *parent);

    commands::AnimationContext &context() { return mContext; }
    const model::AnimationDocument &document() const { return mContext.document(); }
    QFormLayout &form() { return *mForm; }
    /// Between the form and the buttons.
    QVBoxLayout &column() { return *mColumn; }
    QPushButton &acceptButton() { return *mAccept; }

    /// To be called when a field changed.
    void refresh();
    void showFailure(const QString &text);

    /// Why it cannot be done, as a sentence; empty if it can.
    virtual QString problem() const = 0;
    /// What it will do, as "201 → 402 frames". Called only without a problem.
    virtual QString consequence() const { return {}; }
    /// Pushes the command. Returns false if that comes later: then accept() must be called again.
    virtual bool apply() = 0;

private:
    commands::AnimationContext &mContext;
    QVBoxLayout *mColumn;
    QFormLayout *mForm;
    HintLabel *mHint;
    QPushButton *mAccept;
};

} // namespace views
