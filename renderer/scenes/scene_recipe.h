#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/setting.h"
#include "scene/scene.h"

namespace timeshade {

struct RecipeDescription {
    std::string name;     ///< as on the command line; also what stands before the dot of its settings
    std::string summary;  ///< one line: what is to be seen
};

/// A scene that is computed from a few settings. Needs no file and no OpenGL. The same settings make the same scene,
/// bit by bit.
class SceneRecipe : public HasSettings {
  public:
    virtual const RecipeDescription& description() const = 0;
    const std::string& settingsPrefix() const override { return description().name; }
    virtual std::unique_ptr<Scene> make() = 0;
};

/// All of them, in the order in which they are shown.
const std::vector<RecipeDescription>& recipeDescriptions();

/// With its defaults; null where there is no such scene.
std::unique_ptr<SceneRecipe> makeRecipe(const std::string& name);

/// The settings as the scene's parameters, for its reports.
std::vector<SceneParameter> parametersOf(SceneRecipe& recipe);

}  // namespace timeshade
