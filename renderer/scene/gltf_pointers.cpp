#include "scene/gltf_pointers.h"

#include <array>
#include <charconv>
#include <optional>
#include <set>
#include <string_view>

#include <fmt/format.h>

#include "core/one_line.h"
#include "scene/gltf_extensions.h"

namespace timeshade::gltf {

namespace {

using Json = nlohmann::json;

struct Property {
    std::string_view before;  ///< of the index
    std::string_view after;
    TargetPath path;
    bool ofLight;
};

constexpr std::string_view node = "/nodes/", light = "/extensions/KHR_lights_punctual/lights/";
constexpr std::array<Property, 9> properties{{{node, "/translation", TargetPath::Translation, false},
                                              {node, "/rotation", TargetPath::Rotation, false},
                                              {node, "/scale", TargetPath::Scale, false},
                                              {node, "/weights", TargetPath::Weights, false},
                                              {light, "/color", TargetPath::Colour, true},
                                              {light, "/intensity", TargetPath::Intensity, true},
                                              {light, "/range", TargetPath::Range, true},
                                              {light, "/spot/innerConeAngle", TargetPath::InnerConeAngle, true},
                                              {light, "/spot/outerConeAngle", TargetPath::OuterConeAngle, true}}};

/// The channel that a pointer stands for, without its sampler.
std::optional<AnimationChannel> channelOf(std::string_view pointer) {
    for (const Property& property : properties) {
        if (!pointer.starts_with(property.before) || !pointer.ends_with(property.after)) continue;
        if (pointer.size() <= property.before.size() + property.after.size()) continue;
        const char* const first = pointer.data() + property.before.size();
        const char* const last = pointer.data() + pointer.size() - property.after.size();
        int index = -1;
        if (std::from_chars(first, last, index).ptr != last || index < 0) continue;
        return property.ofLight ? AnimationChannel{-1, -1, property.path, index}
                                : AnimationChannel{-1, index, property.path, -1};
    }
    return std::nullopt;
}

}  // namespace

void readPointers(const Json& root, Model& model) {
    const Json::json_pointer place("/target/extensions/KHR_animation_pointer/pointer");
    std::size_t leftOut = 0, number = 0;
    std::set<std::string> names;
    for (const Json& animation : elements(root, "animations")) {
        for (const Json& channel : elements(animation, "channels")) {
            if (!channel.is_object() || !channel.contains(place) || !channel[place].is_string()) continue;
            const auto pointer = channel[place].get<std::string>();
            std::optional<AnimationChannel> known = channelOf(pointer);
            if (known && channel.contains("sampler") && number < model.animations.size()) {
                known->sampler = channel["sampler"].get<int>();
                model.animations[number].channels.push_back(*known);
            } else {
                ++leftOut;
                names.insert(oneLine(pointer, 80));
            }
        }
        ++number;
    }
    if (leftOut > 0)
        model.notes.push_back(fmt::format("{} animated {} left out (KHR_animation_pointer): {}", leftOut,
                                          leftOut == 1 ? "property is" : "properties are",
                                          listed({names.begin(), names.end()})));
}

}  // namespace timeshade::gltf
