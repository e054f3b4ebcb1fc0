// SPDX-License-Identifier: MIT
#include "comparison.h"
#include "experiments/enlarged_square.h"
#include "experiments/now_plates.h"
#include "experiments/now_settings.h"
#include "lixel/plan/warp/texture_warp.h"
#include "lixel/report/png.h"
#include "lixel/scene/framing.h"
#include "lixel/trace/trace_executor.h"
#include "run_results.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>

// Milet, Navratil and Zemcik 2015: Figures 4 to 6, what warps do to a map; the teaser and Figure 7, what is wrong in pictures; and, in
// numbers, what section 4 says in words: that desired view and minimal shadow frustum suffice where a small part of the scene is
// visible, and warps are better where more is. How much is visible is told by narrowing the cameras of the same pictures.
namespace lixel::app {
namespace {

constexpr std::array kFovy{10.0, 25.0, 50.0, 80.0}; // degrees
constexpr const char* kUnsmoothed =
    "desired-view+now(importance=count,power=1,smooth=0,floor=0,lines=nearest,raster=tessellate)";
// Of the map over the whole scene, the rectangle around what is seen.
constexpr std::array<double, 3> kSharesBelow{0.05, 0.3, std::numeric_limits<double>::infinity()};
constexpr std::array<const char*, 3> kShareNames{"less than 5 %", "5 to 30 %", "more than 30 %"};

struct Taken
{
    Shooting shooting;
    Stage stage;
    View view;
    ViewSamples samples;

    Taken(const PictureOptions& picture, Executor& executor)
        : shooting(prepare(picture, false)),
          stage(makeStage(shooting.scene, shooting.evaluateOptions, originOf(shooting, shooting.shots.front()))),
          view(viewOf(shooting, shooting.shots.front())),
          samples(executor.viewSamples(stage, view))
    {
        shooting.shots.front().lights.resize(1);
    }
    Shot& shot() { return shooting.shots.front(); }
    const Light& light() const { return shooting.shots.front().lights.front(); }
};

// The share of a map over the whole scene that the samples' upright rectangle has; nothing where no one map holds them.
std::optional<double> visibleShare(const FramePlan& uniform, const Taken& taken)
{
    if (uniform.lights.front().refused) return std::nullopt;
    const std::vector<Vec2d> places =
        placesInSquare(uniform.lights.front().regions.front(), taken.samples, taken.light());
    if (places.empty()) return std::nullopt;
    Vec2d least{1, 1}, greatest{0, 0};
    for (const Vec2d& p : places) {
        least = {std::min(least.x, p.x), std::min(least.y, p.y)};
        greatest = {std::max(greatest.x, p.x), std::max(greatest.y, p.y)};
    }
    return (greatest.x - least.x) * (greatest.y - least.y);
}

Vec2d movedByRows(const shared::ShadowWarp& row, const TextureWarp& warp, Vec2d p)
{
    const auto x = shared::lxAlongLine(shared::lxRowLines(row, float(p.y)), warp.columns, float(p.x), knotsOf(warp));
    return {x.value, p.y};
}

std::vector<double> samplesOfColumns(std::span<const Vec2d> places, int columns,
                                     const std::function<Vec2d(Vec2d)>& move)
{
    std::vector<double> samples(std::size_t(columns), 0.0);
    for (const Vec2d& place : places) ++samples[std::size_t(std::clamp(int(move(place).x * columns), 0, columns - 1))];
    return samples;
}

// Standard deviation over the mean.
double variation(const std::vector<double>& values)
{
    double sum = 0, squares = 0;
    for (const double value : values) sum += value, squares += value * value;
    const double mean = sum / double(values.size());
    return mean > 0 ? std::sqrt(std::max(0.0, squares / double(values.size()) - mean * mean)) / mean : 0;
}

class NowFigures
{
public:
    explicit NowFigures(const ExperimentOptions& options) : options_(options), scenes_(nowScenes(options, leftOut_))
    {
        executors_.push_back(makeExecutor(options.executor));
        std::string list;
        for (const NowMethod& method : kNowMethods)
            list += fmt::format("{}{}", list.empty() ? "" : ",", method.technique);
        comparison_.techniques = readTechniques(list);
        comparison_.lixels.total = options.isQuick ? LixelSize{128, 128} : LixelSize{512, 512};
        comparison_.timingFrames = 0;
        comparison_.footprintStep = 64;
    }
    Reproduction run();

private:
    void takeAll(const NowScene& scene);
    void addPicture(const NowScene& scene, Taken& taken, double fovy, bool isShown);
    void addPlates(const NowScene& scene, Taken& taken);
    void addMaps(const NowScene& scene, Taken& taken);
    FramePlan planOf(const char* technique, const Taken& taken);
    Plate write(const std::string& name, const std::string& title, const Image<Rgba8>& picture) const;
    void addNumbers();

    const ExperimentOptions& options_;
    std::string leftOut_;
    std::vector<NowScene> scenes_;
    std::vector<std::unique_ptr<Executor>> executors_;
    ComparisonOptions comparison_;
    struct Picture
    {
        double share;                                         // of the scene's map that is seen
        std::array<double, kNowMethods.size()> misclassified; // percent
    };
    std::vector<Picture> pictures_;
    ReproducedTable table_;
    int leftOutPictures_ = 0;
    Reproduction out_;
};

FramePlan NowFigures::planOf(const char* technique, const Taken& taken)
{
    const PlanSubject subject{taken.stage, taken.view, taken.shooting.shots.front().lights, taken.shooting.planes,
                              taken.samples};
    return *planFor(readTechniques(technique).front(), subject, comparison_.lixels, *executors_.front());
}

Plate NowFigures::write(const std::string& name, const std::string& title, const Image<Rgba8>& picture) const
{
    const std::string file = name + ".png";
    writePng(options_.pictures / file, picture);
    return {title, file};
}

// Figures 4 and 5.
void NowFigures::addPlates(const NowScene& scene, Taken& taken)
{
    const FramePlan smooth = planOf(kNowMethods[NowOurs].technique, taken), raw = planOf(kUnsmoothed, taken);
    if (smooth.lights.front().refused || raw.lights.front().refused) return;
    const PlannedRegion& region = smooth.lights.front().regions.front();
    const TextureWarp &warp = region.warp, &unsmoothed = raw.lights.front().regions.front().warp;
    if (warp.isIdentity()) return;
    const std::vector<Vec2d> places = placesInSquare(region, taken.samples, taken.light());
    const shared::ShadowWarp row = tableRow(warp);
    const auto counted = [&](const std::function<Vec2d(Vec2d)>& move) {
        return countedPlate(places, warp.columns, warp.rows, move);
    };
    const CountedPlate before = counted([](Vec2d p) { return p; });
    const CountedPlate byRows = counted([&](Vec2d p) { return movedByRows(row, warp, p); });
    const CountedPlate byBoth = counted([&](Vec2d p) {
        const shared::vec2 at = shared::lxWarped(row, {float(p.x), float(p.y)}, knotsOf(warp)).at;
        return Vec2d{at.x, at.y};
    });
    const std::string title = scene.title();
    const shared::ShadowWarp rawRow = tableRow(unsmoothed);
    const auto columnsOf = [&](const std::function<Vec2d(Vec2d)>& move) {
        return variation(samplesOfColumns(places, warp.columns, move));
    };
    out_.numbers.push_back({title + ": samples of columns, variation before warping", "deviation over mean",
                            columnsOf([](Vec2d p) { return p; }), std::nullopt, "Figure 3"});
    out_.numbers.push_back({title + ": samples of columns, variation after the rows", "deviation over mean",
                            columnsOf([&](Vec2d p) { return movedByRows(rawRow, unsmoothed, p); }), std::nullopt,
                            "Figure 3"});
    for (const auto& [name, plate] : {std::pair("before warping", &before), std::pair("after the rows", &byRows),
                                      std::pair("after the columns", &byBoth)})
        out_.numbers.push_back({fmt::format("{}: cells with view samples, {}", title, name), "percent",
                                100 * plate->usedShare, std::nullopt, "Figure 5"});
    if (options_.pictures.empty()) return;
    const double most = std::max(mostOffset(warp), mostOffset(unsmoothed));
    out_.plates.push_back(
        {fmt::format("Figure 4, {}: the rows' functions; yellow moves to the right, blue to the left", title),
         {write(title + "-importance", "importance map", before.picture),
          write(title + "-rows-unsmoothed", "a function for every row", offsetsPlate(unsmoothed, most)),
          write(title + "-rows", "the same, smoothed", offsetsPlate(warp, most)),
          write(title + "-importance-of-columns", "importance map for the columns", byRows.picture)}});
    const Image<Rgba8> view = executors_.front()->shade(taken.stage, taken.view, taken.shot().lights, taken.samples,
                                                        std::vector<Visibility>(1));
    out_.plates.push_back({fmt::format("Figure 5, {}: view samples over the map; black cells serve nothing", title),
                           {write(title + "-view", "the view", view),
                            {"view samples", title + "-importance.png"},
                            {"moved by rows alone", title + "-importance-of-columns.png"},
                            write(title + "-moved", "moved by rows and columns", byBoth.picture)}});
}

// Figure 6: the maps that rays see.
void NowFigures::addMaps(const NowScene& scene, Taken& taken)
{
    if (options_.pictures.empty()) return;
    PlateRow row{fmt::format("Figure 6, {}: maps", scene.title()), {}};
    for (const std::size_t method : {NowSm, NowRtw, NowOurs, NowOursDv}) {
        const FramePlan plan = planOf(kNowMethods[method].technique, taken);
        if (plan.lights.front().refused) continue;
        const LixelRectangle& r = plan.lights.front().regions.front().rectangle;
        const TracedAtlas atlas = traceAtlas(*taken.stage.traced, plan);
        row.plates.push_back(write(fmt::format("{}-map-{}", scene.title(), method), kNowMethods[method].title,
                                   depthPlate(atlas[std::size_t(r.layer)], r)));
    }
    out_.plates.push_back(std::move(row));
}

// Rows of one picture, its errors beside how much it sees; those that some method refuses do not count.
void NowFigures::addPicture(const NowScene& scene, Taken& taken, double fovy, bool isShown)
{
    taken.shot().name = fmt::format("{}, fovy {:.0f}", taken.shot().name, fovy);
    const auto share = visibleShare(planOf("uniform", taken), taken);
    const Truth truth = findTruth(taken.stage, taken.samples, taken.shot().lights, taken.shooting.planes);
    comparison_.pictures = isShown ? options_.pictures : std::filesystem::path{};
    std::vector<ResultRow> rows =
        compareTechniques({taken.shooting, taken.shot(), taken.stage, taken.view, taken.samples, truth, comparison_},
                          executors_, [](std::string_view) {});
    Picture picture{share.value_or(0), {}};
    const bool areAllServed = std::all_of(rows.begin(), rows.end(), [](const ResultRow& row) {
        return row.measured() && row.measured()->lightFacing > 0;
    });
    if (!share || !areAllServed) {
        ++leftOutPictures_;
        return;
    }
    ReproducedTable::Row told{fmt::format("{}: {:.1f} %", taken.shot().name, 100 * *share), {}};
    for (std::size_t method = 0; method < rows.size(); ++method) {
        const Measurement& m = *rows[method].measured();
        picture.misclassified[method] = 100 * double(m.misclassified) / double(m.lightFacing);
        told.cells.push_back({picture.misclassified[method], std::nullopt});
    }
    if (isShown && !options_.pictures.empty()) {
        PictureRow figure{fmt::format("The teaser and Figure 7: {}", scene.title()),
                          rows.front().scene,
                          rows.front().view,
                          rows.front().light,
                          {}};
        for (const NowMethod& method : kNowMethods) figure.techniques.push_back(method.technique);
        figure.layer = PictureLayer::Error;
        const std::vector<int> everywhere(taken.samples.size(), 0); // planes do not matter here
        enlargeWhereMostIsWrong(readPng(options_.pictures / rows[NowSm].measured()->pictures.error), taken.samples,
                                everywhere, figure);
        out_.figures.push_back(std::move(figure));
    }
    pictures_.push_back(picture);
    table_.rows.push_back(std::move(told));
    for (ResultRow& row : rows) {
        row.seed = options_.seed;
        out_.run.rows.push_back(std::move(row));
    }
}

void NowFigures::takeAll(const NowScene& scene)
{
    for (std::size_t i = 0; i < scene.pictures.size(); ++i)
        for (const double fovy : kFovy) {
            PictureOptions picture = scene.pictures[i];
            picture.flags.fovy = fovy;
            Taken taken(picture, *executors_.front());
            taken.shot().name =
                fmt::format("{}-{}", scene.title(), picture.view.empty() ? fmt::format("{}", i + 1) : picture.view);
            const bool isShown = i == 0 && fovy == 50;
            if (isShown) addPlates(scene, taken), addMaps(scene, taken);
            addPicture(scene, taken, fovy, isShown);
        }
}

// Over the pictures that see as much: the geometric mean of each method's errors over those of the desired view alone.
void NowFigures::addNumbers()
{
    double from = 0;
    for (std::size_t bin = 0; bin < kSharesBelow.size(); ++bin) {
        std::array<double, kNowMethods.size()> logs{};
        int count = 0;
        for (const Picture& picture : pictures_) {
            if (picture.share < from || picture.share >= kSharesBelow[bin]) continue;
            if (std::any_of(picture.misclassified.begin(), picture.misclassified.end(),
                            [](double p) { return p <= 0; }))
                continue; // has no ratio
            ++count;
            for (std::size_t i = 0; i < logs.size(); ++i)
                logs[i] += std::log(picture.misclassified[i] / picture.misclassified[NowOursDv]);
        }
        for (std::size_t i = 0; i < logs.size() && count > 0; ++i)
            out_.numbers.push_back({fmt::format("{} of the map seen, {} pictures: {} over Ours-DV", kShareNames[bin],
                                                count, kNowMethods[i].title),
                                    "ratio of misclassified", std::exp(logs[i] / count), std::nullopt, "section 4"});
        from = kSharesBelow[bin];
    }
}

Reproduction NowFigures::run()
{
    table_.title = "Errors by how much of the whole scene's map is seen";
    table_.unit = "misclassified percent";
    table_.source = "which has words only";
    for (const NowMethod& method : kNowMethods) table_.columns.push_back({method.title, method.technique});
    Progress progress("reproduce", int(scenes_.size()));
    for (const NowScene& scene : scenes_) {
        progress.step(scene.title());
        takeAll(scene);
    }
    addNumbers();
    if (!table_.rows.empty()) out_.tables.push_back(table_);
    out_.run.timing.host = executors_.front()->host();
    out_.parameters = {{"size", options_.isQuick ? "256x256" : "1024x1024"},
                       {"lixels", toString(comparison_.lixels)},
                       {"executor", options_.executor},
                       {"fields of view, degrees", "10, 25, 50, 80"},
                       {"pictures that some method refuses, or that show nothing lit, not counted",
                        fmt::format("{}", leftOutPictures_)},
                       {"seed", fmt::format("{}", options_.seed)}};
    if (!leftOut_.empty())
        out_.parameters.push_back({"scenes left out, since they are not in the folder that --scenes names", leftOut_});
    return std::move(out_);
}

} // namespace

Reproduction reproduceNowFigures(const ExperimentOptions& options) { return NowFigures(options).run(); }

} // namespace lixel::app
