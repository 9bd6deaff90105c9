// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

namespace examples {

/// The only job that writes into an existing folder, as long as this lives; the system lets go of it when a job is
/// killed. Throws std::runtime_error where another job has it.
class folder_lock {
 public:
  explicit folder_lock(const std::filesystem::path& folder);
  ~folder_lock();
  folder_lock(const folder_lock&) = delete;
  folder_lock& operator=(const folder_lock&) = delete;

 private:
  int folder_;
};

}  // namespace examples
