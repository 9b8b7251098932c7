#include "window/trail_chart.h"

#include <algorithm>

#include <fmt/format.h>

#include "chart/chart_layout.h"
#include "techniques/registry.h"
#include "window/accuracy.h"
#include "window/display_texture.h"

namespace timeshade {

namespace {

/// Points of one curve differ in nothing but their sample count.
bool onOneCurve(const ProbeSubject& a, const ProbeSubject& b) {
    return a.technique == b.technique && a.mapSize == b.mapSize &&
           (a.settings == b.settings || sampleCountLabel(a).back() == 'x');
}

std::string nameOf(const std::vector<std::vector<const ProbePoint*>>& curves, const ProbeSubject& subject) {
    int alike = 0;
    for (const auto& curve : curves) alike += curve.front()->subject.technique == subject.technique ? 1 : 0;
    const std::string& title = techniqueDescription(subject.technique).shortTitle;
    return alike == 0 ? title : fmt::format("{} ({})", title, alike + 1);
}

}  // namespace

Chart trailChart(const std::vector<ProbePoint>& trail, bool softwareRenderer) {
    Chart chart;
    chart.xLabel = softwareRenderer ? "ms (software renderer)" : "ms";
    chart.yLabel = "shadow error";
    std::vector<std::vector<const ProbePoint*>> curves;
    for (const ProbePoint& point : trail) {
        const auto fits = [&](const auto& curve) { return onOneCurve(curve.front()->subject, point.subject); };
        const auto found = std::find_if(curves.begin(), curves.end(), fits);
        if (found != curves.end()) {
            found->push_back(&point);
            continue;
        }
        chart.series.push_back({nameOf(curves, point.subject), {}});
        curves.push_back({&point});
    }
    for (std::size_t i = 0; i < curves.size(); ++i) {
        // More samples take more time, but for noise; the labels' numbers are the order.
        std::sort(curves[i].begin(), curves[i].end(), [](const ProbePoint* a, const ProbePoint* b) {
            return std::stoi(sampleCountLabel(a->subject)) < std::stoi(sampleCountLabel(b->subject));
        });
        for (const ProbePoint* point : curves[i])
            chart.series[i].points.push_back(
                {point->milliseconds, point->shadowError, sampleCountLabel(point->subject)});
    }
    return chart;
}

void TrailChart::update(const std::vector<ProbePoint>& trail, const ProbePoint* current, int revision, int width,
                        int height, double scale, bool softwareRenderer) {
    const bool fits = texture_ && texture_->width() == width && texture_->height() == height && scale == scale_;
    if (fits && revision == revision_) return;
    const Chart chart = trailChart(trail, softwareRenderer);
    const DisplayImage image = drawChart(chart, width, height, scale);
    current_.reset();
    if (current != nullptr) {
        const ChartPoint point{current->milliseconds, current->shadowError, ""};
        if (isDrawable(point)) current_ = layoutChart(chart, ChartFonts(), width, height, scale).pixelOf(point);
    }
    upload(texture_, image);
    revision_ = revision;
    scale_ = scale;
}

}  // namespace timeshade
