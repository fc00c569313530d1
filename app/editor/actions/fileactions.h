// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/editor/actions/actions.h"
#include "app/editor/documents/documentkind.h"
#include "app/editor/start/settings.h"
#include "model/base/error.h"
#include "views/scene/framedata.h"

#include <QObject>
#include <QPointer>

#include <vector>

class QWidget;

namespace views {
class LogModel;
class ImportTerrainDialog;
class PrepareDialog;
} // namespace views

namespace editor {

class Document;
class OpenMesh;
class OpenTerrain;
class Workspace;
struct Leftover;

/// The life of documents: open, prepare, save, reload, close, and the questions that come with it.
class FileActions final : public QObject
{
    Q_OBJECT

public:
    FileActions(Actions &actions, Workspace &workspace, Settings &settings, views::LogModel &log, QWidget &window);

    /// Opens documents and samples as tabs; offers to prepare everything else; says what cannot be had.
    void openPaths(const QStringList &paths);
    /// Shows an animation that was made in the program in a tab of its own.
    void openMade(const model::FrameSourcePtr &frames);
    void prepare(const QString &source);

    /// Asks about what an earlier session left, if it left something.
    void offerRecovery();

    /// May the window close? Asks about unsaved changes. False while something still has to be saved: quitReady()
    /// follows when it is.
    bool mayQuit();

    /// A tab for a mesh that is to be made.
    OpenMesh &addMesh();

    /// Shows an error to the user, and keeps it in the log.
    void tell(const QString &text, const model::Error &error);
    /// Shows what the user should know.
    void say(const QString &text);

    /// Enables what the present tab allows.
    void update();

signals:
    void quitReady();
    void recentFilesChanged();

private:
    enum class Answer { Save, Discard, Cancel };

    void openDocument(DocumentKind kind, const QString &path);
    /// A new tab whose document is still to be opened.
    DocumentTab &addTab(DocumentKind kind);
    void openPrepared(const QString &path, const views::OriginalPtr &original);
    void showOpenDialog();
    void newTerrain();
    void importTerrain(const QString &source);
    /// A tab for a terrain that is to be made.
    OpenTerrain &addTerrain();
    void recover(const Leftover &leftover);
    /// Saves to its file; asks for one if it has none. False if the user thought better of it.
    bool save(DocumentTab &tab);
    bool saveAs(DocumentTab &tab);
    bool maySaveOver(Document &document);
    void reload(DocumentTab &tab);
    void close(DocumentTab &tab);
    Answer askAbout(const std::vector<DocumentTab *> &modified);
    void closeSavedOnes();

    void opened(DocumentTab &tab);
    void openingFailed(DocumentTab &tab, const model::Error &error);
    void saved(DocumentTab &tab);
    void savingFailed(DocumentTab &tab, const model::Error &error);

    Actions &mActions;
    Workspace &mWorkspace;
    Settings &mSettings;
    views::LogModel &mLog;
    QWidget &mWindow;
    QPointer<views::PrepareDialog> mPrepare;
    QPointer<views::ImportTerrainDialog> mImport;
    std::vector<DocumentTab *> mCloseWhenSaved;
    bool mQuitWhenSaved = false;
};

} // namespace editor
