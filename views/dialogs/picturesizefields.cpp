// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/dialogs/picturesizefields.h"

#include "views/dialogs/numberfield.h"

#include <QComboBox>
#include <QFormLayout>

namespace views {

PictureSizeFields::PictureSizeFields(QFormLayout &form, QSize window, QSize largest, QObject *parent)
    : QObject(parent)
    , mLargest(largest)
    , mForm(form)
    , mPreset(new QComboBox)
    , mWidth(new NumberField(tr("Width"), {16, double(largest.width()), 0}))
    , mHeight(new NumberField(tr("Height"), {16, double(largest.height()), 0}))
    , mScale(new QComboBox)
{
    mPreset->setObjectName(QStringLiteral("pictureSize"));
    mPreset->setAccessibleName(tr("Size"));
    mPreset->addItem(tr("As in the window (%1 × %2)").arg(window.width()).arg(window.height()), window);
    for (const QSize size : {QSize(1280, 720), QSize(1920, 1080), QSize(3840, 2160)})
        mPreset->addItem(tr("%1 × %2").arg(size.width()).arg(size.height()), size);
    mPreset->addItem(tr("Other"));
    mWidth->setObjectName(QStringLiteral("pictureWidth"));
    mHeight->setObjectName(QStringLiteral("pictureHeight"));
    mWidth->setHint(tr("pixels"));
    mHeight->setHint(tr("pixels"));
    mWidth->setValue(window.width());
    mHeight->setValue(window.height());
    mScale->setObjectName(QStringLiteral("pictureScale"));
    mScale->setAccessibleName(tr("Scale"));
    for (int scale = 1; scale <= 4; ++scale)
        mScale->addItem(QStringLiteral("%1 ×").arg(scale), scale);
    form.addRow(tr("Si&ze:"), mPreset);
    form.addRow(tr("&Width:"), mWidth);
    form.addRow(tr("&Height:"), mHeight);
    form.addRow(tr("S&cale:"), mScale);
    showCustomRows();
    connect(mPreset, &QComboBox::currentIndexChanged, this, [this] {
        showCustomRows();
        emit changed();
    });
    connect(mScale, &QComboBox::currentIndexChanged, this, &PictureSizeFields::changed);
    connect(mWidth, &NumberField::changed, this, &PictureSizeFields::changed);
    connect(mHeight, &NumberField::changed, this, &PictureSizeFields::changed);
}

QString PictureSizeFields::problem() const
{
    if (!mPreset->currentData().isValid())
        for (const NumberField *field : {mWidth, mHeight})
            if (!field->value())
                return field->problem();
    if (size().width() > mLargest.width() || size().height() > mLargest.height())
        return tr("%1 × %2 pixels are too many; this computer draws at most %3 × %4.")
            .arg(size().width())
            .arg(size().height())
            .arg(mLargest.width())
            .arg(mLargest.height());
    return {};
}

QSize PictureSizeFields::size() const
{
    const QVariant preset = mPreset->currentData();
    const QSize once =
        preset.isValid() ? preset.toSize() : QSize(int(mWidth->value().value_or(0)), int(mHeight->value().value_or(0)));
    return once * mScale->currentData().toInt();
}

void PictureSizeFields::showCustomRows()
{
    const bool isCustom = !mPreset->currentData().isValid();
    mForm.setRowVisible(mWidth, isCustom);
    mForm.setRowVisible(mHeight, isCustom);
}

} // namespace views
