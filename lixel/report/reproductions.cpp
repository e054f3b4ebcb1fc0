// SPDX-License-Identifier: MIT
#include "lixel/report/reproductions.h"

#include "lixel/report/json_document.h"
#include "lixel/report/write_file.h"

#include <nlohmann/json.hpp>

#include <fmt/format.h>

namespace lixel {
namespace {

using Json = nlohmann::json;

constexpr int kVersion = 1;

std::string escaped(std::string_view text)
{
    std::string out;
    for (const char c : text) {
        if (c == '&') out += "&amp;";
        else if (c == '<') out += "&lt;";
        else if (c == '>') out += "&gt;";
        else if (c == '"') out += "&quot;";
        else out += c;
    }
    return out;
}

std::string cell(std::string_view text) { return fmt::format("<td>{}</td>", escaped(text)); }

std::string experimentRow(const Reproductions::Entry& entry)
{
    const std::string name = escaped(entry.name);
    const std::string link = entry.leftOut.empty() ? fmt::format("<a href=\"{0}/report.html\">{0}</a>", name) : name;
    const std::string outcome =
        entry.leftOut.empty() ? fmt::format("{:.0f} s", entry.seconds) : "left out: " + entry.leftOut;
    return fmt::format("<tr><td>{}</td>{}{}{}</tr>\n", link, cell(entry.question), cell(entry.paper), cell(outcome));
}

std::string claimRow(const std::string& experiment, const ReproducedClaim& claim)
{
    const char* const look = !claim.holds ? "open" : *claim.holds ? "yes" : "no";
    return fmt::format("<tr>{}{}{}<td class=\"{}\">{}</td></tr>\n", cell(claim.sentence),
                       cell(experiment + ", " + claim.source), cell(claim.measured), look, wordsFor(claim.holds));
}

std::string tally(const Reproductions& all)
{
    int yes = 0, no = 0, open = 0;
    for (const Reproductions::Entry& entry : all.entries)
        for (const ReproducedClaim& claim : entry.claims) ++(!claim.holds ? open : *claim.holds ? yes : no);
    std::string text = fmt::format("{} hold, {} do not", yes, no);
    if (open > 0) text += fmt::format(", {} are not decided by this quick run", open);
    return text + ".";
}

constexpr const char* kHead = R"(<!doctype html>
<html lang="en"><head><meta charset="utf-8"><title>lixel: the papers' experiments</title><style>
body { font: 15px/1.5 system-ui, sans-serif; margin: 2rem auto; max-width: 75rem; padding: 0 1rem; color: #222; background: #fff; }
table { border-collapse: collapse; width: 100%; margin: 0.5rem 0 2rem; }
th, td { text-align: left; vertical-align: top; padding: 0.35rem 0.6rem; border-bottom: 1px solid #ddd; }
code { background: #f2f2f2; padding: 0 0.25rem; } .no { color: #a00; font-weight: 600; } .open { color: #777; }
</style></head><body>
)";

} // namespace

std::string toJson(const Reproductions& all)
{
    Json entries = Json::array(), times = Json::array();
    for (const Reproductions::Entry& entry : all.entries) {
        Json one = {{"name", entry.name},
                    {"paper", entry.paper},
                    {"question", entry.question},
                    {"claims", Json::parse(toJson(entry.claims, false))}};
        if (!entry.leftOut.empty()) one["left_out"] = entry.leftOut;
        entries.push_back(one);
        times.push_back(
            {{"name", entry.name}, {"seconds", entry.seconds}, {"claims", Json::parse(toJson(entry.claims, true))}});
    }
    Json timing = toJson(all.timing);
    timing["experiments"] = times;
    const Json json = {{"version", kVersion},    {"lixel_version", all.lixelVersion},
                       {"command", all.command}, {"quick", all.isQuick},
                       {"experiments", entries}, {"timing", timing}};
    return documentOf(json);
}

void writeReport(const std::filesystem::path& folder, const Reproductions& all)
{
    std::string page = kHead;
    page += fmt::format("<h1>The papers' experiments{}</h1>\n<p><code>{}</code>, {:.0f} s, {}</p>\n",
                        all.isQuick ? ", quick" : "", escaped(all.command), all.timing.totalSeconds,
                        escaped(all.timing.host));
    page += fmt::format("<h2>What the papers say in words</h2>\n<p>{}</p>\n", tally(all));
    page += "<table><tr><th>The "
            "paper</th><th>Where</th><th>Measured</th><th>Holds</th></tr>\n";
    for (const Reproductions::Entry& entry : all.entries)
        for (const ReproducedClaim& claim : entry.claims) page += claimRow(entry.name, claim);
    page +=
        "</table>\n<h2>Experiments</h2>\n<table><tr><th>Name</th><th>Question</th><th>Paper</th><th>Run</th></tr>\n";
    for (const Reproductions::Entry& entry : all.entries) page += experimentRow(entry);
    page += "</table>\n</body></html>\n";
    writeFileAtomically(folder / "report.html", page);
}

} // namespace lixel
