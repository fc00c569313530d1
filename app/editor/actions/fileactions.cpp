// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/actions/fileactions.h"

#include "app/editor/documents/animationtab.h"
#include "app/editor/documents/framefiles.h"
#include "app/editor/documents/meshtab.h"
#include "app/editor/documents/terraintab.h"
#include "app/editor/recovery/recoverydialog.h"
#include "app/editor/window/workspace.h"
#include "model/io/animationreader.h"
#include "model/io/errortext.h"
#include "model/io/terrain/terrainimport.h"
#include "views/dialogs/importterraindialog.h"
#include "views/dialogs/newterraindialog.h"
#include "views/dialogs/preparedialog.h"
#include "views/dialogs/quantitytext.h"
#include "views/itemmodels/logmodel.h"
#include "views/viewport/glsupport.h"

#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>
#include <QtEndian>

#include <algorithm>

namespace editor {

namespace {

/// A glTF scene with animations: to be prepared. Without, it is a mesh.
bool isAnimatedScene(const QString &path)
{
    const QString ending = QFileInfo(path).suffix().toLower();
    QFile file(path);
    if ((ending != QLatin1String("gltf") && ending != QLatin1String("glb")) || !file.open(QIODevice::ReadOnly))
        return false;
    constexpr qint64 MostText = qint64(64) << 20;
    qint64 length = std::min(file.size(), MostText);
    if (ending == QLatin1String("glb")) {
        constexpr qint64 HeaderBytes = 20; // then the first chunk, which is JSON; its length at byte 12
        const QByteArray header = file.read(HeaderBytes);
        if (header.size() < HeaderBytes)
            return false;
        length = std::min<qint64>(qFromLittleEndian<quint32>(header.constData() + 12), MostText);
    }
    return file.read(length).contains("\"animations\"");
}

/// Several meshes that are numbered alike: who opens them together wants the animation.
bool areFrames(const QStringList &paths)
{
    if (paths.size() < 2 || kindOfFile(paths.constFirst()) != DocumentKind::Mesh)
        return false;
    const QString pattern = framePatternOf(paths.constFirst());
    return !pattern.isEmpty() && std::all_of(paths.begin(), paths.end(), [&](const QString &path) {
        return framePatternOf(path) == pattern && QFileInfo(path).isFile();
    });
}

} // namespace

FileActions::FileActions(Actions &actions, Workspace &workspace, Settings &settings, views::LogModel &log,
                         QWidget &window)
    : mActions(actions)
    , mWorkspace(workspace)
    , mSettings(settings)
    , mLog(log)
    , mWindow(window)
{
    const auto onTab = [this](ActionId id, auto function) {
        connect(&mActions[id], &QAction::triggered, this, [this, function] {
            if (DocumentTab *tab = mWorkspace.current())
                (this->*function)(*tab);
        });
    };
    connect(&actions[ActionId::Open], &QAction::triggered, this, &FileActions::showOpenDialog);
    connect(&actions[ActionId::Prepare], &QAction::triggered, this, [this] { prepare(QString()); });
    connect(&actions[ActionId::NewTerrain], &QAction::triggered, this, &FileActions::newTerrain);
    connect(&actions[ActionId::ImportTerrain], &QAction::triggered, this, [this] { importTerrain(QString()); });
    connect(&actions[ActionId::Quit], &QAction::triggered, &window, &QWidget::close);
    onTab(ActionId::Save, &FileActions::save);
    onTab(ActionId::SaveAs, &FileActions::saveAs);
    onTab(ActionId::Reload, &FileActions::reload);
    onTab(ActionId::CloseTab, &FileActions::close);
    connect(&workspace, &Workspace::closeRequested, this, &FileActions::close);
    connect(&workspace, &Workspace::currentChanged, this, &FileActions::update);
    connect(&workspace, &Workspace::currentStateChanged, this, &FileActions::update);
    update();
}

void FileActions::openPaths(const QStringList &paths)
{
    if (areFrames(paths)) {
        prepare(QFileInfo(paths.constFirst()).absolutePath());
        return;
    }
    for (const QString &path : paths) {
        const QFileInfo file(path);
        const std::optional<DocumentKind> kind = isAnimatedScene(path) ? std::nullopt : kindOfFile(path);
        if (!file.exists()) {
            tell(tr("%1 cannot be opened.").arg(file.fileName()),
                 model::Error{model::ErrorCode::NotFound, {}, path.toStdString()});
            mSettings.removeRecentFile(file.absoluteFilePath());
            emit recentFilesChanged();
        } else if (file.isDir() || (!kind && model::io::readableEndings().contains(file.suffix().toLower()))) {
            prepare(file.absoluteFilePath());
        } else if (kind) {
            openDocument(*kind, file.absoluteFilePath());
        } else if (model::io::terrainEndings().contains(file.suffix().toLower())) {
            importTerrain(file.absoluteFilePath());
        } else {
            tell(tr("%1 cannot be opened.").arg(file.fileName()),
                 model::Error{model::ErrorCode::UnknownFormat, {file.suffix().toStdString()}, path.toStdString()});
        }
    }
}

void FileActions::openMade(const model::FrameSourcePtr &frames)
{
    DocumentTab &tab = addTab(DocumentKind::Animation);
    mWorkspace.add(&tab);
    asAnimation(&tab)->document().show(frames);
}

void FileActions::openDocument(DocumentKind kind, const QString &path)
{
    for (DocumentTab *tab : mWorkspace.tabs())
        if (tab->document().path() == path) {
            mWorkspace.activate(*tab);
            return;
        }
    DocumentTab &tab = addTab(kind);
    tab.document().open(path);
    mWorkspace.add(&tab);
}

DocumentTab &FileActions::addTab(DocumentKind kind)
{
    DocumentTab *tab = makeTab(kind, views::glSupport().isSufficient);
    Document &document = tab->document();
    connect(&document, &Document::opened, this, [this, tab] { opened(*tab); });
    connect(&document, &Document::failed, this, [this, tab](const model::Error &e) { openingFailed(*tab, e); });
    connect(&document, &Document::saved, this, [this, tab] { saved(*tab); });
    connect(&document, &Document::saveFailed, this, [this, tab](const model::Error &e) { savingFailed(*tab, e); });
    if (TerrainTab *terrain = asTerrain(tab))
        connect(&terrain->document(), &OpenTerrain::recoveryFailed, this, [this, tab](const model::Error &error) {
            tell(tr("What happens to %1 is not being recorded: it would not come back after a crash.")
                     .arg(tab->document().title()),
                 error);
        });
    return *tab;
}

OpenTerrain &FileActions::addTerrain()
{
    DocumentTab &tab = addTab(DocumentKind::Terrain);
    mWorkspace.add(&tab);
    return asTerrain(&tab)->document();
}

OpenMesh &FileActions::addMesh()
{
    DocumentTab &tab = addTab(DocumentKind::Mesh);
    mWorkspace.add(&tab);
    return asMesh(&tab)->document();
}

void FileActions::newTerrain()
{
    auto *dialog = new views::NewTerrainDialog(&mWindow);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this,
            [this, dialog] { addTerrain().create(dialog->name(), dialog->description()); });
    dialog->open();
}

void FileActions::importTerrain(const QString &source)
{
    if (!mImport) {
        mImport = new views::ImportTerrainDialog(&mWindow);
        mImport->setAttribute(Qt::WA_DeleteOnClose);
        connect(mImport, &QDialog::accepted, this, [this, dialog = mImport.data()] {
            addTerrain().import(dialog->source(), dialog->options(), dialog->layers());
        });
    }
    if (!source.isEmpty())
        mImport->setSource(source);
    mImport->open();
}

void FileActions::offerRecovery()
{
    std::vector<Leftover> leftovers = RecoveryEntry::leftovers();
    if (leftovers.empty())
        return;
    auto *dialog = new RecoveryDialog(std::move(leftovers), &mWindow);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &RecoveryDialog::recoverRequested, this, &FileActions::recover);
    dialog->open();
}

void FileActions::recover(const Leftover &leftover)
{
    addTerrain().recover(leftover);
}

void FileActions::showOpenDialog()
{
    QStringList filters, endings;
    for (const DocumentKind kind : EveryDocumentKind) {
        filters << filterOf(kind);
        // "Animations (*.anim)"
        endings << filterOf(kind).section(QLatin1Char('('), -1).chopped(1);
    }
    filters.prepend(tr("Everything that can be opened (%1)").arg(endings.join(QLatin1Char(' '))));
    filters << tr("All files (*)");
    openPaths(QFileDialog::getOpenFileNames(&mWindow, tr("Open"), mSettings.lastFolder(),
                                            filters.join(QStringLiteral(";;"))));
}

void FileActions::openPrepared(const QString &path, const views::OriginalPtr &original)
{
    openPaths({path});
    AnimationTab *tab = mWorkspace.currentAnimation();
    if (!tab || !tab->document().isOpening() || tab->document().path() != QFileInfo(path).absoluteFilePath())
        return; // open already: it may hold what the file held before
    OpenAnimation &document = tab->document();
    connect(
        &document, &Document::opened, this,
        [&document, original] {
            document.comparison().start(
                QString::fromStdString(original->frames->name()),
                [original](const model::Progress &) -> model::Result<views::Original> { return *original; });
        },
        Qt::SingleShotConnection);
}

void FileActions::prepare(const QString &source)
{
    if (!mPrepare) {
        mPrepare = new views::PrepareDialog(&mWindow);
        mPrepare->setAttribute(Qt::WA_DeleteOnClose);
        connect(mPrepare, &views::PrepareDialog::openRequested, this, &FileActions::openPrepared);
    }
    if (!source.isEmpty())
        mPrepare->setSource(source);
    mPrepare->show();
    mPrepare->raise();
    mPrepare->activateWindow();
}

bool FileActions::save(DocumentTab &tab)
{
    Document &document = tab.document();
    if (document.path().isEmpty() || !canSaveTo(document.kind(), document.path()))
        return saveAs(tab);
    if (!document.canSave() || !maySaveOver(document))
        return false;
    document.save(document.path());
    return true;
}

bool FileActions::saveAs(DocumentTab &tab)
{
    Document &document = tab.document();
    if (!document.canSave())
        return false;
    const QString ending = endingOf(document.kind());
    QString proposal = document.path();
    if (proposal.isEmpty())
        proposal = QDir(mSettings.lastFolder()).filePath(document.title() + QLatin1Char('.') + ending);
    else if (!canSaveTo(document.kind(), proposal))
        proposal =
            QFileInfo(proposal).dir().filePath(QFileInfo(proposal).completeBaseName() + QLatin1Char('.') + ending);
    QFileDialog dialog(&mWindow, tr("Save As"), QFileInfo(proposal).absolutePath(), saveFilterOf(document.kind()));
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(ending);
    connect(&dialog, &QFileDialog::filterSelected, &dialog, [&dialog](const QString &filter) {
        // "OFF (*.off)"
        dialog.setDefaultSuffix(filter.section(QStringLiteral("*."), 1, 1).chopped(1));
    });
    dialog.selectFile(QFileInfo(proposal).fileName());
    if (dialog.exec() != QDialog::Accepted || dialog.selectedFiles().isEmpty())
        return false;
    document.save(QFileInfo(dialog.selectedFiles().constFirst()).absoluteFilePath());
    return true;
}

bool FileActions::maySaveOver(Document &document)
{
    if (!document.isChangedOnDisk())
        return true;
    const bool gone = !QFileInfo::exists(document.path());
    if (gone)
        return true; // nothing is lost by writing it again
    QMessageBox box(
        QMessageBox::Warning, tr("File Changed"),
        tr("Another program has changed %1 since it was opened.").arg(QFileInfo(document.path()).fileName()),
        QMessageBox::Cancel, &mWindow);
    box.setInformativeText(tr("Saving replaces those changes by yours."));
    const QPushButton *overwrite = box.addButton(tr("Replace"), QMessageBox::DestructiveRole);
    box.setDefaultButton(QMessageBox::Cancel);
    box.exec();
    return box.clickedButton() == overwrite;
}

void FileActions::reload(DocumentTab &tab)
{
    Document &document = tab.document();
    if (document.isModified()) {
        QMessageBox box(QMessageBox::Question, tr("Reload"),
                        tr("Reloading drops the unsaved changes of %1.").arg(document.title()), QMessageBox::Cancel,
                        &mWindow);
        const QPushButton *drop = box.addButton(tr("Reload"), QMessageBox::DestructiveRole);
        box.setDefaultButton(QMessageBox::Cancel);
        box.exec();
        if (box.clickedButton() != drop)
            return;
    }
    document.reload();
}

void FileActions::close(DocumentTab &tab)
{
    Document &document = tab.document();
    if (document.isSaving()) {
        mCloseWhenSaved.push_back(&tab);
        return;
    }
    if (document.isModified()) {
        switch (askAbout({&tab})) {
        case Answer::Cancel:
            return;
        case Answer::Save:
            if (save(tab))
                mCloseWhenSaved.push_back(&tab);
            return;
        case Answer::Discard:
            break;
        }
    }
    document.abandon();
    mWorkspace.remove(tab);
}

FileActions::Answer FileActions::askAbout(const std::vector<DocumentTab *> &modified)
{
    QMessageBox box(QMessageBox::Question, tr("Unsaved Changes"), QString(),
                    QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, &mWindow);
    box.setObjectName(QStringLiteral("unsavedChanges"));
    if (modified.size() == 1) {
        box.setText(tr("%1 has unsaved changes.").arg(modified.front()->document().title()));
    } else {
        box.setText(tr("%n document(s) have unsaved changes.", nullptr, int(modified.size())));
        QStringList names;
        for (const DocumentTab *tab : modified)
            names << QStringLiteral("• ") + tab->document().title();
        box.setInformativeText(names.join(QLatin1Char('\n')));
        box.button(QMessageBox::Save)->setText(tr("&Save All"));
        box.button(QMessageBox::Discard)->setText(tr("&Discard All"));
    }
    box.setDefaultButton(QMessageBox::Save);
    switch (box.exec()) {
    case QMessageBox::Save:
        return Answer::Save;
    case QMessageBox::Discard:
        return Answer::Discard;
    default:
        return Answer::Cancel;
    }
}

bool FileActions::mayQuit()
{
    mQuitWhenSaved = false;
    if (mPrepare && !mPrepare->close())
        return false;
    std::vector<DocumentTab *> modified;
    bool saving = false;
    for (DocumentTab *tab : mWorkspace.tabs()) {
        saving = saving || tab->document().isSaving();
        if (tab->document().isModified() && !tab->document().isSaving())
            modified.push_back(tab);
    }
    if (!modified.empty()) {
        switch (askAbout(modified)) {
        case Answer::Cancel:
            return false;
        case Answer::Discard:
            break;
        case Answer::Save:
            for (DocumentTab *tab : modified) {
                mWorkspace.activate(*tab);
                if (!save(*tab))
                    return false;
            }
            saving = true;
            break;
        }
    }
    mQuitWhenSaved = saving;
    return !saving;
}

void FileActions::closeSavedOnes()
{
    const std::vector<DocumentTab *> waiting = std::exchange(mCloseWhenSaved, {});
    const auto isOpen = [this](DocumentTab *tab) {
        const auto tabs = mWorkspace.tabs();
        return std::find(tabs.begin(), tabs.end(), tab) != tabs.end();
    };
    for (DocumentTab *tab : waiting)
        if (isOpen(tab))
            close(*tab); // waits again while it is being saved, asks again if it was edited meanwhile
    const auto tabs = mWorkspace.tabs();
    const bool saving =
        std::any_of(tabs.begin(), tabs.end(), [](DocumentTab *tab) { return tab->document().isSaving(); });
    if (!saving && std::exchange(mQuitWhenSaved, false))
        emit quitReady();
}

void FileActions::opened(DocumentTab &tab)
{
    Document &document = tab.document();
    const QString name = document.path().isEmpty() ? document.title() : document.path();
    mLog.add(views::LogLevel::Info, tr("Opened %1: %2").arg(name, document.summary()));
    if (!document.path().isEmpty()) {
        mSettings.addRecentFile(document.path());
        mSettings.setLastFolder(QFileInfo(document.path()).absolutePath());
        emit recentFilesChanged();
    }
    if (const QString message = document.warning(); !message.isEmpty()) {
        mLog.add(views::LogLevel::Warning, message);
        mWorkspace.messages().add(views::MessageBar::Kind::Warning, message);
    }
    update();
}

void FileActions::openingFailed(DocumentTab &tab, const model::Error &error)
{
    if (error.code != model::ErrorCode::Cancelled)
        tell(tr("%1 cannot be opened.").arg(tab.document().title()), error);
    if (!tab.document().isOpen()) // a reload that failed leaves what is there
        mWorkspace.remove(tab);
}

void FileActions::saved(DocumentTab &tab)
{
    const Document &document = tab.document();
    mLog.add(views::LogLevel::Info, tr("Saved %1 (%2)").arg(document.path(), views::bytesText(document.fileBytes())));
    mSettings.addRecentFile(document.path());
    mSettings.setLastFolder(QFileInfo(document.path()).absolutePath());
    emit recentFilesChanged();
    // Not from within the document's own signal: closing destroys it.
    QMetaObject::invokeMethod(this, &FileActions::closeSavedOnes, Qt::QueuedConnection);
}

void FileActions::savingFailed(DocumentTab &tab, const model::Error &error)
{
    mQuitWhenSaved = false;
    std::erase(mCloseWhenSaved, &tab);
    if (error.code != model::ErrorCode::Cancelled)
        tell(tr("%1 was not saved.").arg(tab.document().title()), error);
}

void FileActions::tell(const QString &text, const model::Error &error)
{
    const QString message = text + QLatin1Char(' ') + model::io::errorText(error);
    mLog.add(views::LogLevel::Error, message);
    mWorkspace.messages().add(views::MessageBar::Kind::Error, message);
}

void FileActions::say(const QString &text)
{
    mLog.add(views::LogLevel::Info, text);
    mWorkspace.messages().add(views::MessageBar::Kind::Note, text);
}

void FileActions::update()
{
    const DocumentTab *tab = mWorkspace.current();
    const bool canSave = tab && tab->document().canSave();
    mActions[ActionId::Save].setEnabled(canSave && (tab->document().isModified() || tab->document().path().isEmpty()));
    mActions[ActionId::SaveAs].setEnabled(canSave);
    mActions[ActionId::Reload].setEnabled(tab && tab->document().canReload());
    mActions[ActionId::CloseTab].setEnabled(tab != nullptr);
    for (const ActionId id : {ActionId::NextTab, ActionId::PreviousTab})
        mActions[id].setEnabled(mWorkspace.tabs().size() > 1);
}

} // namespace editor
