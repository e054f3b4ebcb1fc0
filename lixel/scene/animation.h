// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/scene/scene.h"

#include <span>
#include <vector>

// Keys to values (glTF 2.0, section 3.11 and appendix C).
namespace lixel {

// The time of an animation that plays over and over from 0 to its last key. The end itself is the end.
double repeatedTime(const Animation& animation, double time);

// Numbers of one value: 3 translation, scale; 4 rotation; as many as morph targets.
std::size_t valueSize(const AnimationChannel& channel);

// The channel's value at a time; before its first key that of the first, after its last that of the last, at a key
// exactly that of the key. Rotations are unit quaternions and turn the shorter way. `value` has valueSize() numbers.
void sampleChannel(const AnimationChannel& channel, double time, std::span<double> value);

// The transform from a node's space to its parent's.
Mat4d parentFromNodeMatrix(const NodeTransform& transform);

} // namespace lixel
