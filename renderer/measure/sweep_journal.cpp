#include "measure/sweep_journal.h"

#include <cmath>
#include <limits>
#include <sstream>
#include <system_error>

#include <fcntl.h>
#include <unistd.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/json_limits.h"
#include "image/file_bytes.h"
#include "image/image_file.h"
#include "image/part_file.h"
#include "measure/map_size_json.h"
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
    row.point = {json.at("scene"), json.at("technique"), json.at("spp"), mapSizeFromJson(json.at("map")), "", 0.0};
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

namespace {

std::string textOfFile(const std::filesystem::path& path) {
    const std::vector<unsigned char> bytes = readFileBytes(path);
    return {bytes.begin(), bytes.end()};
}

/// By one call, so that a line is there as a whole or is the last one.
void appendLine(const std::filesystem::path& path, const std::string& line) {
    const int file = ::open(path.c_str(), O_WRONLY | O_APPEND | O_CREAT | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC, 0666);
    const bool written = file >= 0 && ::write(file, line.data(), line.size()) == static_cast<ssize_t>(line.size());
    const int code = errno;
    if (file >= 0) ::close(file);
    if (!written) throw Error(fmt::format("cannot write {}: {}", path.string(), std::generic_category().message(code)));
}

std::string lineOf(const SweepRow& row, const MadeWith& madeWith) {
    Json json = Json::parse(rowAsJson(row));
    for (const auto& [part, text] : madeWith) json["made_with"][part] = text;
    return json.dump();
}

MadeWith madeWithOf(const Json& json) {
    MadeWith madeWith;
    if (json.contains("made_with"))
        for (const auto& [part, text] : json.at("made_with").items()) madeWith.emplace_back(part, text);
    return madeWith;
}

}  // namespace

SweepJournal::SweepJournal(const std::filesystem::path& path) : path_(followOwnLinks(path)) {
    if (!std::filesystem::exists(path_)) return;
    std::istringstream stream(textOfFile(path_));
    std::string kept;
    for (std::string line; std::getline(stream, line);) {
        const bool cutOff = stream.eof();  // lines end in a newline
        const Json json = isNestedTooDeeply(line) ? Json() : Json::parse(line, nullptr, false);
        if (cutOff) break;
        try {
            if (!json.is_object()) throw Error("no object");
            if (!json.contains("experiment"))  // how older journals began: their rows don't say what made them
                entries_.push_back({rowFromJson(line), madeWithOf(json)});
        } catch (const std::exception&) {
            throw Error(fmt::format("{}: is no journal of measured rows; expected one, or no file of that name",
                                    path_.string()));
        }
        kept += line + "\n";
    }
    writeFileAtomically(path_, kept);
}

const SweepRow* SweepJournal::find(const SweepPoint& point, FrameState state, const MadeWith& madeWith) const {
    for (const Entry& entry : entries_)
        if (entry.row.state == state && entry.row.point.key() == point.key() && entry.madeWith == madeWith)
            return &entry.row;
    return nullptr;
}

std::vector<std::string> SweepJournal::staleParts(const SweepPoint& point, const MadeWith& madeWith) const {
    std::vector<std::string> parts;
    for (const Entry& entry : entries_) {
        if (entry.row.point.key() != point.key()) continue;
        parts = differingParts(entry.madeWith, madeWith);
        if (parts.empty()) return parts;
    }
    return parts;
}

void SweepJournal::append(const SweepRow& row, const MadeWith& madeWith) {
    entries_.push_back({row, madeWith});
    appendLine(path_, lineOf(row, madeWith) + "\n");
}

}  // namespace timeshade
