// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/document/terrainrecorder.h"
#include "tests/model/terrain/tin/randomedits.h"
#include "tests/support/testmain.h"

#include <cmath>

using namespace model;
using namespace model::terrain;

namespace {

/// A domain far from the origin, as surveys have them, longer than it is wide.
constexpr Rectangle Domain{{5'000'000, 300'000}, {5'000'004, 300'001}};

std::unique_ptr<TerrainDocument> specimen()
{
    std::vector<Point3> points;
    for (int j = 0; j <= 10; ++j)
        for (int i = 0; i <= 40; ++i)
            points.push_back({Domain.low.x + 0.1 * i, Domain.low.y + 0.1 * j, 700 + 0.1 * std::sin(i) * std::cos(j)});
    return std::make_unique<TerrainDocument>(Terrain(std::move(buildTin(points, Domain)->tin)));
}

void dig(TerrainDocument &document, double x, double depth)
{
    document.edit([&](TinEdit &edit) { edit.insert({Domain.low.x + x, Domain.low.y + 0.43}, 700 - depth); });
}

/// The heights of a recording's places as the terrain has them now.
std::vector<double> heightsOf(const TerrainDocument &document, const FrameSource &frames)
{
    std::vector<double> heights;
    const Point2 middle{(Domain.low.x + Domain.high.x) / 2, (Domain.low.y + Domain.high.y) / 2};
    for (const Vec3f &place : frames.frame(0))
        heights.push_back(document.tin().heightAt({std::clamp(middle.x + place.x, Domain.low.x, Domain.high.x),
                                                   std::clamp(middle.y - place.z, Domain.low.y, Domain.high.y)}));
    return heights;
}

} // namespace

class TestTerrainRecorder final : public QObject
{
    Q_OBJECT

private slots:
    void framesHaveTheHeightsOfTheGround()
    {
        const auto document = specimen();
        const double middle = document->tin().heightAt({Domain.low.x + 2, Domain.low.y + 0.5});
        RecordingLimits limits;
        limits.vertices = 300;
        TerrainRecorder recorder(*document, limits);
        // What the ground is at each frame, found again by another way afterwards.
        std::vector<std::shared_ptr<const Terrain>> moments{document->snapshot()};
        for (int i = 0; i < 6; ++i) {
            dig(*document, 0.3 + 0.55 * i, 0.2 + 0.1 * i);
            recorder.takeFrame();
            moments.push_back(document->snapshot());
        }
        dig(*document, 3.7, 1); // after the last beat
        moments.push_back(document->snapshot());
        const FrameSourcePtr frames = recorder.finish("dug");
        QCOMPARE(frames->frameCount(), 8u);
        QCOMPARE(frames->name(), std::string("dug"));
        QCOMPARE(frames->frameRate(), 25.0);
        QVERIFY(frames->vertexCount() <= 300 && frames->vertexCount() > 200);
        for (std::uint32_t f = 0; f < 8; ++f) {
            const std::vector<double> expected = heightsOf(TerrainDocument(*moments[f]), *frames);
            const std::vector<Vec3f> seen = frames->frame(f);
            for (std::size_t v = 0; v < seen.size(); ++v) {
                QVERIFY(std::abs(double(seen[v].y) - (expected[v] - middle)) < 1e-6);
                QCOMPARE(seen[v].x, frames->frame(0)[v].x);
                QCOMPARE(seen[v].z, frames->frame(0)[v].z);
            }
        }
    }

    void meshCoversTheDomainAndLooksUp()
    {
        const auto document = specimen();
        RecordingLimits limits;
        limits.vertices = 500;
        TerrainRecorder recorder(*document, limits);
        QVERIFY(recorder.columns() > 3 * recorder.rows() && recorder.columns() < 5 * recorder.rows());
        const FrameSourcePtr frames = recorder.finish({});
        double area = 0;
        const std::vector<Vec3f> places = frames->frame(0);
        for (const Triangle &t : frames->connectivity().triangles) {
            const Vec3f a = places[t[1]] - places[t[0]], b = places[t[2]] - places[t[0]];
            const double up = double(a.z) * double(b.x) - double(a.x) * double(b.z);
            QVERIFY(up > 0);
            area += up / 2;
        }
        QVERIFY2(std::abs(area - 4) < 1e-4, qPrintable(QString::number(area)));
    }

    void voidsAreLeftOut()
    {
        const auto document = specimen();
        document->edit([](TinEdit &edit) {
            std::vector<TriangleId> west;
            for (TriangleId t = 0; t < edit.tin().arrays().triangleSlots(); ++t)
                if (edit.tin().arrays().pointAt(cornerOf(t, 0)).x < Domain.low.x + 1)
                    west.push_back(t);
            edit.setVoid(west, true);
        });
        TerrainRecorder recorder(*document, {});
        const FrameSourcePtr frames = recorder.finish({});
        const std::vector<Vec3f> places = frames->frame(0);
        QVERIFY(!frames->connectivity().triangles.empty());
        for (const Triangle &t : frames->connectivity().triangles)
            for (const std::uint32_t v : t)
                QVERIFY(places[v].x > -1.2f);
    }

    void nothingIsTakenWhereNothingHappens()
    {
        const auto document = specimen();
        TerrainRecorder recorder(*document, {});
        recorder.takeFrame();
        document->setMaterials({material(MaterialPreset::DrySand)}); // looks different, is not higher
        recorder.takeFrame();
        QCOMPARE(recorder.frameCount(), 1u);
        dig(*document, 1, 1);
        QTRY_COMPARE(recorder.frameCount(), 2u); // by the beat
        QCOMPARE(recorder.finish({})->frameCount(), 2u);
    }

    void limitEndsIt()
    {
        const auto document = specimen();
        RecordingLimits limits;
        limits.vertices = 100;
        limits.bytes = 3 * 100 * sizeof(float);
        TerrainRecorder recorder(*document, limits);
        QCOMPARE(recorder.frameLimit(), 3u);
        QVERIFY(recorder.byteLimit() <= limits.bytes);
        bool isFull = false;
        connect(&recorder, &TerrainRecorder::limitReached, this, [&] { isFull = true; });
        for (int i = 0; i < 5; ++i) {
            QCOMPARE(isFull, i >= 2);
            dig(*document, 0.5 + 0.6 * i, 1);
            recorder.takeFrame();
        }
        QCOMPARE(recorder.frameCount(), 3u);
        QCOMPARE(recorder.finish({})->frameCount(), 3u);
    }

    void digestTellsRecordingsApart()
    {
        const auto document = specimen();
        const auto recorded = [&](double depth) {
            TerrainRecorder recorder(*document, {});
            Edit edit = document->edit([&](TinEdit &open) { open.setHeight(50, 700 - depth); });
            const FrameSourcePtr frames = recorder.finish({});
            document->swap(edit);
            return frames->digest();
        };
        const std::uint64_t first = recorded(1);
        QCOMPARE(recorded(1), first);
        QVERIFY(recorded(1.5) != first);
    }
};

SANDREEL_TEST(TestTerrainRecorder)
#include "tst_terrainrecorder.moc"
