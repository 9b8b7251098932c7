#include "measure/equal_search.h"

#include <algorithm>
#include <cmath>

#include "measure/sample_count_search.h"

namespace timeshade {

namespace {

/// How often the two neighbours may be exchanged for the next ones.
constexpr int corrections = 4;

std::size_t placeOf(const std::vector<int>& sampleCounts, int sampleCount) {
    return static_cast<std::size_t>(std::lower_bound(sampleCounts.begin(), sampleCounts.end(), sampleCount) -
                                    sampleCounts.begin());
}

/// Where the search says that 1 lies: the place of the first of two neighbours.
std::size_t searchTime(const std::vector<int>& sampleCounts, const MeasureRatios& measure) {
    SampleCountSearch search(sampleCounts, 1.0, SampleCountSearch::Value::Rises);
    while (const std::optional<int> next = search.next()) search.measured(measure({*next}, false).front());
    const auto below = search.shortOfTarget();
    const std::size_t last = sampleCounts.size() < 2 ? 0 : sampleCounts.size() - 2;
    return below ? std::min(placeOf(sampleCounts, below->sampleCount), last) : 0;
}

}  // namespace

bool isEqualRatio(double ratio) { return std::abs(ratio - 1.0) <= equalTolerance; }

bool EqualFind::isEqual() const { return isEqualRatio(chosen.ratio); }

EqualFind findEqualTime(const std::vector<int>& sampleCounts, const MeasureRatios& measure) {
    std::size_t at = searchTime(sampleCounts, measure);
    const std::size_t count = std::min<std::size_t>(2, sampleCounts.size());
    std::vector<double> ratios;
    for (int i = 0; i <= corrections; ++i) {
        const auto begin = sampleCounts.begin() + static_cast<std::ptrdiff_t>(at);
        ratios = measure({begin, begin + static_cast<std::ptrdiff_t>(count)}, true);
        if (i == corrections) break;
        if (ratios.front() > 1.0 && at > 0)
            --at;
        else if (ratios.back() < 1.0 && at + count < sampleCounts.size())
            ++at;
        else
            break;
    }
    EqualFind find;
    for (std::size_t i = 0; i < count; ++i) {
        const EqualTrial trial{sampleCounts[at + i], ratios[i]};
        if (trial.ratio < 1.0)
            find.fewer = trial;
        else if (!find.more)
            find.more = trial;
        if (i == 0 || std::abs(std::log(trial.ratio)) < std::abs(std::log(find.chosen.ratio))) find.chosen = trial;
    }
    find.found = find.isEqual();
    return find;
}

EqualFind findEqualError(const std::vector<int>& sampleCounts, const MeasureRatios& measure) {
    SampleCountSearch search(sampleCounts, 1.0 + equalTolerance, SampleCountSearch::Value::Falls);
    std::optional<EqualTrial> least;
    while (const std::optional<int> next = search.next()) {
        const EqualTrial trial{*next, measure({*next}, true).front()};
        if (!least || trial.ratio < least->ratio) least = trial;
        search.measured(trial.ratio);
    }
    EqualFind find;
    if (const auto before = search.shortOfTarget()) find.fewer = {before->sampleCount, before->value};
    if (const auto past = search.pastTarget()) find.more = {past->sampleCount, past->value};
    find.found = find.more.has_value();
    find.chosen = find.found ? *find.more : *least;
    return find;
}

}  // namespace timeshade
