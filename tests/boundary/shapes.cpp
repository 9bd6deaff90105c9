// SPDX-License-Identifier: BSD-3-Clause
// Where walls meet grains, in numbers from right triangles.
#include "../catch.hpp"

#include <pendular/boundary/cylinder.hpp>
#include <pendular/boundary/wall.hpp>
#include <pendular/core/lanes.hpp>

#include <cmath>

using namespace pendular;
using boundary::cylinder;
using boundary::plane;

TEST_CASE("a plane meets a grain at its height less its radius") {
  const plane floor{{7, 8, 1}, {0, 0, 1}};
  const auto above = floor.meet(vector{-3, 5, 4}, 0.5);
  CHECK(above.gap == 2.5);
  CHECK(above.normal == vector{0, 0, -1});
  CHECK(floor.meet(vector{0, 0, 1.25}, 0.5).gap == -0.25);
  CHECK(floor.meet(vector{0, 0, 0}, 0.5).gap == -1.5);  // beyond the plane it is still one-sided
}

TEST_CASE("an inclined plane measures along its normal") {
  const plane slope{{1, 0, 0}, {-0.6, 0, 0.8}};
  const auto m = slope.meet(vector{1, 9, 5}, 1.0);
  CHECK(m.gap == within(1e-15, 3));
  CHECK(m.normal == vector{0.6, 0, -0.8});
}

TEST_CASE("a cylinder meets a grain inside at its radius less the distance from the axis") {
  const cylinder c{{1, 1, 0}, {0, 0, 1}, 10};
  const auto m = c.meet(vector{4, 5, 77}, 1.0);  // 3 and 4 off the axis
  CHECK(m.gap == within(1e-15, 4));
  CHECK(m.normal.x == within(1e-15, 0.6));
  CHECK(m.normal.y == within(1e-15, 0.8));
  CHECK(m.normal.z == 0);
  CHECK(c.meet(vector{1, 10.5, 0}, 1.0).gap == within(1e-15, -0.5));
}

TEST_CASE("a cylinder may lie in any direction") {
  const cylinder c{{0, 0, 0}, {0.6, 0, 0.8}, 10};
  // 50 along the axis and 5 along (0.8, 0, -0.6)
  const auto m = c.meet(vector{34, 0, 37}, 2.0);
  CHECK(m.gap == within(1e-13, 3));
  CHECK(m.normal.x == within(1e-13, 0.8));
  CHECK(m.normal.z == within(1e-13, -0.6));
}

TEST_CASE("a grain on the axis of a cylinder has a finite gap and a normal that pushes nowhere") {
  const cylinder c{{0, 0, 0}, {0, 0, 1}, 10};
  const auto m = c.meet(vector{0, 0, 3}, 1.0);
  CHECK(m.gap == 9);
  CHECK(m.normal == vector{0, 0, 0});
}

TEST_CASE("shapes give eight grains at a time what they give one") {
  const cylinder c{{1, -2, 0}, {0, 0.6, 0.8}, 10};
  const plane p{{0, 0, 1}, {0, 0.8, 0.6}};
  Vec3<block> centre{block(0), block(0), block(0)};
  block radius(0);
  for (int k = 0; k < 8; ++k) {
    centre.x(k) = 0.3 * k, centre.y(k) = 1 - 0.7 * k, centre.z(k) = 2.0 + k, radius(k) = 0.1 * (k + 1);
  }
  const auto round = c.meet(centre, radius);
  const auto flat = p.meet(centre, radius);
  for (int k = 0; k < 8; ++k) {
    const vector one{centre.x(k), centre.y(k), centre.z(k)};
    CHECK(round.gap(k) == within(1e-14, c.meet(one, double(radius(k))).gap));
    CHECK(round.normal.y(k) == near(1e-14, c.meet(one, double(radius(k))).normal.y));
    CHECK(flat.gap(k) == within(1e-14, p.meet(one, double(radius(k))).gap));
    CHECK(flat.normal.y(k) == -0.8);
  }
}

TEST_CASE("shapes without meaning are refused where the wall is built") {
  using boundary::wall;
  CHECK_NOTHROW((wall{plane{{0, 0, 0}, {0.6, 0, 0.8}}}));
  CHECK_THROWS_AS((wall{plane{{0, 0, 0}, {0, 0, 2}}}), input_error);
  CHECK_THROWS_AS((wall{plane{{0, 0, 0}, {0, 0, 0}}}), input_error);
  CHECK_THROWS_AS((wall{plane{{0, 0, 0}, {0, 0, std::nan("")}}}), input_error);
  CHECK_NOTHROW((wall{cylinder{{0, 0, 0}, {0, 0, 1}, 1}}));
  CHECK_THROWS_AS((wall{cylinder{{0, 0, 0}, {0, 1, 1}, 1}}), input_error);
  for (const double bad : {0.0, -1.0, std::nan("")}) {
    CHECK_THROWS_AS((wall{cylinder{{0, 0, 0}, {0, 0, 1}, bad}}), input_error);
  }
}
