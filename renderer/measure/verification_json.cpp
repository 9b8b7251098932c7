#include "measure/verification_json.h"

#include <nlohmann/json.hpp>

namespace timeshade {

nlohmann::ordered_json asJson(const Verification& v) {
    return {{"samples", v.samples},
            {"tested", v.tested},
            {"shadowed", v.shadowed},
            {"disagree", v.disagree()},
            {"false_shadow", v.falseShadow},
            {"false_lit", v.falseLit},
            {"marginal", v.marginal},
            {"ppm", v.ppm()},
            {"mean_absolute_error", v.meanAbsoluteError},
            {"primary_tested", v.primaryTested},
            {"primary_disagree", v.primaryDisagree},
            {"primary_marginal", v.primaryMarginal},
            {"primary_ppm", v.primaryPpm()},
            {"ruled", v.resolvedExactly},
            {"overruled", v.corrected}};
}

Verification verificationOf(const nlohmann::ordered_json& json) {
    Verification v;
    v.samples = json.at("samples");
    v.tested = json.at("tested");
    v.shadowed = json.at("shadowed");
    v.falseShadow = json.at("false_shadow");
    v.falseLit = json.at("false_lit");
    v.marginal = json.at("marginal");
    v.meanAbsoluteError = json.at("mean_absolute_error");
    v.primaryTested = json.at("primary_tested");
    v.primaryDisagree = json.at("primary_disagree");
    v.primaryMarginal = json.at("primary_marginal");
    v.resolvedExactly = json.at("ruled");
    v.corrected = json.at("overruled");
    return v;
}

}  // namespace timeshade
