// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/document/terraindocument.h"
#include "model/io/terrain/terrainfile.h"
#include "model/io/terrain/zipfile.h"
#include "model/terrain/tin/validate.h"
#include "tests/model/io/terrain/terrains.h"
#include "tests/support/scarcity.h"
#include "tests/support/testmain.h"

#include <QDir>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QRegularExpression>
#include <QTemporaryDir>

#include <functional>

#include <zlib.h>

using namespace model;
using namespace model::io;
using namespace model::terrain;

namespace {

constexpr std::uint64_t Limit = std::uint64_t(1) << 28;

Bytes specimenBytes()
{
    TerrainExtras extras;
    extras.tools = {{"brush", QJsonObject{{"radius", 3.5}}}};
    extras.thumbnail = {0x89, 'P', 'N', 'G'};
    return *formatTerrain(tests::specimenTerrain(), extras);
}

ZipEntry &entry(std::vector<ZipEntry> &entries, const std::string &name)
{
    return *std::find_if(entries.begin(), entries.end(), [&](const ZipEntry &e) { return e.name == name; });
}

QJsonObject manifestOf(std::vector<ZipEntry> &entries)
{
    const Bytes &bytes = entry(entries, "manifest.json").bytes;
    return QJsonDocument::fromJson(QByteArray(reinterpret_cast<const char *>(bytes.data()), qsizetype(bytes.size())))
        .object();
}

/// The specimen with its parts changed, and sizes and checksums in the manifest mended where asked.
Bytes changed(const std::function<void(std::vector<ZipEntry> &)> &change, bool mends = true,
              const std::function<void(QJsonObject &)> &changeManifest = {})
{
    std::vector<ZipEntry> entries = *readZip(specimenBytes(), Limit);
    QJsonObject manifest = manifestOf(entries);
    change(entries);
    if (mends) {
        QJsonObject list;
        for (const ZipEntry &e : entries)
            if (e.name != "mimetype" && e.name != "manifest.json")
                list[QString::fromStdString(e.name)] = QJsonObject{
                    {"bytes", double(e.bytes.size())},
                    {"crc32",
                     QStringLiteral("%1").arg(quint32(crc32_z(crc32(0, nullptr, 0), e.bytes.data(), e.bytes.size())), 8,
                                              16, QLatin1Char('0'))}};
        manifest["entries"] = list;
    }
    if (changeManifest)
        changeManifest(manifest);
    const QByteArray text = QJsonDocument(manifest).toJson();
    for (ZipEntry &e : entries)
        if (e.name == "manifest.json")
            e.bytes.assign(text.begin(), text.end());
    return *writeZip(entries);
}

const auto Nothing = [](std::vector<ZipEntry> &) {};

} // namespace

class TestTerrainFile final : public QObject
{
    Q_OBJECT

private slots:
    void everythingComesBack()
    {
        for (const tests::Ground ground : tests::EveryGround) {
            const Terrain terrain = tests::specimenTerrain(ground, 9, 500);
            TerrainExtras extras;
            extras.step = {0.25, 0.5};
            extras.tools = {{"tool", "rake"}, {"radius", 1.5}};
            extras.thumbnail = {1, 2, 3};
            const auto bytes = formatTerrain(terrain, extras);
            QVERIFY(bytes.has_value());
            const auto file = parseTerrain(*bytes, Limit);
            QVERIFY2(file.has_value(), file ? "" : file.error().args[0].c_str());
            QCOMPARE(tests::describe(file->terrain), tests::describe(terrain));
            QVERIFY(findDefects(file->terrain.tin).empty());
            QCOMPARE(savedFingerprint(file->terrain), savedFingerprint(terrain));
            QCOMPARE(file->extras.tools, extras.tools);
            QCOMPARE(file->extras.thumbnail, extras.thumbnail);
            QCOMPARE(file->extras.step, extras.step);
            QVERIFY(!file->isNewer);
            // And again: the same bytes, although everything has other numbers now.
            const auto again = parseTerrain(*formatTerrain(file->terrain, file->extras), Limit);
            QVERIFY(again.has_value());
            QCOMPARE(tests::describe(again->terrain), tests::describe(terrain));
            QCOMPARE(*formatTerrain(terrain, extras), *bytes);
        }
    }

    void isAnOrdinaryZip()
    {
        const Bytes bytes = specimenBytes();
        // The type is where `file` and desktops look for it.
        const std::string_view text(reinterpret_cast<const char *>(bytes.data()), bytes.size());
        QCOMPARE(text.substr(30, 40), std::string_view("mimetypeapplication/vnd.sandreel.terrain"));
        const auto entries = readZip(bytes, Limit);
        QVERIFY(entries.has_value());
        QCOMPARE(entries->at(1).name, std::string("manifest.json"));
    }

    void whatIsForeignSurvives()
    {
        const Bytes bytes = changed(
            [](auto &entries) {
                entries.push_back({"plugins/river.bin", {1, 2, 3, 4}, true});
            },
            true,
            [](QJsonObject &manifest) {
                manifest["optional"] = QJsonArray{"rivers"};
                manifest["x-author"] = "somebody";
                manifest["version"] = QJsonArray{1, 7};
            });
        const auto file = parseTerrain(bytes, Limit);
        QVERIFY(file.has_value());
        QVERIFY(file->isNewer);
        const auto again = parseTerrain(*formatTerrain(file->terrain, file->extras), Limit);
        QVERIFY(again.has_value());
        QCOMPARE(again->extras.others, (std::vector<ForeignEntry>{{"plugins/river.bin", {1, 2, 3, 4}}}));
        QCOMPARE(again->extras.manifest["x-author"].toString(), QStringLiteral("somebody"));
        QVERIFY(!again->isNewer);
    }

    void badFilesAreRefused_data()
    {
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<int>("code");
        QTest::addColumn<QString>("argument");
        const auto row = [](const char *name, const Bytes &bytes, ErrorCode code, const char *argument) {
            QTest::newRow(name) << QByteArray(reinterpret_cast<const char *>(bytes.data()), qsizetype(bytes.size()))
                                << int(code) << argument;
        };
        const auto text = [](const char *t) {
            const std::string_view view(t);
            return Bytes(view.begin(), view.end());
        };
        row("empty", {}, ErrorCode::BadMagic, ".terrain");
        row("text", text("hello, this is no terrain"), ErrorCode::BadMagic, ".terrain");
        row("half a ZIP", {'P', 'K', 3, 4, 0, 0}, ErrorCode::CorruptStream, "ZIP");
        row("another ZIP", *writeZip({{"a.txt", text("x"), false}}), ErrorCode::BadMagic, ".terrain");
        row("another type", changed([&](auto &e) { e[0].bytes = text("application/zip"); }), ErrorCode::BadMagic,
            ".terrain");
        row("type not first", changed([&](auto &e) { std::swap(e[0], e[1]); }), ErrorCode::BadMagic, ".terrain");
        row("no manifest", changed([&](auto &e) { e.erase(e.begin() + 1); }), ErrorCode::MissingChunk, "manifest.json");
        row("manifest of nothing",
            *writeZip(
                {{"mimetype", text("application/vnd.sandreel.terrain"), false}, {"manifest.json", text("{"), false}}),
            ErrorCode::SyntaxError, "JSON");
        row("manifest of another thing",
            *writeZip(
                {{"mimetype", text("application/vnd.sandreel.terrain"), false}, {"manifest.json", text("[]"), false}}),
            ErrorCode::SyntaxError, "a JSON object");
        row("newer major",
            changed(Nothing, true,
                    [](auto &m) {
                        m["version"] = QJsonArray{2, 0};
                    }),
            ErrorCode::UnsupportedVersion, "2.0");
        row("required feature", changed(Nothing, true, [](auto &m) { m["requires"] = QJsonArray{"caves"}; }),
            ErrorCode::UnsupportedFeature, "caves");
        row("no version", changed(Nothing, true, [](auto &m) { m["version"] = "1"; }), ErrorCode::BadValue, "version");
        row("no features", changed(Nothing, true, [](auto &m) { m.remove("requires"); }), ErrorCode::BadValue,
            "requires");
        row("another format", changed(Nothing, true, [](auto &m) { m["format"] = "x"; }), ErrorCode::BadValue,
            "format");
        row("origin", changed(Nothing, true, [](auto &m) { m["origin"] = QJsonArray{1}; }), ErrorCode::BadValue,
            "origin");
        row("unit", changed(Nothing, true, [](auto &m) { m["unit"] = 3; }), ErrorCode::BadValue, "unit");
        row("crs", changed(Nothing, true, [](auto &m) { m.remove("crs"); }), ErrorCode::BadValue, "crs");
        row("step", changed(Nothing, true, [](auto &m) { m["step"] = QJsonArray{0, 1}; }), ErrorCode::BadValue, "step");
        row("a part that is not there", changed([](auto &e) { e.erase(e.begin() + 2); }, false),
            ErrorCode::MissingChunk, "terrain/surface");
        row("a part that nobody lists", changed([](auto &e) { e.erase(e.begin() + 2); }), ErrorCode::MissingChunk,
            "terrain/surface");
        row("a part changed", changed([](auto &e) { entry(e, "terrain/ledger").bytes[3] ^= 1; }, false),
            ErrorCode::ChecksumMismatch, "terrain/ledger");
        row("a ledger too short", changed([](auto &e) { entry(e, "terrain/ledger").bytes.pop_back(); }),
            ErrorCode::Truncated, "8");
        row("a ledger too long", changed([](auto &e) { entry(e, "terrain/ledger").bytes.push_back(0); }),
            ErrorCode::TrailingBytes, "1");
        row("a ledger of nothing", changed([](auto &e) {
                entry(e, "terrain/ledger").bytes[7] = 0xff;
                entry(e, "terrain/ledger").bytes[6] = 0xff;
            }),
            ErrorCode::NonFinite, "volume");
        row("a constraint of nobody",
            changed([](auto &e) { entry(e, "terrain/constraints").bytes = {1, 3, 3, 0, 9, 0}; }),
            ErrorCode::BrokenTerrain, "constraint");
        row("a constraint too far",
            changed([](auto &e) { entry(e, "terrain/constraints").bytes = {1, 4, 4, 0, 0xff, 0x7f, 0}; }),
            ErrorCode::BadValue, "constraint");
        row("materials of nothing", changed([&](auto &e) { entry(e, "materials.json").bytes = text("nonsense"); }),
            ErrorCode::SyntaxError, "JSON");
        row("too few materials",
            changed([&](auto &e) { entry(e, "materials.json").bytes = text("{\"materials\":[]}"); }),
            ErrorCode::BadValue, "material of layer 0");
        row("a material out of range",
            changed([&](auto &e) { entry(e, "materials.json").bytes = text("{\"materials\":[{\"humidity\":7}]}"); }),
            ErrorCode::BadSetting, "humidity");
        row("tools of nothing", changed([&](auto &e) { entry(e, "tools.json").bytes = text("]"); }),
            ErrorCode::SyntaxError, "JSON");
        row("a way out of the folder", changed([](auto &e) {
                e.push_back({"../../.bashrc", {1}, false});
            }),
            ErrorCode::BadValue, "name of a part");
        row("an absolute name", changed([](auto &e) {
                e.push_back({"/etc/passwd", {1}, false});
            }),
            ErrorCode::BadValue, "name of a part");
        row("another way out", changed([](auto &e) {
                e.push_back({"a\\..\\b", {1}, false});
            }),
            ErrorCode::BadValue, "name of a part");
    }
    void badFilesAreRefused()
    {
        QFETCH(QByteArray, bytes);
        QFETCH(int, code);
        QFETCH(QString, argument);
        const auto file =
            parseTerrain({reinterpret_cast<const std::uint8_t *>(bytes.data()), std::size_t(bytes.size())}, Limit);
        QVERIFY(!file.has_value());
        QCOMPARE(int(file.error().code), code);
        QCOMPARE(QString::fromStdString(file.error().args[0]), argument);
    }

    void everyPrefixIsRefused()
    {
        const Bytes bytes = specimenBytes();
        for (std::size_t size = 0; size < bytes.size(); size += 1 + size / 97)
            QVERIFY(!parseTerrain(Bytes(bytes.begin(), bytes.begin() + std::ptrdiff_t(size)), Limit).has_value());
        QVERIFY(!parseTerrain(Bytes(bytes.begin(), bytes.end() - 1), Limit).has_value());
    }

    /// 100 MB of zeros in 100 kB, and a claim of more than there is.
    void bombsAreDefused()
    {
        const Bytes bomb = changed([](auto &e) { e.push_back({"bomb", Bytes(100'000'000), true}); }, false);
        QVERIFY(bomb.size() < 200'000);
        {
            tests::AllocationMeter meter;
            const auto file = parseTerrain(bomb, 1'000'000);
            SANDREEL_COMPARE_ERROR(file, ErrorCode::LimitExceeded);
            QVERIFY(meter.peak() < 2'000'000);
        }
        std::vector<ZipEntry> many;
        for (int i = 0; i < 5000; ++i)
            many.push_back({"e" + std::to_string(i), {}, false});
        SANDREEL_COMPARE_ERROR(parseTerrain(*writeZip(many), Limit), ErrorCode::LimitExceeded);
    }

    void savesAllOrNothing()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath("a.terrain");
        const Terrain terrain = tests::specimenTerrain();
        QVERIFY(saveTerrain(path, terrain, {}).has_value());
        QCOMPARE(tests::describe(openTerrain(path)->terrain), tests::describe(terrain));
        const QByteArray before = tests::readFile(path);
        {
            const tests::FileSizeLimit full(1000);
            SANDREEL_COMPARE_ERROR(saveTerrain(path, tests::plainTerrain(), {}), ErrorCode::CannotWrite);
        }
        const Progress progress;
        progress.cancel();
        SANDREEL_COMPARE_ERROR(saveTerrain(path, terrain, {}, progress), ErrorCode::Cancelled);
        QCOMPARE(tests::readFile(path), before);
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden), QStringList{"a.terrain"});
        SANDREEL_COMPARE_ERROR(saveTerrain(folder.filePath("no/a.terrain"), terrain, {}), ErrorCode::CannotOpen);
        SANDREEL_COMPARE_ERROR(openTerrain(folder.filePath("none.terrain")), ErrorCode::NotFound);
        SANDREEL_COMPARE_ERROR(openTerrain(folder.path()), ErrorCode::CannotOpen);
    }

    /// Files of every version that was released open, as they were.
    void goldenFilesOpen()
    {
        const QDir folder(QStringLiteral(SANDREEL_SOURCE "/tests/data/terrain"));
        const QStringList files = folder.entryList({"*.terrain"}, QDir::Files);
        QVERIFY(!files.isEmpty());
        for (const QString &name : files) {
            const auto file = openTerrain(folder.filePath(name));
            QVERIFY2(file.has_value(), qPrintable(name));
            const QByteArray expected = tests::readFile(folder.filePath(QFileInfo(name).completeBaseName() + ".txt"));
            QCOMPARE(tests::describe(file->terrain), expected);
        }
    }

    void documentSaysTheVersion()
    {
        const QByteArray document = tests::readFile(QStringLiteral(SANDREEL_SOURCE "/model/io/terrain/FORMAT.md"));
        QVERIFY(document.contains(
            QStringLiteral("Format version: %1.%2\n").arg(TerrainFormatMajor).arg(TerrainFormatMinor).toUtf8()));
    }

    /// The worked example of the document, taken out of it.
    void workedExampleOpens()
    {
        const QString document =
            QString::fromUtf8(tests::readFile(QStringLiteral(SANDREEL_SOURCE "/model/io/terrain/FORMAT.md")));
        static const QRegularExpression block("```hex\n([^`]*)```");
        const QString hex = block.match(document).captured(1);
        QVERIFY(!hex.isEmpty());
        Bytes surface;
        for (const QString &line : hex.split('\n'))
            for (const QString &byte : line.section('#', 0, 0).split(' ', Qt::SkipEmptyParts))
                surface.push_back(std::uint8_t(byte.toUInt(nullptr, 16)));
        const Bytes bytes = changed([&](auto &e) {
            entry(e, "terrain/surface").bytes = surface;
            entry(e, "terrain/constraints").bytes = {0, 0, 0};
            entry(e, "terrain/ledger").bytes.resize(88);
        });
        const auto file = parseTerrain(bytes, Limit);
        QVERIFY2(file.has_value(), file ? "" : file.error().args[0].c_str());
        const Tin &tin = file->terrain.tin;
        QCOMPARE(tin.vertexCount(), 5u);
        QCOMPARE(tin.triangleCount(), 4u);
        QCOMPARE(tin.heightAt({2, 2}), 3.0);
        QCOMPARE(tin.heightAt({0, 0}), 0.0);
        QCOMPARE(tin.domain(), (Rectangle{{0, 0}, {4, 4}}));
    }
};

SANDREEL_TEST(TestTerrainFile)
#include "tst_terrainfile.moc"
