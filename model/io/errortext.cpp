// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/errortext.h"

#include <QCoreApplication>
#include <QDir>
#include <QRegularExpression>

namespace model::io {

namespace {

QString translate(const char *text)
{
    return QCoreApplication::translate("ErrorText", text);
}

/// Phrases that other folders put into errors: those of model/codec and model/terrain, which know no Qt.
[[maybe_unused]] constexpr const char *PhrasesOfOthers[] = {
    QT_TRANSLATE_NOOP("ErrorText", "vertex %1"),
    QT_TRANSLATE_NOOP("ErrorText", "vertex %1 of frame %2"),
    QT_TRANSLATE_NOOP("ErrorText", "triangle %1"),
    QT_TRANSLATE_NOOP("ErrorText", "memory"),
    QT_TRANSLATE_NOOP("ErrorText", "format version"),
    QT_TRANSLATE_NOOP("ErrorText", "vertex count"),
    QT_TRANSLATE_NOOP("ErrorText", "triangle count"),
    QT_TRANSLATE_NOOP("ErrorText", "frame count"),
    QT_TRANSLATE_NOOP("ErrorText", "rows per stream"),
    QT_TRANSLATE_NOOP("ErrorText", "stream count"),
    QT_TRANSLATE_NOOP("ErrorText", "chunk tag"),
    QT_TRANSLATE_NOOP("ErrorText", "letters and digits"),
    QT_TRANSLATE_NOOP("ErrorText", "at most the bytes left"),
    QT_TRANSLATE_NOOP("ErrorText", "point %1"),
    QT_TRANSLATE_NOOP("ErrorText", "number of points"),
    QT_TRANSLATE_NOOP("ErrorText", "extent of the terrain"),
    QT_TRANSLATE_NOOP("ErrorText", "more than nothing in both directions"),
    QT_TRANSLATE_NOOP("ErrorText", "size of the grid"),
    QT_TRANSLATE_NOOP("ErrorText", "at least %1 x %2"),
    QT_TRANSLATE_NOOP("ErrorText", "column %1 of row %2"),
    QT_TRANSLATE_NOOP("ErrorText", "constraint"),
    QT_TRANSLATE_NOOP("ErrorText", "exception count"),
    QT_TRANSLATE_NOOP("ErrorText", "layer count"),
    QT_TRANSLATE_NOOP("ErrorText", "unit"),
    QT_TRANSLATE_NOOP("ErrorText", "packed size"),
    QT_TRANSLATE_NOOP("ErrorText", "unpacked size"),
    QT_TRANSLATE_NOOP("ErrorText", "step count"),
    QT_TRANSLATE_NOOP("ErrorText", "reference size"),
    QT_TRANSLATE_NOOP("ErrorText", "outer vertex count"),
    QT_TRANSLATE_NOOP("ErrorText", "outer vertex size"),
    QT_TRANSLATE_NOOP("ErrorText", "tile size"),
    QT_TRANSLATE_NOOP("ErrorText", "tile count"),
    QT_TRANSLATE_NOOP("ErrorText", "number of materials"),
    QT_TRANSLATE_NOOP("ErrorText", "number of layers"),
    QT_TRANSLATE_NOOP("ErrorText", "number of levels"),
    QT_TRANSLATE_NOOP("ErrorText", "material of layer %1"),
    QT_TRANSLATE_NOOP("ErrorText", "origin"),
    QT_TRANSLATE_NOOP("ErrorText", "volume"),
    QT_TRANSLATE_NOOP("ErrorText", "height prediction"),
    QT_TRANSLATE_NOOP("ErrorText", "void mark"),
};

/// What happened, with places for the arguments of the code.
const char *rowOf(ErrorCode code, bool hasArguments)
{
    switch (code) {
    case ErrorCode::NoFrames:
        return QT_TRANSLATE_NOOP("ErrorText", "The folder holds no frames. Files ending in %1 are taken as frames.");
    case ErrorCode::UnknownFormat:
        return QT_TRANSLATE_NOOP("ErrorText", "Files ending in \"%1\" cannot be read.");
    case ErrorCode::SyntaxError:
        return QT_TRANSLATE_NOOP("ErrorText", "Expected %1, but found %2.");
    case ErrorCode::NonFinite:
        return QT_TRANSLATE_NOOP("ErrorText", "A number is infinite or not a number: %1.");
    case ErrorCode::IndexOutOfRange:
        return QT_TRANSLATE_NOOP("ErrorText", "A face uses vertex %1, but there are %2 vertices.");
    case ErrorCode::NoVertices:
        return QT_TRANSLATE_NOOP("ErrorText", "The mesh has no vertices.");
    case ErrorCode::VertexCountDiffers:
        return QT_TRANSLATE_NOOP("ErrorText",
                                 "There are %1 vertices here, but %2 in %3. All frames of an animation and its "
                                 "base mesh need the same vertices.");
    case ErrorCode::FacesDiffer:
        return QT_TRANSLATE_NOOP("ErrorText",
                                 "Triangle %1 differs from that in %2. All frames of an animation need the "
                                 "same faces in the same order.");
    case ErrorCode::FaceCountDiffers:
        return QT_TRANSLATE_NOOP("ErrorText", "This mesh has %1 triangles, but %3 has %2. All frames of an animation "
                                              "need the same faces.");
    case ErrorCode::Truncated:
        return QT_TRANSLATE_NOOP("ErrorText", "The file ends too early: %1 bytes are needed, %2 are there. It may have "
                                              "been copied incompletely.");
    case ErrorCode::TrailingBytes:
        return QT_TRANSLATE_NOOP("ErrorText", "There are %1 bytes too many at the end. The file may be damaged.");
    case ErrorCode::BadMagic:
        return QT_TRANSLATE_NOOP("ErrorText", "The file is not a %1 file: it does not start as one.");
    case ErrorCode::UnsupportedVersion:
        return QT_TRANSLATE_NOOP("ErrorText",
                                 "The file has format version %1, but this program reads versions up to %2. "
                                 "A newer program may open it.");
    case ErrorCode::UnsupportedFeature:
        return QT_TRANSLATE_NOOP("ErrorText", "The file uses something that cannot be read: %1.");
    case ErrorCode::ChecksumMismatch:
        return QT_TRANSLATE_NOOP("ErrorText", "The file is damaged: the checksum of its part \"%1\" is wrong.");
    case ErrorCode::MissingChunk:
        return QT_TRANSLATE_NOOP("ErrorText", "The file is damaged: its part \"%1\" is missing.");
    case ErrorCode::DuplicateChunk:
        return QT_TRANSLATE_NOOP("ErrorText", "The file is damaged: it has its part \"%1\" twice.");
    case ErrorCode::BadValue:
        return QT_TRANSLATE_NOOP("ErrorText", "The file is damaged: %1 is %2, but must be %3.");
    case ErrorCode::UnknownCodec:
        return QT_TRANSLATE_NOOP("ErrorText", "The file was compressed with method %1, which this program does not "
                                              "know. A newer program may open it.");
    case ErrorCode::CorruptStream:
        return QT_TRANSLATE_NOOP("ErrorText", "The compressed data are damaged (%1).");
    case ErrorCode::MissingBaseMesh:
        return QT_TRANSLATE_NOOP("ErrorText", "A point cache has no faces of its own. Put its mesh beside it under the "
                                              "same name (for example walk.obj for walk.pc2), or choose one.");
    case ErrorCode::NoAnimation:
        return QT_TRANSLATE_NOOP("ErrorText", "The scene has nothing to animate: %1.");
    case ErrorCode::ImporterFailed:
        return QT_TRANSLATE_NOOP("ErrorText", "The file cannot be read: %1");
    case ErrorCode::MeshesDiffer:
        return QT_TRANSLATE_NOOP("ErrorText", "The two animations cannot be compared: %1 is %2 in one and %3 in the "
                                              "other.");
    case ErrorCode::BadPermutation:
        return QT_TRANSLATE_NOOP("ErrorText", "This is not a permutation of the vertices: %1.");
    case ErrorCode::NoSurface:
        return QT_TRANSLATE_NOOP("ErrorText", "The file holds no ground: every part of it is void.");
    case ErrorCode::NotASurface:
        return QT_TRANSLATE_NOOP("ErrorText",
                                 "The mesh cannot be a terrain, which has one height at each place: %2, at %1. "
                                 "If height is not its z, say which axis is up.");
    case ErrorCode::BrokenTerrain:
        return QT_TRANSLATE_NOOP("ErrorText", "The terrain is damaged: %1 (%2).");
    case ErrorCode::CrossingConstraints:
        return QT_TRANSLATE_NOOP("ErrorText", "The line from point %1 to point %2 crosses the fixed line from point "
                                              "%3 to point %4.");
    case ErrorCode::BadSetting:
        return QT_TRANSLATE_NOOP("ErrorText", "%1 cannot be %2. Allowed: %3.");
    case ErrorCode::CannotOpen:
        return QT_TRANSLATE_NOOP("ErrorText", "The file cannot be opened: %1.");
    case ErrorCode::CannotRead:
        return QT_TRANSLATE_NOOP("ErrorText", "The file cannot be read: %1.");
    case ErrorCode::CannotWrite:
        return QT_TRANSLATE_NOOP("ErrorText",
                                 "The file cannot be written: %1. Check the free space and the permissions.");
    case ErrorCode::NotFound:
        return QT_TRANSLATE_NOOP("ErrorText", "There is no such file or folder.");
    case ErrorCode::LimitExceeded:
        return QT_TRANSLATE_NOOP("ErrorText", "Too large: %1 is %2, the limit is %3.");
    case ErrorCode::OutOfMemory:
        if (!hasArguments)
            return QT_TRANSLATE_NOOP("ErrorText",
                                     "There is not enough memory. Close other programs or use a smaller animation.");
        return QT_TRANSLATE_NOOP("ErrorText",
                                 "There is not enough memory: %1 bytes are needed. Close other programs or "
                                 "use a smaller animation.");
    case ErrorCode::Cancelled:
        return QT_TRANSLATE_NOOP("ErrorText", "Cancelled.");
    }
    return "";
}

/// Fixed phrases are translated, also around numbers ("vertex 12 of frame 3" is "vertex %1 of frame %2" to
/// translators); names and numbers alone stay.
QString argumentText(const std::string &argument)
{
    static const QRegularExpression number(QStringLiteral("\\d+"));
    const QString text = QString::fromStdString(argument);
    QString phrase = text;
    QStringList numbers;
    for (auto match = number.match(phrase); match.hasMatch();) {
        numbers << match.captured();
        const QString place = QStringLiteral("%%1").arg(numbers.size());
        phrase.replace(match.capturedStart(), match.capturedLength(), place);
        match = number.match(phrase, match.capturedStart() + place.size());
    }
    QString result = phrase.isEmpty() ? phrase : translate(phrase.toUtf8().constData());
    if (result == phrase)
        return text;
    for (qsizetype i = numbers.size(); i > 0; --i)
        result.replace(QStringLiteral("%%1").arg(i), numbers[i - 1]);
    return result;
}

/// File, line and byte, as far as they are known.
QString placeOf(const Error &error)
{
    const QString file = QDir::toNativeSeparators(QString::fromStdString(error.file));
    const bool hasLine = error.line != Error::None;
    if (!hasLine && error.offset == Error::None)
        return file;
    const QString number = QString::number(hasLine ? error.line : error.offset);
    if (file.isEmpty())
        return translate(hasLine ? QT_TRANSLATE_NOOP("ErrorText", "Line %1")
                                 : QT_TRANSLATE_NOOP("ErrorText", "Byte %1"))
            .arg(number);
    return translate(hasLine ? QT_TRANSLATE_NOOP("ErrorText", "%1, line %2")
                             : QT_TRANSLATE_NOOP("ErrorText", "%1, byte %2"))
        .arg(file, number);
}

/// Puts the arguments in the places of `text`, all at once: an argument that holds "%2" stays as it is.
QString filled(const QString &text, const std::vector<std::string> &args)
{
    QString result;
    for (qsizetype i = 0; i < text.size(); ++i) {
        const int place = text[i] == QLatin1Char('%') && i + 1 < text.size() ? text[i + 1].digitValue() : -1;
        if (place < 1) {
            result += text[i];
            continue;
        }
        result += std::size_t(place) <= args.size() ? argumentText(args[std::size_t(place) - 1]) : QStringLiteral("?");
        ++i;
    }
    return result;
}

} // namespace

QString errorText(const Error &error)
{
    const QString what = filled(translate(rowOf(error.code, !error.args.empty())), error.args);
    const QString place = placeOf(error);
    return place.isEmpty() ? what : translate(QT_TRANSLATE_NOOP("ErrorText", "%1: %2")).arg(place, what);
}

} // namespace model::io
