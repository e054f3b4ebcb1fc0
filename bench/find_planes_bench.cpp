// SPDX-License-Identifier: MIT
// What it costs to find planes: a room with curved things in it, by number of samples.
#include "lixel/plan/partition/find_planes.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <vector>

namespace {

using namespace lixel;

void seekPlanes(benchmark::State& state)
{
    const View view = perspectiveView({0, 1.6, 0}, {0, 1, -5}, {0, 1, 0}, 1, 0.1, 100, 1024, 1024);
    const Vec3d origin = view.anchorWorld, centre = Vec3d{0, 0.5, -4} - origin;
    const double radius = state.range(1) != 0 ? 1.2 : 0;
    const int side = int(std::sqrt(double(state.range(0))));
    std::vector<Vec3d> points, normals;
    const Mat4d localFromClip = *inverse(clipFromLocal(view, origin));
    for (int i = 0; i < side * side; ++i) {
        const Vec3d ray = project(localFromClip, {2 * (i % side + 0.5) / side - 1, 2 * (i / side + 0.5) / side - 1, 0});
        // A sphere before floor and wall.
        const double a = dot(ray, ray), b = dot(ray, centre), d = b * b - a * (dot(centre, centre) - radius * radius);
        const double floor = -1.6 / ray.y, wall = -8 / ray.z;
        double t = ray.y < 0 && floor < wall ? floor : wall;
        Vec3d normal = t == floor ? Vec3d{0, 1, 0} : Vec3d{0, 0, 1};
        if (d > 0 && radius > 0) t = (b - std::sqrt(d)) / a, normal = normalized(t * ray - centre);
        points.push_back(toDouble(toFloat(t * ray)));
        normals.push_back(toDouble(toFloat(normal)));
    }
    PlaneScratch scratch;
    FoundPlanes found;
    const PlaneSearch search{points, normals, {}, pixelSizeLocal(view, origin)};
    for (auto _ : state) {
        findPlanes(search, scratch, found);
        benchmark::DoNotOptimize(found);
    }
}
BENCHMARK(seekPlanes)
    ->ArgNames({"samples", "sphere"})
    ->ArgsProduct({{1024, 4096, 1 << 20}, {0, 1}})
    ->Unit(benchmark::kMicrosecond);

} // namespace
