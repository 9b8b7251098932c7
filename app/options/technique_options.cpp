#include "options/technique_options.h"

#include <memory>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/CLI.hpp>

#include "core/error.h"
#include "core/nearest_word.h"
#include "frame_setup.h"
#include "options/option_checks.h"
#include "scenes/scene_recipe.h"
#include "technique/technique_views.h"
#include "techniques/registry.h"

namespace timeshade {

namespace {

std::string techniquesInWords() {
    std::string names;
    for (const TechniqueDescription& technique : techniqueDescriptions())
        names += (names.empty() ? "" : ", ") + technique.name;
    return names;
}

std::pair<std::string, std::string> settingOf(const std::string& text) {
    const std::size_t equals = text.find('=');
    const std::size_t dot = text.find('.');
    if (equals == std::string::npos || dot == std::string::npos || dot > equals || dot == 0)
        throw UsageError(
            fmt::format("--set {}: expected NAME.KEY=VALUE, as in tsm.bias=0.5 or cubes.count=2000", text));
    return {text.substr(0, equals), text.substr(equals + 1)};
}

std::unique_ptr<Technique> techniqueOfSetting(const std::string& name, gl::ProgramCache& programs) {
    std::vector<std::string> known;
    for (const TechniqueDescription& technique : techniqueDescriptions()) {
        if (technique.name == name) return makeTechnique(name, programs);
        known.push_back(technique.name);
    }
    for (const RecipeDescription& recipe : recipeDescriptions()) known.push_back(recipe.name);
    throw UsageError(fmt::format("--set: '{}' is no technique and no computed scene{}; expected one of {}", name,
                                 didYouMean(name, known), fmt::join(known, ", ")));
}

}  // namespace

void declareSettings(CLI::App& app, SettingTexts& settings, const std::string& help) {
    app.add_option_function<std::vector<std::string>>(
           "--set",
           [&settings](const std::vector<std::string>& texts) {
               for (const std::string& text : texts) settings.push_back(settingOf(text));
           },
           help)
        ->allow_extra_args(false);
}

void declareOptions(CLI::App& app, TechniqueOptions& options, std::string& viewName) {
    app.option_defaults()->group("Technique and view");
    app.add_option("--technique", options.technique, techniquesInWords())
        ->capture_default_str()
        ->multi_option_policy(lastWins);
    declareSettings(app, options.settings,
                    "NAME.KEY=VALUE of a technique or a computed scene, as in tsm.bias=0.5 or cubes.count=2000, "
                    "repeatable (list shows the keys)");
    app.add_option("--view", viewName,
                   "final, visibility, or one of the technique's own (list shows them); for shot also error (against a "
                   "ray-traced reference) and disagreement")
        ->capture_default_str()
        ->multi_option_policy(lastWins);
}

void checkSettings(const SettingTexts& settings) {
    gl::ProgramCache programs;
    for (const auto& [name, value] : settings) {
        const std::string owner = name.substr(0, name.find('.')), key = name.substr(owner.size() + 1);
        if (const std::unique_ptr<SceneRecipe> recipe = makeRecipe(owner))
            setFromText(*recipe, key, value);
        else
            setFromText(*techniqueOfSetting(owner, programs), key, value);
    }
}

void chooseView(const std::string& name, TechniqueOptions& options, bool diagnosticsDrawn, bool techniqueViewsDrawn) {
    if (name == "visibility") options.view = View::Visibility;
    if (name == "final" || name == "visibility") return;
    if (name == "error" || name == "disagreement") {
        if (!diagnosticsDrawn)
            throw UsageError(fmt::format(
                "--view {}: is for the window and for `shot` with a .png file; expected final or visibility here",
                name));
        options.diagnostic = name == "error" ? Diagnostic::Error : Diagnostic::Disagreement;
        return;
    }
    gl::ProgramCache programs;
    viewOf(*techniqueFor(options, programs), name);
    if (!techniqueViewsDrawn)
        throw UsageError(fmt::format("--view {}: is for pictures; expected final or visibility here", name));
    options.techniqueView = name;
}

}  // namespace timeshade
