// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/actions/helpactions.h"

#include "app/editor/actions/shortcutdialog.h"
#include "app/editor/actions/shortcuts.h"
#include "views/viewport/glsupport.h"
#include "views/widgets/icons.h"

#include <QCoreApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QLabel>
#include <QTextBrowser>
#include <QVBoxLayout>

namespace editor {

namespace {

struct Library
{
    const char *name;
    const char *licence;
    const char *address;
};

constexpr Library Libraries[] = {
    {"Qt 6", "LGPL-3.0", "https://www.qt.io"},
    {"Eigen", "MPL-2.0", "https://eigen.tuxfamily.org"},
    {"assimp", "BSD-3-Clause", "https://assimp.org"},
    {"zlib", "Zlib", "https://zlib.net"},
    {"tl::expected", "CC0-1.0", "https://tl.tartanllama.xyz"},
    {"CLI11", "BSD-3-Clause", "https://github.com/CLIUtils/CLI11"},
};

/// A window with a page of text and Close, not modal: a list of keys is read while one works.
void showPage(QWidget &window, const QString &name, const QString &title, const QString &html, QSize size)
{
    auto *dialog = window.findChild<QDialog *>(name);
    if (dialog)
        dialog->close(); // made anew: its contents may have changed
    dialog = new QDialog(&window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setObjectName(name);
    dialog->setWindowTitle(title);
    auto *text = new QTextBrowser(dialog);
    text->setOpenExternalLinks(true);
    text->setHtml(html);
    text->setAccessibleName(title);
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Close, dialog);
    QObject::connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::close);
    auto *column = new QVBoxLayout(dialog);
    column->addWidget(text);
    column->addWidget(buttons);
    dialog->resize(size);
    dialog->show();
}

} // namespace

HelpActions::HelpActions(Actions &actions, Settings &settings, QWidget &window)
    : mActions(actions)
    , mSettings(settings)
    , mWindow(window)
{
    connect(&actions[ActionId::ConfigureShortcuts], &QAction::triggered, this, &HelpActions::configureShortcuts);
    connect(&actions[ActionId::ShortcutList], &QAction::triggered, this, &HelpActions::listShortcuts);
    connect(&actions[ActionId::Licences], &QAction::triggered, this, &HelpActions::showLicences);
    connect(&actions[ActionId::About], &QAction::triggered, this, &HelpActions::showAbout);
}

void HelpActions::configureShortcuts()
{
    auto *dialog = new ShortcutDialog(mActions, mSettings, &mWindow);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->open();
}

void HelpActions::listShortcuts()
{
    QString html = QStringLiteral("<table cellpadding='3' width='100%'>");
    const char *menu = nullptr;
    for (const Actions::Entry &entry : mActions.entries()) {
        if (entry.action->shortcuts().isEmpty())
            continue;
        if (!menu || qstrcmp(menu, entry.menu) != 0) {
            menu = entry.menu;
            html += QStringLiteral("<tr><td colspan='2'><br><b>%1</b></td></tr>")
                        .arg(plainTitle(QCoreApplication::translate("Actions", menu)).toHtmlEscaped());
        }
        html += QStringLiteral("<tr><td width='60%'>%1</td><td>%2</td></tr>")
                    .arg(entry.title().toHtmlEscaped(), shortcutText(entry.action->shortcuts()).toHtmlEscaped());
    }
    html += QStringLiteral("<tr><td colspan='2'><br><b>%1</b></td></tr>").arg(tr("Mouse in the Picture"));
    const std::pair<QString, QString> mouse[] = {
        {tr("Orbit"), tr("Left drag")},
        {tr("Pan"), tr("Middle drag, or Shift+left drag")},
        {tr("Zoom"), tr("Wheel, or right drag")},
        {tr("Close a tab"), tr("Middle click on it")},
    };
    for (const auto &[what, how] : mouse)
        html += QStringLiteral("<tr><td>%1</td><td>%2</td></tr>").arg(what.toHtmlEscaped(), how.toHtmlEscaped());
    showPage(mWindow, QStringLiteral("shortcutList"), tr("Keyboard Shortcuts"), html + QStringLiteral("</table>"),
             {520, 640});
}

void HelpActions::showLicences()
{
    QString html =
        QStringLiteral("<p>%1</p><table cellpadding='4'>")
            .arg(tr("Sandreel is free software under the GNU General Public License, version 3 or later. It is "
                    "made with these libraries:"));
    for (const Library &library : Libraries)
        html += QStringLiteral("<tr><td><b>%1</b></td><td>%2</td><td><a href='%3'>%3</a></td></tr>")
                    .arg(QLatin1String(library.name), QLatin1String(library.licence), QLatin1String(library.address));
    showPage(mWindow, QStringLiteral("licences"), tr("Licences"), html + QStringLiteral("</table>"), {560, 360});
}

void HelpActions::showAbout()
{
    auto *dialog = new QDialog(&mWindow);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setObjectName(QStringLiteral("about"));
    dialog->setWindowTitle(tr("About Sandreel"));
    auto *picture = new QLabel(dialog);
    picture->setPixmap(views::applicationIcon().pixmap(96, 96));
    const QString gl = views::glSupport().version;
    auto *text = new QLabel(
        QStringLiteral("<h2>Sandreel %1</h2><p>%2</p><p>%3<br>%4</p><p>%5</p>")
            .arg(QCoreApplication::applicationVersion().toHtmlEscaped(),
                 tr("Prepares, opens and plays mesh animations."), tr("Qt %1").arg(QLatin1String(qVersion())),
                 (gl.isEmpty() ? tr("No OpenGL") : tr("OpenGL %1").arg(gl)).toHtmlEscaped(),
                 tr("Free software under the GNU General Public License, version 3 or later. It comes without any "
                    "warranty.")),
        dialog);
    text->setWordWrap(true);
    text->setMinimumWidth(360);
    text->setTextInteractionFlags(Qt::TextSelectableByMouse);
    auto *row = new QHBoxLayout;
    row->setSpacing(20);
    row->addWidget(picture, 0, Qt::AlignTop);
    row->addWidget(text, 1);
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Close, dialog);
    connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::close);
    auto *column = new QVBoxLayout(dialog);
    column->setContentsMargins(20, 20, 20, 12);
    column->addLayout(row);
    column->addWidget(buttons);
    column->setSizeConstraint(QLayout::SetFixedSize);
    dialog->open();
}

} // namespace editor
