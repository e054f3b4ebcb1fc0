// SPDX-License-Identifier: MIT
#include "sweep/sweep_run.h"

#include "comparison.h"
#include "exit_code.h"
#include "lixel/report/sweep.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace lixel::app {

// One view of one size at one time.
struct SweepRun::Picture
{
    SweepGroup group; // one of those that it serves
    Shooting shooting;
    Shot shot;
    Stage stage;
    View view;
    ViewSamples samples;

    bool serves(const SweepGroup& other) const
    {
        return group.scene == other.scene && group.viewOfFile == other.viewOfFile && group.time == other.time &&
               group.size == other.size && group.view == other.view;
    }
};

// The same with lights.
struct SweepRun::Lit
{
    SweepGroup group;
    Shot shot;
    Truth truth;
};

namespace {

Shot shotNamed(const SweepFile& file, const SweepGroup& group, const Shooting& shooting)
{
    for (const Shot& shot : shooting.shots)
        if (shot.name == group.view) return shot;
    refuseAt(file, fmt::format("/scenes/{}", group.scene),
             fmt::format("view \"{}\" is not there any more", group.view));
}

// Refused for the scene, not for a light of it: its planes are not there.
std::vector<ResultRow> refusedRows(const ShotContext& context, const TechniqueChoice& choice, const std::string& why,
                                   std::string_view executor)
{
    std::vector<ResultRow> rows;
    for (std::size_t light = 0; light < context.shot.lights.size(); ++light) {
        rows.push_back(keyOf(context, choice, light, executor));
        rows.back().outcome = Refusal{"no-such-plane", why};
    }
    return rows;
}

} // namespace

SweepRun::SweepRun(const SweepFile& file, const SweepPlan& plan, SceneShelf& shelf)
    : file_(file), plan_(plan), shelf_(shelf)
{
    executors_.push_back(makeExecutor(file.executor));
}

SweepRun::~SweepRun() = default;

SweepRun::Lit& SweepRun::litFor(const SweepGroup& group)
{
    if (!picture_ || !picture_->serves(group)) {
        lit_ = nullptr;
        Shooting shooting = shootingOf(file_, group, shelf_);
        const Shot shot = shotNamed(file_, group, shooting);
        const Vec3d origin = originOf(shooting, shot);
        const bool isSameStage = picture_ && picture_->group.scene == group.scene &&
                                 picture_->group.time == group.time &&
                                 picture_->shooting.evaluateOptions.time == shooting.evaluateOptions.time &&
                                 picture_->stage.buffers.triangles.originWorld == origin;
        Stage stage = isSameStage ? std::move(picture_->stage) : Stage();
        picture_ = nullptr;
        if (!isSameStage) stage = makeStage(shooting.scene, shooting.evaluateOptions, origin);
        const View view = viewOf(shooting, shot);
        ViewSamples samples = executors_.front()->viewSamples(stage, view);
        picture_ = std::make_unique<Picture>(
            Picture{group, std::move(shooting), shot, std::move(stage), view, std::move(samples)});
    }
    if (!lit_ || !(lit_->group == group)) {
        Shot shot = picture_->shot;
        shot.lights = file_.lights[group.lights].of(shot.lights, file_.seed);
        Truth truth = findTruth(picture_->stage, picture_->samples, shot.lights, picture_->shooting.planes);
        lit_ = std::make_unique<Lit>(Lit{group, std::move(shot), std::move(truth)});
    }
    return *lit_;
}

std::vector<std::string> SweepRun::measure(const SweepCell& cell)
{
    const SweepGroup& group = plan_.groups[cell.group];
    const Lit& lit = litFor(group);
    ComparisonOptions options;
    options.techniques = {file_.techniques[cell.technique]};
    options.lixels = file_.lixels[cell.budget];
    options.timingFrames = file_.timingFrames;
    const Picture& p = *picture_;
    const ShotContext context{p.shooting, lit.shot, p.stage, p.view, p.samples, lit.truth, options};
    std::vector<ResultRow> rows;
    std::string missingPlane;
    try {
        expectPlanes(options.techniques, p.shooting);
    } catch (const UsageError& error) {
        missingPlane = error.what();
    }
    rows = missingPlane.empty()
               ? compareTechniques(context, executors_, [](std::string_view) {})
               : refusedRows(context, options.techniques.front(), missingPlane, executors_.front()->name());
    LX_ASSERT(rows.size() == cell.rows);

    std::vector<std::string> lines;
    for (std::size_t light = 0; light < rows.size(); ++light) {
        ResultRow& row = rows[light];
        row.seed = plan_.seed;
        row.lixels = cell.lixels;
        lines.push_back(sweepRowLine(row,
                                     {cell.firstRow + light, plan_.keyOf(cell, light), group.timeSeconds,
                                      plan_.lights[group.lights], cell.rows,
                                      std::uint64_t(p.stage.buffers.triangles.triangleCount()), host()},
                                     plan_.lixelVersion));
    }
    return lines;
}

} // namespace lixel::app
