// SPDX-License-Identifier: BSD-3-Clause
// Lanes as a value type, and their functions against the mathematics library in long double.
#include "../catch.hpp"

#include <pendular/core/lanes.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <type_traits>

using pendular::block;
using pendular::lanes;

namespace {
constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
constexpr double least = std::numeric_limits<double>::min(), denormal = 0x1p-1060;

block counting(double first, double step = 1) {
  return block::from([&](int k) { return first + k * step; });
}

/// Largest error in units in the last place over samples that `at(u)` takes from u in [0, 1).
template <class Function, class Exact, class At>
double worst_of(const Function& f, const Exact& exact, const At& at) {
  std::mt19937_64 random(7);
  double worst = 0;
  for (int n = 0; n < 20000; ++n) {
    const block x = block::from([&](int) { return at(std::ldexp(static_cast<double>(random() >> 11), -53)); });
    const block y = f(x);
    for (int k = 0; k < 8; ++k) {
      const long double expected = exact(static_cast<long double>(x[k]));
      const double unit =
          std::abs(std::nextafter(static_cast<double>(expected), infinite) - static_cast<double>(expected));
      const double error = static_cast<double>(std::abs(static_cast<long double>(y[k]) - expected)) / unit;
      if (!(error <= worst)) worst = error;
    }
  }
  return worst;
}

auto between(double a, double b) {
  return [=](double u) { return a + (b - a) * u; };
}
/// Evenly over the orders of magnitude.
auto orders(double a, double b) {
  return [=](double u) { return std::exp(std::log(a) + (std::log(b) - std::log(a)) * u); };
}

/// Lane k of f of the eight values is what is expected there, not-a-number included.
template <class Function>
void check_values(const Function& f, const std::array<double, 8>& x, const std::array<double, 8>& expected,
                  double granted = 1e-15) {
  const block y = f(block::load(x.data()));
  for (int k = 0; k < 8; ++k) {
    const double e = expected[static_cast<std::size_t>(k)];
    CAPTURE(k, std::to_string(x[static_cast<std::size_t>(k)]), std::log2(y[k]), std::log2(e));
    CHECK((std::isnan(e) ? std::isnan(y[k]) : y[k] == e || std::abs(y[k] / e - 1) < granted));
  }
}
}  // namespace

static_assert(std::is_trivially_copyable_v<block> && sizeof(block) == 64);
static_assert(std::is_same_v<decltype(block() * block() + block()), block>, "auto in a law must be a value");
static_assert(std::is_same_v<decltype(pendular::max(block(), block())), block>);
static_assert(std::is_same_v<decltype(pendular::sqrt(2 * block())), block>);

TEST_CASE("lanes are added, multiplied and compared one by one") {
  const block a = counting(1), b = counting(8, -1);
  CHECK(((a + b)[0] == 9 && (a + b)[7] == 9 && (a - b)[0] == -7 && (a * b)[2] == 18 && (a / b)[7] == 8));
  CHECK(((-a)[3] == -4 && (a + 1)[3] == 5 && (2 * a)[3] == 8 && (1.0 / a)[3] == 0.25 && (a - 0.5)[0] == 0.5));
  CHECK(((a < b)[3] && !(a < b)[4] && (a > b)[4] && (a <= 4)[3] && (a >= 4)[3] && !(a < 4)[3] && (4 < a)[4]));
  CHECK((any(a == 8) && !any(a == 9) && all(a != 9) && all(a > 0) && !all(a > 1)));
  CHECK((any(a > 7 && b < 2) && !any(a > 7 && b > 2) && all(a > 4 || b > 4) && !any(!(a > 0))));
  CHECK(sum(a) == 36);
}

TEST_CASE("one lane that is true is found wherever it is, in doubles and in floats") {
  for (int k = 0; k < 8; ++k) {
    block x(0.0);
    x.set(k, 1);
    CHECK((any(x > 0) && !all(x > 0) && x[k] == 1 && sum(x) == 1));
  }
  for (int k = 0; k < 16; ++k) {
    lanes<16, float> x(0);
    x.set(k, 1);
    CHECK((any(x > 0) && !all(x > 0) && any(!(x > 0)) && x[k] == 1));
  }
}

TEST_CASE("a choice takes what the comparison says, and nothing of the other") {
  const block a = counting(-3), chosen = pendular::select(a > 0, pendular::sqrt(a), block(-1));
  CHECK((chosen[0] == -1 && chosen[3] == -1 && chosen[4] == 1 && chosen[7] == 2));
  CHECK(pendular::select(1.0 > 2.0, 5.0, 6.0) == 6.0);
  CHECK(pendular::select(1.0, 5.0, 6.0) == 5.0);  // a number is asked whether it is positive
  CHECK(pendular::select(-1.0, 5.0, 6.0) == 6.0);
  CHECK(pendular::select(-1, 5.0, 6.0) == 6.0);
  CHECK(pendular::select(-1.0f, block(5.0), block(6.0))[0] == 6.0);
  CHECK(std::signbit(pendular::sin(block(-0.0))[0]));
  static_assert(!std::is_constructible_v<block::mask, bool>);  // in which only one lane would be true
}

TEST_CASE("maximum and minimum keep the first where one is no number or both are the same") {
  const std::array<double, 8> a{1, nothing, 1, -0.0, 0.0, infinite, -infinite, 3}, b{2, 1, nothing, 0.0, -0.0, 1, 1, 3};
  const block x = block::load(a.data()), y = block::load(b.data());
  for (int k = 0; k < 8; ++k) {
    const auto at = static_cast<std::size_t>(k);
    const double larger = a[at] < b[at] ? b[at] : a[at], smaller = b[at] < a[at] ? b[at] : a[at];
    CHECK(std::bit_cast<std::uint64_t>(pendular::max(x, y)[k]) == std::bit_cast<std::uint64_t>(larger));
    CHECK(std::bit_cast<std::uint64_t>(pendular::min(x, y)[k]) == std::bit_cast<std::uint64_t>(smaller));
  }
}

TEST_CASE("functions of lanes are right to one unit in the last place, of an angle to two and a half") {
  const auto exp = [](auto x) { return pendular::exp(x); };
  const auto exact_exp = [](long double x) { return std::exp(x); };
  CHECK(worst_of(exp, exact_exp, between(-708.3, 709.7)) <= 1);
  CHECK(worst_of(exp, exact_exp, between(-1, 1)) < 1);
  const auto log = [](auto x) { return pendular::log(x); };
  const auto exact_log = [](long double x) { return std::log(x); };
  CHECK(worst_of(log, exact_log, orders(5e-308, 1.7e308)) < 1);
  CHECK(worst_of(log, exact_log, between(0.5, 2)) < 1);
  const auto cbrt = [](auto x) { return pendular::cbrt(x); };
  CHECK(worst_of(
            cbrt, [](long double x) { return std::cbrt(x); }, orders(1e-300, 1e300)) < 1);
  const auto sin = [](auto x) { return pendular::sin(x); };
  const auto cos = [](auto x) { return pendular::cos(x); };
  const auto exact_sin = [](long double x) { return std::sin(x); };
  const auto exact_cos = [](long double x) { return std::cos(x); };
  for (const double far : {1.0, 10.0, 2e6}) {
    CHECK(worst_of(sin, exact_sin, between(-far, far)) < 2.5);
    CHECK(worst_of(cos, exact_cos, between(-far, far)) < 2.5);
  }
  const auto root = [](auto x) { return pendular::sqrt(x); };
  CHECK(worst_of(
            root, [](long double x) { return std::sqrt(x); }, orders(1e-300, 1e300)) <= 0.5);
}

TEST_CASE("a power loses a unit in the last place per unit of its logarithm, and none as product, quotient or root") {
  for (const double p : {-0.53, 0.34, 2.7, 4.0, -3.0, 2.0, 3.0, -1.0, -2.0, 0.5, 1.5}) {
    const auto power = [=](auto x) { return pendular::pow(x, p); };
    const auto exact = [=](long double x) { return std::pow(x, static_cast<long double>(p)); };
    const bool short_form = p == 2 || p == 3 || p == -1 || p == -2 || p == 0.5 || p == 1.5;
    CHECK(worst_of(power, exact, orders(1e-13, 10)) < (short_form ? 2 : 2 + std::abs(p) * 30));
  }
}

TEST_CASE("powers have the limits and signs of the C library") {
  const double most = std::numeric_limits<double>::max();
  const std::array<double, 8> some{-2.0, -0.0, 0.0, 1.0, -1.0, infinite, -infinite, nothing};
  const std::array<double, 8> others{most, least, 1e308, -1e308, 0.5, 4.0, -0.3, 1e-308};
  for (const double p : {1.0, 2.0, 3.0, -1.0, -2.0, 0.5, 1.5, 4.0, 5.0, -3.0, 0.3, -0.5, infinite, -infinite, 0.0}) {
    for (const auto& x : {some, others}) {
      const block y = pendular::pow(block::load(x.data()), p), each = pendular::pow(block::load(x.data()), block(p));
      for (int k = 0; k < 8; ++k) {
        const double e = std::pow(x[static_cast<std::size_t>(k)], p);
        CAPTURE(p, x[static_cast<std::size_t>(k)], y[k], e);
        CHECK((std::isnan(e) ? std::isnan(y[k]) : y[k] == e || std::abs(y[k] / e - 1) < 1e-12 || e < least));
        CHECK((std::isnan(e) || std::signbit(y[k]) == std::signbit(e)));
        CHECK((std::isnan(e) ? std::isnan(each[k]) : each[k] == e));
      }
    }
  }
  CHECK(pendular::pow(2.0, block(3.0))[5] == 8);
}

TEST_CASE("what laws write besides") {
  block x = counting(1);
  x += 1.0, x *= 2, x -= 1, x /= 3.0f;
  CHECK((x[0] == 1 && x[7] == within(1e-15, 17.0 / 3)));
  CHECK((all(1 <= x) && any(1 == x) && any(1 != x) && !any(1 > x) && any(5 >= x)));
  CHECK(pendular::select(true, x, block(0.0))[0] == 1);
  CHECK(std::numeric_limits<block>::infinity()[3] == infinite);
  CHECK(all(std::numeric_limits<lanes<4, float>>::epsilon() == std::numeric_limits<float>::epsilon()));
}

TEST_CASE("functions of lanes at the ends of the numbers") {
  const std::array<double, 8> x{0.0, -0.0, infinite, -infinite, nothing, least, denormal, -1.0};
  check_values([](auto v) { return pendular::exp(v); }, x, {1, 1, infinite, 0, nothing, 1, 1, std::exp(-1.0)});
  check_values([](auto v) { return pendular::log(v); }, x,
               {-infinite, -infinite, infinite, nothing, nothing, std::log(least), std::log(denormal), nothing});
  check_values([](auto v) { return pendular::cbrt(v); }, x,
               {0, -0.0, infinite, -infinite, nothing, std::cbrt(least), std::cbrt(denormal), -1});
  check_values([](auto v) { return pendular::sin(v); }, x,
               {0, 0, nothing, nothing, nothing, least, denormal, std::sin(-1.0)});
  check_values([](auto v) { return pendular::cos(v); }, x, {1, 1, nothing, nothing, nothing, 1, 1, std::cos(1.0)});
  check_values([](auto v) { return pendular::sqrt(v); }, x,
               {0, 0, infinite, nothing, nothing, std::sqrt(least), std::sqrt(denormal), nothing});
  check_values([](auto v) { return pendular::abs(v); }, x, {0, 0, infinite, infinite, nothing, least, denormal, 1});
  check_values([](auto v) { return pendular::pow(v, 0.5); }, x,
               {0, 0, infinite, infinite, nothing, std::sqrt(least), std::sqrt(denormal), nothing}, 1e-13);
  check_values([](auto v) { return pendular::pow(v, 3); }, x, {0, 0, infinite, -infinite, nothing, 0, 0, -1});
  check_values([](auto v) { return pendular::pow(v, 0); }, x, {1, 1, 1, 1, 1, 1, 1, 1});
  check_values([](auto v) { return pendular::exp(v); }, {-708.4, -708.3, 709.7, 709.79, -1e300, 1e300, 0, 0},
               {0, std::exp(-708.3), std::exp(709.7), infinite, 0, infinite, 1, 1});
}
