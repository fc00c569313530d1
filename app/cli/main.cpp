// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands.h"
#include "model/io/errortext.h"

#include <QCoreApplication>

int main(int argc, char **argv)
{
    const QCoreApplication application(argc, argv);
    cli::Console console;
    cli::Run run;

    CLI::App app("Turns triangle-mesh animations into small .anim files and back, and measures what was lost.",
                 "sandreel-cli");
    app.set_version_flag("--version", "sandreel-cli " SANDREEL_VERSION);
    app.set_help_all_flag("--help-all", "Help of all sub-commands");
    app.require_subcommand(1);
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
    cli::addCompare(app, run);
    cli::addRender(app, run);

    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError &error) {
        // Asking for help or the version ends the parser with success.
        return app.exit(error) == 0 ? 0 : int(cli::ExitCode::Usage);
    }

    const model::Result<void> result = run(console);
    console.endProgress();
    if (!result) {
        console.error(QStringLiteral("sandreel-cli: ") + model::io::errorText(result.error()));
        return int(cli::exitCodeOf(result.error()));
    }
    if (!console.flush()) {
        console.error(QStringLiteral("sandreel-cli: standard output could not be written."));
        return int(cli::ExitCode::InputOutput);
    }
    return int(cli::ExitCode::Ok);
}
