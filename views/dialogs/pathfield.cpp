// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/dialogs/pathfield.h"

#include <QCompleter>
#include <QDir>
#include <QDropEvent>
#include <QFileDialog>
#include <QFileSystemModel>
#include <QHBoxLayout>
#include <QMimeData>
#include <QPushButton>

namespace views {

QString droppedPath(const QMimeData *data)
{
    const QList<QUrl> urls = data->urls();
    for (const QUrl &url : urls)
        if (url.isLocalFile())
            return url.toLocalFile();
    return {};
}

QString withEnding(const QString &path, const QString &ending)
{
    return path.isEmpty() || path.endsWith(ending, Qt::CaseInsensitive) ? path : path + ending;
}

QString newFileProblem(const QString &path)
{
    const QFileInfo file(path);
    if (path.isEmpty())
        return PathField::tr("Name the output file.");
    if (file.isDir())
        return PathField::tr("The output file is a folder.");
    if (!QFileInfo(file.absolutePath()).isDir())
        return PathField::tr("The folder of the output file does not exist.");
    if (!QFileInfo(file.absolutePath()).isWritable())
        return PathField::tr("You may not write to the folder of the output file.");
    return {};
}

PathField::PathField(const QString &name, Picks picks, QWidget *parent)
    : QWidget(parent)
    , mName(name)
    , mInput(new InputLine(this))
{
    mInput->setAccessibleName(name);
    mInput->setClearButtonEnabled(true);
    mInput->setAcceptDrops(false); // a drop on the text would insert an URL; it is ours to take
    setAcceptDrops(true);
    setFocusProxy(mInput);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);

    auto *completer = new QCompleter(this);
    auto *disk = new QFileSystemModel(completer);
    disk->setRootPath(QString());
    disk->setFilter(picks == Picks(ExistingFolder) ? QDir::Dirs | QDir::NoDotAndDotDot
                                                   : QDir::AllEntries | QDir::NoDotAndDotDot);
    completer->setModel(disk);
    mInput->setCompleter(completer);

    auto *row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(mInput, 1);
    const bool onlyOne = picks == Picks(ExistingFile) || picks == Picks(ExistingFolder) || picks == Picks(NewFile);
    if (picks.testFlag(ExistingFolder))
        addButton(onlyOne ? tr("Browse…") : tr("Browse Folder…"), QStringLiteral("browseFolder"),
                  &PathField::pickFolder);
    if (picks.testFlag(ExistingFile))
        addButton(onlyOne ? tr("Browse…") : tr("Browse File…"), QStringLiteral("browseFile"), &PathField::pickFile);
    if (picks.testFlag(NewFile))
        addButton(tr("Browse…"), QStringLiteral("browseFile"), &PathField::pickNewFile);

    connect(mInput, &QLineEdit::textChanged, this, &PathField::pathChanged);
    connect(mInput, &QLineEdit::editingFinished, this, &PathField::pathChosen);
    connect(completer, qOverload<const QString &>(&QCompleter::activated), this, &PathField::pathChosen);
}

QString PathField::path() const
{
    QString text = mInput->text().trimmed();
    if (text.startsWith(QLatin1String("file:")))
        text = QUrl(text).toLocalFile();
    if (text == QLatin1String("~") || text.startsWith(QLatin1String("~/")))
        text.replace(0, 1, QDir::homePath());
    return text.isEmpty() ? text : QDir::cleanPath(QDir().absoluteFilePath(text));
}

void PathField::setPath(const QString &path)
{
    mInput->setText(path.isEmpty() ? path : QDir::toNativeSeparators(QDir::cleanPath(QDir().absoluteFilePath(path))));
}

void PathField::dragEnterEvent(QDragEnterEvent *event)
{
    if (!droppedPath(event->mimeData()).isEmpty())
        event->acceptProposedAction();
}

void PathField::dropEvent(QDropEvent *event)
{
    event->acceptProposedAction();
    choose(droppedPath(event->mimeData()));
}

void PathField::addButton(const QString &text, const QString &objectName, QString (PathField::*pick)())
{
    auto *button = new QPushButton(text, this);
    button->setObjectName(objectName);
    button->setAutoDefault(false);
    button->setAccessibleName(QStringLiteral("%1: %2").arg(mName, text));
    layout()->addWidget(button);
    connect(button, &QPushButton::clicked, this, [this, pick] { choose((this->*pick)()); });
}

void PathField::choose(const QString &path)
{
    if (path.isEmpty())
        return;
    setPath(path);
    emit pathChosen();
}

QString PathField::startFolder() const
{
    return path().isEmpty() ? mStartFolder : path();
}

QString PathField::pickFile()
{
    return QFileDialog::getOpenFileName(this, mName, startFolder(), mFilter);
}

QString PathField::pickFolder()
{
    return QFileDialog::getExistingDirectory(this, mName, startFolder());
}

QString PathField::pickNewFile()
{
    // Whether to overwrite is asked when the file is written: until then it may come and go.
    return QFileDialog::getSaveFileName(this, mName, startFolder(), mFilter, nullptr,
                                        QFileDialog::DontConfirmOverwrite);
}

} // namespace views
