// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/terrain/picture/staletiles.h"

#include <algorithm>
#include <utility>

namespace views {

void StaleTiles::reset(QSize size, QSize tile)
{
    mSize = size;
    mTile = tile;
    mColumns = (size.width() + tile.width() - 1) / tile.width();
    const int rows = (size.height() + tile.height() - 1) / tile.height();
    mParts.assign(std::size_t(mColumns) * std::size_t(rows), QRect());
    mCount = 0;
}

void StaleTiles::add(const QRect &part)
{
    if (mParts.empty())
        return;
    const QRect inside = part.intersected(QRect(QPoint(0, 0), mSize));
    if (inside.isEmpty())
        return;
    for (int row = inside.top() / mTile.height(); row <= inside.bottom() / mTile.height(); ++row)
        for (int column = inside.left() / mTile.width(); column <= inside.right() / mTile.width(); ++column) {
            QRect &stale = mParts[std::size_t(row) * std::size_t(mColumns) + std::size_t(column)];
            mCount += stale.isEmpty();
            stale |= inside & QRect(QPoint(column * mTile.width(), row * mTile.height()), mTile);
        }
}

void StaleTiles::clear()
{
    std::fill(mParts.begin(), mParts.end(), QRect());
    mCount = 0;
}

QRect StaleTiles::take()
{
    const auto found = std::find_if(mParts.begin(), mParts.end(), [](const QRect &part) { return !part.isEmpty(); });
    --mCount;
    return std::exchange(*found, QRect());
}

} // namespace views
