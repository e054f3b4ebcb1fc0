// SPDX-License-Identifier: MIT
// The lixel command line: words in, one of a few exit codes out. Everything else is in the file of its command.
#include "commands.h"
#include "exit_code.h"
#include "lixel/gl/graphics_error.h"
#include "lixel/report/interruption.h"
#include "lixel/report/write_file.h"
#include "lixel/scene/load.h"
#include "output.h"
#include "text.h"

#include <csignal>
#include <cstdio>
#include <new>
#include <system_error>
#include <unistd.h>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace {

using namespace lixel;
using namespace lixel::app;

bool hasTerminal = false; // a progress bar may stand in the line

// Ctrl-C: what is half-written goes, the rest stays.
extern "C" void onInterrupt(int signal)
{
    if (!removePendingFiles(signal)) return;
    constexpr char kMessage[] = "\nlixel: interrupted\n";
    const int skipped = hasTerminal ? 0 : 1;
    if (write(STDERR_FILENO, kMessage + skipped, sizeof kMessage - 1 - std::size_t(skipped)) < 0) _exit(kInterrupted);
    _exit(kInterrupted);
}

// One line, whatever names are in it. Standard error may be closed: then the code has to say it.
int fail(int code, const std::string& message)
{
    std::fputs(("lixel: " + oneLine(message) + "\n").c_str(), stderr);
    return code;
}

// The options' own messages leave open what the first word should have been.
std::string usageMessage(const CLI::App& app, const CLI::ParseError& error, int argc, char** argv)
{
    std::string chosen;
    for (auto at = app.get_subcommands(); !at.empty(); at = at.front()->get_subcommands())
        chosen += at.front()->get_name() + " ";
    if (!chosen.empty()) return fmt::format("{} (lixel {}--help)", error.what(), chosen);
    std::string known;
    for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
        known += (known.empty() ? "" : ", ") + command->get_name();
    if (argc > 1 && argv[1][0] != '-') return fmt::format("\"{}\": no such command (known: {})", argv[1], known);
    return argc > 1 ? fmt::format("{} (lixel --help)", error.what())
                    : fmt::format("a command is expected: {} (lixel --help)", known);
}

int run(int argc, char** argv)
{
    const std::string commandLine = quoted(argc, argv);
    CLI::App app{"lixel: shadow maps that put their samples where the picture needs them, judged by exact visibility",
                 "lixel"};
    app.set_version_flag("--version", "lixel " LIXEL_VERSION);
    app.require_subcommand(1);
    const std::vector<Command> commands{addRender(app),
                                        addCompare(app, commandLine),
                                        addReproduce(app, commandLine),
                                        addStudy(app, commandLine),
                                        addMerge(app, commandLine),
                                        addBench(app, commandLine),
                                        addTechniques(app),
                                        addScenes(app)};
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& success) { // --help, --version
        return app.exit(success);
    } catch (const CLI::ParseError& error) {
        throw UsageError(usageMessage(app, error, argc, argv));
    }
    for (const Command& command : commands)
        if (command.app->parsed()) return command.run();
    return kDone;
}

} // namespace

int main(int argc, char** argv)
{
    hasTerminal = isatty(STDERR_FILENO) == 1;
    for (const int signal : {SIGINT, SIGTERM, SIGQUIT}) std::signal(signal, onInterrupt);
    if (std::signal(SIGHUP, onInterrupt) == SIG_IGN) std::signal(SIGHUP, SIG_IGN); // nohup
    std::signal(SIGPIPE, SIG_IGN); // a reader that goes away is an error of writing
    try {
        const int code = run(argc, argv);
        finishPrinting();
        return code;
    } catch (const UsageError& error) {
        return fail(kBadUsage, error.what());
    } catch (const InputError& error) {
        return fail(kBadInput, error.what());
    } catch (const OutputError& error) {
        return fail(kFailed, error.what());
    } catch (const RefusedError& error) {
        return fail(kRefused, error.what());
    } catch (const gl::GraphicsError& error) {
        const std::string said = error.what();
        const bool namesTheOther = said.find("--executor trace") != said.npos;
        return fail(kNoGraphics, said + (namesTheOther ? "" : "; --executor trace needs no graphics"));
    } catch (const std::system_error& error) { // from printing a page that is longer than the buffer
        return fail(kFailed, fmt::format("standard output: cannot be written: {}", error.code().message()));
    } catch (const std::bad_alloc&) {
        return fail(kFailed, "out of memory; a smaller --size or --lixels needs less");
    } catch (const std::exception& error) {
        return fail(kFailed, error.what());
    }
}
