// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/scene/comparison.h"

#include <QPointer>

class QPainter;
class QRect;

namespace views {

/// What every picture of an animation needs to colour it by the error of each vertex, as long as there is a comparison.
class ErrorColoring
{
public:
    virtual ~ErrorColoring();

    /// Where the errors come from; null: nothing to colour by.
    void setComparison(const Comparison *comparison);
    void setErrorColored(bool colored);
    bool isErrorColored() const { return mErrorColored; }
    /// The colours reach to the largest error of the frame instead of that of all frames.
    void setErrorRangeOfFrame(bool ofFrame);
    bool isErrorRangeOfFrame() const { return mErrorRangeOfFrame; }
    /// The error that has the last colour; 0 while the picture is not coloured by errors.
    float errorRange() const { return errorRangeOf(coloredFrame()); }

protected:
    /// The frame in the picture; null: none.
    virtual const FrameData *coloredFrame() const = 0;
    /// Something above is different now, or what was measured.
    virtual void errorColoringChanged() = 0;

    float errorRangeOf(const FrameData *frame) const;
    /// The scale; nothing while the picture is not coloured by errors.
    void drawErrorScale(QPainter &painter, const QRect &area, bool isDark) const;

private:
    QPointer<const Comparison> mComparison;
    QMetaObject::Connection mFollowing;
    bool mErrorColored = false;
    bool mErrorRangeOfFrame = false;
};

} // namespace views
