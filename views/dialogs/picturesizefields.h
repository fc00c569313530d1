// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QSize>

class QComboBox;
class QFormLayout;

namespace views {

class NumberField;

/// The rows of a form that choose the size of a picture: a usual one or any, times a scale.
class PictureSizeFields final : public QObject
{
    Q_OBJECT

public:
    /// \param window   size of the viewport in pixels; proposed
    /// \param largest  that can be drawn
    PictureSizeFields(QFormLayout &form, QSize window, QSize largest, QObject *parent);

    QString problem() const;
    /// In pixels, the scale included. Precondition: no problem.
    QSize size() const;

signals:
    void changed();

private:
    void showCustomRows();

    const QSize mLargest;
    QFormLayout &mForm;
    QComboBox *mPreset;
    NumberField *mWidth;
    NumberField *mHeight;
    QComboBox *mScale;
};

} // namespace views
