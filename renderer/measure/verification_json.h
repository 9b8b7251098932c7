#pragma once

#include <nlohmann/json_fwd.hpp>

#include "measure/verification.h"

namespace timeshade {

/// The numbers of a comparison, under the names that `verify --json` and the journal of `measure` share. `ppm` is null
/// where the technique's footprint is not binary; the two errors are there where they were measured.
nlohmann::ordered_json asJson(const Verification& verification);
/// What asJson has written; what follows from the rest (ppm) is not read. Throws nlohmann's exceptions where a number
/// is missing.
Verification verificationOf(const nlohmann::ordered_json& json);

}  // namespace timeshade
