#pragma once

#include <map>
#include <memory>
#include <string>

#include "plan/frame_plan.h"
#include "scene/scene.h"
#include "scene_catalogue.h"
#include "scenes/scene_recipe.h"

namespace timeshade {

/// The scene that the window shows. Its planner is always that of the scene, and its number changes with the scene.
class ShownScene {
  public:
    /// A computed scene that is to be shown, with its settings as they were left in this window, or else as `settings`
    /// say; null for a file. Changes nothing that is shown.
    std::unique_ptr<Scene> computed(const std::string& name, const SettingTexts& settings);
    /// Shows it in place of the one before.
    void show(std::unique_ptr<Scene> scene, const std::string& name, const SettingTexts& settings);
    /// Shows the scene of a file with another ground. False for a scene that is computed, which has its own.
    bool setGround(const GroundSettings& ground);
    /// Computes the scene anew from the recipe's settings. Does nothing for a file.
    void rebuild();
    /// Computed scenes have no settings left from before.
    void forgetRecipes();
    /// The settings of computed scenes that were shown before.
    SettingTexts settingsOfOthers() const;

    const Scene& current() const { return *scene_; }
    FramePlanner& planner() const { return *planner_; }
    /// Of a computed scene; null for a file. Its settings are what the sliders set.
    SceneRecipe* recipe() const { return recipe_; }
    /// As on the command line.
    const std::string& name() const { return name_; }
    int number() const { return number_; }

  private:
    SceneRecipe* recipeOf(const std::string& name, const SettingTexts& settings);
    void replace(std::unique_ptr<Scene> scene);

    std::unique_ptr<Scene> scene_;
    std::unique_ptr<FramePlanner> planner_;
    SceneRecipe* recipe_ = nullptr;
    std::string name_;
    int number_ = 0;
    std::map<std::string, std::unique_ptr<SceneRecipe>> recipes_;  ///< of all opened so far; null for files
};

}  // namespace timeshade
