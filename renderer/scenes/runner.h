#pragma once

#include "scenes/scene_recipe.h"

namespace timeshade {

/// A skinned runner between two rings of columns, in the light of a spot, with cloths that wave between the outer ones:
/// after Andersson et al. 2015 (figure 14, a runner in a colonnade), and of a colonnade's complexity.
class Runner final : public SceneRecipe {
  public:
    const RecipeDescription& description() const override;
    void visitSettings(SettingsVisitor& visitor) override;
    std::unique_ptr<Scene> make() override;

  private:
    float cell_ = 7.0f;
    int pace_ = 20;
    float wind_ = 0.2f;
};

}  // namespace timeshade
