// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/terrain/editsurface.h"
#include "views/sculpt/backgroundedit.h"

#include <QDockWidget>
#include <QPointer>
#include <QTimer>

#include <memory>

class QComboBox;
class QFormLayout;
class QGroupBox;
class QPushButton;
class QTreeWidget;
class QVBoxLayout;

namespace views {

class NumberField;

/// What a terrain is made of: the layers on its bedrock, how thick and how wet they are, and the materials themselves,
/// ready-made or changed to one's own.
class MaterialDock final : public QDockWidget
{
    Q_OBJECT

public:
    explicit MaterialDock(QWidget *parent = nullptr);
    ~MaterialDock() override;

    /// \param context  null: no terrain; let go of by itself when it is destroyed
    void setContext(commands::TerrainContext *context);

protected:
    void changeEvent(QEvent *event) override;

private:
    void build();
    QWidget *makeLayers(QWidget *parent);
    QWidget *makeMaterials(QWidget *parent);
    void documentChanged(const model::TerrainChange &change);
    void showLayers();
    void showMaterials();
    void showMaterial();
    void makeCurve();
    void run(const QString &text, commands::EditSurface::Work work);
    void addLayer();
    void fillLayer();
    void setLayerMaterial(int material);
    void editMaterial();
    void choosePreset(int row);
    int chosenLayer() const;

    QPointer<commands::TerrainContext> mContext;
    std::unique_ptr<BackgroundEdit> mWork;
    QList<QMetaObject::Connection> mConnections;
    QTimer mLater; ///< thicknesses are added up again when a stroke has ended
    commands::GestureId mGesture = commands::NoGesture;

    QVBoxLayout *mColumn = nullptr;
    QWidget *mContent = nullptr, *mPanel = nullptr;
    QTreeWidget *mLayers = nullptr;
    QComboBox *mLayerMaterial = nullptr, *mMaterials = nullptr, *mPreset = nullptr;
    NumberField *mThickness = nullptr, *mHumidity = nullptr;
    QPushButton *mAdd = nullptr, *mRemove = nullptr, *mFill = nullptr, *mAddMaterial = nullptr,
                *mRemoveMaterial = nullptr;
    QFormLayout *mForm = nullptr, *mCurveForm = nullptr;
    NumberField *mDensity = nullptr, *mPoured = nullptr, *mCompressibility = nullptr;
    std::vector<NumberField *> mCurve; ///< angles at the humidities of the curve
    bool mIsShowing = false;
};

} // namespace views
