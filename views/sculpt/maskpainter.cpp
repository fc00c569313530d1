// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/sculpt/maskpainter.h"

#include "commands/terrain/setmask.h"
#include "views/sculpt/tooloutline.h"
#include "views/sculpt/toolvalues.h"

#include <QCoreApplication>

#include <algorithm>

namespace views {

using namespace model::terrain;
using model::GroundMask;

namespace {

/// Of the terrain's shorter side, with a tool that has no width.
constexpr double UsualRadius = 1.0 / 30;

double radiusFor(const ToolSettings &settings)
{
    const double radius = radiusOf(settings.tool());
    return radius > 0 ? radius : UsualRadius * settings.terrainSide();
}

QString undoText(const char *text)
{
    return QCoreApplication::translate("Undo", text);
}

} // namespace

MaskPainter::MaskPainter(commands::TerrainContext &context, std::shared_ptr<GroundMask> mask, ToolSettings &settings,
                         GroundView *view, QObject *parent)
    : QObject(parent)
    , mContext(context)
    , mMask(std::move(mask))
    , mSettings(settings)
    , mView(view)
{
    connect(mMask.get(), &GroundMask::changed, this, &MaskPainter::shownChanged);
    connect(&mSettings, &ToolSettings::toolChanged, this, &MaskPainter::updateLines);
}

GroundMask::Value MaskPainter::shown() const
{
    // A copy: whoever draws keeps what it is given.
    return mDraft ? std::make_shared<const PaintMask>(*mDraft) : mMask->value();
}

void MaskPainter::push(const QString &text, GroundMask::Value value)
{
    mContext.pushCommand(std::make_unique<commands::SetMask>(mMask, text, std::move(value)));
}

void MaskPainter::clear()
{
    cancel();
    push(undoText(QT_TRANSLATE_NOOP("Undo", "Clear Mask")), nullptr);
}

void MaskPainter::invert()
{
    cancel();
    PaintMask inverted = mMask->value() ? *mMask->value() : PaintMask(mContext.document().tin().domain());
    inverted.invert();
    push(undoText(QT_TRANSLATE_NOOP("Undo", "Invert Mask")), std::make_shared<const PaintMask>(std::move(inverted)));
}

bool MaskPainter::press(const GroundEvent &event)
{
    mDraft = mMask->value() ? std::make_shared<PaintMask>(*mMask->value())
                            : std::make_shared<PaintMask>(mContext.document().tin().domain());
    mIsOpening = (event.modifiers & Qt::ControlModifier) || event.isEraser;
    mFrom = {event.point.x, event.point.y};
    paintTo(event);
    return true;
}

void MaskPainter::paintTo(const GroundEvent &event)
{
    const Point2 to{event.point.x, event.point.y};
    const Symmetry &symmetry = mSettings.symmetry();
    const double strength = event.isPen ? std::clamp(event.pressure, 0.0, 1.0) : 1;
    for (std::uint32_t i = 0; i < symmetry.count(); ++i)
        mDraft->paint(symmetry.copyOf(mFrom, i), symmetry.copyOf(to, i), radiusFor(mSettings), strength, mIsOpening);
    mFrom = to;
    mPointer = event;
    updateLines();
    emit shownChanged();
}

void MaskPainter::move(const GroundEvent &event)
{
    if (mDraft)
        paintTo(event);
}

void MaskPainter::release(const GroundEvent &event)
{
    if (!mDraft)
        return;
    // A pen that is lifted presses no more.
    if (!event.isPen)
        paintTo(event);
    const std::shared_ptr<const PaintMask> painted = std::exchange(mDraft, nullptr);
    push(mIsOpening ? undoText(QT_TRANSLATE_NOOP("Undo", "Erase Mask"))
                    : undoText(QT_TRANSLATE_NOOP("Undo", "Paint Mask")),
         painted);
    emit shownChanged(); // the command may have been for nothing
}

void MaskPainter::cancel()
{
    if (!std::exchange(mDraft, nullptr))
        return;
    updateLines();
    emit shownChanged();
}

void MaskPainter::hover(const GroundEvent &event)
{
    mPointer = event;
    updateLines();
}

void MaskPainter::leave()
{
    mPointer.reset();
    updateLines();
}

void MaskPainter::updateLines()
{
    if (mView)
        mView->updateLines();
}

std::vector<GroundLine> MaskPainter::lines() const
{
    if (!mPointer)
        return {};
    Raise brush;
    brush.brush.radius = radiusFor(mSettings);
    brush.height = 0.4 * brush.brush.radius; // the dashed line where the soft rim begins
    return outlineOf(brush, {mPointer->point.x, mPointer->point.y}, mPointer->metresPerPixel);
}

} // namespace views
