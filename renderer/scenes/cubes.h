#pragma once

#include "scenes/scene_recipe.h"

namespace timeshade {

/// Many cubes that fly and rotate independently above a ground, after the test scene of Hong and Oh 2017 (figures 8 to
/// 12). They move on wide circles, which are nearly straight within a shutter, inside a volume that does not grow with
/// their number. The displacement of a cube per frame is between half of the speed setting and all of it.
class Cubes final : public SceneRecipe {
  public:
    const RecipeDescription& description() const override;
    void visitSettings(SettingsVisitor& visitor) override;
    std::unique_ptr<Scene> make() override;

  private:
    int count_ = 500;
    float speed_ = 2.0f;
    float turn_ = 6.0f;
    float size_ = 0.4f;
    int seed_ = 1;
};

}  // namespace timeshade
