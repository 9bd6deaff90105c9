// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#if __has_include(<catch2/catch_all.hpp>)
#include <catch2/catch_all.hpp>
#else
#include <catch2/catch.hpp>
#endif

#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <iostream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>

namespace scratch {

/// A new empty folder, its name hard on shells, removed with all it holds.
class folder {
 public:
  folder() {
    std::string name = (std::filesystem::temp_directory_path() / "pendular it's $HOME XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
    path_ = name;
  }
  folder(const folder&) = delete;
  folder& operator=(const folder&) = delete;
  ~folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }

  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

  std::size_t files() const {
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator{path_}, {}));
  }

 private:
  std::filesystem::path path_;
};

inline std::string content(const std::filesystem::path& path) {
  std::ifstream file{path, std::ios::binary};
  return {std::istreambuf_iterator<char>{file}, {}};
}

inline void write(const std::filesystem::path& path, const std::string& bytes) {
  std::ofstream{path, std::ios::binary} << bytes;
}

/// What `call` says when it throws an `Error`; else why it did not.
template <class Error, class Call>
std::string message(Call call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  } catch (const std::exception& error) {
    return std::string{"another type of error: "} + error.what();
  }
  return "no error";
}

/// True when `text` has each of `parts`.
inline bool mentions(const std::string& text, std::initializer_list<std::string> parts) {
  UNSCOPED_INFO(text);
  for (const std::string& part : parts)
    if (text.find(part) == std::string::npos) return false;
  return true;
}

/// Catches what is written to standard error.
class captured_errors {
 public:
  captured_errors() : old_{std::cerr.rdbuf(text_.rdbuf())} {}
  captured_errors(const captured_errors&) = delete;
  captured_errors& operator=(const captured_errors&) = delete;
  ~captured_errors() { std::cerr.rdbuf(old_); }
  std::string text() const { return text_.str(); }

 private:
  std::ostringstream text_;
  std::streambuf* old_;
};

/// Hides every program from shells started meanwhile.
class empty_search_path {
 public:
  empty_search_path() : old_{std::getenv("PATH")} { ::setenv("PATH", "/nowhere", 1); }
  empty_search_path(const empty_search_path&) = delete;
  empty_search_path& operator=(const empty_search_path&) = delete;
  ~empty_search_path() { ::setenv("PATH", old_.c_str(), 1); }

 private:
  std::string old_;
};

}  // namespace scratch
