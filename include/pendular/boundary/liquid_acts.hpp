// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/boundary/wet_rows.hpp>
#include <pendular/contact/findings.hpp>
#include <pendular/liquid/door.hpp>
#include <pendular/space/pair_list.hpp>

#include <cstddef>
#include <cstdint>
#include <exception>
#include <span>
#include <string_view>
#include <utility>

namespace pendular {

/// What is done to the liquid of a scene: by its bridges that break and form, by protocols, sources and users. Made where
/// it is needed, of the rows, grains and list of the scene.
template <class Rows, class Grains, Host H = alone>
class liquid_acts {
 public:
  using bonds_type = typename Rows::bonds_type;

  liquid_acts(Rows& rows, const Grains& grains, const pair_list& list, const vector& up, const H& host = {})
      : rows_(rows), grains_(grains), list_(list), up_(up), host_(host) {}

  /// Ruptures and formations of an evaluation, if it found any or films have changed since the last. Answers whether.
  bool settle_if(const contact_findings& found) {
    const bool asked = host_.any(found.liquid_event || rows_.bridges().asks_protocol());
    if (asked) settle();
    // The forces are those of the bridges before; what has settled acts in the next step, whatever is done meanwhile.
    rows_.bridges().forget_changed_rows();
    return asked;
  }

  /// How far apart the pairs are that a global protocol needs in the list, m.
  template <class P>
  double reach_of(const P& protocol) {
    if constexpr (requires(liquid_door_archetype door) { protocol.reach(door); }) {
      const pair_view v = view();
      const auto incidences = pairs_of();
      double reach = 0;
      together(host_, [&] { reach = protocol.reach(liquid_door(rows_.bridges(), v, incidences, host_)); });
      return reach;
    } else {
      return 0;
    }
  }
  template <class P>
  void redistribute(const P& protocol) {
    const pair_view v = view();
    const auto incidences = pairs_of();
    liquid_door door(rows_.bridges(), v, incidences, host_);
    together(host_, [&] { protocol.redistribute(door); });
    door.close();
  }

  /// One period of a source; `step` is that of time, s.
  template <class S>
  void act(const S& source, double step) {
    through_door(source.account, static_cast<double>(source.period) * step, [&](auto& door) { source.act(door); });
  }
  /// Liquid between the scene and an account outside: act(outside_door&). The protocol is asked afterwards.
  template <class Act>
  void through_door(std::string_view account, double span, const Act& act) {
    const pair_view v = view();
    const auto incidences = pairs_of();
    outside_door door(rows_.bridges(), v, incidences, account, span, host_);
    together(host_, [&] { act(door); });
    door.close();
    rows_.bridges().ask_protocol();
  }

  /// The bridges of these grains break, and their films leave the scene.
  void take_out(std::span<const char> gone) {
    through_door("taken out", 0, [&](auto& door) {
      door.for_each_bridge([&](std::size_t pair) {
        const bool first = gone[door.first_grain(pair)] != 0;
        if (first || (!door.is_at_wall(pair) && gone[door.second_grain(pair)] != 0)) door.break_bridge(pair);
      });
      for (std::size_t grain = 0; grain < door.grains(); ++grain) {
        if (gone[grain] != 0) door.dry_grain(grain, door.film(grain));
      }
    });
  }

  /// Every source whose period ends with this step, until one throws. Answers what it threw; it has then done nothing.
  std::exception_ptr act_at(std::int64_t step_count, double step) {
    std::exception_ptr thrown;
    rows_.bridges().policies().for_each_source([&](const auto& source) {
      if (step_count % source.period == 0 && !thrown) thrown = all_or_nothing([&] { act(source, step); });
    });
    return thrown;
  }
  template <class Act>
  std::exception_ptr all_or_nothing(const Act& act) {
    bonds_type before = rows_.bridges();
    try {
      act();
      return {};
    } catch (...) {
      rows_.bridges() = std::move(before);
      return std::current_exception();
    }
  }

  /// Whether the list might miss a pair that films of today could join; `skin` is that of the list, m.
  bool outgrows_list(double skin) const {
    return rows_.bridges().formation_reach(view(), host_) + skin > list_.range();
  }

 private:
  void settle() {
    const pair_view v = view();
    if (v.wet_walls) {
      settle_bonds(rows_.bridges(), v, boundary::gaps_of_all_rows(rows_).history(), pairs_of(), host_);
    } else {
      settle_bonds(rows_.bridges(), v, rows_.contacts().gaps(), pairs_of(), host_);
    }
  }

  pair_view view() const { return rows_.view(grains_, list_, up_); }
  auto pairs_of() const {
    return [this](std::size_t grain) { return list_.pairs_of(grain); };
  }

  Rows& rows_;
  const Grains& grains_;
  const pair_list& list_;
  vector up_;
  H host_;
};

}  // namespace pendular
