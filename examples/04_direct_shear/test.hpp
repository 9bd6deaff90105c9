// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "report.hpp"
#include "run.hpp"

#include "../common/composition.hpp"
#include "../common/observed.hpp"

#include <pendular/scene/direct_shear.hpp>

#include <algorithm>
#include <cmath>
#include <string>

namespace test {

using namespace pendular;

inline scene::shear_parameters parameters(const options& o) {
  scene::shear_parameters p;
  p.cell_radius = o.cell_radius();
  p.normal_stress = o.normal_stress;
  p.water_content = o.water_content;
  p.solid_fraction = o.solid_fraction;
  p.shear_speed = o.shear_speed;
  p.displacement = o.displacement;
  p.time_step = o.time_step;
  p.mass_scaling = o.mass_scaling;
  p.sample_interval = std::min(p.sample_interval, o.displacement / 20);
  p.selection = o.selection(o.seed);
  p.numerics = {.skin = o.skin, .force = o.force};
  return p;
}

/// A scene that starts or goes on, observed.
template <class Scene>
class job {
 public:
  job(const options& o, Scene& scene)
      : options_(o), scene_(scene), watch_(o, o.displacement, way_of(scene.result()), scene.result().records.size()) {
    scene.look = [this](const auto& s, const scene::shear_result& r) { this->look(s, r); };
  }

  void run(const scene::monitor& watch) {
    scene_.run(watch);
    const auto& result = scene_.result();
    draw_sample(options_, examples::take(scene_.sample(), result.reference, result.records.back().time),
                result.records.back().height);
    report(options_, result, facts());
  }

 private:
  static double way_of(const scene::shear_result& r) { return r.records.empty() ? 0 : r.records.back().displacement; }

  template <class System>
  void look(const System& s, const scene::shear_result& r) {
    if (r.records.empty()) watch_.test_begins();
    watch_.look(s, r.reference, way_of(r), way_of(r) / options_.shear_speed);
  }

  examples::run_facts facts() const {
    const scene::shear_result& r = scene_.result();
    examples::run_facts f = examples::facts_of(scene_.sample());
    watch_.put(f, r.records.size(), parameters(options_).sample_interval / options_.shear_speed, options_.time_step);
    f.mean_diameter = scene::mean_diameter(options_.grain_sizes());
    for (const auto& line : r.records) f.worst_liquid = std::max(f.worst_liquid, std::abs(line.liquid - 1));
    f.imbalance = r.records.back().energy.imbalance;
    f.turnover = r.records.back().energy.turnover;
    f.energy_at_start = r.energy_at_start;
    f.departures = options_.departures();
    if (r.sample.solid_fraction < options_.solid_fraction) {
      f.departures.push_back("solid fraction: " + std::to_string(r.sample.solid_fraction).substr(0, 6) +
                             " after all of the consolidation, not " +
                             std::to_string(options_.solid_fraction).substr(0, 6));
    }
    return f;
  }

  const options& options_;
  Scene& scene_;
  examples::observed watch_;
};

template <class Friction>
auto materials(const options& o, const Friction& friction) {
  const auto with = [&](double coefficient) {
    Friction f = friction;
    f.friction_coefficient = coefficient;
    return examples::contact(o, f);
  };
  return scene::shear_materials{with(0), examples::contact(o, friction), with(o.wall_friction), with(o.plate_friction)};
}

/// Runs one composition from wherever it is to the end.
template <class Friction, class Liquid>
void run(const options& o, const Friction& friction, const Liquid& l, const examples::restart& from,
         const scene::monitor& watch) {
  scene::direct_shear scene(parameters(o), materials(o, friction), l);
  if (examples::begin(scene, o, from, [&] { return prepare(o, from, watch); })) job(o, scene).run(watch);
}

template <class Friction, class Law, class Rupture>
void with_usual_protocol(const options& o, const Friction& friction, const Law& law, const Rupture& rupture,
                         const examples::restart& from, const scene::monitor& watch) {
  run(o, friction, liquid{examples::water(o), law, rupture, protocol::grain_films{}}, from, watch);
}

/// Both kinds of protocol with one composition.
template <class Friction, class Law, class Rupture>
void with_laws(const options& o, const Friction& friction, const Law& law, const Rupture& rupture,
               const examples::restart& from, const scene::monitor& watch) {
  examples::with_protocol(o, law, rupture, [&](const auto& liquid) { run(o, friction, liquid, from, watch); });
}

}  // namespace test
