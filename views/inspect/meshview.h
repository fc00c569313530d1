// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/inspect/inspection.h"
#include "views/inspect/pickreport.h"

#include <QImage>
#include <QPointer>
#include <QWidget>

class QAction;
class QActionGroup;
class QComboBox;
class QLabel;
class QSlider;
class QToolBar;

namespace model {
struct OrbitCamera;
}

namespace views {

class MeshCanvas;
struct MeshMarks;

/// A picture of the mesh that is inspected, drawn by VTK, with what is to be seen in it chosen above it and what was
/// picked below it. Several views of one inspection share the selection; colours, plane and camera are each view's own.
/// Precondition: glSupport().isSufficient.
class MeshView final : public QWidget
{
    Q_OBJECT

public:
    explicit MeshView(QWidget *parent = nullptr);
    ~MeshView() override;

    /// Null: nothing to see.
    void setInspection(Inspection *inspection);
    Inspection *inspection() const { return mInspection; }

    void fitView();
    const model::OrbitCamera &camera() const;
    void setCamera(const model::OrbitCamera &camera);
    /// What was picked last.
    const std::optional<Picked> &picked() const { return mPicked; }
    /// Where a point of the mesh is seen, in canvas(); nothing for what lies behind the eye.
    std::optional<QPointF> placeOf(const model::Vec3f &point) const;
    /// Where the picture is, below the buttons: takes mouse and keys.
    QWidget &canvas() const;
    /// As it is on the screen, with scale and axes.
    QImage picture();

signals:
    void pickedChanged();

protected:
    void changeEvent(QEvent *event) override;

private:
    enum class Coloring : int { Plain, Components, Field };

    QAction *addToggle(const char *name, const char *iconName, bool isOn);
    void makeBar();
    void makeClipRow(QWidget &row);
    void retranslate();
    void follow();
    void fillColorings();
    void showColors();
    void showComponentColors();
    void showField(FieldId id);
    void showMarks();
    void showSelection();
    void showClip();
    void showMessage();
    void showPicked();
    void frame();
    void pick(QPointF place, Qt::KeyboardModifiers modifiers);
    void addMarks(std::vector<MeshMarks> &marks, PartId part, bool isSelected) const;

    QPointer<Inspection> mInspection;
    MeshCanvas *mCanvas;
    QToolBar *mBar;
    QComboBox *mColoring;
    QComboBox *mPickMode;
    QAction *mEdges = nullptr, *mSmooth = nullptr, *mNormals = nullptr, *mLoops = nullptr, *mProblems = nullptr,
            *mSeeThrough = nullptr, *mClip = nullptr, *mFit = nullptr;
    QWidget *mClipRow;
    QLabel *mClipLabel;
    QComboBox *mClipAxis;
    QSlider *mClipPlace;
    QAction *mClipFlip = nullptr;
    QLabel *mReport;
    QLabel *mColoringLabel, *mPickLabel;
    std::optional<Picked> mPicked;
};

} // namespace views
