#pragma once

#include "scenes/scene_recipe.h"

namespace timeshade {

/// A closed convex body of many triangles that moves on a circle and rotates under the light. It casts no shadow on its
/// own lit side, so every shadow there is an error.
class Sphere final : public SceneRecipe {
  public:
    const RecipeDescription& description() const override;
    void visitSettings(SettingsVisitor& visitor) override;
    std::unique_ptr<Scene> make() override;

  private:
    int frequency_ = 32;
    float speed_ = 0.5f;
    float turn_ = 7.5f;
};

}  // namespace timeshade
