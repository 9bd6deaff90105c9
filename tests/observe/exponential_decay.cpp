// SPDX-License-Identifier: BSD-3-Clause
// Slopes of force distributions, against samples of exponentials whose slopes are known.
#include "../catch.hpp"

#include <pendular/observe/exponential_decay.hpp>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_real_distribution.hpp>

#include <cmath>
#include <limits>
#include <vector>

using namespace pendular;
using observe::exponential_decay_of;

namespace {
/// Of a density exp(-rate x) on all of [low, high], by its inverse distribution function at u in (0, 1).
double quantile(double rate, double low, double high, double u) {
  if (rate == 0) return low + u * (high - low);
  return low - std::log1p(-u * (1 - std::exp(-rate * (high - low)))) / rate;
}

/// At even quantiles: a sample without scatter.
std::vector<double> even_sample(double rate, double low, double high, int count, double unit = 1) {
  std::vector<double> x;
  for (int k = 0; k < count; ++k) x.push_back(unit * quantile(rate, low, high, (k + 0.5) / count));
  return x;
}
}  // namespace

TEST_CASE("the decay of a truncated exponential is its rate, whatever its sign and unit") {
  for (const double rate : {-7.0, -1.0, -1e-3, 0.0, 1e-3, 0.5, 4.0, 40.0}) {
    const auto found = exponential_decay_of(even_sample(rate, 0.25, 2, 20000, 4e-4), 4e-4, {0.25, 2});
    CAPTURE(rate);
    CHECK(found.rate == near(2e-3 * std::abs(rate) + 1e-6, rate));
    CHECK(found.count == 20000);
  }
}

TEST_CASE("what lies outside of the window does not count") {
  auto forces = even_sample(4, 0, 3, 30000);
  for (int k = 0; k < 5000; ++k) forces.push_back(0.1), forces.push_back(2.9);  // a peak and a tail
  const auto found = exponential_decay_of(forces, 1, {0.25, 2});
  CHECK(found.rate == within(1e-2, 4));
  CHECK(found.count < 30000);
}

TEST_CASE("the standard error is the scatter of the rates of many samples") {
  boost::random::mt19937_64 random(7);
  boost::random::uniform_real_distribution<double> unit(0, 1);
  constexpr int samples = 400, count = 200;
  double sum = 0, squares = 0, error = 0;
  for (int k = 0; k < samples; ++k) {
    std::vector<double> x;
    for (int i = 0; i < count; ++i) x.push_back(quantile(4, 0.25, 1, unit(random)));
    const auto found = exponential_decay_of(x, 1, {0.25, 1});
    sum += found.rate, squares += found.rate * found.rate, error += found.error / samples;
  }
  const double mean = sum / samples, scatter = std::sqrt(squares / samples - mean * mean);
  CHECK(mean == near(4 * scatter / std::sqrt(samples), 4));
  CHECK(scatter == within(0.15, error));  // four standard deviations of a scatter of 400 samples
}

TEST_CASE("no decay without values in the window") {
  CHECK(std::isnan(exponential_decay_of({}, 1, {0, 1}).rate));
  CHECK(std::isnan(exponential_decay_of(std::vector<double>{0.5, 3}, 1, {0, 1}).error));
  CHECK(exponential_decay_of(std::vector<double>{0.5, 3}, 1, {0, 1}).count == 1);
}

TEST_CASE("windows and units without meaning are refused") {
  const std::vector<double> x{1, 2};
  const double nan = std::nan(""), infinite = std::numeric_limits<double>::infinity();
  CHECK_THROWS_AS(exponential_decay_of(x, 0, {0, 1}), input_error);
  CHECK_THROWS_AS(exponential_decay_of(x, nan, {0, 1}), input_error);
  CHECK_THROWS_AS(exponential_decay_of(x, 1, {1, 1}), input_error);
  CHECK_THROWS_AS(exponential_decay_of(x, 1, {2, 1}), input_error);
  CHECK_THROWS_AS(exponential_decay_of(x, 1, {nan, 1}), input_error);
  CHECK_THROWS_AS(exponential_decay_of(x, 1, {0, infinite}), input_error);
}

TEST_CASE("values all at one end say that the decay is steep, and no more") {
  const std::vector<double> low(50, 0.0), high(50, 1.0);
  const auto falling = observe::exponential_decay_of(low, 1, {0, 1}),
             growing = observe::exponential_decay_of(high, 1, {0, 1});
  CHECK((std::isinf(falling.rate) && falling.rate > 0 && std::isnan(falling.error) && falling.count == 50));
  CHECK((std::isinf(growing.rate) && growing.rate < 0 && std::isnan(growing.error)));
  CHECK_THROWS_AS(observe::exponential_decay_of(low, 1, {-1.7e308, 1.7e308}), input_error);
}
