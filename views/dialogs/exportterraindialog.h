// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/io/terrain/terrainexport.h"
#include "views/dialogs/exportdialog.h"

#include <memory>

class QCheckBox;
class QComboBox;

namespace views {

class NumberField;
class PathField;

/// Export a terrain for other programs. Not modal: works on the terrain as it was when it opened.
class ExportTerrainDialog final : public ExportDialog
{
    Q_OBJECT

public:
    /// \param step  of the raster that the terrain came from, or 0
    /// \param path  proposed, without ending
    ExportTerrainDialog(std::shared_ptr<const model::terrain::Terrain> terrain, model::terrain::Point2 step,
                        const QString &path, QWidget *parent = nullptr);

protected:
    QString problem() const override;
    QString consequence() const override;
    QStringList filesToReplace() const override;
    QString outputPath() const override;
    Work work() override;

private:
    model::io::TerrainFormat format() const;
    void formatChanged();

    const std::shared_ptr<const model::terrain::Terrain> mTerrain;
    const model::terrain::Point2 mStep;
    QComboBox *mFormat;
    PathField *mOutput;
    QCheckBox *mIsWorld;
    NumberField *mCell;
    NumberField *mInterval;
};

} // namespace views
