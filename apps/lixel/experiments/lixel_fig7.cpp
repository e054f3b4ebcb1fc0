// SPDX-License-Identifier: MIT
#include "comparison.h"
#include "experiment.h"
#include "experiments/enlarged_square.h"
#include "experiments/lixel_fig7_numbers.h"
#include "lixel/report/png.h"
#include "lixel/scene/framing.h"
#include "planning_time.h"
#include "run_results.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include <fmt/format.h>

// Chong and Gortler 2004, section 4 and Figure 7: a floor, a wall and bouncing bunnies under a light that moves, and a scene with
// many more things; a picture of 1024x1024, maps of 512x512 lixels against three of 350x350, 350x350 and 128x128. The camera stands;
// the paper gives no place of it or of the light. Our truth is exact visibility, the paper shows pictures.
namespace lixel::app {
namespace {

constexpr const char* kView = "front"; // straight at the wall, over the floor with all that stands or bounces on it

// The light moves straight from one place to another.
struct Sweep
{
    const char* name;
    const char* title;
    Vec3d fromWorld, toWorld;
};
constexpr std::size_t kSweeps = 4;

struct Scenery
{
    const char* scene;
    std::array<Sweep, kSweeps> sweeps;
};
constexpr std::array<Scenery, 2> kSceneries{
    {{"bunnies",
      {{{"high", "an ordinary view", {5, 11, 6}, {-3, 12, 4}},
        {kElongated, "elongated shadows", {9, 4.2, -2}, {6.8, 2.6, -2.6}},
        {"side", "light from the side", {-11, 8, 3}, {-12, 5.5, 5}},
        {kInFront, "light in front of the camera", {-3, 7, -2.6}, {3, 4.8, -2.6}}}}},
     {"objects",
      {{{"high", "an ordinary view", {8, 16, 9}, {-5, 18, 6}},
        {kElongated, "elongated shadows", {9, 5, -6.5}, {6, 3, -6.9}},
        {"side", "light from the side", {-16, 12, 5}, {-18, 8, 8}},
        {kInFront, "light in front of the camera", {-4, 6, -6.8}, {4, 3.2, -6.8}}}}}}};
constexpr double kAnimationSeconds = 4; // bunnies then repeat

struct Sizes
{
    int frames; // of all sweeps
    const char* picture;
    const char* lixels;
    const char* lixelsOfPlanes;
};
constexpr Sizes kPaperSizes{60, "1024x1024", "512x512", "350x350,350x350,128x128"};
constexpr Sizes kQuickSizes{8, "256x256", "128x128", "87x87,87x87,32x32"};

constexpr int kTimingFrames = 3, kPlanningRuns = 15;

struct Moment
{
    int frame = 0;
    double time = 0; // seconds
    const Sweep* sweep = nullptr;
    Light light;
    bool isShown = false; // among the figures
};

std::vector<Moment> momentsOf(const Scenery& scenery, int frames)
{
    const int ofSweep = frames / int(kSweeps);
    std::vector<Moment> out;
    for (const Sweep& sweep : scenery.sweeps)
        for (int i = 0; i < ofSweep; ++i) {
            const double s = double(i) / std::max(ofSweep - 1, 1);
            Moment moment;
            moment.frame = int(out.size());
            moment.time = kAnimationSeconds * moment.frame / frames;
            moment.sweep = &sweep;
            moment.light.name = sweep.name;
            moment.light.kind = LightKind::Point;
            moment.light.positionWorld = (1 - s) * sweep.fromWorld + s * sweep.toWorld;
            moment.isShown = i == (ofSweep - 1) / 2;
            out.push_back(moment);
        }
    return out;
}

std::string text(Vec3d p) { return fmt::format("({}, {}, {})", p.x, p.y, p.z); }

// Techniques that are asked together.
struct Group
{
    ComparisonOptions options;
    bool isTimed = false, isOfShownOnly = false;
};

// A lixel a pixel for floor, wall and what else they take.
LixelSize twiceThePicture(const char* size)
{
    const LixelSize picture = readSize(size, "size", kMostLixelsASide);
    return {2 * picture.width, 2 * picture.height};
}

// Techniques with as many lixels each, but maps of their own.
class Figure7
{
public:
    explicit Figure7(const ExperimentOptions& options)
        : options_(options),
          sizes_(options.isQuick ? kQuickSizes : kPaperSizes),
          progress_("reproduce", int(kSceneries.size() * (sizes_.frames * kComparedMaps.size() +
                                                          kSweeps * (options.pictures.empty() ? 2 : 3) + kOfLowCamera)))
    {
        executors_.push_back(makeExecutor(options.executor));
        const LixelBudget lixels = readBudget(sizes_.lixels, "lixels", kMostLixelsASide);
        add(fmt::format("uniform,{},lispsm,planes(auto)+plane-optimal", kPerspective), lixels);
        add(kConventional, lixels).isTimed = true;
        add(kPlanes, readBudget(sizes_.lixelsOfPlanes, "lixels", kMostLixelsASide)).isTimed = true;
        add(kPlanesAlone, lixels).isOfShownOnly = true;
        LixelBudget exact;
        exact.total = twiceThePicture(sizes_.picture);
        add(kPlanesExactly, exact).isOfShownOnly = true;
    }

    void addScene(const Scenery& scenery);
    Reproduction finished();

private:
    static constexpr int kOfLowCamera = 3; // techniques

    Group& add(const std::string& techniques, const LixelBudget& lixels)
    {
        Group& group = groups_.emplace_back();
        group.options.techniques = readTechniques(techniques);
        group.options.lixels = lixels;
        return group;
    }
    void addLowCamera(const Scenery& scenery);
    void timePlanning(const PlanSubject& subject, const ResultRow& row);
    std::vector<ResultRow> rowsAt(const Moment& moment, const Shooting& shooting, const Stage& stage);
    void addFigure(const Moment& moment, std::span<const ResultRow> rows, const ViewSamples& samples,
                   const Truth& truth);

    const ExperimentOptions& options_;
    const Sizes& sizes_;
    std::vector<std::unique_ptr<Executor>> executors_;
    std::vector<Group> groups_;
    std::map<std::string, std::vector<double>> planningPercent_; // [scene], of the frame of planes
    Progress progress_;
    Reproduction out_;
};

void Figure7::addScene(const Scenery& scenery)
{
    PictureOptions picture;
    picture.scene = scenery.scene;
    picture.view = kView;
    picture.size = sizes_.picture;
    Shooting shooting = prepare(picture, false);
    Shot& shot = shooting.shots.front();
    const Vec3d origin = originOf(shooting, shot);
    std::optional<Stage> stage;
    for (const Moment& moment : momentsOf(scenery, sizes_.frames)) {
        shot.name = fmt::format("{}-{:02}", scenery.scene, moment.frame); // pictures are named after it
        shot.lights = {moment.light};
        if (!stage || shooting.scene->animate) {
            shooting.evaluateOptions.time = moment.time;
            shooting.sceneWorld = sceneBounds(*shooting.scene, shooting.evaluateOptions);
            stage = makeStage(shooting.scene, shooting.evaluateOptions, origin);
        }
        std::vector<ResultRow> rows = rowsAt(moment, shooting, *stage);
        for (ResultRow& row : rows) {
            row.seed = options_.seed;
            out_.run.rows.push_back(std::move(row));
        }
    }
    addLowCamera(scenery);
}

// The paper's own case for worse shadows, in the scene's view of it and its light.
void Figure7::addLowCamera(const Scenery& scenery)
{
    PictureOptions picture;
    picture.scene = scenery.scene;
    picture.view = kLowCamera;
    picture.size = sizes_.picture;
    Shooting shooting = prepare(picture, false);
    Shot& shot = shooting.shots.front();
    const Stage stage = makeStage(shooting.scene, shooting.evaluateOptions, originOf(shooting, shot));
    const View view = viewOf(shooting, shot);
    shot.name = fmt::format("{}-{}", scenery.scene, kLowCamera);
    ComparisonOptions options;
    options.techniques = readTechniques(fmt::format("{},{},{}", kConventional, kFloor, kFloorAlone));
    options.lixels = readBudget(sizes_.lixels, "lixels", kMostLixelsASide);
    options.timingFrames = 0;
    const ViewSamples samples = executors_.front()->viewSamples(stage, view);
    const Truth truth = findTruth(stage, samples, shot.lights, shooting.planes);
    for (ResultRow& row : compareTechniques({shooting, shot, stage, view, samples, truth, options}, executors_,
                                            [&](std::string_view now) { progress_.step(now); })) {
        row.seed = options_.seed;
        out_.run.rows.push_back(std::move(row));
    }
}

// What the maps of planes take to decide, as a part of the frame that they are drawn in.
void Figure7::timePlanning(const PlanSubject& subject, const ResultRow& row)
{
    const Measurement* m = row.measured();
    if (!m || !m->timing.frameMs) return;
    const TechniqueChoice choice = readTechniques(kPlanes).front();
    const LixelBudget lixels = readBudget(sizes_.lixelsOfPlanes, "lixels", kMostLixelsASide);
    const SceneBuffers& buffers = subject.stage.buffers;
    PlanInput input{subject.view,
                    subject.lights,
                    buffers.bounds.boxesWorld,
                    buffers.triangles.originWorld,
                    std::get<MapTechnique>(choice.technique),
                    lixels.total};
    input.planes = subject.planes;
    input.lixelsOfRegions = lixels.ofRegions;
    planningPercent_[row.scene].push_back(100 * planningMs(input, kPlanningRuns) / *m->timing.frameMs);
}

std::vector<ResultRow> Figure7::rowsAt(const Moment& moment, const Shooting& shooting, const Stage& stage)
{
    const Shot& shot = shooting.shots.front();
    const View view = viewOf(shooting, shot);
    const ViewSamples samples = executors_.front()->viewSamples(stage, view);
    const Truth truth = findTruth(stage, samples, shot.lights, shooting.planes);
    std::vector<ResultRow> rows;
    for (const Group& group : groups_) {
        if (group.isOfShownOnly && !moment.isShown) continue;
        ComparisonOptions options = group.options;
        options.timingFrames = moment.isShown && group.isTimed ? kTimingFrames : 0;
        if (moment.isShown && !group.isOfShownOnly) options.pictures = options_.pictures;
        if (!options.pictures.empty() && &group == &groups_.front())
            options.techniques.push_back({"exact", ExactTechnique{}});
        for (ResultRow& row : compareTechniques({shooting, shot, stage, view, samples, truth, options}, executors_,
                                                [&](std::string_view now) { progress_.step(now); })) {
            if (row.technique == kPlanes && group.isTimed)
                timePlanning({stage, view, shot.lights, shooting.planes, samples}, row);
            rows.push_back(std::move(row));
        }
    }
    if (moment.isShown && !options_.pictures.empty()) addFigure(moment, rows, samples, truth);
    return rows;
}

// As the paper's, which has conventional, perspective and its own maps; then what is right.
void Figure7::addFigure(const Moment& moment, std::span<const ResultRow> rows, const ViewSamples& samples,
                        const Truth& truth)
{
    const ResultRow& first = rows.front();
    PictureRow figure{fmt::format("{}: {}", first.scene, moment.sweep->title),
                      first.scene,
                      first.view,
                      first.light,
                      {kConventional, kPerspective, kPlanes, "exact"}};
    // Where the conventional map gets most wrong: there the paper's figure is looked at.
    for (const ResultRow& row : rows)
        if (const Measurement* m = row.measured(); m && row.technique == kConventional)
            enlargeWhereMostIsWrong(readPng(options_.pictures / m->pictures.error), samples, truth.plane, figure);
    out_.figures.push_back(std::move(figure));
}

Reproduction Figure7::finished()
{
    for (const Scenery& scenery : kSceneries) {
        std::vector<ReproducedNumber> numbers = numbersOfScene(scenery.scene, out_.run.rows);
        out_.numbers.insert(out_.numbers.end(), numbers.begin(), numbers.end());
        const std::vector<ReproducedNumber> times = timingNumbersOf(scenery.scene, out_.run.rows);
        out_.timingNumbers.insert(out_.timingNumbers.end(), times.begin(), times.end());
        if (const std::vector<double>& percent = planningPercent_[scenery.scene]; !percent.empty())
            out_.timingNumbers.push_back({fmt::format("{}: planning of planes, of their frame", scenery.scene),
                                          "percent", *std::max_element(percent.begin(), percent.end()), std::nullopt,
                                          "section 1: \"essentially free\""});
        for (const Sweep& sweep : scenery.sweeps)
            out_.parameters.push_back({fmt::format("{}, light {}", scenery.scene, sweep.name),
                                       fmt::format("from {} to {}", text(sweep.fromWorld), text(sweep.toWorld))});
    }
    out_.run.timing.host = executors_.front()->host();
    out_.parameters.insert(out_.parameters.end(),
                           {{"view", kView},
                            {"frames", fmt::format("{} a scene, {} s of animation", sizes_.frames, kAnimationSeconds)},
                            {"size", sizes_.picture},
                            {"lixels", sizes_.lixels},
                            {"lixels of floor, wall and the rest",
                             fmt::format("{}; as many by need where one of them has no map", sizes_.lixelsOfPlanes)},
                            {"executor", options_.executor},
                            {"seed", fmt::format("{}", options_.seed)}});
    return std::move(out_);
}

} // namespace

Reproduction reproduceLixelFig7(const ExperimentOptions& options)
{
    Figure7 figure(options);
    for (const Scenery& scenery : kSceneries) figure.addScene(scenery);
    return figure.finished();
}

} // namespace lixel::app
