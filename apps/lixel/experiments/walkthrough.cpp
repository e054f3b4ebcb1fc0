// SPDX-License-Identifier: MIT
#include "experiments/walkthrough.h"

namespace lixel::app {

Shooting walkthroughAt(const std::string& size)
{
    PictureOptions picture;
    picture.scene = "objects";
    picture.size = size;
    picture.flags.eye = "0.6,1.3,3.4";
    picture.flags.target = "-1,0.5,-2";
    picture.flags.fovy = 60; // degrees
    Shooting shooting = prepare(picture, false);
    shooting.shots.front().name = "walkthrough";
    return shooting;
}

} // namespace lixel::app
