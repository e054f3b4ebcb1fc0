// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>

namespace CLI {
class App;
}

// The commands of the command line. Each adds its options to `parent` and returns what runs when it was chosen; the returned
// function gives an exit code or throws InputError, UsageError, OutputError, gl::GraphicsError, RefusedError.
namespace lixel::app {

struct Command
{
    CLI::App* app = nullptr;
    std::function<int()> run;
};

// `commandLine` repeats the run.
Command addRender(CLI::App& parent);
Command addCompare(CLI::App& parent, const std::string& commandLine);
Command addReproduce(CLI::App& parent, const std::string& commandLine);
Command addStudy(CLI::App& parent, const std::string& commandLine);
Command addBench(CLI::App& parent, const std::string& commandLine);
Command addMerge(CLI::App& parent, const std::string& commandLine);
Command addTechniques(CLI::App& parent);
Command addScenes(CLI::App& parent);

} // namespace lixel::app
