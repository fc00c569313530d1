// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/dialogs/inputline.h"

#include <QWidget>

class QMimeData;

namespace views {

/// A path that a person types (completed from the disk), drops, or picks with a button.
class PathField final : public QWidget
{
    Q_OBJECT

public:
    enum Pick {
        ExistingFile = 1,
        ExistingFolder = 2,
        NewFile = 4,
    };
    static_assert((ExistingFile & ExistingFolder) == 0 && ((ExistingFile | ExistingFolder) & NewFile) == 0);
    Q_DECLARE_FLAGS(Picks, Pick)

    /// \param name  what the path is, for titles of file dialogs and screen readers: "Source"
    PathField(const QString &name, Picks picks, QWidget *parent = nullptr);

    /// For the file dialogs, as QFileDialog takes it.
    void setFileFilter(const QString &filter) { mFilter = filter; }
    /// Where file dialogs start while nothing is typed.
    void setStartFolder(const QString &folder) { mStartFolder = folder; }

    /// Clean, absolute unless empty; `~` is the home folder.
    QString path() const;
    void setPath(const QString &path);
    InputLine &input() { return *mInput; }

signals:
    /// With every change of the text.
    void pathChanged();
    /// The path came at once, by a button or a drop, or was confirmed: no more letters will follow.
    void pathChosen();

protected:
    void dragEnterEvent(QDragEnterEvent *event) override;
    void dropEvent(QDropEvent *event) override;

private:
    void addButton(const QString &text, const QString &objectName, QString (PathField::*pick)());
    void choose(const QString &path);
    QString startFolder() const;
    QString pickFile();
    QString pickFolder();
    QString pickNewFile();

    const QString mName;
    QString mFilter;
    QString mStartFolder;
    InputLine *mInput;
};

Q_DECLARE_OPERATORS_FOR_FLAGS(PathField::Picks)

/// `path` with `ending` (".anim"), which is appended if it is not there; empty stays empty.
QString withEnding(const QString &path, const QString &ending);

/// Why no file can be written at `path`, as a sentence; empty if it can (it may exist).
QString newFileProblem(const QString &path);

/// The first local file or folder of what is dragged; empty if there is none.
QString droppedPath(const QMimeData *data);

} // namespace views
