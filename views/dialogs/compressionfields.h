// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/animation/compressionsettings.h"

#include <QObject>
#include <QString>

#include <vector>

class QComboBox;
class QFormLayout;

namespace views {

class NumberField;

/// The rows of a form that choose a codec and its settings; only those that the chosen codec has are seen. A new codec
/// is a row in codecs(), a new setting a call of addSetting().
class CompressionFields final : public QObject
{
    Q_OBJECT

public:
    /// Appends its rows to `form`, whose widget becomes the parent of the fields.
    CompressionFields(QFormLayout &form, QObject *parent);

    void setSettings(const model::CompressionSettings &settings);
    /// Precondition: problem() is empty.
    model::CompressionSettings settings() const;
    /// The first refused field of the chosen codec, as a sentence; empty if there is none.
    QString problem() const;

    NumberField &basisSize() { return *mBasisSize; }
    NumberField &resolution() { return *mResolution; }

    /// "PCA, basis 20, resolution 10,000"
    static QString summary(const model::CompressionSettings &settings);
    static QString codecName(model::CodecId codec);

signals:
    void changed();

private:
    struct Setting
    {
        NumberField *field;
        std::vector<model::CodecId> codecs; ///< that have it
    };

    NumberField *addSetting(const QString &label, NumberField *field, std::vector<model::CodecId> codecs);
    model::CodecId codec() const;
    void showSettingsOfCodec();

    QFormLayout &mForm;
    QComboBox *mCodec;
    std::vector<Setting> mSettings;
    NumberField *mBasisSize;
    NumberField *mResolution;
};

} // namespace views
