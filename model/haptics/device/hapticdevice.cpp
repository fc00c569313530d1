// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/haptics/device/hapticdevice.h"

namespace model::haptics {

Vec3d fromDevice2009(Vec3d device)
{
    return {device.x / 200 + 0.5, -device.z / 200 + 0.5, device.y / 200};
}

Vec3d toDevice2009(Vec3d application)
{
    return {(application.x - 0.5) * 200, application.z * 200, -(application.y - 0.5) * 200};
}

Vec3d forceToDevice2009(Vec3d application)
{
    return {application.x, application.z, -application.y};
}

} // namespace model::haptics
