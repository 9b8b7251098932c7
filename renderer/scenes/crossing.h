#pragma once

#include "scenes/scene_recipe.h"

namespace timeshade {

/// Two quads that pass across each other at different distances from the light, above a ground, after Andersson,
/// Hasselgren, Munkberg and Akenine-Möller 2015 (the caption of figure 12; figure 3 with an angle of 180 degrees). The
/// lower one is a moving receiver of the upper one's shadow. At the centre of the default frame both centres lie on one
/// ray of the light, which meets the ground at the origin. They move straight and uniformly for three frames, of which
/// the default frame is the second, and back again.
class Crossing final : public SceneRecipe {
  public:
    const RecipeDescription& description() const override;
    void visitSettings(SettingsVisitor& visitor) override;
    std::unique_ptr<Scene> make() override;

  private:
    float angle_ = 90.0f;
    float speed_ = 1.0f;
    float distance_ = 1.0f;
};

}  // namespace timeshade
