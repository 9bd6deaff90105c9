// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/expects.hpp>
#include <pendular/core/vec.hpp>

#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace pendular::source {

/// A grain that may be wetted.
struct wettable_grain {
  std::int64_t id;
  vector position;  // m
  double radius;    // m
  double film;      // m3
};

/// Every grain.
struct all_grains {
  bool operator()(const wettable_grain&) const { return true; }
};

/// The same volume onto the film of every chosen grain, once per period. The films join bridges as the protocol has it.
template <std::predicate<const wettable_grain&> Choice = all_grains>
struct wetting {
  static constexpr std::string_view account = "spray";
  double volume;               // per grain and period, m3
  std::int64_t period = 1000;  // steps
  Choice chosen = {};

  template <class Door>
  void act(Door& door) const {
    door.for_each_grain([&](std::size_t grain) {
      if (chosen({door.id(grain), door.position(grain), door.radius(grain), door.film(grain)})) {
        door.wet_grain(grain, volume);
      }
    });
  }
};

template <class Choice>
wetting(double, std::int64_t, Choice) -> wetting<Choice>;
wetting(double, std::int64_t)->wetting<>;
wetting(double)->wetting<>;

template <class Choice>
void validate(const wetting<Choice>& w) {
  constexpr auto page = "docs/reference/liquid.md";
  expects(w.volume >= 0 && std::isfinite(w.volume), "the volume of wetting per grain (m3)", w.volume,
          "at least 0 and finite", page);
  expects(w.period > 0, "the period of wetting (steps)", static_cast<double>(w.period), "at least 1", page);
}

}  // namespace pendular::source
