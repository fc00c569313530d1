// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/start/language.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>

#include <algorithm>

namespace editor {

std::vector<Language::Choice> Language::choices()
{
    return {{QStringLiteral("en"), QStringLiteral("English")}, {QStringLiteral("cs"), QStringLiteral("Čeština")}};
}

QString Language::resolved(const QString &code)
{
    const auto known = choices();
    const auto isKnown = [&](const QString &candidate) {
        return std::any_of(known.begin(), known.end(), [&](const Choice &c) { return c.code == candidate; });
    };
    if (isKnown(code))
        return code;
    const QStringList wanted = QLocale::system().uiLanguages();
    for (const QString &tag : wanted)
        if (const QString language = tag.section(QLatin1Char('-'), 0, 0); isKnown(language))
            return language;
    return QStringLiteral("en");
}

Language::~Language()
{
    QCoreApplication::removeTranslator(&mOurs);
    QCoreApplication::removeTranslator(&mQts);
}

void Language::apply(const QString &code)
{
    mCurrent = resolved(code);
    QCoreApplication::removeTranslator(&mOurs);
    QCoreApplication::removeTranslator(&mQts);
    // Numbers of the interface; files never use the locale.
    QLocale::setDefault(mCurrent == QLatin1String("en") ? QLocale(QLocale::English, QLocale::UnitedKingdom)
                                                        : QLocale(mCurrent));
    if (mQts.load(QStringLiteral("qtbase_") + mCurrent, QLibraryInfo::path(QLibraryInfo::TranslationsPath)))
        QCoreApplication::installTranslator(&mQts);
    // English too: its file holds the plural forms.
    if (mOurs.load(QStringLiteral(":/i18n/sandreel_%1.qm").arg(mCurrent)))
        QCoreApplication::installTranslator(&mOurs);
}

} // namespace editor
