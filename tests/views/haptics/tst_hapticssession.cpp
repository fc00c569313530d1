// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/testmain.h"
#include "tests/views/haptics/devicebench.h"
#include "views/haptics/handonground.h"
#include "views/sculpt/toolvalues.h"

#include <QSignalSpy>
#include <QThread>
#include <QUndoStack>

using namespace model::haptics;
using tests::DeviceBench;
using tests::PlanView;

class TestHapticsSession final : public QObject
{
    Q_OBJECT

    static double lengthOf(model::Vec3d v) { return std::sqrt(model::dot(v, v)); }

    /// In the air for four seconds, then below the ground for one, again and again: whenever forces come up late on a
    /// busy machine, there is another time.
    static std::unique_ptr<SimulatedDevice> dippingDevice(double depth)
    {
        std::vector<Trajectory::Point> points;
        for (int i = 0; i < 40; ++i)
            for (const auto &[at, z] : {std::pair(0.0, 0.02), std::pair(4.0, 0.02), std::pair(4.3, -depth),
                                        std::pair(5.3, -depth), std::pair(5.6, 0.02)})
                points.push_back({6.0 * i + at, {0, 0, z}, 0});
        auto device = std::make_unique<SimulatedDevice>();
        device->follow(Trajectory(std::move(points)));
        return device;
    }

private slots:
    void aPressOfTheButtonIsOneStep()
    {
        DeviceBench bench;
        const std::uint64_t before = bench.document.fingerprint();
        bench.chooseSimulated();
        const double middle = bench.document.tin().heightAt({0.5, 0.5});
        const double beside = bench.document.tin().heightAt({0.5, 0.1});
        bench.stroke(0.5);
        QCOMPARE(bench.context.undoStack().count(), 1);
        QCOMPARE(bench.context.undoStack().text(0), views::titleOf(bench.settings.tool()));
        QVERIFY(bench.document.tin().heightAt({0.5, 0.5}) < middle - 1e-4);
        QCOMPARE(bench.document.tin().heightAt({0.5, 0.1}), beside);
        bench.stroke(0.8);
        QCOMPARE(bench.context.undoStack().count(), 2);
        bench.context.undoStack().undo();
        bench.context.undoStack().undo();
        QCOMPARE(bench.document.fingerprint(), before);
    }

    void pressesHarderWhereItIsDeeper()
    {
        const auto dug = [](double depth) {
            DeviceBench bench;
            bench.chooseSimulated();
            const double before = bench.document.tin().heightAt({0.5, 0.5});
            bench.moveTo({0.5, 0.5}, -depth, true);
            bench.moveTo({0.5, 0.5}, 0.05, false);
            return before - bench.document.tin().heightAt({0.5, 0.5});
        };
        const double light = dug(0.005), hard = dug(0.04);
        QVERIFY(light > 0);
        QVERIFY(hard > 2 * light);
    }

    void aPressWhileTheWindowIsBusyIsNotLost()
    {
        DeviceBench bench;
        auto device = std::make_unique<SimulatedDevice>();
        device->follow(Trajectory({{0, {0, 0, 0}, 0}, {0.1, {0, 0, 0}, 1}, {0.2, {0, 0, 0}, 0}}));
        bench.session.chooseSimulated(std::move(device));
        QThread::msleep(600); // on purpose: no event is handled meanwhile
        QTRY_COMPARE(bench.context.undoStack().count(), 1);
        QVERIFY(!bench.session.isStroking());
    }

    void aButtonThatIsDownWhenTheDeviceIsChosenDoesNothing()
    {
        DeviceBench bench;
        auto device = std::make_unique<SimulatedDevice>();
        device->moveTo({0, 0, 0}, 1);
        bench.session.chooseSimulated(std::move(device));
        QTRY_VERIFY(bench.session.now().reading.buttons == 1);
        QVERIFY(!bench.session.isStroking());
        bench.chooseSimulated(); // the same one: nothing happens but that it is let go
        bench.moveTo({0.5, 0.5}, 0, true);
        QTRY_VERIFY(bench.session.isStroking());
    }

    void unplugEndsTheStrokeAndTheForces()
    {
        DeviceBench bench;
        bench.chooseSimulated();
        bench.session.setForces(true);
        QSignalSpy forces(&bench.session, &views::HapticsSession::forcesChanged);
        bench.moveTo({0.4, 0.5}, -0.02, true);
        bench.moveTo({0.5, 0.5}, -0.02, true);
        QVERIFY(bench.session.isStroking());
        bench.session.service().simulated()->setConnected(false);
        QTRY_VERIFY(!bench.strokes.isDrawing());
        QVERIFY(!bench.session.isStroking());
        QCOMPARE(bench.context.undoStack().count(), 1); // what was drawn stays
        QVERIFY(!bench.session.wantsForces());
        QCOMPARE(forces.size(), 1);
        QTRY_VERIFY(lengthOf(bench.session.now().force) == 0);
        QCOMPARE(bench.session.service().simulated()->lastForce(), model::Vec3d());

        // Plugged in again with the button still down: only the next press counts, and forces stay off.
        bench.session.service().simulated()->setConnected(true);
        bench.moveTo({0.6, 0.5}, -0.02, true);
        QVERIFY(!bench.session.isStroking());
        bench.moveTo({0.6, 0.5}, 0.02, false);
        bench.moveTo({0.6, 0.5}, -0.02, true);
        QVERIFY(bench.session.isStroking());
        QVERIFY(!bench.session.wantsForces());
    }

    void undoInTheMidstTakesAllAndWaitsForTheNextPress()
    {
        DeviceBench bench;
        const std::uint64_t before = bench.document.fingerprint();
        bench.chooseSimulated();
        bench.moveTo({0.4, 0.5}, -0.02, true);
        bench.moveTo({0.5, 0.5}, -0.02, true);
        bench.context.undoStack().undo();
        QCOMPARE(bench.document.fingerprint(), before);
        bench.moveTo({0.6, 0.5}, -0.02, true);
        QCOMPARE(bench.document.fingerprint(), before);
        QVERIFY(!bench.session.isStroking());
    }

    void theMouseDoesNotDrawIntoTheStrokeOfTheDevice()
    {
        DeviceBench bench;
        bench.view.show();
        bench.chooseSimulated();
        bench.moveTo({0.4, 0.5}, -0.02, true);
        const double far = bench.document.tin().heightAt({0.8, 0.2});
        QTest::mousePress(&bench.view, Qt::LeftButton, {}, PlanView::placeOf({0.8, 0.2}).toPoint());
        QTest::mouseRelease(&bench.view, Qt::LeftButton, {}, PlanView::placeOf({0.8, 0.2}).toPoint());
        QVERIFY(bench.session.isStroking());
        bench.moveTo({0.5, 0.5}, 0.05, false);
        QCOMPARE(bench.document.tin().heightAt({0.8, 0.2}), far);
        QCOMPARE(bench.context.undoStack().count(), 1);
    }

    void anotherTerrainEndsTheStroke()
    {
        DeviceBench bench;
        bench.chooseSimulated();
        bench.session.setForces(true);
        bench.moveTo({0.4, 0.5}, -0.02, true);
        bench.session.setTerrain(nullptr, nullptr);
        QVERIFY(!bench.strokes.isDrawing());
        QCOMPARE(bench.context.undoStack().count(), 1);
        QVERIFY(!bench.session.wantsForces());
        bench.session.setForces(true); // of what ground?
        QVERIFY(!bench.session.wantsForces());
    }

    void forcesAreOffUntilAskedForAndForEachDevice()
    {
        DeviceBench bench;
        bench.session.setForces(true);
        QVERIFY(!bench.session.wantsForces()); // without a device
        bench.chooseSimulated();
        QVERIFY(!bench.session.wantsForces());
        bench.session.setForces(true);
        QVERIFY(bench.session.wantsForces());
        bench.session.choose({});
        QVERIFY(!bench.session.wantsForces());
        bench.chooseSimulated();
        QVERIFY(!bench.session.wantsForces());
    }

    void theGroundPushesBackUntilStop()
    {
        DeviceBench bench;
        bench.session.chooseSimulated(dippingDevice(0.015));
        QTest::qWait(200);
        QCOMPARE(lengthOf(bench.session.now().force), 0.0);
        bench.session.setForces(true);
        QTRY_VERIFY_WITH_TIMEOUT(bench.session.now().force.z > 0.2, 120'000);
        QVERIFY(bench.session.now().depth > 0);
        bench.session.setForces(false);
        QTRY_COMPARE(lengthOf(bench.session.now().force), 0.0);
        QCOMPARE(bench.session.now().state, SafetyState::Stopped);
        QCOMPARE(bench.session.now().cause, SafetyCause::Stopped);
    }

    void theServoFeelsWhatTheDocumentShows()
    {
        DeviceBench bench;
        model::terrain::Tool tool = bench.settings.tool();
        views::setRadius(tool, 0.01); // few enough triangles to be handed over as they are
        bench.settings.setTool(tool);
        bench.chooseSimulated();
        bench.moveTo({0.5, 0.5}, 0, false);
        const double ground = bench.document.tin().heightAt({0.5, 0.5});
        QTRY_VERIFY(std::abs(bench.session.now().depth) < 1e-5);
        bench.context.beginGesture(QStringLiteral("Raise"));
        bench.context.edit([](model::terrain::TinEdit &edit) {
            for (model::terrain::VertexId v = 0; v < edit.tin().vertexCount(); ++v)
                edit.setHeight(v, edit.tin().arrays().heights[v] + 0.05);
        });
        bench.context.endGesture();
        const double risen = bench.document.tin().heightAt({0.5, 0.5}) - ground;
        QVERIFY(risen > 0.04);
        const double scale = bench.session.service().settings().workspace.scale;
        QTRY_VERIFY(std::abs(bench.session.now().depth - risen / scale) < 1e-5);
    }

    void theWholeTerrainIsInReach()
    {
        DeviceBench bench;
        bench.chooseSimulated();
        const Workspace &workspace = bench.session.service().settings().workspace;
        const Capabilities &device = *bench.session.service().capabilities();
        const model::terrain::Point3 low = workspace.toTerrain(device.low), high = workspace.toTerrain(device.high);
        QVERIFY(low.x <= 1e-12 && low.y <= 1e-12 && high.x >= 1 - 1e-12 && high.y >= 1 - 1e-12);
        // The ring goes with the tool, within what a hand can feel.
        model::terrain::Tool tool = bench.settings.tool();
        views::setRadius(tool, 0.02);
        bench.settings.setTool(tool);
        QCOMPARE(bench.session.service().settings().workspace.toolRadius, 0.02);
        views::setRadius(tool, 0.4);
        bench.settings.setTool(tool);
        QVERIFY(bench.session.service().settings().workspace.toolRadius < 0.1);
    }

    void feelIsHandedOn()
    {
        DeviceBench bench;
        bench.chooseSimulated();
        views::FeelSettings feel;
        feel.law = LawKind::Reference2009;
        feel.gain = 1.5;
        feel.maxForce = 2;
        feel.material = model::terrain::MaterialPreset::Mud;
        bench.session.setFeel(feel);
        const ServoSettings &settings = bench.session.service().settings();
        QCOMPARE(settings.law, LawKind::Reference2009);
        QCOMPARE(settings.gain, 1.5);
        QCOMPARE(settings.limits.userForce, 2.0);
        const model::terrain::Material mud = model::terrain::material(model::terrain::MaterialPreset::Mud);
        QVERIFY(settings.overridesFeel && settings.feel == feelOf(mud, mud.humidity));
        feel.material.reset();
        bench.session.setFeel(feel);
        QVERIFY(!bench.session.service().settings().overridesFeel);
    }

    void devicesComeAndGo()
    {
        DeviceBench bench;
        QCOMPARE(bench.session.finder().devices().size(), std::size_t(1));
        bench.session.finder().setWatching(true);
        bench.system->setDevices({tests::spaceNavigator()});
        QTRY_COMPARE(bench.session.finder().devices().size(), std::size_t(2));
        QCOMPARE(bench.session.finder().devices()[1].name, std::string("SpaceNavigator"));
        bench.system->setDevices({});
        QTRY_COMPARE(bench.session.finder().devices().size(), std::size_t(1));
    }

    void aDeviceThatCannotBeOpenedIsSaidSo()
    {
        DeviceBench bench;
        bench.system->setDevices({tests::spaceNavigator()});
        bench.session.finder().setWatching(true);
        QTRY_COMPARE(bench.session.finder().devices().size(), std::size_t(2));
        QSignalSpy refused(&bench.session, &views::HapticsSession::refused);
        bench.session.choose(QString::fromStdString(bench.session.finder().devices()[1].id));
        QCOMPARE(refused.size(), 1);
        QVERIFY(!refused[0][0].toString().isEmpty());
        QCOMPARE(bench.session.chosen(), QString());
    }

    void theHandGoesWithTheMouseAndTheWheel()
    {
        DeviceBench bench;
        bench.chooseSimulated();
        views::HandOnGround hand(bench.session);
        bench.view.setInteraction(&hand);
        bench.view.show();
        const auto moveTo = [&](model::terrain::Point2 p) {
            const QPointF place = PlanView::placeOf(p);
            QMouseEvent event(QEvent::MouseMove, place, bench.view.mapToGlobal(place), Qt::NoButton, Qt::NoButton,
                              Qt::NoModifier);
            QCoreApplication::sendEvent(&bench.view, &event);
        };
        const auto aboveGround = [&] {
            const model::terrain::Point3 tool = bench.session.toolPlace();
            return tool.z - bench.document.tin().heightAt({tool.x, tool.y});
        };
        moveTo({0.25, 0.75});
        const double scale = bench.session.service().settings().workspace.scale;
        QTRY_VERIFY(std::abs(bench.session.toolPlace().x - 0.25) < 1e-6);
        QVERIFY(std::abs(bench.session.toolPlace().y - 0.75) < 1e-6);
        QVERIFY(std::abs(aboveGround() - hand.height() * scale) < 1e-6);

        const QPointF place = PlanView::placeOf({0.25, 0.75});
        for (int i = 0; i < 10; ++i) {
            QWheelEvent wheel(place, bench.view.mapToGlobal(place), {}, {0, -120}, Qt::NoButton, Qt::NoModifier,
                              Qt::NoScrollPhase, false);
            QCoreApplication::sendEvent(&bench.view, &wheel);
        }
        QVERIFY(hand.height() < 0);
        QTRY_VERIFY(bench.session.now().depth > 0);
        QTest::keyClick(&bench.view, Qt::Key_PageUp);
        QVERIFY(std::abs(hand.height() - (-0.008)) < 1e-9);

        QTest::mousePress(&bench.view, Qt::LeftButton, {}, place.toPoint());
        QTRY_VERIFY(bench.session.isStroking());
        moveTo({0.5, 0.75});
        QTRY_VERIFY(std::abs(bench.session.toolPlace().x - 0.5) < 1e-6);
        QTest::mouseRelease(&bench.view, Qt::LeftButton, {}, PlanView::placeOf({0.5, 0.75}).toPoint());
        QTRY_VERIFY(!bench.strokes.isDrawing() && !bench.session.isStroking());
        QCOMPARE(bench.context.undoStack().count(), 1);

        // Escape calls the stroke off.
        QTest::mousePress(&bench.view, Qt::LeftButton, {}, place.toPoint());
        QTRY_VERIFY(bench.session.isStroking());
        QTest::keyClick(&bench.view, Qt::Key_Escape);
        QVERIFY(!bench.strokes.isDrawing());
        QCOMPARE(bench.context.undoStack().count(), 1);
        bench.view.setInteraction(nullptr);
    }
};

SANDREEL_TEST(TestHapticsSession)
#include "tst_hapticssession.moc"
