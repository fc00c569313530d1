// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/dialogs/compressionfields.h"

#include "model/animation/settingsfields.h"
#include "model/codec/animationcodec.h"
#include "views/dialogs/numberfield.h"
#include "views/dialogs/quantitytext.h"

#include <QAbstractItemView>
#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>

#include <algorithm>

namespace views {

using model::CodecId;
using model::CompressionSettings;

namespace {

/// What a field says of itself. The texts are translated in the context of CompressionFields.
struct FieldTexts
{
    QString label; ///< of its row
    QString name;  ///< for a sentence, and for who cannot see
    QString hint;
    QString toolTip;
    int decimals = 0;
    double step = 1; ///< of the arrow keys
};

FieldTexts textsOf(CodecId codec, std::string_view key)
{
    if (key == "basis")
        return {CompressionFields::tr("&Basis size:"), CompressionFields::tr("Basis size"),
                codec == CodecId::Reel ? CompressionFields::tr("0: as many as pay")
                                       : CompressionFields::tr("more: larger and more exact"),
                CompressionFields::tr("Number of movements that the animation is put together from.")};
    if (key == "resolution" && codec == CodecId::Direct)
        return {CompressionFields::tr("&Resolution:"),
                CompressionFields::tr("Resolution"),
                CompressionFields::tr("cells along the longest side"),
                CompressionFields::tr("No vertex is farther off than half the diagonal of a cell."),
                0,
                1000};
    if (key == "resolution")
        return {CompressionFields::tr("&Resolution:"),
                CompressionFields::tr("Resolution"),
                CompressionFields::tr("steps per unit of length"),
                CompressionFields::tr(
                    "How finely numbers are rounded. Normalise, so that it means the same for every animation."),
                3,
                1000};
    if (key == "step")
        return {CompressionFields::tr("St&ep:"),
                CompressionFields::tr("Step"),
                CompressionFields::tr("less: larger and more exact"),
                CompressionFields::tr("How finely the movements' shares are rounded, relative to their mean size."),
                7,
                0.001};
    if (key == "basis-step")
        return {CompressionFields::tr("Basis s&tep:"),
                CompressionFields::tr("Basis step"),
                CompressionFields::tr("less: larger and more exact"),
                CompressionFields::tr("How finely the movements themselves are rounded."),
                7,
                0.001};
    if (key == "predictor")
        return {CompressionFields::tr("&Prediction:"),
                CompressionFields::tr("Prediction"),
                {},
                CompressionFields::tr("What a vertex is expected to do: the better the guess, the smaller the file.")};
    if (key == "entropy")
        return {CompressionFields::tr("Packin&g:"),
                CompressionFields::tr("Packing"),
                {},
                CompressionFields::tr("How the differences from what was expected are packed.")};
    return {};
}

QString choiceText(model::Predictor value)
{
    switch (value) {
    case model::Predictor::None:
        return CompressionFields::tr("None");
    case model::Predictor::Still:
        return CompressionFields::tr("A: stays where it was");
    case model::Predictor::Steady:
        return CompressionFields::tr("B: goes on as it moved");
    case model::Predictor::Accelerating:
        return CompressionFields::tr("C: goes on as it accelerated");
    case model::Predictor::Neighbours:
        return CompressionFields::tr("N: moves with its neighbours");
    }
    return {};
}

QString choiceText(model::Entropy value)
{
    return value == model::Entropy::Deflate ? CompressionFields::tr("Deflate") : CompressionFields::tr("Range coder");
}

} // namespace

QWidget *CompressionFields::Row::widget() const
{
    return number ? static_cast<QWidget *>(number) : choice;
}

CompressionFields::CompressionFields(QFormLayout &form, QObject *parent)
    : QObject(parent)
    , mForm(form)
    , mCodec(new QComboBox(form.parentWidget()))
{
    mCodec->setAccessibleName(tr("Codec"));
    mCodec->setObjectName(QStringLiteral("codec"));
    mForm.addRow(tr("&Codec:"), mCodec);
    for (const CodecId id : model::codec::availableCodecs()) {
        mCodec->addItem(codecName(id), int(id));
        addRows(id);
    }
    mKeepOrder = new QCheckBox(tr("Keep the order of the &vertices"), form.parentWidget());
    mKeepOrder->setObjectName(QStringLiteral("keepOrder"));
    mKeepOrder->setToolTip(tr("Without it the file is a little smaller, and vertices are numbered anew."));
    mForm.addRow(QString(), mKeepOrder);
    connect(mKeepOrder, &QCheckBox::toggled, this, &CompressionFields::changed);
    connect(mCodec, &QComboBox::currentIndexChanged, this, [this] {
        showFieldsOfCodec();
        emit changed();
    });
    setSettings({});
}

void CompressionFields::addRows(CodecId codec)
{
    model::CodecSettings method = model::defaultSettings(codec);
    model::visitFields(method, [&](const auto &field, const auto &value) {
        using Value = std::remove_cvref_t<decltype(value)>;
        const FieldTexts texts = textsOf(codec, field.key);
        Row row{codec, field.key};
        QWidget *parent = mForm.parentWidget();
        if constexpr (model::IsNumberField<Value>) {
            row.number = new NumberField(texts.name, {double(field.least), double(field.most), texts.decimals}, parent);
            row.number->setHint(texts.hint);
            row.number->setStep(texts.step);
            row.number->setValue(double(value));
            connect(row.number, &NumberField::changed, this, &CompressionFields::changed);
        } else {
            row.choice = new QComboBox(parent);
            row.choice->setAccessibleName(texts.name);
            row.choice->view()->setAccessibleName(texts.name);
            // A dock is narrow: the longest text may be cut there, and is whole in the list.
            row.choice->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
            row.choice->setMinimumContentsLength(10);
            for (int v = int(field.least); v <= int(field.most); ++v)
                row.choice->addItem(choiceText(Value(v)), v);
            row.choice->setCurrentIndex(row.choice->findData(int(value)));
            connect(row.choice, &QComboBox::currentIndexChanged, this, &CompressionFields::changed);
        }
        const std::string_view codecName = model::codecKey(codec);
        row.widget()->setObjectName(QString::fromUtf8(codecName.data(), qsizetype(codecName.size())) + u'-' +
                                    QString::fromUtf8(field.key.data(), qsizetype(field.key.size())));
        row.widget()->setToolTip(texts.toolTip);
        mForm.addRow(texts.label, row.widget());
        mRows.push_back(row);
    });
}

const CompressionFields::Row *CompressionFields::rowOf(CodecId codec, std::string_view key) const
{
    const auto found = std::ranges::find_if(mRows, [&](const Row &r) { return r.codec == codec && r.key == key; });
    return found == mRows.end() ? nullptr : &*found;
}

void CompressionFields::setSettings(const CompressionSettings &settings)
{
    mCodec->setCurrentIndex(std::max(0, mCodec->findData(int(settings.codec()))));
    model::visitFields(settings.method, [&](const auto &field, const auto &value) {
        const Row *row = rowOf(settings.codec(), field.key);
        if (!row)
            return;
        if constexpr (model::IsNumberField<std::remove_cvref_t<decltype(value)>>)
            row->number->setValue(double(value));
        else
            row->choice->setCurrentIndex(row->choice->findData(int(value)));
    });
    mKeepOrder->setChecked(settings.keepOrder);
    showFieldsOfCodec();
}

CompressionSettings CompressionFields::settings() const
{
    CompressionSettings result{model::defaultSettings(codec()), mKeepOrder->isChecked()};
    model::visitFields(result.method, [&](const auto &field, auto &value) {
        using Value = std::remove_cvref_t<decltype(value)>;
        const Row *row = rowOf(codec(), field.key);
        if constexpr (model::IsNumberField<Value>)
            value = Value(row->number->value().value_or(double(value)));
        else
            value = Value(row->choice->currentData().toInt());
    });
    return result;
}

QString CompressionFields::problem() const
{
    for (const Row &row : mRows)
        if (row.codec == codec() && row.number && !row.number->problem().isEmpty())
            return row.number->problem();
    return {};
}

std::vector<NumberField *> CompressionFields::numberFields() const
{
    std::vector<NumberField *> fields;
    for (const Row &row : mRows)
        if (row.number)
            fields.push_back(row.number);
    return fields;
}

NumberField *CompressionFields::numberField(std::string_view key) const
{
    const Row *row = rowOf(codec(), key);
    return row ? row->number : nullptr;
}

QWidget *CompressionFields::firstField() const
{
    const auto first = std::ranges::find_if(mRows, [&](const Row &row) { return row.codec == codec(); });
    return first->widget();
}

QString CompressionFields::codecName(CodecId codec)
{
    switch (codec) {
    case CodecId::Direct:
        return tr("Direct");
    case CodecId::Pca:
        return tr("PCA");
    case CodecId::Coddyac:
        return tr("CoDDyaC");
    case CodecId::Reel:
        return tr("Reel");
    }
    return {};
}

QString CompressionFields::summary(const CompressionSettings &settings)
{
    QStringList parts{codecName(settings.codec())};
    model::visitFields(settings.method, [&](const auto &field, const auto &value) {
        QString shown;
        if constexpr (model::IsNumberField<std::remove_cvref_t<decltype(value)>>)
            shown = numberText(double(value), textsOf(settings.codec(), field.key).decimals);
        else
            shown = QString::fromStdString(model::fieldText(value));
        if (field.key == "basis")
            parts << tr("basis %1").arg(shown);
        else if (field.key == "resolution")
            parts << tr("resolution %1").arg(shown);
        else if (field.key == "predictor")
            parts << tr("prediction %1").arg(shown);
        else if (field.key == "entropy")
            parts << shown;
        else if (field.key == "step")
            parts << tr("step %1").arg(shown);
        else if (field.key == "basis-step")
            parts << tr("basis step %1").arg(shown);
    });
    return parts.join(QStringLiteral(", "));
}

CodecId CompressionFields::codec() const
{
    return CodecId(mCodec->currentData().toInt());
}

void CompressionFields::showFieldsOfCodec()
{
    for (const Row &row : mRows)
        mForm.setRowVisible(row.widget(), row.codec == codec());
    mForm.setRowVisible(mKeepOrder, !model::keepsOrderAnyway(codec()));
}

} // namespace views
