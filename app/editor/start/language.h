// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QTranslator>

#include <vector>

namespace editor {

/// The interface's language: texts, and how numbers are written. May change while windows are open; they get a
/// QEvent::LanguageChange.
class Language
{
public:
    struct Choice
    {
        QString code;
        QString name; ///< in the language itself
    };

    static std::vector<Choice> choices();
    /// "en" or "cs" for any code that a settings file or command line may hold; the system's for an empty or unknown
    /// one.
    static QString resolved(const QString &code);

    Language() = default;
    ~Language();
    Language(const Language &) = delete;
    Language &operator=(const Language &) = delete;

    /// \param code  as resolved() takes it
    void apply(const QString &code);
    const QString &current() const { return mCurrent; }

private:
    QString mCurrent = QStringLiteral("en");
    QTranslator mOurs;
    QTranslator mQts;
};

} // namespace editor
