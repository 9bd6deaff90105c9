// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "report.hpp"
#include "run.hpp"

#include <pendular/laplace_young/law.hpp>
#include <pendular/law/capillary/richefeu.hpp>
#include <pendular/law/capillary/richefeu_harmonic.hpp>
#include <pendular/law/rupture/lian.hpp>
#include <pendular/liquid/protocol/all.hpp>
#include <pendular/liquid/protocol/one_of.hpp>
#include <pendular/scene/simple_compression.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#ifdef _OPENMP
#include <omp.h>
#endif

namespace test {

using namespace pendular;

inline double seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

inline fluid water(const options& o) {
  return {o.surface_tension_force / (2 * std::numbers::pi), 0.0, 1000.0, 1e-3};  // theta = 0, companion paper
}

inline double sample_area(const options& o) {
  const double radius = 12.5e-3 * std::cbrt(static_cast<double>(o.grains) / 8000.0);
  return std::numbers::pi * radius * radius;
}

inline scene::compression_parameters parameters(const options& o) {
  scene::compression_parameters p{sample_area(o)};
  p.water_content = o.water_content;
  p.lid_speed = o.wall_speed;
  p.duration = o.duration;
  p.time_step = o.time_step;
  p.mass_scaling = o.mass_scaling;
  p.sample_interval = std::min(1e-6 / o.wall_speed, o.duration / 10);  // a line per micrometre
  p.selection = {o.thinning, o.seed};
  p.force = o.force;
  return p;
}

/// The state of a system by id of the grains.
template <class System>
snapshot take(const System& s, const std::vector<vector>& reference, double time) {
  snapshot shot;
  shot.time = time;
  const auto& g = s.particles();
  const auto view = s.view();
  const auto& book = s.bridges().book();
  std::vector<double> liquid(g.size(), 0.0);
  for (std::size_t p = 0; p < view.pairs; ++p) {
    if (!s.bridges().is_bonded(p)) continue;
    shot.bonds.push_back({view.id[view.grain_i(p)], view.id[view.grain_j(p)]});
    const vector branch = view.position[view.grain_j(p)] - view.position[view.grain_i(p)];
    shot.bond_force.push_back(-dot(s.contacts().force(p), branch) / norm(branch));
    shot.bond_volume.push_back(book.bonds()[p]);
    shot.bond_gap.push_back(view.gap(p));
    liquid[view.grain_i(p)] += 0.5 * book.bonds()[p];
    liquid[view.grain_j(p)] += 0.5 * book.bonds()[p];
  }
  std::size_t id = 0;
  for (const std::size_t row : g.rows_by_id()) {
    const vector x = view.position[row], moved = x - reference[id++];
    shot.x.push_back(x.x), shot.y.push_back(x.y), shot.z.push_back(x.z);
    shot.displacement_x.push_back(moved.x), shot.displacement_y.push_back(moved.y),
        shot.displacement_z.push_back(moved.z);
    shot.radius.push_back(view.radius[row]);
    shot.displacement.push_back(norm(moved));
    shot.liquid.push_back(liquid[row] + book.films()[row]);
  }
  return shot;
}

template <class Scene>
run_facts facts(const options& o, const Scene& scene, double began, double compression_began,
                std::size_t lines_before) {
  const auto& s = scene.sample();
  const auto view = s.view();
  run_facts f;
  f.wall_time = seconds() - began;
  f.compression_time = seconds() - compression_began;
  const double lines = static_cast<double>(scene.result().records.size() - lines_before);
  f.compression_steps = std::llround(lines * std::max(1.0, std::round(parameters(o).sample_interval / o.time_step)));
#ifdef _OPENMP
  f.threads = omp_get_max_threads();
#endif
  f.ruptures = s.events().ruptures;
  f.outside_capillary_law = s.bridges().outside().capillary_law;
  f.outside_rupture_law = s.bridges().outside().rupture_law;
  f.formations = s.events().formations;
  f.liquid_volume = s.bridges().book().introduced();
  f.mean_diameter = scene::mean_diameter(scene::compression_grading());
  for (std::size_t p = 0; p < view.pairs; ++p) {
    f.largest_bridge = std::max(f.largest_bridge, s.bridges().book().bonds()[p] / s.bridges().size_of(p, view));
  }
  for (const scene_limit& l : s.limits()) {
    f.limits.push_back(l.what + " " + pendular::detail::number(l.value) + ", bound " +
                       pendular::detail::number(l.bound) + (l.holds() ? "" : " BROKEN"));
  }
  f.energy_at_end = observe::energies_of(s);
  return f;
}

/// Runs one composition from wherever it is to the end.
template <class Material, class Liquid>
void run(const options& o, const Material& m, const Liquid& l, const restart& from, const scene::monitor& watch) {
  const double began = seconds();
  scene::simple_compression<Material, Liquid> scene(parameters(o), m, l);
  const bool later = from && from->template get<std::string>("scene.stage") != "deposit" &&
                     from->template get<std::string>("scene.stage") != "seal";
  if (later) {
    scene.resume(*from);
  } else {
    scene.start(prepare(o, from, watch));
  }
  const double shot_interval = o.snapshots > 0 ? o.duration / o.snapshots : 0;
  int shots = scene.compressing() && o.snapshots > 0
                  ? static_cast<int>(std::floor(scene.result().records.back().time / shot_interval + 1e-9)) + 1
                  : 0;
  double compression_began = seconds();
  std::size_t lines_before = scene.result().records.size();
  scene.look = [&](const auto& s, const scene::compression_result& r) {
    if (r.records.empty()) compression_began = seconds();
    const double time = r.records.empty() ? 0 : r.records.back().time;
    if (o.snapshots == 0 || time < shots * shot_interval - 1e-9) return;
    write_snapshot(o, take(s, r.reference, time), shots++);
  };
  scene.run(watch);
  const auto& result = scene.result();
  report(o, result, facts(o, scene, began, compression_began, lines_before));
  draw_sample(o, take(scene.sample(), result.reference, result.records.back().time),
              boundary::get<1>(scene.sample().walls()).shape.point.z);
}

/// Liquid of a broken bridge stays on its grains: `protocol::none` as one of several.
struct stay_on_grains {
  double offer(const bond_side&) const { return 0; }
  double merge(double, double) const { return 0; }
  double settle(double, double) const { return 0; }
  double pull(const bond_side&, double) const { return 0; }
};

using local_protocol = protocol::one_of<protocol::neighbours, protocol::grain_films, protocol::gravity, stay_on_grains>;

inline local_protocol chosen_protocol(const options& o) {
  if (o.protocol == "neighbours") return local_protocol(protocol::neighbours{});
  if (o.protocol == "grain-films") return local_protocol(protocol::grain_films{});
  if (o.protocol == "gravity") return local_protocol(protocol::gravity{});
  return local_protocol(stay_on_grains{});
}

template <class Material, class Law, class Rupture>
void with_law(const options& o, const Material& m, const Law& law, const Rupture& rupture, const restart& from,
              const scene::monitor& watch) {
  const auto go = [&](const auto& protocol) { run(o, m, liquid{water(o), law, rupture, protocol}, from, watch); };
  if (o.protocol != "homogeneous") return go(chosen_protocol(o));
  go(protocol::homogeneous{std::max<std::int64_t>(1, std::llround(5e-3 / o.time_step))});
}

/// Every law and protocol with one friction law.
template <class Friction>
void with_friction(const options& o, const Friction& friction, const restart& from, const scene::monitor& watch) {
  const material m{normal::linear{1e3}, damping::viscous{0.8}, friction, energy_book{}};
  if (o.law == "laplace-young") {
    return with_law(o, m, capillary::laplace_young(water(o)), rupture::laplace_young(water(o)), from, watch);
  }
  if (o.law == "richefeu-harmonic") {
    return with_law(o, m, capillary::richefeu_harmonic{}, rupture::lian{}, from, watch);
  }
  with_law(o, m, capillary::richefeu{}, rupture::lian{}, from, watch);
}

}  // namespace test
