// SPDX-License-Identifier: MIT
#include "lixel/report/one_to_one.h"

#include "lixel/report/json_document.h"

#include <algorithm>

#include <nlohmann/json.hpp>

namespace lixel {
namespace {

using Json = nlohmann::json;

constexpr int kOneToOneVersion = 1;

Json most(const std::vector<double>& values)
{
    return values.empty() ? Json(nullptr) : Json(*std::max_element(values.begin(), values.end()));
}

// Of the configurations' worst points.
Json percentiles(std::vector<double> values)
{
    if (values.empty()) return nullptr;
    std::sort(values.begin(), values.end());
    const auto at = [&](double share) { return values[std::size_t(share * double(values.size() - 1))]; };
    return {{"p50", at(0.5)}, {"p90", at(0.9)}, {"p99", at(0.99)}, {"max", values.back()}};
}

Json worst(const std::optional<OneToOne::Worst>& of)
{
    if (!of) return nullptr;
    Json json = of->parameters;
    json["light"] = of->light;
    json["deviation_pixels"] = of->deviationPixels;
    return json;
}

} // namespace

std::string toJson(const OneToOne& study)
{
    const auto onDevice = [&](const auto& of) { return study.onDevice ? Json(of(*study.onDevice)) : Json(nullptr); };
    Json json = studyHead(kOneToOneVersion, "one-to-one", study);
    json["configurations"] = study.configurations;
    json["refused"] = study.refused;
    json["max_deviation_double_pixels"] = most(study.inDouble.worstPixels);
    json["deviation_double_pixels"] = percentiles(study.inDouble.worstPixels);
    json["configurations_double"] = study.inDouble.worstPixels.size();
    json["points_double"] = study.inDouble.points;
    json["worst_double"] = worst(study.worstInDouble);
    json["max_deviation_gpu_pixels"] = onDevice([](const auto& d) { return most(d.worstPixels); });
    json["deviation_gpu_pixels"] = onDevice([](const auto& d) { return percentiles(d.worstPixels); });
    json["configurations_gpu"] = onDevice([](const auto& d) { return Json(d.worstPixels.size()); });
    json["lixels_gpu"] = onDevice([](const auto& d) { return Json(d.points); });
    json["worst_gpu"] = worst(study.worstOnDevice);
    json["why_no_gpu"] = study.onDevice ? Json(nullptr) : Json(study.whyNotOnDevice);
    return documentOf(json);
}

} // namespace lixel
