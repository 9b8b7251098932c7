#pragma once

#include "scenes/scene_recipe.h"

namespace timeshade {

/// Leaves above a ground, under a sun that moves. A leaf is a card of two triangles, of which its alpha leaves a leaf
/// with teeth and holes. Each sways about its stalk.
class Foliage final : public SceneRecipe {
  public:
    const RecipeDescription& description() const override;
    void visitSettings(SettingsVisitor& visitor) override;
    std::unique_ptr<Scene> make() override;

  private:
    int count_ = 40;
    float sway_ = 8.0f;
    float sun_ = 3.0f;
    int seed_ = 1;
};

}  // namespace timeshade
