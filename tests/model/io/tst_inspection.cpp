// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/inspection.h"
#include "model/io/polygonreader.h"
#include "tests/model/io/iotest.h"
#include "tests/support/realdata.h"
#include "tests/support/testmain.h"

#include <QJsonArray>

#include <cmath>

using namespace model;
using namespace model::io;

namespace {

QStringList csvFields(const QString &line)
{
    QStringList fields{QString()};
    bool quoted = false;
    for (const QChar c : line)
        if (c == '"')
            quoted = !quoted;
        else if (c == ',' && !quoted)
            fields << QString();
        else if (c != '\r')
            fields.back() += c;
    return fields;
}

double sum(const QJsonObject &json, const char *list, const char *key)
{
    double total = 0;
    for (const QJsonValue &value : json[QLatin1String(list)].toArray())
        total += value[QLatin1String(key)].toDouble();
    return total;
}

double problemCount(const QJsonObject &json, ProblemKind kind)
{
    return json["problems"][QLatin1String(problemKey(kind))]["count"].toDouble(-1);
}

} // namespace

class TestInspection final : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { SANDREEL_REQUIRE_DATA(); }

    /// The table of an independent script says what each of these files holds.
    void everyMeshHasItsKnownNumbers_data()
    {
        QTest::addColumn<QMap<QString, QString>>("expected");
        const QStringList lines = QString::fromUtf8(tests::contents(tests::dataFolder() + "/meshes/expected.csv"))
                                      .split('\n', Qt::SkipEmptyParts);
        const QStringList names = csvFields(lines.at(0));
        for (qsizetype i = 1; i < lines.size(); ++i) {
            const QStringList fields = csvFields(lines[i]);
            QMap<QString, QString> expected;
            for (qsizetype k = 0; k < names.size(); ++k)
                expected[names[k]] = fields.at(k);
            QTest::newRow(qPrintable(expected["file"])) << expected;
        }
    }
    void everyMeshHasItsKnownNumbers()
    {
        using Expected = QMap<QString, QString>;
        QFETCH(const Expected, expected);
        const auto mesh = readPolygonMesh(tests::dataFolder() + "/meshes/" + expected["file"]);
        QVERIFY(mesh);
        const auto inspection = inspectMesh(mesh->faces, mesh->positions);
        QVERIFY(inspection);
        const QJsonObject json = inspectionJson(*inspection);
        const auto number = [&](const char *name) { return expected[name].toDouble(); };
        QCOMPARE(json["vertices"].toDouble(), number("V"));
        QCOMPARE(json["faces"].toDouble(), number("F"));
        QCOMPARE(json["edges"].toDouble(), number("E"));
        QCOMPARE(json["euler"].toDouble(), number("euler"));
        QCOMPARE(double(json["components"].toArray().size()), number("components_edge"));
        QCOMPARE(sum(json, "components", "faces"), number("F"));
        QCOMPARE(sum(json, "components", "edges"), number("E"));
        QCOMPARE(sum(json, "components", "boundary_edges"), number("boundary_edges"));
        QCOMPARE(sum(json, "components", "boundary_loops"), double(json["holes"].toArray().size()));
        QCOMPARE(problemCount(json, ProblemKind::NonManifoldEdge), number("nonmanifold_edges"));
        QCOMPARE(problemCount(json, ProblemKind::NonManifoldVertex), number("nonmanifold_vertices"));
        QCOMPARE(problemCount(json, ProblemKind::IsolatedVertex), number("isolated_vertices"));
        QCOMPARE(problemCount(json, ProblemKind::DegenerateFace), number("degenerate_faces"));
        QCOMPARE(problemCount(json, ProblemKind::DuplicateFace), number("duplicate_faces"));
        QCOMPARE(problemCount(json, ProblemKind::InconsistentEdge), number("inconsistent_edges"));
        QCOMPARE(json["orientable"].toBool(), expected["orientable"] == "True");
        QCOMPARE(json["manifold"].toBool(), expected["manifold"] == "True");
        if (expected["manifold"] != "True")
            return;
        // At a vertex of several fans, loops that touch are one to the script.
        QCOMPARE(double(json["holes"].toArray().size()), number("boundary_loops"));
        if (expected["orientable"] == "True") {
            QCOMPARE(json["genus"].toDouble(-1), number("genus_total"));
            QCOMPARE(double(json["handles"].toArray().size()), number("genus_total"));
            QCOMPARE(double(inspection->walk.handleSplits.size()), number("genus_total"));
        } else {
            QVERIFY(json["genus"].isNull());
            QCOMPARE("non-orientable genus " + QString::number(json["components"][0]["genus"].toInt()),
                     expected["genus_total"]);
        }
        QCOMPARE(inspection->walk.holes.size() >= std::size_t(number("boundary_loops")), true);
    }

    void knownGeometry()
    {
        const auto jsonOf = [](const char *name) {
            const auto mesh = readPolygonMesh(tests::dataFolder() + "/meshes/" + name);
            InspectionOptions options;
            options.selfIntersections = true;
            return inspectionJson(*inspectMesh(mesh->faces, mesh->positions, options));
        };
        const QJsonObject cube = jsonOf("cube_quad.off");
        QCOMPARE(cube["components"][0]["area"].toDouble(),
                 6 * std::pow(cube["components"][0]["volume"].toDouble(), 2.0 / 3));
        QCOMPARE(problemCount(cube, ProblemKind::SelfIntersection), 0.0);
        const QJsonObject pierced = jsonOf("tetra_intersected_by_triangle.off");
        QVERIFY(problemCount(pierced, ProblemKind::SelfIntersection) > 0);
        QVERIFY(problemCount(jsonOf("quads_to_stitch.off"), ProblemKind::CoincidentVertex) > 0);
        QVERIFY(problemCount(jsonOf("degtri_sliding.off"), ProblemKind::ZeroAreaFace) > 0);
    }
};

SANDREEL_TEST(TestInspection)
#include "tst_inspection.moc"
