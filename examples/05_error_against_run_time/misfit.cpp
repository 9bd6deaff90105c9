// SPDX-License-Identifier: BSD-3-Clause
#include "misfit.hpp"

#include "contenders.hpp"
#include "median.hpp"

#include <pendular/laplace_young/solve.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace misfit {
namespace {

using namespace pendular;

constexpr int gaps = 60;          // of a bridge, evenly from contact to rupture
constexpr double end = 1 - 1e-6;  // of the rupture distance: as near as the solver states its accuracy
constexpr double degree = std::numbers::pi / 180;

/// The exact forces of one bridge, in SI.
struct reference {
  bridge<double> b;
  fluid f;
  double distance, work;
  std::vector<double> gap, force;
};

reference reference_of(double angle, double ratio, double volume) {
  const double radius = 0.5e-3, mean = radius * std::sqrt(ratio);
  reference r{
      {0, volume * mean * mean * mean, radius, ratio * radius}, {0.0728, angle * degree, 1000, 1e-3}, 0, 0, {}, {}};
  laplace_young::bridges_of_volume exact(
      {r.b.radius_i, r.b.radius_j, r.f.contact_angle, r.b.volume, r.f.surface_tension});
  r.distance = exact.rupture_distance();
  r.work = exact.last().energy - exact.at(0)->energy;
  for (int k = 0; k <= gaps; ++k) {
    r.gap.push_back(end * r.distance * k / gaps);
    r.force.push_back(exact.at(r.gap.back())->attraction);
  }
  return r;
}

/// Simpson's rule from contact to the exact rupture distance, in the root of the gap, where the force is steepest.
template <class Law>
double work_of(const Law& law, const reference& r) {
  constexpr int parts = 400;
  const auto c = prepare(law, r.b, r.f);
  double sum = 0;
  for (int k = 0; k <= parts; ++k) {
    const double x = static_cast<double>(k) / parts, weight = k == 0 || k == parts ? 1 : k % 2 ? 4 : 2;
    sum += weight * 2 * x * attraction(law, double(x * x * r.distance), c, r.f);
  }
  return sum * r.distance / (3 * parts);
}

template <class Law>
of_bridge judge_one(const std::string& name, const Law& law, const reference& r) {
  const double unit = capillary_tension(r.f) * capillary::harmonic_radius(r.b);
  of_bridge m{name, r.f.contact_angle / degree, r.b.radius_j / r.b.radius_i, 0, 0, 0, 0, 0, 0, false};
  m.volume = r.b.volume / std::pow(r.b.radius_i * r.b.radius_j, 1.5);
  m.valid = validity_of<Law>().covers(r.b, r.f);
  double squares = 0;
  for (std::size_t k = 0; k < r.gap.size(); ++k) {
    bridge<double> b = r.b;
    b.gap = r.gap[k];
    const double off = std::abs(contenders::pull(law, b, r.f) - r.force[k]) / unit;
    if (k == 0) m.contact = off;
    if (r.gap[k] <= 0.8 * r.distance) m.inner = std::max(m.inner, off);
    m.whole = std::max(m.whole, off);
    squares += off * off;
  }
  m.root_mean = std::sqrt(squares / static_cast<double>(r.gap.size()));
  m.work = work_of(law, r) / r.work - 1;
  return m;
}

template <class Row>
bool usual(const Row& r) {
  return r.size_ratio < 2.01 && r.contact_angle < 40.1 && r.volume > 0.99e-4 && r.volume < 0.0301;
}

template <class Row>
std::vector<std::string> names_in(const std::vector<Row>& rows) {
  std::vector<std::string> names;
  for (const Row& r : rows) {
    if (std::find(names.begin(), names.end(), r.law) == names.end()) names.push_back(r.law);
  }
  return names;
}

/// The values of one law that pass a filter.
template <class Row, class Pick, class Filter>
std::vector<double> pick(const std::vector<Row>& rows, const std::string& law, const Pick& value, const Filter& take) {
  std::vector<double> values;
  for (const Row& r : rows) {
    if (r.law == law && take(r)) values.push_back(std::abs(value(r)));
  }
  return values;
}

double largest(const std::vector<double>& values) {
  return values.empty() ? std::numeric_limits<double>::quiet_NaN() : *std::max_element(values.begin(), values.end());
}

}  // namespace

all judge() {
  all found;
  for (const double angle : {0.0, 20.0, 40.0, 60.0}) {
    for (const double ratio : {1.0, 1.2, 2.0, 4.0, 10.0}) {
      for (const double volume : {1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 3e-2, 1e-1}) {
        const reference r = reference_of(angle, ratio, volume);
        contenders::for_each(contenders::capillary_laws, r.f, [&](const std::string& name, const auto& law) {
          found.bridges.push_back(judge_one(name, law, r));
        });
        contenders::for_each(contenders::rupture_laws, r.f, [&]<class Law>(const std::string& name, const Law& law) {
          found.ruptures.push_back({name, angle, ratio, volume, law.distance(r.b, r.f) / r.distance - 1,
                                    validity_of<Law>().covers(r.b, r.f)});
        });
      }
    }
  }
  return found;
}

std::vector<summary> summarise(const std::vector<of_bridge>& rows) {
  std::vector<summary> table;
  const auto every = [](const of_bridge&) { return true; };
  for (const std::string& law : names_in(rows)) {
    const auto values = [&](double of_bridge::*member, const auto& take) {
      return pick(
          rows, law, [member](const of_bridge& r) { return r.*member; }, take);
    };
    table.push_back({law, largest(values(&of_bridge::contact, every)), largest(values(&of_bridge::inner, every)),
                     largest(values(&of_bridge::whole, every)), median(values(&of_bridge::whole, every)),
                     median(values(&of_bridge::root_mean, every)), median(values(&of_bridge::work, every)),
                     largest(values(&of_bridge::whole, usual<of_bridge>)),
                     largest(values(&of_bridge::whole, [](const of_bridge& r) { return r.valid; }))});
  }
  return table;
}

std::vector<rupture_summary> summarise(const std::vector<of_rupture>& rows) {
  std::vector<rupture_summary> table;
  for (const std::string& law : names_in(rows)) {
    const auto values = [&](const auto& take) {
      return pick(
          rows, law, [](const of_rupture& r) { return r.distance; }, take);
    };
    const auto every = values([](const of_rupture&) { return true; });
    table.push_back({law, largest(every), median(every), largest(values(usual<of_rupture>))});
  }
  return table;
}

}  // namespace misfit
