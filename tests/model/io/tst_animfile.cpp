// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/animfile.h"

#include "model/animation/editedframes.h"
#include "model/animation/sequence.h"
#include "model/codec/animationcodec.h"
#include "tests/model/io/iotest.h"
#include "tests/support/testmain.h"

#include <set>

#include <sys/stat.h>
#include <unistd.h>

#include <QDir>

using namespace model;
using namespace model::io;
using tests::WavyFrames;

class TestAnimFile final : public tests::FolderTest
{
    Q_OBJECT

private slots:
    void bytesComeBack()
    {
        for (const std::size_t size : {std::size_t(0), std::size_t(1), std::size_t(100'000)}) {
            Bytes bytes(size);
            for (std::size_t i = 0; i < size; ++i)
                bytes[i] = std::uint8_t(i * 7);
            QVERIFY(saveBytes(path("a"), bytes).has_value());
            const auto read = readBytes(path("a"));
            QVERIFY(read.has_value());
            QVERIFY(*read == bytes);
        }
        QCOMPARE(QDir(folder().path()).entryList(QDir::Files), QStringList("a"));
    }

    void whatIsNoOrdinaryFileIsRefused()
    {
        SANDREEL_COMPARE_ERROR(readBytes(path("none")), ErrorCode::NotFound);
        QVERIFY(QDir(folder().path()).mkdir("folder"));
        const auto folder = readBytes(path("folder"));
        SANDREEL_COMPARE_ERROR(folder, ErrorCode::CannotOpen);
        QCOMPARE(tests::argsOf(folder.error()), QStringList("it is a folder"));
        QCOMPARE(folder.error().file, path("folder").toStdString());
        // Opening a pipe that nobody writes to would block for ever.
        QCOMPARE(::mkfifo(path("pipe").toLocal8Bit().constData(), 0600), 0);
        for (const QString &special : {path("pipe"), QStringLiteral("/dev/zero")}) {
            const auto read = readBytes(special);
            SANDREEL_COMPARE_ERROR(read, ErrorCode::CannotOpen);
            QCOMPARE(tests::argsOf(read.error()), QStringList("it is not an ordinary file"));
        }
    }

    void hugeFileIsRefusedWithoutReadingIt()
    {
        tests::put(path("huge"), "x");
        QVERIFY(QFile::resize(path("huge"), qint64(1) << 40)); // takes no space: the file has a hole
        const auto read = readBytes(path("huge"));
        SANDREEL_COMPARE_ERROR(read, ErrorCode::LimitExceeded);
        QCOMPARE(read.error().args.at(1), std::to_string(std::uint64_t(1) << 40));
    }

    void fileWithoutPermissionIsAnError()
    {
        if (::geteuid() == 0)
            QSKIP("root may read everything");
        tests::put(path("secret"), "x");
        QVERIFY(QFile::setPermissions(path("secret"), {}));
        SANDREEL_COMPARE_ERROR(readBytes(path("secret")), ErrorCode::CannotOpen);
    }

    void aLargeMeshInASmallFileOpens()
    {
        // 64 MiB and 64 bytes for each byte of the file would not do for so many vertices.
        constexpr std::uint32_t VertexCount = 200'000;
        Connectivity connectivity;
        connectivity.vertexCount = VertexCount;
        const Sequence still(std::move(connectivity), std::vector<Vec3f>(VertexCount));
        const auto encoded = codec::encodeAnimation(still, CompressionSettings());
        QVERIFY(encoded.has_value());
        QCOMPARE(int(codec::decodeAnimation(encoded->bytes).error().code), int(ErrorCode::LimitExceeded));
        QVERIFY(saveBytes(path("large.anim"), encoded->bytes).has_value());
        QVERIFY(openAnim(path("large.anim"), Progress()).has_value());
    }

    void failedSaveLeavesTheOldFile()
    {
        tests::put(path("folder/file"), "old");
        SANDREEL_COMPARE_ERROR(saveBytes(path("folder"), Bytes(5)), ErrorCode::CannotOpen);
        SANDREEL_COMPARE_ERROR(saveBytes(path("none/file"), Bytes(5)), ErrorCode::CannotOpen);
        QCOMPARE(tests::contents(path("folder/file")), QByteArray("old"));
    }

    /// Saving replaces what is there, and must not replace a device or a pipe by a file.
    void onlyOrdinaryFilesAreReplaced()
    {
        QCOMPARE(::mkfifo(path("pipe").toLocal8Bit().constData(), 0600), 0);
        const auto saved = saveBytes(path("pipe"), Bytes(5));
        SANDREEL_COMPARE_ERROR(saved, ErrorCode::CannotOpen);
        QCOMPARE(tests::argsOf(saved.error()), QStringList("it is not an ordinary file"));
        QVERIFY(!QFileInfo(path("pipe")).isFile());
        const auto overFolder = saveBytes(path("."), Bytes(5));
        SANDREEL_COMPARE_ERROR(overFolder, ErrorCode::CannotOpen);
        QCOMPARE(tests::argsOf(overFolder.error()), QStringList("it is a folder"));
    }

    void renamedAnimationKeepsItsStream()
    {
        const auto decoded = encodeAndOpen();
        const EditedFrames renamed(decoded, TimeMap::identity(decoded->frameCount()), {}, 50, "other");
        const auto saved = encodeEdited(renamed, decoded->settings());
        QVERIFY(saved.has_value());
        QVERIFY(saved->bytes == *codec::withNameAndRate(decoded->encoded(), "other", 50));
        for (std::uint32_t i = 0; i < decoded->vertexCount(); ++i)
            QCOMPARE(saved->permutation[i], i);
        const auto again = codec::decodeAnimation(saved->bytes);
        QCOMPARE((*again)->name(), std::string("other"));
        QCOMPARE((*again)->frameRate(), 50.0);
        QVERIFY((*again)->frame(3) == decoded->frame(3));
    }

    void firstBytesOpen()
    {
        const auto encoded = codec::encodeAnimation(WavyFrames(40, 8), {ReelSettings{0.001, 0}});
        QVERIFY(encoded.has_value());
        QVERIFY(saveBytes(path("wavy.anim"), encoded->bytes).has_value());
        const std::uint64_t size = encoded->bytes.size();
        const auto whole = openAnimPrefix(path("wavy.anim"), size + 5);
        QVERIFY(whole.has_value());
        QCOMPARE(whole->bytes, size);
        QCOMPARE(whole->fileBytes, size);
        QCOMPARE(whole->animation->basisSize(), whole->bandsInFile);
        QVERIFY(whole->animation->encoded() == encoded->bytes);
        const std::uint64_t least = whole->animation->prefixBytes().front();
        const auto part = openAnimPrefix(path("wavy.anim"), least);
        QVERIFY(part.has_value());
        QCOMPARE(part->bytes, least);
        QCOMPARE(part->animation->basisSize(), 0u);
        QCOMPARE(part->bandsInFile, whole->bandsInFile);
        const auto tooFew = openAnimPrefix(path("wavy.anim"), least - 1);
        SANDREEL_COMPARE_ERROR(tooFew, ErrorCode::Truncated);
        QCOMPARE(tests::argsOf(tooFew.error()), (QStringList{QString::number(least), QString::number(least - 1)}));
        QCOMPARE(tooFew.error().file, path("wavy.anim").toStdString());
        // The file itself ends in the middle of its shape: as much as it tells.
        QVERIFY(QFile::resize(path("wavy.anim"), qint64(least - 3)));
        const auto cut = openAnimPrefix(path("wavy.anim"), 40);
        SANDREEL_COMPARE_ERROR(cut, ErrorCode::Truncated);
        QCOMPARE(tests::argsOf(cut.error()), (QStringList{QString::number(least), "40"}));
        SANDREEL_COMPARE_ERROR(openAnimPrefix(path("none.anim"), 40), ErrorCode::NotFound);
        // Of the other codecs all is needed.
        encodeAndOpen();
        const qint64 all = QFileInfo(path("wavy.anim")).size();
        const auto pca = openAnimPrefix(path("wavy.anim"), std::uint64_t(all) - 1);
        SANDREEL_COMPARE_ERROR(pca, ErrorCode::Truncated);
        QCOMPARE(tests::argsOf(pca.error()).at(0), QString::number(all));
    }

    void changedAnimationIsEncodedAgain()
    {
        const auto decoded = encodeAndOpen();
        const TimeMap all = TimeMap::identity(decoded->frameCount());
        CompressionSettings finer = decoded->settings();
        std::get<PcaSettings>(finer.method).resolution *= 2;
        const EditedFrames same(decoded, all, {}, 30, "wavy"), trimmed(decoded, all.trimmed(1, 4), {}, 30, "wavy"),
            moved(decoded, all, {2, {1, 0, 0}}, 30, "wavy");
        const auto check = [](const EditedFrames &frames, const CompressionSettings &settings) {
            const auto saved = encodeEdited(frames, settings), fresh = codec::encodeAnimation(frames, settings);
            QVERIFY(saved.has_value() && fresh.has_value());
            QVERIFY(saved->bytes == fresh->bytes);
        };
        check(same, finer);
        check(trimmed, decoded->settings());
        check(moved, decoded->settings());
    }

private:
    std::shared_ptr<const codec::DecodedAnimation> encodeAndOpen()
    {
        const auto encoded = codec::encodeAnimation(WavyFrames(40, 8), {PcaSettings()});
        if (!encoded || !saveBytes(path("wavy.anim"), encoded->bytes))
            qFatal("cannot make an animation");
        return *openAnim(path("wavy.anim"));
    }
};

SANDREEL_TEST(TestAnimFile)
#include "tst_animfile.moc"
