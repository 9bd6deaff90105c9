// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/laplace_young/table.hpp>
#include <pendular/law/capillary/pair_radius.hpp>
#include <pendular/law/validity.hpp>

#include <boost/math/quadrature/gauss.hpp>

#include <array>
#include <memory>

namespace pendular::capillary {

/// The solution of Laplace-Young itself, from a table over all volumes and size ratios at the contact angle of the scene:
///     f_c = F_D P(2 sqrt(1 - D/D_r) - 1),  F_D = 2 pi gamma R_h cos(theta) (1 - D / sqrt(D^2 + 2 V_b / (pi R_h))),
/// P a polynomial of degree 7 whose coefficients are prepared per bond. Made as `capillary::laplace_young{water}`, and to
/// be used with `rupture::laplace_young{water}`; both take the contact angle of their fluid for good.
/// Units: N from N/m, m, m3. Within 1e-4 of 2 pi gamma R_h at equal s = sqrt(1 - D/D_r) for V_b/R^3 in [1e-6, 0.3],
/// size ratios to 10 and the plane, theta to 60 degrees; 5e-4 for ratios below 1.06 between 25 and 35 degrees, where
/// equal spheres begin to break by the antisymmetric mode (docs/reference/laplace_young.md). Beyond these volumes and ratios P is that
/// of the bound.
/// Source: the solver of this library, laplace_young/solve.hpp.
class laplace_young {
 public:
  static constexpr validity valid{.least_volume = 1e-6,
                                  .largest_volume = 0.3,
                                  .largest_ratio = 10,
                                  .largest_contact_angle = 1.0472,
                                  .geometric_mean = true,
                                  .planes = true};
  static constexpr double largest_contact_angle = 1.3963;  // of a table, rad; accurate to 1.0472

  /// Errors: input_error for a contact angle above 80 degrees, where not all bridges of the table exist.
  explicit laplace_young(const fluid& f) : table_(table_for(f)) {}

  /// Errors: input_error if the fluid wets under another angle than the table was made for.
  void expect_fluid(const fluid& f) const {
    expects(f.contact_angle == table_->contact_angle(), "the contact angle of the liquid (rad)", f.contact_angle,
            "that of the fluid which its laplace_young policies were made with", "docs/reference/laplace_young.md");
  }

  /// In powers of t, times 2 pi gamma R_h cos(theta), N.
  template <class T>
  struct polynomial {
    T c0, c1, c2, c3, c4, c5, c6, c7;

    T at(const T& t) const { return c0 + t * (c1 + t * (c2 + t * (c3 + t * (c4 + t * (c5 + t * (c6 + t * c7)))))); }
  };

  template <class T>
  struct coefficients {
    T area;          // 2 V_b / (pi R_h), m2
    T rupture_rate;  // 1 / D_r, 1/m
    polynomial<T> force;
  };

  template <Scalar T>
  coefficients<T> prepare(const bridge<T>& b, const fluid& f) const {
    const T radius = harmonic_radius(b);
    const T force = T(capillary_tension(f)) * radius;
    const auto p = numbers<0>(b);
    const T distance = max(T(p[8] * cbrt(b.volume)), T(tiny));
    const auto term = [&](std::size_t k) { return T(force * p[k]); };
    return {max(T(T(2 / std::numbers::pi) * b.volume / radius), T(T(1e-12) * radius * radius)),
            T(T(1) / distance),
            {term(0), term(1), term(2), term(3), term(4), term(5), term(6), term(7)}};
  }

  template <Scalar T>
  T attraction(const T& gap, const coefficients<T>& c) const {
    const T d = max(gap, T(0));
    const T s = sqrt(T(max(T(T(1) - d * c.rupture_rate), T(tiny))));
    const T t = T(2) * s - T(1);
    const T l = sqrt(T(d * d + c.area));
    return c.force.at(t) * (c.area / (l * (l + d)));
  }

  template <Scalar T>
  T attraction(const bridge<T>& b, const fluid& f) const {
    return attraction(b.gap, prepare(b, f));
  }

  /// Work from the gap of b to the rupture distance, J.
  template <Scalar T>
  T energy(const bridge<T>& b, const fluid& f, const T& rupture_distance) const {
    return energy(b.gap, prepare(b, f), rupture_distance);
  }

  /// The same from what `prepare` answered. F_D dD = -dy with y = sqrt(D^2 + A) - D, A the area: what is left to integrate
  /// over y is P, and over the root of y without the fold at rupture.
  template <Scalar T>
  T energy(const T& gap, const coefficients<T>& c, const T& rupture_distance) const {
    using rule = boost::math::quadrature::gauss<double, 16>;
    const T own = T(1) / c.rupture_rate;
    const T first = left(gap, c), last = min(left(T(min(rupture_distance, own)), c), first);
    T sum = T(0) * gap;
    const auto add = [&](double x, double weight) {
      const double share = 0.5 * (1 + x);
      const T y = last + T(share * share) * (first - last), d = (c.area - y * y) / (y + y);
      const T s = sqrt(T(max(T(T(1) - d * c.rupture_rate), T(tiny))));
      sum = T(sum + T(weight * share) * c.force.at(T(T(2) * s - T(1))));
    };
    for (std::size_t n = 0; n < rule::abscissa().size(); ++n) {
      add(rule::abscissa()[n], rule::weights()[n]);
      add(-rule::abscissa()[n], rule::weights()[n]);
    }
    // beyond the law's own rupture distance P stays at its last value
    const T beyond = max(T(left(T(max(gap, own)), c) - left(rupture_distance, c)), T(0));
    return T(sum * (first - last) + c.force.at(T(-1)) * beyond + max(T(-gap), T(0)) * attraction(T(0), c));
  }

  /// The law's own rupture distance, m.
  template <Scalar T>
  T rupture_distance(const bridge<T>& b) const {
    return T(numbers<table::terms>(b)[0] * cbrt(b.volume));
  }

 private:
  using table = ::pendular::laplace_young::force_table;

  static std::shared_ptr<const table> table_for(const fluid& f) {
    validate(f);
    expects(f.contact_angle <= largest_contact_angle, "the contact angle of a laplace_young law (rad)", f.contact_angle,
            "at most 1.3963", "docs/reference/laplace_young.md");
    return ::pendular::laplace_young::table_of(f.contact_angle);
  }

  /// sqrt(D^2 + A) - D, m.
  template <Scalar T>
  static T left(const T& gap, const coefficients<T>& c) {
    const T d = max(gap, T(0));
    return T(c.area / T(sqrt(T(d * d + c.area)) + d));
  }

  /// v^{1/12}, v = V_b / R^3, within the table.
  template <class T>
  static T volume_root(const T& volume, const T& radius) {
    const T v = max(T(volume / (radius * radius * radius)), T(1e-12));
    const T root = cbrt(T(sqrt(T(sqrt(v)))));
    return T(min(T(max(root, T(table::root_least()))), T(table::root_largest())));
  }

  /// The last numbers that the table has for a bridge, from `First`: coefficients of P, then D_r / V^{1/3}.
  template <std::size_t First, class T>
  auto numbers(const bridge<T>& b) const {
    const T smaller = min(b.radius_i, b.radius_j), larger = max(b.radius_i, b.radius_j);
    const T part = smaller / larger;
    const T contrast = cbrt(max(T((T(1) - part) / (T(1) + part)), T(tiny)));
    const T mean = sqrt(T(smaller * larger));
    auto p = table_->evaluate<First>(volume_root(b.volume, mean), T(min(contrast, T(table::most_contrast()))));
    const T at_wall = unit_step(T(T(1 / largest_grain_ratio) - part));  // lane by lane, so both are needed
    const auto plane = table_->at_plane<First>(volume_root(b.volume, smaller));
    for (std::size_t k = 0; k < p.size(); ++k) p[k] = T(p[k] + at_wall * (plane[k] - p[k]));
    return p;
  }

  std::shared_ptr<const table> table_;
};

}  // namespace pendular::capillary

namespace pendular::rupture {

/// The gap at which a bridge loses its stability at fixed volume by Laplace-Young, antisymmetric modes included.
/// Units: m. Relative error 1e-6 for V_b/R^3 in [1e-6, 0.3], size ratios to 10 and the plane, theta to 60 degrees; 2e-5
/// for nearly equal spheres between 25 and 35 degrees. Beyond, V_b^{1/3} times the value at the bound.
/// Source: the solver of this library, laplace_young/solve.hpp.
class laplace_young {
 public:
  explicit laplace_young(const fluid& f) : law_(f) {}

  static constexpr validity valid = capillary::laplace_young::valid;

  /// Errors: as those of the law.
  void expect_fluid(const fluid& f) const { law_.expect_fluid(f); }

  template <Scalar T>
  T distance(const bridge<T>& b, const fluid&) const {
    return law_.rupture_distance(b);
  }

 private:
  capillary::laplace_young law_;
};

}  // namespace pendular::rupture
