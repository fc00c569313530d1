// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/errortext.h"
#include "tests/support/testmain.h"

#include <QCoreApplication>
#include <QTranslator>

using namespace model;
using namespace model::io;

namespace {

/// How many arguments each code has, as model/base/error.h says. The compiler reports a code that is missing here.
int argumentCount(ErrorCode code)
{
    switch (code) {
    case ErrorCode::NoVertices:
    case ErrorCode::MissingBaseMesh:
    case ErrorCode::NotFound:
    case ErrorCode::Cancelled:
    case ErrorCode::NoSurface:
        return 0;
    case ErrorCode::NoFrames:
    case ErrorCode::UnknownFormat:
    case ErrorCode::NonFinite:
    case ErrorCode::TrailingBytes:
    case ErrorCode::BadMagic:
    case ErrorCode::UnsupportedFeature:
    case ErrorCode::ChecksumMismatch:
    case ErrorCode::MissingChunk:
    case ErrorCode::DuplicateChunk:
    case ErrorCode::UnknownCodec:
    case ErrorCode::CorruptStream:
    case ErrorCode::NoAnimation:
    case ErrorCode::ImporterFailed:
    case ErrorCode::BadPermutation:
    case ErrorCode::CannotOpen:
    case ErrorCode::CannotRead:
    case ErrorCode::CannotWrite:
    case ErrorCode::OutOfMemory:
        return 1;
    case ErrorCode::NotASurface:
    case ErrorCode::BrokenTerrain:
    case ErrorCode::SyntaxError:
    case ErrorCode::IndexOutOfRange:
    case ErrorCode::FacesDiffer:
    case ErrorCode::Truncated:
    case ErrorCode::UnsupportedVersion:
        return 2;
    case ErrorCode::VertexCountDiffers:
    case ErrorCode::FaceCountDiffers:
    case ErrorCode::BadValue:
    case ErrorCode::MeshesDiffer:
    case ErrorCode::BadSetting:
    case ErrorCode::LimitExceeded:
        return 3;
    case ErrorCode::CrossingConstraints:
        return 4;
    }
    return -1;
}

/// Puts everything it is asked for in brackets.
class Brackets final : public QTranslator
{
public:
    QString translate(const char *context, const char *text, const char *, int) const override
    {
        if (qstrcmp(context, "ErrorText") != 0 || qstrcmp(text, "/data/a") == 0)
            return {};
        return QLatin1Char('[') + QString::fromUtf8(text) + QLatin1Char(']');
    }
    bool isEmpty() const override { return false; }
};

} // namespace

class TestErrorText final : public QObject
{
    Q_OBJECT

private slots:
    void everyCodeHasATextThatUsesItsArguments()
    {
        for (int code = 0; code <= int(ErrorCode::Cancelled); ++code) {
            Error error;
            error.code = ErrorCode(code);
            const int count = argumentCount(error.code);
            QVERIFY2(count >= 0, qPrintable(QString::number(code)));
            for (int i = 0; i < count; ++i)
                error.args.push_back("argument" + std::to_string(i));
            const QString text = errorText(error);
            QVERIFY2(text.size() > 5, qPrintable(QString::number(code)));
            for (const std::string &arg : error.args)
                QVERIFY2(text.contains(QString::fromStdString(arg)), qPrintable(text));
            QVERIFY2(!text.contains('%') && !text.contains('?'), qPrintable(text)); // a place without an argument
            QVERIFY2(text.endsWith('.') || error.code == ErrorCode::ImporterFailed, qPrintable(text));
        }
    }

    void placeComesFirst()
    {
        Error error = fail(ErrorCode::NoVertices).value();
        QCOMPARE(errorText(error), "The mesh has no vertices.");
        error.line = 7;
        QCOMPARE(errorText(error), "Line 7: The mesh has no vertices.");
        error.file = "/data/a %2 %1";
        QCOMPARE(errorText(error), "/data/a %2 %1, line 7: The mesh has no vertices.");
        error.line = Error::None;
        error.offset = 12;
        QCOMPARE(errorText(error), "/data/a %2 %1, byte 12: The mesh has no vertices.");
        error.offset = Error::None;
        QCOMPARE(errorText(error), "/data/a %2 %1: The mesh has no vertices.");
    }

    void argumentsAreTakenAsTheyAre()
    {
        QCOMPARE(errorText(fail(ErrorCode::SyntaxError, "%2", "\"%1\"").value()), "Expected %2, but found \"%1\".");
        const std::string numbers = "1/2/3/4/5/6/7/8/9/10/11/12 a13.obj";
        QCOMPARE(errorText(fail(ErrorCode::BadMagic, numbers).value()),
                 "The file is not a " + QString::fromStdString(numbers) + " file: it does not start as one.");
        QCOMPARE(errorText(fail(ErrorCode::VertexCountDiffers, "1").value()).count('?'), 2);
    }

    void memoryOfUnknownSizeHasATextToo()
    {
        QCOMPARE(errorText(fail(ErrorCode::OutOfMemory).value()),
                 "There is not enough memory. Close other programs or use a smaller animation.");
    }

    void phrasesAreTranslated()
    {
        Brackets translator;
        QVERIFY(QCoreApplication::installTranslator(&translator));
        const QString text = errorText(fail(ErrorCode::NonFinite, "vertex 12").value());
        const QString two = errorText(fail(ErrorCode::NonFinite, "vertex 12 of frame 3").value());
        const QString place = errorText(fail(ErrorCode::NotFound).value().in("/data/a"));
        QCoreApplication::removeTranslator(&translator);
        QCOMPARE(text, "[A number is infinite or not a number: [vertex 12].]");
        QCOMPARE(two, "[A number is infinite or not a number: [vertex 12 of frame 3].]");
        QCOMPARE(place, "[/data/a: [There is no such file or folder.]]");
    }
};

SANDREEL_TEST(TestErrorText)
#include "tst_errortext.moc"
