#pragma once

#include "scenes/scene_recipe.h"

namespace timeshade {

/// Duelling frusta: a low light far away that faces the camera across a long plane, so that the near shadows, which
/// are large in the picture, are small in the light's map. Nothing moves but the camera called "path".
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
