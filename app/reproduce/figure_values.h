#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "reproduce/paper_list.h"
#include "reproduce/verdict.h"

namespace timeshade {

/// A row of a CSV file by its columns' names.
using CsvRow = std::map<std::string, std::string>;

/// Commas, a header line, quotes around what holds commas. Throws Error that names the file.
std::vector<CsvRow> readCsv(const std::filesystem::path& path);

/// The rows whose columns have these values.
std::vector<CsvRow> rowsWhere(const std::vector<CsvRow>& rows, const std::map<std::string, std::string>& where);

/// The text as a number, none of which is left over. Throws Error.
double numberIn(const std::string& text);

/// Reads a figure's values from what its steps have written into `folder`. What cannot be read is missing and says why;
/// nothing is thrown.
MeasuredValues readValues(const PaperFigure& figure, const std::filesystem::path& folder);

/// The renderer that the outputs below the folder name; without a name where none does.
UsedDevice deviceIn(const std::filesystem::path& folder);

}  // namespace timeshade
