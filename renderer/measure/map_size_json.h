#pragma once

#include <nlohmann/json.hpp>

#include "core/error.h"
#include "plan/map_size.h"

namespace timeshade {

/// A number where the map is square, else "1024x768".
inline nlohmann::ordered_json asJson(const MapSize& size) {
    if (size.isSquare()) return size.width;
    return size.text();
}

/// Of what asJson wrote. Throws Error where it is something else.
inline MapSize mapSizeFromJson(const nlohmann::ordered_json& json) {
    const std::optional<MapSize> size = MapSize::of(json.is_string() ? json.get<std::string>() : json.dump());
    if (!size) throw Error("a map of " + json.dump() + ": expected texels along a side, or WIDTHxHEIGHT");
    return *size;
}

}  // namespace timeshade
