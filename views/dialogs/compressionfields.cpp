// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/dialogs/compressionfields.h"

#include "views/dialogs/numberfield.h"
#include "views/dialogs/quantitytext.h"

#include <QComboBox>
#include <QFormLayout>

#include <algorithm>

namespace views {

using model::CodecId;
using model::CompressionSettings;

namespace {

constexpr CodecId Codecs[] = {CodecId::Pca};

} // namespace

CompressionFields::CompressionFields(QFormLayout &form, QObject *parent)
    : QObject(parent)
    , mForm(form)
    , mCodec(new QComboBox(form.parentWidget()))
{
    QWidget *widgets = form.parentWidget();
    mCodec->setAccessibleName(tr("Codec"));
    mCodec->setObjectName(QStringLiteral("codec"));
    for (const CodecId id : Codecs)
        mCodec->addItem(codecName(id), int(id));
    mForm.addRow(tr("&Codec:"), mCodec);

    mBasisSize = addSetting(
        tr("&Basis size:"),
        new NumberField(tr("Basis size"),
                        {double(CompressionSettings::MinBasisSize), double(CompressionSettings::MaxBasisSize), 0},
                        widgets),
        {CodecId::Pca});
    mBasisSize->setObjectName(QStringLiteral("basisSize"));
    mBasisSize->setHint(tr("more: larger and more exact"));
    mBasisSize->setToolTip(tr("Number of movements that the animation is put together from."));
    mResolution = addSetting(
        tr("&Resolution:"),
        new NumberField(tr("Resolution"), {CompressionSettings::MinResolution, CompressionSettings::MaxResolution, 3},
                        widgets),
        {CodecId::Pca});
    mResolution->setObjectName(QStringLiteral("resolution"));
    mResolution->setStep(1000);
    mResolution->setHint(tr("steps per unit of length"));
    mResolution->setToolTip(
        tr("How finely numbers are rounded. Normalise, so that it means the same for every animation."));

    connect(mCodec, &QComboBox::currentIndexChanged, this, [this] {
        showSettingsOfCodec();
        emit changed();
    });
    setSettings({});
}

void CompressionFields::setSettings(const CompressionSettings &settings)
{
    mCodec->setCurrentIndex(std::max(0, mCodec->findData(int(settings.codec))));
    mBasisSize->setValue(settings.basisSize);
    mResolution->setValue(settings.resolution);
    showSettingsOfCodec();
}

CompressionSettings CompressionFields::settings() const
{
    CompressionSettings result;
    result.codec = codec();
    result.basisSize = std::uint32_t(mBasisSize->value().value_or(result.basisSize));
    result.resolution = mResolution->value().value_or(result.resolution);
    return result;
}

QString CompressionFields::problem() const
{
    for (const Setting &setting : mSettings)
        if (std::ranges::count(setting.codecs, codec()) && !setting.field->problem().isEmpty())
            return setting.field->problem();
    return {};
}

QString CompressionFields::codecName(CodecId codec)
{
    switch (codec) {
    case CodecId::Pca:
        return tr("PCA");
    }
    return {};
}

QString CompressionFields::summary(const CompressionSettings &settings)
{
    switch (settings.codec) {
    case CodecId::Pca:
        return tr("%1, basis %2, resolution %3")
            .arg(codecName(settings.codec), countText(settings.basisSize), numberText(settings.resolution, 3));
    }
    return {};
}

NumberField *CompressionFields::addSetting(const QString &label, NumberField *field, std::vector<CodecId> codecs)
{
    mForm.addRow(label, field);
    connect(field, &NumberField::changed, this, &CompressionFields::changed);
    mSettings.push_back({field, std::move(codecs)});
    return field;
}

CodecId CompressionFields::codec() const
{
    return CodecId(mCodec->currentData().toInt());
}

void CompressionFields::showSettingsOfCodec()
{
    for (const Setting &setting : mSettings)
        mForm.setRowVisible(setting.field, std::ranges::count(setting.codecs, codec()) > 0);
}

} // namespace views
