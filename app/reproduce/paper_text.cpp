#include "reproduce/paper_text.h"

#include <utility>
#include <vector>

namespace timeshade {

namespace {

using Json = nlohmann::ordered_json;

std::string filled(std::string text, const PaperWords& words) {
    for (const auto& [word, meaning] : words) {
        const std::string hole = "{" + word + "}";
        for (std::size_t at = text.find(hole); at != std::string::npos; at = text.find(hole, at + meaning.size()))
            text.replace(at, hole.size(), meaning);
    }
    return text;
}

bool variesIn(const std::string& text) { return text.find("{variant}") != std::string::npos; }

/// Whether it is a string that does, or holds one: of an array directly, of an object also in objects in it.
bool varies(const Json& json) {
    if (json.is_string()) return variesIn(json.get_ref<const std::string&>());
    for (const Json& each : json)
        if (each.is_string() ? varies(each) : json.is_object() && each.is_object() && varies(each)) return true;
    return false;
}

Json repeated(const Json& json, const std::vector<PaperWords>& variants);

Json repeatedObject(const Json& json, const std::vector<PaperWords>& variants) {
    Json all = Json::object();
    for (const auto& [key, value] : json.items()) {
        if (variesIn(key))
            for (const PaperWords& words : variants) all[filled(key, words)] = filledIn(value, words);
        else
            all[key] = repeated(value, variants);
    }
    return all;
}

/// Entries that vary, once for each variant, in their place.
Json repeated(const Json& json, const std::vector<PaperWords>& variants) {
    if (json.is_object()) return repeatedObject(json, variants);
    if (!json.is_array()) return json;
    Json all = Json::array();
    for (const Json& each : json) {
        if (varies(each))
            for (const PaperWords& words : variants) all.push_back(filledIn(each, words));
        else
            all.push_back(repeated(each, variants));
    }
    return all;
}

}  // namespace

Json filledIn(const Json& json, const PaperWords& words) {
    if (json.is_string()) return filled(json.get<std::string>(), words);
    if (!json.is_structured()) return json;
    Json all = json.is_object() ? Json::object() : Json::array();
    for (const auto& [key, value] : json.items()) {
        if (json.is_object())
            all[filled(key, words)] = filledIn(value, words);
        else
            all.push_back(filledIn(value, words));
    }
    return all;
}

Json withVariants(Json figure) {
    if (!figure.contains("variants")) return figure;
    std::vector<PaperWords> variants;
    for (const auto& [name, own] : figure["variants"].items()) {
        PaperWords words = own.get<PaperWords>();
        words["variant"] = name;
        variants.push_back(std::move(words));
    }
    figure.erase("variants");
    return repeated(figure, variants);
}

}  // namespace timeshade
