// SPDX-License-Identifier: BSD-3-Clause
// Volumes of spheres in an upright cylinder, against caps and napkin rings in closed form.
#include "../catch.hpp"

#include <pendular/boundary/wall.hpp>
#include <pendular/law/normal/linear.hpp>
#include <pendular/observe/circle_overlap.hpp>
#include <pendular/observe/solid_fraction.hpp>
#include <pendular/system.hpp>

#include <cmath>
#include <numbers>

using namespace pendular;
using observe::circle_overlap;
using observe::upright_cylinder;
using observe::volume_within;
using std::numbers::pi;

TEST_CASE("circles share the area of two segments") {
  CHECK(circle_overlap(1, 1, 1) == within(1e-14, 1.2283696986087568));  // 2 pi / 3 - sqrt(3) / 2
  CHECK(circle_overlap(3, 4, 5) == within(1e-14, 6.6416747027070614));  // 9 acos(3/5) + 16 acos(4/5) - 12
  CHECK(circle_overlap(4, 3, 5) == within(1e-14, 6.6416747027070614));
}

TEST_CASE("circles apart share nothing, one inside of the other is shared whole") {
  CHECK((circle_overlap(1, 2, 3) == 0 && circle_overlap(1, 2, 7) == 0));
  CHECK((circle_overlap(1, 2, 0) == within(1e-15, pi) && circle_overlap(2, 1, 0.9) == within(1e-15, pi)));
  CHECK(circle_overlap(1, 1, 0) == within(1e-15, pi));
  CHECK(circle_overlap(1, 2, 2.9999999) < 1e-9);
  CHECK(circle_overlap(1, 2, 1.0000001) == within(1e-9, pi));
}

TEST_CASE("a sphere that is wholly in or out counts wholly or not at all") {
  const upright_cylinder c{5, -4, 4};
  CHECK(volume_within({1, 2, 0.5}, 1.5, c) == within(1e-15, 4.0 / 3 * pi * 3.375));
  for (const vector& outside : {vector{7, 0, 0}, vector{0, 0, 5.5}, vector{0, 0, -9}, vector{-4.5, -4.5, 0}}) {
    CHECK(volume_within(outside, 1.2, c) == 0);
  }
}

TEST_CASE("a sphere that is cut by an end counts with its cap") {
  const upright_cylinder c{50, 0, 10};
  const auto cap = [](double radius, double height) { return pi * height * height * (3 * radius - height) / 3; };
  CHECK(volume_within({3, 4, -0.5}, 2, c) == within(1e-12, cap(2, 1.5)));
  CHECK(volume_within({3, 4, 10.5}, 2, c) == within(1e-12, cap(2, 1.5)));
  CHECK(volume_within({0, 0, 9}, 2, c) == within(1e-12, 4.0 / 3 * pi * 8 - cap(2, 1)));
  CHECK(volume_within({0, 0, 5}, 8, c) == within(1e-12, 4.0 / 3 * pi * 512 - 2 * cap(8, 3)));  // at both ends
}

TEST_CASE("a sphere about the axis counts with what a drill of the cylinder's radius takes out") {
  const upright_cylinder c{3, -10, 10};
  const double whole = 4.0 / 3 * pi * 125, drilled = whole - 4.0 / 3 * pi * std::pow(25.0 - 9, 1.5);
  CHECK(std::abs(volume_within({0, 0, 0}, 5, c) - drilled) < 1e-3 * whole);
}

TEST_CASE("a sphere that is cut by the side counts with its part, nearly a cap at a wide cylinder") {
  const double radius = 1e4;
  const auto part = [&](double inside) {  // of a sphere of radius 1 whose centre is so far inside
    return volume_within({0.6 * (radius - inside), -0.8 * (radius - inside), 0}, 1, {radius, -5, 5});
  };
  const double whole = 4.0 / 3 * pi;
  for (const double h : {-0.5, 0.0, 0.3, 0.9}) {
    const double cap = pi * (1 + h) * (1 + h) * (2 - h) / 3;
    CHECK(std::abs(part(h) - cap) < 1e-3 * whole);
  }
}

TEST_CASE("solid fractions of the cell are those of bulk and surroundings together") {
  pendular::system s{material{normal::linear{1e3}}, boundary::walls{}, half_step_velocity_verlet{1e-7},
                     run_options{.force = true}};
  // one grain in the bulk, one at the floor, one half beyond the side
  s.add({{0, 0, 5}, 1, 1});
  s.add({{1, 0, 0.5}, 0.5, 1});
  s.add({{0, 4, 7}, 0.8, 1});
  const auto f = observe::solid_fractions_of(s.particles(), {4, 0, 10}, 2);
  const double cell = pi * 16 * 10, bulk = pi * 4 * 6, sphere = 4.0 / 3 * pi;
  CHECK(f.bulk == within(1e-12, sphere / bulk));
  CHECK(f.cell > sphere * (1 + 0.125) / cell);
  CHECK(f.cell < sphere * (1 + 0.125 + 0.512 / 2) / cell);
  CHECK(f.near_walls == within(1e-12, (f.cell * cell - sphere) / (cell - bulk)));
  CHECK(observe::solid_fraction_within(s.particles(), {4, 0, 10}) == f.cell);
}

TEST_CASE("a cell without a bulk has none, and a margin without meaning is refused") {
  pendular::system s{material{normal::linear{1e3}}, boundary::walls{}, half_step_velocity_verlet{1e-7},
                     run_options{.force = true}};
  s.add({{0, 0, 1}, 1, 1});
  const auto narrow = observe::solid_fractions_of(s.particles(), {2, 0, 10}, 2);
  CHECK((narrow.bulk == 0 && narrow.near_walls == narrow.cell));
  const auto flat = observe::solid_fractions_of(s.particles(), {20, 0, 3}, 2);
  CHECK((flat.bulk == 0 && flat.near_walls == flat.cell && flat.cell > 0));
  const auto whole = observe::solid_fractions_of(s.particles(), {20, 0, 3}, 0);
  CHECK((whole.bulk == whole.cell && whole.near_walls == 0));
  for (const double bad : {-1.0, std::nan("")}) {
    CHECK_THROWS_AS(observe::solid_fractions_of(s.particles(), {20, 0, 3}, bad), input_error);
  }
}
