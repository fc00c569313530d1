// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/docks/terrain/toolsdock.h"

#include "views/dialogs/numberfield.h"
#include "views/docks/terrain/dockform.h"
#include "views/sculpt/toolvalues.h"

#include <QButtonGroup>
#include <QCheckBox>
#include <QComboBox>
#include <QEvent>
#include <QFormLayout>
#include <QGridLayout>
#include <QGroupBox>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

namespace views {

using namespace model::terrain;

namespace {

constexpr int ToolColumns = 3;

/// What the tool was made of, without how large it is: a preset stays one when it is scaled to the terrain.
bool isPreset(const Tool &tool, const ToolPreset &preset)
{
    if (tool.index() != preset.tool.index() || !(radiusOf(preset.tool) > 0))
        return false;
    const Tool same = scaled(preset.tool, radiusOf(tool) / radiusOf(preset.tool));
    for (const ToolField &field : fieldsOf(tool)) {
        const double a = field.value(tool), b = field.value(same);
        if (std::abs(a - b) > 1e-9 * std::max(1.0, std::abs(b)))
            return false;
    }
    return true;
}

} // namespace

ToolsDock::ToolsDock(ToolSettings &settings, QWidget *parent)
    : QDockWidget(parent)
    , mSettings(settings)
{
    setObjectName(QStringLiteral("toolsDock"));
    build();
    connect(&mSettings, &ToolSettings::toolChanged, this, &ToolsDock::show);
}

ToolsDock::~ToolsDock() = default;

void ToolsDock::changeEvent(QEvent *event)
{
    if (event->type() == QEvent::LanguageChange)
        build();
    QDockWidget::changeEvent(event);
}

void ToolsDock::build()
{
    setWindowTitle(tr("Tools"));
    auto *content = new QWidget;
    auto *column = new QVBoxLayout(content);
    column->addWidget(makeTools(content));
    mFieldsBox = new QGroupBox(content);
    new QFormLayout(mFieldsBox);
    mTakeReference = new QPushButton(tr("Take &Reference"), content);
    mTakeReference->setObjectName(QStringLiteral("takeReference"));
    mTakeReference->setToolTip(tr("From now on, Restore brings back the ground as it is at this moment. Until then it "
                                  "is that of the last save."));
    connect(mTakeReference, &QPushButton::clicked, this, &ToolsDock::referenceRequested);
    mMaskBox = new QGroupBox(tr("Only Where"), content);
    new QFormLayout(mMaskBox);
    column->addWidget(mFieldsBox);
    column->addWidget(mTakeReference);
    column->addWidget(makeSymmetry(content));
    column->addWidget(mMaskBox);
    column->addStretch();
    mShape.clear();
    setScrolledWidget(*this, content);
    show();
}

QWidget *ToolsDock::makeTools(QWidget *parent)
{
    auto *part = new QWidget(parent);
    auto *grid = new QGridLayout(part);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(2);
    mTools = new QButtonGroup(part);
    for (std::size_t i = 0; i < mSettings.tools().size(); ++i) {
        const Tool &tool = mSettings.tools()[i];
        auto *button = new QToolButton(part);
        button->setObjectName(QLatin1String("tool.") + QLatin1String(nameOf(tool)));
        button->setText(titleOf(tool));
        button->setToolTip(hintOf(tool));
        button->setAccessibleName(titleOf(tool));
        button->setCheckable(true);
        button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        mTools->addButton(button, int(i));
        grid->addWidget(button, int(i) / ToolColumns, int(i) % ToolColumns);
    }
    connect(mTools, &QButtonGroup::idClicked, this, [this](int id) { mSettings.choose(std::size_t(id)); });
    mPresets = new QComboBox(part);
    mPresets->setObjectName(QStringLiteral("presets"));
    mPresets->setAccessibleName(tr("Ready-made tools"));
    mPresets->addItem(tr("Custom"));
    for (const ToolPreset &preset : toolPresets())
        mPresets->addItem(preset.title);
    connect(mPresets, &QComboBox::activated, this, &ToolsDock::applyPreset);
    const int row = int(mSettings.tools().size() - 1) / ToolColumns + 1;
    grid->addWidget(mPresets, row, 0, 1, ToolColumns);
    return part;
}

void ToolsDock::applyPreset(int row)
{
    const std::vector<ToolPreset> presets = toolPresets();
    if (row < 1 || row > int(presets.size()))
        return;
    // In proportion to the terrain: the tools were fitted to it.
    const ToolPreset &preset = presets[std::size_t(row - 1)];
    mSettings.setTool(scaled(preset.tool, mSettings.terrainSide()));
}

QWidget *ToolsDock::makeSymmetry(QWidget *parent)
{
    auto *box = new QGroupBox(tr("Symmetry"), parent);
    auto *form = new QFormLayout(box);
    mSymmetry = new QComboBox(box);
    mSymmetry->setObjectName(QStringLiteral("symmetry"));
    mSymmetry->addItems({tr("Off"), tr("Left and Right"), tr("Front and Back"), tr("Both"), tr("Around")});
    addRow(*form, tr("&Copies:"), mSymmetry);
    mCopies = new NumberField(tr("Number of copies"), {2, 64, 0}, box);
    addRow(*form, tr("N&umber:"), mCopies);
    mCentreX = new NumberField(tr("Centre X"), {-1e7, 1e7, 3}, box);
    mCentreY = new NumberField(tr("Centre Y"), {-1e7, 1e7, 3}, box);
    addRow(*form, tr("Centre &X:"), mCentreX, QStringLiteral("m"));
    addRow(*form, tr("Centre &Y:"), mCentreY, QStringLiteral("m"));
    connect(mSymmetry, &QComboBox::activated, this, &ToolsDock::takeSymmetry);
    for (NumberField *field : {mCopies, mCentreX, mCentreY})
        connect(field, &NumberField::changed, this, &ToolsDock::takeSymmetry);
    return box;
}

void ToolsDock::takeSymmetry()
{
    if (mIsShowing || !mCopies->value() || !mCentreX->value() || !mCentreY->value())
        return;
    mSettings.setSymmetry({Symmetry::Kind(mSymmetry->currentIndex()),
                           {*mCentreX->value(), *mCentreY->value()},
                           std::uint32_t(*mCopies->value())});
}

void ToolsDock::showSymmetry()
{
    const Symmetry &symmetry = mSettings.symmetry();
    mSymmetry->setCurrentIndex(int(symmetry.kind));
    showNumber(*mCopies, symmetry.copies);
    showNumber(*mCentreX, symmetry.centre.x);
    showNumber(*mCentreY, symmetry.centre.y);
    const bool isOn = symmetry.kind != Symmetry::Kind::Off;
    setRowVisible(mCopies, symmetry.kind == Symmetry::Kind::Radial);
    setRowVisible(mCentreX, isOn);
    setRowVisible(mCentreY, isOn);
}

void ToolsDock::fillForm(QFormLayout &form, const std::vector<ToolField> &fields)
{
    clearForm(form);
    for (const ToolField &field : fields) {
        const auto set = [this, write = field.setValue](double value) {
            if (mIsShowing)
                return;
            Tool tool = mSettings.tool();
            write(tool, value);
            mSettings.setTool(tool);
        };
        QWidget *editor = nullptr;
        if (field.kind == ToolField::Kind::Flag) {
            auto *box = new QCheckBox(field.label);
            connect(box, &QCheckBox::toggled, this, set);
            mRefresh.push_back([=, this] { box->setChecked(field.value(mSettings.tool()) != 0); });
            form.addRow(box);
            editor = box;
        } else if (field.kind == ToolField::Kind::Choice) {
            auto *combo = new QComboBox;
            combo->addItems(field.choices);
            connect(combo, &QComboBox::activated, this, set);
            mRefresh.push_back([=, this] { combo->setCurrentIndex(int(field.value(mSettings.tool()))); });
            addRow(form, tr("%1:").arg(field.label), combo);
            editor = combo;
        } else {
            auto *number = new NumberField(field.label, {field.min, field.max, field.decimals});
            number->setStep(field.step);
            connect(number, &NumberField::changed, this, [=] {
                if (number->value())
                    set(*number->value());
            });
            mRefresh.push_back([=, this] { showNumber(*number, field.value(mSettings.tool())); });
            addRow(form, tr("%1:").arg(field.label), number, field.unit);
            editor = number;
        }
        editor->setToolTip(field.hint);
    }
}

/// The fields of the chosen tool, made anew only if there are others.
void ToolsDock::makeForm()
{
    const std::vector<ToolField> fields = fieldsOf(mSettings.tool()), mask = maskFieldsOf(mSettings.tool());
    QString shape = titleOf(mSettings.tool());
    for (const ToolField &field : fields)
        shape += QLatin1Char('|') + field.label + QString::number(field.choices.size());
    if (shape == mShape)
        return;
    mShape = shape;
    mRefresh.clear();
    mFieldsBox->setTitle(titleOf(mSettings.tool()));
    fillForm(*static_cast<QFormLayout *>(mFieldsBox->layout()), fields);
    fillForm(*static_cast<QFormLayout *>(mMaskBox->layout()), mask);
    mMaskBox->setVisible(!mask.empty());
    mTakeReference->setVisible(std::holds_alternative<Restore>(mSettings.tool()));
}

void ToolsDock::show()
{
    if (mIsShowing)
        return;
    mIsShowing = true;
    const Tool &tool = mSettings.tool();
    mTools->button(int(tool.index()))->setChecked(true);
    makeForm();
    for (const auto &refresh : mRefresh)
        refresh();
    const std::vector<ToolPreset> presets = toolPresets();
    int row = 0;
    for (std::size_t i = 0; i < presets.size() && row == 0; ++i)
        if (isPreset(tool, presets[i]))
            row = int(i) + 1;
    mPresets->setCurrentIndex(row);
    showSymmetry();
    mIsShowing = false;
}

} // namespace views
