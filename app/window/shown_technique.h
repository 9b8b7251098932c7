#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "gl/program_cache.h"
#include "scene_catalogue.h"
#include "technique/technique.h"
#include "window/frame_driver.h"

namespace timeshade {

/// The technique that the window shows, and the settings of those that it showed before.
class ShownTechnique {
  public:
    explicit ShownTechnique(std::unique_ptr<Technique> technique) : technique_(std::move(technique)) {}

    Technique& current() const { return *technique_; }
    const std::string& name() const { return technique_->description().name; }

    /// Shows another in its place. The one before.
    std::unique_ptr<Technique> replace(std::unique_ptr<Technique> technique);
    /// Shows the one of that name, with its settings as they were left in this window, or else as `settings` say.
    void choose(const std::string& name, const SettingTexts& settings, gl::ProgramCache& programs);

    /// Values of a technique's settings in their order, as they were left; null where it was not shown before.
    const std::vector<double>* settingsLeft(const std::string& name) const;
    /// What the technique of that name is to start from when it is chosen next.
    void leaveSettings(const std::string& name, std::vector<double> values);
    void forgetSettings() { settingsLeft_.clear(); }
    SettingTexts settingsOfOthers(gl::ProgramCache& programs) const;

    /// What it counted in the picture that is shown; while that is being drawn, in the one before. While it plays this
    /// is read a few times a second: each time waits for the device.
    const std::vector<TechniqueStatistic>& statistics(const FrameDriver& driver, bool playing, double now);

  private:
    std::unique_ptr<Technique> technique_;
    std::map<std::string, std::vector<double>> settingsLeft_;
    std::vector<TechniqueStatistic> statistics_;
    double statisticsAt_ = 0.0;  ///< seconds, when they were read
    int statisticsOf_ = 0;       ///< the picture that they belong to, by its number
};

}  // namespace timeshade
