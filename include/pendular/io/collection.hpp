// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <pendular/io/atomic_file.hpp>
#include <pendular/io/number.hpp>
#include <pendular/io/vtk.hpp>

namespace pendular::io {

/// A time series of .vtp files: open `path` (.pvd) in ParaView. The file is rewritten at each add(), so a running or
/// interrupted simulation can be looked at.
class collection {
 public:
  struct entry {
    double time;                 // s
    std::filesystem::path file;  // as add() takes it
  };

  /// `entries` are the frames already written, when a simulation is resumed.
  explicit collection(std::filesystem::path path, std::vector<entry> entries = {})
      : path_{std::move(path)}, entries_{std::move(entries)} {}

  /// `file` is relative to the working folder, as it was given to write_points. Throws std::runtime_error when the
  /// .pvd file cannot be written.
  void add(double time, std::filesystem::path file) {
    entries_.push_back({time, std::move(file)});
    write();
  }

  const std::vector<entry>& entries() const { return entries_; }

 private:
  std::filesystem::path path_;
  std::vector<entry> entries_;

  /// Names relative to the .pvd file, so that the folder can be moved as a whole.
  void write() const {
    const auto folder = std::filesystem::absolute(path_).lexically_normal().parent_path();
    std::string xml = "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"";
    xml += detail::byte_order() + std::string{"\">\n<Collection>\n"};
    for (const entry& e : entries_) {
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
