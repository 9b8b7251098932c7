#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/setting.h"
#include "scene/scene.h"

namespace timeshade {

struct RecipeDescription {
    std::string name;     ///< as on the command line; also the prefix of its settings
    std::string summary;  ///< one line: what it shows
};

/// A scene that is computed from a few settings, without OpenGL. Equal settings make bitwise equal scenes.
class SceneRecipe : public HasSettings {
  public:
    virtual const RecipeDescription& description() const = 0;
    const std::string& settingsPrefix() const override { return description().name; }
    virtual std::unique_ptr<Scene> make() = 0;
};

/// All recipes, in the order in which they are shown.
const std::vector<RecipeDescription>& recipeDescriptions();

/// The recipe of that name with its default settings; null if there is none.
std::unique_ptr<SceneRecipe> makeRecipe(const std::string& name);

/// The settings as the scene's parameters, for reports.
std::vector<SceneParameter> parametersOf(SceneRecipe& recipe);

}  // namespace timeshade
