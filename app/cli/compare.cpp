// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands.h"
#include "app/cli/outputs.h"
#include "model/animation/hausdorff.h"
#include "model/animation/metrics.h"
#include "model/animation/sted.h"
#include "model/codec/connectivity/codedorder.h"
#include "model/io/animfile.h"

#include <QJsonArray>
#include <QJsonValue>
#include <QLocale>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

namespace cli {

namespace {

/// What is measured in one pass.
enum class Metric { VertexErrors, Sted, Hausdorff };

const std::map<std::string, Metric> MetricNames{{"kg", Metric::VertexErrors},    {"da", Metric::VertexErrors},
                                                {"rmse", Metric::VertexErrors},  {"psnr", Metric::VertexErrors},
                                                {"max", Metric::VertexErrors},   {"sted", Metric::Sted},
                                                {"hausdorff", Metric::Hausdorff}};

struct Measured
{
    model::ComparisonResult errors;
    std::optional<model::StedResult> sted;
    std::optional<model::HausdorffResult> hausdorff;
};

struct Compare
{
    InputOptions reference;
    std::string test, permutation, csv;
    NormaliseOption normalise;
    std::vector<Metric> metrics; ///< empty: all
    double surfaceSamples = model::DefaultSurfaceSamples;

    model::Result<void> run(Console &console) const;
    model::Result<std::vector<std::uint32_t>> readPermutation() const;
    model::Result<Measured> measure(const model::FrameSource &original, const model::FrameSource &tested,
                                    std::span<const std::uint32_t> order, Console &console) const;
    bool wants(Metric metric) const { return metrics.empty() || std::ranges::find(metrics, metric) != metrics.end(); }
};

/// KG errors above this share of the animation's extent mean that the two were not placed alike.
constexpr double SuspiciousKgPercent = 50;

model::Result<std::vector<std::uint32_t>> Compare::readPermutation() const
{
    if (permutation.empty())
        return std::vector<std::uint32_t>();
    const auto bytes = model::io::readBytes(fromUtf8(permutation));
    if (!bytes)
        return model::fail(bytes.error());
    std::vector<std::uint32_t> order;
    const char *at = reinterpret_cast<const char *>(bytes->data());
    const char *const end = at + bytes->size();
    for (std::uint64_t line = 1; at != end; ++line) {
        std::uint32_t index = 0;
        const auto [next, problem] = std::from_chars(at, end, index);
        const char *rest = next;
        while (rest != end && (*rest == '\r' || *rest == ' '))
            ++rest;
        if (problem != std::errc() || (rest != end && *rest != '\n'))
            return model::fail(model::Error{
                model::ErrorCode::BadPermutation, {"not an index"}, permutation, line, model::Error::None});
        order.push_back(index);
        at = rest == end ? end : rest + 1;
    }
    // Without a line it would read as "the same order".
    if (order.empty())
        return model::fail(model::Error{
            model::ErrorCode::BadPermutation, {"it is empty"}, permutation, model::Error::None, model::Error::None});
    return order;
}

QJsonValue decibels(double value)
{
    return std::isfinite(value) ? QJsonValue(value) : QJsonValue();
}

double frameDecibels(double diagonal, double rmse)
{
    return 20 * std::log10(diagonal / rmse);
}

QJsonObject jsonOf(const Measured &measured)
{
    const model::ComparisonResult &errors = measured.errors;
    QJsonArray frames;
    for (std::size_t i = 0; i < errors.frames.size(); ++i) {
        const model::FrameError &error = errors.frames[i];
        QJsonObject frame{{"frame", double(i + 1)},
                          {"kg_error_percent", error.kgErrorPercent},
                          {"da_error", error.daError},
                          {"rmse", error.rmse},
                          {"psnr_db", decibels(frameDecibels(errors.diagonal, error.rmse))},
                          {"max_vertex_error", error.maxVertexError},
                          {"worst_vertex", double(error.worstVertex)}};
        if (measured.sted) {
            frame.insert("sted_spatial", measured.sted->frames[i].spatial);
            // No step leads to the first frame.
            frame.insert("sted_temporal", i == 0 ? QJsonValue() : QJsonValue(measured.sted->frames[i].temporal));
        }
        if (measured.hausdorff)
            frame.insert("hausdorff", measured.hausdorff->frames[i].distance());
        frames.append(frame);
    }
    QJsonObject result{{"kg_error_percent", errors.kgErrorPercent},
                       {"da_error", errors.daError},
                       {"rmse", errors.rmse},
                       {"psnr_db", decibels(errors.psnrDb)},
                       {"max_vertex_error", errors.maxVertexError},
                       {"worst_frame", double(errors.worstFrame + 1)},
                       {"worst_vertex", double(errors.worstVertex)},
                       {"diagonal", errors.diagonal},
                       {"frames", frames}};
    if (const auto &sted = measured.sted) {
        result.insert("sted", sted->sted);
        result.insert("sted_spatial", sted->spatial);
        result.insert("sted_temporal", sted->temporal);
    }
    if (const auto &hausdorff = measured.hausdorff) {
        result.insert("hausdorff", hausdorff->distance);
        result.insert("hausdorff_from_reference", hausdorff->fromReference);
        result.insert("hausdorff_from_test", hausdorff->fromTest);
        result.insert("hausdorff_worst_frame", double(hausdorff->worstFrame + 1));
    }
    return result;
}

QByteArray csvOf(const Measured &measured)
{
    const auto number = [](double value) { return QByteArray::number(value, 'g', QLocale::FloatingPointShortest); };
    QByteArrayList header{"frame", "kg_error_percent", "rmse", "max_vertex_error", "worst_vertex", "da_error"};
    if (measured.sted)
        header << "sted_spatial"
               << "sted_temporal";
    if (measured.hausdorff)
        header << "hausdorff";
    QByteArray text = header.join(',') + '\n';
    for (std::size_t i = 0; i < measured.errors.frames.size(); ++i) {
        const model::FrameError &error = measured.errors.frames[i];
        QByteArrayList row{
            QByteArray::number(qulonglong(i + 1)), number(error.kgErrorPercent),          number(error.rmse),
            number(error.maxVertexError),          QByteArray::number(error.worstVertex), number(error.daError)};
        if (measured.sted)
            row << number(measured.sted->frames[i].spatial)
                << (i == 0 ? QByteArray() : number(measured.sted->frames[i].temporal));
        if (measured.hausdorff)
            row << number(measured.hausdorff->frames[i].distance());
        text += row.join(',') + '\n';
    }
    return text;
}

void printTable(Console &console, const Measured &measured)
{
    const model::ComparisonResult &errors = measured.errors;
    const auto line = [&console](const char *name, const QString &value) {
        console.line(QString::fromLatin1(name).leftJustified(22) + value);
    };
    const auto number = [](double value) { return QString::number(value, 'g', 6); };
    const auto percent = [&](double length) {
        return QString::number(errors.diagonal > 0 ? 100 * length / errors.diagonal : 0.0, 'g', 4);
    };
    line("KG error", number(errors.kgErrorPercent) + " %");
    line("DA error", number(errors.daError));
    if (const auto &sted = measured.sted)
        line("STED", QStringLiteral("%1 (spatial %2, temporal %3)")
                         .arg(number(sted->sted), number(sted->spatial), number(sted->temporal)));
    line("RMSE", number(errors.rmse));
    line("PSNR",
         std::isfinite(errors.psnrDb) ? QString::number(errors.psnrDb, 'f', 2) + " dB" : QStringLiteral("infinite"));
    line("largest vertex error", QStringLiteral("%1 (%2 % of the diagonal; vertex %3 in frame %4)")
                                     .arg(number(errors.maxVertexError), percent(errors.maxVertexError))
                                     .arg(errors.worstVertex)
                                     .arg(errors.worstFrame + 1));
    if (const auto &hausdorff = measured.hausdorff)
        line("Hausdorff distance", QStringLiteral("%1 (%2 % of the diagonal; frame %3)")
                                       .arg(number(hausdorff->distance), percent(hausdorff->distance))
                                       .arg(hausdorff->worstFrame + 1));
}

model::Result<Measured> Compare::measure(const model::FrameSource &original, const model::FrameSource &tested,
                                         std::span<const std::uint32_t> order, Console &console) const
{
    Measured measured;
    auto errors = model::compareAnimations(original, tested, order, console.progress("Comparing"));
    if (!errors)
        return model::fail(std::move(errors.error()));
    measured.errors = std::move(*errors);
    if (wants(Metric::Sted)) {
        auto sted = model::spatioTemporalDifference(original, tested, order, console.progress("STED"));
        if (!sted)
            return model::fail(std::move(sted.error()));
        measured.sted = std::move(*sted);
    }
    if (wants(Metric::Hausdorff)) {
        auto hausdorff =
            model::hausdorffDistance(original, tested, order, surfaceSamples, console.progress("Hausdorff"));
        if (!hausdorff)
            return model::fail(std::move(hausdorff.error()));
        measured.hausdorff = std::move(*hausdorff);
    }
    return measured;
}

model::Result<void> Compare::run(Console &console) const
{
    if (auto checked = checkOutputs({{"--csv", csv}}, {reference.path, test, reference.baseMesh, permutation});
        !checked)
        return checked;
    const auto order = readPermutation();
    if (!order)
        return model::fail(order.error());
    const auto original = reference.read(console.progress("Reading"));
    if (!original)
        return model::fail(original.error());
    const auto placed = normalise.apply(*original, console.progress("Measuring"));
    if (!placed)
        return model::fail(placed.error());
    InputOptions testInput = reference;
    testInput.path = test;
    const auto tested = testInput.read(console.progress("Reading"));
    if (!tested)
        return model::fail(tested.error());
    std::vector<std::uint32_t> matching = *order;
    if (permutation.empty()) { // vertices that our own encoder reordered are found again
        auto found = model::codec::codedOrder((*placed)->connectivity(), (*tested)->connectivity(),
                                              console.progress("Matching"));
        if (!found)
            return model::fail(std::move(found).error());
        matching = std::move(*found);
    }
    const auto result = measure(**placed, **tested, matching, console);
    if (!result)
        return model::fail(model::Error(result.error())
                               .in(result.error().code == model::ErrorCode::BadPermutation ? permutation : test));

    if (!csv.empty()) {
        const QByteArray text = csvOf(*result);
        const auto saved = model::io::saveBytes(
            fromUtf8(csv), {reinterpret_cast<const std::uint8_t *>(text.constData()), std::size_t(text.size())});
        if (!saved)
            return saved;
    }
    if (console.isJson())
        console.json(jsonOf(*result));
    else
        printTable(console, *result);
    if (result->errors.kgErrorPercent > SuspiciousKgPercent)
        console.note(
            QStringLiteral("The two are far apart. If one of them was normalised, compare with the same --normalize; "
                           "if its vertices were reordered, give their --permutation."));
    return {};
}

} // namespace

void addCompare(CLI::App &app, Run &run)
{
    CLI::App *command = app.add_subcommand("compare", "Measure what was lost between two animations");
    const auto options = std::make_shared<Compare>();
    options->reference.addTo(*command, "REFERENCE");
    command->add_option("TEST", options->test, "The animation to measure; read as the reference is")->required();
    command
        ->add_option("--permutation", options->permutation,
                     "For each vertex of TEST, a line with its index in REFERENCE, as encode wrote it")
        ->type_name("FILE");
    options->normalise.addTo(*command, "Normalise REFERENCE first, as encode did for TEST (default: none)");
    command
        ->add_option("--metrics", options->metrics,
                     "Measure only these, separated by commas: kg, da, rmse, psnr and max (always\n"
                     "measured), sted, hausdorff (default: all)")
        ->delimiter(',')
        ->transform(CLI::CheckedTransformer(MetricNames, CLI::ignore_case).description(""))
        ->type_name("NAMES");
    command
        ->add_option("--surface-samples", options->surfaceSamples,
                     "Samples per triangle, on average, for the Hausdorff distance (default: 10)")
        ->check(finiteRange(0, model::MaxSurfaceSamples))
        ->type_name("N");
    command->add_option("--csv", options->csv, "Also write the errors of each frame")->type_name("FILE");
    command->footer("Frames are counted from 1, vertices from 0.\n"
                    "Examples:\n"
                    "  sandreel-cli compare frames/ walk.anim\n"
                    "  sandreel-cli compare frames/ walk.anim --metrics kg,sted --csv errors.csv\n"
                    "  sandreel-cli --json compare walk.pc2 decoded.pc2 --base-mesh walk.obj");
    onCall(*command, options, run);
}

} // namespace cli
