// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace lixel::test {

enum class InBrowser { Usable, Broken, NoBrowser };

// Uses the page as a reader does; report_in_browser.py says what is tried, and on standard error what is wrong.
// LIXEL_REPORT_SCREENSHOTS=folder keeps pictures of the page, in `name` there.
InBrowser useInBrowser(const std::filesystem::path& page, const std::string& name);

} // namespace lixel::test
