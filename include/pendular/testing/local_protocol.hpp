// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/liquid/protocol/concepts.hpp>
#include <pendular/testing/report.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pendular::testing {

/// The bonds of one grain each: from one to twelve, above and below, of unequal partners, some just forming.
inline std::vector<std::vector<bond_side>> bond_side_samples(double radius = 5e-4) {
  std::vector<std::vector<bond_side>> samples;
  for (std::size_t count = 1; count <= 12; ++count) {
    for (int kind = 0; kind < 6; ++kind) {
      std::vector<bond_side> sides;
      for (std::size_t k = 0; k < count; ++k) {
        const double share = std::fmod(0.618 * static_cast<double>(k + 1) + 0.37 * kind, 1.0);
        const double height = kind == 0 ? 0 : kind == 1 ? -0.5 : kind == 2 ? 0.5 : 2 * share - 1;
        const bool forming = kind == 3 || (kind > 3 && k % 3 == 0);
        sides.push_back({radius, radius * (kind % 2 == 0 ? 1 : 0.1 + 5 * share), height * radius,
                         static_cast<std::int64_t>(7 * k % 13) - (kind == 5 && k == 0 ? 20 : 0), forming});
      }
      samples.push_back(sides);
    }
  }
  return samples;
}

namespace detail {
/// What every bond of a grain pulls, when their offers are merged one after the other in this order.
template <LocalProtocol P>
std::vector<double> pulls_of(const P& protocol, const std::vector<bond_side>& sides,
                             const std::vector<std::size_t>& order, double film) {
  auto merged = protocol.offer(sides[order.front()]);
  for (std::size_t k = 1; k < order.size(); ++k) merged = protocol.merge(merged, protocol.offer(sides[order[k]]));
  const auto grant = protocol.settle(merged, film);
  std::vector<double> pulls;
  for (const bond_side& side : sides) pulls.push_back(protocol.pull(side, grant));
  return pulls;
}

/// The same with the offers merged as in a tree.
template <LocalProtocol P, class Offer>
Offer merged_as_tree(const P& protocol, const std::vector<Offer>& offers, std::size_t from, std::size_t to) {
  if (to - from == 1) return offers[from];
  const std::size_t middle = from + (to - from + 1) / 2;
  return protocol.merge(merged_as_tree(protocol, offers, middle, to), merged_as_tree(protocol, offers, from, middle));
}

template <LocalProtocol P>
void demand_shares(report& broken, const P& protocol, const std::vector<bond_side>& sides, double film) {
  std::vector<std::size_t> order(sides.size());
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
  const std::vector<double> pulls = pulls_of(protocol, sides, order, film);
  double sum = 0;
  for (const double pull : pulls) {
    const std::initializer_list<quantity> example = {
        {"bonds", static_cast<double>(sides.size())}, {"film", film}, {"pull", pull}};
    demand(broken, std::isfinite(pull) && pull >= 0, "a pull must be finite and at least 0", example);
    sum += pull;
  }
  demand(broken, sum <= film * (1 + 1e-12), "the pulls of a grain must not exceed its film",
         {{"bonds", static_cast<double>(sides.size())}, {"film", film}, {"pulls", sum}});
  std::reverse(order.begin(), order.end());
  const std::vector<double> reversed = pulls_of(protocol, sides, order, film);
  std::vector<decltype(protocol.offer(sides.front()))> offers;
  for (const bond_side& side : sides) offers.push_back(protocol.offer(side));
  const auto grant = protocol.settle(merged_as_tree(protocol, offers, 0, offers.size()), film);
  for (std::size_t k = 0; k < sides.size(); ++k) {
    const double as_tree = protocol.pull(sides[k], grant);
    demand(broken, agree(pulls[k], reversed[k], 1e-12, 1e-12 * film), "offers must merge in any order",
           {{"pull", pulls[k]}, {"in reverse", reversed[k]}});
    demand(broken, agree(pulls[k], as_tree, 1e-12, 1e-12 * film), "offers must merge in any grouping",
           {{"pull", pulls[k]}, {"in pairs", as_tree}});
  }
}
}  // namespace detail

/// What a local protocol promises beyond its signature.
template <LocalProtocol P>
report local_protocol_report(const P& protocol) {
  report broken;
  for (const std::vector<bond_side>& sides : bond_side_samples()) {
    for (const double film : {0.0, 1e-18, 1e-12}) detail::demand_shares(broken, protocol, sides, film);
  }
  return broken;
}

}  // namespace pendular::testing
