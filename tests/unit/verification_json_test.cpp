// What verify and the journal of measure write of a comparison, and what is read back: older journals too.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include <nlohmann/json.hpp>

#include "measure/verification_json.h"

namespace timeshade {
namespace {

Verification someVerification() {
    Verification v;
    v.samples = 1000;
    v.tested = 800;
    v.shadowed = 300;
    v.falseShadow = 3;
    v.falseLit = 5;
    v.marginal = 1;
    v.meanAbsoluteError = 0.01;
    v.primaryTested = 1000;
    v.resolvedExactly = 20;
    v.corrected = 2;
    v.footprintError = {{800, 0.01, 0.1, 1.0, 0.001, 0.01, 0.0002}, 0};
    v.shadowError = ShadowError{{90, 0.02, 0.03, 0.4, 0.005, 0.0009, 0.0003}, 7, 2, 1024};
    return v;
}

TEST(VerificationJson, ComesBackAsItWent) {
    const Verification v = someVerification();
    const nlohmann::ordered_json json = asJson(v);
    EXPECT_EQ(json.at("ppm"), 10000.0);
    EXPECT_EQ(json.at("footprint").at("time"), "instant");
    EXPECT_EQ(json.at("pixels"), 90);
    EXPECT_EQ(json.at("reference_rays"), 1024);
    EXPECT_EQ(json.at("shadow_error").at("rms"), 0.03);
    EXPECT_EQ(json.at("footprint_error").at("standard_error"), 0.001);
    const Verification back = verificationOf(nlohmann::ordered_json::parse(json.dump()));
    EXPECT_EQ(asJson(back), json);
    ASSERT_TRUE(back.shadowError);
    EXPECT_EQ(back.shadowError->error.meanSquareDeviation, 0.0003);
    EXPECT_EQ(back.footprintError.error.count, 800u);
    EXPECT_EQ(back.corrected, 2u);
}

TEST(VerificationJson, FractionsAreNotRightOrWrong) {
    Verification v = someVerification();
    v.footprint.time = Footprint::Time::Shutter;
    v.footprint.space = Footprint::Space::PixelSurface;
    v.footprint.filterTexels = 3.0;
    v.footprintError.rays = 512;
    const nlohmann::ordered_json json = asJson(v);
    EXPECT_TRUE(json.at("ppm").is_null());
    const Verification back = verificationOf(nlohmann::ordered_json::parse(json.dump()));
    EXPECT_EQ(back.footprint.time, Footprint::Time::Shutter);
    EXPECT_EQ(back.footprint.space, Footprint::Space::PixelSurface);
    EXPECT_EQ(back.footprint.filterTexels, 3.0);
    EXPECT_EQ(back.footprintError.rays, 512u);
}

TEST(VerificationJson, BrokenValuesStayBroken) {
    Verification v = someVerification();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    v.shadowError->error = {90, nan, nan, nan, nan, nan, nan};
    const nlohmann::ordered_json json = nlohmann::ordered_json::parse(asJson(v).dump());
    EXPECT_TRUE(json.at("shadow_error").at("rms").is_null());
    EXPECT_TRUE(std::isnan(verificationOf(json).shadowError->error.rms));
}

TEST(VerificationJson, ReadsJournalsOfBefore) {
    nlohmann::ordered_json json = asJson(someVerification());
    for (const char* key :
         {"footprint", "footprint_error", "footprint_samples", "footprint_rays", "shadow_error", "pixels",
          "pixels_without_samples", "pixels_without_reference", "reference_rays", "resolved_exactly", "corrected"})
        json.erase(key);
    json["ruled"] = 20;
    json["overruled"] = 2;
    const Verification v = verificationOf(json);
    EXPECT_EQ(v.resolvedExactly, 20u);
    EXPECT_EQ(v.corrected, 2u);
    EXPECT_EQ(v.falseLit, 5u);
    EXPECT_FALSE(v.shadowError);
    EXPECT_EQ(v.footprintError.error.count, 0u);
}

}  // namespace
}  // namespace timeshade
