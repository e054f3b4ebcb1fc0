// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/plan/fit/light_frame.h"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace lixel {

// The affine part of a light image, for an optical axis: rectangles and parallelograms around what the map must hold.
//
//   H. Chong, S. Gortler. Scene Optimized Shadow Mapping. 2007, section 2.3, step 4bii, and Figure 3.
//
// Light images with w > 0 for all that is held keep the order of its hull's corners, so the hull is found once for all axes.
class HullMaps
{
public:
    static constexpr std::size_t kMostCorners = 40;

    // `corners`: rays (x, y, w) of the hull, counter-clockwise on the light plane, kMostCorners at most. `aspect`: lixels across the map over those
    // along, if that is known.
    HullMaps(std::span<const Vec3d> corners, double aspect, std::vector<Vec2d>& room)
        : corners_(corners), aspect_(aspect), room_(room)
    {
    }

    // Looks along a new axis, of any length. False where some corner is not before it, or all but.
    bool lookAlong(Vec3d w);

    // A rectangle in the image, one side along (cos, sin) of the basis, as the rows of a map with one lixel in all.
    struct Sides
    {
        Vec2d along;        // unit, on the image
        Vec2d centre, half; // along it and across
        double shear = 0;   // how far, along, all moves for one unit across
        double area() const { return half.x * half.y; }
    };
    std::size_t sideCount() const { return image_.size() + 1; }
    // Of the hull's side, or, as the last, upright across the way in which the image widens.
    Sides sides(std::size_t number) const;
    // The parallelogram of least area with the rectangle's side (Figure 3); where several are, that of the least shear.
    Sides sheared(const Sides& upright) const;

    // u = (x.r / w.r, y.r / w.r) is in [-1/2, 1/2] times the map's sides, whose product is 1. Turned: along runs up the map.
    PlaneWarp rows(const Sides& sides, bool isTurned) const;
    // The basis vectors b1 and b2 of such rows (lixel_energy.h), to which energies are due.
    struct Steps
    {
        Vec3d alongX, alongY;
    };
    Steps steps(const Sides& sides, bool isTurned) const;

    Vec3d axis() const { return w_; }
    bool isSquare() const { return aspect_ == 1; }

private:
    std::span<const Vec3d> corners_;
    double aspect_;
    std::vector<Vec2d>& room_;
    Vec3d w_, e1_, e2_; // orthonormal
    std::span<const Vec2d> image_;
};

} // namespace lixel
