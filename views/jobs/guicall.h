// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/progress.h"

#include <QCoreApplication>

#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <type_traits>
#include <utility>

namespace views {

/// From the work of a Job: runs `call` in the GUI thread and waits for what it returns; nothing if the work is
/// cancelled before. Never waits for a GUI thread that waits itself: a cancel ends it. `call` owns what it uses, since
/// it may run after the work has given up.
template <class Call>
auto callInGui(const model::Progress &progress, Call call) -> std::optional<std::invoke_result_t<Call &>>
{
    struct Desk
    {
        std::mutex mutex;
        std::condition_variable ready;
        std::optional<std::invoke_result_t<Call &>> value;
    };
    constexpr std::chrono::milliseconds CancelInterval(20);

    const auto desk = std::make_shared<Desk>();
    QMetaObject::invokeMethod(
        QCoreApplication::instance(),
        [desk, call = std::move(call), progress]() mutable {
            if (progress.isCancelled())
                return;
            auto value = call();
            const std::lock_guard lock(desk->mutex);
            desk->value = std::move(value);
            desk->ready.notify_one();
        },
        Qt::QueuedConnection);
    std::unique_lock lock(desk->mutex);
    while (!desk->value && !progress.isCancelled())
        desk->ready.wait_for(lock, CancelInterval);
    return std::move(desk->value);
}

} // namespace views
