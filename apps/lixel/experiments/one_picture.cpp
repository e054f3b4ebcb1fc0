// SPDX-License-Identifier: MIT
#include "experiments/one_picture.h"

#include "lixel/scene/framing.h"
#include "lixel/trace/parallel.h"
#include "lixel/trace/view_rays.h"

#include <algorithm>
#include <atomic>

namespace lixel::app {
namespace {

Shooting shootingOf(const std::string& scene, const std::string& viewName, const std::string& size)
{
    PictureOptions picture;
    picture.scene = scene;
    picture.view = viewName;
    picture.size = size;
    return prepare(picture, false);
}

} // namespace

OnePicture::OnePicture(const std::string& scene, const std::string& viewName, const std::string& size,
                       Executor& executor)
    : shooting(shootingOf(scene, viewName, size)),
      stage(makeStage(shooting.scene, shooting.evaluateOptions, originOf(shooting, shot()))),
      view(viewOf(shooting, shot())),
      samples(executor.viewSamples(stage, view)),
      truth(findTruth(stage, samples, shot().lights, shooting.planes))
{
}

FramePlan OnePicture::planOf(const std::string& technique, LixelSize lixels, Executor& executor) const
{
    LixelBudget budget;
    budget.total = lixels;
    return *planFor(readTechniques(technique).front(), {stage, view, shot().lights, shooting.planes, samples}, budget,
                    executor);
}

std::int64_t fragmentsOf(const Stage& stage, const View& view)
{
    const TraceScene& scene = *stage.traced;
    const ViewRays rays(view, scene.originWorld());
    struct Counting
    {
        const TraceScene& scene;
        Ray ray;
        double tFar;
        std::int64_t met = 0;
    };
    const auto count = [](void* query, std::uint32_t triangle) {
        Counting& counting = *static_cast<Counting*>(query);
        const auto hit = intersect(counting.ray, counting.scene.corners(triangle));
        if (hit && hit->t <= counting.tFar && counting.scene.keeps(triangle, float(hit->u), float(hit->v)))
            ++counting.met;
        return false;
    };
    std::atomic<std::int64_t> all = 0;
    forEachBlock(std::size_t(view.height), 8, [&](std::size_t first, std::size_t last) {
        for (std::size_t y = first; y < last; ++y)
            for (int x = 0; x < view.width; ++x) {
                const auto ray = rays.through({x + 0.5, double(y) + 0.5});
                if (!ray) continue;
                Counting counting{scene, {ray->origin, ray->direction, 0, {}}, ray->tFar};
                const Interval inScene = clipToBox(ray->origin, ray->direction, scene.searchBoxLocal(), {0, ray->tFar});
                scene.embree().anyBlocks(searchRay(ray->origin, ray->direction, inScene), count, &counting);
                all += counting.met;
            }
    });
    return all;
}

} // namespace lixel::app
