// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/document/terraindocument.h"
#include "views/sculpt/groundreference.h"
#include "views/sculpt/profileline.h"

#include <QDockWidget>
#include <QPointer>
#include <QTimer>

class QAction;
class QLabel;
class QPushButton;
class QToolButton;

namespace views {

class ProfilePlot;

/// The cross-section of a terrain along a line on it: the curve, what it was at the reference, and what lies under the
/// cursor. Follows the terrain while it changes.
class ProfileDock final : public QDockWidget
{
    Q_OBJECT

public:
    /// \param pick  checkable: the line is drawn on the ground while it is checked
    explicit ProfileDock(QAction &pick, QWidget *parent = nullptr);
    ~ProfileDock() override;

    /// \param line, reference  of the terrain in front; null: none. Let go of by itself when the document goes
    void setTerrain(const model::TerrainDocument *document, ProfileLine *line, GroundReference *reference);
    ProfilePlot &plot() { return *mPlot; }

protected:
    void changeEvent(QEvent *event) override;

private:
    void build();
    void measure();
    void showReading();
    QString readingText() const;
    void copyTable();
    void copyPicture();

    QAction &mPickAction;
    QPointer<const model::TerrainDocument> mDocument;
    QPointer<ProfileLine> mLine;
    QPointer<GroundReference> mReference;
    QList<QMetaObject::Connection> mConnections;
    QTimer mLater; ///< while the terrain changes
    ProfilePlot *mPlot = nullptr;
    QLabel *mReading = nullptr;
    QPushButton *mCopyTable = nullptr, *mCopyPicture = nullptr, *mClear = nullptr;
};

} // namespace views
