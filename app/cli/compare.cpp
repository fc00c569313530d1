// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands.h"
#include "app/cli/outputs.h"
#include "model/animation/metrics.h"
#include "model/io/animfile.h"

#include <QJsonArray>
#include <QJsonValue>
#include <QLocale>

#include <charconv>
#include <cmath>

namespace cli {

namespace {

struct Compare
{
    InputOptions reference;
    std::string test, permutation, csv;
    NormaliseOption normalise;

    model::Result<void> run(Console &console) const;
    model::Result<std::vector<std::uint32_t>> readPermutation() const;
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

QJsonObject jsonOf(const model::ComparisonResult &result)
{
    QJsonArray frames;
    for (std::size_t i = 0; i < result.frames.size(); ++i) {
        const model::FrameError &error = result.frames[i];
        frames.append(QJsonObject{{"frame", double(i + 1)},
                                  {"kg_error_percent", error.kgErrorPercent},
                                  {"rmse", error.rmse},
                                  {"psnr_db", decibels(frameDecibels(result.diagonal, error.rmse))},
                                  {"max_vertex_error", error.maxVertexError},
                                  {"worst_vertex", double(error.worstVertex)}});
    }
    return {{"kg_error_percent", result.kgErrorPercent},
            {"rmse", result.rmse},
            {"psnr_db", decibels(result.psnrDb)},
            {"max_vertex_error", result.maxVertexError},
            {"worst_frame", double(result.worstFrame + 1)},
            {"worst_vertex", double(result.worstVertex)},
            {"diagonal", result.diagonal},
            {"frames", frames}};
}

QByteArray csvOf(const model::ComparisonResult &result)
{
    const auto number = [](double value) { return QByteArray::number(value, 'g', QLocale::FloatingPointShortest); };
    QByteArray text = "frame,kg_error_percent,rmse,max_vertex_error,worst_vertex\n";
    for (std::size_t i = 0; i < result.frames.size(); ++i) {
        const model::FrameError &error = result.frames[i];
        text += QByteArray::number(qulonglong(i + 1)) + ',' + number(error.kgErrorPercent) + ',' + number(error.rmse) +
                ',' + number(error.maxVertexError) + ',' + QByteArray::number(error.worstVertex) + '\n';
    }
    return text;
}

void printTable(Console &console, const model::ComparisonResult &result)
{
    console.line(QStringLiteral("KG error              %1 %").arg(result.kgErrorPercent, 0, 'g', 6));
    console.line(QStringLiteral("RMSE                  %1").arg(result.rmse, 0, 'g', 6));
    console.line(std::isfinite(result.psnrDb)
                     ? QStringLiteral("PSNR                  %1 dB").arg(result.psnrDb, 0, 'f', 2)
                     : QStringLiteral("PSNR                  infinite"));
    console.line(QStringLiteral("largest vertex error  %1 (%2 % of the diagonal; vertex %3 in frame %4)")
                     .arg(result.maxVertexError, 0, 'g', 6)
                     .arg(result.diagonal > 0 ? 100 * result.maxVertexError / result.diagonal : 0.0, 0, 'g', 4)
                     .arg(result.worstVertex)
                     .arg(result.worstFrame + 1));
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
    const auto result = model::compareAnimations(**placed, **tested, *order, console.progress("Comparing"));
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
    if (result->kgErrorPercent > SuspiciousKgPercent)
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
    command->add_option("--csv", options->csv, "Also write the errors of each frame")->type_name("FILE");
    command->footer("Frames are counted from 1, vertices from 0.\n"
                    "Examples:\n"
                    "  sandreel-cli compare frames/ walk.anim\n"
                    "  sandreel-cli --json compare walk.pc2 decoded.pc2 --base-mesh walk.obj");
    command->callback([options, &run] { run = [options](Console &console) { return options->run(console); }; });
}

} // namespace cli
