// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/io/terrain/newterrain.h"

#include <QWidget>

#include <memory>

class QComboBox;
class QPushButton;
class QToolButton;
class QVBoxLayout;

namespace views {

class NumberField;

/// "Dry Sand", in the interface's language.
QString materialTitle(model::terrain::MaterialPreset preset);

/// What lies on the ground: a row for each layer, its material and how thick it is; the upmost first, as it is seen
/// from the side.
class LayersField final : public QWidget
{
    Q_OBJECT

public:
    explicit LayersField(QWidget *parent = nullptr);

    void add(model::terrain::MaterialPreset preset, double thickness);
    /// The upmost last. Precondition: problem() is empty.
    std::vector<model::io::NewLayer> layers() const;
    QString problem() const;

signals:
    void changed();

private:
    struct Row
    {
        QWidget *widget;
        QComboBox *material;
        NumberField *thickness;
        QToolButton *remove;
    };

    void remove(const QWidget *widget);
    void numberRows();

    std::vector<Row> mRows; ///< the upmost first
    QVBoxLayout *mColumn;
    QPushButton *mAdd;
};

} // namespace views
