// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/haptics/hid/catalog.h"

#include <QObject>
#include <QTimer>

#include <memory>
#include <vector>

namespace views {

/// Notices what is plugged in and out, once a second while it is watching. The system is asked in a worker: that may
/// take it longer than a frame.
class DeviceFinder final : public QObject
{
    Q_OBJECT

public:
    explicit DeviceFinder(std::shared_ptr<model::haptics::HidSystem> system, QObject *parent = nullptr);

    /// Looks at once, and then again and again, until it is told not to.
    void setWatching(bool isWatching);
    /// The simulated device alone until the system was asked.
    const std::vector<model::haptics::FoundDevice> &devices() const { return mDevices; }

signals:
    void changed();

private:
    void look();
    void take(std::vector<model::haptics::FoundDevice> devices);

    std::shared_ptr<model::haptics::HidSystem> mSystem;
    std::vector<model::haptics::FoundDevice> mDevices;
    QTimer mTimer;
    bool mIsLooking = false;
};

} // namespace views
