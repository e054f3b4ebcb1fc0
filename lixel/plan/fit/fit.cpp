// SPDX-License-Identifier: MIT
#include "lixel/plan/fit/fit.h"

namespace lixel {

std::string_view nameOf(FitFailure failure)
{
    switch (failure) {
    case FitFailure::NothingInView: return "nothing-in-view";
    case FitFailure::ExtentNotInHemisphere: return "extent-not-in-hemisphere";
    case FitFailure::EmptyScene: return "empty-scene";
    case FitFailure::NoViewSamples: return "no-view-samples";
    case FitFailure::NotGiven: return "not-given";
    case FitFailure::TooFewLixels: return "too-few-lixels";
    }
    return "";
}

std::string_view sentenceFor(FitFailure failure)
{
    switch (failure) {
    case FitFailure::NothingInView: return "no part of the scene is both in view and in the light's reach";
    case FitFailure::ExtentNotInHemisphere:
        return "what the light must see does not fit into one perspective map (half a sphere or more): cube is needed";
    case FitFailure::EmptyScene: return "the scene has no casters";
    case FitFailure::NoViewSamples: return "it is made from view samples, and none were given";
    case FitFailure::NotGiven: return "the file has no map for this light";
    case FitFailure::TooFewLixels: return "the budget has less than one lixel for each region";
    }
    return "";
}

} // namespace lixel
