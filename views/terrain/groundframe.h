// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/geometry/vec.h"
#include "model/terrain/tin/tin.h"

namespace views {

/// How a terrain (metres, x east, y north, z up) lies in the space that is drawn (x right, y up, z towards the south):
/// its middle is the origin, so that floats keep their precision wherever the terrain is.
class GroundFrame
{
public:
    /// \param tin  its domain and the height in its middle fix the frame
    explicit GroundFrame(const model::terrain::Tin &tin)
    {
        const model::terrain::Rectangle &domain = tin.domain();
        mMiddle.x = (domain.low.x + domain.high.x) / 2;
        mMiddle.y = (domain.low.y + domain.high.y) / 2;
        mMiddle.z = tin.heightAt({mMiddle.x, mMiddle.y});
        mHalfX = float((domain.high.x - domain.low.x) / 2);
        mHalfY = float((domain.high.y - domain.low.y) / 2);
    }

    const model::terrain::Point3 &middle() const { return mMiddle; }
    /// Half the sides of the domain, metres east and north.
    float halfX() const { return mHalfX; }
    float halfY() const { return mHalfY; }

    model::Vec3f toScene(double x, double y, double z) const
    {
        return {float(x - mMiddle.x), float(z - mMiddle.z), float(mMiddle.y - y)};
    }
    model::terrain::Point3 toGround(double x, double y, double z) const
    {
        return {x + mMiddle.x, mMiddle.y - z, y + mMiddle.z};
    }

private:
    model::terrain::Point3 mMiddle;
    float mHalfX, mHalfY;
};

} // namespace views
