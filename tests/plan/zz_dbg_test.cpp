#include "plan/awkward_setups.h"
#include "plan/ordinary_setups.h"
#include "plan/planed_setups.h"
#include <gtest/gtest.h>
#include <cstdio>
#include <cstdlib>
using namespace lixel;
using namespace lixel::test;
TEST(Dbg, One)
{
    const char* text = std::getenv("TECH"); const std::string kind = std::getenv("KIND");
    forEachCase(1, [&](Rng& rng) {
        RandomSetup setup = kind == "awk" ? awkwardSetup(rng) : kind == "ord" ? ordinarySetup(rng) : anySetup(rng);
        ViewSamples samples = anySamples(setup, rng);
        LixelSize budget{512, 384};
        constexpr LixelSize kBudgets[] = {{512, 384}, {16, 16}, {512, 1}, {1, 512}, {2, 7}, {3, 3}, {1, 1}};
        if (kind == "awk") budget = kBudgets[rng.integer(0, 6)];
        PlanInput input{setup.view, {&setup.light, 1}, setup.boxesWorld, setup.originWorld, std::get<MapTechnique>(*parseTechnique(text)), budget};
        if (kind == "awk") { if (rng.chance(0.7) || needsViewSamples(input.technique)) input.seen = &samples; input.seenIsAll = input.seen && rng.chance(0.5);}
        PlanedCase planed; planed.giveTo(input, setup, samples, rng, kind == "ord");
        FramePlan plan = planShadows(input);
        std::printf("budget %d x %d, kind %d seen %d all %d radius %g samples %zu refused %s\n", budget.width, budget.height, int(setup.light.kind), !!input.seen, input.seenIsAll, setup.radius, samples.size(), plan.lights[0].refused ? std::string(nameOf(*plan.lights[0].refused)).c_str() : "no");
        const Vec3d l = setup.light.positionWorld - setup.originWorld, d = setup.light.directionWorld, e = setup.view.anchorWorld - setup.originWorld;
        std::printf("light %g %g %g dir %g %g %g eye %g %g %g\n", l.x, l.y, l.z, d.x, d.y, d.z, e.x, e.y, e.z);
        for (auto& lo : plan.lights[0].leftOut) std::printf("left out %d %s\n", lo.plane, std::string(nameOf(lo.why)).c_str());
        for (auto& r : plan.lights[0].regions) std::printf("region plane %d halfspaces %zu rect %d %d %d %d double %d\n", r.plane, r.halfSpacesLocal.size(), r.rectangle.x0, r.rectangle.y0, r.rectangle.x1, r.rectangle.y1, r.isInDouble);
        for (std::size_t i = 0; i < samples.size(); ++i) {
            shared::LxReceiver rec{};
            const PlannedRegion* reg = serving(plan, samples.positionLocal[i], samples.normal[i], rec);
            const Vec3d p = toDouble(samples.positionLocal[i]);
            std::printf("%zu (%g %g %g) %s lixel %g %g:", i, p.x, p.y, p.z, reg ? "ok" : "UNSERVED", rec.lixel.x, rec.lixel.y);
            if (reg) std::printf(" region %d", int(reg - plan.lights[0].regions.data()));
            if (!reg) for (auto& r : plan.lights[0].regions) {
                const Vec4d c = r.lightClipFromLocal * point(p);
                std::printf(" [%.7g %.7g %.7g w %g", c.x / c.w, c.y / c.w, c.z / c.w, c.w);
                for (auto& h : r.halfSpacesLocal) std::printf(" h%.3g", h.signedDistance(p));
                std::printf("]");
            }
            std::printf("\n");
        }
    });
}
