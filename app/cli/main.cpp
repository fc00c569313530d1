// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands.h"
#include "app/cli/haptics.h"
#include "model/base/outofmemory.h"
#include "model/io/errortext.h"

#include <QCoreApplication>

#include <cstdlib>

namespace {

/// One line of what is wrong with the command line, and where to read on.
std::string usageMessage(const CLI::App *app, const CLI::Error &error)
{
    std::string what = error.what();
    std::string help = app->get_name();
    if (const auto chosen = app->get_subcommands(); !chosen.empty()) {
        help += ' ' + chosen.front()->get_name();
        if (dynamic_cast<const CLI::ExtrasError *>(&error)) {
            what = "Not expected:";
            for (const std::string &argument : app->remaining(true))
                what += ' ' + argument;
        }
    } else if (dynamic_cast<const CLI::RequiredError *>(&error)) {
        const auto rest = app->remaining();
        what = rest.empty() ? "A sub-command is missing." : "There is no sub-command \"" + rest.front() + "\".";
        what += " There are";
        for (const CLI::App *command : app->get_subcommands({}))
            what += ' ' + command->get_name() + ',';
        what.back() = '.';
    }
    return "sandreel-cli: " + what + "\nSee " + help + " --help.\n";
}

} // namespace

int main(int argc, char **argv)
{
    // Numbers on the command line have a decimal point, and file names are UTF-8, wherever the program runs.
    qputenv("LC_ALL", "C.UTF-8");
    const QCoreApplication application(argc, argv);
    cli::Console console;
    cli::Run run;

    CLI::App app("Turns triangle-mesh animations into small .anim files and back, and measures what was lost;\n"
                 "makes, imports, changes and exports terrains.",
                 "sandreel-cli");
    app.set_version_flag("--version", "sandreel-cli " SANDREEL_VERSION);
    app.set_help_all_flag("--help-all", "Help of all sub-commands");
    app.require_subcommand(1);
    app.failure_message(usageMessage);
    app.fallthrough();
    app.add_flag_callback(
        "--json", [&] { console.setJson(true); }, "Print JSON on standard output, for machines");
    app.add_flag_callback(
        "-q,--quiet", [&] { console.setQuiet(true); }, "No progress, no messages but errors");
    app.footer("Exit codes: 0 done, 2 wrong usage, 3 bad input, 4 a file could not be read or written, 5 too large,\n"
               "130 interrupted. Each sub-command has its own --help, with examples.");
    cli::addEncode(app, run);
    cli::addDecode(app, run);
    cli::addInfo(app, run);
    cli::addInspect(app, run);
    cli::addCompare(app, run);
    cli::addRender(app, run);
    cli::addExportPlayer(app, run);
    cli::addTerrain(app, run);
    cli::addHaptics(app, run);

    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError &error) {
        // Asking for help or the version ends the parser with success.
        if (app.exit(error) != 0)
            return int(cli::ExitCode::Usage);
        return console.flush() ? int(cli::ExitCode::Ok) : int(cli::ExitCode::InputOutput);
    }

    const model::Result<void> result = model::catchBadAlloc([&] { return run(console); });
    console.endProgress();
    if (!result) {
        console.error(QStringLiteral("sandreel-cli: ") + model::io::errorText(result.error()));
        // A scene's importer may still be at work; who pressed Ctrl+C does not wait for it.
        if (result.error().code == model::ErrorCode::Cancelled)
            std::_Exit(int(cli::ExitCode::Interrupted));
        return int(cli::exitCodeOf(result.error()));
    }
    if (!console.flush()) {
        console.error(QStringLiteral("sandreel-cli: standard output could not be written."));
        return int(cli::ExitCode::InputOutput);
    }
    return int(cli::ExitCode::Ok);
}
