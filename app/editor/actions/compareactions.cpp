// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/actions/compareactions.h"

#include "app/editor/documents/animationtab.h"
#include "app/editor/start/settings.h"
#include "app/editor/window/workspace.h"
#include "model/io/errortext.h"
#include "views/dialogs/comparedialog.h"
#include "views/itemmodels/logmodel.h"
#include "views/viewport/errorcoloring.h"

#include <QFileInfo>

namespace editor {

CompareActions::CompareActions(Actions &actions, Workspace &workspace, const Settings &settings, views::LogModel &log,
                               QWidget &window)
    : mActions(actions)
    , mWorkspace(workspace)
    , mSettings(settings)
    , mLog(log)
    , mWindow(window)
{
    connect(&actions[ActionId::Compare], &QAction::triggered, this, &CompareActions::ask);
    connect(&actions[ActionId::StopComparing], &QAction::triggered, this, [this] {
        if (views::Comparison *compared = comparison())
            compared->stop();
    });
    connect(&actions[ActionId::ErrorColors], &QAction::toggled, this, &CompareActions::update);
    connect(&actions[ActionId::ErrorRange], &QAction::toggled, this, &CompareActions::update);
    connect(&workspace, &Workspace::currentChanged, this, &CompareActions::follow);
    connect(&workspace, &Workspace::currentStateChanged, this, &CompareActions::follow);
    follow();
}

views::Comparison *CompareActions::comparison() const
{
    AnimationTab *tab = mWorkspace.currentAnimation();
    return tab && tab->document().isOpen() ? &tab->document().comparison() : nullptr;
}

void CompareActions::follow()
{
    if (views::Comparison *compared = comparison()) {
        connect(compared, &views::Comparison::changed, this, &CompareActions::update, Qt::UniqueConnection);
        connect(compared, &views::Comparison::failed, this, &CompareActions::failed, Qt::UniqueConnection);
    }
    update();
}

void CompareActions::update()
{
    const views::Comparison *compared = comparison();
    const AnimationTab *tab = mWorkspace.currentAnimation();
    views::ErrorColoring *coloring = tab ? tab->errorColoring() : nullptr;
    const bool hasErrors = compared && compared->result();
    mActions[ActionId::Compare].setEnabled(compared != nullptr);
    mActions[ActionId::StopComparing].setEnabled(compared && compared->isActive());
    mActions[ActionId::ErrorColors].setEnabled(hasErrors && coloring);
    mActions[ActionId::ErrorRange].setEnabled(hasErrors && coloring && mActions[ActionId::ErrorColors].isChecked());
    if (!coloring)
        return;
    coloring->setErrorColored(mActions[ActionId::ErrorColors].isChecked());
    coloring->setErrorRangeOfFrame(mActions[ActionId::ErrorRange].isChecked());
}

void CompareActions::ask()
{
    views::Comparison *compared = comparison();
    if (!compared)
        return;
    OpenAnimation &document = mWorkspace.currentAnimation()->document();
    const model::FrameSourcePtr frames = document.context()->document().frames();
    std::vector<views::CompareDialog::Candidate> candidates;
    for (DocumentTab *open : mWorkspace.tabs()) {
        AnimationTab *tab = asAnimation(open);
        if (!tab || &tab->document() == &document || !tab->document().isOpen())
            continue;
        const model::FrameSourcePtr other = tab->document().context()->document().frames();
        if (other->frameCount() == frames->frameCount() && other->vertexCount() == frames->vertexCount())
            candidates.push_back({tab->document().title(), other});
    }
    const QString folder = document.path().isEmpty() ? mSettings.lastFolder() : QFileInfo(document.path()).path();
    auto *dialog = new views::CompareDialog(document.title(), std::move(candidates), folder, &mWindow);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    // The tab may be closed while the dialog is there.
    connect(compared, &QObject::destroyed, dialog, &QDialog::reject);
    connect(dialog, &QDialog::accepted, compared, [this, compared, dialog] {
        // Who asks for the error wants to see where it is.
        mActions[ActionId::ErrorColors].setChecked(true);
        compared->start(dialog->originalName(), dialog->reader());
    });
    dialog->open();
}

void CompareActions::failed(const QString &name, const model::Error &error)
{
    if (error.code == model::ErrorCode::Cancelled)
        return;
    const QString text =
        tr("The animation cannot be compared with %1.").arg(name) + QLatin1Char(' ') + model::io::errorText(error);
    mLog.add(views::LogLevel::Error, text);
    mWorkspace.messages().add(views::MessageBar::Kind::Error, text);
}

} // namespace editor
