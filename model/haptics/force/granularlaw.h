// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/haptics/force/forcelaw.h"

namespace model::haptics {

/// Sand: an elastic grip that yields.
///
/// The material holds the tool at a rest point, like a spring; above a yield force it gives way and the rest point
/// follows the tool through the sand. The yield force grows with the depth below the ground around the tool, sideways
/// with the material that lies ahead; pulling out meets only what cohesion holds. Damping acts in contact, grains
/// roughen the force as a function of the way gone, so that nothing trembles at rest.
///
/// Depth is that below the ring around the tool, not below its centre: a tool that stamps is always level with the
/// ground under it. The ground under the centre decides whether there is contact at all.
class GranularLaw final : public ForceLaw
{
public:
    /// Metres of the hand over which contact fades in below, and out above, the ground: the newest snapshot may have
    /// been stamped down to the tool's own depth, and rounding must not make the sand come and go.
    static constexpr double Skin = 0.002;

    Vec3d force(const Contact &contact, const Feel &feel, LawMemory &memory) const override;
};

} // namespace model::haptics
