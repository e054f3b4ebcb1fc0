// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/enclosing_polygon.h"
#include "lixel/base/rectangle.h"
#include "lixel/plan/fit/hull_map.h"
#include "lixel/plan/fit/light_frame.h"
#include "lixel/plan/fit/map_search.h"
#include "plan/box_pictures.h"
#include "plan/ordinary_setups.h"

#include <optional>
#include <vector>

// What light images are searched for: the receivers in a picture of an ordinary set-up, and those of them near shadow boundaries.
namespace lixel::test {

struct SearchCase
{
    RandomSetup setup;
    BoxPicture picture;
    std::vector<NeedSample> edges;
    FitScratch scratch;
    LightFrame frame; // the receivers are in [-1, 1]
    EdgeRays rays;
    std::vector<Vec3d> corners;

    // False where nothing is seen, or nothing has a shadow's edge, or no one map holds it.
    bool make(Rng& rng, int width, int height)
    {
        setup = ordinarySetup(rng);
        setup.view.width = width, setup.view.height = height;
        return frameIt();
    }

    bool frameIt()
    {
        picture = boxPicture(setup);
        edges = edgesOf(setup, picture);
        if (edges.size() < 8 || picture.facingLocal.empty()) return false;
        const auto body = frameAround(input(), picture.facingLocal);
        if (!body) return false;
        std::vector<Vec2d> image;
        Vec2d low{INFINITY, INFINITY}, high{-INFINITY, -INFINITY};
        for (const Vec3d& p : picture.facingLocal) {
            const Vec2d at = onLightPlane(body->frame, p);
            low = {std::min(low.x, at.x), std::min(low.y, at.y)},
            high = {std::max(high.x, at.x), std::max(high.y, at.y)};
            image.push_back(at);
        }
        const Vec2d centre = 0.5 * (low + high);
        const double scale = 2 / std::max(high.x - low.x, high.y - low.y);
        const auto scaled = warped(*body, {{scale, 0, -scale * centre.x}, {0, scale, -scale * centre.y}, {0, 0, 1}});
        if (!scaled) return false;
        frame = scaled->frame;
        std::vector<Vec2d> hull(image.size() + 1);
        hull.resize(convexHull(image, hull));
        if (hull.size() > HullMaps::kMostCorners) hull.resize(encloseWithFewerCorners(hull, HullMaps::kMostCorners));
        corners.clear();
        for (const Vec2d& p : hull) corners.push_back({scale * (p.x - centre.x), scale * (p.y - centre.y), 1});
        rays.assign(setup.view, setup.originWorld, frame.framedFromLocal, edges);
        return corners.size() >= 3 && !rays.isEmpty();
    }

    FitInput input()
    {
        FitInput out{setup.view, setup.light, setup.originWorld, setup.boxesWorld, setup.sceneLocal(), scratch};
        out.hasViewSamples = true;
        out.seenLocal = picture.facingLocal;
        out.edges = edges;
        return out;
    }

    MapQuestion question(LixelMetric metric, double aspect = 1, bool hasShear = false)
    {
        return {metric, rays, corners, aspect, hasShear, scratch.scene};
    }
};

} // namespace lixel::test
