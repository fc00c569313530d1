// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/testmain.h"
#include "tests/views/terrain/groundshapes.h"
#include "tests/views/terrain/settled.h"
#include "views/terrain/picture/groundvertices.h"
#include "views/terrain/terrainpictures.h"
#include "views/terrain/terrainviewport.h"
#include "views/viewport/glsupport.h"

#include <QDir>
#include <QPainter>
#include <QtConcurrentRun>

using namespace model::terrain;
using namespace views;

namespace {

constexpr QSize Size{192, 144};

/// How far two pictures are apart: the mean difference of a channel, and the largest mean of a block of 8 x 8 pixels.
/// Drivers round differently and smooth edges differently, which a block evens out; shaders that are wrong do not.
struct Difference
{
    double mean = 255, block = 255;

    bool isSmall() const { return mean <= 2.5 && block <= 14; }
    QString told() const { return QString("mean %1, worst block %2").arg(mean, 0, 'f', 2).arg(block, 0, 'f', 1); }
};

Difference differenceOf(const QImage &a, const QImage &b)
{
    if (a.size() != b.size() || a.isNull())
        return {};
    Difference difference{0, 0};
    constexpr int Side = 8;
    for (int top = 0; top < a.height(); top += Side)
        for (int left = 0; left < a.width(); left += Side) {
            double red = 0, green = 0, blue = 0; // of the block's mean colours
            for (int y = top; y < top + Side; ++y)
                for (int x = left; x < left + Side; ++x) {
                    const QRgb p = a.pixel(x, y), q = b.pixel(x, y);
                    red += qRed(p) - qRed(q);
                    green += qGreen(p) - qGreen(q);
                    blue += qBlue(p) - qBlue(q);
                    difference.mean +=
                        std::abs(qRed(p) - qRed(q)) + std::abs(qGreen(p) - qGreen(q)) + std::abs(qBlue(p) - qBlue(q));
                }
            const double largest = std::max({std::abs(red), std::abs(green), std::abs(blue)}) / (Side * Side);
            difference.block = std::max(difference.block, largest);
        }
    difference.mean /= 3.0 * a.width() * a.height();
    return difference;
}

/// A hollow in dunes, the northern half of it wet.
std::unique_ptr<model::TerrainDocument> specimen()
{
    auto document = tests::groundDocument(tests::UnitSquare, 90, [](double x, double y) {
        const double away = std::hypot(x - 0.45, y - 0.5);
        return tests::dunes(x, y) - 0.12 * std::exp(-away * away / 0.02);
    });
    document->setMaterials({material(MaterialPreset::DrySand)});
    document->edit([](TinEdit &edit) {
        edit.addLayer(0, 0);
        for (VertexId v = 0; v < edit.tin().arrays().vertexSlots(); ++v)
            edit.setLayer(v, 0, {0.3, edit.tin().arrays().points[v].y > 0.55 ? 0.8f : 0.0f});
    });
    return document;
}

} // namespace

/// Pictures against stored ones. SANDREEL_WRITE_REFERENCES=1 writes them anew: look at them before they are kept.
class TestTerrainPictures final : public QObject
{
    Q_OBJECT

    std::unique_ptr<model::TerrainDocument> mDocument;
    std::unique_ptr<TerrainViewport> mViewport;

    static QString fileOf(const QString &name)
    {
        return QStringLiteral(SANDREEL_SOURCE_DIR "/tests/data/terrain/pictures/%1.png").arg(name);
    }
    static model::OrbitCamera camera()
    {
        model::OrbitCamera camera;
        camera.target = {0, -0.03f, 0};
        camera.yaw = 0.5f;
        camera.pitch = 0.7f;
        camera.distance = 1.5f;
        return camera;
    }
    TerrainStyle plain() const
    {
        TerrainStyle style;
        style.isDark = true;
        return style;
    }
    QImage drawn(const TerrainStyle &style)
    {
        mViewport->setStyle(style);
        return mViewport->renderPicture(Size, camera());
    }

private slots:
    void initTestCase()
    {
        QVERIFY2(glSupport().isSufficient, "these tests need a display with OpenGL 3.3");
        mDocument = specimen();
        mViewport = std::make_unique<TerrainViewport>(*mDocument);
        mViewport->resize(320, 240);
        mViewport->show();
        QVERIFY(QTest::qWaitForWindowExposed(mViewport.get()));
    }
    void cleanupTestCase()
    {
        mViewport.reset();
        mDocument.reset();
    }

    void looksLikeItsReference_data()
    {
        QTest::addColumn<int>("quality");
        QTest::addColumn<int>("look");
        QTest::addColumn<int>("overlay");
        const auto row = [](const char *name, GroundQuality quality, GroundLook look, GroundOverlay overlay) {
            QTest::newRow(name) << int(quality) << int(look) << int(overlay);
        };
        row("sand-low", GroundQuality::Low, GroundLook::Sand, GroundOverlay::None);
        row("sand-medium", GroundQuality::Medium, GroundLook::Sand, GroundOverlay::None);
        row("sand-high", GroundQuality::High, GroundLook::Sand, GroundOverlay::None);
        row("recipe", GroundQuality::Medium, GroundLook::Reference, GroundOverlay::None);
        row("slope", GroundQuality::Medium, GroundLook::Sand, GroundOverlay::Slope);
        row("humidity", GroundQuality::Medium, GroundLook::Sand, GroundOverlay::Humidity);
    }
    void looksLikeItsReference()
    {
        QFETCH(int, quality);
        QFETCH(int, look);
        QFETCH(int, overlay);
        TerrainStyle style = plain();
        style.quality = GroundQuality(quality);
        style.look = GroundLook(look);
        style.overlay = GroundOverlay(overlay);
        style.hasContours = overlay == int(GroundOverlay::Slope);
        const QImage picture = drawn(style);
        const QString file = fileOf(QString::fromLatin1(QTest::currentDataTag()));
        if (qEnvironmentVariableIsSet("SANDREEL_WRITE_REFERENCES")) {
            QDir().mkpath(QFileInfo(file).path());
            QVERIFY(picture.save(file));
        }
        const QImage reference(file);
        QVERIFY2(!reference.isNull(), qPrintable(file));
        const Difference difference = differenceOf(picture, reference.convertToFormat(picture.format()));
        QVERIFY2(difference.isSmall(), qPrintable(difference.told()));

        // What a broken picture would be is told from it.
        const QColor mean = picture.scaled(1, 1, Qt::IgnoreAspectRatio, Qt::SmoothTransformation).pixelColor(0, 0);
        QImage broken(picture.size(), picture.format());
        for (const QColor &color : {mean, QColor(Qt::black), QColor(Qt::white)}) {
            broken.fill(color);
            QVERIFY2(!differenceOf(broken, reference).isSmall(), qPrintable(color.name()));
        }
        QVERIFY(!differenceOf(picture.mirrored(true, false), reference).isSmall());
    }

    void everyChoiceMakesAnotherPicture()
    {
        TerrainStyle style = plain();
        const QImage usual = drawn(style);
        const auto isOther = [&](auto change) {
            TerrainStyle other = plain();
            change(other);
            return !differenceOf(drawn(other), usual).isSmall();
        };
        QVERIFY(isOther([](TerrainStyle &other) { other.sunAzimuth += 90; }));
        QVERIFY(isOther([](TerrainStyle &other) { other.sunElevation += 40; }));
        QVERIFY(isOther([](TerrainStyle &other) { other.look = GroundLook::Reference; }));
        QVERIFY(isOther([](TerrainStyle &other) { other.isDark = false; }));
    }

    /// Sand that comes and goes leaves the ground as it was, and its detail elsewhere: half a reach on the other copy
    /// of it has taken over, in its place. What is too flat to slide keeps its detail.
    void detailTravelsWithTheSand_data()
    {
        QTest::addColumn<double>("slope");
        QTest::addColumn<int>("quality");
        QTest::addColumn<bool>("travels");
        QTest::newRow("steep") << 0.6 << int(GroundQuality::High) << true;
        QTest::newRow("steep, medium") << 0.6 << int(GroundQuality::Medium) << true;
        QTest::newRow("steep, without detail") << 0.6 << int(GroundQuality::Low) << false;
        QTest::newRow("flat") << 0.1 << int(GroundQuality::High) << false;
    }
    void detailTravelsWithTheSand()
    {
        QFETCH(double, slope);
        QFETCH(int, quality);
        QFETCH(bool, travels);
        const auto document =
            tests::groundDocument(tests::UnitSquare, 60, [&](double x, double) { return -slope * x; });
        TerrainViewport viewport(*document);
        viewport.resize(320, 240);
        viewport.show();
        QVERIFY(QTest::qWaitForWindowExposed(&viewport));
        TerrainStyle style = plain();
        style.quality = GroundQuality(quality);
        viewport.setStyle(style);
        model::OrbitCamera near = camera();
        near.distance = 0.3f; // grains are to be seen
        const auto picture = [&] { return viewport.renderPicture(Size, near); };
        const auto raise = [&](double by) {
            document->edit([&](TinEdit &edit) {
                for (VertexId v = 0; v < edit.tin().arrays().vertexSlots(); ++v)
                    edit.setHeight(v, edit.tin().arrays().heights[v] + by);
            });
            picture(); // uploads it
        };
        const QImage before = picture();
        constexpr double Quarter = 0.012 / 4 * 0.6 / 1.5 / 2; // of the reach, gone twice
        raise(-Quarter);
        raise(Quarter);
        const QImage quarter = picture();
        raise(-Quarter);
        raise(Quarter);
        const QImage half = picture();
        if (travels) {
            const double away = differenceOf(quarter, before).mean, back = differenceOf(half, before).mean;
            QVERIFY2(away > 1 && back < away / 4, qPrintable(QString("%1, %2").arg(away).arg(back)));
        } else {
            QCOMPARE(quarter, before);
            QCOMPARE(half, before);
        }
    }

    void sandSlidesDownhill()
    {
        const float reach = 2, drop = 0.5f;
        const auto facing = [](double x, double z) {
            return GroundHeight{1, std::int16_t(std::lround(x * 32767)), std::int16_t(std::lround(z * 32767))};
        };
        const double angle = 35 * 3.14159265358979 / 180;
        const GroundSlide east = slid({}, 1 - drop, facing(std::sin(angle), 0), reach);
        // What came and went, over the slope, and half as much again that passes through.
        QCOMPARE(int(east.x), int(std::lround(1.5 * drop / std::tan(angle) / reach * SlideSteps)));
        QCOMPARE(int(east.z), 0);
        QVERIFY(slid({}, 1 + drop, facing(std::sin(angle), 0), reach) == east); // also where sand has gone
        const GroundSlide south = slid(east, 1 - drop, facing(0, std::sin(angle)), reach);
        QVERIFY(south.x == east.x && south.z == east.x);
        QVERIFY(slid(east, 1 - drop, facing(0.1, 0), reach) == east); // 6 degrees
        QVERIFY(slid({32767, 0}, -1e9f, facing(0.6, 0), reach) == (GroundSlide{32767, 0}));
        QVERIFY(slid({}, 1, facing(0, 0), reach) == GroundSlide());
    }

    void picturesInTheBackgroundAreTheSame()
    {
        TerrainStyle style = plain();
        const QImage expected = drawn(style);
        const DrawView draw = drawingOf(*mViewport);
        auto made = QtConcurrent::run([&] { return draw(Size, camera(), model::Progress()); });
        QTRY_VERIFY_WITH_TIMEOUT(made.isFinished(), 60000);
        QVERIFY(made.result().has_value());
        QCOMPARE(*made.result(), expected);
        // A cancel ends it, and too large a picture is none.
        model::Progress cancelled;
        cancelled.cancel();
        made = QtConcurrent::run([&] { return draw(Size, camera(), cancelled); });
        QTRY_VERIFY_WITH_TIMEOUT(made.isFinished(), 60000);
        QVERIFY(!made.result().has_value());
        made = QtConcurrent::run([&] { return draw({1 << 20, 10}, camera(), model::Progress()); });
        QTRY_VERIFY_WITH_TIMEOUT(made.isFinished(), 60000);
        QVERIFY(made.result().has_value() && made.result()->isNull());
    }
};

SANDREEL_TEST(TestTerrainPictures)
#include "tst_terrainpictures.moc"
