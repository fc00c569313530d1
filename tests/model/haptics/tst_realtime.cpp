// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/haptics/device/simulateddevice.h"
#include "model/haptics/servo/periodicthread.h"
#include "model/haptics/servo/samplering.h"
#include "tests/model/haptics/grounds.h"
#include "tests/model/haptics/interposed.h"
#include "tests/support/testmain.h"

#include <mutex>
#include <thread>

using namespace model;
using namespace model::haptics;
using namespace std::chrono_literals;

/// What holds for the thread that must never wait.
class TestRealTime final : public QObject
{
    Q_OBJECT

private slots:
    void theStandInsCount()
    {
        const tests::Interposed before = tests::interposedCalls();
        int *volatile one = new int(1); // volatile: nobody may see that they are not needed
        delete one;
        void *volatile other = std::malloc(10);
        std::free(other);
        std::mutex mutex;
        mutex.lock();
        mutex.unlock();
        QVERIFY(tests::interposedCalls().allocations >= before.allocations + 2);
        QVERIFY(tests::interposedCalls().releases >= before.releases + 2);
#if !defined(__SANITIZE_THREAD__)
        QCOMPARE(tests::interposedCalls().locks, before.locks + 1);
#endif
    }

    /// Through everything that can happen to it: new ground, other settings, faults, every law.
    void stepsNeitherAllocateNorLock()
    {
        SimulatedDevice device;
        device.follow(pressTrajectory());
        device.holdWith({});
        SampleRing ring;
        for (const LawKind law : EveryLaw) {
            tests::VirtualLoop loop(law);
            loop.core.setForces(true);
            const terrain::Terrain ground = tests::groundOf(0.1, [](double x, double y) { return 0.01 * x * y; });
            PatchBuilder builder;
            tests::Interposed used;
            bool hasTouched = false;
            for (int i = 0; i < 9000; ++i) {
                if (i % 20 == 0) {
                    TerrainPatch &patch = loop.core.nextPatch();
                    builder.build(ground, {0, 0}, 0.5, patch);
                    patch.id = std::uint64_t(i) + 100;
                    patch.time = loop.now;
                    if (i < 8000)
                        loop.core.publishPatch();
                }
                if (i % 500 == 0)
                    loop.core.publishSettings(loop.settings);
                device.setConnected(i % 3000 != 2999);
                loop.now += ServoPeriod;
                const tests::Interposed before = tests::interposedCalls();
                const Reading reading = device.read(loop.now);
                const ServoSample sample = loop.core.step(reading, loop.now);
                device.write(sample.force, loop.now);
                ring.push(sample);
                const tests::Interposed after = tests::interposedCalls();
                used.allocations += after.allocations - before.allocations;
                used.releases += after.releases - before.releases;
                used.locks += after.locks - before.locks;
                hasTouched = hasTouched || sample.depth > 0.01;
            }
            QVERIFY(hasTouched);
            QCOMPARE(used.allocations, 0u);
            QCOMPARE(used.releases, 0u);
            QCOMPARE(used.locks, 0u);
        }
    }

    /// The thread itself, sleep and bookkeeping included.
    void theThreadNeitherAllocatesNorLocks()
    {
        tests::Interposed first, last;
        std::atomic<int> steps = 0;
        PeriodicThread thread([&](Time) {
            if (steps == 3)
                first = tests::interposedCalls();
            last = tests::interposedCalls();
            ++steps;
        });
        thread.start();
        QTRY_VERIFY_WITH_TIMEOUT(steps > 100, 20000);
        thread.stop();
        QCOMPARE(last.allocations, first.allocations);
        QCOMPARE(last.releases, first.releases);
        QCOMPARE(last.locks, first.locks);
        const Punctuality punctuality = thread.punctuality();
        QCOMPARE(punctuality.steps, std::uint64_t(steps));
        QCOMPARE(thread.lateness().count(), punctuality.steps);
        QVERIFY(std::abs(punctuality.rate() - 1000) < 1); // of deadlines, whatever became of them
    }

    /// A stroke writes ground as fast as it can while the servo feels it: for ThreadSanitizer, and for torn patches.
    void servoWhileStroking()
    {
        tests::VirtualLoop loop;
        ServoCore core;
        ServoSettings settings = loop.settings;
        core.publishSettings(settings);
        SimulatedDevice device;
        SampleRing ring;
        std::atomic<std::uint64_t> felt = 0, changes = 0;
        PeriodicThread servo([&](Time now) {
            const ServoSample sample = core.step(device.read(now), now);
            device.write(sample.force, now);
            ring.push(sample);
            if (sample.patch != felt.load(std::memory_order_relaxed)) {
                felt.store(sample.patch, std::memory_order_relaxed);
                changes.store(changes.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
            }
        });
        servo.start();
        std::thread stroke([&] {
            terrain::Terrain ground =
                tests::groundOf(0.1, [](double x, double y) { return 0.01 * std::sin(9 * x) * y; });
            PatchBuilder builder;
            for (std::uint64_t i = 1; i <= 300; ++i) {
                TerrainPatch &patch = core.nextPatch();
                builder.build(ground, {0.001 * double(i), 0}, 0.5, patch);
                patch.id = i;
                patch.time = monotonicNow();
                core.publishPatch();
                device.moveTo({0.001 * double(i), 0, -0.001 * double(i % 30)}, 1);
                core.setForces(i % 100 > 10);
                settings.gain = 1 + 0.001 * double(i);
                core.publishSettings(settings);
                std::this_thread::sleep_for(1ms);
            }
        });
        std::vector<ServoSample> samples;
        while (felt < 300) {
            ring.drain(samples);
            std::this_thread::sleep_for(2ms);
        }
        stroke.join();
        servo.stop();
        ring.drain(samples);
        QCOMPARE(ring.lost(), 0u);
        QCOMPARE(samples.size(), servo.punctuality().steps);
        QVERIFY(changes > 20);
        std::uint64_t patch = 0;
        for (const ServoSample &sample : samples) {
            QVERIFY(sample.patch >= patch);
            patch = sample.patch;
            QVERIFY(std::abs(sample.depth) < 0.2);
            QVERIFY(tests::lengthOf(sample.force) <= 10);
        }
    }

    void ringCountsWhatItLoses()
    {
        SampleRing ring;
        ServoSample sample;
        for (std::uint64_t i = 0; i < SampleRing::Capacity + 5; ++i) {
            sample.patch = i;
            ring.push(sample);
        }
        QCOMPARE(ring.lost(), 5u);
        std::vector<ServoSample> samples;
        ring.drain(samples);
        QCOMPARE(samples.size(), SampleRing::Capacity);
        QCOMPARE(samples.back().patch, SampleRing::Capacity - 1);
        ring.push(sample);
        ring.drain(samples);
        QCOMPARE(samples.size(), SampleRing::Capacity + 1);
    }
};

SANDREEL_TEST(TestRealTime)
#include "tst_realtime.moc"
