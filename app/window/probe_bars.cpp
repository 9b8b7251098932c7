#include "window/probe_bars.h"

#include <algorithm>
#include <tuple>

namespace timeshade {

std::vector<ProbeBar> barsOf(std::vector<ProbeValue> values, float ProbeValue::*shown, float mark) {
    std::erase_if(values, [](const ProbeValue& value) { return value.lit < 0.0f; });
    const auto order = [](const ProbeValue& v) { return std::make_tuple(v.from, v.to, -v.lit, -v.truth); };
    std::sort(values.begin(), values.end(),
              [&](const ProbeValue& a, const ProbeValue& b) { return order(a) < order(b); });
    std::vector<ProbeBar> bars;
    for (auto first = values.begin(); first != values.end();) {
        const auto last = std::find_if(first, values.end(),
                                       [&](const ProbeValue& v) { return v.from != first->from || v.to != first->to; });
        ProbeBar bar{first->from, first->to};
        if (first->from == first->to) {
            bar.left = std::clamp(first->from - 0.5f * mark, 0.0f, 1.0f - mark);
            bar.right = bar.left + mark;
        }
        const auto count = static_cast<float>(last - first);
        for (float row = 0.0f; first != last; ++first, row += 1.0f) {
            bar.top = row / count;
            bar.bottom = (row + 1.0f) / count;
            bar.grey = (*first).*shown;
            if (bar.grey >= 0.0f) bars.push_back(bar);
        }
    }
    return bars;
}

}  // namespace timeshade
