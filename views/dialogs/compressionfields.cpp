// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/dialogs/compressionfields.h"

#include "model/animation/settingsfields.h"
#include "model/codec/animationcodec.h"
#include "views/dialogs/numberfield.h"
#include "views/dialogs/quantitytext.h"

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
                CompressionFields::tr("more: larger and more exact"),
                CompressionFields::tr("Number of movements that the animation is put together from.")};
    if (key == "resolution" && codec == CodecId::Pca)
        return {CompressionFields::tr("&Resolution:"),
                CompressionFields::tr("Resolution"),
                CompressionFields::tr("steps per unit of length"),
                CompressionFields::tr(
                    "How finely numbers are rounded. Normalise, so that it means the same for every animation."),
                3,
                1000};
    return {};
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
            for (int v = int(field.least); v <= int(field.most); ++v)
                row.choice->addItem(QString::fromStdString(model::fieldText(Value(v))), v);
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
    showFieldsOfCodec();
}

CompressionSettings CompressionFields::settings() const
{
    CompressionSettings result{model::defaultSettings(codec())};
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
}

} // namespace views
