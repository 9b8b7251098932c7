#include "reproduce/figure_values.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/file_bytes.h"
#include "core/json_limits.h"
#include "options/number_list.h"

namespace timeshade {

namespace {

using Json = nlohmann::json;

constexpr std::size_t largestOutput = std::size_t{64} << 20;

Json readJson(const std::filesystem::path& path) {
    const std::string text = readFileText(path, largestOutput);
    const Json json = isNestedTooDeeply(text) ? Json() : Json::parse(text, nullptr, false);
    if (!json.is_structured()) throw Error(path.filename().string() + " is not valid JSON");
    return json;
}

/// The cells of one line. A cell in quotes may hold commas; no cell holds a line break.
std::vector<std::string> cellsOf(const std::string& line) {
    std::vector<std::string> cells(1);
    bool quoted = false;
    for (const char c : line) {
        if (c == '"')
            quoted = !quoted;
        else if (c == ',' && !quoted)
            cells.emplace_back();
        else if (c != '\r')
            cells.back() += c;
    }
    return cells;
}

/// One step along "/a/b": a member, a number of an array, or "name=value", the object of an array that has that.
const Json& memberOf(const Json& json, const std::string& token) {
    const std::size_t equals = token.find('=');
    if (json.is_array() && equals != std::string::npos) {
        const std::string key = token.substr(0, equals), wanted = token.substr(equals + 1);
        for (const Json& each : json)
            if (each.is_object() && each.contains(key) && each[key] == wanted) return each;
        throw Error("nothing has " + token);
    }
    if (json.is_array()) return json.at(static_cast<std::size_t>(numberIn(token)));
    if (!json.is_object() || !json.contains(token)) throw Error("there is no " + token);
    return json[token];
}

double jsonNumber(const Json& whole, const std::string& path) {
    const Json* json = &whole;
    for (std::size_t begin = 1; begin <= path.size();) {
        const std::size_t end = std::min(path.find('/', begin), path.size());
        json = &memberOf(*json, path.substr(begin, end - begin));
        begin = end + 1;
    }
    if (json->is_object() && json->contains("value")) json = &(*json)["value"];
    if (!json->is_number()) throw Error(fmt::format("{} is {}, expected a number", path, json->dump().substr(0, 40)));
    return json->get<double>();
}

double csvValue(const PaperValue& value, const std::filesystem::path& path) {
    const std::vector<CsvRow> rows = rowsWhere(readCsv(path), value.where);
    if (rows.size() != 1) throw Error(fmt::format("{} rows fit, expected one", rows.size()));
    const auto cell = rows.front().find(value.column);
    if (cell == rows.front().end()) throw Error("there is no column " + value.column);
    return numberIn(cell->second);
}

double numberOf(const MeasuredValues& values, const std::string& name) {
    const MeasuredValue& value = values.at(name);
    if (!value.number) throw Error(value.missing);
    return *value.number;
}

double rawValue(const PaperValue& value, const MeasuredValues& earlier, const std::filesystem::path& folder) {
    const auto& [dividend, divisor] = value.quotient;
    if (!dividend.empty()) return numberOf(earlier, dividend) / numberOf(earlier, divisor);
    double sum = 0.0;
    for (const auto& [name, factor] : value.sum) sum += factor * numberOf(earlier, name);
    if (!value.sum.empty()) return sum;
    const std::filesystem::path path = folder / value.file;
    return value.at.empty() ? csvValue(value, path) : jsonNumber(readJson(path), value.at);
}

}  // namespace

double numberIn(const std::string& text) {
    const auto number = numbersIn<double>(text, 1);
    if (!number) throw Error(fmt::format("'{}' found, expected a number", text));
    return number->front();
}

std::vector<CsvRow> readCsv(const std::filesystem::path& path) {
    const std::string text = readFileText(path, largestOutput);
    std::vector<CsvRow> rows;
    std::vector<std::string> header;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        const std::vector<std::string> cells = cellsOf(text.substr(begin, end - begin));
        begin = end + 1;
        if (header.empty()) {
            header = cells;
            continue;
        }
        if (cells.size() > header.size())
            throw Error(fmt::format("{}: a row of {} cells, expected {}", path.string(), cells.size(), header.size()));
        CsvRow& row = rows.emplace_back();
        for (std::size_t i = 0; i < cells.size(); ++i) row[header[i]] = cells[i];
    }
    return rows;
}

std::vector<CsvRow> rowsWhere(const std::vector<CsvRow>& rows, const std::map<std::string, std::string>& where) {
    std::vector<CsvRow> fit;
    std::copy_if(rows.begin(), rows.end(), std::back_inserter(fit), [&](const CsvRow& row) {
        return std::all_of(where.begin(), where.end(), [&](const auto& wanted) {
            const auto cell = row.find(wanted.first);
            return cell != row.end() && cell->second == wanted.second;
        });
    });
    return fit;
}

MeasuredValues readValues(const PaperFigure& figure, const std::filesystem::path& folder) {
    MeasuredValues values;
    for (const PaperValue& value : figure.values) {
        MeasuredValue measured{std::nullopt, value.label, value.unit, ""};
        try {
            measured.number = value.scale * (rawValue(value, values, folder) + value.plus);
        } catch (const std::exception& error) {
            measured.missing =
                value.file.empty() ? std::string(error.what()) : fmt::format("{}: {}", value.file, error.what());
        }
        values[value.name] = measured;
    }
    return values;
}

UsedDevice deviceIn(const std::filesystem::path& folder) {
    std::set<std::filesystem::path> files;  // sorted, so that the answer is always the same
    std::error_code missing;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder, missing))
        if (entry.path().extension() == ".json") files.insert(entry.path());
    for (const std::filesystem::path& file : files) {
        try {
            const Json gl = readJson(file).value("gl", Json::object());
            if (gl.contains("renderer")) return {gl["renderer"].get<std::string>(), gl.value("software", false)};
        } catch (const std::exception&) {
            continue;  // not every step that writes JSON draws
        }
    }
    return {};
}

}  // namespace timeshade
