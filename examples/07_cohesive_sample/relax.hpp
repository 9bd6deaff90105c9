// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "microstructure.hpp"
#include "report.hpp"
#include "run.hpp"

#include "../common/composition.hpp"
#include "../common/observed.hpp"

#include <pendular/law/capillary/richefeu.hpp>
#include <pendular/law/rupture/lian.hpp>
#include <pendular/scene/cohesive_sample.hpp>

#include <algorithm>
#include <cmath>
#include <string>

namespace relax {

using namespace pendular;

inline scene::cohesive_parameters parameters(const options& o) {
  scene::cohesive_parameters p;
  p.water_content = o.water_content;
  p.confining_pressure = o.confining_pressure;
  p.relaxation = o.relaxation;
  p.unbalanced_force = o.unbalanced_force;
  p.time_step = o.time_step;
  p.mass_scaling = o.mass_scaling;
  p.selection = o.selection(o.seed);
  p.numerics = {.skin = o.skin, .force = o.force};
  return p;
}

/// A scene that starts or goes on, observed.
template <class Scene>
class job {
 public:
  job(const options& o, Scene& scene)
      : options_(o), scene_(scene), watch_(o, o.relaxation, time_of(scene.result()), scene.result().records.size()) {
    scene.look = [this](const auto& s, const scene::cohesive_result& r) {
      if (r.records.empty()) watch_.test_begins();
      watch_.look(s, r.reference, time_of(r), time_of(r));
    };
  }

  void run(const scene::monitor& watch) {
    const scene::cohesive_result& result = scene_.run(watch);
    report(options_, result, microstructure_of(scene_.sample(), result.end, options_.largest_pull()), facts());
  }

 private:
  static double time_of(const scene::cohesive_result& r) { return r.records.empty() ? 0 : r.records.back().time; }

  examples::run_facts facts() const {
    const scene::cohesive_result& r = scene_.result();
    examples::run_facts f = examples::facts_of(scene_.sample());
    watch_.put(f, r.records.size(), parameters(options_).sample_interval, options_.time_step);
    f.mean_diameter = options_.mean_diameter();
    for (const auto& line : r.records) f.worst_liquid = std::max(f.worst_liquid, std::abs(line.liquid - 1));
    f.imbalance = r.records.back().energy.imbalance;
    f.turnover = r.records.back().energy.turnover;
    f.energy_at_start = r.energy_at_start;
    f.departures = options_.departures();
    if (!scene_.at_rest()) f.departures.push_back("rest: not reached within the time of the relaxation");
    return f;
  }

  const options& options_;
  Scene& scene_;
  examples::observed watch_;
};

/// Runs one composition from wherever it is to the end.
template <class Friction, class Liquid>
void run(const options& o, const Friction& friction, const Liquid& l, const examples::restart& from,
         const scene::monitor& watch) {
  const material walls{normal::linear{o.stiffness}, damping::viscous{0.8}, energy_book{}};
  scene::cohesive_sample scene(parameters(o), examples::contact(o, friction), walls, l);
  const bool relaxing = from && from->template get<std::string>("scene.stage") == "relax";
  if (relaxing && !o.packing_only) scene.resume(*from);
  if (!relaxing) {
    const scene::boxed_packing packing = prepare(o, from, watch);
    if (!o.packing_only) scene.start(packing);
  }
  if (!o.packing_only) job(o, scene).run(watch);
}

/// Protocols that know no up and down: those of `examples::local_protocol` without the paper's P3.
using local_protocol = protocol::one_of<protocol::neighbours, protocol::grain_films, examples::stay_on_grains>;

inline local_protocol chosen_protocol(const options& o) {
  if (o.protocol == "neighbours") return local_protocol(protocol::neighbours{});
  if (o.protocol == "grain-films") return local_protocol(protocol::grain_films{});
  return local_protocol(examples::stay_on_grains{});
}

/// Both kinds of protocol with one friction law.
template <class Friction>
void with_friction(const options& o, const Friction& friction, const examples::restart& from,
                   const scene::monitor& watch) {
  const auto go = [&](const auto& protocol) {
    run(o, friction, liquid{examples::water(o), capillary::richefeu{}, rupture::lian{}, protocol}, from, watch);
  };
  o.protocol == "homogeneous" ? go(examples::chosen_period(o)) : go(chosen_protocol(o));
}

}  // namespace relax
