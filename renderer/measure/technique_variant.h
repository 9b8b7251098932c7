#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "plan/frame_request.h"
#include "technique/technique.h"

namespace timeshade {

/// A technique with some settings of its own, as one series of a measurement: "tsm:bias=2:dynamic_bias=on". Without a
/// colon it is the technique itself.
struct TechniqueVariant {
    std::string name;                                           ///< in the registry
    std::vector<std::pair<std::string, std::string>> settings;  ///< "bias", "2"
    std::optional<CameraSamples> samples{};                     ///< of onItsSamples()

    /// Throws UsageError where a setting has no "=" or is not one of KEY=VALUE.
    static TechniqueVariant of(const std::string& label);
    /// As of(), where a series may say which camera samples it is measured on: "integral:samples=intervals". Throws
    /// UsageError for others than strata and intervals. (Elsewhere `samples` is an unknown key, for make().)
    static TechniqueVariant onItsSamples(const std::string& label);
    /// The request on the series' own camera samples, where it says which. Throws UsageError for interval samples of a
    /// shutter in pieces.
    FrameRequest on(FrameRequest request) const;
    /// With what `settings` ("tsm.bias", "0.5") say of the technique first, then its own. Throws UsageError for an
    /// unknown technique, an unknown key or a value out of range.
    std::unique_ptr<Technique> make(const std::vector<std::pair<std::string, std::string>>& settings,
                                    gl::ProgramCache& programs) const;
};

}  // namespace timeshade
