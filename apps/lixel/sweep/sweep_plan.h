// SPDX-License-Identifier: MIT
#pragma once

#include "sweep/sweep_file.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

// What a sweep consists of, before anything is measured: every row has its number and its key. A plan stands at the head of
// the file of rows, so that neither going on nor merging opens scenes that have nothing left to do.
namespace lixel::app {

// One picture with its lights: what its rows share. Numbers are places in the lists of the file.
struct SweepGroup
{
    std::size_t scene = 0, viewOfFile = 0, time = 0, size = 0, lights = 0;
    std::string view; // by its own name: "all" stands for many
    double timeSeconds = 0;
    std::vector<std::string> lightNames;

    friend bool operator==(const SweepGroup&, const SweepGroup&) = default;
};

// One technique at one budget: what is measured at once, a row for each light.
struct SweepCell
{
    std::size_t group = 0, technique = 0;
    std::string lixels; // empty: a technique without a map
    std::size_t budget = 0;
    std::size_t firstRow = 0, rows = 0;
};

struct SweepPlan
{
    std::string study, hash, lixelVersion, executor, question;
    std::uint64_t seed = 0;
    std::vector<std::string> scenes, sizes, lights, lixels;
    struct OneTechnique
    {
        std::string typed, full;
        bool hasMap = true;
    };
    std::vector<OneTechnique> techniques;
    std::vector<SweepGroup> groups;

    std::vector<SweepCell> cells() const; // in the order of their rows
    std::string keyOf(const SweepCell& cell, std::size_t light) const;
};

// JSON in one line, and back: nothing where it is no plan.
std::string toJson(const SweepPlan& plan);
std::optional<SweepPlan> readPlan(std::string_view text);

// Scenes that are open. A study may name more than memory holds: of large ones only the last stays.
class SceneShelf
{
public:
    std::shared_ptr<const Scene> open(const std::string& path);

private:
    std::map<std::string, std::shared_ptr<const Scene>> scenes_;
    std::size_t triangles_ = 0;
};

// The pictures of one view of the file; throws InputError where the scene does not have it.
Shooting shootingOf(const SweepFile& file, const SweepGroup& group, SceneShelf& shelf);

// Opens every scene of the file. Throws InputError.
SweepPlan planSweep(const SweepFile& file, SceneShelf& shelf);

} // namespace lixel::app
