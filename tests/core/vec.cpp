// SPDX-License-Identifier: BSD-3-Clause
// Vectors at whole numbers worked out by hand.
#include "../catch.hpp"

#include <pendular/core/lanes.hpp>
#include <pendular/core/vec.hpp>

#include <array>
#include <cmath>
#include <limits>

using namespace pendular;

TEST_CASE("vectors of whole numbers add, scale and multiply exactly") {
  const vector a{1, 2, 3}, b{-4, 5, 6};
  CHECK(a + b == vector{-3, 7, 9});
  CHECK(a - b == vector{5, -3, -3});
  CHECK(-a == vector{-1, -2, -3});
  CHECK(2.0 * a == vector{2, 4, 6});
  CHECK(dot(a, b) == 24);
  CHECK(cross(a, b) == vector{-3, -18, 13});
  CHECK(cross(vector{1, 0, 0}, vector{0, 1, 0}) == vector{0, 0, 1});
  CHECK(norm(vector{2, -3, 6}) == 7);
  vector c = a;
  c += b;
  CHECK(c == vector{-3, 7, 9});
  c -= b;
  CHECK(c == a);
  CHECK_FALSE(a == vector{1, 2, 4});
  CHECK_FALSE(a == vector{1, 0, 3});
  CHECK_FALSE(a == vector{0, 2, 3});
}

TEST_CASE("the tangential part of a vector is what the normal leaves") {
  CHECK(tangential_part(vector{3, 4, 5}, vector{0, 0, 1}) == vector{3, 4, 0});
  // n = (3, 4, 0)/5 and a = (5, 10, 2): along = 11
  const vector t = tangential_part(vector{5, 10, 2}, vector{0.6, 0.8, 0});
  CHECK(t.x == near(1e-14, -1.6));
  CHECK(t.y == near(1e-14, 1.2));
  CHECK(t.z == 2);
}

TEST_CASE("a vector is shortened, never lengthened, and zero stays zero") {
  const vector a{2, -3, 6};
  CHECK(shortened_to(a, 14.0) == a);
  CHECK(shortened_to(a, 7.0) == a);
  CHECK(norm(shortened_to(a, 3.5)) == within(1e-15, 3.5));
  CHECK(shortened_to(a, 3.5).y == within(1e-15, -1.5));
  CHECK(shortened_to(a, 0.0) == vector{0, 0, 0});
  CHECK(shortened_to(vector{0, 0, 0}, 0.0) == vector{0, 0, 0});
  CHECK(shortened_to(vector{0, 0, 0}, 1.0) == vector{0, 0, 0});
}

TEST_CASE("rows are padded to whole blocks") {
  CHECK(padded(0) == 0);
  CHECK(padded(1) == 8);
  CHECK(padded(8) == 8);
  CHECK(padded(9) == 16);
}

TEST_CASE("a block is loaded from and stored to the rows it names") {
  std::array<double, 24> column{};
  for (std::size_t k = 0; k < column.size(); ++k) column[k] = static_cast<double>(k);
  const block middle = load(column.data() + 8);
  CHECK((middle[0] == 8 && middle[7] == 15));
  store(column.data() + 16, middle);
  CHECK((column[15] == 15 && column[16] == 8 && column[23] == 15));
}

TEST_CASE("the unit step of lanes agrees with that of a double, infinities and signed zero included") {
  const double infinite = std::numeric_limits<double>::infinity();
  const std::array<double, 8> x{-infinite, -1e300, -0.0, 0.0, 1e-299, 1.0, 1e300, infinite};
  const std::array<double, 8> expected{0, 0, 0, 0, 1, 1, 1, 1};
  const block steps = unit_step(load(x.data()));
  for (std::size_t k = 0; k < 8; ++k) {
    CHECK(steps[static_cast<int>(k)] == expected[k]);
    CHECK(unit_step(x[k]) == expected[k]);
  }
}
