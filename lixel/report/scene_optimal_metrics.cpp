// SPDX-License-Identifier: MIT
#include "lixel/report/scene_optimal_metrics.h"

#include "lixel/judge/rank_correlation.h"
#include "lixel/report/json_document.h"

#include <algorithm>
#include <functional>

#include <nlohmann/json.hpp>

namespace lixel {
namespace {

using Json = nlohmann::json;
using Case = SceneOptimalMetrics::Case;

constexpr int kVersion = 1;

// Energies and errors of some cases.
struct Pairs
{
    std::vector<double> energy, errors;

    std::optional<double> correlation() const { return rankCorrelation(energy, errors); }
};

Pairs forEachSample(const std::vector<Case>& cases, const std::string& metric,
                    const std::function<bool(const Case&)>& wanted)
{
    Pairs out;
    for (const Case& c : cases) {
        if (!wanted(c)) continue;
        out.energy.push_back(c.meanEnergy.at(metric));
        out.errors.push_back(double(c.misclassified) / double(c.boundarySamples));
    }
    return out;
}

Pairs sums(const std::vector<Case>& cases, const std::string& metric)
{
    Pairs out;
    for (const Case& c : cases) {
        out.energy.push_back(c.meanEnergy.at(metric) * double(c.boundarySamples));
        out.errors.push_back(double(c.misclassified));
    }
    return out;
}

void rankWithinLights(const SceneOptimalMetrics& study, MetricRanks& out)
{
    std::map<std::string, std::vector<Case>> byLight;
    for (const Case& c : study.cases) byLight[c.light].push_back(c);
    double chosen = 0, best = 0;
    for (const auto& [light, cases] : byLight) {
        const auto found = forEachSample(cases, out.metric, [](const Case&) { return true; }).correlation();
        if (!found) continue;
        out.withinLights += *found;
        ++out.lightsRanked;
        const auto energy = [&](const Case& c) { return c.meanEnergy.at(out.metric); };
        const auto least = std::ranges::min_element(cases, {}, energy);
        const auto right = std::ranges::min_element(cases, {}, &Case::misclassified);
        out.bestFound += least->misclassified == right->misclassified;
        chosen += double(least->misclassified), best += double(right->misclassified);
    }
    if (out.lightsRanked > 0) out.withinLights /= out.lightsRanked;
    out.lossOfChoice = best > 0 ? chosen / best : 1;
}

Json toJson(std::optional<double> value) { return value ? Json(*value) : Json(); }

Json toJson(const MetricRanks& ranks)
{
    Json techniques = Json::array();
    for (const auto& [technique, value] : ranks.ofTechnique)
        techniques.push_back({{"technique", technique}, {"rank_correlation", toJson(value)}});
    return {{"metric", ranks.metric},
            {"techniques", techniques},
            {"pooled", toJson(ranks.pooled)},
            {"pooled_sums", toJson(ranks.pooledSums)},
            {"within_lights", ranks.withinLights},
            {"lights_ranked", ranks.lightsRanked},
            {"best_found", ranks.bestFound},
            {"loss_of_choice", ranks.lossOfChoice}};
}

Json toJson(const Case& c)
{
    return {{"light", c.light},
            {"technique", c.technique},
            {"misclassified", c.misclassified},
            {"boundary_samples", c.boundarySamples},
            {"boundary_unserved", c.unserved},
            {"mean_energy", c.meanEnergy}};
}

} // namespace

std::vector<MetricRanks> metricRanks(const SceneOptimalMetrics& study)
{
    std::vector<MetricRanks> out;
    for (const std::string& metric : study.metrics) {
        MetricRanks& ranks = out.emplace_back();
        ranks.metric = metric;
        for (const std::string& technique : study.techniques)
            ranks.ofTechnique[technique] = forEachSample(study.cases, metric, [&](const Case& c) {
                                               return c.technique == technique;
                                           }).correlation();
        ranks.pooled = forEachSample(study.cases, metric, [](const Case&) { return true; }).correlation();
        ranks.pooledSums = sums(study.cases, metric).correlation();
        rankWithinLights(study, ranks);
    }
    return out;
}

std::string toJson(const SceneOptimalMetrics& study)
{
    Json ranks = Json::array(), cases = Json::array();
    for (const MetricRanks& one : metricRanks(study)) ranks.push_back(toJson(one));
    for (const Case& c : study.cases) cases.push_back(toJson(c));
    Json json = studyHead(kVersion, "scene-optimal-metrics", study);
    json["lights_left_out"] = study.leftOut;
    json["metrics"] = ranks;
    json["cases"] = cases;
    return documentOf(json);
}

} // namespace lixel
