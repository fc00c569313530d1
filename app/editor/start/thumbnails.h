// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/editor/documents/filestamp.h"
#include "model/mesh/softwareraster.h"
#include "views/jobs/job.h"

#include <QHash>
#include <QObject>
#include <QPixmap>

#include <functional>

namespace editor {

/// Small pictures of documents, drawn one after another in the background, and kept while their files do not
/// change.
class Thumbnails final : public QObject
{
    Q_OBJECT

public:
    static constexpr int Width = 176;
    static constexpr int Height = 112;
    /// Larger files stay without a picture: it must cost nothing that anybody notices.
    static constexpr qint64 MaxFileSize = 16 * 1024 * 1024;

    explicit Thumbnails(QObject *parent = nullptr);

    /// The picture, null if it is not there (yet): ready() may follow.
    QPixmap of(const QString &path);

signals:
    void ready(const QString &path);

private:
    void drawNext();

    struct Picture
    {
        FileStamp stamp;
        QPixmap pixmap;
    };
    QHash<QString, Picture> mPictures;
    QStringList mWaiting;
    views::Job mDrawing;
};

} // namespace editor
