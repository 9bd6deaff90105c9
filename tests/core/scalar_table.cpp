// SPDX-License-Identifier: BSD-3-Clause
#include "../catch.hpp"

#include <pendular/core/scalar_table.hpp>

#include <array>
#include <cstdint>
#include <type_traits>

using namespace pendular;

namespace {
template <class T>
struct spring {
  Vec3<T> force;
  T energy;
};
template <class>
struct empty {};

spring<double> row_of(double n) { return {{n, n + 0.25, n + 0.5}, n + 0.75}; }

scalar_table<spring> table_of(std::size_t rows) {
  scalar_table<spring> t;
  t.resize(rows);
  for (std::size_t k = 0; k < rows; ++k) t.set_row(k, row_of(static_cast<double>(k + 1)));
  return t;
}
}  // namespace

TEST_CASE("an empty record makes a table without columns that can be carried, loaded and stored") {
  static_assert(scalar_table<empty>::width == 0 && scalar_table<spring>::width == 4);
  scalar_table<empty> t;
  t.resize(16);
  t.store_block(8, t.load_block(0));
  t.carry(std::array<std::int32_t, 3>{2, -1, 0}, 8);
  static_assert(std::is_same_v<decltype(t.row(0)), empty<double>>);
}

TEST_CASE("a row is read as it was written, and every member has its own column") {
  const scalar_table<spring> t = table_of(16);
  CHECK((t.row(4).force == vector{5, 5.25, 5.5} && t.row(4).energy == 5.75));
  CHECK((t.column(0)[4] == 5 && t.column(2)[4] == 5.5 && t.column(3)[15] == 16.75));
}

TEST_CASE("a block is eight rows, and storing it leaves the others") {
  scalar_table<spring> t = table_of(24);
  spring<block> b = t.load_block(8);
  CHECK((b.force.x[0] == 9 && b.force.y[7] == 16.25 && b.energy[3] == 12.75));
  b.energy = -b.energy;
  t.store_block(8, b);
  CHECK(
      (t.row(7).energy == 8.75 && t.row(8).energy == -9.75 && t.row(15).energy == -16.75 && t.row(16).energy == 17.75));
  CHECK(t.row(8).force == vector{9, 9.25, 9.5});
}

TEST_CASE("rows are carried to their new places; new rows and padding are zero") {
  scalar_table<spring> t = table_of(8);
  // Old rows 1 and 3 are dropped; two rows are new; the table grows to two blocks.
  t.carry(std::array<std::int32_t, 7>{5, -1, 0, 2, 4, 7, -1}, 16);
  CHECK(t.row(0).force == vector{6, 6.25, 6.5});
  CHECK((t.row(1).force == vector{0, 0, 0} && t.row(1).energy == 0));
  CHECK((t.row(2).energy == 1.75 && t.row(3).energy == 3.75 && t.row(4).energy == 5.75 && t.row(5).energy == 8.75));
  for (std::size_t k = 6; k < 16; ++k) CHECK((t.row(k).energy == 0 && t.row(k).force == vector{0, 0, 0}));
  t.carry(std::array<std::int32_t, 1>{5}, 8);
  CHECK((t.row(0).energy == 8.75 && t.column(0).size() == 8));
}
