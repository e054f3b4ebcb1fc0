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
    case FitFailure::NoSuchPlane: return "no-such-plane";
    case FitFailure::PlaneFacesAway: return "plane-faces-away";
    case FitFailure::LightInPlane: return "light-in-plane";
    case FitFailure::EyeInPlane: return "eye-in-plane";
    case FitFailure::NoPlaceOfLight: return "no-place-of-light";
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
    case FitFailure::TooFewLixels:
        return "the budget has less than one lixel for each region, or than a lixel a pixel where that is asked for";
    case FitFailure::NoSuchPlane: return "there is no plane of that name, or none was found";
    case FitFailure::PlaneFacesAway: return "the plane is between eye and light: nothing seen of it faces the light";
    case FitFailure::LightInPlane: return "the light lies in the plane: its rays do not cross it";
    case FitFailure::EyeInPlane: return "the eye lies in the plane, which is seen edge-on";
    case FitFailure::NoPlaceOfLight:
        return "a directional light has no place to put a paraboloid at: dual-paraboloid serves spot and point lights";
    }
    return "";
}

} // namespace lixel
