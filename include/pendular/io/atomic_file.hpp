// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

namespace pendular::io {

/// A file that appears under its name only when it is complete: bytes go to `path.tmp`, and commit() flushes them to
/// the disc and renames. Without commit() the temporary is removed and whatever stood at `path` stays. The folder of
/// `path` is created if absent. Every member throws std::runtime_error with the system's reason.
class atomic_file {
 public:
  explicit atomic_file(std::filesystem::path path) : path_{std::move(path)}, temporary_{path_} {
    temporary_ += ".tmp";
    std::error_code ignored;  // an unusable folder is reported by fopen
    if (path_.has_parent_path()) std::filesystem::create_directories(path_.parent_path(), ignored);
    file_ = std::fopen(temporary_.c_str(), "wb");
    if (file_ == nullptr) fail();
  }

  atomic_file(const atomic_file&) = delete;
  atomic_file& operator=(const atomic_file&) = delete;

  ~atomic_file() {
    if (file_ != nullptr) std::fclose(file_);
    std::error_code ignored;
    if (!committed_) std::filesystem::remove(temporary_, ignored);
  }

  void write(const void* bytes, std::size_t size) {
    if (size != 0 && std::fwrite(bytes, 1, size, file_) != size) fail();
  }

  void write(std::string_view text) { write(text.data(), text.size()); }

  /// Call once, last.
  void commit() {
    if (std::fflush(file_) != 0 || ::fsync(::fileno(file_)) != 0) fail();
    if (std::fclose(std::exchange(file_, nullptr)) != 0) fail();
    if (std::rename(temporary_.c_str(), path_.c_str()) != 0) fail();
    committed_ = true;
    sync_folder();
  }

 private:
  std::filesystem::path path_;
  std::filesystem::path temporary_;
  std::FILE* file_ = nullptr;
  bool committed_ = false;

  [[noreturn]] void fail() {
    const std::string reason = std::strerror(errno);
    if (file_ != nullptr) std::fclose(std::exchange(file_, nullptr));
    std::error_code ignored;
    std::filesystem::remove(temporary_, ignored);
    throw std::runtime_error("pendular: cannot write '" + path_.string() + "' (" + reason +
                             "); choose a path in a writable folder with free space");
  }

  /// The rename itself survives a power cut only once the folder is on the disc; file systems that refuse are left be.
  void sync_folder() const {
    const std::filesystem::path folder = path_.has_parent_path() ? path_.parent_path() : ".";
    const int descriptor = ::open(folder.c_str(), O_RDONLY);
    if (descriptor < 0) return;
    ::fsync(descriptor);
    ::close(descriptor);
  }
};

}  // namespace pendular::io
