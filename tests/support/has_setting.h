#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "core/setting.h"

namespace timeshade {

inline bool hasSetting(HasSettings& owner, const std::string& key) {
    const std::vector<Setting> settings = settingsOf(owner);
    return std::any_of(settings.begin(), settings.end(), [&](const Setting& setting) { return setting.key == key; });
}

}  // namespace timeshade
