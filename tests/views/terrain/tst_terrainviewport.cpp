// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/terrain/tools/stroke.h"
#include "tests/support/testmain.h"
#include "tests/views/terrain/groundshapes.h"
#include "tests/views/terrain/settled.h"
#include "views/terrain/terrainviewport.h"
#include "views/viewport/glsupport.h"

#include <QApplication>
#include <QPointingDevice>
#include <QTabletEvent>
#include <QWheelEvent>

#include <set>

using namespace model::terrain;
using namespace views;

namespace {

struct Call
{
    QString name;
    std::optional<GroundEvent> event;
};

/// Writes down what it is told.
class Recorder final : public GroundInteraction
{
public:
    bool isActive() const override { return active; }
    bool press(const GroundEvent &event) override { return note("press", event), takes; }
    void move(const GroundEvent &event) override { note("move", event); }
    void release(const GroundEvent &event) override { note("release", event); }
    void cancel() override { calls.push_back({"cancel", {}}); }
    void hover(const GroundEvent &event) override { note("hover", event); }
    void leave() override { calls.push_back({"leave", {}}); }
    bool wheel(const GroundEvent &event, double notches) override { return note("wheel", event), notches > 0; }
    std::vector<GroundLine> lines() const override { return outline; }

    QStringList names() const
    {
        QStringList result;
        for (const Call &call : calls)
            result += call.name;
        return result;
    }
    const GroundEvent &last(const char *name) const
    {
        for (auto call = calls.rbegin(); call != calls.rend(); ++call)
            if (call->name == name)
                return *call->event;
        qFatal("no %s", name);
    }

    bool active = true, takes = true;
    std::vector<Call> calls;
    std::vector<GroundLine> outline;

private:
    void note(const char *name, const GroundEvent &event) { calls.push_back({name, event}); }
};

void send(QWidget &widget, QEvent::Type type, QPointF place, Qt::MouseButton button, Qt::MouseButtons buttons,
          Qt::KeyboardModifiers modifiers = {})
{
    QMouseEvent event(type, place, widget.mapToGlobal(place), button, buttons, modifiers);
    QApplication::sendEvent(&widget, &event);
}

int coloursOf(const QImage &image)
{
    std::set<QRgb> colours;
    for (int y = 0; y < image.height(); y += 3)
        for (int x = 0; x < image.width(); x += 3)
            colours.insert(image.pixel(x, y));
    return int(colours.size());
}

bool isGround(QColor color)
{
    return color.red() > color.blue() + 12;
}

/// From straight above, north up: a metre is as long everywhere on level ground.
model::OrbitCamera fromAbove()
{
    model::OrbitCamera camera;
    camera.target = {0, 0, 0};
    camera.yaw = 0;
    camera.pitch = 1.5707963f;
    camera.distance = 1.6f;
    return camera;
}

} // namespace

class TestTerrainViewport final : public QObject
{
    Q_OBJECT

private:
    std::unique_ptr<model::TerrainDocument> mDocument;
    std::unique_ptr<Recorder> mRecorder;
    std::unique_ptr<TerrainViewport> mViewport;

    void show(std::unique_ptr<model::TerrainDocument> document)
    {
        mViewport.reset();
        mDocument = std::move(document);
        mViewport = std::make_unique<TerrainViewport>(*mDocument);
        mViewport->resize(320, 240);
        mViewport->show();
        QVERIFY(QTest::qWaitForWindowExposed(mViewport.get()));
        QTRY_VERIFY_WITH_TIMEOUT(!mViewport->isLoading(), 60000);
    }
    QImage picture() { return tests::settled(*mViewport); }
    /// Without shadows, which follow an edit a moment later.
    void drawPlainly()
    {
        TerrainStyle style = mViewport->style();
        style.quality = GroundQuality::Low;
        mViewport->setStyle(style);
    }

private slots:
    void initTestCase() { QVERIFY2(glSupport().isSufficient, "these tests need a display with OpenGL 3.3"); }
    void init()
    {
        show(tests::groundDocument(tests::UnitSquare, 40, tests::dunes));
        mRecorder = std::make_unique<Recorder>();
    }
    void cleanup()
    {
        mViewport.reset();
        mRecorder.reset();
        mDocument.reset();
    }

    void groundIsInTheMiddleBeforeTheBackground()
    {
        const QImage image = picture();
        QVERIFY(coloursOf(image) > 100);
        QVERIFY(isGround(image.pixelColor(160, 130)));
        for (const QPoint corner : {QPoint(4, 4), QPoint(315, 4), QPoint(4, 235)})
            QVERIFY(!isGround(image.pixelColor(corner)));
    }

    void pickAndPlaceAreInverse()
    {
        const QImage image = picture();
        int picked = 0;
        for (int y = 5; y < 240; y += 23)
            for (int x = 5; x < 320; x += 31) {
                const auto point = mViewport->pick(QPointF(x, y));
                bool isInside = true, isOutside = true; // not at the terrain's outline, that is
                for (int k = 0; k < 9; ++k) {
                    const bool ground = isGround(image.pixelColor(x - 2 + 2 * (k % 3), y - 2 + 2 * (k / 3)));
                    isInside = isInside && ground;
                    isOutside = isOutside && !ground;
                }
                QVERIFY2(!(isInside && !point) && !(isOutside && point), qPrintable(QString("%1, %2").arg(x).arg(y)));
                if (!point)
                    continue;
                ++picked;
                QVERIFY(std::abs(point->z - mDocument->tin().heightAt({point->x, point->y})) < 1e-9);
                const auto place = mViewport->placeOf(*point);
                QVERIFY(place && std::hypot(place->x() - x, place->y() - y) < 0.01);
            }
        QVERIFY(picked > 10);
    }

    void eastIsRightAndNorthIsUpFromAbove()
    {
        mViewport->setCamera(fromAbove());
        const auto middle = mViewport->pick({160, 120});
        const auto right = mViewport->pick({200, 120}), up = mViewport->pick({160, 80});
        QVERIFY(middle && right && up);
        QVERIFY(std::abs(middle->x - 0.5) < 0.01 && std::abs(middle->y - 0.5) < 0.01);
        QVERIFY(right->x > middle->x + 0.1 && std::abs(right->y - middle->y) < 0.02);
        QVERIFY(up->y > middle->y + 0.1 && std::abs(up->x - middle->x) < 0.02);
    }

    void editUploadsWhatItWroteAndShows()
    {
        drawPlainly();
        const QImage before = picture();
        const std::uint64_t sent = mViewport->uploadCount().total;
        const VertexId v = mDocument->tin().triangleAt({0.5, 0.5});
        const VertexId moved = mDocument->tin().arrays().vertex(cornerOf(v, 0));
        Edit edit = mDocument->edit([&](TinEdit &open) { open.setHeight(moved, 0.3); });
        const QImage after = picture();
        QVERIFY(after != before);
        const std::uint64_t bytes = mViewport->uploadCount().total - sent;
        QVERIFY2(bytes > 0 && bytes < 40 * 24, qPrintable(QString::number(bytes)));
        mDocument->swap(edit);
        QCOMPARE(picture(), before);
        // Nothing changed: nothing is sent.
        const std::uint64_t total = mViewport->uploadCount().total;
        QCOMPARE(picture(), before);
        QCOMPARE(mViewport->uploadCount().total, total);
    }

    void newVerticesAndTrianglesShowAndGoAgain()
    {
        drawPlainly();
        const QImage before = picture();
        std::vector<Edit> edits;
        for (int i = 0; i < 60; ++i)
            edits.push_back(mDocument->edit([i](TinEdit &open) {
                open.insert({0.3 + 0.005 * i, 0.4 + 0.003 * (i % 7)}, 0.25);
            }));
        const QImage during = picture();
        QVERIFY(during != before);
        // A view that was opened now shows the same.
        {
            TerrainViewport other(*mDocument);
            other.resize(320, 240);
            other.show();
            QVERIFY(QTest::qWaitForWindowExposed(&other));
            other.setCamera(mViewport->camera());
            other.setStyle(mViewport->style());
            QCOMPARE(other.renderPicture({300, 200}, mViewport->camera()),
                     mViewport->renderPicture({300, 200}, mViewport->camera()));
        }
        while (!edits.empty()) {
            mDocument->swap(edits.back());
            edits.pop_back();
        }
        QCOMPARE(picture(), before);
    }

    /// After a reload: the same view shows another terrain as one that was made for it, and nothing of the one before.
    void anotherDocumentShowsAsInANewView()
    {
        auto before =
            tests::groundDocument(tests::UnitSquare, 40, [](double x, double y) { return 0.3 * tests::dunes(y, x); });
        const auto after =
            tests::groundDocument({{10, 20}, {13, 22}}, 50, [](double x, double y) { return 7 + tests::dunes(x, y); });
        TerrainViewport kept(*before);
        kept.resize(320, 240);
        kept.show();
        QVERIFY(QTest::qWaitForWindowExposed(&kept));
        TerrainStyle style = mViewport->style();
        style.quality = GroundQuality::Medium;
        kept.setStyle(style);
        kept.setReference(std::make_shared<const Terrain>(before->terrain()));
        (void)tests::settled(kept);
        kept.setDocument(*after);
        before.reset();
        TerrainViewport fresh(*after);
        fresh.resize(320, 240);
        fresh.show();
        QVERIFY(QTest::qWaitForWindowExposed(&fresh));
        fresh.setStyle(style);
        QCOMPARE(kept.camera().target.y, fresh.camera().target.y); // nobody moved it
        const auto same = [&] {
            return kept.renderPicture({300, 200}, fresh.camera()) == fresh.renderPicture({300, 200}, fresh.camera());
        };
        QVERIFY(same());
        const QImage still = kept.renderPicture({300, 200}, fresh.camera());
        after->edit([](TinEdit &edit) { edit.insert({11, 21}, 7.5); });
        QVERIFY(same());
        QVERIFY(kept.renderPicture({300, 200}, fresh.camera()) != still);
        style.overlay = GroundOverlay::CutAndFill; // the reference is gone with the document
        kept.setStyle(style);
        fresh.setStyle(style);
        QVERIFY(same());
        QVERIFY(kept.pick(QPointF(160, 120)).has_value());
    }

    void stampOfAMillionVerticesIsSentIn256KiB()
    {
        // As many vertices under the tool and its rim as a radius of 0.04 has in a unit square of a million.
        show(tests::groundDocument(tests::UnitSquare, 400, [](double x, double y) { return 0.2 * x * y; }));
        mDocument->setMaterials({material(MaterialPreset::DrySand)});
        mDocument->edit([](TinEdit &edit) {
            edit.addLayer(0, 0);
            for (VertexId v = 0; v < edit.tin().arrays().vertexSlots(); ++v)
                edit.setLayer(v, 0, {0.3, 0.1f});
        });
        picture();
        QTRY_VERIFY(!mViewport->isLoading());
        Imprint tool;
        tool.radius = 0.1;
        tool.depth = 0.05;
        ToolMemory memory;
        const std::uint64_t sent = mViewport->uploadCount().total;
        mDocument->edit(
            [&](TinEdit &edit) {
                QVERIFY(draw(edit, Stroke{tool, {{{0.5, 0.5}}}, {}}, 1, memory));
            },
            VolumeRule::Keep);
        picture();
        const std::uint64_t bytes = mViewport->uploadCount().total - sent;
        QVERIFY2(bytes > 50 * 1024 && bytes <= 256 * 1024, qPrintable(QString::number(bytes)));
    }

    void largeTerrainIsAGridWhileTheCameraMoves()
    {
        if (!glSupport().isSoftware)
            QSKIP("only where the processor draws");
        show(tests::groundDocument(tests::UnitSquare, 290, tests::dunes));
        drawPlainly();
        picture();
        mDocument->edit([](TinEdit &edit) { // a hole, to look through
            std::vector<TriangleId> inside;
            for (TriangleId t = 0; t < edit.tin().arrays().triangleSlots(); ++t) {
                const Point2 p = edit.tin().arrays().pointAt(cornerOf(t, 0));
                if (std::hypot(p.x - 0.5, p.y - 0.5) < 0.1)
                    inside.push_back(t);
            }
            edit.setVoid(inside, true);
        });
        mViewport->setCamera(fromAbove());
        QImage moving = mViewport->grabFramebuffer();
        for (int i = 0; i < 500 && isGround(moving.pixelColor(160, 120)); ++i) { // heights come in steps
            model::OrbitCamera camera = fromAbove();
            camera.distance += 1e-5f * float(i);
            mViewport->setCamera(camera);
            moving = mViewport->grabFramebuffer();
        }
        const QImage still = picture();
        QVERIFY(still != moving);
        int different = 0;
        for (int y = 0; y < still.height(); ++y)
            for (int x = 0; x < still.width(); ++x)
                different += std::abs(qRed(still.pixel(x, y)) - qRed(moving.pixel(x, y))) > 12;
        QVERIFY2(different < still.width() * still.height() / 30, qPrintable(QString::number(different)));
        QVERIFY(isGround(moving.pixelColor(160, 60)) && !isGround(moving.pixelColor(160, 120)));
        QVERIFY(!isGround(still.pixelColor(160, 120)));
    }

    void voidsAreNotDrawn()
    {
        mViewport->setCamera(fromAbove());
        QVERIFY(isGround(picture().pixelColor(160, 120)));
        mDocument->edit([](TinEdit &edit) {
            std::vector<TriangleId> inside;
            for (TriangleId t = 0; t < edit.tin().arrays().triangleSlots(); ++t) {
                const Point2 p = edit.tin().arrays().pointAt(cornerOf(t, 0));
                if (std::hypot(p.x - 0.5, p.y - 0.5) < 0.2)
                    inside.push_back(t);
            }
            edit.setVoid(inside, true);
        });
        QVERIFY(!isGround(picture().pixelColor(160, 120)));
        QVERIFY(!mViewport->pick({160, 120}));
    }

    void materialsAndHumidityColourTheGround()
    {
        mViewport->setCamera(fromAbove());
        const QColor sand = picture().pixelColor(160, 120);
        mDocument->setMaterials({material(MaterialPreset::Snow), material(MaterialPreset::DrySand)});
        mDocument->edit([](TinEdit &edit) {
            edit.addLayer(0, 0);
            for (VertexId v = 0; v < edit.tin().arrays().vertexSlots(); ++v)
                edit.setLayer(v, 0, {0.05, 0});
        });
        const QColor snow = picture().pixelColor(160, 120);
        QVERIFY(snow.blue() > sand.blue() + 25);
        mDocument->edit([](TinEdit &edit) {
            for (VertexId v = 0; v < edit.tin().arrays().vertexSlots(); ++v)
                edit.setLayer(v, 0, {0.05, 1});
        });
        QVERIFY(picture().pixelColor(160, 120).lightness() < snow.lightness() - 25);
    }

    void strokeGetsWhatThePointerDoes()
    {
        Recorder &recorder = *mRecorder;
        mViewport->setInteraction(&recorder);
        mViewport->setCamera(fromAbove());
        const model::OrbitCamera camera = mViewport->camera();
        send(*mViewport, QEvent::MouseMove, {160, 120}, Qt::NoButton, Qt::NoButton);
        send(*mViewport, QEvent::MouseButtonPress, {160, 120}, Qt::LeftButton, Qt::LeftButton, Qt::ControlModifier);
        send(*mViewport, QEvent::MouseMove, {200, 120}, Qt::NoButton, Qt::LeftButton);
        send(*mViewport, QEvent::MouseMove, {318, 120}, Qt::NoButton, Qt::LeftButton);
        send(*mViewport, QEvent::MouseButtonRelease, {200, 120}, Qt::LeftButton, Qt::NoButton);
        QCOMPARE(recorder.names(), QStringList({"hover", "press", "move", "move", "release"}));
        QVERIFY(std::abs(recorder.last("press").point.x - 0.5) < 0.01);
        QCOMPARE(recorder.last("press").modifiers, Qt::ControlModifier);
        QCOMPARE(recorder.last("press").pressure, 1.0);
        QVERIFY(recorder.last("release").point.x > 0.6);
        // Past the edge, on the level of the border.
        const GroundEvent &beyond = *recorder.calls[3].event;
        QVERIFY(!beyond.isOnTerrain && beyond.point.x > 1);
        QVERIFY(std::abs(beyond.point.z - nearestHeight(mDocument->tin(), {beyond.point.x, beyond.point.y})) < 1e-6);
        // A metre on the screen: the field of view is 0.7 high.
        const double expected = 2 * 1.6 * std::tan(0.35) / 240;
        QVERIFY(std::abs(recorder.last("press").metresPerPixel / expected - 1) < 0.1);
        QCOMPARE(mViewport->camera().target, camera.target);
        QCOMPARE(mViewport->camera().yaw, camera.yaw);
    }

    void strokeIsCalledOff_data()
    {
        QTest::addColumn<QString>("how");
        for (const char *how : {"right click", "escape", "focus", "taken away"})
            QTest::newRow(how) << QString(how);
    }
    void strokeIsCalledOff()
    {
        QFETCH(QString, how);
        Recorder &recorder = *mRecorder;
        mViewport->setInteraction(&recorder);
        const model::OrbitCamera camera = mViewport->camera();
        send(*mViewport, QEvent::MouseButtonPress, {160, 130}, Qt::LeftButton, Qt::LeftButton);
        if (how == "right click") {
            send(*mViewport, QEvent::MouseButtonPress, {160, 130}, Qt::RightButton, Qt::LeftButton | Qt::RightButton);
            send(*mViewport, QEvent::MouseMove, {190, 150}, Qt::NoButton, Qt::LeftButton | Qt::RightButton);
            send(*mViewport, QEvent::MouseButtonRelease, {190, 150}, Qt::RightButton, Qt::LeftButton);
        } else if (how == "escape") {
            QTest::keyClick(mViewport.get(), Qt::Key_Escape);
        } else if (how == "focus") {
            QFocusEvent away(QEvent::FocusOut, Qt::ActiveWindowFocusReason);
            QApplication::sendEvent(mViewport.get(), &away);
        } else {
            mViewport->setInteraction(nullptr);
        }
        send(*mViewport, QEvent::MouseButtonRelease, {190, 150}, Qt::LeftButton, Qt::NoButton);
        QCOMPARE(recorder.names(), QStringList({"press", "cancel"}));
        QCOMPARE(mViewport->camera().yaw, camera.yaw);
        QCOMPARE(mViewport->camera().distance, camera.distance);
    }

    void cameraMovesWithTheRightButtonWhileAToolIsActive()
    {
        Recorder &recorder = *mRecorder;
        mViewport->setInteraction(&recorder);
        const model::OrbitCamera before = mViewport->camera();
        send(*mViewport, QEvent::MouseButtonPress, {160, 130}, Qt::RightButton, Qt::RightButton);
        send(*mViewport, QEvent::MouseMove, {190, 150}, Qt::NoButton, Qt::RightButton);
        send(*mViewport, QEvent::MouseButtonRelease, {190, 150}, Qt::RightButton, Qt::NoButton);
        QVERIFY(mViewport->camera().yaw != before.yaw);
        QVERIFY(!recorder.names().contains("press"));
        recorder.active = false; // now the left button is the camera's again
        const float yaw = mViewport->camera().yaw;
        send(*mViewport, QEvent::MouseButtonPress, {160, 130}, Qt::LeftButton, Qt::LeftButton);
        send(*mViewport, QEvent::MouseMove, {190, 130}, Qt::NoButton, Qt::LeftButton);
        send(*mViewport, QEvent::MouseButtonRelease, {190, 130}, Qt::LeftButton, Qt::NoButton);
        QVERIFY(mViewport->camera().yaw != yaw);
        QVERIFY(!recorder.names().contains("press"));
    }

    void penTellsPressureAndTilt()
    {
        Recorder &recorder = *mRecorder;
        mViewport->setInteraction(&recorder);
        const QPointingDevice pen(QStringLiteral("pen"), 7, QInputDevice::DeviceType::Stylus,
                                  QPointingDevice::PointerType::Pen, QInputDevice::Capability::Pressure, 1, 2);
        const auto sendPen = [&](QEvent::Type type, double pressure, Qt::MouseButton button, Qt::MouseButtons buttons) {
            const QPointF place(160, 130);
            QTabletEvent event(type, &pen, place, mViewport->mapToGlobal(place), pressure, 20, -10, 0, 0, 0, {}, button,
                               buttons);
            QApplication::sendEvent(mViewport.get(), &event);
            QVERIFY(event.isAccepted());
        };
        sendPen(QEvent::TabletPress, 0.25, Qt::LeftButton, Qt::LeftButton);
        sendPen(QEvent::TabletMove, 0.5, Qt::NoButton, Qt::LeftButton);
        sendPen(QEvent::TabletRelease, 0, Qt::LeftButton, Qt::NoButton);
        QCOMPARE(recorder.names(), QStringList({"press", "move", "release"}));
        QVERIFY(std::abs(recorder.last("press").pressure - 0.25) < 1e-6);
        QVERIFY(std::abs(recorder.last("move").pressure - 0.5) < 1e-6);
        QVERIFY(std::abs(recorder.last("move").xTilt - 20) < 1e-6 && std::abs(recorder.last("move").yTilt + 10) < 1e-6);
        QVERIFY(recorder.last("move").isPen);
    }

    void wheelIsTheToolsOrTheCameras()
    {
        Recorder &recorder = *mRecorder;
        mViewport->setInteraction(&recorder);
        const auto turn = [&](int angle) {
            const QPointF place(160, 130);
            QWheelEvent event(place, mViewport->mapToGlobal(place), {}, {0, angle}, {}, {}, Qt::NoScrollPhase, false);
            QApplication::sendEvent(mViewport.get(), &event);
        };
        const float distance = mViewport->camera().distance;
        turn(120); // taken
        QCOMPARE(mViewport->camera().distance, distance);
        turn(-120);
        QVERIFY(mViewport->camera().distance > distance);
    }

    void linesAreDrapedOnTheGround()
    {
        Recorder &recorder = *mRecorder;
        mViewport->setInteraction(&recorder);
        const QImage before = picture();
        const std::uint64_t sent = mViewport->uploadCount().total;
        recorder.outline = {{{{0.2, 0.5}, {0.8, 0.5}}, false, QColor(0, 255, 0), 3, false}};
        mViewport->updateLines();
        const QImage after = picture();
        for (const double x : {0.25, 0.4, 0.5, 0.63, 0.75}) {
            const Point3 p{x, 0.5, mDocument->tin().heightAt({x, 0.5})};
            const QPoint place = mViewport->placeOf(p)->toPoint();
            const QColor color = after.pixelColor(place);
            QVERIFY2(color.green() > 180 && color.red() < 120, qPrintable(color.name()));
        }
        QVERIFY(after != before);
        QCOMPARE(mViewport->uploadCount().total, sent);
    }
};

SANDREEL_TEST(TestTerrainViewport)
#include "tst_terrainviewport.moc"
