// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/quad.hpp>
#include <pendular/space/grains.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

// The wet scene of this folder written by hand: linear springs, two-sided dashpots, Eq. 12 in its stable form, Eqs. 4-11
// with the rupture of Eq. 6, six planes, synchronised velocity Verlet; no policy, no composition, no check. What the
// library is measured against.
namespace yardstick {

using pendular::block;
using pendular::quad;
using pendular::quad_block;
using pendular::Vec3;
using pendular::vector;
using lanes3 = Vec3<block>;

struct parameters {
  double stiffness = 1e3, damping = 0.8, viscosity = 1.0, friction = 0.4, kappa = 0.4, decay = 0.9;
  double time_step = 1e-6, gravity = -9.81, skin = 0.2;
};

/// Columns of a list of contacts, padded to whole blocks.
struct contacts {
  std::vector<std::int32_t> i, j;
  std::vector<double> memory[3];
  std::vector<double> amplitude, rate, rupture;  // of the bridges; rupture below 0 for none
  std::vector<quad> force, turn;

  void resize(std::size_t rows) {
    for (auto& column : memory) column.assign(rows, 0.0);
    for (auto* column : {&amplitude, &rate}) column->assign(rows, 0.0);
    rupture.assign(rows, -1.0);
    force.assign(rows, {});
    turn.assign(rows, {});
  }
};

class wet_box {
 public:
  wet_box(const std::vector<pendular::grain>& grains, const vector& size, const parameters& p)
      : p_(p), size_(size), n_(grains.size()) {
    for (const auto& g : grains) {
      const double mass = 4.0 / 3 * std::numbers::pi * g.radius * g.radius * g.radius * g.density;
      place_.push_back({g.position.x, g.position.y, g.position.z, g.radius});
      motion_.push_back({g.velocity.x, g.velocity.y, g.velocity.z, 1 / mass});
      turn_.push_back({0, 0, 0, 0});
      inverse_inertia_.push_back(2.5 / (mass * g.radius * g.radius));
      id_.push_back(static_cast<std::int64_t>(id_.size()));
      smallest_ = std::min(smallest_, g.radius);
      largest_ = std::max(largest_, g.radius);
    }
    force_.assign(n_, {});
    torque_.assign(n_, {});
    rebuild();
    evaluate();
    for (std::size_t k = 0; k < n_; ++k) sum(k, false);
  }

  /// V_b = alpha R^3 for the given pairs of ids.
  void wet(double alpha, const std::set<std::pair<std::int64_t, std::int64_t>>& bridges) {
    reach_ = std::cbrt(alpha) * largest_;
    alpha_ = alpha;
    rebuild();
    for (std::size_t p = 0; p < pairs_; ++p) {
      const auto i = static_cast<std::size_t>(c_.i[p]), j = static_cast<std::size_t>(c_.j[p]);
      if (bridges.contains({id_[i], id_[j]})) make_bridge(p, place_[i].d, place_[j].d);
    }
    evaluate();
    for (std::size_t k = 0; k < n_; ++k) sum(k, false);
  }

  void step() {
    const double dt = p_.time_step;
    bool far = false;
    const double allowed = 0.25 * skin() * skin();
    for (std::size_t k = 0; k < n_; ++k) {
      quad &x = place_[k], &v = motion_[k], &w = turn_[k];
      const quad &f = force_[k], &t = torque_[k];
      const double ax = v.d * f.a, ay = v.d * f.b, az = v.d * f.c + p_.gravity;
      x.a += dt * v.a + 0.5 * dt * dt * ax, x.b += dt * v.b + 0.5 * dt * dt * ay, x.c += dt * v.c + 0.5 * dt * dt * az;
      v.a += dt * ax, v.b += dt * ay, v.c += dt * az;
      const double s = dt * inverse_inertia_[k];
      w.a += s * t.a, w.b += s * t.b, w.c += s * t.c;
      const vector d{x.a - listed_at_[k].x, x.b - listed_at_[k].y, x.c - listed_at_[k].z};
      far |= !(dot(d, d) < allowed);
    }
    if (far) rebuild();
    evaluate();
    for (std::size_t k = 0; k < n_; ++k) sum(k, true);
  }

  std::size_t pairs() const { return pairs_; }
  std::size_t bridges() const {
    return static_cast<std::size_t>(
        std::count_if(c_.rupture.begin(), c_.rupture.end(), [](double r) { return r > 0; }));
  }
  int rebuilds() const { return rebuilds_; }

  std::vector<vector> positions_by_id() const {
    std::vector<vector> all(n_);
    for (std::size_t k = 0; k < n_; ++k)
      all[static_cast<std::size_t>(id_[k])] = {place_[k].a, place_[k].b, place_[k].c};
    return all;
  }

 private:
  double skin() const { return p_.skin * smallest_; }
  vector centre(std::size_t k) const { return {place_[k].a, place_[k].b, place_[k].c}; }

  void make_bridge(std::size_t p, double ri, double rj) {
    const double mean = std::sqrt(ri * rj), volume = alpha_ * mean * mean * mean;
    const double ratio = std::max(ri, rj) / std::min(ri, rj);
    c_.amplitude[p] = p_.kappa * mean;
    c_.rate[p] = 1 / (p_.decay * std::sqrt(0.5 * volume / ratio * (1 / ri + 1 / rj)));
    c_.rupture[p] = std::cbrt(volume);
  }

  // -- forces ---------------------------------------------------------------------------------------------------------

  static lanes3 followed(const lanes3& memory, const lanes3& n, const block& twist) {
    const block before = dot(memory, memory);
    const lanes3 turned = memory + twist * cross(n, memory), laid = tangential_part(turned, n);
    return block((before / dot(laid, laid).max(1e-60)).sqrt()) * laid;
  }

  /// Eq. 12 in its stable form; the memory is that of the contact.
  lanes3 traction(const lanes3& slip, const block& mass, const block& count, const block& push, lanes3& memory) const {
    const block mass_rate = mass / (count * p_.time_step), resistance = 0.5625 * mass_rate;
    const block limit = p_.friction * push.max(0.0);
    const lanes3 trial = block(p_.viscosity / (p_.viscosity + resistance)) * (memory - resistance * slip);
    const lanes3 elastic = slip + block(block::Constant(1 / p_.viscosity)) * trial;
    memory = shortened_to(lanes3(memory - block(0.0625 * mass_rate) * elastic), limit);
    return shortened_to(trial, limit);
  }

  void touch(contacts& c, std::size_t p, const lanes3& n, const block& gap, const lanes3& velocity, const block& mass,
             const lanes3& rolling, const block& twist, const block& count, const block& pull) const {
    const block closing = dot(velocity, n), closed = pendular::unit_step(block(-gap));
    const block push =
        p_.stiffness * (-gap).max(0.0) + 2 * p_.damping * (mass * p_.stiffness).sqrt() * closing * closed;
    lanes3 memory{pendular::load(c.memory[0].data() + p), pendular::load(c.memory[1].data() + p),
                  pendular::load(c.memory[2].data() + p)};
    memory = followed(memory, n, twist);
    const lanes3 t = traction(tangential_part(velocity, n) + rolling, 2.0 / 7 * mass, count, push, memory);
    pendular::store(c.memory[0].data() + p, memory.x);
    pendular::store(c.memory[1].data() + p, memory.y);
    pendular::store(c.memory[2].data() + p, memory.z);
    const lanes3 force = t - block(push - pull) * n, torque = cross(n, t);
    pendular::store(c.force.data() + p, {force.x, force.y, force.z, closed});
    pendular::store(c.turn.data() + p, {torque.x, torque.y, torque.z, gap});
  }

  block pull(std::size_t p, const block& gap) const {
    const block alive = pendular::unit_step(block(pendular::load(c_.rupture.data() + p) - gap));
    const block decayed = (-gap.max(0.0) * pendular::load(c_.rate.data() + p)).exp();
    return alive * pendular::load(c_.amplitude.data() + p) * decayed;
  }

  void break_bridges(std::size_t p, const block& gap) {
    const block rupture = pendular::load(c_.rupture.data() + p);
    if (!(((gap - rupture) * pendular::unit_step(rupture)).maxCoeff() > 0)) return;
    for (int lane = 0; lane < pendular::lane_count; ++lane) {
      if (gap(lane) > rupture(lane)) c_.rupture[p + static_cast<std::size_t>(lane)] = -1;
    }
  }

  void evaluate() {
    for (std::size_t p = 0; p < c_.i.size(); p += pendular::lane_count) evaluate_pairs(p);
    for (std::size_t w = 0; w < 6; ++w) {
      for (std::size_t p = 0; p < walls_[w].i.size(); p += pendular::lane_count) evaluate_wall(w, p);
    }
  }

  PENDULAR_FLATTEN void evaluate_pairs(std::size_t p) {
    const std::int32_t *i = c_.i.data() + p, *j = c_.j.data() + p;
    const quad_block from = gather(place_.data(), i), to = gather(place_.data(), j);
    const lanes3 branch{to.a - from.a, to.b - from.b, to.c - from.c};
    const block distance = norm(branch), gap = distance - from.d - to.d;
    char& busy = busy_[p / pendular::lane_count];
    const bool touching = gap.minCoeff()<0, bonded = pendular::load(c_.rupture.data() + p).maxCoeff()> 0;
    if (!touching && !bonded && busy == 0) return;
    const lanes3 n = block(1 / distance) * branch;
    const block attraction = bonded ? pull(p, gap) : block(block::Zero());
    if (bonded) break_bridges(p, gap);
    if (!touching && busy < 2) {
      const lanes3 force = attraction * n;
      pendular::store(c_.force.data() + p, {force.x, force.y, force.z, block(block::Zero())});
      busy = bonded ? 1 : 0;
      return;
    }
    busy = touching ? 2 : 1;
    const quad_block vi = gather(motion_.data(), i), vj = gather(motion_.data(), j);
    const quad_block wi = gather(turn_.data(), i), wj = gather(turn_.data(), j);
    const block mass = 1 / (vi.d + vj.d);
    const lanes3 si{wi.a, wi.b, wi.c}, sj{wj.a, wj.b, wj.c};
    const lanes3 rolling = cross(block(from.d + 0.5 * gap) * si + block(to.d + 0.5 * gap) * sj, n);
    const block count = ((wi.d * vi.d + wj.d * vj.d) * mass).max(1.0), twist = 0.5 * p_.time_step * dot(si + sj, n);
    touch(c_, p, n, gap, {vi.a - vj.a, vi.b - vj.b, vi.c - vj.c}, mass, rolling, twist, count, attraction);
  }

  PENDULAR_FLATTEN void evaluate_wall(std::size_t w, std::size_t p) {
    contacts& c = walls_[w];
    const quad_block x = gather(place_.data(), c.i.data() + p), v = gather(motion_.data(), c.i.data() + p);
    const quad_block s = gather(turn_.data(), c.i.data() + p);
    const std::size_t axis = w / 2;
    const bool upper = w % 2 == 1;
    const block& along = axis == 0 ? x.a : axis == 1 ? x.b : x.c;
    const double edge = axis == 0 ? size_.x : axis == 1 ? size_.y : size_.z;
    const block gap = (upper ? block(edge - along) : along) - x.d;
    if (!(gap.minCoeff() < 0)) {
      std::fill_n(c.force.begin() + static_cast<std::ptrdiff_t>(p), pendular::lane_count, quad{});
      std::fill_n(c.turn.begin() + static_cast<std::ptrdiff_t>(p), pendular::lane_count, quad{});
      for (auto& column : c.memory)
        std::fill_n(column.begin() + static_cast<std::ptrdiff_t>(p), pendular::lane_count, 0.0);
      return;
    }
    const block one = block::Constant(upper ? 1 : -1), zero = block::Zero();
    const lanes3 n{axis == 0 ? one : zero, axis == 1 ? one : zero, axis == 2 ? one : zero};
    const lanes3 spin{s.a, s.b, s.c};
    const block twist = 0.5 * p_.time_step * dot(spin, n);
    touch(c, p, n, gap, {v.a, v.b, v.c}, 1 / v.d, cross(block(x.d + gap) * spin, n), twist, s.d.max(1.0), zero);
  }

  /// All that acts on one grain, and its corrected velocity.
  void sum(std::size_t k, bool moving) {
    using four = pendular::detail::four_doubles;
    four f{0, 0, 0, 0}, t{0, 0, 0, 0}, row;
    const double r = place_[k].d;
    for (std::size_t m = wall_start_[k]; m < wall_start_[k + 1]; ++m) {
      const quad& turn = walls_[at_walls_[m].wall].turn[at_walls_[m].row];
      const double lever = r + turn.d;
      pendular::detail::read(row, walls_[at_walls_[m].wall].force[at_walls_[m].row]);
      f += row;
      pendular::detail::read(row, turn);
      t += four{lever, lever, lever, 0} * row;
    }
    for (std::size_t m = start_[k]; m < start_[k + 1]; ++m) {
      const std::size_t p = incident_[m] >> 1;
      const double sign = (incident_[m] & 1u) != 0u ? -1 : 1, lever = r + 0.5 * c_.turn[p].d;
      pendular::detail::read(row, c_.force[p]);
      f += four{sign, sign, sign, 1} * row;
      pendular::detail::read(row, c_.turn[p]);
      t += four{lever, lever, lever, 0} * row;
    }
    turn_[k].d = f[3];
    if (moving) {
      const double half = 0.5 * p_.time_step, s = half * motion_[k].d, u = half * inverse_inertia_[k];
      motion_[k].a += s * (f[0] - force_[k].a), motion_[k].b += s * (f[1] - force_[k].b);
      motion_[k].c += s * (f[2] - force_[k].c);
      turn_[k].a += u * (t[0] - torque_[k].a), turn_[k].b += u * (t[1] - torque_[k].b);
      turn_[k].c += u * (t[2] - torque_[k].c);
    }
    force_[k] = {f[0], f[1], f[2], 0};
    torque_[k] = {t[0], t[1], t[2], 0};
  }

  // -- the list -------------------------------------------------------------------------------------------------------

  struct at_wall {
    std::size_t wall, row;
  };

  void rebuild() {
    ++rebuilds_;
    const double range = skin() + reach_, edge = 2 * largest_ + range;
    sort_grains(edge);
    const contacts before = c_;
    const auto old_row = [&, start = start_, incident = incident_, order = order_](std::size_t i,
                                                                                   std::int64_t partner) {
      const std::size_t k = order[i];
      if (k + 1 >= start.size()) return std::size_t(-1);
      for (std::size_t m = start[k]; m < start[k + 1]; ++m) {
        const std::size_t p = incident[m] >> 1;
        if (old_id_[static_cast<std::size_t>((incident[m] & 1u) != 0u ? before.i[p] : before.j[p])] == partner)
          return p;
      }
      return std::size_t(-1);
    };
    find_pairs(edge, range);
    c_.resize(c_.i.size());
    for (std::size_t p = 0; p < pairs_ && !before.i.empty(); ++p) {
      const std::size_t old = old_row(static_cast<std::size_t>(c_.i[p]), id_[static_cast<std::size_t>(c_.j[p])]);
      if (old == std::size_t(-1)) continue;
      for (int k = 0; k < 3; ++k) c_.memory[k][p] = before.memory[k][old];
      c_.amplitude[p] = before.amplitude[old], c_.rate[p] = before.rate[old], c_.rupture[p] = before.rupture[old];
    }
    busy_.assign(c_.i.size() / pendular::lane_count, 2);
    list_incidences();
    list_walls();
    listed_at_.resize(n_);
    for (std::size_t k = 0; k < n_; ++k) listed_at_[k] = centre(k);
  }

  void sort_grains(double edge) {
    counts_ = {static_cast<std::int64_t>(size_.x / edge) + 1, static_cast<std::int64_t>(size_.y / edge) + 1,
               static_cast<std::int64_t>(size_.z / edge) + 1};
    std::vector<std::size_t> cell(n_);
    for (std::size_t k = 0; k < n_; ++k) cell[k] = cell_of(centre(k), edge);
    order_.resize(n_);
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    std::sort(order_.begin(), order_.end(),
              [&](std::size_t a, std::size_t b) { return cell[a] != cell[b] ? cell[a] < cell[b] : id_[a] < id_[b]; });
    old_id_ = id_;
    const auto permute = [&](auto& column) {
      auto moved = column;
      for (std::size_t k = 0; k < n_; ++k) moved[k] = column[order_[k]];
      column.swap(moved);
    };
    permute(place_), permute(motion_), permute(turn_), permute(force_), permute(torque_), permute(inverse_inertia_),
        permute(id_);
    cell_start_.assign(static_cast<std::size_t>(counts_.x * counts_.y * counts_.z) + 1, 0);
    for (const std::size_t c : cell) ++cell_start_[c + 1];
    std::partial_sum(cell_start_.begin(), cell_start_.end(), cell_start_.begin());
  }

  std::size_t cell_of(const vector& x, double edge) const {
    const auto at = [&](double v, std::int64_t count) {
      return std::clamp<std::int64_t>(static_cast<std::int64_t>(v / edge), 0, count - 1);
    };
    return static_cast<std::size_t>((at(x.z, counts_.z) * counts_.y + at(x.y, counts_.y)) * counts_.x +
                                    at(x.x, counts_.x));
  }

  void find_pairs(double edge, double range) {
    std::vector<std::int32_t> kinds[3];
    c_.i.clear(), c_.j.clear();
    const auto empty_kinds = [&] {
      for (auto& kind : kinds) {
        for (std::size_t k = 0; k < kind.size(); k += 2) c_.i.push_back(kind[k]), c_.j.push_back(kind[k + 1]);
        kind.clear();
      }
    };
    for (std::size_t a = 0; a < n_; ++a) {
      const vector x = centre(a);
      const auto cell = static_cast<std::int64_t>(cell_of(x, edge));
      const std::int64_t cx = cell % counts_.x, cy = cell / counts_.x % counts_.y, cz = cell / (counts_.x * counts_.y);
      for (std::int64_t z = std::max<std::int64_t>(cz - 1, 0); z <= std::min(cz + 1, counts_.z - 1); ++z) {
        for (std::int64_t y = std::max<std::int64_t>(cy - 1, 0); y <= std::min(cy + 1, counts_.y - 1); ++y) {
          const std::int64_t line = (z * counts_.y + y) * counts_.x;
          const std::size_t from = cell_start_[static_cast<std::size_t>(line + std::max<std::int64_t>(cx - 1, 0))];
          const std::size_t to = cell_start_[static_cast<std::size_t>(line + std::min(cx + 1, counts_.x - 1)) + 1];
          for (std::size_t b = std::max(from, a + 1); b < to; ++b) add_pair(a, b, x, range, kinds);
        }
      }
      if (a % 256 == 255) empty_kinds();
    }
    empty_kinds();
    pairs_ = c_.i.size();
    if (pairs_ == 0) return;
    c_.i.resize(pendular::padded(pairs_), c_.i.back());
    c_.j.resize(pendular::padded(pairs_), c_.j.back());
  }

  void add_pair(std::size_t a, std::size_t b, const vector& x, double range, std::vector<std::int32_t> (&kinds)[3]) {
    const vector d = centre(b) - x;
    const double sum = place_[a].d + place_[b].d, square = dot(d, d);
    if (square > (sum + range) * (sum + range)) return;
    const bool in_order = id_[a] < id_[b];
    auto& kind = kinds[square <= sum * sum ? 0 : square <= (sum + reach_) * (sum + reach_) ? 1 : 2];
    kind.push_back(static_cast<std::int32_t>(in_order ? a : b));
    kind.push_back(static_cast<std::int32_t>(in_order ? b : a));
  }

  void list_incidences() {
    start_.assign(n_ + 1, 0);
    for (std::size_t p = 0; p < pairs_; ++p)
      ++start_[static_cast<std::size_t>(c_.i[p]) + 1], ++start_[static_cast<std::size_t>(c_.j[p]) + 1];
    std::partial_sum(start_.begin(), start_.end(), start_.begin());
    incident_.resize(2 * pairs_);
    std::vector<std::size_t> next(start_.begin(), start_.end() - 1);
    for (std::size_t p = 0; p < pairs_; ++p) {
      incident_[next[static_cast<std::size_t>(c_.i[p])]++] = static_cast<std::uint32_t>(2 * p);
      incident_[next[static_cast<std::size_t>(c_.j[p])]++] = static_cast<std::uint32_t>(2 * p + 1);
    }
  }

  void list_walls() {
    const std::vector<std::vector<at_wall>> before = by_id_;
    std::vector<contacts> old(std::begin(walls_), std::end(walls_));
    by_id_.assign(n_, {});
    for (std::size_t w = 0; w < 6; ++w) {
      contacts& c = walls_[w];
      c.i.clear();
      for (std::size_t k = 0; k < n_; ++k) {
        const double x = w / 2 == 0 ? place_[k].a : w / 2 == 1 ? place_[k].b : place_[k].c;
        const double edge = w / 2 == 0 ? size_.x : w / 2 == 1 ? size_.y : size_.z;
        if ((w % 2 == 1 ? edge - x : x) - place_[k].d < skin()) c.i.push_back(static_cast<std::int32_t>(k));
      }
      const std::size_t count = c.i.size();
      if (count > 0) c.i.resize(pendular::padded(count), c.i.back());
      c.resize(c.i.size());
      for (std::size_t row = 0; row < count; ++row) {
        const auto k = static_cast<std::size_t>(c.i[row]), id = static_cast<std::size_t>(id_[k]);
        by_id_[id].push_back({w, row});
        if (before.empty()) continue;
        for (const at_wall& at : before[id]) {
          if (at.wall == w)
            for (int m = 0; m < 3; ++m) c.memory[m][row] = old[w].memory[m][at.row];
        }
      }
    }
    at_walls_.clear();
    wall_start_.assign(1, 0);
    for (std::size_t k = 0; k < n_; ++k) {
      const auto& mine = by_id_[static_cast<std::size_t>(id_[k])];
      at_walls_.insert(at_walls_.end(), mine.begin(), mine.end());
      wall_start_.push_back(at_walls_.size());
    }
  }

  parameters p_;
  vector size_;
  std::size_t n_, pairs_ = 0;
  double smallest_ = 1e9, largest_ = 0, reach_ = 0, alpha_ = 0;
  int rebuilds_ = 0;
  std::vector<quad> place_, motion_, turn_, force_, torque_;  // radius, inverse mass and contacts in fourth place
  std::vector<double> inverse_inertia_;
  std::vector<std::int64_t> id_, old_id_;
  Vec3<std::int64_t> counts_{1, 1, 1};
  std::vector<std::size_t> order_, cell_start_, start_;
  std::vector<std::uint32_t> incident_;  // 2 * pair + (1 for the second grain)
  std::vector<vector> listed_at_;
  std::vector<char> busy_;
  contacts c_, walls_[6];
  std::vector<at_wall> at_walls_;        // of all grains, one after the other
  std::vector<std::size_t> wall_start_;  // where those of a grain begin
  std::vector<std::vector<at_wall>> by_id_;
};

}  // namespace yardstick
