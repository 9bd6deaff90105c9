// SPDX-License-Identifier: BSD-3-Clause
// Where walls meet grains, in numbers from right triangles.
#include "../catch.hpp"

#include <pendular/boundary/cylinder.hpp>
#include <pendular/boundary/rimmed_cylinder.hpp>
#include <pendular/boundary/wall.hpp>
#include <pendular/core/lanes.hpp>

#include <cmath>

using namespace pendular;
using boundary::cylinder;
using boundary::plane;
using boundary::rimmed_cylinder;

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

TEST_CASE("a rimmed cylinder is a cylinder within, an edge above the rim and a plane over its solid") {
  const rimmed_cylinder lower{{1, 1, 10}, {0, 0, -1}, 10};  // solid below z = 10
  const auto within_it = lower.meet(vector{4, 5, 7}, 1.0);
  CHECK(within_it.gap == within(1e-15, 4));
  CHECK(norm(within_it.normal - vector{0.6, 0.8, 0}) < 1e-15);
  CHECK(lower.meet(vector{1, 10.5, 0}, 1.0).gap == within(1e-15, -0.5));
  const auto at_edge = lower.meet(vector{8, 1, 14}, 2.0);  // 3 short of the edge, 4 above it
  CHECK(at_edge.gap == within(1e-15, 3));
  CHECK(at_edge.normal.x == within(1e-15, 0.6));
  CHECK(at_edge.normal.z == within(1e-15, -0.8));
  const auto on_rim = lower.meet(vector{1, 12, 13}, 3.5);
  CHECK(on_rim.gap == within(1e-15, -0.5));
  CHECK(on_rim.normal == vector{0, 0, -1});
  CHECK(lower.meet(vector{1, 10.5, 5}, 1.0).gap == lower.meet(vector{1, 10.5, 10 - 1e-9}, 1.0).gap);
}

TEST_CASE("gap and normal of a rimmed cylinder have no jump where a grain passes the rim") {
  const rimmed_cylinder upper{{0, 0, 0}, {0, 0, 1}, 10};  // solid above z = 0
  const auto above = upper.meet(vector{9, 0, 1e-9}, 1.0), below = upper.meet(vector{9, 0, -1e-9}, 1.0);
  CHECK(above.gap == near(1e-12, below.gap));
  CHECK(norm(above.normal - below.normal) < 1e-8);
  const auto inwards = upper.meet(vector{10 - 1e-9, 0, -1}, 1.0), outwards = upper.meet(vector{10 + 1e-9, 0, -1}, 1.0);
  CHECK(inwards.gap == near(1e-12, outwards.gap));
  CHECK(norm(inwards.normal - outwards.normal) < 1e-8);
  CHECK(outwards.normal == vector{0, 0, 1});
}

TEST_CASE("a grain on the axis of a rimmed cylinder, or on its very edge, has a finite gap") {
  const rimmed_cylinder c{{0, 0, 0}, {0, 0, 1}, 10};
  CHECK(c.meet(vector{0, 0, 3}, 1.0).gap == 9);
  CHECK(c.meet(vector{0, 0, 3}, 1.0).normal == vector{0, 0, 0});
  CHECK(c.meet(vector{10, 0, 0}, 1.0).gap == -1);
  CHECK(std::isfinite(norm(c.meet(vector{10, 0, 0}, 1.0).normal)));
}

TEST_CASE("shapes give eight grains at a time what they give one") {
  const cylinder c{{1, -2, 0}, {0, 0.6, 0.8}, 10};
  const plane p{{0, 0, 1}, {0, 0.8, 0.6}};
  const rimmed_cylinder half{{1, -2, 5}, {0, 0.6, 0.8}, 2};
  Vec3<block> centre{block(0), block(0), block(0)};
  block radius(0);
  for (int k = 0; k < 8; ++k) {
    centre.x.set(k, 0.3 * k), centre.y.set(k, 1 - 0.7 * k), centre.z.set(k, 2.0 + k), radius.set(k, 0.1 * (k + 1));
  }
  const auto round = c.meet(centre, radius);
  const auto flat = p.meet(centre, radius);
  const auto rimmed = half.meet(centre, radius);
  for (int k = 0; k < 8; ++k) {
    const vector one{centre.x[k], centre.y[k], centre.z[k]};
    CHECK(round.gap[k] == within(1e-14, c.meet(one, radius[k]).gap));
    CHECK(round.normal.y[k] == near(1e-14, c.meet(one, radius[k]).normal.y));
    CHECK(flat.gap[k] == within(1e-14, p.meet(one, radius[k]).gap));
    CHECK(flat.normal.y[k] == -0.8);
    CHECK(rimmed.gap[k] == within(1e-14, half.meet(one, radius[k]).gap));
    CHECK(rimmed.normal.y[k] == near(1e-14, half.meet(one, radius[k]).normal.y));
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
  CHECK_THROWS_AS((wall{rimmed_cylinder{{0, 0, 0}, {0, 1, 1}, 1}}), input_error);
  for (const double bad : {0.0, -1.0, std::nan("")}) {
    CHECK_THROWS_AS((wall{cylinder{{0, 0, 0}, {0, 0, 1}, bad}}), input_error);
    CHECK_THROWS_AS((wall{rimmed_cylinder{{0, 0, 0}, {0, 0, 1}, bad}}), input_error);
  }
}
