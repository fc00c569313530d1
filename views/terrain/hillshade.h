// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/terrain/terrain.h"
#include "views/terrain/terrainstyle.h"

#include <QImage>

namespace views {

/// A terrain from straight above, north up, shaded by its slope towards the sun; drawn by the processor, row by row.
class HillShade
{
public:
    explicit HillShade(const model::terrain::Terrain &terrain)
        : mTerrain(terrain)
    {}

    /// Of the terrain's proportions, within `size`; another size starts anew.
    void resize(QSize size);
    /// All rows are drawn anew, in time.
    void restart()
    {
        mNextRow = 0;
        mRowsLeft = mImage.height();
    }
    /// Only the rows that an edit changed.
    void note(const model::terrain::Edit &edit);
    /// Draws rows until that many milliseconds have passed. \returns whether some are left
    bool draw(double milliseconds);

    /// Voids are transparent.
    const QImage &image() const { return mImage; }

private:
    void drawRow(int row);

    const model::terrain::Terrain &mTerrain;
    QImage mImage;
    int mNextRow = 0;
    int mRowsLeft = 0; ///< from mNextRow on
};

/// The shade of a slope: 1 on level ground. \param gradient  metres up for a metre east and north
double shadeOf(model::terrain::Gradient gradient, const TerrainStyle &style);

} // namespace views
