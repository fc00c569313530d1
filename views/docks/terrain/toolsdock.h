// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/sculpt/toolfields.h"
#include "views/sculpt/toolsettings.h"

#include <QDockWidget>

#include <functional>

class QButtonGroup;
class QComboBox;
class QFormLayout;
class QGroupBox;
class QPushButton;

namespace views {

/// The tools of a terrain: which one draws, its settings, ready-made ones, where it is mirrored and where it works.
class ToolsDock final : public QDockWidget
{
    Q_OBJECT

public:
    explicit ToolsDock(ToolSettings &settings, QWidget *parent = nullptr);
    ~ToolsDock() override;

signals:
    /// The user takes the ground as it is now for the reference.
    void referenceRequested();

protected:
    void changeEvent(QEvent *event) override;

private:
    void build();
    QWidget *makeTools(QWidget *parent);
    QWidget *makeSymmetry(QWidget *parent);
    void makeForm();
    void fillForm(QFormLayout &form, const std::vector<ToolField> &fields);
    void show();
    void showSymmetry();
    void takeSymmetry();
    void applyPreset(int row);

    ToolSettings &mSettings;
    QButtonGroup *mTools = nullptr;
    QComboBox *mPresets = nullptr;
    QGroupBox *mFieldsBox = nullptr, *mMaskBox = nullptr;
    QPushButton *mTakeReference = nullptr;
    QComboBox *mSymmetry = nullptr;
    class NumberField *mCopies = nullptr, *mCentreX = nullptr, *mCentreY = nullptr;
    QString mShape;                              ///< which fields the form has
    std::vector<std::function<void()>> mRefresh; ///< of each field
    bool mIsShowing = false;
};

} // namespace views
