#include "measure/verification_json.h"

#include <limits>

#include <nlohmann/json.hpp>

#include "measure/json_numbers.h"

namespace timeshade {

namespace {

const char* nameOf(Footprint::Time time) {
    switch (time) {
    case Footprint::Time::Instant: return "instant";
    case Footprint::Time::Stratum: return "stratum";
    case Footprint::Time::Shutter: break;
    }
    return "shutter";
}

const char* nameOf(Footprint::Space space) { return space == Footprint::Space::Point ? "point" : "pixel_surface"; }

nlohmann::ordered_json asJson(const Footprint& footprint) {
    return {{"time", nameOf(footprint.time)},
            {"space", nameOf(footprint.space)},
            {"filter_texels", footprint.filterTexels}};
}

Footprint footprintOf(const nlohmann::ordered_json& json) {
    Footprint footprint;
    for (const auto time : {Footprint::Time::Instant, Footprint::Time::Stratum, Footprint::Time::Shutter})
        if (json.at("time") == nameOf(time)) footprint.time = time;
    for (const auto space : {Footprint::Space::Point, Footprint::Space::PixelSurface})
        if (json.at("space") == nameOf(space)) footprint.space = space;
    footprint.filterTexels = json.at("filter_texels");
    return footprint;
}

nlohmann::ordered_json asJson(const ErrorSummary& e) {
    return {{"mean", e.mean},
            {"rms", e.rms},
            {"p999", e.p999},
            {"standard_error", e.standardError},
            {"mean_square", e.meanSquare},
            {"mean_square_standard_error", e.meanSquareDeviation}};
}

std::uint64_t count(const nlohmann::ordered_json& json) { return wholeFromJson<std::uint64_t>(json); }

ErrorSummary errorOf(const nlohmann::ordered_json& json, std::uint64_t count) {
    const auto number = [&](const char* key) {  // what is not a number has been written as null
        return json.at(key).is_null() ? std::numeric_limits<double>::quiet_NaN() : json.at(key).get<double>();
    };
    return {count,
            number("mean"),
            number("rms"),
            number("p999"),
            number("standard_error"),
            number("mean_square"),
            number("mean_square_standard_error")};
}

void appendErrors(const Verification& v, nlohmann::ordered_json& json) {
    json["footprint"] = asJson(v.footprint);
    if (v.footprintError.error.count > 0) {
        json["footprint_error"] = asJson(v.footprintError.error);
        json["footprint_samples"] = v.footprintError.error.count;
        json["footprint_rays"] = v.footprintError.rays;
    }
    if (!v.shadowError) return;
    json["shadow_error"] = asJson(v.shadowError->error);
    json["pixels"] = v.shadowError->error.count;
    json["pixels_without_samples"] = v.shadowError->pixelsWithoutSamples;
    json["pixels_without_reference"] = v.shadowError->pixelsWithoutReference;
    json["reference_rays"] = v.shadowError->rays;
}

void readErrors(const nlohmann::ordered_json& json, Verification& v) {
    if (json.contains("footprint")) v.footprint = footprintOf(json.at("footprint"));
    if (json.contains("footprint_error"))
        v.footprintError = {errorOf(json.at("footprint_error"), count(json.at("footprint_samples"))),
                            wholeFromJson<std::uint32_t>(json.at("footprint_rays"))};
    if (json.contains("shadow_error"))
        v.shadowError = {errorOf(json.at("shadow_error"), count(json.at("pixels"))),
                         count(json.at("pixels_without_samples")), count(json.at("pixels_without_reference")),
                         wholeFromJson<int>(json.at("reference_rays"))};
}

}  // namespace

nlohmann::ordered_json asJson(const Verification& v) {
    nlohmann::ordered_json json{{"samples", v.samples},
                                {"tested", v.tested},
                                {"shadowed", v.shadowed},
                                {"disagree", v.disagree()},
                                {"false_shadow", v.falseShadow},
                                {"false_lit", v.falseLit},
                                {"marginal", v.marginal},
                                {"ppm", nullptr},
                                {"mean_absolute_error", v.meanAbsoluteError},
                                {"primary_tested", v.primaryTested},
                                {"primary_disagree", v.primaryDisagree},
                                {"primary_marginal", v.primaryMarginal},
                                {"primary_ppm", v.primaryPpm()},
                                {"resolved_exactly", v.resolvedExactly},
                                {"corrected", v.corrected}};
    if (v.isBinary()) json["ppm"] = v.ppm();
    if (v.intervals) json["intervals"] = true;
    appendErrors(v, json);
    return json;
}

Verification verificationOf(const nlohmann::ordered_json& json) {
    Verification v;
    v.samples = count(json.at("samples"));
    v.tested = count(json.at("tested"));
    v.shadowed = count(json.at("shadowed"));
    v.falseShadow = count(json.at("false_shadow"));
    v.falseLit = count(json.at("false_lit"));
    v.marginal = count(json.at("marginal"));
    v.meanAbsoluteError = json.at("mean_absolute_error");
    v.primaryTested = count(json.at("primary_tested"));
    v.primaryDisagree = count(json.at("primary_disagree"));
    v.primaryMarginal = count(json.at("primary_marginal"));
    // Journals of earlier versions have other names for these, and no errors.
    v.resolvedExactly = count(json.at(json.contains("ruled") ? "ruled" : "resolved_exactly"));
    v.corrected = count(json.at(json.contains("overruled") ? "overruled" : "corrected"));
    v.intervals = json.value("intervals", false);
    readErrors(json, v);
    return v;
}

}  // namespace timeshade
