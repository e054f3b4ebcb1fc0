// SPDX-License-Identifier: MIT
#include "one_light.h"

#include "lixel/plan/need.h"
#include "lixel/plan/observe.h"
#include "lixel/trace/exact_visibility.h"

#include <algorithm>

namespace lixel::app {

StudiedPicture::StudiedPicture(const Shooting& of, const Shot& shot, Executor& by)
    : shooting(of),
      executor(by),
      stage(makeStage(of.scene, of.evaluateOptions, originOf(of, shot))),
      view(viewOf(of, shot)),
      samples(by.viewSamples(stage, view))
{
}

OneLight::OneLight(const StudiedPicture& picture, const Light& light)
    : picture_(picture),
      lights_{light},
      exact_(exactVisibility(*picture.stage.traced, picture.samples, light)),
      zones_(zonesOf(picture.samples, light, exact_))
{
}

std::int64_t OneLight::lightFacing() const
{
    return std::ranges::count_if(zones_, [](Zone zone) { return zone != Zone::FacingAway; });
}

void OneLight::drawLastFrame(LixelSize lixels)
{
    const FramePlan standard = plan(readTechniques("focused").front(), lixels, {});
    before_ = picture_.executor.run(picture_.stage, standard, picture_.samples);
    for (Visibility& v : before_) v.value.resize(picture_.samples.size(), 0.0f); // refused: nothing is seen of it
}

PlanMemory OneLight::lastFrame(ObservationGrid grid) const
{
    PlanMemory memory;
    memory.observed = observe(picture_.samples, picture_.view, lights_, before_, gridWithin(grid, picture_.view));
    memory.observed->ageFrames = 1;
    return memory;
}

std::vector<NeedSample> OneLight::boundary() const
{
    const ObservationGrid pixels{picture_.view.width, picture_.view.height};
    const std::vector<Visibility> exact{{exact_, {}}};
    const Observation observed = observe(picture_.samples, picture_.view, lights_, exact, pixels);
    NeedSource source;
    source.observed = &observed;
    source.view = &picture_.view;
    BoundaryDirections directions;
    std::vector<NeedSample> out;
    gatherNeedSamples(source, light(), picture_.samples.originWorld, directions, out,
                      {observed.samples.size(), 0, 0, true});
    return out;
}

FramePlan OneLight::plan(const TechniqueChoice& choice, LixelSize lixels, const PlanMemory& known) const
{
    const PlanSubject subject{picture_.stage, picture_.view, lights_, picture_.shooting.planes, picture_.samples};
    LixelBudget budget;
    budget.total = lixels;
    return planFor(choice, subject, budget, picture_.executor, known).value();
}

Score OneLight::score(const FramePlan& plan) const
{
    const std::vector<Visibility> found = picture_.executor.run(picture_.stage, plan, picture_.samples);
    return lixel::score(zones_, found.front(), exact_);
}

std::optional<Score> OneLight::score(const TechniqueChoice& choice, LixelSize lixels, const PlanMemory& known) const
{
    const FramePlan found = plan(choice, lixels, known);
    if (found.lights.front().refused) return std::nullopt;
    return score(found);
}

} // namespace lixel::app
