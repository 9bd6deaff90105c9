// SPDX-License-Identifier: BSD-3-Clause
// The solver against a Runge-Kutta integration of the same equation and against itself in fifty digits.
#include "../catch.hpp"
#include "samples.hpp"
#include "second_method.hpp"

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <algorithm>

using namespace samples;

TEST_CASE("a Runge-Kutta integration from one contact line arrives at the other", "[slow]") {
  double radius_off = 0, angle_off = 0, height_off = 0, volume_off = 0, area_off = 0;
  for (const liquid_bridge& b : of_all_kinds(300, 2)) {
    bridges_of_volume bridges(b);
    const double farthest = bridges.rupture_distance();
    for (const double part : parts) {
      const auto s = bridges.at(part * farthest);
      REQUIRE(s);
      const auto end = second_method::arrive(*s, b, std::sqrt(s->contact_radius_i * radius));
      const double angle = std::numbers::pi / 2 - b.contact_angle - s->filling_angle_j;
      const double caps = cap_volume(b.radius_i, s->filling_angle_i) + cap_volume(b.radius_j, s->filling_angle_j);
      const auto worst = [](double& so_far, double off) { so_far = std::max(so_far, std::abs(off)); };
      worst(radius_off, end.radius / s->contact_radius_j - 1);
      worst(height_off, end.height / s->contact_radius_j);
      worst(angle_off, end.angle - angle);
      worst(volume_off, (end.volume - caps) / b.volume - 1);
      worst(area_off, end.area / s->free_area - 1);
    }
  }
  CAPTURE(radius_off, height_off, angle_off, volume_off, area_off);
  CHECK(std::max({radius_off, height_off, angle_off, volume_off, area_off}) < 1e-9);
}

namespace {
using fifty = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;

struct refined {
  double force_off, residual;
};

/// The same state in fifty digits, by corrections with the slope in double.
refined refine(const detail::geometry<double>& g, const detail::vector6& z) {
  const detail::geometry<fifty> wide{g.curvature_i, g.curvature_j, g.contact_angle};
  std::array<fifty, detail::places> x;
  for (std::size_t k = 0; k < x.size(); ++k) x[k] = z[static_cast<int>(k)];
  const auto slope = Eigen::Matrix4d(detail::linearise(g, z).slope.leftCols<4>()).fullPivLu();
  fifty size = 1;
  for (int iteration = 0; iteration < 60 && size > fifty("1e-40"); ++iteration) {
    const auto r = detail::residuals(wide, x);
    size = 0;
    for (const fifty& one : r) size = std::max<fifty>(size, abs(one));
    Eigen::Vector4d scaled;
    for (int k = 0; k < 4; ++k) scaled[k] = static_cast<double>(fifty(r[static_cast<std::size_t>(k)] / size));
    const Eigen::Vector4d step = slope.solve(scaled);
    for (int k = 0; k < 4; ++k) x[static_cast<std::size_t>(k)] -= fifty(step[k]) * size;
  }
  const double force = detail::meridian_of(g, detail::numbers_of(z)).force;
  return {static_cast<double>(fifty(detail::meridian_of(wide, x).force / force - 1)), static_cast<double>(size)};
}
}  // namespace

TEST_CASE("the force is that of fifty digits to 1e-9", "[slow]") {
  double worst = 0;
  for (const liquid_bridge& b : of_all_kinds(25, 3)) {
    const auto g = detail::geometry_of(b);
    detail::branch branch(g, detail::held::volume, *detail::touching(g, b.volume / (radius * radius * radius)));
    const double farthest = branch.last()[detail::gap];
    for (const double part : {0.0, 0.5, 0.99, 1 - 1e-6}) {
      const refined r = refine(g, *branch.at(part * farthest));
      REQUIRE(r.residual < 1e-35);
      worst = std::max(worst, std::abs(r.force_off));
    }
  }
  CAPTURE(worst);
  CHECK(worst < 1e-9);
}
