// SPDX-License-Identifier: BSD-3-Clause
// The mean radius as a policy: shipped ones, one's own with and without a parameter, in law, kit and validity.
#include "../catch.hpp"

#include <pendular/law/all.hpp>
#include <pendular/law/check.hpp>
#include <pendular/law/prepared.hpp>
#include <pendular/testing/archetypes.hpp>
#include <pendular/testing/law_kits.hpp>

#include <algorithm>
#include <numbers>
#include <string>
#include <type_traits>

using namespace pendular;

namespace {

/// A user's mean, with a range of its own.
struct arithmetic {
  static constexpr validity valid{.largest_ratio = 2, .planes = false};

  template <Scalar T>
  T of(const bridge<T>& b) const {
    return T(0.5) * (b.radius_i + b.radius_j);
  }
};

/// Another one with a parameter: between the smaller and the harmonic mean.
struct mixed {
  double share;

  template <Scalar T>
  T of(const bridge<T>& b) const {
    const T harmonic = capillary::harmonic_radius(b);
    return T(1 - share) * min(b.radius_i, b.radius_j) + T(share) * harmonic;
  }
};
void validate(const mixed& m) { expects(m.share >= 0 && m.share <= 1, "the share", m.share, "in [0, 1]", "my page"); }

using of_arithmetic = capillary::richefeu_with<arithmetic>;
static_assert(check::mean_radius<arithmetic> && check::mean_radius<mixed>);
static_assert(check::capillary_law<of_arithmetic> && check::capillary_law<capillary::richefeu_with<mixed>>);
static_assert(HasCapillaryEnergy<of_arithmetic>);
static_assert(sizeof(of_arithmetic) == sizeof(double) && sizeof(capillary::richefeu_with<mixed>) == 2 * sizeof(double));
static_assert(std::is_same_v<capillary::richefeu, capillary::richefeu_with<mean_radius::geometric>> &&
              std::is_same_v<capillary::richefeu_harmonic, capillary::richefeu_with<mean_radius::harmonic>>);

constexpr fluid unit{1 / (2 * std::numbers::pi), 0, 1000, 1e-3};  // kappa = 1 N/m
constexpr bridge<double> touching{0, 1e-3, 1, 3};

template <class Law>
double pull(const Law& law, const bridge<double>& b) {
  return attraction(law, b.gap, prepare(law, b, unit), unit);
}
}  // namespace

TEST_CASE("means of 1 and 3, and the pull at contact, are those of a pocket calculator") {
  CHECK(mean_radius::geometric{}.of(touching) == within(1e-9, 1.7320508076));
  CHECK(mean_radius::harmonic{}.of(touching) == within(1e-15, 1.5));
  CHECK(pull(capillary::richefeu{}, touching) == within(1e-9, 1.7320508076));
  CHECK(pull(capillary::richefeu_harmonic{}, touching) == within(1e-14, 1.5));
  CHECK(pull(of_arithmetic{}, touching) == within(1e-14, 2));
  CHECK(pull(capillary::richefeu_with{0.9, mixed{0.5}}, touching) == within(1e-14, 1.25));
}

TEST_CASE("the mean is in the amplitude alone: pulls decay alike over the gap") {
  const bridge<double> open{0.05, 1e-3, 1, 3};
  const double share = pull(capillary::richefeu{}, open) / pull(capillary::richefeu{}, touching);
  CHECK(share < 0.5);
  CHECK(pull(of_arithmetic{}, open) / pull(of_arithmetic{}, touching) == within(1e-13, share));
  const double longer = pull(of_arithmetic{1.8}, open) / pull(of_arithmetic{1.8}, touching);
  CHECK(longer * longer == within(1e-13, share));
}

TEST_CASE("where a law is valid is where its mean is") {
  CHECK(validity_of<capillary::richefeu>().largest_ratio == 4);
  CHECK(validity_of<capillary::richefeu_harmonic>().largest_ratio == 1e300);
  CHECK(validity_of<of_arithmetic>().largest_ratio == 2);
  CHECK(validity_of<capillary::richefeu>().covers({0, 1e-3, 1, 4}, unit));
  CHECK_FALSE(validity_of<capillary::richefeu>().covers({0, 1e-3, 1, 4.1}, unit));
  CHECK_FALSE(validity_of<of_arithmetic>().covers({0, 1e-3, 3, 1}, unit));
}

TEST_CASE("a parameter of the law and one of its mean are refused out of bounds") {
  CHECK_NOTHROW(validate(capillary::richefeu_with{0.9, mixed{1}}));
  CHECK_THROWS_AS(validate(capillary::richefeu_with{0.9, mixed{1.5}}), input_error);
  CHECK_THROWS_AS(validate(capillary::richefeu_with{0.0, mixed{1}}), input_error);
}

TEST_CASE("means keep their promises, and so does the law with one's own") {
  const auto check_sound = [](const testing::report& found) {
    for (const std::string& broken : found) FAIL_CHECK(broken);
    SUCCEED();
  };
  check_sound(testing::mean_radius_report(mean_radius::geometric{}));
  check_sound(testing::mean_radius_report(mean_radius::harmonic{}));
  check_sound(testing::mean_radius_report(arithmetic{}));
  check_sound(testing::mean_radius_report(mixed{0.5}));
  check_sound(testing::mean_radius_report(testing::archetype::mean_radius(0.5)));
  check_sound(testing::capillary_law_report(of_arithmetic{}, fluid::water()));
}

namespace {
struct bad_mean {
  enum class mistake { none, first, of_the_gap, squared, smaller } made;
  template <Scalar T>
  T of(const bridge<T>& b) const {
    const T mean = T(0.5) * (b.radius_i + b.radius_j);
    if (made == mistake::first) return b.radius_i;
    if (made == mistake::of_the_gap) return mean - T(0.1) * max(b.gap, T(0)) * (b.radius_j / b.radius_i - T(1));
    if (made == mistake::squared) return min(max(T(T(1e3) * mean * mean), min(b.radius_i, b.radius_j)), mean);
    if (made == mistake::smaller) return T(0.4) * (b.radius_i + b.radius_j);
    return mean;
  }
};
}  // namespace

TEST_CASE("the kit of mean radii finds a broken promise") {
  using enum bad_mean::mistake;
  const auto first_of = [](auto made) {
    const testing::report found = testing::mean_radius_report(bad_mean{made});
    return found.empty() ? std::string() : found.front();
  };
  CHECK(first_of(none).empty());
  CHECK(first_of(first).starts_with("the mean radius must not change when i and j are exchanged"));
  CHECK(first_of(squared).starts_with("the mean radius must scale as a length"));
  CHECK(first_of(smaller).starts_with("the mean radius must lie between the two radii"));
  const testing::report found = testing::mean_radius_report(bad_mean{of_the_gap});
  CHECK(std::any_of(found.begin(), found.end(),
                    [](const auto& line) { return line.starts_with("the mean radius must not depend on the gap"); }));
}
