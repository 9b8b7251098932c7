#pragma once

#include <map>
#include <string>

#include <nlohmann/json.hpp>

namespace timeshade {

/// Words that stand in braces in a list, and what they are replaced by.
using PaperWords = std::map<std::string, std::string>;

/// The JSON with each "{word}" inside its strings, keys included, replaced. What is in no list of words stays.
nlohmann::ordered_json filledIn(const nlohmann::ordered_json& json, const PaperWords& words);

/// The figure with what varies repeated for each of its "variants", whose own words are filled in: entries of objects
/// whose key holds "{variant}", and entries of arrays that hold it, as strings or in one of their own strings. The
/// variants themselves are taken out.
nlohmann::ordered_json withVariants(nlohmann::ordered_json figure);

}  // namespace timeshade
