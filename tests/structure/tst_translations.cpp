// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/testmain.h"

#include <QDirIterator>
#include <QFile>
#include <QRegularExpression>
#include <QSet>
#include <QXmlStreamReader>

namespace {

struct Message
{
    QString context;
    QString source;
    QStringList translations; ///< one, or the plural forms
    bool numerus = false;
    QString type; ///< "unfinished", "vanished" or empty
};

QList<Message> messagesOf(const QString &language)
{
    QFile file(QStringLiteral(SANDREEL_SOURCE_DIR "/translations/sandreel_%1.ts").arg(language));
    QList<Message> messages;
    if (!file.open(QIODevice::ReadOnly))
        return messages;
    QXmlStreamReader xml(&file);
    QString context;
    Message message;
    while (!xml.atEnd()) {
        xml.readNext();
        if (xml.isStartElement()) {
            if (xml.name() == QLatin1String("name"))
                context = xml.readElementText();
            else if (xml.name() == QLatin1String("message"))
                message = {
                    context, {}, {}, xml.attributes().value(QLatin1String("numerus")) == QLatin1String("yes"), {}};
            else if (xml.name() == QLatin1String("source"))
                message.source = xml.readElementText();
            else if (xml.name() == QLatin1String("numerusform"))
                message.translations << xml.readElementText();
            else if (xml.name() == QLatin1String("translation")) {
                message.type = xml.attributes().value(QLatin1String("type")).toString();
                if (!message.numerus)
                    message.translations << xml.readElementText();
            }
        } else if (xml.isEndElement() && xml.name() == QLatin1String("message")) {
            messages << message;
        }
    }
    return xml.hasError() ? QList<Message>() : messages;
}

QStringList placeholdersOf(const QString &text)
{
    static const QRegularExpression placeholder(QStringLiteral("%L?\\d+|%n"));
    QStringList result;
    auto matches = placeholder.globalMatch(text);
    while (matches.hasNext())
        result << matches.next().captured();
    result.sort();
    result.removeDuplicates();
    return result;
}

/// "&" before a letter, "&&" being a sign of its own.
int mnemonicsIn(QString text)
{
    text.remove(QLatin1String("&&"));
    return int(text.count(QLatin1Char('&')));
}

} // namespace

class TestTranslations final : public QObject
{
    Q_OBJECT

private slots:
    void everyTextIsTranslated_data()
    {
        QTest::addColumn<QString>("language");
        QTest::addColumn<int>("pluralForms");
        QTest::newRow("Czech") << "cs" << 3;
        QTest::newRow("English plurals") << "en" << 2;
    }
    void everyTextIsTranslated()
    {
        QFETCH(QString, language);
        QFETCH(int, pluralForms);
        const QList<Message> messages = messagesOf(language);
        QVERIFY(!messages.isEmpty());
        QStringList broken;
        for (const Message &message : messages) {
            const qsizetype wanted = message.numerus ? pluralForms : 1;
            if (!message.type.isEmpty() || message.translations.size() != wanted ||
                message.translations.contains(QString()))
                broken << message.context + ": " + message.source;
        }
        QVERIFY2(broken.isEmpty(), qPrintable(broken.join('\n')));
    }

    void placeholdersAgree()
    {
        QStringList broken;
        for (const Message &message : messagesOf(QStringLiteral("cs")) + messagesOf(QStringLiteral("en")))
            for (const QString &translation : message.translations)
                if (placeholdersOf(translation) != placeholdersOf(message.source))
                    broken << message.source + " -> " + translation;
        QVERIFY2(broken.isEmpty(), qPrintable(broken.join('\n')));
    }

    void whatHasAMnemonicKeepsOne()
    {
        QStringList broken;
        for (const Message &message : messagesOf(QStringLiteral("cs")))
            for (const QString &translation : message.translations)
                if (mnemonicsIn(translation) != mnemonicsIn(message.source))
                    broken << message.source + " -> " + translation;
        QVERIFY2(broken.isEmpty(), qPrintable(broken.join('\n')));
    }

    void everyTextOfTheSourcesIsListed()
    {
        // What lupdate has not seen since it was written; checked on the texts that are easy to find by eye.
        QSet<QString> known;
        for (const Message &message : messagesOf(QStringLiteral("cs")))
            known << message.source;
        for (const char *text : {"&File", "Trim to %n Frame(s)", "The mesh has no vertices.", "Save"})
            QVERIFY2(known.contains(QLatin1String(text)), text);
    }

    /// tr() asks in the class with its namespace. Where lupdate lost the namespace, nothing would be found.
    void contextsWithoutNamespaceAreNamedInTheSources()
    {
        QByteArray sources;
        for (const char *folder : {"model", "commands", "views", "app/cli", "app/editor"}) {
            QDirIterator it(QStringLiteral(SANDREEL_SOURCE_DIR "/") + QLatin1String(folder), {"*.h", "*.cpp"},
                            QDir::Files, QDirIterator::Subdirectories);
            while (it.hasNext()) {
                QFile file(it.next());
                QVERIFY(file.open(QIODevice::ReadOnly));
                sources += file.readAll();
            }
        }
        for (const Message &message : messagesOf(QStringLiteral("cs")))
            if (!message.context.contains(QStringLiteral("::")))
                QVERIFY2(sources.contains('"' + message.context.toUtf8() + '"') ||
                             sources.contains("Q_DECLARE_TR_FUNCTIONS(" + message.context.toUtf8() + ')'),
                         qPrintable(message.context));
    }
};

SANDREEL_TEST(TestTranslations)
#include "tst_translations.moc"
