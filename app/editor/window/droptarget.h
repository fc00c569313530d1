// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QStringList>
#include <QWidget>

class QMimeData;

namespace editor {

/// Lets files and folders be dropped anywhere on a window, and shows that they can be while they hover over it.
class DropTarget final : public QObject
{
    Q_OBJECT

public:
    explicit DropTarget(QWidget &window);

signals:
    /// Local paths, absolute.
    void dropped(const QStringList &paths);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void showOverlay(bool visible);

    QWidget &mWindow;
    QWidget *mOverlay;
};

} // namespace editor
