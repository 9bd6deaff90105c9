// SPDX-License-Identifier: BSD-3-Clause
#include "../catch.hpp"

#include <pendular/space/grains.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <string>

using namespace pendular;

namespace {
using sliding = grains<false, false>;
using rolling = grains<true, true>;
constexpr double infinite = std::numeric_limits<double>::infinity();

std::string refusal(const grain& g) {
  rolling all;
  all.add({{0, 0, 0}, 1, 1});
  try {
    all.add(g);
  } catch (const input_error& error) {
    CHECK(all.size() == 1);  // nothing was changed
    return error.what();
  }
  return "accepted";
}
bool mentions(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }
}  // namespace

TEST_CASE("a grain gets the mass and the inertia of a solid sphere") {
  rolling g;
  g.add({{1, 2, 3}, 0.5e-3, 2600, {4, 5, 6}, {7, 8, 9}});
  CHECK(1 / g.get<column::inverse_mass>()[0] == within(1e-12, 1.361356816555577e-6));
  CHECK(1 / g.get<column::inverse_inertia>()[0] == within(1e-12, 1.361356816555577e-6 * 0.25e-6 * 0.4));
  CHECK(g.get<column::position>()[0] == vector{1, 2, 3});
  CHECK(g.get<column::velocity>()[0] == vector{4, 5, 6});
  CHECK(g.get<column::angular_velocity>()[0] == vector{7, 8, 9});
  CHECK(g.get<column::force>()[0] == vector{0, 0, 0});
  CHECK(g.get<column::torque>()[0] == vector{0, 0, 0});
  CHECK(g.get<column::contacts>()[0] == 0);
}

TEST_CASE("a grain is given back as it was put in") {
  rolling g;
  g.add({{0, 0, 0}, 1, 1});
  g.add({{1, 2, 3}, 0.7e-3, 2600, {4, 5, 6}, {7, 8, 9}});
  const grain again = g[1];
  CHECK((again.position == vector{1, 2, 3} && again.velocity == vector{4, 5, 6} && again.radius == 0.7e-3));
  CHECK(again.density == within(1e-14, 2600));
  CHECK(again.angular_velocity == vector{7, 8, 9});
}

TEST_CASE("ids are given in the order of adding and found again after a permutation") {
  sliding g;
  for (int k = 0; k < 4; ++k) g.add({{1.0 * k, 0, 0}, 0.1 * (k + 1), 1});
  g.permute(std::array<std::size_t, 4>{2, 0, 3, 1});
  CHECK((g.get<column::id>()[0] == 2 && g.get<column::id>()[1] == 0 && g.get<column::id>()[2] == 3));
  CHECK(g.rows_by_id() == std::vector<std::size_t>{1, 3, 0, 2});
  for (std::int64_t id = 0; id < 4; ++id) {
    const std::size_t row = g.rows_by_id()[static_cast<std::size_t>(id)];
    CHECK(g.get<column::position>()[row].x == static_cast<double>(id));
    CHECK(g.get<column::radius>()[row] == within(1e-15, 0.1 * static_cast<double>(id + 1)));
  }
  g.add({{9, 0, 0}, 1, 1});
  CHECK(g.get<column::id>()[4] == 4);
}

TEST_CASE("grains without size, mass or place are refused before anything is changed") {
  CHECK(refusal({{0, 0, 0}, 1, 1}) == "accepted");
  for (const double bad : {0.0, -1e-3, std::nan(""), infinite}) {
    CHECK(mentions(refusal({{0, 0, 0}, bad, 1}), "the radius of a grain (m)"));
    CHECK(mentions(refusal({{0, 0, 0}, 1, bad}), "the density of a grain (kg/m3)"));
  }
  for (const double bad : {std::nan(""), infinite, -infinite}) {
    CHECK(mentions(refusal({{0, bad, 0}, 1, 1}), "position or velocity"));
    CHECK(mentions(refusal({{0, 0, 0}, 1, 1, {0, 0, bad}}), "position or velocity"));
    CHECK(mentions(refusal({{0, 0, 0}, 1, 1, {0, 0, 0}, {bad, 0, 0}}), "angular velocity"));
  }
  CHECK(mentions(refusal({{0, 0, 0}, -1, 1}), "docs/reference/grains.md"));
}
