// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/inspect/meshview.h"

#include "views/inspect/meshcanvas.h"
#include "views/inspect/numbers.h"
#include "views/inspect/partcolors.h"
#include "views/inspect/problems.h"
#include "views/viewport/errorcolors.h"
#include "views/widgets/flowlayout.h"
#include "views/widgets/icons.h"

#include <QAction>
#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolBar>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace views {

namespace {

constexpr int ClipSteps = 1000;
constexpr int PlainColoring = -2, ComponentColoring = -1; ///< item data of mColoring; else the index of a field

QRgb colorOfShare(float share)
{
    const float at = std::clamp(share, 0.0f, 1.0f) * float(ErrorColors.size() - 1);
    const auto low = std::min(std::size_t(at), ErrorColors.size() - 2);
    const float part = at - float(low);
    const auto mix = [&](int a, int b) { return int(std::lround(float(a) + float(b - a) * part)); };
    const QRgb a = ErrorColors[low], b = ErrorColors[low + 1];
    return qRgb(mix(qRed(a), qRed(b)), mix(qGreen(a), qGreen(b)), mix(qBlue(a), qBlue(b)));
}

/// Ring closed: each vertex to the next, the last to the first.
void addRing(MeshMarks &marks, const std::vector<std::uint32_t> &ring)
{
    for (std::size_t i = 0; i < ring.size(); ++i)
        marks.edges.push_back({ring[i], ring[(i + 1) % ring.size()]});
}

} // namespace

MeshView::MeshView(QWidget *parent)
    : QWidget(parent)
    , mCanvas(new MeshCanvas(this))
    , mBar(new QToolBar(this))
    , mColoring(new QComboBox(this))
    , mPickMode(new QComboBox(this))
    , mClipRow(new QWidget(this))
    , mClipLabel(new QLabel(mClipRow))
    , mClipAxis(new QComboBox(mClipRow))
    , mClipPlace(new QSlider(Qt::Horizontal, mClipRow))
    , mReport(new QLabel(this))
    , mColoringLabel(new QLabel(this))
    , mPickLabel(new QLabel(this))
{
    mCanvas->setObjectName(QStringLiteral("meshCanvas"));
    makeBar();
    makeClipRow(*mClipRow);
    mReport->setObjectName(QStringLiteral("pickReport"));
    mReport->setWordWrap(true);
    mReport->setMargin(6);
    mReport->setTextFormat(Qt::RichText);
    mReport->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(mBar);
    column->addWidget(mClipRow);
    column->addWidget(mCanvas, 1);
    column->addWidget(mReport);
    mClipRow->hide();
    connect(mCanvas, &VtkView::clicked, this, &MeshView::pick);
    retranslate();
    showPicked();
}

MeshView::~MeshView() = default;

QAction *MeshView::addToggle(const char *name, const char *iconName, bool isOn)
{
    QAction *action = mBar->addAction(icon(QLatin1String(iconName)), QString());
    action->setObjectName(QLatin1String(name));
    action->setCheckable(true);
    action->setChecked(isOn);
    return action;
}

void MeshView::makeBar()
{
    mBar->setIconSize({18, 18});
    mColoring->setObjectName(QStringLiteral("coloring"));
    mColoring->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    mColoringLabel->setBuddy(mColoring);
    mColoringLabel->setContentsMargins(4, 0, 4, 0);
    mBar->addWidget(mColoringLabel);
    mBar->addWidget(mColoring);
    mBar->addSeparator();
    mEdges = addToggle("meshEdges", "shaded-wireframe", false);
    mSmooth = addToggle("meshSmooth", "shaded", false);
    mNormals = addToggle("meshNormals", "normals", false);
    mSeeThrough = addToggle("meshSeeThrough", "see-through", false);
    mClip = addToggle("meshClip", "clip", false);
    mBar->addSeparator();
    mLoops = addToggle("meshLoops", "loops", true);
    mProblems = addToggle("meshProblems", "warning", true);
    mBar->addSeparator();
    mPickMode->setObjectName(QStringLiteral("pickMode"));
    for (const PickMode mode : {PickMode::Face, PickMode::Edge, PickMode::Vertex})
        mPickMode->addItem(QString(), int(mode));
    mPickLabel->setBuddy(mPickMode);
    mPickLabel->setContentsMargins(4, 0, 4, 0);
    mBar->addWidget(mPickLabel);
    mBar->addWidget(mPickMode);
    mBar->addSeparator();
    mFit = mBar->addAction(icon(QStringLiteral("fit")), QString());
    mFit->setObjectName(QStringLiteral("meshFit"));

    connect(mColoring, &QComboBox::currentIndexChanged, this, &MeshView::showColors);
    connect(mEdges, &QAction::toggled, mCanvas, &MeshCanvas::setEdgesVisible);
    connect(mSmooth, &QAction::toggled, mCanvas, &MeshCanvas::setSmooth);
    connect(mNormals, &QAction::toggled, mCanvas, &MeshCanvas::setNormalsVisible);
    connect(mSeeThrough, &QAction::toggled, mCanvas, &MeshCanvas::setTransparent);
    connect(mLoops, &QAction::toggled, this, &MeshView::showMarks);
    connect(mProblems, &QAction::toggled, this, &MeshView::showMarks);
    connect(mClip, &QAction::toggled, this, [this](bool on) {
        mClipRow->setVisible(on);
        showClip();
    });
    connect(mFit, &QAction::triggered, this, &MeshView::fitView);
}

void MeshView::makeClipRow(QWidget &row)
{
    auto *layout = new QHBoxLayout(&row);
    layout->setContentsMargins(6, 2, 6, 2);
    mClipAxis->setObjectName(QStringLiteral("clipAxis"));
    for (const char *axis : {"x", "y", "z"})
        mClipAxis->addItem(QLatin1String(axis));
    mClipPlace->setObjectName(QStringLiteral("clipPlace"));
    mClipPlace->setRange(0, ClipSteps);
    mClipPlace->setValue(ClipSteps / 2);
    mClipPlace->setPageStep(ClipSteps / 20);
    mClipFlip = new QAction(icon(QStringLiteral("reverse")), QString(), this);
    mClipFlip->setObjectName(QStringLiteral("clipFlip"));
    mClipFlip->setCheckable(true);
    auto *flip = new QToolButton(&row);
    flip->setDefaultAction(mClipFlip);
    flip->setAutoRaise(true);
    mClipLabel->setBuddy(mClipAxis);
    layout->addWidget(mClipLabel);
    layout->addWidget(mClipAxis);
    layout->addWidget(mClipPlace, 1);
    layout->addWidget(flip);
    connect(mClipAxis, &QComboBox::currentIndexChanged, this, &MeshView::showClip);
    connect(mClipPlace, &QSlider::valueChanged, this, &MeshView::showClip);
    connect(mClipFlip, &QAction::toggled, this, &MeshView::showClip);
}

void MeshView::changeEvent(QEvent *event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    if (event->type() == QEvent::PaletteChange && mInspection) {
        showColors();
        showMarks();
        showSelection();
    }
}

void MeshView::retranslate()
{
    mCanvas->setAccessibleName(tr("Mesh"));
    mCanvas->setAccessibleDescription(
        tr("The mesh in 3D. Arrow keys turn it, plus and minus zoom, F shows all of it."));
    mColoringLabel->setText(tr("Colour:"));
    mColoring->setAccessibleName(tr("What colours tell"));
    mPickLabel->setText(tr("Pick:"));
    mPickMode->setAccessibleName(tr("What a click picks"));
    mPickMode->setItemText(0, tr("Faces"));
    mPickMode->setItemText(1, tr("Edges"));
    mPickMode->setItemText(2, tr("Vertices"));
    const auto name = [](QAction *action, const QString &text, const QString &tip) {
        action->setText(text);
        action->setToolTip(text + QStringLiteral("\n") + tip);
        action->setStatusTip(tip);
    };
    name(mEdges, tr("Edges"), tr("Draw the edges of the faces"));
    name(mSmooth, tr("Smooth"), tr("Draw smooth surfaces instead of flat faces"));
    name(mNormals, tr("Normals"), tr("Draw the normal of each vertex"));
    name(mSeeThrough, tr("See Through"), tr("Let what lies behind the surface show"));
    name(mClip, tr("Clip"), tr("Cut a part of the mesh away"));
    name(mLoops, tr("Loops"), tr("Draw the borders of holes and the loops of handles as tubes"));
    name(mProblems, tr("Problems"), tr("Mark what is wrong with the mesh"));
    name(mFit, tr("Fit"), tr("Move the camera so that all is seen"));
    name(mClipFlip, tr("Other Side"), tr("Cut the other side away"));
    mClipLabel->setText(tr("Cut across:"));
    mClipAxis->setAccessibleName(tr("Axis across which the mesh is cut"));
    mClipPlace->setAccessibleName(tr("Where the mesh is cut"));
    mReport->setAccessibleName(tr("What was picked"));
    fillColorings();
    showMessage();
    showPicked();
}

void MeshView::setInspection(Inspection *inspection)
{
    if (inspection == mInspection)
        return;
    if (mInspection)
        mInspection->disconnect(this);
    mInspection = inspection;
    if (inspection) {
        connect(inspection, &Inspection::meshChanged, this, [this] {
            if (!mInspection->mesh())
                follow();
            mPicked.reset();
            showPicked();
            showMessage();
        });
        connect(inspection, &Inspection::sceneryReady, this, &MeshView::follow);
        connect(inspection, &Inspection::found, this, [this] {
            showColors();
            showMarks();
            showSelection();
            showPicked();
        });
        connect(inspection, &Inspection::busyChanged, this, &MeshView::showMessage);
        connect(inspection, &Inspection::selectionChanged, this, [this] {
            showColors();
            showSelection();
        });
        connect(inspection, &Inspection::frameAsked, this, &MeshView::frame);
        connect(inspection, &Inspection::fieldsChanged, this, &MeshView::fillColorings);
        connect(inspection, &Inspection::fieldReady, this, [this] {
            showColors();
            showPicked();
        });
    }
    follow();
    fillColorings();
}

void MeshView::follow()
{
    mPicked.reset();
    mCanvas->setScenery(mInspection ? mInspection->scenery() : nullptr);
    mCanvas->setSmooth(mSmooth->isChecked());
    showColors();
    showMarks();
    showSelection();
    showClip();
    showMessage();
    showPicked();
}

void MeshView::fillColorings()
{
    const QVariant before = mColoring->currentData();
    const QSignalBlocker blocker(mColoring);
    mColoring->clear();
    mColoring->addItem(tr("None"), PlainColoring);
    mColoring->addItem(tr("Components"), ComponentColoring);
    if (mInspection) {
        const std::vector<FieldId> fields = mInspection->fields();
        for (std::size_t i = 0; i < fields.size(); ++i)
            mColoring->addItem(fieldTitle(fields[i]), int(i));
    }
    const int index = before.isValid() ? mColoring->findData(before) : 1;
    mColoring->setCurrentIndex(std::max(index, 0));
    showColors();
}

void MeshView::showColors()
{
    if (!mInspection || !mInspection->scenery())
        return;
    const int choice = mColoring->currentData().toInt();
    mCanvas->setLegend(std::nullopt);
    const std::vector<FieldId> fields = mInspection->fields();
    if (choice >= 0 && choice < int(fields.size()))
        showField(fields[std::size_t(choice)]);
    else if (choice == ComponentColoring && mInspection->report())
        showComponentColors();
    else
        mCanvas->setColors({});
}

void MeshView::showComponentColors()
{
    const model::MeshReport &report = *mInspection->report();
    const auto &selection = mInspection->selection();
    const bool isChosen =
        std::any_of(selection.begin(), selection.end(), [](PartId part) { return part.kind == PartKind::Component; });
    if (report.components.size() <= 1) {
        mCanvas->setColors({}); // one colour would tell nothing, and hide which faces are seen from behind
        return;
    }
    std::vector<QRgb> ofComponent;
    for (std::uint32_t c = 0; c < report.components.size(); ++c) {
        const bool isDimmed = isChosen && !mInspection->isSelected({PartKind::Component, c});
        ofComponent.push_back(isDimmed ? dimmed(componentColor(c), palette()) : componentColor(c));
    }
    const model::Faces &faces = mInspection->mesh()->faces;
    std::vector<QRgb> colors(mInspection->mesh()->positions.size(), 0xff808080);
    for (std::uint32_t f = 0; f < faces.faceCount(); ++f)
        for (const std::uint32_t vertex : faces.face(f))
            colors[vertex] = ofComponent[report.componentOfFace[f]];
    mCanvas->setColors(colors);
}

void MeshView::showField(FieldId id)
{
    const std::vector<float> *values = mInspection->field(id);
    if (!values) {
        mCanvas->setColors({}); // fieldReady follows
        return;
    }
    const auto [low, high] = typicalRange(*values);
    const float width = high > low ? high - low : 1;
    std::vector<QRgb> colors;
    colors.reserve(values->size());
    for (const float value : *values)
        colors.push_back(std::isfinite(value) ? colorOfShare((value - low) / width) : qRgb(128, 128, 128));
    mCanvas->setColors(colors);
    ColorScale scale;
    scale.title = fieldTitle(id);
    scale.colors.assign(ErrorColors.begin(), ErrorColors.end());
    constexpr int Ticks = 5;
    for (int tick = 0; tick < Ticks; ++tick)
        scale.ticks << shortNumber(double(low) + double(high - low) * tick / (Ticks - 1));
    mCanvas->setLegend(scale);
}

void MeshView::addMarks(std::vector<MeshMarks> &marks, PartId part, bool isSelected) const
{
    const model::Faces &faces = mInspection->mesh()->faces;
    const MarkColors &colors = markColors(palette());
    switch (part.kind) {
    case PartKind::Component:
        break; // shown by the colours of all others; a mesh of one component needs no mark
    case PartKind::Hole: {
        MeshMarks mark{isSelected ? colors.selected : colors.hole, {}, {}, {}};
        for (const std::uint32_t side : mInspection->report()->holes[part.index].loop.sides)
            mark.edges.push_back({faces.vertex(side), faces.sideEnd(side)});
        marks.push_back(std::move(mark));
        break;
    }
    case PartKind::Handle: {
        const model::HandleReport &handle = (*mInspection->handles())[part.index];
        for (std::size_t loop = 0; loop < 2; ++loop) {
            const QColor usual = loop == 0 ? colors.handle : colors.tunnel;
            MeshMarks mark{isSelected ? (loop == 0 ? colors.selected : colors.selectedTunnel) : usual, {}, {}, {}};
            addRing(mark, handle.loops[loop].vertices);
            marks.push_back(std::move(mark));
        }
        break;
    }
    case PartKind::Problem: {
        const Problem &problem = mInspection->problems()[part.index];
        MeshMarks mark{isSelected ? colors.selected : colors.problem, {}, {}, {}};
        const auto [a, b] = problem.ids;
        if (problem.kind == model::ProblemKind::NonManifoldEdge || problem.kind == model::ProblemKind::InconsistentEdge)
            mark.edges.push_back({a, b});
        else if (namesOf(problem.kind) == IdsName::Vertices)
            mark.vertices.push_back(a);
        else if (namesOf(problem.kind) == IdsName::Faces)
            for (const std::uint32_t face : problem.ids) {
                if (face == model::NoId)
                    continue;
                mark.faces.push_back(face);
                // A face without area is seen by its border alone.
                for (std::uint32_t side = faces.begin(face); side < faces.end(face); ++side)
                    mark.edges.push_back({faces.vertex(side), faces.sideEnd(side)});
            }
        marks.push_back(std::move(mark));
        break;
    }
    }
}

void MeshView::showMarks()
{
    std::vector<MeshMarks> loops, problems;
    if (mInspection && mInspection->report() && mInspection->mesh()) {
        const auto add = [&](std::vector<MeshMarks> &marks, PartKind kind) {
            for (std::uint32_t i = 0; i < mInspection->countOf(kind); ++i)
                addMarks(marks, {kind, i}, false);
        };
        if (mLoops->isChecked()) {
            add(loops, PartKind::Hole);
            add(loops, PartKind::Handle);
        }
        if (mProblems->isChecked())
            add(problems, PartKind::Problem);
    }
    mCanvas->setMarks(MeshCanvas::Layer::Loops, loops);
    mCanvas->setMarks(MeshCanvas::Layer::Problems, problems);
}

void MeshView::showSelection()
{
    std::vector<MeshMarks> marks;
    if (mInspection)
        for (const PartId part : mInspection->selection())
            addMarks(marks, part, true);
    mCanvas->setMarks(MeshCanvas::Layer::Selection, marks);
}

void MeshView::showClip()
{
    if (!mClip->isChecked() || !mInspection || !mInspection->scenery()) {
        mCanvas->setClip(std::nullopt);
        return;
    }
    const model::Box3f &box = mInspection->scenery()->box;
    // The ends leave nothing and all, with no face in the plane itself.
    const float share = float(mClipPlace->value()) / ClipSteps * 1.002f - 0.001f;
    const float side = mClipFlip->isChecked() ? 1.0f : -1.0f;
    const int axis = mClipAxis->currentIndex();
    const model::Vec3f normal{axis == 0 ? side : 0, axis == 1 ? side : 0, axis == 2 ? side : 0};
    mCanvas->setClip(ClipPlane{box.min + box.size() * share, normal});
}

void MeshView::showMessage()
{
    QString message;
    if (mInspection && mInspection->mesh()) {
        if (!mInspection->scenery())
            message = tr("Preparing the picture…");
        else if (mInspection->mesh()->positions.empty())
            message = tr("The mesh is empty.");
        else if (!mInspection->report() && mInspection->isBusy())
            message = tr("Analysing…");
        else if (!mInspection->handles() && mInspection->isBusy())
            message = tr("Looking for handles…");
    }
    mCanvas->setMessage(message);
}

void MeshView::pick(QPointF place, Qt::KeyboardModifiers)
{
    if (!mInspection || !mInspection->mesh() || !mInspection->scenery() ||
        mInspection->scenery()->mesh != mInspection->mesh())
        return;
    mPicked.reset();
    if (const auto hit = mCanvas->hitAt(place))
        mPicked = pickedAt(*mInspection->mesh(), hit->face, hit->place, PickMode(mPickMode->currentData().toInt()));
    showPicked();
    emit pickedChanged();
}

void MeshView::showPicked()
{
    if (!mPicked || !mInspection || !mInspection->mesh()) {
        mReport->setText(tr("Click a face, an edge or a vertex to read about it."));
        mCanvas->setMarks(MeshCanvas::Layer::Picked, {});
        return;
    }
    MeshMarks mark{markColors(palette()).picked, {}, {}, {}};
    switch (mPicked->mode) {
    case PickMode::Face:
        mark.faces.push_back(mPicked->face);
        break;
    case PickMode::Edge:
        mark.edges.push_back({mPicked->vertices[0], mPicked->vertices[1]});
        break;
    case PickMode::Vertex:
        mark.vertices.push_back(mPicked->vertices[0]);
        break;
    }
    mCanvas->setMarks(MeshCanvas::Layer::Picked, {mark});
    QStringList parts;
    for (const auto &[name, value] : describe(*mPicked, *mInspection))
        parts << QStringLiteral("<b>%1</b>&nbsp;%2").arg(name.toHtmlEscaped(), value.toHtmlEscaped());
    mReport->setText(parts.join(QStringLiteral(" &nbsp; ")));
}

void MeshView::frame()
{
    model::Box3f box = mInspection->selectionBox();
    if (box.isEmpty())
        return;
    // Something around it says where it is; a single vertex has no size.
    const model::Vec3f middle = box.center();
    const float reach = std::max(box.diagonal() * 0.75f, mInspection->scenery()->box.diagonal() * 0.02f);
    box.add(middle + model::Vec3f{reach, reach, reach} * 0.6f);
    box.add(middle - model::Vec3f{reach, reach, reach} * 0.6f);
    mCanvas->fit(box);
}

void MeshView::fitView()
{
    mCanvas->fitView();
}

const model::OrbitCamera &MeshView::camera() const
{
    return mCanvas->camera();
}

void MeshView::setCamera(const model::OrbitCamera &camera)
{
    mCanvas->setCamera(camera);
}

std::optional<QPointF> MeshView::placeOf(const model::Vec3f &point) const
{
    return mCanvas->placeOf(point);
}

QWidget &MeshView::canvas() const
{
    return *mCanvas;
}

QImage MeshView::picture()
{
    return mCanvas->grabFramebuffer();
}

} // namespace views
