// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/contact/row_state.hpp>
#include <pendular/core/expects.hpp>
#include <pendular/core/fields.hpp>
#include <pendular/core/host.hpp>
#include <pendular/liquid/pair_view.hpp>
#include <pendular/space/grains.hpp>
#include <pendular/space/pair_list.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace pendular {

namespace detail {
/// Visits the numbers of a value of a grain as doubles that are only carried.
template <class Value, class Visit>
void for_each_carried(Value& value, const Visit& visit) {
  if constexpr (std::is_same_v<Value, std::int64_t>) {
    double carried = std::bit_cast<double>(value);
    visit(carried);
    value = std::bit_cast<std::int64_t>(carried);
  } else {
    for_each_scalar<double>(value, visit);
  }
}

/// Reads numbers one after the other.
class unpacking {
 public:
  explicit unpacking(std::span<const double> numbers) : numbers_(numbers) {}
  double next() { return numbers_[at_++]; }
  std::int64_t next_whole() { return std::bit_cast<std::int64_t>(next()); }

 private:
  std::span<const double> numbers_;
  std::size_t at_ = 0;
};

/// Where a contact of a grain is: its row among the pairs, or among those of one wall.
struct contact_place {
  std::int64_t partner;  // id of the other grain, or -1 - k for wall k
  std::size_t row;
};
}  // namespace detail

/// What goes with the grains when they are given to the parts of a scene that keep them from now on: every column of a
/// grain, its film, and of each of its contacts what `row_state` declares and the volume of its bridge.
template <class Rows, class Grains>
class luggage {
  static constexpr bool wet = Rows::wet;

 public:
  luggage(Rows& rows, Grains& grains) : rows_(rows), grains_(grains) {}

  /// Every grain goes to its keeper, and copies of those within `reach`, m, of a kept one come; grains that are new are
  /// everywhere, and grains marked as gone nowhere. Their contacts follow when they are listed.
  template <DistributingHost H>
  void exchange(const pair_list& list, const pair_view& view, const H& host, double reach, std::span<const char> gone) {
    const std::size_t listed = list.grains(), kept = grains_.kept();
    const auto is_here = [&](std::size_t row) { return row < listed ? row < kept : host.keeps(view.position[row]); };
    parcels_ = pack(list, view, is_here, gone);
    const std::size_t kept_now = host.exchange(parcels_, reach);
    unpack_grains(kept_now);
  }

  /// What the contacts of the kept grains had. Errors: run_error for a bridge whose pair is not listed.
  void unpack_contacts(const pair_list& list, const pair_view& view) {
    find_walls();
    known_pairs_.assign(list.size(), 0);
    known_at_walls_.clear();
    rows_.for_each_wall(
        [&](const auto&, const auto& contacts) { known_at_walls_.push_back(std::vector<char>(contacts.size(), 0)); });
    std::vector<std::pair<std::int64_t, std::size_t>> row_of;
    for (std::size_t row = 0; row < grains_.kept(); ++row) row_of.push_back({view.id[row], row});
    std::sort(row_of.begin(), row_of.end());
    for (auto& [id, in] : unread_) {
      const auto found = std::lower_bound(row_of.begin(), row_of.end(), std::pair{id, std::size_t{0}});
      for (auto left = in.next_whole(); left > 0; --left) unpack_contact(id, found->second, in, list, view);
    }
    unread_.clear();
    leave_only_new_ones();
  }

 private:
  /// Of the grains for which `is_here(row)`, without those marked as gone, whose contacts are no more.
  template <class IsHere>
  std::vector<parcel> pack(const pair_list& list, const pair_view& view, const IsHere& is_here,
                           std::span<const char> gone) {
    find_walls();
    if constexpr (wet) volumes_before_ = rows_.bridges().volumes_before();
    std::vector<parcel> parcels;
    for (std::size_t row = 0; row < grains_.size(); ++row) {
      if (!is_here(row)) continue;
      if (!gone.empty() && gone[row] != 0) {
        settle_contacts(row, list);
        continue;
      }
      parcels.push_back({view.id[row], view.position[row], view.radius[row], {}});
      numbers_ = &parcels.back().numbers;
      pack_grain(row);
      pack_contacts(row, list, view);
    }
    return parcels;
  }

  /// The grains themselves and their films; the first `kept` are kept here.
  void unpack_grains(std::size_t kept) {
    std::vector<std::int64_t> ids;
    for (const parcel& p : parcels_) ids.push_back(p.id);
    grains_.restore(ids, grains_.next_id());
    grains_.mark_copies(parcels_.size() - kept);
    rows_.forget_rows(parcels_.size());
    unread_.clear();
    for (std::size_t row = 0; row < parcels_.size(); ++row) {
      detail::unpacking in(parcels_[row].numbers);
      Grains::for_each_column([&](auto column) {
        detail::for_each_carried(grains_.template get<decltype(column)>()[row], [&](double& v) { v = in.next(); });
      });
      if constexpr (wet) rows_.bridges().restore_film(row, in.next());
      if (row < kept) unread_.push_back({ids[row], in});
    }
  }

  void pack_grain(std::size_t row) {
    Grains::for_each_column([&](auto column) {
      auto value = grains_.template get<decltype(column)>()[row];
      detail::for_each_carried(value, [&](double& v) { numbers_->push_back(v); });
    });
    if constexpr (wet) numbers_->push_back(rows_.bridges().book().films()[row]);
  }

  void put_whole(std::int64_t n) { numbers_->push_back(std::bit_cast<double>(n)); }

  void pack_contacts(std::size_t row, const pair_list& list, const pair_view& view) {
    const std::size_t count_at = numbers_->size();
    std::int64_t count = 0;
    put_whole(0);
    if (row < list.grains()) {
      for (const auto& incidence : list.pairs_of(row)) {
        const auto p = static_cast<std::size_t>(incidence.pair);
        pack_contact(view.id[incidence.is_second ? view.grain_i(p) : view.grain_j(p)], rows_.contacts(), p, p);
        ++count;
      }
      std::int64_t wall = 0;
      rows_.for_each_wall([&](const auto&, const auto& contacts) {
        const std::size_t k = places_at_walls_[static_cast<std::size_t>(wall)][row];
        if (k < contacts.size()) {
          pack_contact(-1 - wall, contacts, k, contacts.bond_row(k));
          ++count;
        }
        ++wall;
      });
    }
    (*numbers_)[count_at] = std::bit_cast<double>(count);
  }

  /// The work in the contacts of a grain that is taken out. Those of which it is the second go with the first grain, to be
  /// settled where they are not listed any more.
  void settle_contacts(std::size_t row, const pair_list& list) {
    if (row >= list.grains()) return;
    for (const auto& incidence : list.pairs_of(row)) {
      if (!incidence.is_second) settle(rows_.contacts(), incidence.pair);
    }
    std::size_t wall = 0;
    rows_.for_each_wall([&](const auto&, auto& contacts) {
      const std::size_t k = places_at_walls_[wall++][row];
      if (k < contacts.size()) settle(contacts, k);
    });
  }
  template <class Contacts>
  static void settle(Contacts& contacts, std::size_t row) {
    auto& work = contacts.work();
    if constexpr (requires { work.settle(work.row(row)); }) work.settle(work.row(row));
  }

  template <class Contacts>
  void pack_contact(std::int64_t partner, const Contacts& contacts, std::size_t row, std::size_t bond) {
    put_whole(partner);
    put_whole(contacts.is_known(row));
    auto state = contacts.take(row);
    for_each_number(state, [&](double& v) { numbers_->push_back(v); });
    if constexpr (wet && Contacts::carries_bridges) {
      numbers_->push_back(rows_.bridges().book().bonds()[bond]);
      numbers_->push_back(volumes_before_[bond]);
    }
  }

  void unpack_contact(std::int64_t id, std::size_t grain, detail::unpacking& in, const pair_list& list,
                      const pair_view& view) {
    const std::int64_t partner = in.next_whole();
    const bool known = in.next_whole() != 0;
    if (partner >= 0) {
      const std::size_t p = list.pair_with(grain, partner);
      const bool settles = id < partner;
      unpack_row(rows_.contacts(), p, p, p < list.size() ? &known_pairs_ : nullptr, known, settles, in, view);
      return;
    }
    std::int64_t wall = -1;
    rows_.for_each_wall([&](const auto&, auto& contacts) {
      if (wall-- != partner) return;
      auto& known_here = known_at_walls_[static_cast<std::size_t>(-1 - partner)];
      const std::size_t k = places_at_walls_[static_cast<std::size_t>(-1 - partner)][grain];
      const bool listed = k < contacts.size();
      unpack_row(contacts, k, listed ? contacts.bond_row(k) : k, listed ? &known_here : nullptr, known, true, in, view);
    });
  }

  /// `listed` are the rows of this list whose action is known, null if the contact is not in it.
  template <class Contacts>
  void unpack_row(Contacts& contacts, std::size_t row, std::size_t bond, std::vector<char>* listed, bool known,
                  bool settles, detail::unpacking& in, const pair_view& view) {
    typename Contacts::state_type state{};
    for_each_number(state, [&](double& v) { v = in.next(); });
    if (listed) {
      contacts.put(row, state);
      (*listed)[row] = known ? 1 : 0;
    } else if (settles) {
      if constexpr (requires { contacts.work().settle(state.work); }) contacts.work().settle(state.work);
    }
    if constexpr (wet && Contacts::carries_bridges) {
      const double volume = in.next(), before = in.next();
      if (!listed && volume > 0) {
        throw run_error("a liquid bridge lost its pair when grains went to another part of the scene (see "
                        "docs/reference/host.md)");
      }
      if (listed && volume > 0 && !rows_.bridges().is_bonded(bond)) rows_.bridges().restore(bond, volume, view);
      if (listed && !std::isnan(before)) rows_.bridges().restore_change(bond, before);
    }
  }

  /// Place of every grain among the contacts of every wall, or one beyond them.
  void find_walls() {
    places_at_walls_.clear();
    rows_.for_each_wall([&](const auto&, const auto& contacts) {
      std::vector<std::size_t> places(grains_.size(), contacts.size());
      for (std::size_t k = 0; k < contacts.size(); ++k) places[contacts.row(k)] = k;
      places_at_walls_.push_back(std::move(places));
    });
  }

  void leave_only_new_ones() {
    rows_.contacts().renew_only(unknown(known_pairs_));
    std::size_t wall = 0;
    rows_.for_each_wall([&](const auto&, auto& contacts) { contacts.renew_only(unknown(known_at_walls_[wall++])); });
  }
  static std::vector<std::size_t> unknown(const std::vector<char>& known) {
    std::vector<std::size_t> rows;
    for (std::size_t row = 0; row < known.size(); ++row) {
      if (!known[row]) rows.push_back(row);
    }
    return rows;
  }

  Rows& rows_;
  Grains& grains_;
  std::vector<double>* numbers_ = nullptr;  // of the parcel that is packed
  std::vector<parcel> parcels_;             // that have come, from which contacts are still to be read
  std::vector<double> volumes_before_;
  std::vector<std::vector<std::size_t>> places_at_walls_;
  std::vector<char> known_pairs_;
  std::vector<std::vector<char>> known_at_walls_;
  std::vector<std::pair<std::int64_t, detail::unpacking>> unread_;
};

template <class Rows, class Grains>
luggage<Rows, Grains> luggage_of(Rows& rows, Grains& grains) {
  return {rows, grains};
}

}  // namespace pendular
