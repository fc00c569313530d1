// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRect>
#include <QSize>

#include <vector>

namespace views {

/// The parts of a picture that have to be drawn anew, cut along a grid: each is a bounded piece of work.
class StaleTiles
{
public:
    /// Starts with nothing stale. \param tile  the largest part, pixels; at least 1 x 1
    void reset(QSize size, QSize tile);
    QSize size() const { return mSize; }
    QSize tile() const { return mTile; }

    /// Parts outside the picture are left out.
    void add(const QRect &part);
    void addAll() { add(QRect(QPoint(0, 0), mSize)); }
    void clear();
    bool isEmpty() const { return mCount == 0; }
    /// A part that is stale, which it then is no more. Precondition: !isEmpty().
    QRect take();

private:
    QSize mSize{0, 0}, mTile{1, 1};
    int mColumns = 0;
    std::vector<QRect> mParts; ///< of each tile; empty: up to date
    int mCount = 0;            ///< tiles with a part
};

} // namespace views
