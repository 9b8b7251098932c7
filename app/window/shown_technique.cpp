#include "window/shown_technique.h"

#include <algorithm>
#include <utility>

#include "frame_setup.h"
#include "options_text.h"
#include "techniques/registry.h"

namespace timeshade {

namespace {

constexpr double secondsBetweenStatistics = 0.25;

void setAll(Technique& technique, const std::vector<double>& values) {
    std::vector<Setting> settings = settingsOf(technique);
    for (std::size_t i = 0; i < std::min(settings.size(), values.size()); ++i) settings[i].set(values[i]);
}

}  // namespace

std::unique_ptr<Technique> ShownTechnique::replace(std::unique_ptr<Technique> technique) {
    statistics_.clear();
    return std::exchange(technique_, std::move(technique));
}

void ShownTechnique::choose(const std::string& name, const SettingTexts& settings, gl::ProgramCache& programs) {
    if (name == this->name()) return;
    std::vector<double> values;
    for (const Setting& setting : settingsOf(*technique_)) values.push_back(setting.get());
    leaveSettings(this->name(), std::move(values));
    replace(techniqueFor(name, settings, programs));
    if (const std::vector<double>* left = settingsLeft(name)) setAll(*technique_, *left);
}

const std::vector<double>* ShownTechnique::settingsLeft(const std::string& name) const {
    const auto found = settingsLeft_.find(name);
    return found == settingsLeft_.end() ? nullptr : &found->second;
}

void ShownTechnique::leaveSettings(const std::string& name, std::vector<double> values) {
    settingsLeft_[name] = std::move(values);
}

SettingTexts ShownTechnique::settingsOfOthers(gl::ProgramCache& programs) const {
    SettingTexts others;
    for (const auto& [name, values] : settingsLeft_) {
        if (name == technique_->description().name) continue;
        const std::unique_ptr<Technique> other = makeTechnique(name, programs);
        setAll(*other, values);
        for (const Setting& setting : settingsOf(*other))
            others.emplace_back(name + "." + setting.key, textOf(setting));
    }
    return others;
}

const std::vector<TechniqueStatistic>& ShownTechnique::statistics(const FrameDriver& driver, bool playing, double now) {
    const bool due = !playing || now - statisticsAt_ >= secondsBetweenStatistics;
    if (due && driver.state() == FrameDriver::State::Complete && driver.hasPlan() && statisticsOf_ != driver.begun()) {
        statistics_ = technique_->statistics();
        statisticsOf_ = driver.begun();
        statisticsAt_ = now;
    }
    return statistics_;
}

}  // namespace timeshade
