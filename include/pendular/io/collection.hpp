// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include <pendular/core/expects.hpp>
#include <pendular/io/atomic_file.hpp>
#include <pendular/io/number.hpp>
#include <pendular/io/vtk.hpp>

namespace pendular::io {

/// A time series of .vtp files: open `path` (.pvd) in ParaView. The file is rewritten at each add(), so a running or
/// interrupted simulation can be looked at. It lists each time once, in the order of time.
class collection {
 public:
  struct entry {
    double time;                 // s
    std::filesystem::path file;  // as add() takes it
  };

  /// Goes on with the frames that the file at `path` lists, if there is one: the first add() drops those that are not
  /// before it, which an interrupted run wrote beyond the checkpoint that this one resumes from. Throws
  /// std::runtime_error when the file is no list of frames.
  explicit collection(std::filesystem::path path) : path_{std::move(path)} {
    std::error_code unknown;
    if (std::filesystem::exists(path_, unknown) || unknown) take(listed());
  }

  /// Goes on with `entries` in place of what is at `path`; with none it begins anew.
  collection(std::filesystem::path path, std::vector<entry> entries) : path_{std::move(path)} {
    take(std::move(entries));
  }

  /// `file` is relative to the working folder, as it was given to write_points; it takes the place of a frame of the
  /// same time. Throws input_error for a time that is not finite, std::runtime_error when the .pvd file cannot be
  /// written.
  void add(double time, std::filesystem::path file) {
    expects(std::isfinite(time), "the time of a frame (s)", time, "finite", page);
    auto entries = entries_;
    if (inherited_) std::erase_if(entries, [&](const entry& e) { return e.time >= time; });
    put(entries, {time, std::move(file)});
    write(entries);
    entries_ = std::move(entries);
    inherited_ = false;
  }

  const std::vector<entry>& entries() const { return entries_; }

 private:
  static constexpr auto page = "docs/how-to/paraview.md";

  std::filesystem::path path_;
  std::vector<entry> entries_;
  bool inherited_ = true;  // all entries are from before this object

  static void put(std::vector<entry>& entries, entry e) {
    const auto place = std::ranges::lower_bound(entries, e.time, {}, &entry::time);
    if (place != entries.end() && place->time == e.time) *place = std::move(e);
    else entries.insert(place, std::move(e));
  }

  void take(std::vector<entry> entries) {
    for (entry& e : entries) {
      expects(std::isfinite(e.time), "the time of a frame (s)", e.time, "finite", page);
      put(entries_, std::move(e));
    }
  }

  [[noreturn]] void fail(const std::string& what) const {
    throw std::runtime_error("pendular: '" + path_.string() + "' " + what +
                             "; remove it, or give the series another path (see " + page + ")");
  }

  /// The frames of the file, which names them relative to itself.
  std::vector<entry> listed() const {
    std::ifstream file;
    if (std::filesystem::is_regular_file(path_)) file.open(path_, std::ios::binary);
    if (!file.is_open()) fail("is no file that can be read");
    const std::string text{std::istreambuf_iterator<char>{file}, {}};
    const std::string_view all{text};
    const auto type = detail::xml_attribute(tag_at(all, all.find("<VTKFile")), "type");
    if (type != "Collection" || all.find("</VTKFile>") == all.npos) fail("is no whole VTKFile of type Collection");
    std::vector<entry> entries;
    constexpr std::string_view opening = "<DataSet";
    for (auto at = all.find(opening); at != all.npos; at = all.find(opening, at + 1)) {
      const std::string frame = "in frame " + std::to_string(entries.size() + 1);
      const std::string_view tag = tag_at(all, at);
      if (detail::xml_attribute(tag, "part").value_or("0") != "0") fail("has several parts " + frame);
      entries.push_back({time_in(tag, frame), file_in(tag, frame)});
    }
    return entries;
  }

  static std::string_view tag_at(std::string_view text, std::size_t at) {
    return at == text.npos ? text.substr(0, 0) : text.substr(at, text.find('>', at) - at);
  }

  double time_in(std::string_view tag, const std::string& frame) const {
    const auto text = detail::xml_attribute(tag, "timestep");
    if (!text) fail("has no timestep " + frame);
    double time = 0;
    const auto [end, error] = std::from_chars(text->data(), text->data() + text->size(), time);
    if (error != std::errc{} || end != text->data() + text->size() || !std::isfinite(time))
      fail("has the timestep '" + *text + "', which is no finite number, " + frame);
    return time;
  }

  std::filesystem::path file_in(std::string_view tag, const std::string& frame) const {
    const auto name = detail::xml_attribute(tag, "file");
    if (!name || name->empty()) fail("has no file " + frame);
    return path_.parent_path() / *name;
  }

  /// Names relative to the .pvd file, so that the folder can be moved as a whole.
  void write(const std::vector<entry>& entries) const {
    const auto folder = std::filesystem::absolute(path_).lexically_normal().parent_path();
    std::string xml = "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"";
    xml += detail::byte_order() + std::string{"\">\n<Collection>\n"};
    for (const entry& e : entries) {
      const auto name = std::filesystem::absolute(e.file).lexically_normal().lexically_relative(folder);
      xml += "<DataSet timestep=\"" + shortest(e.time) + "\" group=\"\" part=\"0\" file=\"" +
             detail::xml_escaped(name.generic_string()) + "\"/>\n";
    }
    atomic_file file{path_};
    file.write(xml + "</Collection>\n</VTKFile>\n");
    file.commit();
  }
};

}  // namespace pendular::io
