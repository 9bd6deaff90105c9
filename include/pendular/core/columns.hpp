// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <span>
#include <tuple>
#include <type_traits>
#include <vector>

namespace pendular {

/// Parallel vectors of equal length, one per tag; a tag names its element type as `using type = ...`.
/// A column that no policy asks for is not in the list and costs nothing.
template <class... Tags>
class columns {
 public:
  template <class Tag>
  static constexpr bool has = (std::is_same_v<Tag, Tags> || ...);
  static constexpr std::size_t bytes_per_row = (sizeof(typename Tags::type) + ... + 0);

  std::size_t size() const { return size_; }

  template <class Tag>
  std::span<typename Tag::type> get() {
    return store<Tag>();
  }
  template <class Tag>
  std::span<const typename Tag::type> get() const {
    return store<Tag>();
  }

  void resize(std::size_t size) {
    (store<Tags>().resize(size), ...);
    size_ = size;
  }

  /// Row k becomes what was row order[k]; rows that are not in the order are no more.
  void permute(std::span<const std::size_t> order) {
    (permute_one<Tags>(order), ...);
    size_ = order.size();
  }

 private:
  template <class Tag>
  struct slot {
    std::vector<typename Tag::type> values;
  };

  template <class Tag>
  auto& store() {
    return std::get<slot<Tag>>(slots_).values;
  }
  template <class Tag>
  const auto& store() const {
    return std::get<slot<Tag>>(slots_).values;
  }

  template <class Tag>
  void permute_one(std::span<const std::size_t> order) {
    auto& values = store<Tag>();
    std::vector<typename Tag::type> moved(order.size());
    for (std::size_t k = 0; k < order.size(); ++k) moved[k] = values[order[k]];
    values.swap(moved);
  }

  std::tuple<slot<Tags>...> slots_;
  std::size_t size_ = 0;
};

}  // namespace pendular
