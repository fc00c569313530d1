// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/animation/compressionsettings.h"

#include <QObject>
#include <QString>

#include <functional>
#include <string_view>
#include <vector>

class QCheckBox;
class QComboBox;
class QFormLayout;

namespace views {

class NumberField;

/// The rows of a form that choose a codec and its settings; only those of the chosen codec are seen, and each codec
/// keeps what was entered for it. Which codecs there are is said by codec::availableCodecs(), which fields they have by
/// model::visitFields(): a new field only needs its texts here.
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

    /// All fields for numbers, of all codecs.
    std::vector<NumberField *> numberFields() const;
    /// The field of the chosen codec with this key (model::SettingField); null if it has none or it is no number.
    NumberField *numberField(std::string_view key) const;
    /// The first field of the chosen codec.
    QWidget *firstField() const;

    /// "PCA, basis 20, resolution 10,000"
    static QString summary(const model::CompressionSettings &settings);
    static QString codecName(model::CodecId codec);

signals:
    void changed();

private:
    /// A field on the screen. Exactly one of `number` and `choice` is set.
    struct Row
    {
        model::CodecId codec;
        std::string_view key;
        NumberField *number = nullptr;
        QComboBox *choice = nullptr;

        QWidget *widget() const;
    };

    void addRows(model::CodecId codec);
    const Row *rowOf(model::CodecId codec, std::string_view key) const;
    model::CodecId codec() const;
    void showFieldsOfCodec();

    QFormLayout &mForm;
    QComboBox *mCodec;
    QCheckBox *mKeepOrder;
    std::vector<Row> mRows;
};

} // namespace views
