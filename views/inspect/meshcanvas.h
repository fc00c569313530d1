// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/inspect/meshmarks.h"
#include "views/inspect/meshscenery.h"
#include "views/inspect/vtkview.h"
#include "views/viewport/overlay.h"

#include <QTimer>

#include <array>

#include <vtkNew.h>

class vtkActor;
class vtkPlane;
class vtkPolyDataMapper;

namespace views {

/// A half-space that is cut away.
struct ClipPlane
{
    model::Vec3f origin, normal; ///< what lies on the normal's side stays
    friend bool operator==(const ClipPlane &, const ClipPlane &) = default;
};

/// The picture of a mesh: surface, edges, normals, marks, a plane that cuts. Large meshes turn as a coarse one. Private
/// to views/inspect; MeshView is what others use.
class MeshCanvas final : public VtkView
{
    Q_OBJECT

public:
    explicit MeshCanvas(QWidget *parent = nullptr);
    ~MeshCanvas() override;

    /// Null: nothing is drawn. Colours and marks go with the mesh before.
    void setScenery(MeshSceneryPtr scenery);
    /// One for each vertex; empty: all alike, and faces seen from behind in another one.
    void setColors(const std::vector<QRgb> &colors);
    void setLegend(std::optional<ColorScale> legend);
    void setEdgesVisible(bool visible);
    void setSmooth(bool smooth);
    void setNormalsVisible(bool visible);
    /// The surface lets marks behind it show.
    void setTransparent(bool transparent);
    void setClip(const std::optional<ClipPlane> &plane);
    /// What is said in the picture while there is nothing else; empty: nothing.
    void setMessage(const QString &message);

    /// In the order in which they are drawn over one another.
    enum class Layer { Loops, Problems, Selection, Picked };
    void setMarks(Layer layer, const std::vector<MeshMarks> &marks);

    struct Hit
    {
        std::uint32_t face;
        model::Vec3f place;
    };
    /// The face under a place of the widget, of what the plane leaves.
    std::optional<Hit> hitAt(QPointF place) const;

    /// It turns, and a coarse mesh stands for the large one.
    bool isCoarse() const { return mIsCoarse; }

protected:
    void drawOverlay(QPainter &painter) override;
    void resizeGL(int width, int height) override;

private:
    /// An actor with all that hangs at it.
    struct Drawn;

    void applyPalette();
    void applyClip();
    void turn();
    void stand();
    void showCoarse(bool coarse);
    void makeNormals();
    void applyPixelRatio();
    bool isDark() const;

    MeshSceneryPtr mScenery;
    std::unique_ptr<Drawn> mFull, mCoarse, mNormals;
    static constexpr std::size_t LayerCount = 4;
    std::array<std::unique_ptr<Drawn>, LayerCount> mMarks, mHidden; ///< where they are seen, and through the surface
    vtkNew<vtkPlane> mPlane;
    std::optional<ClipPlane> mClip;
    std::optional<ColorScale> mLegend;
    QString mMessage;
    bool mNormalsVisible = false;
    bool mIsCoarse = false;
    double mFullMilliseconds = 0; ///< that the whole mesh took when it was drawn last
    QTimer mStanding;
};

} // namespace views
