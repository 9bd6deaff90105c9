// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <charconv>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include <pendular/io/atomic_file.hpp>
#include <pendular/io/number.hpp>

namespace pendular::io {

struct column {
  std::string name;  // with its unit: "normal stress (Pa)"
  std::vector<double> values;
};

/// Named columns of equal length.
class table {
 public:
  table() = default;
  explicit table(std::vector<column> columns) : columns_{std::move(columns)} {}

  /// Empty columns with these names, to be filled by add_row.
  explicit table(std::initializer_list<std::string> names) {
    for (const std::string& name : names) columns_.push_back({name, {}});
  }

  /// One value per column. Throws std::invalid_argument for another number of values.
  void add_row(std::span<const double> row) {
    if (row.size() != columns_.size())
      throw std::invalid_argument("pendular: a row has " + std::to_string(row.size()) + " values; the table has " +
                                  std::to_string(columns_.size()) + " columns");
    for (std::size_t i = 0; i < row.size(); ++i) columns_[i].values.push_back(row[i]);
  }
  void add_row(std::initializer_list<double> row) { add_row(std::span<const double>{row.begin(), row.size()}); }

  bool has(std::string_view name) const { return find(name) != nullptr; }

  /// Throws std::out_of_range, naming the columns there are.
  const std::vector<double>& operator[](std::string_view name) const {
    if (const column* found = find(name)) return found->values;
    std::string names;
    for (const column& c : columns_) names += (names.empty() ? "'" : ", '") + c.name + "'";
    throw std::out_of_range("pendular: no column '" + std::string{name} + "' in the table; it has " +
                            (names.empty() ? "none" : names));
  }

  const std::vector<column>& columns() const { return columns_; }
  std::size_t rows() const { return columns_.empty() ? 0 : columns_.front().values.size(); }

 private:
  std::vector<column> columns_;

  const column* find(std::string_view name) const {
    for (const column& c : columns_)
      if (c.name == name) return &c;
    return nullptr;
  }
};

namespace detail {

inline std::string csv_quoted(const std::string& name) {
  if (name.find_first_of(",\"\r\n") == std::string::npos) return name;
  std::string quoted = "\"";
  for (const char c : name) quoted += c == '"' ? std::string{"\"\""} : std::string(1, c);
  return quoted + "\"";
}

/// The cells of one line; commas inside double quotes do not separate.
inline std::vector<std::string> csv_cells(std::string_view line) {
  std::vector<std::string> cells(1);
  bool inside = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const bool doubled = inside && line[i] == '"' && i + 1 < line.size() && line[i + 1] == '"';
    if (doubled) cells.back() += line[++i];
    else if (line[i] == '"') inside = !inside;
    else if (line[i] == ',' && !inside) cells.emplace_back();
    else cells.back() += line[i];
  }
  return cells;
}

/// True when all of `cell`, blanks aside, is one number.
inline bool parsed(std::string_view cell, double& value) {
  const auto first = cell.find_first_not_of(" \t");
  if (first == std::string_view::npos) return false;
  cell = cell.substr(first, cell.find_last_not_of(" \t") - first + 1);
  if (cell.starts_with('+')) cell.remove_prefix(1);
  const char* end = cell.data() + cell.size();
  const auto result = std::from_chars(cell.data(), end, value);
  return result.ec == std::errc{} && result.ptr == end;
}

[[noreturn]] inline void table_error(const std::filesystem::path& path, const std::string& what) {
  throw std::runtime_error("pendular: table '" + path.string() + "' " + what);
}

inline void check_columns(const std::filesystem::path& path, const std::vector<column>& columns) {
  if (columns.empty()) table_error(path, "has no columns; give it at least one");
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (columns[i].values.size() != columns[0].values.size())
      table_error(path, "has " + std::to_string(columns[i].values.size()) + " values in '" + columns[i].name +
                            "' and " + std::to_string(columns[0].values.size()) + " in '" + columns[0].name +
                            "'; columns must be equally long");
    if (columns[i].name.empty() || columns[i].name.find_first_of("\r\n") != std::string::npos)
      table_error(path, "has no name of one line for column " + std::to_string(i + 1) + "; give it one in the header");
    for (std::size_t j = 0; j < i; ++j)
      if (columns[j].name == columns[i].name)
        table_error(path, "has two columns '" + columns[i].name + "'; give each its own name");
  }
}

inline std::vector<double> parsed_row(const std::filesystem::path& path, std::size_t line,
                                      const std::vector<std::string>& cells, const std::vector<column>& columns) {
  const std::string where = "line " + std::to_string(line);
  if (cells.size() != columns.size())
    table_error(path, "has " + std::to_string(cells.size()) + " values in " + where + "; its header names " +
                          std::to_string(columns.size()) + " columns");
  std::vector<double> row(cells.size());
  for (std::size_t i = 0; i < cells.size(); ++i)
    if (!parsed(cells[i], row[i]))
      table_error(path, "has '" + cells[i] + "' in " + where + ", column '" + columns[i].name +
                            "', where a number is needed");
  return row;
}

}  // namespace detail

/// Comma-separated values: a header of names, then numbers that read back exactly. Throws std::runtime_error when
/// columns differ in length, two share a name, or the file cannot be written.
inline void write_table(const std::filesystem::path& path, const table& data) {
  const auto& columns = data.columns();
  detail::check_columns(path, columns);
  std::string text;
  for (std::size_t i = 0; i < columns.size(); ++i) text += (i == 0 ? "" : ",") + detail::csv_quoted(columns[i].name);
  text += '\n';
  for (std::size_t row = 0; row < data.rows(); ++row) {
    for (std::size_t i = 0; i < columns.size(); ++i) text += (i == 0 ? "" : ",") + shortest(columns[i].values[row]);
    text += '\n';
  }
  atomic_file file{path};
  file.write(text);
  file.commit();
}

/// Reads what write_table writes, and plain tables of other programs. Throws std::runtime_error, with the line number
/// where there is one, for a missing file, a row of another length, text that is no number, two columns of one name.
inline table read_table(const std::filesystem::path& path) {
  std::ifstream file{path};
  std::string line;
  if (!std::getline(file, line)) detail::table_error(path, "cannot be read; check that it exists and is not empty");
  const auto strip = [&line] {
    if (line.ends_with('\r')) line.pop_back();
  };
  strip();
  if (line.starts_with("\xEF\xBB\xBF")) line.erase(0, 3);  // byte-order mark of spreadsheet programs
  std::vector<column> columns;
  for (const std::string& name : detail::csv_cells(line)) columns.push_back({name, {}});
  detail::check_columns(path, columns);
  table data{std::move(columns)};
  for (std::size_t number = 2; std::getline(file, line); ++number) {
    strip();
    if (line.empty() && file.peek() == std::ifstream::traits_type::eof()) break;
    data.add_row(detail::parsed_row(path, number, detail::csv_cells(line), data.columns()));
  }
  return data;
}

}  // namespace pendular::io
