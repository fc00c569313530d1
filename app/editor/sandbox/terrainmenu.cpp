// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/sandbox/terrainmenu.h"

#include "app/editor/actions/actions.h"
#include "app/editor/actions/menus.h"
#include "app/editor/sandbox/sandbox.h"
#include "views/docks/terrain/erosiondock.h"
#include "views/sculpt/toolvalues.h"
#include "views/widgets/icons.h"

#include <QActionGroup>
#include <QCoreApplication>
#include <QMenu>

namespace editor {

using model::terrain::Symmetry;
using model::terrain::Tool;

namespace {

/// Bigger and smaller; stronger and weaker.
constexpr double RadiusStep = 1.1, AmountStep = 1.25;
/// Of the tools in their order.
constexpr const char *ToolKeys[] = {"1", "2", "3", "4", "5", "6", "7", "8", "9", "0", "Shift+1", "Shift+2", "Shift+3"};
static_assert(std::size(ToolKeys) == std::variant_size_v<Tool>);

QString translated(const char *text)
{
    return QCoreApplication::translate("Actions", text);
}

} // namespace

struct TerrainMenu::Row
{
    const char *key;
    const char *icon;
    const char *shortcut;
    const char *text; ///< null: a separator
    const char *tip;
    void (*trigger)(Sandbox &, bool isOn);
    bool isCheckable = false;
    bool isRepeated = false; ///< while its key is held
    RowGroup group = ToolRows;
};

const std::vector<TerrainMenu::Row> &TerrainMenu::rows()
{
    static const std::vector<Row> all = {
        {"terrain.bigger", "bigger", "]", QT_TRANSLATE_NOOP("Actions", "&Bigger Tool"),
         QT_TRANSLATE_NOOP("Actions", "Make the tool a tenth wider"),
         [](Sandbox &s, bool) { s.settings().scaleRadius(RadiusStep); }, false, true},
        {"terrain.smaller", "smaller", "[", QT_TRANSLATE_NOOP("Actions", "S&maller Tool"),
         QT_TRANSLATE_NOOP("Actions", "Make the tool a tenth narrower"),
         [](Sandbox &s, bool) { s.settings().scaleRadius(1 / RadiusStep); }, false, true},
        {"terrain.stronger", "stronger", "Ctrl+]", QT_TRANSLATE_NOOP("Actions", "St&ronger Tool"),
         QT_TRANSLATE_NOOP("Actions", "Let each stamp do a quarter more"),
         [](Sandbox &s, bool) { s.settings().scaleAmount(AmountStep); }, false, true},
        {"terrain.weaker", "weaker", "Ctrl+[", QT_TRANSLATE_NOOP("Actions", "&Weaker Tool"),
         QT_TRANSLATE_NOOP("Actions", "Let each stamp do a fifth less"),
         [](Sandbox &s, bool) { s.settings().scaleAmount(1 / AmountStep); }, false, true},
        {"", "", "", nullptr, nullptr, nullptr},
        {"terrain.slide", "slide", "Shift+S", QT_TRANSLATE_NOOP("Actions", "S&lide While Drawing"),
         QT_TRANSLATE_NOOP("Actions", "What is too steep slides while you draw and after it"),
         [](Sandbox &s, bool isOn) {
             views::FlowSettings flow = s.settings().flow();
             flow.isOn = isOn;
             s.settings().setFlow(flow);
         },
         true},
        {"terrain.run", "play", "R", QT_TRANSLATE_NOOP("Actions", "&Run Erosion"),
         QT_TRANSLATE_NOOP("Actions", "Let everything that is too steep slide, or hold it"),
         [](Sandbox &s, bool) { s.erosion().runOrPause(); }},
        {"terrain.step", "step-forward", "Shift+R", QT_TRANSLATE_NOOP("Actions", "Step &Erosion"),
         QT_TRANSLATE_NOOP("Actions", "Go once over everything that is too steep"),
         [](Sandbox &s, bool) { s.erosion().step(); }},
        {"terrain.settle", "settle", "Ctrl+R", QT_TRANSLATE_NOOP("Actions", "Erode &Until Settled"),
         QT_TRANSLATE_NOOP("Actions", "Let everything slide in the background, until no face is too steep"),
         [](Sandbox &s, bool) { s.erosion().settle(); }},
        {"", "", "", nullptr, nullptr, nullptr},
        {"terrain.reference", "reference", "", QT_TRANSLATE_NOOP("Actions", "Take Re&ference"),
         QT_TRANSLATE_NOOP("Actions", "Restore, cut and fill, and the cross-section go by the ground as it is now"),
         [](Sandbox &s, bool) { s.takeReference(); }},
        {"terrain.clearMask", "clear", "Ctrl+M", QT_TRANSLATE_NOOP("Actions", "Clear Mas&k"),
         QT_TRANSLATE_NOOP("Actions", "Open all ground to tools"), [](Sandbox &s, bool) { s.clearMask(); }, false,
         false, MaskRows},
        {"terrain.invertMask", "symmetry", "Ctrl+Shift+M", QT_TRANSLATE_NOOP("Actions", "&Invert Mask"),
         QT_TRANSLATE_NOOP("Actions", "Protect what is open, and open what is protected"),
         [](Sandbox &s, bool) { s.invertMask(); }, false, false, MaskRows},
    };
    return all;
}

TerrainMenu::TerrainMenu(Actions &actions, Menus &menus, Sandbox &sandbox)
    : mActions(actions)
    , mSandbox(sandbox)
    , mTools(new QActionGroup(this))
    , mSymmetries(new QActionGroup(this))
{
    makeTools(menus);
    makeSymmetries(menus);
    makeRows(menus, ToolRows);
    for (QAction *mode : {&sandbox.pickAction(), &sandbox.maskAction()}) {
        menus.terrainMenu().addAction(mode);
        actions.adopt(*mode, QT_TRANSLATE_NOOP("Actions", "&Terrain"), DocumentKind::Terrain);
    }
    makeRows(menus, MaskRows);
    menus.terrainMenu().addSeparator();
    Feeling &feeling = sandbox.feeling();
    for (QAction *action : {&feeling.modeAction(), &feeling.forcesAction(), &feeling.stopAction()}) {
        menus.terrainMenu().addAction(action);
        actions.adopt(*action, QT_TRANSLATE_NOOP("Actions", "&Terrain"), DocumentKind::Terrain);
    }
    mTexts.push_back([&feeling] {
        feeling.modeAction().setText(translated(QT_TRANSLATE_NOOP("Actions", "Feel with the Mouse (&Haptics)")));
        feeling.modeAction().setStatusTip(translated(
            QT_TRANSLATE_NOOP("Actions", "The mouse moves the simulated haptic device, the wheel presses it in")));
        feeling.forcesAction().setText(translated(QT_TRANSLATE_NOOP("Actions", "Haptic F&orces")));
        feeling.forcesAction().setStatusTip(
            translated(QT_TRANSLATE_NOOP("Actions", "Let the haptic device push; off at every start")));
        feeling.stopAction().setText(translated(QT_TRANSLATE_NOOP("Actions", "Sto&p All Forces")));
        feeling.stopAction().setStatusTip(
            translated(QT_TRANSLATE_NOOP("Actions", "Forces off, at once; Escape does the same anywhere")));
        feeling.retranslate();
    });
    mTexts.push_back([&pick = sandbox.pickAction(), &paint = sandbox.maskAction()] {
        paint.setText(translated(QT_TRANSLATE_NOOP("Actions", "Paint M&ask")));
        paint.setStatusTip(translated(QT_TRANSLATE_NOOP(
            "Actions", "The left button protects ground from all tools; with Ctrl it opens it again")));
        pick.setText(translated(QT_TRANSLATE_NOOP("Actions", "Pick &Cross-Section")));
        pick.setStatusTip(translated(QT_TRANSLATE_NOOP(
            "Actions", "The left button draws the line along which the ground is cut, and moves its ends")));
    });
    connect(&sandbox, &Sandbox::stateChanged, this, &TerrainMenu::follow);
    connect(&sandbox.erosion(), &views::ErosionDock::stateChanged, this, &TerrainMenu::follow);
    connect(&sandbox.settings(), &views::ToolSettings::toolChanged, this, &TerrainMenu::follow);
    connect(&sandbox.settings(), &views::ToolSettings::flowChanged, this, &TerrainMenu::follow);
    retranslate();
    follow();
}

QAction &TerrainMenu::add(const QString &name, const QString &iconName, const char *shortcut,
                          std::function<QString()> text, std::function<QString()> tip)
{
    auto *action = new QAction(this);
    action->setObjectName(name);
    if (!iconName.isEmpty())
        action->setIcon(views::icon(iconName));
    if (*shortcut)
        action->setShortcuts(QKeySequence::listFromString(QLatin1String(shortcut)));
    action->setAutoRepeat(false);
    mTexts.push_back([action, text = std::move(text), tip = std::move(tip)] {
        action->setText(text());
        action->setStatusTip(tip());
    });
    mActions.adopt(*action, QT_TRANSLATE_NOOP("Actions", "&Terrain"), DocumentKind::Terrain);
    return *action;
}

void TerrainMenu::makeTools(Menus &menus)
{
    for (const Tool &tool : mSandbox.settings().tools()) {
        const QString name = QLatin1String(nameOf(tool));
        QAction &action = add(
            QStringLiteral("tool.") + name, QStringLiteral("tool-") + name, ToolKeys[tool.index()],
            [tool] { return views::titleOf(tool); }, [tool] { return views::hintOf(tool); });
        action.setCheckable(true);
        mTools->addAction(&action);
        menus.toolMenu().addAction(&action);
        connect(&action, &QAction::triggered, this, [this, kind = tool.index()] { mSandbox.chooseTool(kind); });
    }
}

void TerrainMenu::makeSymmetries(Menus &menus)
{
    static constexpr std::pair<const char *, const char *> Kinds[] = {
        {"symmetry.off", QT_TRANSLATE_NOOP("Actions", "&Off")},
        {"symmetry.x", QT_TRANSLATE_NOOP("Actions", "&Left and Right")},
        {"symmetry.y", QT_TRANSLATE_NOOP("Actions", "&Front and Back")},
        {"symmetry.both", QT_TRANSLATE_NOOP("Actions", "&Both")},
        {"symmetry.radial", QT_TRANSLATE_NOOP("Actions", "&Around")},
    };
    for (int kind = 0; kind < int(std::size(Kinds)); ++kind) {
        const auto &[key, text] = Kinds[kind];
        QAction &action = add(
            QLatin1String(key), {}, "", [text = text] { return translated(text); },
            [] { return translated(QT_TRANSLATE_NOOP("Actions", "Draw mirrored or turned copies of each stroke")); });
        action.setCheckable(true);
        mSymmetries->addAction(&action);
        menus.symmetryMenu().addAction(&action);
        connect(&action, &QAction::triggered, this, [this, kind] {
            Symmetry symmetry = mSandbox.settings().symmetry();
            symmetry.kind = Symmetry::Kind(kind);
            mSandbox.settings().setSymmetry(symmetry);
        });
    }
}

void TerrainMenu::makeRows(Menus &menus, RowGroup group)
{
    for (const Row &row : rows()) {
        if (row.group != group)
            continue;
        if (!row.text) {
            menus.terrainMenu().addSeparator();
            continue;
        }
        QAction &action = add(
            QLatin1String(row.key), QLatin1String(row.icon), row.shortcut,
            [text = row.text] { return translated(text); }, [tip = row.tip] { return translated(tip); });
        action.setCheckable(row.isCheckable);
        action.setAutoRepeat(row.isRepeated);
        menus.terrainMenu().addAction(&action);
        connect(&action, &QAction::triggered, this,
                [this, trigger = row.trigger](bool isOn) { trigger(mSandbox, isOn); });
    }
}

QAction &TerrainMenu::named(const char *key) const
{
    return *findChild<QAction *>(QLatin1String(key), Qt::FindDirectChildrenOnly);
}

void TerrainMenu::follow()
{
    const bool hasTerrain = mSandbox.erosion().hasTerrain();
    const bool isRunning = mSandbox.erosion().isRunning(), isSettling = mSandbox.erosion().isSettling();
    for (QAction *action : findChildren<QAction *>(QString(), Qt::FindDirectChildrenOnly))
        action->setEnabled(hasTerrain);
    for (QAction *mode : {&mSandbox.pickAction(), &mSandbox.maskAction()})
        mode->setEnabled(hasTerrain);
    const views::ToolSettings &settings = mSandbox.settings();
    mTools->actions()[qsizetype(settings.tool().index())]->setChecked(true);
    mSymmetries->actions()[qsizetype(settings.symmetry().kind)]->setChecked(true);
    const bool hasAmount = views::amountKindOf(settings.tool()) != views::AmountKind::None;
    for (const char *key : {"terrain.stronger", "terrain.weaker"})
        named(key).setEnabled(hasTerrain && hasAmount);
    named("terrain.slide").setChecked(settings.flow().isOn);
    QAction &run = named("terrain.run");
    run.setEnabled(hasTerrain && !isSettling);
    run.setIcon(views::icon(isRunning ? QStringLiteral("pause") : QStringLiteral("play")));
    run.setText(translated(isRunning ? QT_TRANSLATE_NOOP("Actions", "&Pause Erosion") : "&Run Erosion"));
    named("terrain.step").setEnabled(hasTerrain && !isSettling && !isRunning);
    named("terrain.settle").setEnabled(hasTerrain && !isSettling);
}

void TerrainMenu::retranslate()
{
    for (const auto &set : mTexts)
        set();
    follow();
}

} // namespace editor
