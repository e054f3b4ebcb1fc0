// SPDX-License-Identifier: MIT
// The fragment stage of a host's casters.   LIXEL_KEEP   the host's text, which stands before this, has bool lixelKeep(vec2 uv)
layout(location = 0) in vec2 lixelUv;

void main()
{
#ifdef LIXEL_KEEP
    if (!lixelKeep(lixelUv)) discard;
#endif
}
