// SPDX-License-Identifier: MIT
#include "lixel/scene/animation.h"

#include "lixel/base/assert.h"

#include <algorithm>
#include <cmath>

namespace lixel {
namespace {

// Two keys and how far the time is between them, in [0, 1); or one key, twice.
struct Between
{
    std::size_t before = 0, after = 0;
    double fraction = 0, seconds = 0; // seconds from key to key
};

Between findKeys(const std::vector<float>& times, double time)
{
    const std::size_t last = times.size() - 1;
    if (!(time > times.front())) return {0, 0, 0, 0};
    if (time >= times.back()) return {last, last, 0, 0};
    const auto above =
        std::upper_bound(times.begin(), times.end(), time, [](double t, float key) { return t < double(key); });
    const std::size_t after = std::size_t(above - times.begin());
    const double seconds = double(times[after]) - double(times[after - 1]);
    return {after - 1, after, (time - double(times[after - 1])) / seconds, seconds};
}

void normalizeQuaternion(std::span<double> q)
{
    const double norm = std::hypot(std::hypot(q[0], q[1]), std::hypot(q[2], q[3]));
    if (!(norm > 1e-30)) {
        q[0] = q[1] = q[2] = 0, q[3] = 1;
        return;
    }
    for (double& component : q) component /= norm;
}

// Shoemake. Animating Rotation with Quaternion Curves. SIGGRAPH 1985. `a` and `b` are made unit first.
void slerp(std::span<const float> keyA, std::span<const float> keyB, double t, std::span<double> q)
{
    double a[4], b[4];
    std::copy(keyA.begin(), keyA.end(), a);
    std::copy(keyB.begin(), keyB.end(), b);
    normalizeQuaternion(a), normalizeQuaternion(b);
    double cosine = a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
    const double sign = cosine < 0 ? -1 : 1;
    cosine *= sign;

    // Nearly equal rotations: the chord is the arc, and the sine below would vanish.
    double weightA = 1 - t, weightB = t;
    if (cosine < 1 - 1e-9) {
        const double angle = std::acos(cosine);
        weightA = std::sin((1 - t) * angle) / std::sin(angle);
        weightB = std::sin(t * angle) / std::sin(angle);
    }
    for (std::size_t i = 0; i < 4; ++i) q[i] = weightA * a[i] + sign * weightB * b[i];
    normalizeQuaternion(q);
}

// Cubic Hermite: values and tangents (per second) at both keys.
double hermite(double value0, double tangent0, double value1, double tangent1, double t)
{
    const double t2 = t * t, t3 = t2 * t;
    return (2 * t3 - 3 * t2 + 1) * value0 + (t3 - 2 * t2 + t) * tangent0 + (3 * t2 - 2 * t3) * value1 +
           (t3 - t2) * tangent1;
}

} // namespace

double repeatedTime(const Animation& animation, double time)
{
    double end = 0;
    for (const AnimationChannel& channel : animation.channels)
        if (!channel.time.empty()) end = std::max(end, double(channel.time.back()));
    if (!(end > 0)) return 0;
    if (time >= 0 && time <= end) return time;
    const double rest = std::fmod(time, end);
    return rest < 0 ? rest + end : rest;
}

std::size_t valueSize(const AnimationChannel& channel)
{
    const std::size_t parts = channel.interpolation == Interpolation::CubicSpline ? 3 : 1;
    return channel.time.empty() ? 0 : channel.value.size() / (parts * channel.time.size());
}

void sampleChannel(const AnimationChannel& channel, double time, std::span<double> value)
{
    const std::size_t n = valueSize(channel);
    LX_ASSERT(n > 0 && value.size() == n);
    const bool isRotation = channel.path == AnimationPath::Rotation;
    LX_ASSERT(!isRotation || n == 4);
    const Between keys = findKeys(channel.time, time);

    // Cubic splines store in-tangent, value, out-tangent for each key.
    const bool isCubic = channel.interpolation == Interpolation::CubicSpline;
    const std::span<const float> all(channel.value);
    const auto keyValue = [&](std::size_t key) { return all.subspan(isCubic ? (3 * key + 1) * n : key * n, n); };
    const std::span<const float> v0 = keyValue(keys.before), v1 = keyValue(keys.after);

    if (channel.interpolation == Interpolation::Step || keys.before == keys.after || keys.fraction == 0) {
        std::copy(v0.begin(), v0.end(), value.begin());
    } else if (isCubic) {
        const std::span<const float> out0 = all.subspan((3 * keys.before + 2) * n, n),
                                     in1 = all.subspan(3 * keys.after * n, n);
        for (std::size_t i = 0; i < n; ++i)
            value[i] = hermite(double(v0[i]), keys.seconds * double(out0[i]), double(v1[i]),
                               keys.seconds * double(in1[i]), keys.fraction);
    } else if (isRotation) {
        slerp(v0, v1, keys.fraction, value);
    } else {
        for (std::size_t i = 0; i < n; ++i)
            value[i] = (1 - keys.fraction) * double(v0[i]) + keys.fraction * double(v1[i]);
    }
    if (isRotation) normalizeQuaternion(value);
}

Mat4d parentFromNodeMatrix(const NodeTransform& transform)
{
    if (transform.matrix) return *transform.matrix;
    const Vec4d q = transform.rotation;
    const Vec3d s = transform.scale, t = transform.translation;
    const double xx = q.x * q.x, yy = q.y * q.y, zz = q.z * q.z;
    const double xy = q.x * q.y, xz = q.x * q.z, yz = q.y * q.z, wx = q.w * q.x, wy = q.w * q.y, wz = q.w * q.z;
    return Mat4d::fromRows({(1 - 2 * (yy + zz)) * s.x, 2 * (xy - wz) * s.y, 2 * (xz + wy) * s.z, t.x},
                           {2 * (xy + wz) * s.x, (1 - 2 * (xx + zz)) * s.y, 2 * (yz - wx) * s.z, t.y},
                           {2 * (xz - wy) * s.x, 2 * (yz + wx) * s.y, (1 - 2 * (xx + yy)) * s.z, t.z}, {0, 0, 0, 1});
}

} // namespace lixel
