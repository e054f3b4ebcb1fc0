// SPDX-License-Identifier: MIT
#pragma once

#include <csignal>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

// The command line as a user has it: the built executable in a process of its own, without a shell.
namespace lixel::test {

struct CommandOptions
{
    std::filesystem::path folder;                             // to run in; empty: this process's
    std::map<std::string, std::string> environment;           // besides this process's
    std::filesystem::path printTo;                            // standard output goes there; empty: into the result
    bool hasNoReader = false;                                 // standard output is a pipe whose reader is gone
    std::function<bool()> interruptWhen;                      // asked again and again; then it gets one signal
    int signal = SIGINT;                                      // as by Ctrl-C
    int terminalColumns = 0;                                  // standard error is a terminal so wide; 0: a file
    std::function<bool(std::string_view)> interruptWhenShown; // as interruptWhen, given what the terminal has got
};

struct CommandResult
{
    int exitCode = -1; // 128 + signal where one ended it
    std::string out, err;
    double cpuSeconds = 0; // of all its threads: other work on the machine does not count
};

CommandResult runLixel(const std::vector<std::string>& arguments, const CommandOptions& options = {});

// Nothing where OpenGL works here, else what the command line says; throws where LIXEL_REQUIRE_GL=1 wants it to work.
std::string missingGraphics(const std::filesystem::path& folder);

// "lixel a b c", for messages.
std::string asTyped(const std::vector<std::string>& arguments);

} // namespace lixel::test
