#include "measure/sweep_journal.h"

#include <cmath>
#include <fstream>
#include <limits>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "measure/verification_json.h"

namespace timeshade {

namespace {

using Json = nlohmann::ordered_json;

/// JSON has no infinity, which the PSNR of equal pictures is.
Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }
double numberOf(const Json& json) {
    return json.is_null() ? std::numeric_limits<double>::infinity() : json.get<double>();
}

}  // namespace

std::string rowAsJson(const SweepRow& row) {
    Json json;
    json["scene"] = row.point.scene;
    json["technique"] = row.point.technique;
    json["spp"] = row.point.sampleCount;
    json["map"] = row.point.mapSize;
    json["state"] = nameOf(row.state);
    json["renders"] = row.renders;
    if (!row.point.varied.empty()) json["varied"] = {{"key", row.point.varied}, {"value", row.point.variedValue}};
    for (const auto& [name, timing] : row.steps)
        json["milliseconds"][name] = {{"median", timing.median}, {"low", timing.low}, {"high", timing.high}};
    json["error"] = {{"rmse", number(row.error.rmse)},
                     {"relative_mse", number(row.error.relativeMse)},
                     {"psnr", number(row.error.psnr)},
                     {"mean_absolute", number(row.error.meanAbsolute)},
                     {"p999", number(row.error.p999)},
                     {"off_by_30", number(row.error.offBy30.value_or(0.0))},
                     {"reference_noise", number(row.referenceNoise)},
                     {"bias", number(row.biasAndNoise.bias)},
                     {"noise", number(row.biasAndNoise.noise)},
                     {"mean_error", number(row.biasAndNoise.meanError)}};
    json["verify"] = asJson(row.verification);
    json["bytes"] = {{"total", row.bytes}, {"technique", row.techniqueBytes}};
    json["figures"] = Json::array();
    for (const TechniqueStatistic& figure : row.statistics)
        json["figures"].push_back({{"name", figure.name},
                                   {"value", number(figure.value)},
                                   {"unit", figure.unit},
                                   {"warning", figure.warning}});
    return json.dump();
}

SweepRow rowFromJson(const std::string& text) {
    const Json json = Json::parse(text);
    SweepRow row;
    row.point = {json.at("scene"), json.at("technique"), json.at("spp"), json.at("map"), "", 0.0};
    row.state = frameStateNamed(json.value("state", "")).value_or(FrameState::Filling);
    row.renders = json.value("renders", 1);
    if (json.contains("varied")) {
        row.point.varied = json.at("varied").at("key");
        row.point.variedValue = json.at("varied").at("value");
    }
    for (const auto& [name, timing] : json.at("milliseconds").items())
        row.steps[name] = {timing.at("median"), timing.at("low"), timing.at("high")};
    const Json& error = json.at("error");
    row.error.rmse = numberOf(error.at("rmse"));
    row.error.relativeMse = numberOf(error.at("relative_mse"));
    row.error.psnr = numberOf(error.at("psnr"));
    row.error.meanAbsolute = numberOf(error.at("mean_absolute"));
    row.error.p999 = numberOf(error.at("p999"));
    row.error.offBy30 = numberOf(error.at("off_by_30"));
    row.referenceNoise = error.contains("reference_noise") ? numberOf(error.at("reference_noise")) : 0.0;
    row.biasAndNoise.bias = numberOf(error.at("bias"));
    row.biasAndNoise.noise = numberOf(error.at("noise"));
    row.biasAndNoise.meanError = numberOf(error.at("mean_error"));
    row.verification = verificationOf(json.at("verify"));
    row.bytes = json.at("bytes").at("total");
    row.techniqueBytes = json.at("bytes").at("technique");
    for (const Json& figure : json.at("figures"))
        row.statistics.push_back(
            {figure.at("name"), numberOf(figure.at("value")), figure.at("unit"), figure.at("warning")});
    return row;
}

SweepJournal::SweepJournal(std::filesystem::path path, const std::string& experiment) : path_(std::move(path)) {
    std::ifstream stream(path_);
    std::string line;
    const std::string header = Json{{"experiment", experiment}}.dump();
    std::string kept = header + "\n";
    if (std::getline(stream, line) && line == header) {
        while (std::getline(stream, line)) {
            try {
                rows_.push_back(rowFromJson(line));
            } catch (const nlohmann::json::exception&) {
                break;  // cut off in the middle
            }
            kept += line + "\n";
        }
    }
    stream.close();
    writeFileAtomically(path_, kept);
}

const SweepRow* SweepJournal::find(const SweepPoint& point, FrameState state) const {
    for (const SweepRow& row : rows_)
        if (row.state == state && row.point.key() == point.key()) return &row;
    return nullptr;
}

void SweepJournal::append(const SweepRow& row) {
    rows_.push_back(row);
    std::ofstream stream(path_, std::ios::app);
    stream << rowAsJson(row) << std::endl;
    if (!stream) throw Error(fmt::format("{}: cannot be written to", path_.string()));
}

}  // namespace timeshade
