// SPDX-License-Identifier: MIT
#include "run_command.h"

#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <optional>
#include <stdexcept>
#include <sys/ioctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace lixel::test {
namespace {

// The writing end of a pipe without a reader.
std::FILE* pipeToNobody()
{
    int ends[2];
    if (pipe(ends) != 0) return nullptr;
    close(ends[0]);
    return fdopen(ends[1], "w");
}

std::FILE* fileFor(const std::filesystem::path& path, bool hasNoReader)
{
    if (hasNoReader) return pipeToNobody();
    return path.empty() ? std::tmpfile() : std::fopen(path.c_str(), "w+");
}

// Takes what the process prints: into an unnamed file, or to a path.
class Capture
{
public:
    explicit Capture(const std::filesystem::path& path = {}, bool hasNoReader = false)
        : file_(fileFor(path, hasNoReader))
    {
        if (!file_) throw std::runtime_error("no file for what is printed");
    }
    Capture(const Capture&) = delete;
    Capture& operator=(const Capture&) = delete;
    ~Capture() { std::fclose(file_); }

    int descriptor() const { return fileno(file_); }
    std::string text() const
    {
        std::string all;
        char block[4096];
        std::rewind(file_);
        for (std::size_t read; (read = std::fread(block, 1, sizeof block, file_)) > 0;) all.append(block, read);
        return all;
    }

private:
    std::FILE* file_;
};

// A terminal for standard error, which takes what it is given whenever asked.
class Terminal
{
public:
    explicit Terminal(int columns) : host_(posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK))
    {
        if (host_ < 0 || grantpt(host_) != 0 || unlockpt(host_) != 0)
            throw std::runtime_error("no pseudo-terminal here");
        const winsize size{24, static_cast<unsigned short>(columns), 0, 0};
        ioctl(host_, TIOCSWINSZ, &size);
        process_ = open(ptsname(host_), O_RDWR | O_NOCTTY);
        if (process_ < 0) throw std::runtime_error("no pseudo-terminal here");
    }
    Terminal(const Terminal&) = delete;
    Terminal& operator=(const Terminal&) = delete;
    ~Terminal()
    {
        close(process_);
        close(host_);
    }

    int descriptor() const { return process_; }
    const std::string& text()
    {
        char block[4096];
        for (ssize_t got; (got = read(host_, block, sizeof block)) > 0;) text_.append(block, std::size_t(got));
        return text_;
    }

private:
    int host_, process_ = -1;
    std::string text_;
};

// Between fork and exec only calls that are safe there: everything else is prepared before.
[[noreturn]] void become(char* const* arguments, char* const* environment, const char* folder, int out, int err)
{
    if (*folder && chdir(folder) != 0) _exit(126);
    if (dup2(out, STDOUT_FILENO) < 0 || dup2(err, STDERR_FILENO) < 0) _exit(126);
    for (const int signal : {SIGINT, SIGTERM, SIGQUIT, SIGHUP, SIGPIPE}) std::signal(signal, SIG_DFL);
    execve(LIXEL_CLI, arguments, environment);
    _exit(127);
}

std::vector<std::string> environmentWith(const std::map<std::string, std::string>& more)
{
    std::vector<std::string> all;
    for (char** entry = environ; *entry; ++entry) {
        const std::string text = *entry;
        if (!more.contains(text.substr(0, text.find('=')))) all.push_back(text);
    }
    for (const auto& [name, value] : more) {
        std::string entry = name;
        entry.append("=").append(value);
        all.push_back(entry);
    }
    return all;
}

std::vector<char*> pointersTo(std::vector<std::string>& texts)
{
    std::vector<char*> out;
    for (std::string& text : texts) out.push_back(text.data());
    out.push_back(nullptr);
    return out;
}

double seconds(const timeval& time) { return double(time.tv_sec) + 1e-6 * double(time.tv_usec); }

// Waits for its end, and interrupts it once when that is asked for.
void await(pid_t process, const CommandOptions& options, std::optional<Terminal>& terminal, CommandResult& result)
{
    int status = 0;
    rusage used{};
    bool wasInterrupted = false;
    const auto isTime = [&] {
        const bool isShown = terminal && options.interruptWhenShown && options.interruptWhenShown(terminal->text());
        return isShown || (options.interruptWhen && options.interruptWhen());
    };
    while (wait4(process, &status, options.interruptWhen || terminal ? WNOHANG : 0, &used) == 0) {
        if (terminal) terminal->text();
        if (!wasInterrupted && isTime()) wasInterrupted = kill(process, options.signal) == 0;
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    result.exitCode = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    result.cpuSeconds = seconds(used.ru_utime) + seconds(used.ru_stime);
}

} // namespace

CommandResult runLixel(const std::vector<std::string>& arguments, const CommandOptions& options)
{
    const Capture out(options.printTo, options.hasNoReader), err;
    std::optional<Terminal> terminal;
    if (options.terminalColumns > 0) terminal.emplace(options.terminalColumns);
    const int errDescriptor = terminal ? terminal->descriptor() : err.descriptor();
    std::vector<std::string> words{"lixel"};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<std::string> environment = environmentWith(options.environment);
    const std::vector<char*> wordPointers = pointersTo(words), environmentPointers = pointersTo(environment);
    const std::string folder = options.folder.string();

    const pid_t process = fork();
    if (process < 0) throw std::runtime_error("no new process");
    if (process == 0)
        become(wordPointers.data(), environmentPointers.data(), folder.c_str(), out.descriptor(), errDescriptor);
    CommandResult result;
    await(process, options, terminal, result);
    if (options.printTo.empty() && !options.hasNoReader) result.out = out.text();
    result.err = terminal ? terminal->text() : err.text();
    return result;
}

std::string missingGraphics(const std::filesystem::path& folder)
{
    CommandOptions options;
    options.folder = folder;
    const CommandResult probe =
        runLixel({"render", "table", "--size", "8x8", "--lixels", "8x8", "-o", "probe.png"}, options);
    if (probe.exitCode != 4) return "";
    const char* required = std::getenv("LIXEL_REQUIRE_GL");
    if (required && std::string(required) == "1") throw std::runtime_error(probe.err);
    return "no graphics: " + probe.err;
}

std::string asTyped(const std::vector<std::string>& arguments)
{
    std::string line = "lixel";
    for (const std::string& argument : arguments) line.append(" ").append(argument);
    return line;
}

} // namespace lixel::test
