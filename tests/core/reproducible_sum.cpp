// SPDX-License-Identifier: BSD-3-Clause
// Sums that do not depend on the order, against binary numbers of 2600 digits (Boost.Multiprecision).
#include "../catch.hpp"

#include <pendular/core/certain_sum.hpp>
#include <pendular/core/reproducible_sum.hpp>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_int_distribution.hpp>
#include <boost/random/uniform_real_distribution.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

using pendular::reproducible_sum;

namespace {
using wide =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<2600, boost::multiprecision::digit_base_2>>;
using numbers = std::numeric_limits<double>;

double exact(const std::vector<double>& values) {
  wide sum = 0;
  for (const double v : values) sum += v;
  return sum.convert_to<double>();
}
double ours(const std::vector<double>& values) {
  reproducible_sum sum;
  for (const double v : values) sum.add(v);
  return sum.value();
}

/// Any sign, any power of two between the two.
std::vector<double> random_numbers(int count, int lowest, int highest, unsigned seed) {
  boost::random::mt19937 random(seed);
  boost::random::uniform_real_distribution<double> mantissa(-1, 1);
  boost::random::uniform_int_distribution<int> power(lowest, highest);
  std::vector<double> values;
  for (int k = 0; k < count; ++k) values.push_back(std::ldexp(mantissa(random), power(random)));
  return values;
}
}  // namespace

TEST_CASE("a sum is the exact one, rounded once") {
  for (unsigned seed = 1; seed <= 40; ++seed) {
    for (const auto& [lowest, highest] : {std::pair{-1080, 1000}, {-60, 60}, {-3, 3}, {-1074, -1000}, {990, 1010}}) {
      const std::vector<double> values = random_numbers(300, lowest, highest, seed);
      CHECK(ours(values) == exact(values));
    }
  }
}

TEST_CASE("a sum of one number is that number, whatever it is") {
  for (const double v : {0.0, 1.0, -1.0, 0.1, -1e-300, numbers::denorm_min(), -numbers::denorm_min(), numbers::min(),
                         numbers::max(), -numbers::max(), 0x1.fffffffffffffp-1022, 3e-310}) {
    CHECK(ours({v}) == v);
  }
  CHECK(ours({}) == 0);
  CHECK(ours({1e308, 1e308, -1e308, -1e308}) == 0);
  CHECK(ours({0x1p53, 1, 0x1p-60}) == 0x1p53 + 2);  // more than half a unit: up
  CHECK(ours({0x1p53, 1}) == 0x1p53);               // a tie: to even
  CHECK(ours({0x1p53, 3}) == 0x1p53 + 4);
  CHECK(ours({0x1p13, 0x1p-40, 0x1p-60}) == 0x1p13 + 0x1p-39);  // more than half by bits of the next digit alone
  CHECK(ours({-0x1p53, -1, -0x1p-1074}) == -(0x1p53 + 2));
}

TEST_CASE("neither the order nor the parts that a sum is made of change a bit") {
  std::vector<double> values = random_numbers(3000, -200, 200, 7);
  const double forth = ours(values);
  std::reverse(values.begin(), values.end());
  CHECK(ours(values) == forth);
  std::sort(values.begin(), values.end());
  CHECK(ours(values) == forth);
  reproducible_sum parts[7], joined;
  for (std::size_t k = 0; k < values.size(); ++k) parts[k * k % 7].add(values[k]);
  for (const auto& part : parts) joined.join(part);
  CHECK(joined.value() == forth);
  joined.add(-forth);
  CHECK(joined.value() == exact([&] {
          auto all = values;
          all.push_back(-forth);
          return all;
        }()));
}

TEST_CASE("a number that is not finite is not hidden") {
  CHECK(std::isnan(ours({1, HUGE_VAL})));
  CHECK(std::isnan(ours({std::nan(""), 1})));
  reproducible_sum good, bad;
  good.add(1);
  bad.add(-HUGE_VAL);
  good.join(bad);
  CHECK(std::isnan(good.value()));
}

TEST_CASE("carries are taken before they can be lost") {
  reproducible_sum doubling;
  doubling.add(0x1.fffffffffffffp31);
  for (int k = 0; k < 50; ++k) {
    const reproducible_sum same = doubling;
    doubling.join(same);
  }
  CHECK(doubling.value() == 0x1.fffffffffffffp81);
}

TEST_CASE("a certain sum is the exact one or says nothing, and seldom says nothing") {
  int asked = 0, silent = 0;
  for (unsigned seed = 1; seed <= 300; ++seed) {
    for (const auto& [lowest, highest] : {std::pair{-60, 60}, {-3, 3}, {-30, 0}, {-1074, -1000}}) {
      const int count = seed % 3 == 0 ? 3 : 400;
      std::vector<double> values = random_numbers(count, lowest, highest, seed);
      if (seed % 2 == 0) {  // all but a little of the sum cancels
        const std::vector<double> other = random_numbers(3, lowest - 40, lowest - 30, seed + 1000);
        for (int k = count - 1; k >= 0; --k) values.push_back(-values[static_cast<std::size_t>(k)]);
        values.insert(values.end(), other.begin(), other.end());
      }
      pendular::certain_sum sum;
      for (const double v : values) sum.add(pendular::detail::four(v));
      for (int k = 0; k < 4; ++k) {
        const double value = sum.value(k);
        if (!std::isnan(value)) CHECK(value == exact(values));
        const bool ordinary = seed % 2 != 0 && lowest > -1000;
        asked += ordinary, silent += ordinary && std::isnan(value);
      }
    }
  }
  CHECK(silent < asked / 100);
}

TEST_CASE("a certain sum says nothing where it could be one of two numbers") {
  pendular::certain_sum half;
  for (const double v : {1.0, 0x1p-53}) half.add(pendular::detail::four(v));
  CHECK(std::isnan(half.value(0)));
  for (const double v : {0x1p-120, 0x1p-140}) half.add(pendular::detail::four(v));
  CHECK(std::isnan(half.value(2)));
  pendular::certain_sum below;  // where the next number below is nearer than that above
  for (const double v : {1.0, -0x1p-54}) below.add(pendular::detail::four(v));
  CHECK(std::isnan(below.value(1)));
  pendular::certain_sum more;
  for (const double v : {1.0, 0x1.01p-53}) more.add(pendular::detail::four(v));
  CHECK(more.value(3) == 1 + 0x1p-52);
  pendular::certain_sum nothing, infinite;
  CHECK(nothing.value(0) == 0.0);
  infinite.add(pendular::detail::four(HUGE_VAL));
  infinite.add(pendular::detail::four(-HUGE_VAL));
  CHECK(std::isnan(infinite.value(0)));
}
