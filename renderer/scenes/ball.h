#pragma once

#include "scenes/scene_recipe.h"

namespace timeshade {

/// A heavy ball on a rope that swings into a wall of blocks, some 8,000 triangles, after Andersson et al. 2015 (figure
/// 14). What it strikes flies off, turning; then all of it happens backwards. The default frame is shortly after the
/// blow.
class Ball final : public SceneRecipe {
  public:
    const RecipeDescription& description() const override;
    void visitSettings(SettingsVisitor& visitor) override;
    std::unique_ptr<Scene> make() override;

  private:
    float speed_ = 0.45f;
    int courses_ = 12;
};

}  // namespace timeshade
