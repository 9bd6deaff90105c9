// SPDX-License-Identifier: BSD-3-Clause
// Whatever the volume, the sizes and the angle: no law is infinite, pushes, or exceeds the bound of docs/reference/laws.md.
#include "../catch.hpp"

#include <pendular/law/all.hpp>
#include <pendular/testing/capillary_law.hpp>

#include <boost/hana/for_each.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <type_traits>
#include <typeinfo>

using namespace pendular;

namespace {
constexpr double plane = std::numeric_limits<double>::infinity();

/// Pull over 2 pi gamma R that no bridge exceeds.
template <class Law>
double bound() {
  if constexpr (std::is_same_v<Law, capillary::rabinovich>) return 2;
  if constexpr (std::is_same_v<Law, capillary::willett>) return 1.15;
  if constexpr (std::is_same_v<Law, capillary::soulie> || std::is_same_v<Law, capillary::mikami>) return 1.04;
  return 1 + 1e-12;
}

template <class Law>
double mean_of(const bridge<double>& b) {
  if constexpr (std::is_same_v<Law, capillary::richefeu> || std::is_same_v<Law, capillary::soulie>) {
    return std::sqrt(b.radius_i * b.radius_j);
  }
  return 2 / (1 / b.radius_i + 1 / b.radius_j);
}

struct worst {
  int sick = 0;  // not finite, or less than nothing
  double most = 0;
};

/// As double and as float.
template <class T, class Law>
void look(const Law& law, double ratio, double angle, worst& seen) {
  const fluid f{1, angle, 1000, 1e-3};
  for (double exponent = -310; exponent <= 3; exponent += exponent < -31 ? 31 : 0.5) {
    const double mean = 2 / (1 + 1 / ratio), v = std::pow(10, exponent) * mean * mean * mean;
    for (const double gap : {-0.1, -0.0, 5e-324, 1e-12, 1e-6, 1e-3, 0.03, 0.1, 0.3, 1.0, 10.0}) {
      const bridge<double> b{gap, v, 1, ratio};
      const double pull = double(testing::pull(law, bridge<T>{T(gap), T(v), T(1), T(ratio)}, f));
      if (!(std::isfinite(pull) && pull >= 0)) ++seen.sick;
      seen.most = std::max(seen.most, pull / (2 * std::numbers::pi * mean_of<Law>(b)));
    }
  }
}
}  // namespace

TEST_CASE("no capillary law pushes or exceeds its bound, whatever it is asked") {
  boost::hana::for_each(law::capillary_laws, []<class L>(L) {
    using law_type = typename L::type;
    worst seen, in_float;
    for (const double ratio : {1.0, 1.0 + 1e-15, 1.5, 10.0, 1e3, 1e6, plane}) {
      if (ratio == plane && !law_type::valid.planes) continue;
      for (double degrees = 0; degrees <= 90; degrees += 2.5) {
        look<double>(law_type{}, ratio, degrees * std::numbers::pi / 180, seen);
        look<float>(law_type{}, ratio, degrees * std::numbers::pi / 180, in_float);
      }
    }
    CAPTURE(typeid(law_type).name(), seen.most, in_float.most);
    CHECK((seen.sick == 0 && in_float.sick == 0));
    CHECK(in_float.most <= bound<law_type>() + 1e-4);
    CHECK(seen.most <= bound<law_type>());
    CHECK(seen.most >= 0.9);
  });
}

TEST_CASE("no rupture distance falls as the volume grows, whatever the sizes") {
  boost::hana::for_each(law::rupture_laws, []<class L>(L) {
    int falls = 0, sick = 0;
    for (const double ratio : {1.0, 1.5, 2.0, 10.0, 300.0, 1e3, 1e6, plane}) {
      for (const double angle : {0.0, 0.5, 1.0, std::numbers::pi / 2}) {
        double last = 0;
        for (double exponent = -320; exponent <= 6; exponent += 0.1) {
          const bridge<double> b{0, std::pow(10, exponent), 1, ratio};
          const double distance = typename L::type{}.distance(b, {1, angle, 1000, 1e-3});
          if (!(distance >= 0 && std::isfinite(distance))) ++sick;
          if (distance < last) ++falls;
          last = distance;
        }
      }
    }
    CAPTURE(typeid(typename L::type).name());
    CHECK(sick == 0);
    CHECK(falls == 0);
  });
}

TEST_CASE("Willett's rupture distance stays at the top of its fit") {
  // rho = 1/4: L (1 - 0.275 L) is largest at L = 1/0.55, where it is 1/1.1; R_h = 1.6.
  const fluid wetting{1, 0, 1000, 1e-3};
  for (const double v : {1 / (0.55 * 0.55 * 0.55), 10.0, 1e3, 1e9}) {
    const bridge<double> b{0, v * 1.6 * 1.6 * 1.6, 1, 4};
    CHECK(rupture::willett{}.distance(b, wetting) == within(1e-14, 1.6 / 1.1));
  }
  const bridge<double> below{0, 0.125 * 1.6 * 1.6 * 1.6, 1, 4};  // L = 1/2
  CHECK(rupture::willett{}.distance(below, wetting) == within(1e-14, 1.6 * 0.5 * (1 - 0.275 * 0.5)));
}
