#pragma once

#include "scenes/scene_recipe.h"

namespace timeshade {

/// A cube that moves straight above a plane, after Palmér 2011: the plane stands still (figure 4.1) or turns about an
/// axis in it (figures 4.2 and 4.3), so that the shadow moves on a moving receiver. Both move uniformly for three
/// frames and back again. At the centre of the default frame, the second, the cube is in the middle of its way above
/// the plane's centre, and the plane is level.
class Cube final : public SceneRecipe {
  public:
    const RecipeDescription& description() const override;
    void visitSettings(SettingsVisitor& visitor) override;
    std::unique_ptr<Scene> make() override;

  private:
    float speed_ = 1.0f;
    float angle_ = 8.0f;
    bool turning_ = false;
};

}  // namespace timeshade
