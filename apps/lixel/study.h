// SPDX-License-Identifier: MIT
#pragma once

#include "picture_options.h"

#include <cstdint>
#include <span>
#include <string>

namespace lixel::app {

struct StudyOptions
{
    int count = 0;        // of cases or lights; 0: the study's own
    bool isQuick = false; // fewer cases, the same question
    std::uint64_t seed = 2004;
    std::string executor = "gl";
    std::string json;        // where to, or empty
    std::string output;      // folder for results.json and report.html, or empty
    std::string commandLine; // repeats the run

    int timingFrames = 5; // of studies of views

    // Of studies of a scene.
    PictureOptions picture;
    std::string tolerance, technique = "scene-optimal";
    std::string lixels = "512x512";
};

// What a study is asked of; its options follow from that.
enum class StudiedCases : std::uint8_t {
    Counted, // --count, --quick, --seed
    Views,   // --count of the views of each built-in scene, --quick, --timing-frames
    Lights,  // --lights, --quick, --seed
    Scene,   // SCENE and what chooses its pictures, --tolerance, --technique
    Pictures // SCENE and what chooses its pictures, --lixels
};

// A question about lixel's own techniques that a table of pictures does not answer. Its run prints what it finds, writes JSON where it is
// asked to, and gives an exit code.
struct Study
{
    std::string name, question;
    StudiedCases cases = StudiedCases::Counted;
    bool hasReport = false; // goes into StudyOptions::output
    int (*run)(const StudyOptions& options);
};

std::span<const Study> studies();

// Their runs, one file each.
int studyOneToOne(const StudyOptions& options);
int studyPlaneBudget(const StudyOptions& options);
int studySceneOptimalSearch(const StudyOptions& options);
int studyResolution(const StudyOptions& options);
int studySceneOptimalSensitivity(const StudyOptions& options);
int studySceneOptimalMetrics(const StudyOptions& options);
int studyWarps(const StudyOptions& options);
int studyLookups(const StudyOptions& options);

} // namespace lixel::app
