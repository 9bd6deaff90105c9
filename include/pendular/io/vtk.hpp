// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <numeric>
#include <optional>
#include <set>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <pendular/core/strided.hpp>
#include <pendular/io/atomic_file.hpp>
#include <pendular/io/number.hpp>

namespace pendular::io {

/// A named column of a .vtp file: a scalar per item, or a vector per item stored x y z, x y z, ...
struct field {
  std::string name;
  int components;              // 1 or 3
  std::vector<double> values;  // components times the number of points or lines

  field(std::string name_, int components_, std::vector<double> values_)
      : name{std::move(name_)}, components{components_}, values{std::move(values_)} {}
  field(std::string name_, int components_, strided<const double> values_)
      : field{std::move(name_), components_, std::vector<double>(values_.begin(), values_.end())} {}
};

namespace detail {

inline std::string xml_escaped(std::string_view text) {
  std::string safe;
  for (const char c : text) {
    if (c == '&') safe += "&amp;";
    else if (c == '<') safe += "&lt;";
    else if (c == '>') safe += "&gt;";
    else if (c == '"') safe += "&quot;";
    else safe += c;
  }
  return safe;
}

/// What xml_escaped() was given.
inline std::string xml_unescaped(std::string_view safe) {
  constexpr std::array<std::pair<std::string_view, char>, 5> names{
      {{"&amp;", '&'}, {"&lt;", '<'}, {"&gt;", '>'}, {"&quot;", '"'}, {"&apos;", '\''}}};
  std::string text;
  while (!safe.empty()) {
    const auto found = std::ranges::find_if(names, [&](const auto& n) { return safe.starts_with(n.first); });
    text += found == names.end() ? safe.front() : found->second;
    safe.remove_prefix(found == names.end() ? 1 : found->first.size());
  }
  return text;
}

/// The value of an attribute of the form name="value" in a tag.
inline std::optional<std::string> xml_attribute(std::string_view tag, std::string_view name) {
  const std::string opening = ' ' + std::string{name} + "=\"";
  const auto begin = tag.find(opening);
  if (begin == tag.npos) return std::nullopt;
  const auto end = tag.find('"', begin + opening.size());
  if (end == tag.npos) return std::nullopt;
  return xml_unescaped(tag.substr(begin + opening.size(), end - begin - opening.size()));
}

inline const char* byte_order() { return std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian"; }

/// x y z, x y z, ... from three columns. Throws std::invalid_argument when their lengths differ.
inline std::vector<double> interleaved(std::span<const double> x, std::span<const double> y,
                                       std::span<const double> z) {
  if (y.size() != x.size() || z.size() != x.size())
    throw std::invalid_argument("pendular: coordinates have lengths " + std::to_string(x.size()) + ", " +
                                std::to_string(y.size()) + ", " + std::to_string(z.size()) + "; they must be equal");
  std::vector<double> points;
  points.reserve(3 * x.size());
  for (std::size_t i = 0; i < x.size(); ++i) points.insert(points.end(), {x[i], y[i], z[i]});
  return points;
}

inline void check_fields(const std::vector<field>& fields, std::size_t items, const std::string& item) {
  std::set<std::string> names;
  for (const field& f : fields) {
    if (f.components != 1 && f.components != 3)
      throw std::invalid_argument("pendular: field '" + f.name + "' has " + std::to_string(f.components) +
                                  " components; 1 (scalar) or 3 (vector) can be written");
    const std::size_t expected = items * static_cast<std::size_t>(f.components);
    if (f.values.size() != expected)
      throw std::invalid_argument("pendular: field '" + f.name + "' has " + std::to_string(f.values.size()) +
                                  " values; " + std::to_string(expected) + " are needed (" +
                                  std::to_string(f.components) + " per " + item + ")");
    if (!names.insert(f.name).second)
      throw std::invalid_argument("pendular: two fields are named '" + f.name + "'; give each its own name");
  }
}

inline void check_lines(std::span<const std::array<std::int64_t, 2>> lines, std::size_t points) {
  for (std::size_t i = 0; i < lines.size(); ++i)
    for (const std::int64_t end : lines[i])
      if (end < 0 || static_cast<std::uint64_t>(end) >= points)
        throw std::invalid_argument("pendular: line " + std::to_string(i) + " ends at point " + std::to_string(end) +
                                    "; there are " + std::to_string(points) + " points, counted from 0");
}

/// XML text in front, raw arrays behind, each led by its size in bytes as UInt64.
class polydata {
 public:
  polydata(std::size_t points, std::size_t vertices, std::size_t lines) {
    xml_ = std::string{"<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\""} +
           byte_order() + "\" header_type=\"UInt64\">\n<PolyData>\n<Piece NumberOfPoints=\"" + std::to_string(points) +
           "\" NumberOfVerts=\"" + std::to_string(vertices) + "\" NumberOfLines=\"" + std::to_string(lines) +
           "\" NumberOfStrips=\"0\" NumberOfPolys=\"0\">\n";
  }

  void fields(const std::string& tag, const std::vector<field>& all) {
    xml_ += "<" + tag + ">\n";
    for (const field& f : all) array("Float64", f.name, f.components, std::as_bytes(std::span{f.values}));
    xml_ += "</" + tag + ">\n";
  }

  void points(std::span<const double> coordinates) {
    xml_ += "<Points>\n";
    array("Float64", "Points", 3, std::as_bytes(coordinates));
    xml_ += "</Points>\n";
  }

  /// Cells of `corners` points each, their point numbers one after the other.
  void cells(const std::string& tag, std::size_t corners, std::span<const std::int64_t> connectivity) {
    std::vector<std::int64_t> offsets(connectivity.size() / corners);
    for (std::size_t i = 0; i < offsets.size(); ++i) offsets[i] = static_cast<std::int64_t>(corners * (i + 1));
    xml_ += "<" + tag + ">\n";
    array("Int64", "connectivity", 1, std::as_bytes(connectivity));
    array("Int64", "offsets", 1, std::as_bytes(std::span<const std::int64_t>{offsets}));
    xml_ += "</" + tag + ">\n";
  }

  void write(const std::filesystem::path& path) const {
    atomic_file file{path};
    file.write(xml_ + "</Piece>\n</PolyData>\n<AppendedData encoding=\"raw\">\n_");
    file.write(data_);
    file.write("\n</AppendedData>\n</VTKFile>\n");
    file.commit();
  }

 private:
  std::string xml_;
  std::string data_;

  void array(const std::string& type, const std::string& name, int components, std::span<const std::byte> bytes) {
    xml_ += "<DataArray type=\"" + type + "\" Name=\"" + xml_escaped(name) + "\" NumberOfComponents=\"" +
            std::to_string(components) + "\" format=\"appended\" offset=\"" + std::to_string(data_.size()) + "\"/>\n";
    const std::uint64_t size = bytes.size();
    data_.append(reinterpret_cast<const char*>(&size), sizeof size);
    data_.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  }
};

}  // namespace detail

/// A vector field from three columns of equal length.
inline field vector_field(std::string name, std::span<const double> x, std::span<const double> y,
                          std::span<const double> z) {
  return {std::move(name), 3, detail::interleaved(x, y, z)};
}

/// Points (x, y, z in m) with their fields as VTK XML PolyData, raw binary: open `path` (.vtp) in ParaView.
/// Throws std::invalid_argument when a length does not fit, std::runtime_error when the file cannot be written.
inline void write_points(const std::filesystem::path& path, std::span<const double> x, std::span<const double> y,
                         std::span<const double> z, const std::vector<field>& fields = {}) {
  const auto coordinates = detail::interleaved(x, y, z);
  detail::check_fields(fields, x.size(), "point");
  std::vector<std::int64_t> vertices(x.size());
  std::iota(vertices.begin(), vertices.end(), 0);

  detail::polydata document{x.size(), x.size(), 0};
  document.fields("PointData", fields);
  document.points(coordinates);
  document.cells("Verts", 1, vertices);
  document.write(path);
}

/// Lines between points (x, y, z in m), for instance bridges between grain centres; `lines` holds the two point
/// numbers of each. Errors as in write_points, and std::invalid_argument when a line ends at no point.
inline void write_lines(const std::filesystem::path& path, std::span<const double> x, std::span<const double> y,
                        std::span<const double> z, std::span<const std::array<std::int64_t, 2>> lines,
                        const std::vector<field>& point_fields = {}, const std::vector<field>& line_fields = {}) {
  const auto coordinates = detail::interleaved(x, y, z);
  detail::check_lines(lines, x.size());
  detail::check_fields(point_fields, x.size(), "point");
  detail::check_fields(line_fields, lines.size(), "line");
  std::vector<std::int64_t> ends;
  for (const auto& line : lines) ends.insert(ends.end(), line.begin(), line.end());

  detail::polydata document{x.size(), 0, lines.size()};
  document.fields("PointData", point_fields);
  document.fields("CellData", line_fields);
  document.points(coordinates);
  document.cells("Lines", 2, ends);
  document.write(path);
}

}  // namespace pendular::io
