#include "core/setting.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/error.h"
#include "core/nearest_word.h"

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

/// The value that the text means, where it is one that the setting may have.
std::optional<double> valueOf(const Setting& setting, const std::string& text) {
    if (setting.isSwitch()) return parseSwitch(text);
    const auto choice = std::find(setting.choices.begin(), setting.choices.end(), text);
    if (choice != setting.choices.end()) return static_cast<double>(choice - setting.choices.begin());
    if (setting.isChoice() && setting.choices.front() == "off" && parseSwitch(text)) return parseSwitch(text);
    const std::optional<double> number = parseNumber(text);
    const bool whole = number && (!setting.isWhole() || *number == std::floor(*number));
    if (!whole || *number < setting.minimum || *number > setting.maximum) return std::nullopt;
    return number;
}

std::string expectedBy(const Setting& setting) {
    if (setting.isSwitch()) return "on or off";
    if (setting.isChoice()) return fmt::format("one of {}", fmt::join(setting.choices, ", "));
    return fmt::format("a {} from {:g} to {:g} ({})", setting.isWhole() ? "whole number" : "number", setting.minimum,
                       setting.maximum, setting.unit);
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

void resetSettings(HasSettings& owner) {
    for (Setting& setting : settingsOf(owner)) setting.set(setting.defaultValue);
}

std::string textOf(const Setting& setting) {
    const double value = setting.get();
    if (setting.isSwitch()) return value != 0.0 ? "on" : "off";
    if (setting.isChoice()) return setting.choices[static_cast<std::size_t>(value)];
    if (setting.isWhole()) return fmt::format("{:.0f}", value);
    const auto number = static_cast<float>(value);
    std::string text = fmt::format("{}", number);
    return static_cast<float>(std::strtod(text.c_str(), nullptr)) == number ? text : fmt::format("{}", value);
}

void setFromText(HasSettings& owner, const std::string& key, const std::string& text) {
    std::vector<Setting> settings = settingsOf(owner);
    const std::string name = owner.settingsPrefix();
    const auto setting = std::find_if(settings.begin(), settings.end(), [&](const Setting& s) { return s.key == key; });
    if (setting == settings.end()) {
        std::vector<std::string> known;
        for (const Setting& s : settings) known.push_back(name + "." + s.key);
        throw UsageError(fmt::format("--set {}.{}: no such setting{}; expected {}", name, key,
                                     didYouMean(name + "." + key, known),
                                     known.empty() ? std::string("none: it has no settings")
                                                   : fmt::format("one of {}", fmt::join(known, ", "))));
    }
    const std::optional<double> value = valueOf(*setting, text);
    if (!value) throw UsageError(fmt::format("--set {}.{}={}: expected {}", name, key, text, expectedBy(*setting)));
    setting->set(*value);
}

}  // namespace timeshade
