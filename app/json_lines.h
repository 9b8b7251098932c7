#pragma once

#include <map>
#include <string>
#include <vector>

namespace timeshade {

/// The line of every key of a JSON object, "spp", and of the object "set" in it, "set/tsm.bias". The text is valid
/// JSON. Of a key that is there twice, the last. In time and memory a multiple of the text, whatever it holds.
std::map<std::string, int> linesOfKeys(const std::string& json);

/// A value in a JSON text, as it is written there, and the line that it begins in.
struct JsonPiece {
    std::string text;
    int line = 1;
};

/// The objects in the array that is the value of this key of a JSON object; for an object as the value that one. The
/// text is valid JSON. Of a key that is there twice, the last.
std::vector<JsonPiece> objectsUnder(const std::string& json, const std::string& key);

}  // namespace timeshade
