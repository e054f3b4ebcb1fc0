// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/light.h"
#include "lixel/base/view.h"
#include "lixel/gl/device/program.h"
#include "lixel/gl/passes/point_list.h"
#include "lixel/gl/passes/visibility_list.h"
#include "lixel/gl/passes/volume_casters.h"

#include <span>

namespace lixel::gl {

// Shadow volumes (Crow 1977) from silhouettes, counted behind the samples (z-fail) and closed at infinity, so that the eye may be
// inside them (Everitt, Kilgard 2002). Every triangle is a caster with two sides; the sides between volumes cancel by
// multiplicity (Kim et al. 2008), which serves open and non-manifold meshes: a sample's count is the number of triangles
// between it and the light. It is kept modulo 256, of which 252 to 255 are less than none.
//   reads   VolumeCasters, PointList with an entry a pixel        writes   VisibilityList
class ShadowVolumePass
{
public:
    static constexpr const char* kSilhouettes = "silhouettes";
    static constexpr const char* kVolumes = "volumes";

    ShadowVolumePass();

    // Takes what `begin` and `visibilityOf` need of a frame: casters and points share their originWorld, the view is perspective.
    void begin(const VolumeCasters& casters, const View& view, const PointList& points);
    // Light by light: what hangs from its silhouettes, then how many volumes hold each sample.
    void findSilhouettes(const VolumeCasters& casters, const Light& light);
    void count(const VolumeCasters& casters);
    void decide(const PointList& points, const VisibilityList& visibility, std::size_t light) const;

private:
    void drawSamples(const PointList& points); // one a pixel, for what lies behind it

    Program facing_, silhouettes_, samples_, sides_, caps_, farCaps_, visibility_;
    VertexArray noVertices_;
    Buffer facingOfTriangles_, sidesOfVolumes_, draw_;
    Texture sampleOfPixel_, volumes_;
    Framebuffer withSamples_, counting_;
    std::uint32_t verticesASide_ = 6;
    bool isPointLight_ = true;
};

} // namespace lixel::gl
