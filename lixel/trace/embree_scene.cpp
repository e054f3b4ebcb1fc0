// SPDX-License-Identifier: MIT
#include "lixel/trace/embree_scene.h"

#include "lixel/base/assert.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <new>
#include <vector>

namespace lixel {
namespace {

// What Embree hands to our functions with each ray. The first member is Embree's, so that a pointer to it is one to the
// whole.
struct CandidateContext
{
    RTCIntersectContext embree;
    EmbreeScene::Blocks blocks;
    void* query;
};

struct OfferContext
{
    RTCIntersectContext embree;
    EmbreeScene::Meets meets;
    void* query;
};

struct NearestContext
{
    RTCIntersectContext embree;
    EmbreeScene::Keeps keeps;
    const void* owner;
};

// Embree calls this for each triangle whose widened box the ray meets.
void offerCandidate(const RTCOccludedFunctionNArguments* args)
{
    LX_ASSERT(args->N == 1);
    if (!args->valid[0]) return;
    const auto* context = reinterpret_cast<const CandidateContext*>(args->context);
    if (context->blocks(context->query, args->primID)) reinterpret_cast<RTCRay*>(args->ray)->tfar = -INFINITY;
}

// Likewise, for each whose widened box begins before the nearest hit so far.
void offerUpToHit(const RTCIntersectFunctionNArguments* args)
{
    LX_ASSERT(args->N == 1);
    if (!args->valid[0]) return;
    const auto* context = reinterpret_cast<const OfferContext*>(args->context);
    auto* hit = reinterpret_cast<RTCRayHit*>(args->rayhit);
    const std::optional<double> t = context->meets(context->query, args->primID);
    if (!t) return;
    // Rounded up: what is nearer by less than floats tell is still offered.
    const float end = std::nextafter(std::max(float(*t), hit->ray.tnear), INFINITY);
    if (!(end < hit->ray.tfar)) return;
    hit->ray.tfar = end;
    hit->hit.geomID = args->geomID, hit->hit.primID = args->primID;
}

void filterHits(const RTCFilterFunctionNArguments* args)
{
    const auto* context = reinterpret_cast<const NearestContext*>(args->context);
    if (!context->keeps) return;
    for (unsigned i = 0; i < args->N; ++i) {
        if (args->valid[i] == 0) continue;
        const std::uint32_t triangle = RTCHitN_primID(args->hit, args->N, i);
        const float u = RTCHitN_u(args->hit, args->N, i), v = RTCHitN_v(args->hit, args->N, i);
        if (!context->keeps(context->owner, triangle, u, v)) args->valid[i] = 0;
    }
}

RTCRay toEmbree(const SearchRay& ray)
{
    RTCRay r{};
    r.org_x = ray.origin.x, r.org_y = ray.origin.y, r.org_z = ray.origin.z, r.tnear = ray.tMin;
    r.dir_x = ray.direction.x, r.dir_y = ray.direction.y, r.dir_z = ray.direction.z, r.tfar = ray.tMax;
    r.mask = ~0u;
    return r;
}

constexpr unsigned kPacket = 16;

} // namespace

struct EmbreeScene::State
{
    RTCDevice device = nullptr;
    RTCScene candidates = nullptr; // user geometry: boxes only, the test is ours
    RTCScene native = nullptr;     // Embree's own triangles
    std::vector<Vec3f> position;
    std::vector<std::uint32_t> indices;
    float margin = 0;

    ~State()
    {
        if (candidates) rtcReleaseScene(candidates);
        if (native) rtcReleaseScene(native);
        if (device) rtcReleaseDevice(device);
    }

    RTCScene newScene() const
    {
        RTCScene scene = rtcNewScene(device);
        rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
        return scene;
    }

    static void boundsOf(const RTCBoundsFunctionArguments* args)
    {
        const auto* state = static_cast<const State*>(args->geometryUserPtr);
        const std::uint32_t* corner = state->indices.data() + 3 * std::size_t(args->primID);
        const Vec3f a = state->position[corner[0]], b = state->position[corner[1]], c = state->position[corner[2]];
        RTCBounds& box = *args->bounds_o;
        box.lower_x = std::min({a.x, b.x, c.x}) - state->margin,
        box.upper_x = std::max({a.x, b.x, c.x}) + state->margin;
        box.lower_y = std::min({a.y, b.y, c.y}) - state->margin,
        box.upper_y = std::max({a.y, b.y, c.y}) + state->margin;
        box.lower_z = std::min({a.z, b.z, c.z}) - state->margin,
        box.upper_z = std::max({a.z, b.z, c.z}) + state->margin;
    }

    void buildCandidates()
    {
        candidates = newScene();
        RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
        rtcSetGeometryUserPrimitiveCount(geometry, unsigned(indices.size() / 3));
        rtcSetGeometryUserData(geometry, this);
        rtcSetGeometryBoundsFunction(geometry, boundsOf, nullptr);
        rtcSetGeometryOccludedFunction(geometry, offerCandidate);
        rtcSetGeometryIntersectFunction(geometry, offerUpToHit);
        attach(candidates, geometry);
    }

    void buildNative()
    {
        native = newScene();
        RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
        copyInto(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, sizeof(Vec3f), position.data(), position.size());
        copyInto(geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), indices.data(),
                 indices.size() / 3);
        rtcSetGeometryIntersectFilterFunction(geometry, filterHits);
        attach(native, geometry);
    }

    static void copyInto(RTCGeometry geometry, RTCBufferType type, RTCFormat format, std::size_t stride,
                         const void* data, std::size_t count)
    {
        void* buffer = rtcSetNewGeometryBuffer(geometry, type, 0, format, stride, count);
        if (!buffer) throw std::bad_alloc();
        std::memcpy(buffer, data, stride * count);
    }

    void attach(RTCScene scene, RTCGeometry geometry) const
    {
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene, geometry);
        rtcReleaseGeometry(geometry);
        rtcCommitScene(scene);
        if (rtcGetDeviceError(device) != RTC_ERROR_NONE)
            throw std::bad_alloc(); // all that a list of triangles can meet
    }
};

EmbreeScene::EmbreeScene(std::span<const Vec3f> positionLocal, std::span<const std::uint32_t> indices)
    : state_(std::make_unique<State>())
{
    state_->device = rtcNewDevice(nullptr);
    LX_ASSERT(state_->device);
    state_->position.assign(positionLocal.begin(), positionLocal.end());
    state_->indices.assign(indices.begin(), indices.end());
    float largest = 0;
    for (const std::uint32_t corner : indices) {
        LX_ASSERT(corner < positionLocal.size());
        const Vec3f p = positionLocal[corner];
        largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    }
    // Along an axis, a float ray that starts in the box of half size M strays from the one in double by 2^-24 M for its
    // origin and by 2^-24 * 2 sqrt(3) M for its direction; the walk through the tree, robust by flag, adds a few such
    // steps.
    state_->margin = std::max(0x1p-20f * largest, 0x1p-126f);
    if (indices.empty()) return;
    state_->buildCandidates();
    state_->buildNative();
}

EmbreeScene::EmbreeScene(EmbreeScene&&) noexcept = default;
EmbreeScene& EmbreeScene::operator=(EmbreeScene&&) noexcept = default;
EmbreeScene::~EmbreeScene() = default;

double EmbreeScene::margin() const { return state_->margin; }

bool EmbreeScene::anyBlocks(const SearchRay& ray, Blocks blocks, void* query) const
{
    if (!state_->candidates || !(ray.tMin <= ray.tMax)) return false;
    CandidateContext context{};
    rtcInitIntersectContext(&context.embree);
    context.blocks = blocks, context.query = query;
    RTCRay r = toEmbree(ray);
    rtcOccluded1(state_->candidates, &context.embree, &r);
    return r.tfar == -INFINITY;
}

void EmbreeScene::offerUpToNearest(const SearchRay& ray, Meets meets, void* query) const
{
    if (!state_->candidates || !(ray.tMin <= ray.tMax)) return;
    OfferContext context{};
    rtcInitIntersectContext(&context.embree);
    context.meets = meets, context.query = query;
    RTCRayHit rayHit{};
    rayHit.ray = toEmbree(ray);
    rayHit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(state_->candidates, &context.embree, &rayHit);
}

void EmbreeScene::nearest(std::span<const SearchRay> rays, std::span<SearchHit> hits, Keeps keeps,
                          const void* owner) const
{
    LX_ASSERT(rays.size() == hits.size());
    std::fill(hits.begin(), hits.end(), SearchHit{});
    if (!state_->native) return;
    NearestContext context{};
    rtcInitIntersectContext(&context.embree);
    context.embree.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    context.keeps = keeps, context.owner = owner;
    for (std::size_t first = 0; first < rays.size(); first += kPacket) {
        const auto count = unsigned(std::min<std::size_t>(kPacket, rays.size() - first));
        alignas(64) int valid[kPacket] = {};
        alignas(64) RTCRayHit16 packet{};
        for (unsigned i = 0; i < count; ++i) {
            const SearchRay& ray = rays[first + i];
            valid[i] = ray.tMin <= ray.tMax ? -1 : 0;
            packet.ray.org_x[i] = ray.origin.x, packet.ray.org_y[i] = ray.origin.y, packet.ray.org_z[i] = ray.origin.z;
            packet.ray.dir_x[i] = ray.direction.x, packet.ray.dir_y[i] = ray.direction.y;
            packet.ray.dir_z[i] = ray.direction.z;
            packet.ray.tnear[i] = ray.tMin, packet.ray.tfar[i] = ray.tMax, packet.ray.mask[i] = ~0u;
            packet.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
        }
        rtcIntersect16(valid, state_->native, &context.embree, &packet);
        for (unsigned i = 0; i < count; ++i)
            if (valid[i] && packet.hit.geomID[i] != RTC_INVALID_GEOMETRY_ID)
                hits[first + i] = {packet.hit.primID[i], packet.ray.tfar[i], packet.hit.u[i], packet.hit.v[i]};
    }
}

} // namespace lixel
