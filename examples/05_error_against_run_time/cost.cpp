// SPDX-License-Identifier: BSD-3-Clause
#include "cost.hpp"

#include "contenders.hpp"
#include "median.hpp"

#include <pendular/core/lanes.hpp>

#include <chrono>
#include <functional>
#include <vector>

namespace cost {
namespace {

using namespace pendular;

constexpr int bridges = 4096;  // fit into the first cache
constexpr int rounds = 41;

template <class T>
struct width {
  static constexpr int value = 1;
};
template <int W, class E>
struct width<lanes<W, E>> {
  static constexpr int value = W;
};

template <class T>
T spread(double first, double step) {
  if constexpr (width<T>::value == 1) {
    return static_cast<T>(first);
  } else {
    return T::from([&](int k) { return first + k * step; });
  }
}

template <class T>
double total(const T& x) {
  if constexpr (width<T>::value == 1) {
    return static_cast<double>(x);
  } else {
    return static_cast<double>(sum(x));
  }
}

double seconds(const std::function<double()>& work) {
  static volatile double sink = 0;
  const auto began = std::chrono::steady_clock::now();
  sink = sink + work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
}

/// Evaluations of prepared bridges in T: gaps over the whole range, a few different bridges.
template <class T, class Law>
std::function<double()> evaluations(const Law& law, const fluid& f) {
  constexpr int count = bridges / width<T>::value, kinds = 8;
  std::vector<T> gap;
  for (int k = 0; k < count; ++k) gap.push_back(spread<T>(1e-4 * k / count, 1e-4 / bridges));
  std::vector<decltype(law.prepare(bridge<T>{}, f))> prepared;
  for (int k = 0; k < kinds; ++k) {
    const T volume = spread<T>(1e-12 * (1 + 0.1 * k), 1e-14), radius = spread<T>(5e-4, 1e-6);
    prepared.push_back(law.prepare(bridge<T>{spread<T>(0, 0), volume, radius, spread<T>(6e-4, 1e-6)}, f));
  }
  return [law, gap, prepared] {
    T sum = T(gap[0] * element_t<T>(0));
    for (std::size_t k = 0; k < gap.size(); ++k) sum = T(sum + law.attraction(gap[k], prepared[k % kinds]));
    return total(sum);
  };
}

template <class Law>
std::function<double()> preparations(const Law& law, const fluid& f) {
  return [law, f] {
    double sum = 0;
    for (int k = 0; k < bridges / 16; ++k) {
      const auto c = law.prepare(bridge<double>{0, 1e-12 * (1 + 1e-3 * k), 5e-4, 6e-4}, f);
      sum += law.attraction(1e-6, c);
    }
    return sum;
  };
}

struct job {
  std::function<double()> work;
  double count;
  std::vector<double> times;
};

}  // namespace

std::vector<of_law> measure() {
  const fluid f{0.0728, 0.3, 1000, 1e-3};
  std::vector<std::string> names;
  std::vector<job> jobs;
  contenders::for_each(contenders::capillary_laws, f, [&](const std::string& name, const auto& law) {
    names.push_back(name);
    jobs.push_back({evaluations<double>(law, f), bridges, {}});
    jobs.push_back({evaluations<float>(law, f), bridges, {}});
    jobs.push_back({evaluations<lanes<8>>(law, f), bridges, {}});
    jobs.push_back({evaluations<lanes<16, float>>(law, f), bridges, {}});
    jobs.push_back({preparations(law, f), bridges / 16, {}});
  });
  for (int round = 0; round < rounds; ++round) {
    for (job& j : jobs) j.times.push_back(1e9 * seconds(j.work) / j.count);
  }
  std::vector<of_law> table;
  for (std::size_t k = 0; k < names.size(); ++k) {
    const auto time = [&](std::size_t what) { return median(jobs[5 * k + what].times); };
    table.push_back({names[k], time(0), time(1), time(2), time(3), time(4)});
  }
  return table;
}

}  // namespace cost
