#pragma once

#include "scenes/scene_recipe.h"

namespace timeshade {

/// The octopus of the file octopus.glb with more triangles: 190,000 as that of Andersson et al. 2015 (figures 1 and 9).
/// The skin's longest edges are divided and curved; the motion is the file's. make() throws Error where the file can't
/// be read.
class FineOctopus final : public SceneRecipe {
  public:
    const RecipeDescription& description() const override;
    void visitSettings(SettingsVisitor& visitor) override;
    std::unique_ptr<Scene> make() override;

  private:
    int triangles_ = 190000;
};

}  // namespace timeshade
