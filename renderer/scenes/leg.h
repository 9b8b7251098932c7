#pragma once

#include "scenes/scene_recipe.h"

namespace timeshade {

/// A skinned runner of some 265,000 triangles whose leg swings towards the light, seen from near, after Hong and Oh
/// 2019 (figure 10). Feet on the ground stand still.
class Leg final : public SceneRecipe {
  public:
    const RecipeDescription& description() const override;
    void visitSettings(SettingsVisitor& visitor) override;
    std::unique_ptr<Scene> make() override;

  private:
    float cell_ = 4.6f;
    int pace_ = 24;
};

}  // namespace timeshade
