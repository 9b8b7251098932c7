#include "window/frame_times.h"

#include <algorithm>

namespace timeshade {

namespace {
double median(std::vector<double> values) {
    if (values.empty()) return 0.0;
    std::sort(values.begin(), values.end());
    const std::size_t half = values.size() / 2;
    return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}
}  // namespace

void FrameTimes::add(const std::vector<gl::PassTimer::Reading>& readings) {
    if (readings.empty()) return;
    frames_.push_back(readings);
    if (frames_.size() > kept) frames_.pop_front();
}

std::vector<gl::PassTimer::Reading> FrameTimes::medians() const {
    std::vector<gl::PassTimer::Reading> result;
    if (frames_.empty()) return result;
    for (const auto& pass : frames_.back()) {
        std::vector<double> values;
        for (const auto& frame : frames_)
            for (const auto& reading : frame)
                if (reading.name == pass.name) values.push_back(reading.milliseconds);
        result.push_back({pass.name, median(values)});
    }
    return result;
}

double FrameTimes::medianTotal() const {
    std::vector<double> totals;
    for (const auto& frame : frames_) totals.push_back(gl::totalOf(frame));
    return median(totals);
}

}  // namespace timeshade
