#pragma once

#include <cstdint>
#include <utility>

#include <nlohmann/json.hpp>

#include "core/error.h"

namespace timeshade {

/// Of a file that may hold anything. Throws Error for what is no whole number, or beyond the type.
template <typename Whole>
Whole wholeFromJson(const nlohmann::ordered_json& json) {
    if (json.is_number_unsigned() && std::in_range<Whole>(json.get<std::uint64_t>()))
        return static_cast<Whole>(json.get<std::uint64_t>());
    if (json.is_number_integer() && !json.is_number_unsigned() && std::in_range<Whole>(json.get<std::int64_t>()))
        return static_cast<Whole>(json.get<std::int64_t>());
    throw Error("holds " + json.dump() + "; expected a whole number");
}

}  // namespace timeshade
