#include "measure/sweep_rows.h"

#include <algorithm>
#include <limits>
#include <set>

#include <fmt/format.h>

namespace timeshade {

const std::vector<std::string> frameSteps{"sample", "build", "lookup", "shade", "total"};

Timing stepOf(const SweepRow& row, const std::string& name) {
    const auto found = row.steps.find(name);
    return found == row.steps.end() ? Timing{} : found->second;
}

std::vector<std::string> partsOf(const std::vector<SweepRow>& rows, const std::string& scene) {
    std::set<std::string> parts;
    for (const SweepRow& row : rows)
        for (const auto& [name, timing] : row.steps)
            if (name.find('/') != std::string::npos && (scene.empty() || row.point.scene == scene)) parts.insert(name);
    return {parts.begin(), parts.end()};
}

std::vector<std::string> scenesOf(const std::vector<SweepRow>& rows) {
    std::vector<std::string> scenes;
    for (const SweepRow& row : rows)
        if (std::find(scenes.begin(), scenes.end(), row.point.scene) == scenes.end()) scenes.push_back(row.point.scene);
    return scenes;
}

const SweepRow* variedRow(const std::vector<SweepRow>& rows, const std::string& scene) {
    const auto found = std::find_if(rows.begin(), rows.end(), [&](const SweepRow& row) {
        return row.point.scene == scene && !row.point.varied.empty();
    });
    return found == rows.end() ? nullptr : &*found;
}

std::vector<SweepRow> rowsOfCharts(const std::vector<SweepRow>& rows) {
    std::vector<SweepRow> chosen;
    for (const SweepRow& row : rows) {
        const auto same = std::find_if(chosen.begin(), chosen.end(),
                                       [&](const SweepRow& other) { return other.point.key() == row.point.key(); });
        if (same == chosen.end())
            chosen.push_back(row);
        else if (row.state == FrameState::Steady)
            *same = row;
    }
    return chosen;
}

std::string curveName(const std::vector<SweepRow>& rows, const SweepPoint& point) {
    std::set<MapSize> maps;
    for (const SweepRow& row : rows)
        if (row.point.technique == point.technique) maps.insert(row.point.mapSize);
    return maps.size() > 1 ? fmt::format("{}, map {}", point.technique, point.mapSize.text()) : point.technique;
}

double shadowErrorOf(const SweepRow& row) {
    return row.verification.shadowError ? row.verification.shadowError->error.rms
                                        : std::numeric_limits<double>::quiet_NaN();
}

double wrongPpmOf(const SweepRow& row) {
    return row.verification.isBinary() ? row.verification.ppm() : std::numeric_limits<double>::quiet_NaN();
}

bool haveShadowErrors(const std::vector<SweepRow>& rows) {
    return std::any_of(rows.begin(), rows.end(),
                       [](const SweepRow& row) { return row.verification.shadowError.has_value(); });
}

std::string sampleCountLabel(const SweepRow& row) {
    return row.renders > 1 ? fmt::format("{}x", row.renders) : fmt::format("{}", row.point.sampleCount);
}

}  // namespace timeshade
