// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/haptics/devicefinder.h"

#include <QCoreApplication>
#include <QPointer>
#include <QThreadPool>

namespace views {

using namespace model::haptics;

namespace {

constexpr int LookMilliseconds = 1000;

} // namespace

DeviceFinder::DeviceFinder(std::shared_ptr<HidSystem> system, QObject *parent)
    : QObject(parent)
    , mSystem(std::move(system))
    , mDevices{simulatedDevice()}
{
    mTimer.setInterval(LookMilliseconds);
    connect(&mTimer, &QTimer::timeout, this, &DeviceFinder::look);
}

void DeviceFinder::setWatching(bool isWatching)
{
    if (isWatching == mTimer.isActive())
        return;
    if (!isWatching)
        return mTimer.stop();
    mTimer.start();
    look();
}

void DeviceFinder::look()
{
    if (mIsLooking)
        return;
    mIsLooking = true;
    QThreadPool::globalInstance()->start([system = mSystem, self = QPointer(this)] {
        // The application outlives the worker's news; this object may not.
        QMetaObject::invokeMethod(
            QCoreApplication::instance(),
            [self, devices = findDevices(*system)]() mutable {
                if (self)
                    self->take(std::move(devices));
            },
            Qt::QueuedConnection);
    });
}

void DeviceFinder::take(std::vector<FoundDevice> devices)
{
    mIsLooking = false;
    if (devices == mDevices)
        return;
    mDevices = std::move(devices);
    emit changed();
}

} // namespace views
