// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/animationreader.h"
#include "model/io/errortext.h"
#include "tests/bench/comparison/contender.h"
#include "tests/bench/comparison/plot.h"
#include "tests/support/realdata.h"

#include <CLI/CLI.hpp>

#include <QFileInfo>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>

// All codecs at equal error, side by side: one table, also as CSV and as a plot.

using namespace model;
using namespace bench;

namespace {

/// \param name  one of the shared sequences, or a path
std::optional<Subject> subjectOf(const std::string &name)
{
    const QString given = QString::fromStdString(name);
    QString path = given;
    if (!QFileInfo::exists(path)) {
        if (tests::dataFolder().isEmpty()) {
            std::fprintf(stderr, "%s: no such file, and SANDREEL_DATA is not set\n", name.c_str());
            return {};
        }
        const QString folder = tests::sequenceFolder(given);
        const QString cache = folder + u'/' + given + QStringLiteral(".pc2");
        path = QFileInfo::exists(cache) ? cache : folder;
    }
    const auto animation = io::readAnimation(path);
    if (!animation) {
        std::fprintf(stderr, "%s\n", qPrintable(io::errorText(animation.error())));
        return {};
    }
    return Subject{QFileInfo(given).completeBaseName().toStdString(), toSequence(*animation)};
}

std::string secondsText(double seconds)
{
    if (std::isnan(seconds))
        return "-";
    std::array<char, 32> buffer;
    std::snprintf(buffer.data(), buffer.size(), seconds < 1 ? "%.3f" : seconds < 10 ? "%.2f" : "%.1f", seconds);
    return buffer.data();
}

/// For machines: nothing where nothing was measured.
std::string numberField(double value)
{
    if (std::isnan(value))
        return "";
    std::array<char, 32> buffer;
    std::snprintf(buffer.data(), buffer.size(), "%.6g", value);
    return buffer.data();
}

/// Rows as they come, on the terminal and in the CSV; points for the plot.
class Report
{
public:
    explicit Report(const std::string &csv)
    {
        std::printf("%-13s %5s  %-25s %-44s %11s %9s %8s %9s %9s %9s\n", "sequence", "KG %", "codec", "setting",
                    "bytes", "bpfv", "KG %", "encode s", "decode s", "search s");
        if (csv.empty())
            return;
        mCsv.open(csv);
        mCsv << "sequence,target KG %,codec,setting,bytes,bpfv,KG %,encode s,decode s,search s\n";
    }

    void begin(const Subject &subject) { mPanels.push_back({subject.name, {}}); }

    void add(const Subject &subject, double target, const Measurement &row)
    {
        const double bpfv = subject.bpfv(row.bytes);
        const std::string wanted = numberField(target);
        std::printf("%-13s %5s  %-25s %-44s %11llu %9.4f %8.4f %9s %9s %9s\n", subject.name.c_str(), wanted.c_str(),
                    row.codec.c_str(), row.setting.c_str(), static_cast<unsigned long long>(row.bytes), bpfv,
                    row.kgErrorPercent, secondsText(row.encodeSeconds).c_str(), secondsText(row.decodeSeconds).c_str(),
                    secondsText(row.searchSeconds).c_str());
        std::fflush(stdout);
        if (mCsv.is_open())
            mCsv << subject.name << ',' << wanted << ',' << '"' << row.codec << "\",\"" << row.setting << "\","
                 << row.bytes << ',' << numberField(bpfv) << ',' << numberField(row.kgErrorPercent) << ','
                 << numberField(row.encodeSeconds) << ',' << numberField(row.decodeSeconds) << ','
                 << numberField(row.searchSeconds) << std::endl;
    }

    /// A point on the line of a codec; none for what has no error.
    void plot(const Subject &subject, const std::string &codec, const Measurement &row)
    {
        if (!(row.kgErrorPercent > 0))
            return;
        auto &lines = mPanels.back().lines;
        auto line = std::find_if(lines.begin(), lines.end(), [&](const RateLine &l) { return l.codec == codec; });
        if (line == lines.end())
            line = lines.insert(lines.end(), {codec, {}});
        line->points.push_back({subject.bpfv(row.bytes), row.kgErrorPercent});
    }

    const std::vector<RatePanel> &panels() const { return mPanels; }

private:
    std::ofstream mCsv;
    std::vector<RatePanel> mPanels;
};

struct Named
{
    std::string name;
    std::unique_ptr<Contender> contender;
};

std::vector<Named> contenders(const std::vector<std::string> &wanted)
{
    std::vector<Named> all;
    all.push_back({"reel", makePredicting(CodecId::Reel)});
    all.push_back({"coddyac", makePredicting(CodecId::Coddyac)});
    all.push_back({"pca", makePredicting(CodecId::Pca)});
    all.push_back({"direct", makeDirect()});
    all.push_back({"draco", makeDraco()});
    all.push_back({"xz-cells", makeXzOfCells()});
    all.push_back({"xz-floats", makeXzOfFloats()});
    std::erase_if(all, [&](const Named &named) {
        return !wanted.empty() && std::find(wanted.begin(), wanted.end(), named.name) == wanted.end();
    });
    for (const Named &named : all)
        if (!named.contender)
            std::printf("Built without %s: its rows are left out.\n", named.name.c_str());
    std::erase_if(all, [](const Named &named) { return !named.contender; });
    return all;
}

void compare(const Subject &subject, const std::vector<double> &targets, const std::vector<Named> &all, Report &report)
{
    report.begin(subject);
    for (const Named &named : all)
        for (const double target : targets) {
            const std::vector<Measurement> rows = named.contender->reach(subject, target);
            for (const Measurement &row : rows)
                report.add(subject, named.contender->isLossless() ? 0 : target, row);
            if (rows.empty())
                std::printf("%-13s %5g  %s: cannot come so close\n", subject.name.c_str(), target, named.name.c_str());
            // The plot has one line for all the ways of `direct`: the best of them.
            if (named.name == "direct" && !rows.empty())
                report.plot(subject, "direct (best)",
                            *std::min_element(rows.begin(), rows.end(),
                                              [](const auto &a, const auto &b) { return a.bytes < b.bytes; }));
            else
                for (const Measurement &row : rows)
                    report.plot(subject, row.codec, row);
            if (named.contender->isLossless())
                break;
        }
}

} // namespace

int main(int argc, char **argv)
{
    std::vector<double> targets{5, 1, 0.2};
    std::vector<std::string> sequences{"chicken", "cow", "dance", "samba", "horse-gallop"}, codecs;
    std::string csv, svg;
    CLI::App app("Compares all codecs, and Draco and xz, at equal KG error.");
    app.add_option("--kg", targets, "KG errors to reach, per cent")->delimiter(',')->check(CLI::PositiveNumber);
    app.add_option("--sequences", sequences, "names in SANDREEL_DATA, or paths")->delimiter(',');
    app.add_option("--codecs", codecs, "only these")
        ->delimiter(',')
        ->check(CLI::IsMember({"reel", "coddyac", "pca", "direct", "draco", "xz-cells", "xz-floats"}));
    app.add_option("--csv", csv, "the table as a file");
    app.add_option("--svg", svg, "the plot");
    CLI11_PARSE(app, argc, argv);

    const std::vector<Named> all = contenders(codecs);
    Report report(csv);
    for (const std::string &name : sequences) {
        const auto subject = subjectOf(name);
        if (!subject)
            return 1;
        compare(*subject, targets, all, report);
    }
    if (!svg.empty() && !(std::ofstream(svg) << ratePlot(report.panels()))) {
        std::fprintf(stderr, "%s: cannot be written\n", svg.c_str());
        return 1;
    }
    return 0;
}
