// SPDX-License-Identifier: BSD-3-Clause
#include <pendular/io/atomic_file.hpp>

#include "scratch.hpp"

using pendular::io::atomic_file;

TEST_CASE("a file appears only when it is committed", "[io]") {
  const scratch::folder folder;
  const auto path = folder / "new folder/out.txt";
  {
    atomic_file file{path};
    file.write("abc");
    CHECK_FALSE(std::filesystem::exists(path));
    file.commit();
    CHECK(scratch::content(path) == "abc");
  }
  CHECK(scratch::content(path) == "abc");
  CHECK_FALSE(std::filesystem::exists(path.string() + ".tmp"));
}

TEST_CASE("a file that is not committed leaves the old one", "[io]") {
  const scratch::folder folder;
  scratch::write(folder / "out.txt", "old");
  try {
    atomic_file file{folder / "out.txt"};
    file.write("new");
    throw 1;
  } catch (int) {
  }
  CHECK(scratch::content(folder / "out.txt") == "old");
  CHECK(folder.files() == 1);
}

TEST_CASE("a file in an impossible place says where and why", "[io]") {
  const scratch::folder folder;
  scratch::write(folder / "file", "");
  const auto said = scratch::message<std::runtime_error>([&] { atomic_file{folder / "file/out.txt"}; });
  CHECK(scratch::mentions(said, {"file/out.txt", "Not a directory", "choose"}));

  std::filesystem::create_directories(folder / "taken/inside");
  const auto refused = scratch::message<std::runtime_error>([&] {
    atomic_file file{folder / "taken"};
    file.commit();
  });
  CHECK(scratch::mentions(refused, {"taken", "Is a directory"}));
  CHECK_FALSE(std::filesystem::exists((folder / "taken").string() + ".tmp"));
}

TEST_CASE("a full disc is reported", "[io]") {
  if (!std::filesystem::exists("/dev/full")) return;
  const scratch::folder folder;
  std::filesystem::create_symlink("/dev/full", folder / "out.txt.tmp");
  const auto said = scratch::message<std::runtime_error>([&] {
    atomic_file file{folder / "out.txt"};
    file.write("abc");
    file.commit();
  });
  CHECK(scratch::mentions(said, {"out.txt", "No space left"}));
  CHECK_FALSE(std::filesystem::exists(folder / "out.txt"));
}
