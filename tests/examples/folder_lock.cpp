// SPDX-License-Identifier: BSD-3-Clause
#include "../catch.hpp"

#include "../../examples/common/folder_lock.hpp"

#include <filesystem>
#include <optional>

TEST_CASE("one job at a time writes into a folder, and the next may when it has gone") {
  const auto folder = std::filesystem::temp_directory_path() / "pendular_folder_lock";
  std::filesystem::create_directories(folder);
  std::optional<examples::folder_lock> first(std::in_place, folder);
  CHECK_THROWS_WITH(examples::folder_lock(folder),
                    Catch::Matchers::Contains("another job is writing to " + folder.string()));
  first.reset();
  CHECK_NOTHROW(examples::folder_lock(folder));
  std::filesystem::remove(folder);
}
