// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/window/droptarget.h"

#include "views/widgets/icons.h"

#include <QDragEnterEvent>
#include <QMimeData>
#include <QPainter>
#include <QUrl>

namespace editor {

namespace {

class DropOverlay final : public QWidget
{
public:
    explicit DropOverlay(QWidget *parent)
        : QWidget(parent)
    {
        setAttribute(Qt::WA_TransparentForMouseEvents);
        hide();
    }

protected:
    void paintEvent(QPaintEvent *) override
    {
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        QColor veil = palette().color(QPalette::Window);
        veil.setAlpha(215);
        painter.fillRect(rect(), veil);
        painter.setPen(QPen(palette().color(QPalette::Link), 2, Qt::DashLine));
        painter.drawRoundedRect(QRectF(rect()).adjusted(16, 16, -16, -16), 12, 12);
        const QRect picture(rect().center() - QPoint(24, 52), QSize(48, 48));
        views::icon(QStringLiteral("drop")).paint(&painter, picture);
        QFont large = font();
        large.setPointSizeF(large.pointSizeF() * 1.4);
        painter.setFont(large);
        painter.setPen(palette().color(QPalette::WindowText));
        painter.drawText(rect().adjusted(0, 40, 0, 40), Qt::AlignCenter, DropTarget::tr("Drop to open"));
    }
};

QStringList localPaths(const QMimeData *data)
{
    QStringList paths;
    const QList<QUrl> urls = data->urls();
    for (const QUrl &url : urls)
        if (url.isLocalFile())
            paths << url.toLocalFile();
    return paths;
}

} // namespace

DropTarget::DropTarget(QWidget &window)
    : mWindow(window)
    , mOverlay(new DropOverlay(&window))
{
    window.setAcceptDrops(true);
    window.installEventFilter(this);
}

bool DropTarget::eventFilter(QObject *watched, QEvent *event)
{
    switch (event->type()) {
    case QEvent::DragEnter:
    case QEvent::DragMove: {
        auto *drag = static_cast<QDragMoveEvent *>(event);
        if (localPaths(drag->mimeData()).isEmpty())
            return false;
        drag->acceptProposedAction();
        showOverlay(true);
        return true;
    }
    case QEvent::DragLeave:
        showOverlay(false);
        return true;
    case QEvent::Drop: {
        showOverlay(false);
        auto *drop = static_cast<QDropEvent *>(event);
        const QStringList paths = localPaths(drop->mimeData());
        if (paths.isEmpty())
            return false;
        drop->acceptProposedAction();
        // The program that is dragged from waits until this returns: dialogs must not open here.
        QMetaObject::invokeMethod(
            this, [this, paths] { emit dropped(paths); }, Qt::QueuedConnection);
        return true;
    }
    case QEvent::Resize:
        mOverlay->setGeometry(mWindow.rect());
        return false;
    default:
        return QObject::eventFilter(watched, event);
    }
}

void DropTarget::showOverlay(bool visible)
{
    if (visible == mOverlay->isVisible())
        return;
    mOverlay->setGeometry(mWindow.rect());
    mOverlay->setVisible(visible);
    mOverlay->raise();
}

} // namespace editor
