#include "measure/sweep_row_json.h"

#include <cmath>
#include <limits>
#include <sstream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/json_limits.h"
#include "measure/json_numbers.h"
#include "measure/map_size_json.h"
#include "measure/verification_json.h"

namespace timeshade {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t longestLine = std::size_t{1} << 20;

/// JSON has no infinity, which the PSNR of equal pictures is.
Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }
double numberOf(const Json& json) {
    return json.is_null() ? std::numeric_limits<double>::infinity() : json.get<double>();
}

MadeWith madeWithOf(const Json& json) {
    MadeWith madeWith;
    if (json.contains("made_with"))
        for (const auto& [part, text] : json.at("made_with").items()) madeWith.emplace_back(part, text);
    return madeWith;
}

}  // namespace

std::string rowAsJson(const SweepRow& row) {
    Json json;
    json["scene"] = row.point.scene;
    json["technique"] = row.point.technique;
    json["spp"] = row.point.sampleCount;
    json["map"] = asJson(row.point.mapSize);
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
    row.point = {json.at("scene"),
                 json.at("technique"),
                 wholeFromJson<int>(json.at("spp")),
                 mapSizeFromJson(json.at("map")),
                 "",
                 0.0};
    row.state = frameStateNamed(json.value("state", "")).value_or(FrameState::Filling);
    if (json.contains("renders")) row.renders = wholeFromJson<int>(json.at("renders"));
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
    row.bytes = wholeFromJson<std::size_t>(json.at("bytes").at("total"));
    row.techniqueBytes = wholeFromJson<std::size_t>(json.at("bytes").at("technique"));
    for (const Json& figure : json.at("figures"))
        row.statistics.push_back(
            {figure.at("name"), numberOf(figure.at("value")), figure.at("unit"), figure.at("warning")});
    return row;
}

std::string lineOf(const JournalEntry& entry) {
    Json json = Json::parse(rowAsJson(entry.row));
    for (const auto& [part, text] : entry.madeWith) json["made_with"][part] = text;
    return json.dump() + "\n";
}

JournalText journalOf(const std::string& text) {
    JournalText journal;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) {
        if (stream.eof()) break;  // cut off: lines end in a newline
        if (line.size() > longestLine) throw Error(fmt::format("has a line of {} bytes", line.size()));
        const Json json = isNestedTooDeeply(line) ? Json() : Json::parse(line, nullptr, false);
        try {
            if (!json.is_object()) throw Error("no object");
            if (!json.contains("experiment"))  // how older journals began: their rows don't say what made them
                journal.entries.push_back({rowFromJson(line), madeWithOf(json)});
        } catch (const std::exception&) {
            throw Error("is no journal of measured rows");
        }
        journal.wholeLines += line + "\n";
    }
    return journal;
}

}  // namespace timeshade
