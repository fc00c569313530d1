// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands.h"
#include "model/io/inspection.h"
#include "model/io/polygonreader.h"

#include <QFileInfo>

#include <optional>

namespace cli {

namespace {

using model::io::Inspection;

/// Rows of a list that a person reads on a terminal; --csv has them all.
constexpr std::size_t MostRows = 20;

struct Inspect
{
    InputOptions input;
    std::optional<std::uint32_t> frame; ///< counted from 1
    std::optional<model::io::InspectionTable> csv;
    bool selfIntersections = false;

    model::Result<void> run(Console &console) const;
    model::Result<model::PolygonMesh> readMesh(const model::Progress &progress) const;
};

/// A mesh file as it is; of an animation one frame.
model::Result<model::PolygonMesh> Inspect::readMesh(const model::Progress &progress) const
{
    const QString path = fromUtf8(input.path);
    if (model::io::meshKindOf(path) && !QFileInfo(path).isDir() && frame.value_or(1) == 1)
        return model::io::readPolygonMesh(path, progress);
    const auto source = input.read(progress);
    if (!source)
        return model::fail(source.error());
    const std::uint32_t count = (*source)->frameCount();
    if (frame.value_or(1) > count)
        return model::fail(model::ErrorCode::BadSetting, "frame", std::to_string(*frame),
                           "1.." + std::to_string(count));
    return model::PolygonMesh{(*source)->frame(frame.value_or(1) - 1), model::Faces((*source)->connectivity())};
}

QString number(double value)
{
    return QString::number(value, 'g', 6);
}

/// Columns as wide as their widest field, numbers to the right.
QStringList aligned(const QList<QStringList> &rows)
{
    QList<qsizetype> widths;
    for (const QStringList &row : rows)
        for (qsizetype i = 0; i < row.size(); ++i) {
            if (i == widths.size())
                widths << 0;
            widths[i] = std::max(widths[i], row[i].size());
        }
    QStringList lines;
    for (const QStringList &row : rows) {
        QString line;
        for (qsizetype i = 0; i < row.size(); ++i)
            line += QStringLiteral("  ") + row[i].rightJustified(widths[i]);
        lines << line;
    }
    return lines;
}

/// A headline with the number of rows, and the first of them.
template <class List, class RowOf>
void addTable(QStringList &text, const QString &title, const QStringList &names, const List &list, const RowOf &rowOf)
{
    text << QString() << QStringLiteral("%1: %2").arg(title).arg(list.size());
    if (list.empty())
        return;
    QList<QStringList> rows{names};
    for (std::size_t i = 0; i < std::min(list.size(), MostRows); ++i)
        rows << (QStringList{QString::number(i)} << rowOf(list[i]));
    text << aligned(rows);
    if (list.size() > MostRows)
        text << QStringLiteral("  ... and %1 more").arg(list.size() - MostRows);
}

QString idsText(const std::vector<model::ProblemIds> &list)
{
    constexpr std::size_t MostIds = 6;
    QStringList ids;
    for (std::size_t i = 0; i < std::min(list.size(), MostIds); ++i)
        ids << (list[i][1] == model::NoId ? QString::number(list[i][0])
                                          : QStringLiteral("%1-%2").arg(list[i][0]).arg(list[i][1]));
    return ids.join(QStringLiteral(", ")) + (list.size() > MostIds ? QStringLiteral(", ...") : QString());
}

QStringList problemLines(const Inspection &inspection)
{
    QList<QStringList> rows;
    for (std::size_t i = 0; i < model::ProblemKindCount; ++i) {
        const auto kind = model::ProblemKind(i);
        const auto &list = inspection.report.of(kind);
        if (!list.empty())
            rows << QStringList{QString(QLatin1String(model::problemKey(kind))).replace('_', ' '),
                                QString::number(list.size()), idsText(list)};
    }
    QStringList lines;
    for (const QStringList &row : rows)
        lines << QStringLiteral("  %1  %2  %3").arg(row[0], -22).arg(row[1], 8).arg(row[2]);
    return lines;
}

QString walkText(const model::codec::WalkStatistics &walk)
{
    QStringList symbols;
    for (const char symbol : {'C', 'L', 'E', 'R', 'S'})
        symbols << QStringLiteral("%1 %2")
                       .arg(QLatin1Char(symbol))
                       .arg(walk.symbolCounts[QByteArray("CSRLE").indexOf(symbol)]);
    return QStringLiteral("%1; %2 handle splits; %3 bytes, %4 bits per triangle")
        .arg(symbols.join(QStringLiteral(", ")))
        .arg(walk.handleSplits.size())
        .arg(walk.bytes)
        .arg(walk.bitsPerTriangle, 0, 'f', 3);
}

QString yesNo(bool value)
{
    return value ? QStringLiteral("yes") : QStringLiteral("no");
}

template <class Number>
QString orDash(const std::optional<Number> &value)
{
    return value ? number(double(*value)) : QStringLiteral("-");
}

QStringList textOf(const Inspection &inspection)
{
    const model::MeshReport &report = inspection.report;
    QStringList text{QStringLiteral("vertices      %1").arg(report.vertices),
                     QStringLiteral("edges         %1").arg(report.edges),
                     QStringLiteral("faces         %1").arg(report.faces),
                     QStringLiteral("Euler number  %1").arg(report.euler()),
                     QStringLiteral("genus         %1").arg(orDash(report.genus())),
                     QStringLiteral("manifold      %1").arg(yesNo(report.isManifold())),
                     QStringLiteral("orientable    %1").arg(yesNo(report.isOrientable())),
                     QStringLiteral("EdgeBreaker   %1").arg(walkText(inspection.walk))};
    addTable(text, QStringLiteral("Components (pieces that do not hang together)"),
             {"#", "vertices", "edges", "faces", "Euler", "genus", "loops", "orientable", "area", "volume"},
             report.components, [](const model::ComponentReport &c) {
                 return QStringList{
                     QString::number(c.vertices), QString::number(c.edges), QString::number(c.faces),
                     QString::number(c.euler()),  orDash(c.genus),          QString::number(c.boundaryLoops),
                     yesNo(c.isOrientable),       number(c.area),           orDash(c.volume)};
             });
    addTable(text, QStringLiteral("Holes (where faces are missing)"), {"#", "component", "edges", "length", "area"},
             report.holes, [](const model::HoleReport &hole) {
                 return QStringList{QString::number(hole.component), QString::number(hole.loop.sides.size()),
                                    number(hole.length), number(hole.area)};
             });
    addTable(text, QStringLiteral("Handles (tunnels through the shape)"),
             {"#", "component", "shortest loop", "edges", "other loop", "edges"}, inspection.handles,
             [](const model::HandleReport &handle) {
                 return QStringList{QString::number(handle.component), number(handle.loops[0].length),
                                    QString::number(handle.loops[0].vertices.size()), number(handle.loops[1].length),
                                    QString::number(handle.loops[1].vertices.size())};
             });
    const QStringList problems = problemLines(inspection);
    text << QString() << (problems.isEmpty() ? QStringLiteral("Problems: none") : QStringLiteral("Problems"))
         << problems;
    if (!inspection.hasSelfIntersections)
        text << QStringLiteral("  (self-intersections: looked for with --self-intersections)");
    return text;
}

model::Result<void> Inspect::run(Console &console) const
{
    const auto mesh = readMesh(console.progress("Reading"));
    if (!mesh)
        return model::fail(mesh.error());
    model::io::InspectionOptions options;
    options.selfIntersections = selfIntersections;
    const auto inspection =
        model::io::inspectMesh(mesh->faces, mesh->positions, options, console.progress("Inspecting"));
    if (!inspection)
        return model::fail(inspection.error());
    console.endProgress();
    if (csv) {
        for (const QString &line : model::io::inspectionCsv(*inspection, *csv))
            console.line(line);
        return {};
    }
    console.data(model::io::inspectionJson(*inspection), textOf(*inspection));
    return {};
}

} // namespace

void addInspect(CLI::App &app, Run &run)
{
    CLI::App *command = app.add_subcommand("inspect", "Say what a mesh is made of and what is wrong with it");
    const auto options = std::make_shared<Inspect>();
    options->input.addTo(*command, "MESH");
    command->add_option("--frame", options->frame, "Frame of an animation, counted from 1 (default: the first)")
        ->check(CLI::PositiveNumber)
        ->type_name("N");
    const std::map<std::string, model::io::InspectionTable> tables{
        {"components", model::io::InspectionTable::Components},
        {"holes", model::io::InspectionTable::Holes},
        {"handles", model::io::InspectionTable::Handles},
        {"problems", model::io::InspectionTable::Problems}};
    command->add_option("--csv", options->csv, "Print one of the lists as CSV")
        ->transform(CLI::CheckedTransformer(tables, CLI::ignore_case).description(""))
        ->type_name("components|holes|handles|problems");
    command->add_flag("--self-intersections", options->selfIntersections, "Look for faces that cross each other, too");
    command->footer("Nothing is repaired before it is counted. Numbers of vertices, faces and components start at 0.\n"
                    "Examples:\n"
                    "  sandreel-cli inspect bunny.ply\n"
                    "  sandreel-cli --json inspect bunny.ply\n"
                    "  sandreel-cli inspect walk.anim --frame 12 --csv holes");
    onCall(*command, options, run);
}

} // namespace cli
