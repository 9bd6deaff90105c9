// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/host.hpp>
#include <pendular/testing/report.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace pendular::testing {

namespace detail {
/// Somewhere in a box, another place for every id.
inline vector scattered(std::int64_t id, const vector& lower, const vector& upper) {
  const auto share = [&](double step) {
    const double t = step * static_cast<double>(id + 1);
    return t - std::floor(t);
  };
  // The R3 sequence (M. Roberts 2018), which fills a cube evenly.
  return {lower.x + share(0.8191725133961645) * (upper.x - lower.x),
          lower.y + share(0.6710436067037893) * (upper.y - lower.y),
          lower.z + share(0.5497004779019703) * (upper.z - lower.z)};
}

template <Host H>
void demand_questions(report& broken, const H& host, std::size_t place) {
  const double own = static_cast<double>(place) - 3;
  const double most = host.most(own);
  demand(broken, most >= own, "most must not be less than what a part says", {{"own", own}, {"most", most}});
  demand(broken, -host.most(-most) == most, "most must be the same on all parts", {{"most", most}});
  demand(broken, !host.any(false), "any must be false where it is so nowhere", {});
  demand(broken, host.any(own == most), "any must be true where it is so somewhere", {});
  demand(broken, host.any(own < most) == (most > -host.most(-own)), "any must be true where it is so somewhere", {});
}

template <Host H>
void demand_sums(report& broken, const H& host, std::size_t place) {
  std::vector<reproducible_sum> sums(3);
  sums[0].add(1);
  sums[1].add(host.leads() ? 1 : 0);
  sums[2].add(place % 2 == 0 ? 1e300 : 1e-300);
  sums[2].add(place % 2 == 0 ? -1e300 : 0);
  host.sum(sums);
  const double parts = sums[0].value();
  demand(broken, parts >= 1 && parts == std::floor(parts), "a sum of ones must be the number of parts",
         {{"sum", parts}});
  demand(broken, sums[1].value() == 1, "exactly one part must lead", {{"leaders", sums[1].value()}});
  demand(broken, sums[2].value() == std::floor(parts / 2) * 1e-300, "sums must be joined without an error",
         {{"sum", sums[2].value()}});
  demand(broken, host.most(parts) == parts && -host.most(-parts) == parts, "sums must be the same on all parts",
         {{"sum", parts}});
}

/// Grains of these ids wander through the box; who keeps them now, with copies of their neighbours?
template <DistributingHost H>
std::vector<parcel> demand_exchange(report& broken, const H& host, std::vector<parcel> parcels, double reach,
                                    std::size_t& kept, std::int64_t grains) {
  kept = host.exchange(parcels, reach);
  demand(broken, kept <= parcels.size(), "exchange must answer how many of the parcels are kept", {});
  kept = std::min(kept, parcels.size());
  std::vector<reproducible_sum> keepers(static_cast<std::size_t>(grains));
  for (std::size_t k = 0; k < kept; ++k) keepers[static_cast<std::size_t>(parcels[k].id)].add(1);
  host.sum(keepers);
  for (const reproducible_sum& k : keepers) {
    demand(broken, k.value() == 1, "every grain must be kept on exactly one part", {{"keepers", k.value()}});
  }
  for (std::size_t k = 0; k < parcels.size(); ++k) {
    const double keeps = host.keeps(parcels[k].position) ? 1 : 0;
    demand(broken, keeps == (k < kept ? 1 : 0), "exchange must keep the grains that `keeps` says, and copies of others",
           {{"place", static_cast<double>(k)}, {"keeps", keeps}});
    demand(broken, parcels[k].numbers == std::vector<double>{static_cast<double>(parcels[k].id), 0.5},
           "a parcel must arrive as it was sent", {{"id", static_cast<double>(parcels[k].id)}});
  }
  return parcels;
}

inline void demand_neighbours(report& broken, const std::vector<parcel>& here, std::size_t kept,
                              const std::vector<vector>& positions, double reach) {
  std::vector<char> known(positions.size(), 0);
  for (const parcel& p : here) {
    demand(broken, known[static_cast<std::size_t>(p.id)]++ == 0, "no grain may be twice on a part",
           {{"id", static_cast<double>(p.id)}});
  }
  for (std::size_t id = 0; id < positions.size(); ++id) {
    const bool near = std::any_of(here.begin(), here.begin() + static_cast<std::ptrdiff_t>(kept),
                                  [&](const parcel& p) { return norm(p.position - positions[id]) <= reach; });
    demand(broken, !near || known[id] != 0, "there must be a copy of every grain within reach of a kept one",
           {{"id", static_cast<double>(id)}, {"reach", reach}});
  }
}

template <DistributingHost H>
void demand_updates(report& broken, const H& host, const std::vector<parcel>& here, std::size_t kept) {
  // Rows are not stored in the order of the parcels.
  std::vector<std::int64_t> ids;
  for (const parcel& p : here) ids.push_back(p.id);
  std::reverse(ids.begin(), ids.begin() + static_cast<std::ptrdiff_t>(kept));
  std::reverse(ids.begin() + static_cast<std::ptrdiff_t>(kept), ids.end());
  host.know_rows(ids, kept);
  for (const std::size_t width : {std::size_t{1}, std::size_t{4}}) {
    std::vector<double> numbers(width * ids.size(), -1);
    for (std::size_t k = 0; k < width * kept; ++k) {
      numbers[k] = 10 * static_cast<double>(ids[k / width]) + static_cast<double>(k % width);
    }
    host.update_copies(numbers, width);
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      const double wanted = 10 * static_cast<double>(ids[k / width]) + static_cast<double>(k % width);
      demand(broken, numbers[k] == wanted, "copies must get the numbers of their keepers, and those keep theirs",
             {{"wanted", wanted}, {"number", numbers[k]}});
    }
  }
}
}  // namespace detail

/// What a host promises beyond its signatures. To be called on all of its parts at once, each with its own place, 0, 1, ...,
/// and a box, m, in which the parts lie. For a host that carries grains 300 of them are scattered, moved and scattered again.
template <Host H>
report host_report(const H& host, std::size_t place, const vector& lower, const vector& upper) {
  report broken;
  detail::demand_questions(broken, host, place);
  detail::demand_sums(broken, host, place);
  if constexpr (DistributingHost<H>) {
    constexpr std::int64_t grains = 300;
    const double reach = 0.1 * norm(upper - lower);
    std::vector<parcel> parcels;
    for (std::int64_t id = 0; id < grains; ++id) {
      const vector x = detail::scattered(id, lower, upper);
      if (host.keeps(x)) parcels.push_back({id, x, 0.01 * reach, {static_cast<double>(id), 0.5}});
    }
    for (std::int64_t round = 0; round < 3; ++round) {
      std::vector<vector> positions;
      for (std::int64_t id = 0; id < grains; ++id) {
        positions.push_back(detail::scattered(id + round * grains / 2, lower, upper));
      }
      for (parcel& p : parcels) p.position = positions[static_cast<std::size_t>(p.id)];
      std::size_t kept = 0;
      parcels = detail::demand_exchange(broken, host, parcels, reach, kept, grains);
      detail::demand_neighbours(broken, parcels, kept, positions, reach);
      detail::demand_updates(broken, host, parcels, kept);
      parcels.resize(kept);
    }
  }
  return broken;
}

}  // namespace pendular::testing
