#pragma once

#include "scenes/scene_recipe.h"

namespace timeshade {

/// Duelling frusta: a low, distant light that faces the camera across a long plane, so that nearby shadows are large in
/// the picture but small in the shadow map. Only the camera "path" moves.
class Frusta final : public SceneRecipe {
  public:
    const RecipeDescription& description() const override;
    void visitSettings(SettingsVisitor& visitor) override;
    std::unique_ptr<Scene> make() override;

  private:
    int rows_ = 12;
    float speed_ = 0.125f;
};

}  // namespace timeshade
