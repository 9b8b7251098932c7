#pragma once

#include "scenes/scene_recipe.h"

namespace timeshade {

/// Many cubes, each flying and turning in its own way above a ground: the scene of Hong and Oh's measurements (2017,
/// figures 8 to 12). They fly on wide circles, which within a shutter are all but straight, in a block of air that does
/// not grow with their number; each cube's own way per frame is between half of the speed and all of it.
class Cubes final : public SceneRecipe {
  public:
    const RecipeDescription& description() const override;
    void visitSettings(SettingsVisitor& visitor) override;
    std::unique_ptr<Scene> make() override;

  private:
    int count_ = 500;
    float speed_ = 2.0f;
    float turn_ = 6.0f;
    int seed_ = 1;
};

}  // namespace timeshade
