#include "reproduce/paper_list.h"

#include <algorithm>
#include <sstream>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/data_folder.h"
#include "core/error.h"
#include "core/file_bytes.h"
#include "core/json_limits.h"
#include "core/nearest_word.h"
#include "reproduce/figure_values.h"
#include "reproduce/paper_list_check.h"
#include "reproduce/paper_text.h"

namespace timeshade {

namespace {

using Json = nlohmann::ordered_json;

/// A mistyped key would be a silent loss.
void requireKnownKeys(const Json& json, const std::string& what, const std::vector<std::string>& known) {
    if (!json.is_object()) throw Error(fmt::format("{}: {} found, expected an object", what, json.dump()));
    for (const auto& [key, value] : json.items())
        if (std::find(known.begin(), known.end(), key) == known.end())
            throw Error(fmt::format("{}: '{}' found, expected one of {}", what, key, fmt::join(known, ", ")));
}

std::string textAt(const Json& json, const char* key) { return json.value(key, std::string()); }

/// Words between spaces.
std::vector<std::string> wordsOf(const std::string& line) {
    std::istringstream stream(line);
    std::vector<std::string> words;
    for (std::string word; stream >> word;) words.push_back(word);
    return words;
}

/// A number, or a text that is one once a form's words are filled in.
double numberAt(const Json& json, const char* key, double otherwise) {
    if (!json.contains(key)) return otherwise;
    return json[key].is_string() ? numberIn(json[key].get<std::string>()) : json[key].get<double>();
}

PaperStep stepOf(const std::string& name, const Json& json) {
    if (json.is_string()) return {name, wordsOf(json.get<std::string>())};
    requireKnownKeys(json, "step " + name, {"run", "seconds"});
    return {name, wordsOf(json.at("run").get<std::string>()), numberAt(json, "seconds", 10.0)};
}

PaperPicture pictureOf(const Json& json) {
    requireKnownKeys(json, "picture", {"file", "caption"});
    return {json.at("file").get<std::string>(), textAt(json, "caption")};
}

PaperTable tableOf(const Json& json) {
    requireKnownKeys(json, "table", {"caption", "columns", "rows"});
    return {textAt(json, "caption"), json.at("columns").get<std::vector<std::string>>(),
            json.at("rows").get<std::vector<std::vector<std::string>>>()};
}

PaperChart chartOf(const Json& json) {
    requireKnownKeys(json, "chart",
                     {"caption", "file", "x", "y", "x_label", "y_label", "by", "where", "names", "scale"});
    PaperChart chart{textAt(json, "caption"),
                     textAt(json, "x_label"),
                     textAt(json, "y_label"),
                     json.at("file").get<std::string>(),
                     json.at("x").get<std::string>(),
                     json.at("y").get<std::string>(),
                     json.at("by").get<std::string>(),
                     {},
                     {},
                     1.0};
    if (json.contains("where")) chart.where = json["where"].get<std::map<std::string, std::string>>();
    if (json.contains("names")) chart.names = json["names"].get<std::map<std::string, std::string>>();
    chart.scale = numberAt(json, "scale", 1.0);
    return chart;
}

PaperValue valueOf(const std::string& name, const Json& json) {
    requireKnownKeys(json, "value " + name,
                     {"label", "unit", "file", "at", "column", "where", "sum", "quotient", "plus", "scale"});
    PaperValue value{name,
                     json.value("label", name),
                     textAt(json, "unit"),
                     textAt(json, "file"),
                     textAt(json, "at"),
                     textAt(json, "column"),
                     {},
                     {},
                     {}};
    if (json.contains("where")) value.where = json["where"].get<std::map<std::string, std::string>>();
    if (json.contains("sum"))
        for (const Json& term : json["sum"]) value.sum.emplace_back(term.at(0), term.at(1));
    if (json.contains("quotient")) value.quotient = {json["quotient"].at(0), json["quotient"].at(1)};
    value.plus = numberAt(json, "plus", 0.0);
    value.scale = numberAt(json, "scale", 1.0);
    return value;
}

PaperRule ruleOf(const Json& json) {
    requireKnownKeys(json, "rule", {"test", "of", "by", "expected", "within", "clear", "hardware", "why", "all"});
    PaperRule rule;
    rule.kind = json.at("test").get<std::string>();
    if (json.contains("of")) rule.of = json["of"].get<std::vector<std::string>>();
    rule.by = numberAt(json, "by", 1.0);
    rule.expected = numberAt(json, "expected", 0.0);
    rule.within = numberAt(json, "within", 0.0);
    rule.clear = numberAt(json, "clear", 0.0);
    rule.hardware = textAt(json, "hardware");
    rule.why = textAt(json, "why");
    if (json.contains("all"))
        for (const Json& each : json["all"]) rule.all.push_back(ruleOf(each));
    return rule;
}

PaperClaim claimOf(const Json& json) {
    requireKnownKeys(json, "claim", {"says", "stands", "number", "picture", "shown", "rule"});
    PaperClaim claim{json.at("says").get<std::string>(),
                     textAt(json, "stands"),
                     textAt(json, "number"),
                     textAt(json, "picture"),
                     {},
                     ruleOf(json.at("rule"))};
    if (json.contains("shown")) claim.shown = json["shown"].get<std::vector<std::string>>();
    return claim;
}

FigureKind kindIn(const std::string& word) {
    if (word == "reproduced") return FigureKind::Reproduced;
    if (word == "drawing") return FigureKind::Drawing;
    if (word == "not possible") return FigureKind::NotPossible;
    throw Error(fmt::format("status '{}' found, expected reproduced, drawing or not possible", word));
}

template <typename Thing>
void readEach(const Json& json, const char* key, std::vector<Thing>& things, Thing (*read)(const Json&)) {
    if (!json.contains(key)) return;
    for (const Json& each : json[key]) things.push_back(read(each));
}

PaperPair pairOf(const Json& json) {
    requireKnownKeys(json, "pair", {"left", "right"});
    return {pictureOf(json.at("left")), pictureOf(json.at("right"))};
}

PaperFigure figureOf(const Json& json) {
    requireKnownKeys(json, "figure",
                     {"figure", "caption", "status", "reason", "note", "steps", "pictures", "pairs", "tables", "charts",
                      "values", "claims"});
    PaperFigure figure;
    figure.number = json.at("figure").get<std::string>();
    figure.caption = json.at("caption").get<std::string>();
    figure.kind = kindIn(json.at("status").get<std::string>());
    figure.reason = textAt(json, "reason");
    figure.note = textAt(json, "note");
    if (json.contains("steps"))
        for (const auto& [name, step] : json["steps"].items()) figure.steps.push_back(stepOf(name, step));
    readEach(json, "pictures", figure.pictures, pictureOf);
    readEach(json, "pairs", figure.pairs, pairOf);
    readEach(json, "tables", figure.tables, tableOf);
    readEach(json, "charts", figure.charts, chartOf);
    if (json.contains("values"))
        for (const auto& [name, value] : json["values"].items()) figure.values.push_back(valueOf(name, value));
    readEach(json, "claims", figure.claims, claimOf);
    return figure;
}

/// The words of a form: those of the paper, and of the figure in their place.
PaperWords formWords(const Json& paper, const Json& figure, bool quick) {
    PaperWords words;
    for (const Json* json : {&paper, &figure})
        if (json->contains("forms"))
            for (const auto& [word, forms] : (*json)["forms"].items()) words[word] = forms.at(quick ? 1 : 0);
    return words;
}

PaperList listOf(const Json& json, bool quick) {
    requireKnownKeys(json, "list", {"name", "authors", "year", "title", "venue", "hardware", "forms", "figures"});
    PaperList list{json.at("name"),
                   json.at("authors"),
                   json.at("title"),
                   textAt(json, "venue"),
                   textAt(json, "hardware"),
                   json.at("year"),
                   {}};
    for (const Json& given : json.at("figures")) {
        try {
            Json figure = filledIn(withVariants(given), formWords(json, given, quick));
            figure.erase("forms");
            list.figures.push_back(figureOf(figure));
            requireWhole(list.figures.back());
        } catch (const std::exception& error) {
            throw Error(fmt::format("figure {}: {}", textAt(given, "figure"), error.what()));
        }
    }
    return list;
}

std::filesystem::path papersFolder() { return dataFolder() / "assets" / "papers"; }

}  // namespace

std::vector<std::string> paperNames() {
    std::vector<std::string> names;
    std::error_code missing;
    for (const auto& entry : std::filesystem::directory_iterator(papersFolder(), missing))
        if (entry.path().extension() == ".json") names.push_back(entry.path().stem().string());
    if (names.empty()) throw Error(papersFolder().string() + ": expected lists of papers, NAME.json");
    std::sort(names.begin(), names.end());
    return names;
}

PaperList paperListOf(const std::string& text, const std::string& place, bool quick) {
    if (isNestedTooDeeply(text)) throw Error(place + ": nested too deeply");
    try {
        return listOf(Json::parse(text), quick);
    } catch (const std::exception& error) {
        throw Error(fmt::format("{}: {}", place, error.what()));
    }
}

PaperList readPaperList(const std::string& name, bool quick) {
    const std::vector<std::string> names = paperNames();
    if (std::find(names.begin(), names.end(), name) == names.end())
        throw UsageError(fmt::format("reproduce {}: no such paper{}; expected {} or all", name, didYouMean(name, names),
                                     fmt::join(names, ", ")));
    const std::filesystem::path path = papersFolder() / (name + ".json");
    return paperListOf(readFileText(path, largestSettingsFile), path.string(), quick);
}

}  // namespace timeshade
