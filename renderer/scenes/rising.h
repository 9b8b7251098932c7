#pragma once

#include "scenes/scene_recipe.h"

namespace timeshade {

/// Two finely tessellated cubes that rise towards a light overhead, after Hong and Oh 2019 (figure 9). All triangles
/// change their distance from the light and hardly move in the shadow map.
class Rising final : public SceneRecipe {
  public:
    const RecipeDescription& description() const override;
    void visitSettings(SettingsVisitor& visitor) override;
    std::unique_ptr<Scene> make() override;

  private:
    float speed_ = 0.5f;
};

}  // namespace timeshade
