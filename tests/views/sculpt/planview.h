// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/document/terraindocument.h"
#include "views/terrain/grounddispatcher.h"

#include <QMouseEvent>
#include <QPointingDevice>
#include <QTabletEvent>
#include <QWidget>

namespace tests {

/// A view of the unit square from above, 400 pixels wide with a margin of 50 around it: events go the way they go in
/// the product's views, but no OpenGL is needed to know what they mean.
class PlanView final : public QWidget, public views::GroundView
{
public:
    static constexpr int Side = 400, Margin = 50;

    explicit PlanView(const model::TerrainDocument &document)
        : mDocument(document)
        , mDispatcher(*this, [this](QPointF place) { return find(place); })
    {
        resize(Side + 2 * Margin, Side + 2 * Margin);
        setMouseTracking(true);
        setFocusPolicy(Qt::StrongFocus);
    }

    void setInteraction(views::GroundInteraction *interaction) override { mDispatcher.setInteraction(interaction); }
    std::optional<model::terrain::Point3> pick(QPointF place) const override
    {
        const auto event = find(place);
        return event && event->isOnTerrain ? std::optional(event->point) : std::nullopt;
    }
    void updateLines() override { ++mLineUpdates; }
    int lineUpdates() const { return mLineUpdates; }

    static QPointF placeOf(model::terrain::Point2 p) { return {Margin + Side * p.x, Margin + Side * (1 - p.y)}; }

    /// What a pen does: Qt's own test functions know the mouse alone.
    void pen(QEvent::Type type, model::terrain::Point2 p, double pressure, float tilt = 0, bool isEraser = false)
    {
        using Device = QInputDevice;
        constexpr auto Capabilities = Device::Capability::Pressure | Device::Capability::XTilt;
        static const QPointingDevice tip(QStringLiteral("pen"), 7, Device::DeviceType::Stylus,
                                         QPointingDevice::PointerType::Pen, Capabilities, 1, 1);
        static const QPointingDevice eraser(QStringLiteral("eraser"), 8, Device::DeviceType::Stylus,
                                            QPointingDevice::PointerType::Eraser, Capabilities, 1, 1);
        const QPointF place = placeOf(p);
        QTabletEvent event(type, isEraser ? &eraser : &tip, place, mapToGlobal(place), pressure, tilt, 0, 0, 0, 0,
                           Qt::NoModifier, Qt::LeftButton,
                           type == QEvent::TabletRelease ? Qt::NoButton : Qt::LeftButton);
        QCoreApplication::sendEvent(this, &event);
    }

protected:
    bool event(QEvent *event) override { return mDispatcher.handle(*event) || QWidget::event(event); }

private:
    std::optional<views::GroundEvent> find(QPointF place) const
    {
        views::GroundEvent event;
        const model::terrain::Point2 p{(place.x() - Margin) / Side, 1 - (place.y() - Margin) / Side};
        event.isOnTerrain = mDocument.tin().domain().contains(p);
        event.point = {p.x, p.y, event.isOnTerrain ? mDocument.tin().heightAt(p) : 0};
        event.metresPerPixel = 1.0 / Side;
        event.position = place;
        return event;
    }

    const model::TerrainDocument &mDocument;
    views::GroundDispatcher mDispatcher;
    int mLineUpdates = 0;
};

} // namespace tests
