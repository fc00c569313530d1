// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/terrain/terraincontext.h"
#include "model/document/groundmask.h"
#include "model/terrain/tools/livestroke.h"
#include "views/sculpt/groundreading.h"
#include "views/sculpt/groundreference.h"
#include "views/sculpt/sandflow.h"
#include "views/terrain/groundinteraction.h"

#include <QObject>
#include <QPointer>
#include <QTimer>

#include <optional>

namespace views {

/// Draws strokes on a terrain with the mouse or a pen: what a person does to the ground is one gesture, from the press
/// until the sand that it set in motion rests or the next gesture begins.
///
/// Left drag draws. Ctrl inverts the tool, Shift smooths, Alt lifts; the pen's other end inverts too. F and the pointer
/// change the radius, Shift+F what one stamp does, until a click.
class StrokeController final : public QObject, public GroundInteraction
{
    Q_OBJECT

public:
    /// \param view  to be told when the lines on the ground change; may be null
    StrokeController(commands::TerrainContext &context, ToolSettings &settings, GroundView *view,
                     QObject *parent = nullptr);
    ~StrokeController() override;

    /// Off: the mouse moves the camera.
    void setActive(bool isActive);
    SandFlow &flow() { return mFlow; }
    bool isDrawing() const { return mStroke.has_value(); }
    /// What Restore brings back.
    GroundReference &reference() { return mReference; }
    /// What no tool changes; null: there is no such mask.
    void setMask(std::shared_ptr<const model::GroundMask> mask) { mMask = std::move(mask); }

    bool isActive() const override { return mIsActive; }
    bool press(const GroundEvent &event) override;
    void move(const GroundEvent &event) override;
    void release(const GroundEvent &event) override;
    void cancel() override;
    void hover(const GroundEvent &event) override;
    void leave() override;
    bool keyPress(const QKeyEvent &event) override;
    std::vector<GroundLine> lines() const override;

signals:
    /// The pointer is over another place of the ground; nothing beside the terrain.
    void readingChanged(const std::optional<views::GroundReading> &reading);
    /// A stroke is over. \param report  of its stamps, without what slid
    void strokeEnded(const model::terrain::StrokeReport &report);
    /// A stroke could not be drawn, or not to its end. \param reason  for people
    void strokeRefused(const QString &reason);

private:
    /// What a drag without a button changes.
    enum class Adjusting { Nothing, Radius, Amount };

    model::terrain::Tool toolFor(const GroundEvent &event) const;
    void add(const GroundEvent &event);
    void drawDue();
    void finish();
    void abandon();
    void adjust(const GroundEvent &event);
    void showReading(const GroundEvent &event);
    void updateLines();
    double speedAt(const GroundEvent &event);
    model::terrain::OwnerId nextOwner();

    commands::TerrainContext &mContext;
    ToolSettings &mSettings;
    GroundView *mView;
    SandFlow mFlow;
    GroundReference mReference;
    std::shared_ptr<const model::GroundMask> mMask;
    model::terrain::ToolMemory mMemory;
    std::optional<model::terrain::LiveStroke> mStroke;
    QTimer mDrawing; ///< for stamps that did not fit into the event that brought them
    bool mIsActive = true;
    bool mIsEnding = false;
    model::terrain::OwnerId mNextOwner = model::terrain::None;
    std::optional<GroundEvent> mLast; ///< of the pointer
    double mSpeed = 0;
    Adjusting mAdjusting = Adjusting::Nothing;
    GroundEvent mAdjustFrom;
    model::terrain::Tool mBeforeAdjusting;
};

} // namespace views
