// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/window/tabicon.h"

#include "app/editor/documents/document.h"

#include <QGuiApplication>
#include <QIconEngine>
#include <QPainter>
#include <QPalette>
#include <QPixmap>

namespace editor {

namespace {

/// Drawn when painted, so that it follows the theme and the resolution.
class TabIconEngine final : public QIconEngine
{
public:
    explicit TabIconEngine(double progress)
        : mProgress(progress)
    {}

    void paint(QPainter *painter, const QRect &rect, QIcon::Mode, QIcon::State) override
    {
        const QPalette palette = QGuiApplication::palette();
        painter->setRenderHint(QPainter::Antialiasing);
        const QRectF box = QRectF(rect).adjusted(0, 0, 0, 0);
        const double side = std::min(box.width(), box.height());
        if (mProgress < 0) {
            painter->setPen(Qt::NoPen);
            painter->setBrush(palette.color(QPalette::Link));
            painter->drawEllipse(box.center(), side * 0.24, side * 0.24);
            return;
        }
        QRectF ring(0, 0, side * 0.72, side * 0.72);
        ring.moveCenter(box.center());
        painter->setBrush(Qt::NoBrush);
        painter->setPen(QPen(palette.color(QPalette::Mid), side * 0.15));
        painter->drawEllipse(ring);
        painter->setPen(QPen(palette.color(QPalette::Link), side * 0.15, Qt::SolidLine, Qt::RoundCap));
        constexpr int FullCircle = 360 * 16; // in QPainter's units
        painter->drawArc(ring, FullCircle / 4, -int(FullCircle * std::max(0.04, mProgress)));
    }

    QPixmap pixmap(const QSize &size, QIcon::Mode mode, QIcon::State state) override
    {
        QPixmap picture(size);
        picture.fill(Qt::transparent);
        QPainter painter(&picture);
        paint(&painter, QRect(QPoint(), size), mode, state);
        return picture;
    }

    QIconEngine *clone() const override { return new TabIconEngine(*this); }

private:
    const double mProgress; ///< below zero: the dot
};

} // namespace

QIcon tabIcon(Document &document)
{
    if (document.isOpening())
        return QIcon(new TabIconEngine(document.openingJob().fraction()));
    if (document.isSaving())
        return QIcon(new TabIconEngine(document.savingJob().fraction()));
    if (document.isModified())
        return QIcon(new TabIconEngine(-1));
    return {};
}

} // namespace editor
