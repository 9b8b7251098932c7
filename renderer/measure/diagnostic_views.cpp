#include "measure/diagnostic_views.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/error.h"
#include "measure/picture_strip.h"
#include "shared/heat_color.shared.h"

namespace timeshade {

namespace {

constexpr double decades = 4.0;
constexpr Rgb falseShadowColor{40, 120, 255}, falseLitColor{255, 150, 20};

Rgb fromOklab(double lightness, double chroma, double hueDegrees) {
    return eightBits(shared::srgbOfOklab(static_cast<float>(lightness), static_cast<float>(chroma),
                                         static_cast<float>(hueDegrees * 3.14159265358979 / 180.0)));
}

/// 0: nearly black, by way of violet and orange, 1: pale yellow.
Rgb errorColor(double t) {
    return fromOklab(0.08 + 0.88 * t, 0.19 * std::pow(std::sin(3.14159265 * (0.08 + 0.84 * t)), 0.8),
                     300.0 + 165.0 * t);
}

void setPixel(DisplayImage& image, std::size_t pixel, Rgb color) {
    image.rgb[3 * pixel] = color.red;
    image.rgb[3 * pixel + 1] = color.green;
    image.rgb[3 * pixel + 2] = color.blue;
}

/// Each pixel as a square of so many a side.
DisplayImage enlargedBy(const DisplayImage& picture, int factor) {
    if (factor == 1) return picture;
    DisplayImage large{picture.width * factor, picture.height * factor, {}};
    large.rgb.reserve(picture.rgb.size() * static_cast<std::size_t>(factor * factor));
    for (int y = 0; y < large.height; ++y)
        for (int x = 0; x < large.width; ++x) {
            const auto pixel = static_cast<std::ptrdiff_t>(y / factor) * picture.width + x / factor;
            large.rgb.insert(large.rgb.end(), picture.rgb.begin() + 3 * pixel, picture.rgb.begin() + 3 * pixel + 3);
        }
    return large;
}

std::uint8_t mix(double from, double to, double share) {
    return static_cast<std::uint8_t>(std::lround(from + (to - from) * share));
}

}  // namespace

DisplayImage errorView(const LinearImage& image, const LinearImage& reference, double fullScale, int enlarged) {
    if (image.width != reference.width || image.height != reference.height)
        throw Error(fmt::format("a picture of {} x {} cannot be compared with a reference of {} x {}", image.width,
                                image.height, reference.width, reference.height));
    DisplayImage out{image.width, image.height, std::vector<std::uint8_t>(image.rgb.size())};
    for (std::size_t pixel = 0; pixel < image.rgb.size() / 3; ++pixel) {
        double difference = 0.0;
        for (std::size_t c = 0; c < 3; ++c)
            difference = std::max(difference, std::abs(static_cast<double>(image.rgb[3 * pixel + c]) -
                                                       static_cast<double>(reference.rgb[3 * pixel + c])));
        setPixel(out, pixel,
                 errorColor(difference > 0.0 ? std::clamp(1.0 + std::log10(difference / fullScale) / decades, 0.0, 1.0)
                                             : 0.0));
    }
    out = enlargedBy(out, enlarged);
    return withStrip(out, [&](ChartCanvas& canvas, const ChartFont& font) {
        const double left = 12.0, right = std::max(left + 1.0, out.width - 12.0);
        for (double x = left; x < right; x += 1.0)
            canvas.fillBox({x, 4.0, x + 1.0, 14.0}, errorColor((x + 0.5 - left) / (right - left)));
        for (int decade = 0; decade <= 4; ++decade) {
            const std::string text = fmt::format("{:g}", fullScale * std::pow(10.0, decade - decades));
            const double x = left + (right - left) * decade / decades, width = font.width(text, 12.0);
            writeOnStrip(canvas, font, text, std::clamp(x - 0.5 * width, left, std::max(left, right - width)), 28.0);
        }
    });
}

DisagreementView::DisagreementView(int width, int height)
    : width_(width), height_(height), pixels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}

void DisagreementView::add(const VerifiedSample& sample) {
    if (!sample.truth.tested) return;
    Counts& counts =
        pixels_[(static_cast<std::size_t>(height_) - 1 - sample.index.y) * static_cast<std::size_t>(width_) +
                sample.index.x];
    ++counts.tested;
    const bool lit = sample.lit >= 0.5f;
    if (lit != sample.truth.lit) ++(lit ? counts.falseLit : counts.falseShadow);
}

DisplayImage DisagreementView::draw(const DisplayImage& picture, int enlarged) const {
    DisplayImage out = picture;
    unsigned long falseShadow = 0, falseLit = 0;
    for (std::size_t pixel = 0; pixel < pixels_.size(); ++pixel) {
        const Counts& counts = pixels_[pixel];
        falseShadow += counts.falseShadow;
        falseLit += counts.falseLit;
        const double grey =
            0.5 * (0.2126 * out.rgb[3 * pixel] + 0.7152 * out.rgb[3 * pixel + 1] + 0.0722 * out.rgb[3 * pixel + 2]);
        const double tested = std::max(1u, counts.tested), shadow = counts.falseShadow / tested,
                     lit = counts.falseLit / tested;
        // The root lets one wrong sample of many be seen.
        const double strength = std::sqrt(shadow + lit), part = shadow + lit > 0.0 ? lit / (shadow + lit) : 0.0;
        setPixel(out, pixel,
                 {mix(grey, mix(falseShadowColor.red, falseLitColor.red, part), strength),
                  mix(grey, mix(falseShadowColor.green, falseLitColor.green, part), strength),
                  mix(grey, mix(falseShadowColor.blue, falseLitColor.blue, part), strength)});
    }
    out = enlargedBy(out, enlarged);
    return withStrip(out, [&](ChartCanvas& canvas, const ChartFont& font) {
        const double half = 0.5 * out.width, room = half - 12.0 - 18.0;
        const auto write = [&](double left, Rgb color, const std::string& counted) {
            canvas.fillBox({left, 10.0, left + 12.0, 22.0}, color);
            const std::string whole = counted + " samples";
            writeOnStrip(canvas, font, font.width(whole, 12.0) > room ? counted : whole, left + 18.0, 21.0);
        };
        write(12.0, falseShadowColor, fmt::format("false shadow: {}", falseShadow));
        write(half, falseLitColor, fmt::format("false lit: {}", falseLit));
    });
}

}  // namespace timeshade
