// SPDX-License-Identifier: BSD-3-Clause
#include "../catch.hpp"

#include <pendular/core/columns.hpp>

#include <array>
#include <cstdint>
#include <type_traits>

using namespace pendular;

namespace {
struct weight {
  using type = double;
};
struct label {
  using type = std::int64_t;
};
struct colour {
  using type = int;
};
using table = columns<weight, label>;

static_assert(table::has<weight> && table::has<label> && !table::has<colour>);
static_assert(std::is_same_v<decltype(std::declval<table&>().get<label>()), std::span<std::int64_t>>);
static_assert(std::is_same_v<decltype(std::declval<const table&>().get<weight>()), std::span<const double>>);
static_assert(sizeof(columns<weight>) < sizeof(table));

table of_five() {
  table t;
  t.resize(5);
  for (std::size_t k = 0; k < 5; ++k) {
    t.get<weight>()[k] = 0.5 * static_cast<double>(k);
    t.get<label>()[k] = static_cast<std::int64_t>(100 + k);
  }
  return t;
}
}  // namespace

TEST_CASE("columns have equal lengths, keep their rows when they grow and start at zero") {
  table t;
  CHECK(t.size() == 0);
  t.resize(2);
  t.get<weight>()[1] = 3;
  t.resize(4);
  CHECK((t.size() == 4 && t.get<weight>().size() == 4 && t.get<label>().size() == 4));
  CHECK((t.get<weight>()[1] == 3 && t.get<weight>()[3] == 0 && t.get<label>()[0] == 0));
  t.resize(1);
  CHECK((t.size() == 1 && t.get<label>().size() == 1));
}

TEST_CASE("a permutation moves all columns alike: row k becomes what was row order[k]") {
  table t = of_five();
  // A cycle of three and a swap, so that the inverse permutation would give something else.
  const std::array<std::size_t, 5> order{1, 2, 0, 4, 3};
  t.permute(order);
  const std::array<std::int64_t, 5> labels{101, 102, 100, 104, 103};
  for (std::size_t k = 0; k < 5; ++k) {
    CHECK(t.get<label>()[k] == labels[k]);
    CHECK(t.get<weight>()[k] == 0.5 * static_cast<double>(labels[k] - 100));
  }
}

TEST_CASE("spans of one table see what was written through another") {
  table t = of_five();
  const table& seen = t;
  t.get<weight>()[4] = 7;
  CHECK(seen.get<weight>()[4] == 7);
}
