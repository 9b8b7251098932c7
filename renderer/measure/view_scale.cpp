#include "measure/view_scale.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "measure/picture_strip.h"
#include "shared/heat_color.shared.h"

namespace timeshade {

namespace {

double shareOf(const TechniqueView& view, double value) {
    return static_cast<double>(shared::heatShare(static_cast<float>(value), static_cast<float>(view.low),
                                                 static_cast<float>(view.high), view.logarithmic));
}

}  // namespace

double roundStep(double least) {
    const double power = std::pow(10.0, std::floor(std::log10(least)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * power >= least * (1.0 - 1e-9)) return factor * power;
    return 10.0 * power;
}

std::vector<ScaleMark> marksOf(const TechniqueView& view) {
    std::vector<double> values{view.low};
    if (view.logarithmic) {
        // Powers of two or of ten, whichever leaves room to read them.
        const double base = view.high / view.low <= 64.0 ? 2.0 : 10.0;
        for (double value = std::pow(base, std::floor(std::log(view.low) / std::log(base) + 1e-9) + 1.0);
             value < view.high; value *= base)
            values.push_back(value);
    } else {
        const double step = roundStep((view.high - view.low) / 5.0);
        for (double value = (std::floor(view.low / step + 1e-9) + 1.0) * step; value < view.high - 1e-9 * step;
             value += step)
            values.push_back(value);
    }
    // A round number right before the end would be written over it.
    while (values.size() > 1 && shareOf(view, values.back()) > 0.9) values.pop_back();
    while (values.size() > 1 && shareOf(view, values[1]) < 0.06) values.erase(values.begin() + 1);
    values.push_back(view.high);
    std::vector<ScaleMark> marks;
    for (const double value : values) marks.push_back({shareOf(view, value), fmt::format("{:g}", value)});
    if (!view.unit.empty()) marks.back().text += " " + view.unit;
    return marks;
}

DisplayImage withScale(const DisplayImage& picture, const TechniqueView& view) {
    return withStrip(picture, [&](ChartCanvas& canvas, const ChartFont& font) {
        const double left = 12.0, right = std::max(left + 1.0, picture.width - 12.0);
        for (double x = left; x < right; x += 1.0)
            canvas.fillBox({x, 4.0, x + 1.0, 14.0},
                           eightBits(shared::heatColor(static_cast<float>((x + 0.5 - left) / (right - left)))));
        const std::vector<ScaleMark> marks = marksOf(view);
        const auto leftOf = [&](const ScaleMark& mark) {
            const double width = widthOnStrip(font, mark.text);
            return std::clamp(left + (right - left) * mark.share - 0.5 * width, left, std::max(left, right - width));
        };
        // The ends first; what lies between only where there is room.
        const double lastLeft = leftOf(marks.back());
        writeOnStrip(canvas, font, marks.back().text, lastLeft, 28.0);
        double free = 0.0;
        for (std::size_t i = 0; i + 1 < marks.size(); ++i) {
            const double at = leftOf(marks[i]), end = at + widthOnStrip(font, marks[i].text);
            if (at < free || end + 8.0 > lastLeft) continue;
            writeOnStrip(canvas, font, marks[i].text, at, 28.0);
            free = end + 8.0;
        }
    });
}

}  // namespace timeshade
