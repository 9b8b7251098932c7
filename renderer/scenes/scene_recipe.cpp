#include "scenes/scene_recipe.h"

#include "scenes/ball.h"
#include "scenes/crossing.h"
#include "scenes/cube.h"
#include "scenes/cubes.h"
#include "scenes/depths.h"
#include "scenes/fine_octopus.h"
#include "scenes/foliage.h"
#include "scenes/frusta.h"
#include "scenes/leg.h"
#include "scenes/rising.h"
#include "scenes/runner.h"
#include "scenes/sphere.h"
#include "scenes/tree.h"

namespace timeshade {

namespace {

std::vector<std::unique_ptr<SceneRecipe>> allRecipes() {
    std::vector<std::unique_ptr<SceneRecipe>> recipes;
    recipes.push_back(std::make_unique<Cubes>());
    recipes.push_back(std::make_unique<Rising>());
    recipes.push_back(std::make_unique<Frusta>());
    recipes.push_back(std::make_unique<Sphere>());
    recipes.push_back(std::make_unique<Crossing>());
    recipes.push_back(std::make_unique<Depths>());
    recipes.push_back(std::make_unique<Cube>());
    recipes.push_back(std::make_unique<Foliage>());
    recipes.push_back(std::make_unique<Ball>());
    recipes.push_back(std::make_unique<FineOctopus>());
    recipes.push_back(std::make_unique<Tree>());
    recipes.push_back(std::make_unique<Leg>());
    recipes.push_back(std::make_unique<Runner>());
    return recipes;
}

}  // namespace

const std::vector<RecipeDescription>& recipeDescriptions() {
    static const std::vector<RecipeDescription> descriptions = [] {
        std::vector<RecipeDescription> all;
        for (const auto& recipe : allRecipes()) all.push_back(recipe->description());
        return all;
    }();
    return descriptions;
}

std::unique_ptr<SceneRecipe> makeRecipe(const std::string& name) {
    for (auto& recipe : allRecipes())
        if (recipe->description().name == name) return std::move(recipe);
    return nullptr;
}

std::vector<SceneParameter> parametersOf(SceneRecipe& recipe) {
    std::vector<SceneParameter> parameters;
    for (const Setting& setting : settingsOf(recipe)) {
        // As it is written: 0.4 is no float.
        const bool isFraction = !setting.isWhole() && !setting.isSwitch();
        parameters.push_back({setting.key, isFraction ? std::stod(textOf(setting)) : setting.get()});
    }
    return parameters;
}

}  // namespace timeshade
