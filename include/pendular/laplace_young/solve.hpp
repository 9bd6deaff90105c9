// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/laplace_young/branch.hpp>
#include <pendular/laplace_young/state.hpp>

#include <optional>
#include <string>
#include <vector>

namespace pendular::laplace_young {

namespace detail {

inline void validate_gap(double distance) {
  expects(distance >= 0 && std::isfinite(distance), "the gap of a bridge (m)", distance, "at least 0 and finite",
          "docs/reference/laplace_young.md");
}

/// Volume, in units of the smaller radius, of the bridge between touching bodies that has this curvature k.
inline std::optional<vector6> touching_at(const geometry<double>& g, double k) {
  const double bend = g.curvature_i + g.curvature_j;
  const auto excess = [&](double log_v) -> std::optional<double> {
    const auto z = touching(g, std::exp(log_v));
    if (!z) return std::nullopt;
    return (*z)[turn] * std::exp(-(*z)[log_length]) - k;
  };
  const double height = 2 * std::cos(g.contact_angle) / std::max(k, 1e-2);
  double low =
      k > 0 ? std::clamp(std::log(3.2 * height * height / bend), std::log(1e-12), std::log(1e-2)) : std::log(1e-8);
  double high = low;
  auto f_low = excess(low), f_high = f_low;
  while (f_low && *f_low < 0 && low > std::log(1e-14)) f_low = excess(low -= 1);
  while (f_high && *f_high > 0 && high < std::log(10.0)) f_high = excess(high += 0.25);
  if (!f_low || !f_high || *f_low < 0 || *f_high > 0) return std::nullopt;
  if (low == high) return touching(g, std::exp(low));
  std::uintmax_t iterations = 60;
  const auto tight = [](double a, double b) { return std::abs(b - a) < 1e-14; };
  const auto f = [&](double log_v) { return excess(log_v).value_or(-1); };
  const auto [a, b] = boost::math::tools::toms748_solve(f, low, high, *f_low, *f_high, tight, iterations);
  return touching(g, std::exp(0.5 * (a + b)));
}

}  // namespace detail

/// All stable bridges of one volume between two bodies, from contact to rupture; the states are continued along the gap,
/// so asking for many of one bridge is cheap.
/// Validity: smaller radius R, radius ratio from 1 to infinity, contact angle in [0, 90) degrees, volume 1e-8 to 1 R^3.
/// Method: Newton and pseudo-arc-length continuation (Keller 1977) for both filling angles, curvature and length of the
/// meridian at once, on the closed form of Delaunay's surfaces.
/// Errors: input_error for a bridge out of its bounds; run_error if no bridge of this volume joins the touching bodies.
class bridges_of_volume {
 public:
  explicit bridges_of_volume(const liquid_bridge& b) : bridge_(b), branch_(start(b)) {}

  /// The bridge at this gap, m; nothing beyond the rupture distance.
  std::optional<state> at(double distance) {
    const auto z = numbers_at(distance);
    if (!z) return std::nullopt;
    return detail::state_of(bridge_, *z);
  }

  /// The same in the numbers of the solver.
  std::optional<detail::vector6> numbers_at(double distance) {
    detail::validate_gap(distance);
    return branch_.at(distance / detail::unit_of(bridge_));
  }

  /// The last stable state at fixed volume, by whatever mode it breaks.
  state last() { return detail::state_of(bridge_, branch_.last()); }

  /// m
  double rupture_distance() { return branch_.last()[detail::gap] * detail::unit_of(bridge_); }

 private:
  static detail::branch start(const liquid_bridge& b) {
    validate(b);
    const detail::geometry<double> g = detail::geometry_of(b);
    const double unit = detail::unit_of(b);
    const auto z = detail::touching(g, b.volume / (unit * unit * unit));
    if (!z) {
      throw run_error("no liquid bridge of " + pendular::detail::number(b.volume) +
                      " m3 joins the two bodies at contact (see docs/reference/laplace_young.md)");
    }
    return {g, detail::held::volume, *z};
  }

  liquid_bridge bridge_;
  detail::branch branch_;
};

/// The stable bridge at a gap, m, or nothing beyond its rupture distance. Validity and errors: see bridges_of_volume.
inline std::optional<state> solve(const liquid_bridge& b, double gap) { return bridges_of_volume(b).at(gap); }

/// Gap at which the bridge loses its stability at fixed volume, m; antisymmetric modes included.
inline double rupture_distance(const liquid_bridge& b) { return bridges_of_volume(b).rupture_distance(); }

/// The bridge that is reached from contact at a suction held fixed, Pa; nothing beyond the gap at which it breaks then,
/// or if touching bodies hold no such bridge. Of two touching ones it is that with less liquid; of two at a gap, which have
/// the suction up to where both end, that with more, the stable one. The volume of `b` is not used.
inline std::optional<state> solve_at_suction(liquid_bridge b, double gap, double suction) {
  const double unit = detail::unit_of(b);
  b.volume = unit * unit * unit;  // not used
  validate(b);
  detail::validate_gap(gap);
  expects(std::isfinite(suction), "the suction (Pa)", suction, "finite", "docs/reference/laplace_young.md");
  const detail::geometry<double> g = detail::geometry_of(b);
  const auto start = detail::touching_at(g, suction * unit / b.surface_tension);
  if (!start) return std::nullopt;
  const auto z = detail::branch(g, detail::held::suction, *start).at(gap / unit);
  if (!z) return std::nullopt;
  return detail::state_of(b, *z);
}

/// A point of the meridian.
struct profile_point {
  double height;  // along the axis from the top of body i towards body j, m
  double radius;  // m
};

/// Meridian of the stable bridge at a gap from contact line to contact line; empty beyond the rupture distance. Errors as
/// those of bridges_of_volume.
inline std::vector<profile_point> profile(const liquid_bridge& b, double gap, std::size_t points = 101) {
  detail::validate_gap(gap);
  expects(points >= 2, "the number of points of a profile", static_cast<double>(points), "at least 2",
          "docs/reference/laplace_young.md");
  const auto z = bridges_of_volume(b).numbers_at(gap);
  if (!z) return {};
  const double unit = detail::unit_of(b);
  const detail::geometry<double> g = detail::geometry_of(b);
  const meridian<double> m = detail::meridian_of(g, detail::numbers_of(*z));
  const double foot = detail::cap_of(std::exp((*z)[detail::log_arc_i]), g.curvature_i).height;
  std::vector<profile_point> line;
  for (std::size_t k = 0; k < points; ++k) {
    const double t = static_cast<double>(k) / static_cast<double>(points - 1);
    line.push_back({(m.integrate(t).height - foot) * unit, std::sqrt(m.square_radius(t)) * unit});
  }
  return line;
}

}  // namespace pendular::laplace_young
