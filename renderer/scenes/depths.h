#pragma once

#include "scenes/scene_recipe.h"

namespace timeshade {

/// Two quads above a ground, each on a ray of the light: the lower one moves towards the light, the upper one away,
/// after Andersson, Hasselgren, Munkberg and Akenine-Möller 2015 (the caption of figure 13). Their paths in the shadow
/// map are those of a perspective projection, not linear in time. The upper one shadows the lower one, and both the
/// ground. With the default speed they move farther in a frame than the lower one is above the ground. They move
/// straight and uniformly for one and a half frames, with the default frame in the middle, and back again; they never
/// touch each other or the ground.
class Depths final : public SceneRecipe {
  public:
    const RecipeDescription& description() const override;
    void visitSettings(SettingsVisitor& visitor) override;
    std::unique_ptr<Scene> make() override;

  private:
    float speed_ = 0.7f;
    float distance_ = 0.2f;
};

}  // namespace timeshade
