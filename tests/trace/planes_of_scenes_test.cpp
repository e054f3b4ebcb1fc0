// SPDX-License-Identifier: MIT
// Planes found in pictures of whole scenes.
#include "lixel/plan/partition/find_planes.h"
#include "lixel/scene/builtin.h"
#include "lixel/scene/evaluate.h"
#include "lixel/scene/framing.h"
#include "lixel/trace/trace_view_samples.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace lixel {
namespace {

// What a named view sees of its scene, as far as it faces its first light.
struct Seen
{
    Seen(const Scene& scene, const TraceScene& traced, const NamedView& view)
    {
        const Vec3d origin = traced.originWorld();
        const View camera = makeView(view.camera, 256, 256, sceneBounds(scene, {}));
        const ViewSamples samples = traceViewSamples(traced, camera);
        for (std::size_t i = 0; i < samples.size(); ++i) {
            const Vec3d p = toDouble(samples.positionLocal[i]), normal = toDouble(samples.normal[i]);
            if (!isLightFacing(view.lights[0], origin, p, normal)) continue;
            pointsLocal.push_back(p);
            normals.push_back(normal);
        }
        pixelSize = pixelSizeLocal(camera, origin);
        for (const NamedPlane& plane : scene.planes)
            namedLocal.push_back(planeThrough(plane.pointWorld - origin, normalized(plane.normalWorld)));
        PlaneScratch scratch;
        findPlanes({pointsLocal, normals, {}, pixelSize}, scratch, found);
    }

    // To a thousandth of a pixel, and to what floats can tell so far from the origin.
    bool isAt(Vec3d p, const Plane& plane) const
    {
        return std::abs(plane.signedDistance(p)) < 1e-3 * dot(pixelSize, point(p)) + 0x1p-22 * length(p);
    }
    double shareOf(const Plane& plane) const
    {
        double count = 0;
        for (std::size_t i = 0; i < normals.size(); ++i)
            count += dot(normals[i], plane.normal) > 0.999 && isAt(pointsLocal[i], plane) ? 1 : 0;
        return count / double(normals.size());
    }
    bool isFound(const Plane& plane) const
    {
        return std::any_of(found.begin(), found.end(), [&](const FoundPlane& f) {
            return std::all_of(f.cornersLocal.begin(), f.cornersLocal.end(),
                               [&](Vec3d corner) { return isAt(corner, plane); });
        });
    }

    std::vector<Vec3d> pointsLocal, normals;
    Vec4d pixelSize;
    std::vector<Plane> namedLocal;
    FoundPlanes found;
};

class PlanesOfScenes : public testing::TestWithParam<const char*>
{
protected:
    const std::shared_ptr<const Scene> scene_ = std::make_shared<const Scene>(buildBuiltin(GetParam()).value());
    const SceneBuffers buffers_ =
        evaluate(scene_, {}, chooseOrigin(scene_->views[0].camera.eyeWorld, sceneBounds(*scene_, {})));
    const TraceScene traced_{buffers_.casters()};
};

TEST_P(PlanesOfScenes, NamedPlanesThatShowAreFoundExactlyAndHeavyOnesAreFlat)
{
    std::size_t shown = 0;
    for (const NamedView& view : scene_->views) {
        SCOPED_TRACE(view.name);
        const Seen seen(*scene_, traced_, view);
        for (std::size_t i = 0; i < seen.namedLocal.size(); ++i) {
            if (seen.shareOf(seen.namedLocal[i]) < 0.05) continue;
            ++shown;
            EXPECT_TRUE(seen.isFound(seen.namedLocal[i])) << scene_->planes[i].name;
        }
        // Not slices of curved things, nor planes between two: their samples are all exactly on them.
        for (const FoundPlane& f : seen.found) {
            if (f.weight > 0.05) {
                EXPECT_NEAR(seen.shareOf(f.planeLocal), f.weight, 0.03);
            }
        }
    }
    EXPECT_GE(shown, scene_->views.size());
}

INSTANTIATE_TEST_SUITE_P(Builtin, PlanesOfScenes, testing::Values("bunnies", "objects", "table", "city"));

} // namespace
} // namespace lixel
