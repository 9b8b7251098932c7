#pragma once

#include <optional>
#include <string>
#include <vector>

namespace timeshade {

/// The word that was most likely meant: the one that takes the fewest letters put in, left out, replaced or swapped
/// with their neighbour, at most one for each three letters of it, or else the only one that begins with the given
/// word. Capitals do not count. The first of several that are as near; nothing where none is near, or where it is the
/// word.
std::optional<std::string> nearestWord(const std::string& word, const std::vector<std::string>& known);

/// " (did you mean tsm?)" or nothing, to go behind what is wrong.
std::string didYouMean(const std::string& word, const std::vector<std::string>& known);

}  // namespace timeshade
