// SPDX-License-Identifier: BSD-3-Clause
#include "folder_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <stdexcept>

namespace examples {

folder_lock::folder_lock(const std::filesystem::path& folder) : folder_(open(folder.c_str(), O_RDONLY | O_CLOEXEC)) {
  // A file system without locks is no reason to refuse the job.
  if (folder_ < 0 || flock(folder_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
  close(folder_);
  throw std::runtime_error("another job is writing to " + folder.string() +
                           ": wait until it ends, or choose another folder");
}

folder_lock::~folder_lock() {
  if (folder_ >= 0) close(folder_);
}

}  // namespace examples
