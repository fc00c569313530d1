// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/document/terraindocument.h"
#include "views/terrain/grounddispatcher.h"
#include "views/terrain/hillshade.h"

#include <QTimer>
#include <QWidget>

namespace views {

/// Stands where the TerrainViewport would, on a machine without sufficient OpenGL: the terrain from above, as the
/// processor draws it. Tools work in it.
class NoGlTerrainView final : public QWidget, public GroundView
{
    Q_OBJECT

public:
    explicit NoGlTerrainView(const model::TerrainDocument &document, QWidget *parent = nullptr);
    ~NoGlTerrainView() override;

    void setInteraction(GroundInteraction *interaction) override;
    std::optional<model::terrain::Point3> pick(QPointF place) const override;
    void updateLines() override;
    /// The map; some rows of it may still be those of a moment ago.
    const QImage &picture() const { return mShade.image(); }

    QSize minimumSizeHint() const override { return {160, 120}; }
    QSize sizeHint() const override { return {800, 600}; }

protected:
    void paintEvent(QPaintEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    bool event(QEvent *event) override;

private:
    void documentChanged(const model::TerrainChange &change);
    void drawOn();
    QRect mapArea() const;
    model::terrain::Point2 mapPoint(QPointF place) const;
    QPointF placeOf(model::terrain::Point2 point) const;
    std::optional<GroundEvent> groundAt(QPointF place) const;

    const model::TerrainDocument &mDocument;
    HillShade mShade;
    QTimer mDrawing;
    GroundDispatcher mDispatcher;
};

} // namespace views
