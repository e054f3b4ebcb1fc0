// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/plan/light_image.h"
#include "lixel/plan/need.h"

#include <optional>
#include <span>

// From a light's budget of lixels to one rectangle a region.
namespace lixel {

// Lixels a light may use in a frame. One size is a total; with several they are the maps themselves.
struct LixelSize
{
    int width = 0, height = 0;
    friend bool operator==(const LixelSize&, const LixelSize&) = default;
};

// The shares, adding up to 1, that make the sum of need / sqrt(share) least (need.h): they go with need^(2/3). No share is much less
// than a 32nd of an even one. Equal shares where no need is known. In place: needs in, shares out.
void sharesByNeed(std::span<double> needs);

// Cuts a rectangle into pieces of about the given shares: in halves of the shares, across the longer side, again and again, so
// that pieces stay as square as they can. They do not overlap, have at least one lixel each and fill the whole. False
// where there are fewer lixels than pieces.
bool cutRectangle(LixelRectangle whole, std::span<const double> shares, std::span<LixelRectangle> pieces);

// The same with pieces shaped for their needs: of all ways to halve along either side, by the shares or evenly, the one with the least
// predicted error. More than 8 pieces are halved across the longer side until 8 or fewer are left to try. A piece may be used turned by
// a right angle: `turned` says so. Turning, and halving the shorter side, must be better by 3 % to be taken. `reach` lixels along
// each side of a piece are guard band (place.h). Needs at most 64 pieces.
bool cutRectangleByNeed(LixelRectangle whole, std::span<const double> shares, std::span<const Need> needs,
                        std::span<LixelRectangle> pieces, std::span<bool> turned, double reach = 0);

// Packs rectangles of given sizes side by side, without turning them, and says how large the whole became: shelves of falling
// height, about as wide as high. Needs at most 64.
LixelSize packRectangles(std::span<const LixelSize> sizes, int layer, std::span<LixelRectangle> rectangles);

} // namespace lixel
