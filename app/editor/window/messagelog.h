// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace views {
class LogModel;
}

namespace editor {

/// While it lives, what Qt and its plugins say (qWarning and the like, from any thread) comes into the log too, besides
/// going where it went before. One at a time.
class MessageLog final
{
public:
    explicit MessageLog(views::LogModel &log);
    ~MessageLog();
    MessageLog(const MessageLog &) = delete;
    MessageLog &operator=(const MessageLog &) = delete;
};

} // namespace editor
