// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/viewport/errorcoloring.h"

#include "views/viewport/overlay.h"

#include <algorithm>
#include <limits>

namespace views {

ErrorColoring::~ErrorColoring()
{
    QObject::disconnect(mFollowing);
}

void ErrorColoring::setComparison(const Comparison *comparison)
{
    QObject::disconnect(mFollowing);
    mComparison = comparison;
    if (mComparison)
        mFollowing = QObject::connect(mComparison, &Comparison::changed, [this] { errorColoringChanged(); });
    errorColoringChanged();
}

void ErrorColoring::setErrorColored(bool colored)
{
    mErrorColored = colored;
    errorColoringChanged();
}

void ErrorColoring::setErrorRangeOfFrame(bool ofFrame)
{
    mErrorRangeOfFrame = ofFrame;
    errorColoringChanged();
}

float ErrorColoring::errorRangeOf(const FrameData *frame) const
{
    if (!mErrorColored || !mComparison || !mComparison->result() || !frame || frame->errors.empty())
        return 0;
    const float range = mErrorRangeOfFrame ? frame->largestError : float(mComparison->result()->maxVertexError);
    return std::max(range, std::numeric_limits<float>::min()); // without errors everything has the first colour
}

void ErrorColoring::drawErrorScale(QPainter &painter, const QRect &area, bool isDark) const
{
    if (const float range = errorRange(); range > 0)
        drawErrorLegend(painter, area, {range, mComparison->result()->diagonal, mErrorRangeOfFrame}, isDark);
}

} // namespace views
