// SPDX-License-Identifier: MIT
#include "plan_file.h"

#include "lixel/plan/clip_convention.h"
#include "lixel/scene/input_file.h"
#include "lixel/scene/json_text.h"
#include "lixel/scene/view_json.h"

#include <nlohmann/json.hpp>

#include <fmt/format.h>

namespace lixel::app {
namespace {

constexpr int kMostLixels = 16384; // a side of an atlas

ClipConvention readConvention(const JsonPlace& place)
{
    place.expectMembers({"depth", "y"});
    ClipConvention convention;
    if (const auto depth = place.find("depth")) {
        const std::string word = depth->text();
        if (word == "0..1") convention.depth = ClipDepth::ZeroToOne;
        else if (word == "1..0") convention.depth = ClipDepth::OneToZero;
        else if (word != "-1..1") depth->refuse("expected \"-1..1\", \"0..1\" or \"1..0\"");
    }
    if (const auto y = place.find("y")) {
        const std::string word = y->text();
        if (word != "up" && word != "down") y->refuse("expected \"up\" or \"down\"");
        convention.yDown = word == "down";
    }
    return convention;
}

Mat4d readMatrix(const JsonPlace& place, const ClipConvention& convention)
{
    const std::vector<JsonPlace> rows = place.elements(4);
    if (rows.size() != 4) place.refuse("expected 4 rows");
    Mat4d matrix;
    for (int i = 0; i < 4; ++i) {
        const std::vector<JsonPlace> numbers = rows[std::size_t(i)].elements(4);
        if (numbers.size() != 4) rows[std::size_t(i)].refuse("expected 4 numbers");
        for (int j = 0; j < 4; ++j) matrix.m[i][j] = numbers[std::size_t(j)].number();
    }
    if (!inverse(matrix)) place.refuse("expected a matrix that has an inverse");
    return fromHost(matrix, convention);
}

LixelRectangle readRectangle(const JsonPlace& place)
{
    const std::vector<JsonPlace> numbers = place.elements(4);
    const auto at = [&](std::size_t i) {
        const double value = numbers[i].number();
        if (value < 0 || value > kMostLixels || value != double(int(value)))
            numbers[i].refuse(fmt::format("expected a whole number from 0 to {}", kMostLixels));
        return int(value);
    };
    if (numbers.size() != 4) place.refuse("expected x0, y0, x1, y1");
    const LixelRectangle r{at(0), at(1), at(2), at(3), 0};
    if (r.width() < 1 || r.height() < 1) place.refuse("expected x0 < x1 and y0 < y1");
    return r;
}

Plane readHalfSpace(const JsonPlace& place)
{
    const std::vector<JsonPlace> numbers = place.elements(4);
    if (numbers.size() != 4) place.refuse("expected nx, ny, nz, d");
    const Vec3d normal{numbers[0].number(), numbers[1].number(), numbers[2].number()};
    const double size = length(normal);
    if (!(size > 0)) place.refuse("expected a normal of some length");
    return {normal / size, numbers[3].number() / size};
}

GivenRegion readRegion(const JsonPlace& place, const ClipConvention& convention)
{
    place.expectMembers({"lightClipFromWorld", "rectangle", "halfSpaces"});
    GivenRegion region;
    region.lightClipFromWorld = readMatrix(place.at("lightClipFromWorld"), convention);
    if (const auto rectangle = place.find("rectangle")) region.rectangle = readRectangle(*rectangle);
    if (const auto halfSpaces = place.find("halfSpaces")) {
        const std::vector<JsonPlace> all = halfSpaces->elements(0);
        if (all.size() > CellPlanes::capacity())
            halfSpaces->refuse(fmt::format("expected {} half-spaces at most", CellPlanes::capacity()));
        for (const JsonPlace& one : all) region.halfSpacesWorld.push_back(readHalfSpace(one));
    }
    return region;
}

GivenLight readLight(const JsonPlace& place, const ClipConvention& convention)
{
    place.expectMembers({"name", "lightClipFromWorld", "regions"});
    GivenLight light;
    if (const auto name = place.find("name")) light.light = name->text();
    if (place.has("regions") == place.has("lightClipFromWorld"))
        place.refuse("expected either \"lightClipFromWorld\" or \"regions\"");
    if (const auto matrix = place.find("lightClipFromWorld"))
        light.regions.push_back({readMatrix(*matrix, convention), std::nullopt, {}});
    if (const auto regions = place.find("regions"))
        for (const JsonPlace& region : regions->elements(1)) light.regions.push_back(readRegion(region, convention));
    return light;
}

void expectRectangles(const JsonPlace& place, const GivenLight& light, bool needsRectangles)
{
    for (const GivenRegion& region : light.regions) {
        if (needsRectangles && !region.rectangle)
            place.refuse("expected regions with a \"rectangle\" each for plan(file)");
    }
    if (!needsRectangles && light.regions.size() > 1)
        place.refuse("expected one matrix for matrix(file); plan(file) takes several regions");
}

nlohmann::json rowsOf(const Mat4d& matrix)
{
    nlohmann::json rows = nlohmann::json::array();
    for (int i = 0; i < 4; ++i) rows.push_back({matrix.m[i][0], matrix.m[i][1], matrix.m[i][2], matrix.m[i][3]});
    return rows;
}

nlohmann::json toJson(const PlannedRegion& region, Vec3d originWorld)
{
    const LixelRectangle& r = region.rectangle;
    nlohmann::json out;
    out["lightClipFromWorld"] = rowsOf(region.lightClipFromLocal * translation(-originWorld));
    if (const auto& p = region.paraboloid)
        out["paraboloid"] = {{"centre", {p->centre.x, p->centre.y}},
                             {"halfSize", {p->halfSize.x, p->halfSize.y}},
                             {"near", p->near},
                             {"far", p->far}};
    out["rectangle"] = {r.x0, r.y0, r.x1, r.y1};
    out["halfSpaces"] = nlohmann::json::array();
    for (const Plane& p : region.halfSpacesLocal)
        out["halfSpaces"].push_back({p.normal.x, p.normal.y, p.normal.z, p.offset - dot(p.normal, originWorld)});
    return out;
}

} // namespace

std::vector<GivenLight> readPlanFile(const std::string& path, bool needsRectangles)
{
    const nlohmann::json json = parseJson(readJsonFile(path), path);
    const JsonPlace root(json, "", path);
    root.expectMembers({"convention", "lights"});
    const auto conventionPlace = root.find("convention");
    const ClipConvention convention = conventionPlace ? readConvention(*conventionPlace) : ClipConvention{};
    std::vector<GivenLight> lights;
    for (const JsonPlace& place : root.at("lights").elements(1)) {
        lights.push_back(readLight(place, convention));
        expectRectangles(place, lights.back(), needsRectangles);
    }
    return lights;
}

std::string toPlanJson(const FramePlan& plan, std::span<const Light> lights)
{
    nlohmann::json out;
    out["convention"] = {{"depth", "-1..1"}, {"y", "up"}};
    out["lights"] = nlohmann::json::array();
    for (std::size_t i = 0; i < lights.size(); ++i) {
        if (plan.lights[i].refused) continue;
        nlohmann::json regions = nlohmann::json::array();
        for (const PlannedRegion& region : plan.lights[i].regions) regions.push_back(toJson(region, plan.originWorld));
        out["lights"].push_back({{"name", lights[i].name}, {"regions", regions}});
    }
    return out.dump(1) + "\n";
}

} // namespace lixel::app
