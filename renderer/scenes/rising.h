#pragma once

#include "scenes/scene_recipe.h"

namespace timeshade {

/// Two finely divided cubes that rise towards a light overhead: the scene of Hong and Oh's figure 9 (2019), whose
/// triangles all change their distance from the light and none its place in the light's map for long.
class Rising final : public SceneRecipe {
  public:
    const RecipeDescription& description() const override;
    void visitSettings(SettingsVisitor& visitor) override;
    std::unique_ptr<Scene> make() override;

  private:
    float speed_ = 0.5f;
};

}  // namespace timeshade
