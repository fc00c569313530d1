// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/inspect/meshcanvas.h"

#include "model/mesh/normals.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkStaticCellLocator.h>
#include <vtkUnsignedCharArray.h>

namespace views {

namespace {

/// After a movement of the camera the whole mesh is drawn again when nothing has moved for this long.
constexpr int StandMilliseconds = 250;
/// What is drawn as quickly as this turns as it is.
constexpr double QuickMilliseconds = 60;
/// Normals are lines of this share of the box's diagonal, of so many vertices at most.
constexpr float NormalLength = 0.02f;
constexpr std::size_t MostNormals = 60'000;
/// How much of the marks is seen through the surface.
constexpr double HiddenOpacity = 0.3;
constexpr double SeeThrough = 0.35;
constexpr float TubeWidth = 4, BallSize = 9; ///< pixels

struct Colors
{
    QColor top, bottom, surface, back, edges, normals;
};

const Colors &colorsFor(bool isDark)
{
    static const Colors dark{{58, 64, 74}, {30, 33, 39}, {198, 200, 204}, {150, 92, 84}, {24, 26, 30}, {120, 190, 255}};
    static const Colors light{{246, 247, 249}, {214, 219, 226}, {186, 190, 197},
                              {196, 132, 120}, {70, 74, 82},    {0, 92, 180}};
    return isDark ? dark : light;
}

std::array<double, 3> rgb(const QColor &color)
{
    return {color.redF(), color.greenF(), color.blueF()};
}

vtkSmartPointer<vtkUnsignedCharArray> colorArray(std::size_t count)
{
    auto array = vtkSmartPointer<vtkUnsignedCharArray>::New();
    array->SetNumberOfComponents(3);
    array->SetNumberOfTuples(vtkIdType(count));
    return array;
}

/// Marks as VTK draws them: every mark brings its own points, in its own colour.
vtkSmartPointer<vtkPolyData> dataOf(const model::PolygonMesh &mesh, const std::vector<MeshMarks> &marks)
{
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> balls, tubes, faces;
    auto colors = colorArray(0);
    std::vector<vtkIdType> ids;
    for (const MeshMarks &mark : marks) {
        const auto add = [&](std::uint32_t vertex) {
            const model::Vec3f &p = mesh.positions[vertex];
            ids.push_back(points->InsertNextPoint(p.x, p.y, p.z));
            colors->InsertNextTuple3(mark.color.red(), mark.color.green(), mark.color.blue());
        };
        const auto close = [&](vtkCellArray &cells) {
            cells.InsertNextCell(vtkIdType(ids.size()), ids.data());
            ids.clear();
        };
        for (const std::uint32_t vertex : mark.vertices) {
            add(vertex);
            close(*balls);
        }
        for (const auto &[a, b] : mark.edges) {
            add(a);
            add(b);
            close(*tubes);
        }
        for (const std::uint32_t face : mark.faces) {
            for (const std::uint32_t vertex : mesh.faces.face(face))
                add(vertex);
            if (ids.size() >= 3)
                close(*faces);
            ids.clear();
        }
    }
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(points);
    data->SetVerts(balls);
    data->SetLines(tubes);
    data->SetPolys(faces);
    data->GetPointData()->SetScalars(colors);
    return data;
}

} // namespace

struct MeshCanvas::Drawn
{
    vtkNew<vtkPolyDataMapper> mapper;
    vtkNew<vtkActor> actor;

    explicit Drawn(vtkRenderer &renderer)
    {
        actor->SetMapper(mapper);
        actor->VisibilityOff();
        renderer.AddActor(actor);
    }
    void show(vtkPolyData *data)
    {
        mapper->SetInputData(data);
        actor->SetVisibility(data != nullptr);
    }
    vtkProperty &property() { return *actor->GetProperty(); }
};

MeshCanvas::MeshCanvas(QWidget *parent)
    : VtkView(parent)
    , mFull(std::make_unique<Drawn>(renderer()))
    , mCoarse(std::make_unique<Drawn>(renderer()))
    , mNormals(std::make_unique<Drawn>(renderer()))
{
    for (Drawn *surface : {mFull.get(), mCoarse.get()}) {
        surface->property().SetInterpolationToFlat();
        surface->property().SetAmbient(0.12);
        surface->property().SetDiffuse(0.88);
        // Marks lie on the surface: it steps back behind them.
        surface->mapper->SetResolveCoincidentTopologyToPolygonOffset();
        surface->mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(1, 1);
    }
    mNormals->property().SetLighting(false);
    for (std::size_t layer = 0; layer < LayerCount; ++layer) {
        mMarks[layer] = std::make_unique<Drawn>(renderer());
        mHidden[layer] = std::make_unique<Drawn>(frontRenderer());
        const double nearer = -4.0 * double(layer + 1);
        vtkPolyDataMapper &mapper = *mMarks[layer]->mapper;
        mapper.SetResolveCoincidentTopologyToPolygonOffset();
        mapper.SetRelativeCoincidentTopologyPolygonOffsetParameters(0, nearer);
        mapper.SetRelativeCoincidentTopologyLineOffsetParameters(-1, nearer - 2);
        mapper.SetRelativeCoincidentTopologyPointOffsetParameter(nearer - 4);
        for (Drawn *marks : {mMarks[layer].get(), mHidden[layer].get()}) {
            marks->property().SetLighting(false);
            marks->property().SetRenderPointsAsSpheres(true);
        }
        mMarks[layer]->property().SetRenderLinesAsTubes(true);
        mHidden[layer]->property().SetOpacity(HiddenOpacity);
    }
    mStanding.setSingleShot(true);
    mStanding.setInterval(StandMilliseconds);
    connect(&mStanding, &QTimer::timeout, this, &MeshCanvas::stand);
    connect(this, &VtkView::cameraMoved, this, &MeshCanvas::turn);
    connect(this, &VtkView::paletteChanged, this, &MeshCanvas::applyPalette);
    applyPalette();
}

MeshCanvas::~MeshCanvas() = default;

bool MeshCanvas::isDark() const
{
    return palette().color(QPalette::Window).lightness() < 128;
}

void MeshCanvas::applyPalette()
{
    const Colors &colors = colorsFor(isDark());
    renderer().SetGradientBackground(true);
    renderer().SetBackground2(rgb(colors.top).data());
    renderer().SetBackground(rgb(colors.bottom).data());
    for (Drawn *surface : {mFull.get(), mCoarse.get()}) {
        surface->property().SetColor(rgb(colors.surface).data());
        surface->property().SetEdgeColor(rgb(colors.edges).data());
        vtkNew<vtkProperty> back;
        back->DeepCopy(&surface->property());
        back->SetColor(rgb(colors.back).data());
        surface->actor->SetBackfaceProperty(back);
    }
    mNormals->property().SetColor(rgb(colors.normals).data());
    update();
}

void MeshCanvas::applyPixelRatio()
{
    const auto ratio = float(devicePixelRatioF());
    for (std::size_t layer = 0; layer < LayerCount; ++layer)
        for (Drawn *marks : {mMarks[layer].get(), mHidden[layer].get()}) {
            marks->property().SetLineWidth((TubeWidth + float(layer)) * ratio);
            marks->property().SetPointSize((BallSize + float(layer)) * ratio);
        }
}

void MeshCanvas::resizeGL(int width, int height)
{
    VtkView::resizeGL(width, height);
    applyPixelRatio();
}

void MeshCanvas::setScenery(MeshSceneryPtr scenery)
{
    mScenery = std::move(scenery);
    for (std::size_t layer = 0; layer < LayerCount; ++layer) {
        mMarks[layer]->show(nullptr);
        mHidden[layer]->show(nullptr);
    }
    const auto copyOf = [](vtkPolyData *from) {
        vtkSmartPointer<vtkPolyData> copy;
        if (from) {
            copy = vtkSmartPointer<vtkPolyData>::New();
            copy->ShallowCopy(from);
        }
        return copy;
    };
    mFull->show(mScenery ? copyOf(mScenery->faces).Get() : nullptr);
    mCoarse->show(mScenery ? copyOf(mScenery->coarse).Get() : nullptr);
    mFullMilliseconds = 0;
    showCoarse(false);
    setColors({});
    makeNormals();
    setSceneBox(mScenery ? mScenery->box : model::Box3f());
}

void MeshCanvas::setColors(const std::vector<QRgb> &colors)
{
    vtkSmartPointer<vtkUnsignedCharArray> array;
    if (mScenery && colors.size() == mScenery->mesh->positions.size()) {
        array = colorArray(colors.size());
        unsigned char *out = array->GetPointer(0);
        for (const QRgb color : colors) {
            *out++ = static_cast<unsigned char>(qRed(color));
            *out++ = static_cast<unsigned char>(qGreen(color));
            *out++ = static_cast<unsigned char>(qBlue(color));
        }
    }
    for (Drawn *surface : {mFull.get(), mCoarse.get()})
        if (vtkPolyData *data_ = surface->mapper->GetInput()) {
            data_->GetPointData()->SetScalars(array);
            surface->mapper->SetScalarVisibility(array != nullptr);
        }
    update();
}

void MeshCanvas::setLegend(std::optional<ColorScale> legend)
{
    mLegend = std::move(legend);
    update();
}

void MeshCanvas::setEdgesVisible(bool visible)
{
    mFull->property().SetEdgeVisibility(visible);
    applyPalette();
}

void MeshCanvas::setSmooth(bool smooth)
{
    for (Drawn *surface : {mFull.get(), mCoarse.get()})
        surface->property().SetInterpolation(smooth ? VTK_PHONG : VTK_FLAT);
    if (smooth && mScenery && !mScenery->mesh->positions.empty()) {
        vtkNew<vtkFloatArray> normals;
        normals->SetNumberOfComponents(3);
        normals->SetNumberOfTuples(vtkIdType(mScenery->normals.size()));
        std::copy_n(reinterpret_cast<const float *>(mScenery->normals.data()), 3 * mScenery->normals.size(),
                    normals->GetPointer(0));
        for (Drawn *surface : {mFull.get(), mCoarse.get()})
            if (vtkPolyData *data_ = surface->mapper->GetInput())
                data_->GetPointData()->SetNormals(normals);
    }
    applyPalette();
}

void MeshCanvas::setNormalsVisible(bool visible)
{
    mNormalsVisible = visible;
    makeNormals();
    update();
}

void MeshCanvas::makeNormals()
{
    if (!mNormalsVisible || !mScenery) {
        mNormals->show(nullptr);
        return;
    }
    const std::vector<model::Vec3f> &positions = mScenery->mesh->positions;
    const std::size_t step = positions.size() / MostNormals + 1;
    const float reach = mScenery->box.diagonal() * NormalLength;
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> lines;
    for (std::size_t v = 0; v < positions.size(); v += step) {
        const model::Vec3f from = positions[v], to = from + mScenery->normals[v] * reach;
        const vtkIdType first = points->InsertNextPoint(from.x, from.y, from.z);
        lines->InsertNextCell({first, points->InsertNextPoint(to.x, to.y, to.z)});
    }
    vtkNew<vtkPolyData> data_;
    data_->SetPoints(points);
    data_->SetLines(lines);
    mNormals->show(data_);
}

void MeshCanvas::setTransparent(bool transparent)
{
    for (Drawn *surface : {mFull.get(), mCoarse.get()})
        surface->property().SetOpacity(transparent ? SeeThrough : 1);
    applyPalette();
}

void MeshCanvas::setClip(const std::optional<ClipPlane> &plane)
{
    if (plane == mClip)
        return;
    mClip = plane;
    applyClip();
    turn(); // a slider that is dragged is a movement like that of the camera
    update();
}

void MeshCanvas::applyClip()
{
    std::vector<vtkPolyDataMapper *> mappers{mFull->mapper, mCoarse->mapper, mNormals->mapper};
    for (std::size_t layer = 0; layer < LayerCount; ++layer) {
        mappers.push_back(mMarks[layer]->mapper);
        mappers.push_back(mHidden[layer]->mapper);
    }
    for (vtkPolyDataMapper *mapper : mappers) {
        mapper->RemoveAllClippingPlanes();
        if (mClip)
            mapper->AddClippingPlane(mPlane);
    }
    if (mClip) {
        mPlane->SetOrigin(mClip->origin.x, mClip->origin.y, mClip->origin.z);
        mPlane->SetNormal(mClip->normal.x, mClip->normal.y, mClip->normal.z);
    }
}

void MeshCanvas::setMessage(const QString &message)
{
    mMessage = message;
    update();
}

void MeshCanvas::setMarks(Layer layer, const std::vector<MeshMarks> &marks)
{
    const auto index = std::size_t(layer);
    vtkSmartPointer<vtkPolyData> data_;
    if (mScenery && !marks.empty())
        data_ = dataOf(*mScenery->mesh, marks);
    mMarks[index]->show(data_);
    // Faces that shone through would hide what lies before them.
    vtkSmartPointer<vtkPolyData> hidden;
    if (data_) {
        hidden = vtkSmartPointer<vtkPolyData>::New();
        hidden->ShallowCopy(data_);
        hidden->SetPolys(vtkSmartPointer<vtkCellArray>::New());
    }
    mHidden[index]->show(hidden);
    update();
}

std::optional<MeshCanvas::Hit> MeshCanvas::hitAt(QPointF place) const
{
    if (!mScenery || mScenery->mesh->faces.faceCount() == 0)
        return std::nullopt;
    const Ray ray = rayAt(place);
    const float reach = model::length(mScenery->box.center() - ray.origin) + mScenery->box.diagonal();
    float from = 0, to = reach;
    if (mClip) {
        const float height = dot(ray.origin - mClip->origin, mClip->normal), slope = dot(ray.direction, mClip->normal);
        if (slope == 0 && height < 0)
            return std::nullopt;
        if (slope != 0) {
            const float at = -height / slope;
            (slope > 0 ? from : to) = slope > 0 ? std::max(from, at) : std::min(to, at);
        }
        if (from >= to)
            return std::nullopt;
    }
    const auto point = [&](float distance) {
        const model::Vec3f p = ray.origin + ray.direction * distance;
        return std::array<double, 3>{double(p.x), double(p.y), double(p.z)};
    };
    std::array<double, 3> begin = point(from), end = point(to), at{}, inside{};
    double along = 0;
    int part = 0;
    vtkIdType cell = -1;
    if (!mScenery->locator->IntersectWithLine(begin.data(), end.data(), 1e-9, along, at.data(), inside.data(), part,
                                              cell))
        return std::nullopt;
    return Hit{std::uint32_t(cell), {float(at[0]), float(at[1]), float(at[2])}};
}

void MeshCanvas::turn()
{
    if (!mScenery || !mScenery->coarse || (!mIsCoarse && mFullMilliseconds < QuickMilliseconds))
        return;
    showCoarse(true);
    mStanding.start();
}

void MeshCanvas::stand()
{
    showCoarse(false);
}

void MeshCanvas::showCoarse(bool coarse)
{
    mIsCoarse = coarse;
    mFull->actor->SetVisibility(!coarse && mScenery);
    mCoarse->actor->SetVisibility(coarse);
    mNormals->actor->SetVisibility(!coarse && mNormals->mapper->GetInput());
    update();
}

void MeshCanvas::drawOverlay(QPainter &painter)
{
    if (!mIsCoarse)
        mFullMilliseconds = drawMilliseconds();
    if (mScenery)
        drawAxes(painter, rect(), camera(), isDark());
    if (mLegend)
        drawColorScale(painter, rect(), *mLegend, isDark());
    if (!mMessage.isEmpty()) {
        painter.setPen(isDark() ? QColor(230, 232, 236) : QColor(50, 54, 60));
        painter.drawText(rect().adjusted(20, 20, -20, -20), Qt::AlignHCenter | Qt::AlignTop | Qt::TextWordWrap,
                         mMessage);
    }
}

} // namespace views
