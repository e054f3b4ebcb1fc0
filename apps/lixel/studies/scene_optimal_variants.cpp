// SPDX-License-Identifier: MIT
#include "studies/scene_optimal_variants.h"

#include "shadows.h"

#include <algorithm>
#include <array>
#include <variant>

#include <fmt/format.h>

namespace lixel::app {
namespace {

struct Base
{
    const char* technique;
    bool isDescent; // has angles and iterations
};
constexpr std::array kBases{Base{"scene-optimal(uncovered=lit)", false},
                            Base{"scene-optimal(metric=l2,search=paper,uncovered=lit)", true}};

struct Angles
{
    const char* name;
    std::vector<double> degrees;
};
const std::vector<Angles>& angleLists()
{
    static const std::vector<Angles> all{
        {"16", {16}},
        {"-10 5 16 40", {-10, 5, 16, 40}},
        {"1 2 4 8", {1, 2, 4, 8}},
        {"3 5 9 16 23 30 40 50", {3, 5, 9, 16, 23, 30, 40, 50}},
        {"the paper's: -10 and those", {kPaperAngles.begin(), kPaperAngles.end()}},
        {"those and halfway between",
         {-10, -5, 1, 2, 3, 4, 5, 7, 9, 12.5, 16, 19.5, 23, 26.5, 30, 35, 40, 45, 50, 60, 70}},
        {"both ways", {-50, -30, -16, -9, -3, 3, 9, 16, 30, 50}},
    };
    return all;
}

// One base's curves.
class CurvesOf
{
public:
    explicit CurvesOf(const Base& base)
        : base_(base), own_(*sceneOptimalOf(std::get<MapTechnique>(readTechniques(base.technique).front().technique)))
    {
    }

    void addTo(std::vector<SceneOptimalCurve>& out) const
    {
        const std::array grids{45, 90, 180, 360};
        out.push_back(curve("samples each way", grids, &SceneOptimalFit::samples));
        if (base_.isDescent) {
            const std::array iterations{0, 1, 2, 3, 4, 5, 6};
            out.push_back(curve("iterations", iterations, &SceneOptimalFit::iterations));
            out.push_back(ofAngles());
        }
        const std::array shears{false, true};
        out.push_back(curve("shear", shears, &SceneOptimalFit::hasShear));
        const std::array weights{0.0, 0.002, 0.02, 0.2, 1.0};
        out.push_back(curve("weight away from boundaries", weights, &SceneOptimalFit::awayFromBoundaries));
        const std::array slacks{0.0, 0.005, 0.02, 0.05, 0.1};
        out.push_back(curve("slack", slacks, &SceneOptimalFit::slack));
        const std::array extents{MapExtent::Shadows, MapExtent::Seen};
        out.push_back(curve("holds", extents, &SceneOptimalFit::extent));
        const std::array metrics{LixelMetric::L2, LixelMetric::Lloyd, LixelMetric::Area, LixelMetric::Width};
        out.push_back(curve("metric", metrics, &SceneOptimalFit::metric));
    }

private:
    static std::string text(int value) { return fmt::format("{}", value); }
    static std::string text(double value) { return fmt::format("{}", value); }
    static std::string text(bool value) { return value ? "yes" : "no"; }
    static std::string text(MapExtent value) { return value == MapExtent::Shadows ? "shadows" : "seen"; }
    static std::string text(LixelMetric value) { return std::string(nameOf(value)); }

    template <typename Values, typename T>
    SceneOptimalCurve curve(const char* parameter, const Values& values, T SceneOptimalFit::*member) const
    {
        SceneOptimalCurve out{parameter, base_.technique, {}};
        for (const T value : values) {
            SceneOptimalFit fit = own_;
            fit.*member = value;
            out.variants.push_back({text(value), fit == own_, fit});
        }
        return out;
    }

    SceneOptimalCurve ofAngles() const
    {
        SceneOptimalCurve out{"angles", base_.technique, {}};
        for (const Angles& angles : angleLists()) {
            const bool isOwn = std::ranges::equal(angles.degrees, kPaperAngles);
            out.variants.push_back({angles.name, isOwn, own_, angles.degrees});
        }
        return out;
    }

    Base base_;
    SceneOptimalFit own_;
};

} // namespace

std::vector<SceneOptimalCurve> sceneOptimalCurves()
{
    std::vector<SceneOptimalCurve> out;
    for (const Base& base : kBases) CurvesOf(base).addTo(out);
    return out;
}

} // namespace lixel::app
