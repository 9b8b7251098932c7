#include "window/shown_scene.h"

#include <utility>

#include "options_text.h"
#include "scene/grounded_scene.h"

namespace timeshade {

SceneRecipe* ShownScene::recipeOf(const std::string& name, const SettingTexts& settings) {
    std::unique_ptr<SceneRecipe>& recipe = recipes_[name];
    if (!recipe) recipe = recipeFor(name, settings);
    return recipe.get();
}

void ShownScene::replace(std::unique_ptr<Scene> scene) {
    planner_.reset();  // it refers to the scene
    scene_ = std::move(scene);
    planner_ = std::make_unique<FramePlanner>(*scene_);
    ++number_;
}

std::unique_ptr<Scene> ShownScene::computed(const std::string& name, const SettingTexts& settings) {
    SceneRecipe* recipe = recipeOf(name, settings);
    return recipe != nullptr ? recipe->make() : nullptr;
}

void ShownScene::show(std::unique_ptr<Scene> scene, const std::string& name, const SettingTexts& settings) {
    replace(std::move(scene));
    recipe_ = recipeOf(name, settings);
    name_ = name;
}

bool ShownScene::setGround(const GroundSettings& ground) {
    const auto* file = dynamic_cast<const GroundedScene*>(scene_.get());
    if (file == nullptr) return false;
    replace(std::make_unique<GroundedScene>(*file, ground));
    return true;
}

void ShownScene::rebuild() {
    if (recipe_ != nullptr) replace(recipe_->make());
}

void ShownScene::forgetRecipes() {
    recipe_ = nullptr;
    recipes_.clear();
}

SettingTexts ShownScene::settingsOfOthers() const {
    SettingTexts others;
    for (const auto& [name, recipe] : recipes_)
        if (recipe && recipe.get() != recipe_)
            for (const Setting& setting : settingsOf(*recipe))
                others.emplace_back(name + "." + setting.key, textOf(setting));
    return others;
}

}  // namespace timeshade
