// SPDX-License-Identifier: MIT
// The words of GLSL that the files of this folder use, so that C++ reads the very same text: vec2, vec3, vec4, mat4, float
// (and double) arithmetic and a few functions. GLSL includes this file too and finds it empty but for the macros.
//
// Rules of the common subset: literals are floats with an f (0.5f), every value is named and constructed as vec3(x, y, z),
// components are .x .y .z .w one at a time, functions begin with LX_FN, and arguments are passed by value.
// Where both must come to the same bits, variables are LX_PRECISE: evaluated as written.
#ifndef LIXEL_SHARED_GLSL_H
#define LIXEL_SHARED_GLSL_H

#ifdef __cplusplus

#include <algorithm>
#include <bit>
#include <cmath>

#define LX_FN inline
#define LX_PRECISE
#define LX_SHARED_BEGIN namespace lixel::shared {
#define LX_SHARED_END }

namespace lixel::shared {

struct vec2
{
    float x = 0, y = 0;
    constexpr vec2() = default;
    constexpr vec2(float x_, float y_) : x(x_), y(y_) {}
    constexpr explicit vec2(float s) : x(s), y(s) {}
};

struct vec3
{
    float x = 0, y = 0, z = 0;
    constexpr vec3() = default;
    constexpr vec3(float x_, float y_, float z_) : x(x_), y(y_), z(z_) {}
    constexpr explicit vec3(float s) : x(s), y(s), z(s) {}
};

struct alignas(16) vec4
{
    float x = 0, y = 0, z = 0, w = 0;
    constexpr vec4() = default;
    constexpr vec4(float x_, float y_, float z_, float w_) : x(x_), y(y_), z(z_), w(w_) {}
    constexpr vec4(vec3 v, float w_) : x(v.x), y(v.y), z(v.z), w(w_) {}
    constexpr explicit vec4(float s) : x(s), y(s), z(s), w(s) {}
};

using uint = unsigned int;

struct alignas(16) uvec4
{
    uint x = 0, y = 0, z = 0, w = 0;
    constexpr uvec4() = default;
    constexpr uvec4(uint x_, uint y_, uint z_, uint w_) : x(x_), y(y_), z(z_), w(w_) {}
    constexpr uint operator[](int i) const { return i == 0 ? x : i == 1 ? y : i == 2 ? z : w; }
    constexpr uint& operator[](int i) { return i == 0 ? x : i == 1 ? y : i == 2 ? z : w; }
};

// Columns, as GLSL stores it.
struct mat4
{
    vec4 columns[4];
    constexpr vec4& operator[](int i) { return columns[i]; }
    constexpr const vec4& operator[](int i) const { return columns[i]; }
};

constexpr vec2 operator+(vec2 a, vec2 b) { return {a.x + b.x, a.y + b.y}; }
constexpr vec2 operator-(vec2 a, vec2 b) { return {a.x - b.x, a.y - b.y}; }
constexpr vec2 operator*(vec2 a, vec2 b) { return {a.x * b.x, a.y * b.y}; }
constexpr vec2 operator*(float s, vec2 a) { return {s * a.x, s * a.y}; }
constexpr vec2 operator*(vec2 a, float s) { return {a.x * s, a.y * s}; }
constexpr vec2 operator/(vec2 a, float s) { return {a.x / s, a.y / s}; }
constexpr vec3 operator+(vec3 a, vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
constexpr vec3 operator-(vec3 a, vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
constexpr vec3 operator-(vec3 a) { return {-a.x, -a.y, -a.z}; }
constexpr vec3 operator*(vec3 a, vec3 b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
constexpr vec3 operator/(vec3 a, vec3 b) { return {a.x / b.x, a.y / b.y, a.z / b.z}; }
constexpr vec3 operator*(float s, vec3 a) { return {s * a.x, s * a.y, s * a.z}; }
constexpr vec3 operator*(vec3 a, float s) { return {a.x * s, a.y * s, a.z * s}; }
constexpr vec3 operator/(vec3 a, float s) { return {a.x / s, a.y / s, a.z / s}; }
constexpr vec4 operator+(vec4 a, vec4 b) { return {a.x + b.x, a.y + b.y, a.z + b.z, a.w + b.w}; }
constexpr vec4 operator-(vec4 a, vec4 b) { return {a.x - b.x, a.y - b.y, a.z - b.z, a.w - b.w}; }
constexpr vec4 operator*(float s, vec4 a) { return {s * a.x, s * a.y, s * a.z, s * a.w}; }
constexpr vec4 operator*(vec4 a, float s) { return {a.x * s, a.y * s, a.z * s, a.w * s}; }
constexpr vec4 operator*(const mat4& m, vec4 v) { return v.x * m[0] + v.y * m[1] + v.z * m[2] + v.w * m[3]; }

constexpr float dot(vec2 a, vec2 b) { return a.x * b.x + a.y * b.y; }
constexpr float dot(vec3 a, vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
constexpr float dot(vec4 a, vec4 b) { return a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w; }
constexpr vec3 cross(vec3 a, vec3 b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }

inline uint floatBitsToUint(float a) { return std::bit_cast<uint>(a); }
inline float uintBitsToFloat(uint a) { return std::bit_cast<float>(a); }
inline int findLSB(uint a) { return a == 0 ? -1 : std::countr_zero(a); }
inline int bitCount(uint a) { return std::popcount(a); }

inline float abs(float a) { return std::fabs(a); }
inline float floor(float a) { return std::floor(a); }
inline float sqrt(float a) { return std::sqrt(a); }
inline float pow(float a, float b) { return std::pow(a, b); }
inline float exp(float a) { return std::exp(a); }
inline float exp2(float a) { return std::exp2(a); }
constexpr int min(int a, int b) { return b < a ? b : a; }
constexpr int max(int a, int b) { return a < b ? b : a; }
constexpr float min(float a, float b) { return b < a ? b : a; }
constexpr float max(float a, float b) { return a < b ? b : a; }
constexpr float clamp(float a, float low, float high) { return min(max(a, low), high); }
constexpr float mix(float a, float b, float t) { return a * (1.0f - t) + b * t; }
constexpr vec3 mix(vec3 a, vec3 b, float t) { return a * (1.0f - t) + b * t; }
inline float length(vec3 a) { return std::sqrt(dot(a, a)); }
inline vec3 normalize(vec3 a) { return a / length(a); }

} // namespace lixel::shared

#else

#define LX_FN
#define LX_PRECISE precise
#define LX_SHARED_BEGIN
#define LX_SHARED_END

#endif
#endif
