#pragma once

#include <string>
#include <vector>

namespace timeshade {

/// One thing that a settings file says, as it would be said on the command line, and where it stands.
struct FileSetting {
    std::string key;
    std::vector<std::string> arguments;
    std::string place;  ///< "F.json:12"
};

/// What a JSON object of settings says: keys are the long options without their dashes, "set" an object of technique
/// and scene settings, "window" an object of what is the window's alone, which is left out, as `others` are. `path`
/// names the file in messages, where the text begins in `firstLine`. Throws Error that names the line.
std::vector<FileSetting> settingsOfJson(const std::string& text, const std::string& path, int firstLine = 1,
                                        const std::vector<std::string>& others = {});

/// The same from a file.
std::vector<FileSetting> readSettingsFile(const std::string& path);

/// The whole file, which is a regular one of at most largestSettingsFile bytes. Throws Error that names `option`.
std::string textOfFile(const std::string& path, const std::string& option);

}  // namespace timeshade
