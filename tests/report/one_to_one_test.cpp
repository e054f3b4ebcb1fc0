// SPDX-License-Identifier: MIT
#include "lixel/report/one_to_one.h"

#include "schema_check.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace lixel {
namespace {

using test::schemaError;

constexpr const char* kSchema = "one-to-one.schema.json";

OneToOne sample()
{
    OneToOne study;
    study.lixelVersion = "0.0.0";
    study.command = "lixel study one-to-one";
    study.seed = 7;
    study.configurations = 4;
    study.refused = {{"plane-faces-away", 1}};
    study.inDouble = {{1e-12, 3e-10, 2e-11}, 30};
    study.worstInDouble = {{{"light_elevation_radians", 0.5}, {"radius_units", 2}}, "spot", 3e-10};
    study.onDevice = {{1e-4, 2e-3, 3e-5}, 300};
    study.worstOnDevice = study.worstInDouble;
    study.timing = {"2000-01-01T00:00:00Z", "somewhere", 1.5};
    return study;
}

TEST(OneToOneJson, IsWhatItsSchemaSays)
{
    const std::string text = toJson(sample());
    EXPECT_EQ(schemaError(text, kSchema), "");
    const auto json = nlohmann::json::parse(text);
    EXPECT_EQ(json["max_deviation_double_pixels"], 3e-10);
    EXPECT_EQ(json["max_deviation_gpu_pixels"], 2e-3);
    EXPECT_EQ(json["deviation_double_pixels"]["p50"], 2e-11);
    EXPECT_EQ(json["why_no_gpu"], nullptr);
}

TEST(OneToOneJson, WithoutADeviceSaysWhy)
{
    OneToOne study = sample();
    study.onDevice.reset();
    study.worstOnDevice.reset();
    study.whyNotOnDevice = "none here";
    const std::string text = toJson(study);
    EXPECT_EQ(schemaError(text, kSchema), "");
    const auto json = nlohmann::json::parse(text);
    EXPECT_EQ(json["max_deviation_gpu_pixels"], nullptr);
    EXPECT_EQ(json["why_no_gpu"], "none here");
}

TEST(OneToOneJson, OfNothingMeasuredHasNoLargestNumber)
{
    OneToOne study = sample();
    study.inDouble = {};
    study.worstInDouble.reset();
    const std::string text = toJson(study);
    EXPECT_EQ(schemaError(text, kSchema), "");
    EXPECT_EQ(nlohmann::json::parse(text)["max_deviation_double_pixels"], nullptr);
}

TEST(OneToOneJson, TheSchemaIsClosed)
{
    auto json = nlohmann::json::parse(toJson(sample()));
    json["something"] = 1;
    EXPECT_NE(schemaError(json.dump(), kSchema), "");
    json = nlohmann::json::parse(toJson(sample()));
    json.erase("max_deviation_gpu_pixels");
    EXPECT_NE(schemaError(json.dump(), kSchema), "");
}

} // namespace
} // namespace lixel
