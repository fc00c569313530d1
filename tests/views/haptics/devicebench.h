// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/commands/terrain/sandbox.h"
#include "tests/views/sculpt/planview.h"
#include "views/haptics/hapticssession.h"

#include <mutex>

namespace tests {

/// A system whose devices are plugged in and out by the test; they are listed, not opened. For any thread.
class PluggableHid final : public model::haptics::HidSystem
{
public:
    void setDevices(std::vector<model::haptics::HidDeviceInfo> devices)
    {
        const std::lock_guard lock(mMutex);
        mDevices = std::move(devices);
    }
    void forbid()
    {
        const std::lock_guard lock(mMutex);
        mIsAllowed = false;
    }

    model::Result<std::vector<model::haptics::HidDeviceInfo>> devices() override
    {
        const std::lock_guard lock(mMutex);
        return mDevices;
    }
    model::Result<std::unique_ptr<model::haptics::HidTransport>>
    open(const model::haptics::HidDeviceInfo &info) override
    {
        return model::fail(model::Error{
            model::ErrorCode::CannotOpen, {"Permission denied"}, info.path, model::Error::None, model::Error::None});
    }
    model::Result<model::Bytes> reportDescriptor(const model::haptics::HidDeviceInfo &) override
    {
        return model::fail(model::ErrorCode::CannotRead, "report descriptor");
    }
    bool hasPermission(const model::haptics::HidDeviceInfo &) override
    {
        const std::lock_guard lock(mMutex);
        return mIsAllowed;
    }

private:
    std::mutex mMutex;
    std::vector<model::haptics::HidDeviceInfo> mDevices;
    bool mIsAllowed = true;
};

inline model::haptics::HidDeviceInfo spaceNavigator()
{
    return {"/dev/hidraw9", 0x046d, 0xc626, 1, 8, "3Dconnexion", "SpaceNavigator", ""};
}

/// The simulated device over the unit square of sand, without a window.
struct DeviceBench
{
    model::TerrainDocument document{sandbox(1500)};
    commands::TerrainContext context{document};
    views::ToolSettings settings;
    PlanView view{document};
    views::StrokeController strokes{context, settings, &view};
    std::shared_ptr<PluggableHid> system = std::make_shared<PluggableHid>();
    views::HapticsSession session{system, settings};
    State start{document};

    DeviceBench()
    {
        settings.fitTo(document.tin().domain());
        views::FlowSettings flow;
        flow.isOn = false;
        settings.setFlow(flow);
        view.setInteraction(&strokes);
        session.setTerrain(&document, &strokes);
    }
    ~DeviceBench()
    {
        session.setTerrain(nullptr, nullptr);
        view.setInteraction(nullptr);
    }

    void chooseSimulated()
    {
        session.choose(QStringLiteral("simulated"));
        moveTo({0.5, 0.5}, 0.1, false);
    }
    /// So many metres above the ground as it is there now; returns when the session has seen it.
    void moveTo(Point2 p, double above, bool isPressed)
    {
        const Point3 place{p.x, p.y, document.tin().heightAt(p) + above};
        session.moveHand(place, isPressed);
        const auto isThere = [&] {
            const Point3 tool = session.toolPlace();
            return std::abs(tool.x - place.x) + std::abs(tool.y - place.y) + std::abs(tool.z - place.z) < 1e-9 &&
                   (session.now().reading.buttons != 0) == isPressed;
        };
        QTRY_VERIFY_WITH_TIMEOUT(isThere(), 20'000);
    }
    /// A trace in the sand from left to right.
    void stroke(double y)
    {
        moveTo({0.3, y}, 0.05, false);
        moveTo({0.3, y}, -0.03, true);
        for (double x = 0.35; x < 0.72; x += 0.05)
            moveTo({x, y}, -0.03, true);
        moveTo({0.7, y}, 0.05, false);
        QTRY_VERIFY(!strokes.isDrawing());
    }
};

} // namespace tests
