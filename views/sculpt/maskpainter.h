// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/terrain/terraincontext.h"
#include "model/document/groundmask.h"
#include "views/sculpt/toolsettings.h"
#include "views/terrain/groundinteraction.h"

#include <QObject>

#include <optional>

namespace views {

/// Paints what is protected from tools: as wide as the tool, with its symmetry, as hard as the pen presses. Ctrl and
/// the pen's other end open again. A stroke is one undo step; until it is over, the document does not know of it.
class MaskPainter final : public QObject, public GroundInteraction
{
    Q_OBJECT

public:
    /// \param view  to be told when the lines on the ground change; may be null
    MaskPainter(commands::TerrainContext &context, std::shared_ptr<model::GroundMask> mask, ToolSettings &settings,
                GroundView *view, QObject *parent = nullptr);

    /// With the stroke that is being drawn; null: nothing is protected.
    model::GroundMask::Value shown() const;
    void clear();
    void invert();

    bool isActive() const override { return true; }
    bool press(const GroundEvent &event) override;
    void move(const GroundEvent &event) override;
    void release(const GroundEvent &event) override;
    void cancel() override;
    void hover(const GroundEvent &event) override;
    void leave() override;
    std::vector<GroundLine> lines() const override;

signals:
    void shownChanged();

private:
    void push(const QString &text, model::GroundMask::Value value);
    void paintTo(const GroundEvent &event);
    void updateLines();

    commands::TerrainContext &mContext;
    const std::shared_ptr<model::GroundMask> mMask;
    ToolSettings &mSettings;
    GroundView *mView;
    std::shared_ptr<model::terrain::PaintMask> mDraft; ///< while a stroke is drawn
    bool mIsOpening = false;
    model::terrain::Point2 mFrom;
    std::optional<GroundEvent> mPointer;
};

} // namespace views
