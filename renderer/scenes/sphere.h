#pragma once

#include "scenes/scene_recipe.h"

namespace timeshade {

/// One closed convex stone of many triangles that flies round and turns under the light. No point of it that faces the
/// light is shadowed by the stone itself, so that every shadow on its lit side is a mistake.
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
