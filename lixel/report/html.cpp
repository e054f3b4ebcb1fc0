// SPDX-License-Identifier: MIT
#include "lixel/report/html.h"

#include "lixel/report/base64.h"
#include "lixel/report/false_colour.h"
#include "lixel/report/json.h"
#include "lixel/report/png.h"
#include "lixel/report/write_file.h"

#include "generated/reportPage.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <span>
#include <stdexcept>
#include <tuple>

namespace fs = std::filesystem;

namespace lixel {
namespace {

// JSON in a script element ends where "</script" stands, or is lost in "<!--": neither can, without a "<". In JSON it
// only stands inside strings, where it has a longer spelling.
std::string safeInScript(const std::string& json)
{
    std::string safe;
    safe.reserve(json.size());
    for (const char c : json)
        if (c == '<') safe += "\\u003c";
        else safe += c;
    return safe;
}

std::string cssColour(Rgba8 c) { return fmt::format("\"#{:02x}{:02x}{:02x}\"", c.r, c.g, c.b); }

// The colours of the pictures, for the legends.
std::string coloursJson()
{
    constexpr int kSteps = 8; // of the scale's picture, an octave
    std::string density;
    for (int i = -kDensityOctaves * kSteps; i <= kDensityOctaves * kSteps; ++i)
        density += (density.empty() ? "" : ",") + cssColour(densityColour(std::exp2(double(i) / kSteps)));
    return fmt::format(R"({{"false_shadow":{},"false_lit":{},"boundary":{},"density_octaves":{},"density":[{}]}})",
                       cssColour(verdictColour(Verdict::FalseShadow)), cssColour(verdictColour(Verdict::FalseLit)),
                       cssColour(kBoundaryColour), kDensityOctaves, density);
}

// The pixels that differ from `base`, the others transparent; the picture again is `base` with this over it.
Image<Rgba8> differenceOver(const Image<Rgba8>& base, const Image<Rgba8>& picture)
{
    Image<Rgba8> difference = picture;
    for (std::size_t i = 0; i < picture.data().size(); ++i)
        if (picture.data()[i] == base.data()[i]) difference.data()[i] = {0, 0, 0, 0};
    return difference;
}

std::string bytesOf(const fs::path& path)
{
    std::ifstream file(path, std::ios::binary);
    if (!file) throw std::runtime_error(path.string() + ": cannot be opened");
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

bool canBeOver(const Image<Rgba8>& base, const Image<Rgba8>& picture)
{
    const auto isOpaque = [](Rgba8 pixel) { return pixel.a == 255; };
    return base.width() == picture.width() && base.height() == picture.height() &&
           std::all_of(picture.data().begin(), picture.data().end(), isOpaque);
}

// Writes the pictures as script elements that the page decodes when it shows them. The shaded pictures of one view
// differ only along shadows: all but an executor's first are told as their difference from it, where that is smaller.
class PictureWriter
{
public:
    PictureWriter(AtomicFile& file, const fs::path& folder) : file_(file), folder_(folder) {}

    void write(const std::string& id, const fs::path& file) { writeElement(id, "", bytesOf(folder_ / file)); }

    void write(std::size_t row, const ResultRow& of)
    {
        const Measurement* measured = of.measured();
        if (!measured) return;
        const PictureFiles& pictures = measured->pictures;
        if (!pictures.shaded.empty()) writeShaded(row, of, folder_ / pictures.shaded);
        writeOverlay(row, "error", pictures.error);
        writeOverlay(row, "footprint", pictures.footprint);
        writeOverlay(row, "density", pictures.density);
        writeOverlay(row, "boundary", pictures.boundary);
    }

private:
    struct Base
    {
        std::string id;
        Image<Rgba8> picture;
    };

    static std::string idOf(std::size_t row, std::string_view kind) { return fmt::format("picture-{}-{}", row, kind); }

    void writeOverlay(std::size_t row, std::string_view kind, const std::string& file)
    {
        if (!file.empty()) writeElement(idOf(row, kind), "", bytesOf(folder_ / file));
    }

    void writeShaded(std::size_t row, const ResultRow& of, const fs::path& path)
    {
        const auto view = std::tuple(of.scene, of.view, of.light, of.size);
        if (view != view_) bases_.clear();
        view_ = view;
        const std::string whole = bytesOf(path);
        Image<Rgba8> picture = decodePng(whole, path.string());
        const auto base = bases_.find(of.executor);
        if (base == bases_.end()) {
            writeElement(idOf(row, "shaded"), "", whole);
            bases_.emplace(of.executor, Base{idOf(row, "shaded"), std::move(picture)});
            return;
        }
        const std::string difference =
            canBeOver(base->second.picture, picture) ? encodePng(differenceOver(base->second.picture, picture)) : whole;
        if (difference.size() < whole.size()) writeElement(idOf(row, "shaded"), base->second.id, difference);
        else writeElement(idOf(row, "shaded"), "", whole);
    }

    void writeElement(const std::string& id, const std::string& over, const std::string& png)
    {
        file_.write(fmt::format("<script type=\"text/plain\" id=\"{}\"", id));
        if (!over.empty()) file_.write(fmt::format(" data-over=\"{}\"", over));
        file_.write(">" + toBase64(png) + "</script>\n");
    }

    AtomicFile& file_;
    fs::path folder_;
    std::tuple<std::string, std::string, std::string, std::string> view_; // with light and size
    std::map<std::string, Base> bases_;                                   // of that view, by executor
};

// Writes the template, and for each {{name}} in it what `write(name)` writes.
void fillTemplate(AtomicFile& file, std::string_view text, const std::function<void(std::string_view)>& write)
{
    while (true) {
        const std::size_t open = text.find("{{");
        file.write(text.substr(0, open));
        if (open == std::string_view::npos) return;
        const std::size_t close = text.find("}}", open);
        LX_ASSERT(close != std::string_view::npos);
        write(text.substr(open + 2, close - open - 2));
        text.remove_prefix(close + 2);
    }
}

// The page numbers rows as the JSON has them. `page` is the template's name.
void writePage(const fs::path& folder, const std::string& json, std::vector<ResultRow> rows,
               std::string_view page = "report.html", std::span<const PlateRow> plates = {})
{
    sortByKey(rows);
    AtomicFile file(folder / "report.html");
    PictureWriter pictures(file, folder);
    const std::map<std::string_view, std::function<void()>> parts{
        {"results", [&] { file.write(safeInScript(json)); }},
        {"colours", [&] { file.write(coloursJson()); }},
        {"pictures",
         [&] {
             for (std::size_t row = 0; row < rows.size(); ++row) pictures.write(row, rows[row]);
             for (std::size_t i = 0; i < plates.size(); ++i)
                 for (std::size_t j = 0; j < plates[i].plates.size(); ++j)
                     pictures.write(fmt::format("plate-{}-{}", i, j), plates[i].plates[j].file);
         }},
    };
    fillTemplate(file, textNamed(reportPage(), page), [&](std::string_view name) {
        if (const auto part = parts.find(name); part != parts.end()) part->second();
        else file.write(textNamed(reportPage(), name));
    });
    file.commit();
}

} // namespace

void writeReport(const fs::path& folder, const RunResults& results)
{
    writePage(folder, toJson(results), results.rows);
}

void writeReport(const fs::path& folder, const Reproduction& reproduction)
{
    writePage(folder, toJson(reproduction), reproduction.run.rows, "report.html", reproduction.plates);
}

void writeReport(const fs::path& folder, const PlaneBudget& study) { writePage(folder, toJson(study), study.run.rows); }

void writeReport(const fs::path& folder, const LookupStudy& study) { writePage(folder, toJson(study), study.run.rows); }

void writeReport(const fs::path& folder, const SweepResults& sweep)
{
    writePage(folder, toJson(sweep), {}, "sweep.html");
}

void writeReport(const fs::path& folder, const BenchResults& bench)
{
    writePage(folder, toJson(bench), {}, "bench.html");
}

} // namespace lixel
