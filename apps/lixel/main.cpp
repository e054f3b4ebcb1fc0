// SPDX-License-Identifier: MIT
// The lixel command line: words in, one of a few exit codes out. Everything else is in the file of its command.
#include "commands.h"
#include "executor_error.h"
#include "exit_code.h"
#include "lixel/report/write_file.h"
#include "lixel/scene/load.h"
#include "text.h"

#include <csignal>
#include <cstdio>
#include <new>
#include <unistd.h>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace {

using namespace lixel;
using namespace lixel::app;

// Ctrl-C: what is half-written goes, the rest stays.
extern "C" void onInterrupt(int)
{
    removePendingFiles();
    constexpr char kMessage[] = "\nlixel: interrupted\n";
    if (write(STDERR_FILENO, kMessage, sizeof kMessage - 1) < 0) _exit(kInterrupted);
    _exit(kInterrupted);
}

int fail(ExitCode code, const std::string& message)
{
    fmt::print(stderr, "lixel: {}\n", message);
    return code;
}

int runChosen(const std::vector<Command>& commands)
{
    try {
        for (const Command& command : commands)
            if (command.app->parsed()) return command.run();
        return kDone;
    } catch (const UsageError& error) {
        return fail(kBadUsage, error.what());
    } catch (const InputError& error) {
        return fail(kBadInput, error.what());
    } catch (const OutputError& error) {
        return fail(kFailed, error.what());
    } catch (const RefusedError& error) {
        return fail(kRefused, error.what());
    } catch (const NoGraphicsError& error) {
        return fail(kNoGraphics, error.what());
    } catch (const std::bad_alloc&) {
        return fail(kFailed, "out of memory; a smaller --size or --lixels needs less");
    } catch (const std::exception& error) {
        return fail(kFailed, error.what());
    }
}

} // namespace

int main(int argc, char** argv)
{
    std::signal(SIGINT, onInterrupt);
    std::signal(SIGTERM, onInterrupt);
    const std::string commandLine = quoted(argc, argv);
    CLI::App app{"lixel: shadow maps that put their samples where the picture needs them, judged by exact visibility", "lixel"};
    app.set_version_flag("--version", "lixel " LIXEL_VERSION);
    app.require_subcommand(1);
    app.failure_message(CLI::FailureMessage::simple);
    const std::vector<Command> commands{addRender(app), addCompare(app, commandLine), addReproduce(app, commandLine),
                                        addTechniques(app), addScenes(app)};
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& success) { // --help, --version
        return app.exit(success);
    } catch (const CLI::ParseError& error) {
        return fail(kBadUsage, fmt::format("{} (lixel --help)", error.what()));
    }
    return runChosen(commands);
}
