// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/io/terrain/newterrain.h"
#include "model/io/terrain/terrainimport.h"

#include <QDialog>

class QComboBox;
class QFormLayout;
class QLineEdit;
class QPushButton;

namespace views {

class HintLabel;
class LayersField;
class NumberField;
class PathField;

/// Import Terrain: which file, how exactly its heights are kept, what lies on them, and what the file does not say of
/// itself. Only what matters for the kind of file is shown.
class ImportTerrainDialog final : public QDialog
{
    Q_OBJECT

public:
    explicit ImportTerrainDialog(QWidget *parent = nullptr);

    void setSource(const QString &path);

    // What to do. Precondition: it was accepted.
    QString source() const;
    model::io::TerrainImportOptions options() const;
    std::vector<model::io::NewLayer> layers() const;

private:
    enum class FileKind { Raster, Raw, Points, Mesh };

    NumberField *addNumber(const char *objectName, const QString &label, const QString &what, double min, double max,
                           int decimals, double value, const QString &unit);
    FileKind fileKind() const;
    QString problem() const;
    void sourceChanged();
    void guessRawSize();
    void refresh();

    QFormLayout *mForm;
    PathField *mSource;
    NumberField *mMaxError;
    NumberField *mCellSize;
    NumberField *mHeightScale;
    NumberField *mColumns;
    NumberField *mRows;
    QComboBox *mType;
    QComboBox *mByteOrder;
    QComboBox *mUp;
    QLineEdit *mCrs;
    LayersField *mLayers;
    HintLabel *mMessage;
    QPushButton *mImport;
};

} // namespace views
