#include "core/setting.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "core/error.h"

namespace timeshade {

namespace {

class Collector final : public SettingsVisitor {
  public:
    void visit(const Setting& setting) override { settings.push_back(setting); }
    std::vector<Setting> settings;
};

std::optional<double> parseNumber(const std::string& text) {
    double number = 0.0;  // from_chars: no leading blanks, no hexadecimal, the same in every locale
    const auto [rest, failure] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (failure != std::errc{} || rest != text.data() + text.size() || !std::isfinite(number)) return std::nullopt;
    return number;
}

std::optional<double> parseSwitch(const std::string& text) {
    if (text == "on" || text == "true" || text == "1") return 1.0;
    if (text == "off" || text == "false" || text == "0") return 0.0;
    return std::nullopt;
}

}  // namespace

double Setting::get() const {
    return std::visit([](auto* pointer) { return static_cast<double>(*pointer); }, value);
}

void Setting::set(double number) {
    if (auto* const* pointer = std::get_if<float*>(&value)) **pointer = static_cast<float>(number);
    if (auto* const* pointer = std::get_if<int*>(&value)) **pointer = static_cast<int>(std::lround(number));
    if (auto* const* pointer = std::get_if<bool*>(&value)) **pointer = number != 0.0;
}

std::vector<Setting> settingsOf(HasSettings& owner) {
    Collector collector;
    owner.visitSettings(collector);
    return std::move(collector.settings);
}

void setFromText(HasSettings& owner, const std::string& key, const std::string& text) {
    std::vector<Setting> settings = settingsOf(owner);
    const std::string name = owner.settingsPrefix();
    const auto setting = std::find_if(settings.begin(), settings.end(), [&](const Setting& s) { return s.key == key; });
    if (setting == settings.end()) {
        std::string known;
        for (const Setting& s : settings) known += (known.empty() ? "" : ", ") + name + "." + s.key;
        throw UsageError(fmt::format("--set {}.{}: no such setting; expected {}", name, key,
                                     known.empty() ? "none: it has no settings" : "one of " + known));
    }
    if (setting->isSwitch()) {
        const std::optional<double> state = parseSwitch(text);
        if (!state) throw UsageError(fmt::format("--set {}.{}={}: expected on or off", name, key, text));
        setting->set(*state);
        return;
    }
    const std::optional<double> number = parseNumber(text);
    const bool whole = number && (!setting->isWhole() || *number == std::floor(*number));
    if (!whole || *number < setting->minimum || *number > setting->maximum)
        throw UsageError(fmt::format("--set {}.{}={}: expected a {} from {:g} to {:g} ({})", name, key, text,
                                     setting->isWhole() ? "whole number" : "number", setting->minimum, setting->maximum,
                                     setting->unit));
    setting->set(*number);
}

}  // namespace timeshade
