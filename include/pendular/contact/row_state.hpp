// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/contact/action_row.hpp>
#include <pendular/core/fields.hpp>

#include <cstddef>
#include <type_traits>

namespace pendular {

/// All that a row of contacts has, declared once: what checkpoints keep of it and what goes with a grain to another part of a
/// scene.
template <class Memory, class Account, bool Rotates>
struct row_state {
  action_row<Rotates> action;  // what acted in the last evaluation
  double gap;                  // of it, m
  Memory remembered;
  Account work;
};

/// visit(double&) for every number of it.
template <class Memory, class Account, bool Rotates, class Visit>
void for_each_number(row_state<Memory, Account, Rotates>& state, const Visit& visit) {
  for_each_scalar<double>(state.action, visit);
  visit(state.gap);
  for_each_scalar<double>(state.remembered, visit);
  for_each_scalar<double>(state.work, visit);
}

template <class State>
std::size_t number_count() {
  State state{};
  std::size_t count = 0;
  for_each_number(state, [&](double&) { ++count; });
  return count;
}

}  // namespace pendular
