// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QVBoxLayout;

namespace views {

/// Messages above the work instead of a box in its way: each stays until it is closed, notes go by themselves. Takes no
/// room while there are none.
class MessageBar final : public QWidget
{
    Q_OBJECT

public:
    enum class Kind { Note, Warning, Error };
    static constexpr int MaxMessages = 3; ///< the oldest goes

    explicit MessageBar(QWidget *parent = nullptr);

    void add(Kind kind, const QString &text);
    /// Of the messages now shown, oldest first.
    QStringList texts() const;
    void clear();

private:
    QVBoxLayout *mRows;
};

} // namespace views
