// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/contact/action_row.hpp>
#include <pendular/contact/bridge_force.hpp>
#include <pendular/contact/clock.hpp>
#include <pendular/contact/findings.hpp>
#include <pendular/contact/force.hpp>
#include <pendular/contact/gap_record.hpp>
#include <pendular/contact/row_state.hpp>
#include <pendular/contact/separation.hpp>
#include <pendular/contact/work_sums.hpp>
#include <pendular/core/parallel.hpp>
#include <pendular/core/scalar_table.hpp>
#include <pendular/liquid/bonds.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

namespace pendular {

/// The contacts of one list, pairs or grains near a wall: what each remembers, and in the first phase of a step the
/// composed laws over all of them, a block at a time, with what acts stored per row.
///
/// What differs between lists is in the `Way` to look at them: `size()`; for a block of rows `look(row)`, its separation,
/// `meet(row, separation, reduced mass, time step)`, the encounter, `inverse_mass(row)`, `material_of(row)`, and
/// `turning(encounter, traction)`, what is stored of the torque; and `bond_row(row)`, its row among the bonds.
template <class Material, class Bonds, bool Rotates, bool KeepsBook>
class contact_rows {
 public:
  static constexpr bool rotates = Rotates;
  static constexpr bool carries_bridges = !std::is_same_v<Bonds, no_bonds>;
  template <class T>
  using memory = typename Material::template memory<T>;
  template <class T>
  using constants = contact_constants<T, Material>;

  /// Follows the rows into a new list. What acts is kept only where nobody evaluates all of it again at once.
  void carry(std::span<const std::int32_t> origin, std::size_t rows, bool keeps_actions) {
    memory_.carry(origin, rows);
    carry_actions(origin, rows, keeps_actions);
    busy_.assign(rows / lane_count, in_contact);
    forget_constants();
    size_ = origin.size();
    gaps_.carry(origin, rows, keeps_actions);
    work_.carry(origin, rows);
    findings_.assign(chunk_count(rows, chunk), {});
  }

  /// To be called when masses or material may have changed.
  void forget_constants() { constants_known_ = false; }

  template <class Way>
  contact_findings evaluate(const Way& way, const Bonds& bonds, const contact_clock& clock) {
    if (!constants_known_) make_constants(way);
    fresh_.clear();
    gaps_.turn();
    for_chunks(actions_.size(), chunk, [&](std::size_t begin, std::size_t end, std::size_t c) {
      lane_findings found;
      for (std::size_t p = begin; p < end; p += lane_count) evaluate_block(way, bonds, clock, p, found);
      findings_[c] = found.folded();
    });
    contact_findings all;
    for (const contact_findings& f : findings_) all |= f;
    return all;
  }

  /// Only these rows, and those that have never been evaluated, as they stand; all others keep what acts to the last bit.
  template <class Way>
  contact_findings renew(const Way& way, const Bonds& bonds, const contact_clock& clock,
                         std::span<const std::size_t> changed) {
    if (!constants_known_) make_constants(way);
    fresh_.insert(fresh_.end(), changed.begin(), changed.end());
    std::sort(fresh_.begin(), fresh_.end());
    gaps_.stand();
    contact_findings all;
    for (auto next = fresh_.begin(); next != fresh_.end();) {
      const std::size_t begin = *next / lane_count * lane_count;
      std::array<bool, lane_count> wanted{};
      for (; next != fresh_.end() && *next < begin + lane_count; ++next) wanted[*next - begin] = true;
      lane_findings found;
      renew_block(way, bonds, clock, begin, wanted, found);
      all |= found.folded();
    }
    fresh_.clear();
    return all;
  }

  using state_type = row_state<memory<double>, typename work_sums_if<KeepsBook>::template account<double>, Rotates>;
  state_type take(std::size_t row) const { return {actions_[row], gaps_.now()[row], memory_.row(row), work_.row(row)}; }
  void put(std::size_t row, const state_type& state) {
    actions_[row] = state.action;
    gaps_.recall(row, state.gap);
    memory_.set_row(row, state.remembered);
    work_.set_row(row, state.work);
  }
  /// Nothing is left of the rows, because all are put back by hand.
  void forget_rows() {
    work_.forget_rows();
    fresh_.clear();
  }
  /// Whether what acts on a row is known: it has been evaluated since it was listed, or put back.
  bool is_known(std::size_t row) const { return !std::binary_search(fresh_.begin(), fresh_.end(), row); }
  /// After rows were put back, those are new that are left in this list; none by default.
  void renew_only(std::vector<std::size_t> rows = {}) { fresh_ = std::move(rows); }

  /// Gaps of the last evaluation, m.
  std::span<const double> gap() const { return gaps_.now().first(size_); }
  /// The same with padding and with those of the evaluation before, which only bridges that form on closing ask for.
  gap_history gaps() const { return gaps_.history(); }
  void recall_gap(std::size_t row, double gap) { gaps_.recall(row, gap); }

  /// Force on the (first) grain of a row, N.
  vector force(std::size_t row) const { return vector_of(push_of(actions_[row])); }
  /// What its way stored: of a pair the torque per lever arm, N, of a grain at a wall the torque, N m.
  vector torque(std::size_t row) const requires(Rotates) { return vector_of(actions_[row].high); }
  const action_row<Rotates>* actions() const { return actions_.data(); }

  scalar_table<memory>& memories() { return memory_; }
  const scalar_table<memory>& memories() const { return memory_; }
  work_sums_if<KeepsBook>& work() { return work_; }
  const work_sums_if<KeepsBook>& work() const { return work_; }

 private:
  static constexpr std::size_t chunk = 512;
  static constexpr char idle = 0, bridging = 1, in_contact = 2;

  void carry_actions(std::span<const std::int32_t> origin, std::size_t rows, bool keeps) {
    const std::vector<action_row<Rotates>> before = std::exchange(actions_, std::vector<action_row<Rotates>>(rows));
    const std::vector<std::size_t> fresh = std::exchange(fresh_, {});
    if (!keeps) return;
    for (std::size_t p = 0; p < origin.size(); ++p) {
      const auto old = static_cast<std::size_t>(origin[p]);
      const bool known = origin[p] >= 0 && !std::binary_search(fresh.begin(), fresh.end(), old);
      if (known) actions_[p] = before[old];
      else fresh_.push_back(p);
    }
  }

  template <class Way>
  void make_constants(const Way& way) {
    if constexpr (scalar_table<constants>::width == 0) return;
    constants_.resize(actions_.size());
    for_chunks(actions_.size(), chunk, [&](std::size_t begin, std::size_t end, std::size_t) {
      for (std::size_t p = begin; p < end; p += lane_count) {
        constants_.store_block(p, constants_of(way.material_of(p), block(1.0 / way.inverse_mass(p))));
      }
    });
    constants_known_ = true;
  }
  /// Where it is not kept it is made again, and costs nothing if no law looks at it.
  template <class Way>
  static block reduced_mass(const Way& way, std::size_t p, const constants<block>& made) {
    if constexpr (keeps_reduced_mass<Material>) return made.reduced_mass;
    else return 1.0 / way.inverse_mass(p);
  }

  // Flattened, because a block passed to a function that is not inlined goes through memory.
  template <class Way>
  PENDULAR_FLATTEN void evaluate_block(const Way& way, const Bonds& bonds, const contact_clock& clock, std::size_t p,
                                       lane_findings& found) {
    const separation<block> s = way.look(p);
    bool bonded = false;
    if constexpr (carries_bridges) {
      bonded = bonds.any_bonded(way.bond_row(p));
      found.event = max(found.event, bonds.event(way.bond_row(p), s.gap, gaps_.before(p, s.gap)));
    }
    gaps_.put(p, s.gap);
    char& busy = busy_[p / lane_count];
    const bool touching = any(!(s.gap >= 0));  // also if it is no number
    const bool dragging = touching || (Bonds::is_viscous && bonded);
    if (dragging || busy == in_contact) {
      busy = dragging || !clock.moving ? in_contact : bridging;  // once more, so that what contacts remember is cleared
      const constants<block> made = constants_.load_block(p);
      // The encounter has no name, under which compilers would copy it.
      evaluate_contacts(way, way.meet(p, s, reduced_mass(way, p, made), clock.time_step), made, bonds, clock, p, found);
    } else {
      found.demand_finite(s.gap);
      if (bonded || busy != idle) evaluate_bridges(way, s, bonds, p, bonded, found);
      busy = bonded ? bridging : idle;
    }
  }

  /// Nobody touches and nobody did in the last step: what is left is the pull of bridges, if any.
  template <class Way>
  void evaluate_bridges(const Way& way, const separation<block>& s, const Bonds& bonds, std::size_t p, bool bonded,
                        lane_findings& found) {
    block pull = block(0.0);
    if constexpr (carries_bridges) {
      if (bonded) pull = bonds.attraction(way.bond_row(p), s.gap);
    }
    const Vec3<block> force = pull * s.normal;
    store_action(p, s.gap, force, {block(0.0), block(0.0), block(0.0)});
    found.demand_finite(force.x + force.y + force.z);
  }

  template <class Way>
  void evaluate_contacts(const Way& way, const encounter<block>& e, const constants<block>& made, const Bonds& bonds,
                         const contact_clock& clock, std::size_t p, lane_findings& found) {
    const block& gap = e.approaching.gap;
    memory<block> remembered = memory_.load_block(p);
    contact_force<block> f = touch(way.material_of(p), e, made.damping, remembered, clock.time_step);
    if (clock.moving) memory_.store_block(p, remembered);
    block pull = block(0.0);
    if constexpr (carries_bridges) pull = add_bridges(bonds, way.bond_row(p), e, f);
    const block push = f.push - pull;
    const Vec3<block> force = f.traction - push * e.normal;
    Vec3<block> torque;
    if constexpr (Rotates) torque = way.turning(e, f.traction);
    store_action(p, gap, force, torque);
    const block smaller = min(e.approaching.radius_i, e.approaching.radius_j);
    found.room = min(found.room, gap + clock.overlap_limit * smaller);
    found.demand_finite(gap + force.x + force.y + force.z);
    if constexpr (KeepsBook) work_.add(p, e, f, clock);
  }

  void store_action(std::size_t p, const block& gap, const Vec3<block>& force, const Vec3<block>& torque) {
    const quad_block push{force.x, force.y, force.z, unit_step(block(-gap))};
    if constexpr (Rotates) {
      store(actions_.data() + p, push, {torque.x, torque.y, torque.z, gap});
    } else {
      store(actions_.data() + p, push);
    }
  }

  template <class Way>
  void renew_block(const Way& way, const Bonds& bonds, const contact_clock& clock, std::size_t begin,
                   const std::array<bool, lane_count>& wanted, lane_findings& found) {
    const std::vector<action_row<Rotates>> actions(actions_.begin() + static_cast<std::ptrdiff_t>(begin),
                                                   actions_.begin() + static_cast<std::ptrdiff_t>(begin + lane_count));
    using account = typename work_sums_if<KeepsBook>::template account<double>;
    std::array<account, lane_count> accounts;
    for (std::size_t lane = 0; KeepsBook && lane < lane_count; ++lane) accounts[lane] = work_.row(begin + lane);
    evaluate_block(way, bonds, clock, begin, found);
    // Which rows lie in a block is chance, so only the wanted ones may have events.
    const block asked = block::from([&](int lane) { return wanted[static_cast<std::size_t>(lane)] ? 1.0 : 0.0; });
    found.event = select(asked > 0, found.event, block(-1.0));
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
      if (wanted[lane]) continue;
      actions_[begin + lane] = actions[lane];
      if constexpr (KeepsBook) work_.set_row(begin + lane, accounts[lane]);
    }
  }

  std::size_t size_ = 0;  // without padding
  scalar_table<memory> memory_;
  scalar_table<constants> constants_;
  bool constants_known_ = false;
  std::vector<action_row<Rotates>> actions_;
  std::vector<std::size_t> fresh_;  // rows whose action is not known yet, in ascending order
  std::vector<char> busy_;          // per block: the most that one of its rows did in the last step
  gap_record<carries_bridges && Bonds::forms_on_closing> gaps_;
  work_sums_if<KeepsBook> work_;
  std::vector<contact_findings> findings_;
};

}  // namespace pendular
