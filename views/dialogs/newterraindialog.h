// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/animation/framesource.h"
#include "model/io/terrain/newterrain.h"
#include "views/jobs/job.h"

#include <QDialog>

class QComboBox;
class QFormLayout;
class QPushButton;

namespace views {

class FramePicture;
class HintLabel;
class LayersField;
class NumberField;

/// New Terrain: its shape, size, resolution and layers, with a picture of what comes of them.
class NewTerrainDialog final : public QDialog
{
    Q_OBJECT

public:
    explicit NewTerrainDialog(QWidget *parent = nullptr);

    /// What to make. Precondition: it was accepted.
    model::io::NewTerrain description() const;
    /// For its tab: "Dunes".
    QString name() const;

private:
    NumberField *addNumber(QFormLayout &form, const char *objectName, const QString &label, const QString &what,
                           double min, double max, int decimals, double value, const QString &unit);
    model::io::ReliefShape shape() const;
    QString problem() const;
    void refresh();
    void drawPreview();

    QComboBox *mShape;
    NumberField *mWidth;
    NumberField *mDepth;
    NumberField *mSpacing;
    NumberField *mHeight;
    NumberField *mWavelength;
    NumberField *mSeed;
    LayersField *mLayers;
    FramePicture *mPicture;
    HintLabel *mMessage;
    QPushButton *mCreate;
    bool mIsOutdated = false; ///< something changed while a picture was being made
    Job mMaking;
};

} // namespace views
