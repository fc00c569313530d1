// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/testmain.h"
#include "tests/views/terrain/groundshapes.h"
#include "tests/views/terrain/settled.h"
#include "views/terrain/groundlegend.h"
#include "views/terrain/picture/constraintlines.h"
#include "views/terrain/terrainviewport.h"
#include "views/viewport/glsupport.h"

#include <cmath>
#include <numbers>
#include <set>

using namespace model::terrain;
using namespace views;

namespace {

/// From straight above: every place of the square is seen.
model::OrbitCamera fromAbove()
{
    model::OrbitCamera camera;
    camera.yaw = 0;
    camera.pitch = std::numbers::pi_v<float> / 2;
    camera.distance = 1.6f;
    return camera;
}

/// What an overlay's colour becomes on a plane that rises by `rise` metres a metre to the east; see terrain.frag.
QColor shaded(QRgb color, double rise, const TerrainStyle &style)
{
    const double azimuth = style.sunAzimuth * std::numbers::pi / 180;
    const double elevation = style.sunElevation * std::numbers::pi / 180;
    const double sunEast = std::sin(azimuth) * std::cos(elevation), sunUp = std::sin(elevation);
    const double lambert = std::max((-rise * sunEast + sunUp) / std::sqrt(1 + rise * rise), 0.0);
    const double shade = std::clamp(0.55 + 0.45 * lambert / sunUp, 0.5, 1.15);
    const auto part = [shade](int value) { return std::min(int(std::lround(value * shade)), 255); };
    return QColor(part(qRed(color)), part(qGreen(color)), part(qBlue(color)));
}

int distanceOf(QColor a, QColor b)
{
    return std::max({std::abs(a.red() - b.red()), std::abs(a.green() - b.green()), std::abs(a.blue() - b.blue())});
}

QString told(QColor seen, QColor expected)
{
    return seen.name() + " instead of " + expected.name();
}

} // namespace

class TestTerrainOverlays final : public QObject
{
    Q_OBJECT

private:
    std::unique_ptr<model::TerrainDocument> mDocument;
    std::unique_ptr<TerrainViewport> mViewport;
    TerrainStyle mStyle;

    template <class Height>
    void show(int side, Height height)
    {
        mViewport.reset();
        mDocument = tests::groundDocument(tests::UnitSquare, side, height);
        mViewport = std::make_unique<TerrainViewport>(*mDocument);
        mViewport->resize(420, 420);
        mViewport->show();
        QVERIFY(QTest::qWaitForWindowExposed(mViewport.get()));
        mViewport->setCamera(fromAbove());
        mStyle = mViewport->style();
        mStyle.quality = GroundQuality::Low;
        mStyle.hasLegend = false;
        setStyle();
    }
    void setStyle()
    {
        mViewport->setStyle(mStyle);
        QTRY_VERIFY(!mViewport->isLoading());
    }
    /// The ground at a place of the square.
    QColor seenAt(const QImage &image, double x, double y) const
    {
        const auto place = mViewport->placeOf({x, y, mDocument->tin().heightAt({x, y})});
        return image.pixelColor(place->toPoint());
    }
    /// The least lightness of the pixels at and around a place: a line is one pixel wide.
    int darkestAt(const QImage &image, double x, double y) const
    {
        const QPoint place = mViewport->placeOf({x, y, mDocument->tin().heightAt({x, y})})->toPoint();
        int darkest = 255;
        for (const int dx : {-1, 0, 1})
            for (const int dy : {-1, 0, 1})
                darkest = std::min(darkest, image.pixelColor(place + QPoint(dx, dy)).lightness());
        return darkest;
    }
    QImage picture() { return tests::settled(*mViewport); }

private slots:
    void initTestCase() { QVERIFY2(glSupport().isSufficient, "these tests need a display with OpenGL 3.3"); }
    void cleanup()
    {
        mViewport.reset();
        mDocument.reset();
    }

    void heightHasTheColoursOfTheLegend()
    {
        show(12, [](double x, double) { return 100 + 0.5 * x; });
        mStyle.overlay = GroundOverlay::Height;
        setStyle();
        const QImage image = picture();
        for (const double x : {0.12, 0.37, 0.5, 0.66, 0.91}) {
            const QColor expected = shaded(colorAt(SequentialColors, {100, 100.5}, 100 + 0.5 * x), 0.5, mStyle);
            const QColor seen = seenAt(image, x, 0.45);
            QVERIFY2(distanceOf(seen, expected) <= 5, qPrintable(told(seen, expected)));
        }
    }

    void slopeIsThatOfTheTriangle_data()
    {
        QTest::addColumn<double>("rise");
        for (const double rise : {0.0, 0.2, -0.2, 0.577, 1.2})
            QTest::addRow("%g", rise) << rise;
    }
    void slopeIsThatOfTheTriangle()
    {
        QFETCH(double, rise);
        show(12, [rise](double x, double) { return rise * (x - 0.5); });
        mStyle.overlay = GroundOverlay::Slope;
        setStyle();
        const double degrees = std::atan(std::abs(rise)) * 180 / std::numbers::pi;
        const QColor expected = shaded(colorAt(SequentialColors, {0, 60}, degrees), rise, mStyle);
        const QColor seen = seenAt(picture(), 0.5, 0.4);
        QVERIFY2(distanceOf(seen, expected) <= 4, qPrintable(told(seen, expected)));
    }

    void layersHaveHumidityAndThickness()
    {
        show(21, [](double, double) { return 0.0; });
        mDocument->setMaterials({material(MaterialPreset::DrySand)});
        mDocument->edit([](TinEdit &edit) {
            edit.addLayer(0, 0);
            for (VertexId v = 0; v < edit.tin().arrays().vertexSlots(); ++v) {
                const double x = edit.tin().arrays().points[v].x;
                edit.setLayer(v, 0, {0.2 * x, float(0.1 + 0.8 * x)});
            }
        });
        mStyle.overlay = GroundOverlay::Humidity;
        setStyle();
        QImage image = picture();
        for (const double x : {0.2, 0.5, 0.8}) {
            const QColor expected = shaded(colorAt(SequentialColors, {0, 100}, 10 + 80 * x), 0, mStyle);
            QVERIFY2(distanceOf(seenAt(image, x, 0.5), expected) <= 6,
                     qPrintable(told(seenAt(image, x, 0.5), expected)));
        }
        mStyle.overlay = GroundOverlay::Thickness;
        setStyle();
        image = picture();
        for (const double x : {0.2, 0.5, 0.8}) {
            const QColor expected = shaded(colorAt(SequentialColors, {0, 0.2}, 0.2 * x), 0, mStyle);
            QVERIFY2(distanceOf(seenAt(image, x, 0.5), expected) <= 6,
                     qPrintable(told(seenAt(image, x, 0.5), expected)));
        }
        mStyle.thicknessLayer = 3; // there is none
        setStyle();
        QVERIFY(distanceOf(seenAt(picture(), 0.8, 0.5), QColor(SequentialColors[0])) <= 4);
    }

    void cutAndFillComparesWithAMoment()
    {
        show(41, [](double, double) { return 0.0; });
        mStyle.overlay = GroundOverlay::CutAndFill;
        setStyle();
        const QColor middle(DivergingColors[4]);
        QVERIFY(distanceOf(seenAt(picture(), 0.25, 0.5), middle) <= 4);
        mViewport->setReference(mDocument->snapshot());
        mDocument->edit([](TinEdit &edit) {
            for (VertexId v = 0; v < edit.tin().arrays().vertexSlots(); ++v) {
                const double x = edit.tin().arrays().points[v].x;
                if (x < 0.4)
                    edit.setHeight(v, -0.1);
                else if (x > 0.6)
                    edit.setHeight(v, 0.05);
            }
        });
        QTRY_VERIFY(!mViewport->isLoading());
        // A vertex that was not there then, in the midst of what was cut.
        mDocument->edit([](TinEdit &edit) { edit.insert({0.2, 0.503}); });
        const QImage image = picture();
        const QColor cut(DivergingColors[0]), filled(DivergingColors[6]);
        QVERIFY2(distanceOf(seenAt(image, 0.2, 0.5), cut) <= 4, qPrintable(told(seenAt(image, 0.2, 0.5), cut)));
        QVERIFY2(distanceOf(seenAt(image, 0.8, 0.5), filled) <= 4, qPrintable(told(seenAt(image, 0.8, 0.5), filled)));
        QVERIFY(distanceOf(seenAt(image, 0.5, 0.5), middle) <= 12);
    }

    void contoursLieAtWholeMultiples()
    {
        show(12, [](double x, double) { return 7 + 0.5 * x; });
        const QImage without = picture();
        mStyle.hasContours = true;
        mStyle.contourInterval = 0.1;
        setStyle();
        const QImage with = picture();
        for (int i = 1; i < 5; ++i) { // 7.1, 7.2 ... at 0.2, 0.4 ...
            const double on = 0.2 * i, between = on + 0.1;
            QVERIFY(seenAt(with, on, 0.5).lightness() < seenAt(without, on, 0.5).lightness() - 20);
            if (between < 1)
                QVERIFY(distanceOf(seenAt(with, between, 0.5), seenAt(without, between, 0.5)) <= 2);
        }
    }

    void constrainedEdgesAreRedOrTheirOwners()
    {
        show(3, [](double, double) { return 0.0; });
        mDocument->edit([](TinEdit &edit) {
            for (const OwnerId owner : {5u, 6u}) {
                const double y = owner == 5 ? 0.3 : 0.7;
                const VertexId a = edit.insert({0.2, y}), b = edit.insert({0.8, y});
                QVERIFY(edit.constrain(a, b, owner, Crossing::Split));
            }
        });
        QVERIFY(distanceOf(seenAt(picture(), 0.35, 0.3), QColor(ConstraintColor)) > 40);
        mStyle.edges = GroundEdges::Constrained;
        setStyle();
        for (const double y : {0.3, 0.7})
            QVERIFY(distanceOf(seenAt(picture(), 0.35, y), QColor(ConstraintColor)) < 40);
        mStyle.edges = GroundEdges::ConstrainedByOwner;
        setStyle();
        QVERIFY(distanceOf(seenAt(picture(), 0.35, 0.3), QColor(ownerColor(5))) < 40);
        QVERIFY(distanceOf(seenAt(picture(), 0.35, 0.7), QColor(ownerColor(6))) < 40);
        QVERIFY(distanceOf(QColor(ownerColor(5)), QColor(ownerColor(6))) > 60);
    }

    void wireframeAndActiveTrianglesShow()
    {
        show(6, [](double, double) { return 0.0; });
        const TinArrays &tin = mDocument->tin().arrays();
        const TriangleId t = mDocument->tin().triangleAt({0.41, 0.52});
        Point2 middle, edge;
        for (std::uint32_t i = 0; i < 3; ++i) {
            const Point2 p = tin.pointAt(cornerOf(t, i));
            middle.x += p.x / 3;
            middle.y += p.y / 3;
            if (i > 0) {
                edge.x += p.x / 2;
                edge.y += p.y / 2;
            }
        }
        const QImage plain = picture();
        mStyle.hasWireframe = true;
        setStyle();
        const QImage wired = picture();
        QVERIFY(darkestAt(wired, edge.x, edge.y) < darkestAt(plain, edge.x, edge.y) - 30);
        QVERIFY(distanceOf(seenAt(wired, middle.x, middle.y), seenAt(plain, middle.x, middle.y)) <= 2);
        mStyle.hasWireframe = false;
        mStyle.hasActiveTriangles = true;
        setStyle();
        mViewport->setActiveTriangles({t});
        const QColor active = seenAt(picture(), middle.x, middle.y);
        QVERIFY(active.red() - active.blue() > 80);
        QVERIFY(active.green() < seenAt(plain, middle.x, middle.y).green() - 20);
        mViewport->setActiveTriangles({});
        QVERIFY(distanceOf(seenAt(picture(), middle.x, middle.y), seenAt(plain, middle.x, middle.y)) <= 2);
    }

    void steeperFromTheSunIsDarker()
    {
        int last = 256;
        for (const double rise : {0.3, 0.0, -0.3, -0.6}) { // the sun stands in the west
            show(6, [rise](double x, double) { return rise * (x - 0.5); });
            mStyle.sunAzimuth = 270;
            setStyle();
            const int now = seenAt(picture(), 0.5, 0.5).lightness();
            QVERIFY2(now < last - 5, qPrintable(QString("%1: %2 after %3").arg(rise).arg(now).arg(last)));
            last = now;
        }
        show(6, [](double x, double) { return 0.5 * (x - 0.5); });
        mStyle.sunAzimuth = 270;
        setStyle();
        const int towards = seenAt(picture(), 0.5, 0.5).lightness(); // rises to the east: faces west
        mStyle.sunAzimuth = 90;
        setStyle();
        QVERIFY(seenAt(picture(), 0.5, 0.5).lightness() < towards - 30);
    }

    void ridgeThrowsAShadowOfItsLength()
    {
        show(101, [](double x, double) { return std::max(0.0, 0.12 - std::abs(x - 0.3) * 6); });
        mStyle.quality = GroundQuality::Medium;
        mStyle.sunAzimuth = 270;
        mStyle.sunElevation = 30;
        setStyle();
        const QImage image = picture();
        const double length = 0.12 / std::tan(std::numbers::pi / 6); // from the crest at 0.3
        const int dark = seenAt(image, 0.3 + 0.7 * length, 0.5).lightness();
        const int lit = seenAt(image, 0.3 + 1.7 * length, 0.5).lightness();
        QVERIFY2(dark < lit - 40, qPrintable(QString("%1 %2").arg(dark).arg(lit)));
        QVERIFY(std::abs(seenAt(image, 0.1, 0.5).lightness() - lit) < 40); // in front of it there is none
    }

    void shadowsFollowAnEdit()
    {
        show(101, [](double, double) { return 0.0; });
        mStyle.quality = GroundQuality::Medium;
        mStyle.sunAzimuth = 270;
        mStyle.sunElevation = 30;
        setStyle();
        const int lit = seenAt(picture(), 0.42, 0.5).lightness();
        Edit edit = mDocument->edit([](TinEdit &open) {
            for (VertexId v = 0; v < open.tin().arrays().vertexSlots(); ++v)
                if (std::abs(open.tin().arrays().points[v].x - 0.3) < 0.012)
                    open.setHeight(v, 0.12);
        });
        picture();
        QTRY_VERIFY(seenAt(picture(), 0.42, 0.5).lightness() < lit - 40);
        mDocument->swap(edit);
        picture();
        QTRY_VERIFY(std::abs(seenAt(picture(), 0.42, 0.5).lightness() - lit) <= 2);
        // What was drawn in part is what would be drawn at once.
        const QImage part = picture();
        mViewport->setCamera(mViewport->camera());
        QCOMPARE(picture(), part);
    }

    void looksDifferAndNoneIsOfOneColour()
    {
        show(60, tests::dunes);
        std::vector<QImage> images;
        for (const GroundLook look : {GroundLook::Sand, GroundLook::Reference})
            for (const GroundQuality quality : {GroundQuality::Low, GroundQuality::Medium, GroundQuality::High}) {
                mStyle.look = look;
                mStyle.quality = quality;
                setStyle();
                images.push_back(mViewport->renderPicture({300, 300}));
                std::set<QRgb> colours;
                for (int y = 80; y < 220; ++y)
                    for (int x = 80; x < 220; ++x)
                        colours.insert(images.back().pixel(x, y));
                QVERIFY2(colours.size() > 200, qPrintable(QString::number(colours.size())));
            }
        QVERIFY(images[0] != images[1] && images[1] != images[2] && images[2] != images[5]);
    }

    void legendHasUnitsAndTheUsersNumbers()
    {
        show(6, [](double, double) { return 0.0; });
        const QLocale before;
        QLocale::setDefault(QLocale(QLocale::Czech));
        mStyle.overlay = GroundOverlay::CutAndFill;
        const ColorScale scale = groundScale(mStyle, {-0.25, 0.25}, mDocument->terrain());
        QLocale::setDefault(before);
        QCOMPARE(scale.ticks, QStringList({"-0,250", "-0,125", "0,000", "+0,125", "+0,250"}));
        QCOMPARE(scale.notes, QStringList{"metres"});
        QVERIFY(!scale.title.isEmpty());
        const QImage without = picture();
        mStyle.hasLegend = true;
        mStyle.overlay = GroundOverlay::None;
        setStyle();
        QCOMPARE(picture(), without);
        mStyle.overlay = GroundOverlay::Slope;
        setStyle();
        QVERIFY(picture().pixelColor(405, 25) != without.pixelColor(405, 25));
    }
};

SANDREEL_TEST(TestTerrainOverlays)
#include "tst_terrainoverlays.moc"
