#include "window/preview_quality.h"

#include <algorithm>
#include <cmath>

namespace timeshade {

namespace {
struct Level {
    double side;  ///< of the picture, relative to all of it
    int samplesDivisor;
    int mapDivisor;
};
constexpr std::array<Level, PreviewQuality::levels> ladder{{{1.0, 1, 1},
                                                            {0.7, 1, 1},
                                                            {0.5, 1, 1},
                                                            {0.35, 1, 1},
                                                            {0.25, 1, 1},
                                                            {0.25, 2, 1},
                                                            {0.25, 4, 1},
                                                            {0.2, 4, 2},
                                                            {0.2, 4, 4},
                                                            {0.2, 16, 32}}};
constexpr int coarse = 4;  // the first level of the choice of that name
constexpr double fastMilliseconds = 50.0;
constexpr int framesUntilRetry = 40;
constexpr int mostMap = 2048;  // of a preview: finer than any of its pixels
// Below these nothing can be recognised any more.
constexpr int leastSamples = 2, leastMap = 256, leastSide = 96;

int reducedTo(int full, int divisor, int least) { return std::min(full, std::max(full / divisor, least)); }

/// How many levels up are worth trying at once.
int stepFor(double milliseconds) {
    if (milliseconds > 16.0 * PreviewQuality::slowMilliseconds) return 5;
    if (milliseconds > 8.0 * PreviewQuality::slowMilliseconds) return 4;
    if (milliseconds > 4.0 * PreviewQuality::slowMilliseconds) return 3;
    if (milliseconds > 2.0 * PreviewQuality::slowMilliseconds) return 2;
    return 1;
}
}  // namespace

int PreviewQuality::level() const {
    if (choice_ == Choice::Full) return 0;
    return choice_ == Choice::Coarse ? std::max(level_, coarse) : level_;
}

FrameRequest PreviewQuality::reduced(FrameRequest full, int level) const {
    const Level& l = ladder[static_cast<std::size_t>(level)];
    const double least = std::min(1.0, leastSide / static_cast<double>(std::max({full.width, full.height, 1})));
    const double share = std::max(l.side, least);
    full.width = std::max(1, static_cast<int>(std::lround(full.width * share)));
    full.height = std::max(1, static_cast<int>(std::lround(full.height * share)));
    full.samplesPerPixel = reducedTo(full.samplesPerPixel, l.samplesDivisor, leastSamples);
    const auto side = [&](int map) {
        return reducedTo(level > 0 ? std::min(map, mostMap) : map, l.mapDivisor, leastMap);
    };
    full.mapSize = {side(full.mapSize.width), side(full.mapSize.height)};
    return full;
}

void PreviewQuality::forget() {
    cost_.fill(std::nullopt);
    fastFrames_ = 0;
}

void PreviewQuality::measured(int level, double milliseconds) {
    cost_[static_cast<std::size_t>(level)] = milliseconds;
    const bool fast = milliseconds < fastMilliseconds;
    fastFrames_ = fast && level == level_ ? fastFrames_ + 1 : 0;
    if (milliseconds > slowMilliseconds) {
        level_ = std::min(std::max(level_, level + stepFor(milliseconds)), levels - 1);
    } else if (fast && level < level_) {
        level_ = level;
    } else if (fastFrames_ > 0 && level > 0) {
        // What was slow once may have compiled shaders then: it is tried again now and then.
        const std::optional<double>& below = cost_[static_cast<std::size_t>(level - 1)];
        if (!below || *below <= slowMilliseconds || fastFrames_ >= framesUntilRetry) {
            level_ = level - 1;
            fastFrames_ = 0;
        }
    }
}

namespace {
constexpr std::array<const char*, 3> choiceNames{"full", "automatic", "coarse"};
}  // namespace

std::string nameOf(PreviewQuality::Choice choice) { return choiceNames[static_cast<std::size_t>(choice)]; }

std::optional<PreviewQuality::Choice> previewOf(const std::string& name) {
    for (std::size_t i = 0; i < choiceNames.size(); ++i)
        if (name == choiceNames[i]) return static_cast<PreviewQuality::Choice>(i);
    return std::nullopt;
}

}  // namespace timeshade
