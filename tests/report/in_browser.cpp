// SPDX-License-Identifier: MIT
#include "in_browser.h"

#include <cstdlib>
#include <sys/wait.h>

namespace lixel::test {

InBrowser useInBrowser(const std::filesystem::path& page, const std::string& name)
{
    constexpr int kNoBrowser = 77;
    std::string command = "python3 '" LIXEL_SOURCE_DIR "/tests/report/report_in_browser.py' '" + page.string() + "'";
    if (const char* screenshots = std::getenv("LIXEL_REPORT_SCREENSHOTS"))
        command += " --screenshots '" + std::string(screenshots) + "/" + name + "'";
    const int status = std::system(command.c_str());
    if (!WIFEXITED(status)) return InBrowser::Broken;
    return WEXITSTATUS(status) == 0            ? InBrowser::Usable
           : WEXITSTATUS(status) == kNoBrowser ? InBrowser::NoBrowser
                                               : InBrowser::Broken;
}

} // namespace lixel::test
