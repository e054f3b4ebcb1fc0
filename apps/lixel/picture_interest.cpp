// SPDX-License-Identifier: MIT
#include "picture_interest.h"

#include "lixel/trace/exact_visibility.h"
#include "lixel/trace/trace_view_samples.h"

#include <algorithm>
#include <cmath>

namespace lixel::app {
namespace {

constexpr double kJump = 1.2;            // ratio of distances that is a contour
constexpr double kCrease = 0.7;          // cosine between normals below which there is one
constexpr double kSmooth = 0.95;         // and above which two pixels show one surface
constexpr double kBorderWeight = 2;      // of a shadow's border, compared with a contour
constexpr double kEnoughLit = 1.0 / 3.0; // share of the pixels

struct Features
{
    std::size_t contours = 0, borders = 0;
};

class Picture
{
public:
    Picture(const TraceScene& scene, const View& view, Vec3d eyeWorld, const Light& light)
        : width_(std::size_t(view.width)),
          height_(std::size_t(view.height)),
          samples_(traceViewSamples(scene, view)),
          visibility_(exactVisibility(scene, samples_, light)),
          sampleAt_(width_ * height_, kNothing)
    {
        for (std::size_t i = 0; i < samples_.size(); ++i) {
            sampleAt_[std::size_t(samples_.pixel[i].y) * width_ + std::size_t(samples_.pixel[i].x)] = i;
            distance_.push_back(length(toDouble(samples_.positionLocal[i]) + samples_.originWorld - eyeWorld));
        }
    }

    double share(std::size_t count) const { return double(count) / double(width_ * height_); }

    double lit() const { return share(std::size_t(std::count(visibility_.begin(), visibility_.end(), 1.0f))); }

    double nearerThan(double limit) const
    {
        return share(
            std::size_t(std::count_if(distance_.begin(), distance_.end(), [&](double d) { return d < limit; })));
    }

    double medianDistance() const
    {
        if (distance_.empty()) return 0;
        std::vector<double> sorted = distance_;
        const auto middle = sorted.begin() + std::ptrdiff_t(sorted.size() / 2);
        std::nth_element(sorted.begin(), middle, sorted.end());
        return *middle;
    }

    Features features() const
    {
        Features found;
        for (std::size_t y = 0; y < height_; ++y)
            for (std::size_t x = 0; x < width_; ++x) {
                const std::size_t here = y * width_ + x;
                if (x + 1 < width_) compare(sampleAt_[here], sampleAt_[here + 1], found);
                if (y + 1 < height_) compare(sampleAt_[here], sampleAt_[here + width_], found);
            }
        return found;
    }

private:
    static constexpr std::size_t kNothing = std::size_t(-1);

    void compare(std::size_t a, std::size_t b, Features& found) const
    {
        if (a == kNothing || b == kNothing) {
            found.contours += a != b;
            return;
        }
        const auto [nearer, farther] = std::minmax(distance_[a], distance_[b]);
        const double cosine = dot(toDouble(samples_.normal[a]), toDouble(samples_.normal[b]));
        if (farther > kJump * nearer || cosine < kCrease) ++found.contours;
        else if (cosine > kSmooth && visibility_[a] != visibility_[b]) ++found.borders;
    }

    std::size_t width_, height_;
    ViewSamples samples_;
    std::vector<float> visibility_;
    std::vector<std::size_t> sampleAt_; // one a pixel
    std::vector<double> distance_;      // one a sample
};

} // namespace

double pictureInterest(const TraceScene& scene, const View& view, Vec3d eyeWorld, const Light& light, double tooNear)
{
    const Picture picture(scene, view, eyeWorld, light);
    const Features found = picture.features();
    const double free = 1 - picture.nearerThan(tooNear);
    return (picture.share(found.contours) + kBorderWeight * picture.share(found.borders)) * free * free *
           std::sqrt(picture.medianDistance()) * std::min(1.0, picture.lit() / kEnoughLit);
}

} // namespace lixel::app
