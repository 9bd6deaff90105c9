// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/lanes.hpp>
#include <pendular/law/capillary/richefeu.hpp>
#include <pendular/law/rupture/lian.hpp>
#include <pendular/liquid/protocol/all.hpp>
#include <pendular/liquid/redistribution.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

// Grains and pairs written down by hand. Grains have a radius of about 1 m and bridges of about 1e-3 m3, so that volumes
// can be read; the liquid does not know what size a grain has.
namespace hand_made {

using namespace pendular;

struct listed_pair {
  std::int32_t i, j;
};

struct incidence {
  std::int32_t pair;
};

/// A rupture distance of its volume's number, so that thresholds can be worked out in the head: 1 m for 1 m3.
struct volume_is_distance {
  template <Scalar T>
  T distance(const bridge<T>& b, const fluid&) const {
    return b.volume;
  }
};

struct packing {
  std::vector<vector> position;
  std::vector<double> radius;
  std::vector<listed_pair> pairs;
  vector up{0, 0, 1};

  std::vector<std::int64_t> id;
  std::vector<std::int32_t> first, second;
  std::vector<std::vector<incidence>> of_grain;
  std::vector<wall_row> floor;  // the grains at the one wall that carries bridges, by id

  /// Fills what the list of a scene holds: padding, and pairs of every grain by partner id.
  packing& listed() {
    id.resize(radius.size());
    for (std::size_t k = 0; k < id.size(); ++k) id[k] = static_cast<std::int64_t>(k);
    if (position.empty()) position.resize(radius.size(), vector{0, 0, 0});
    first.clear();
    second.clear();
    of_grain.assign(radius.size(), {});
    for (const auto& [i, j] : pairs) {
      of_grain[static_cast<std::size_t>(i)].push_back({static_cast<std::int32_t>(first.size())});
      of_grain[static_cast<std::size_t>(j)].push_back({static_cast<std::int32_t>(first.size())});
      first.push_back(i);
      second.push_back(j);
    }
    for (std::size_t grain = 0; grain < radius.size(); ++grain) {
      const auto partner = [&](const incidence& n) {
        const auto p = static_cast<std::size_t>(n.pair);
        return first[p] == static_cast<std::int32_t>(grain) ? second[p] : first[p];
      };
      std::sort(of_grain[grain].begin(), of_grain[grain].end(),
                [&](const incidence& a, const incidence& b) { return partner(a) < partner(b); });
    }
    first.resize(padded(pairs.size()), first.empty() ? 0 : first.back());
    second.resize(padded(pairs.size()), second.empty() ? 0 : second.back());
    return *this;
  }

  pair_view view() const {
    pair_view v{first, second, pairs.size(), position, radius, id, up, radius.size()};
    if (floor.empty()) return v;
    v.wet_walls = true;
    v.at_walls = floor;
    v.at_walls.resize(padded(floor.size()), {floor.back().grain, -1, floor.back().gap, floor.back().normal});
    v.wall_begins = {0};
    return v;
  }

  /// One step that ends with these gaps; all pairs were apart before it if nothing else is said.
  template <class Liquid>
  bond_events settle(bonds<Liquid>& b, const std::vector<double>& gap) const {
    return settle(b, gap, std::vector<double>(gap.size(), 1e3));
  }
  template <class Liquid>
  bond_events settle(bonds<Liquid>& b, const std::vector<double>& gap, const std::vector<double>& before) const {
    const bond_events until_now = b.events();
    settle_bonds(
        b, view(), gap_history{gap, before}, [this](std::size_t grain) -> const auto& { return of_grain[grain]; });
    return {b.events().ruptures - until_now.ruptures, b.events().formations - until_now.formations};
  }
};

/// Bonds of the given volumes (0 for a pair without) and films, in a fresh ledger.
template <class Liquid>
bonds<Liquid> bonds_of(const Liquid& policies, const packing& grains, const std::vector<double>& volumes,
                       const std::vector<double>& films) {
  bonds<Liquid> b(policies);
  b.resize_films(grains.radius.size());
  for (std::size_t k = 0; k < films.size(); ++k) {
    b.introduce(films[k]);
    b.fill_film(ledger::reservoir(), k, films[k], grains.view());
  }
  b.carry({}, grains.view());
  for (std::size_t p = 0; p < volumes.size(); ++p) {
    b.introduce(volumes[p]);
    b.move(ledger::reservoir(), ledger::bond_of(p), volumes[p], p, 0.0, grains.view());
  }
  b.restore_work({});
  return b;
}

/// Answers what happened to the bridges.
template <class Liquid>
bond_events distribute(bonds<Liquid>& b, const pair_view& view, const bond_selection& selection) {
  const bond_events until_now = b.events();
  b.select(selection);
  distribute_homogeneously(b, view);
  return {b.events().ruptures - until_now.ruptures, b.events().formations - until_now.formations};
}

template <class... Policies>
auto wet(Policies... policies) {
  return liquid{fluid::water(), capillary::richefeu{}, policies...};
}

}  // namespace hand_made
