#include "scenes/fine_octopus.h"

#include "core/scene_folder.h"
#include "scene/finer_scene.h"
#include "scene/gltf_scene.h"

namespace timeshade {

const RecipeDescription& FineOctopus::description() const {
    static const RecipeDescription description{
        "octopus-fine", "the octopus with 190,000 triangles: its skin divided more finely, its motion the same"};
    return description;
}

void FineOctopus::visitSettings(SettingsVisitor& visitor) {
    visitor.whole("triangles", triangles_, 190000.0, 80000.0, 280000.0, "triangles",
                  "How many triangles there are with those of the sand; the file has 74,416.");
}

std::unique_ptr<Scene> FineOctopus::make() {
    return std::make_unique<FinerScene>(loadGltf(sceneFolder() / "octopus.glb"), static_cast<std::size_t>(triangles_),
                                        description().name, parametersOf(*this));
}

}  // namespace timeshade
