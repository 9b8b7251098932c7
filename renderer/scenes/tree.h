#pragma once

#include "scenes/scene_recipe.h"

namespace timeshade {

/// A tree with some 13,000 leaves, 112,000 triangles, under a sun that moves, after Andersson et al. 2015 (figure 14).
/// Its leaves hang on sprays that sway about their roots.
class Tree final : public SceneRecipe {
  public:
    const RecipeDescription& description() const override;
    void visitSettings(SettingsVisitor& visitor) override;
    std::unique_ptr<Scene> make() override;

  private:
    int sprays_ = 900;
    float sway_ = 1.5f;
    float sun_ = 4.0f;
    int seed_ = 1;
};

}  // namespace timeshade
