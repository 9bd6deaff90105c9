// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/parallel.hpp>
#include <pendular/core/quad.hpp>
#include <pendular/space/grains.hpp>

#include <cstddef>
#include <vector>

namespace pendular {

/// What the pairs read of their grains, copied once per step into rows of four numbers.
template <bool Rotates>
class grain_rows {
 public:
  template <class Grains>
  void fill(const Grains& g) {
    resize(g.size());
    for_chunks(g.size(), 512, [&](std::size_t begin, std::size_t end, std::size_t) { fill(g, begin, end); });
  }

  void resize(std::size_t grains) {
    places_.resize(grains);
    motions_.resize(grains);
    if constexpr (Rotates) turns_.resize(grains);
  }

  template <class Grains>
  void fill(const Grains& g, std::size_t begin, std::size_t end) {
    const auto position = g.template get<column::position>(), velocity = g.template get<column::velocity>();
    const auto radius = g.template get<column::radius>(), inverse_mass = g.template get<column::inverse_mass>();
    for (std::size_t k = begin; k < end; ++k) {
      places_[k] = {position[k].x, position[k].y, position[k].z, radius[k]};
      motions_[k] = {velocity[k].x, velocity[k].y, velocity[k].z, inverse_mass[k]};
      if constexpr (Rotates) {
        const vector& spin = g.template get<column::angular_velocity>()[k];
        turns_[k] = {spin.x, spin.y, spin.z, 0};
        if constexpr (Grains::count_contacts) turns_[k].d = g.template get<column::contacts>()[k];
      }
    }
  }

  const quad* places() const { return places_.data(); }    // position, radius
  const quad* motions() const { return motions_.data(); }  // velocity, inverse mass
  const quad* turns() const { return turns_.data(); }      // angular velocity, number of contacts

 private:
  std::vector<quad> places_, motions_, turns_;
};

}  // namespace pendular
