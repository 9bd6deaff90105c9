// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "report.hpp"
#include "run.hpp"

#include "../common/composition.hpp"
#include "../common/observed.hpp"

#include <pendular/scene/simple_compression.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace test {

using namespace pendular;

inline scene::compression_parameters parameters(const options& o) {
  scene::compression_parameters p{std::numbers::pi * o.cylinder_radius() * o.cylinder_radius()};
  p.water_content = o.water_content;
  p.lid_speed = o.wall_speed;
  p.duration = o.duration;
  p.time_step = o.time_step;
  p.mass_scaling = o.mass_scaling;
  p.sample_interval = std::min(1e-6 / o.wall_speed, o.duration / 10);  // a line per micrometre
  p.selection = o.selection(o.seed);
  p.numerics = {.skin = o.skin, .force = o.force};
  p.relaxation = o.relaxation;
  return p;
}

/// A scene that starts or goes on, observed.
template <class Scene>
class job {
 public:
  job(const options& o, Scene& scene)
      : options_(o), scene_(scene), watch_(o, o.duration, way_of(scene.result()), scene.result().records.size()) {
    scene.look = [this](const auto& s, const scene::compression_result& r) { this->look(s, r); };
  }

  void run(const scene::monitor& watch) {
    scene_.run(watch);
    const auto& result = scene_.result();
    const auto last = examples::take(scene_.sample(), result.reference, result.records.back().time);
    draw_sample(options_, last, boundary::get<1>(scene_.sample().walls()).shape.point.z);
    report(options_, result, facts(), still_grains_of(last, result.records.back().shortening));
  }

 private:
  static double way_of(const scene::compression_result& r) { return r.records.empty() ? 0 : r.records.back().time; }

  template <class System>
  void look(const System& s, const scene::compression_result& r) {
    if (r.records.empty()) watch_.test_begins();
    watch_.look(s, r.reference, way_of(r), way_of(r));
  }

  examples::run_facts facts() const {
    const scene::compression_result& r = scene_.result();
    examples::run_facts f = examples::facts_of(scene_.sample());
    watch_.put(f, r.records.size(), parameters(options_).sample_interval, options_.time_step);
    f.mean_diameter = scene::mean_diameter(scene::compression_grading());
    for (const auto& line : r.records) f.worst_liquid = std::max(f.worst_liquid, std::abs(line.liquid - 1));
    f.imbalance = r.records.back().imbalance;
    f.turnover = r.records.back().turnover;
    f.energy_at_start = r.energy_at_start;
    f.departures = options_.departures();
    return f;
  }

  const options& options_;
  Scene& scene_;
  examples::observed watch_;
};

/// Runs one composition from wherever it is to the end.
template <class Material, class Liquid>
void run(const options& o, const Material& m, const Liquid& l, const examples::restart& from,
         const scene::monitor& watch) {
  scene::simple_compression<Material, Liquid> scene(parameters(o), m, l);
  if (examples::begin(scene, o, from, [&] { return prepare(o, from, watch); })) job(o, scene).run(watch);
}

template <class Friction, class Law, class Rupture>
void with_usual_protocol(const options& o, const Friction& friction, const Law& law, const Rupture& rupture,
                         const examples::restart& from, const scene::monitor& watch) {
  run(o, examples::contact(o, friction), liquid{examples::water(o), law, rupture, examples::chosen_period(o)}, from,
      watch);
}

/// Both kinds of protocol with one composition.
template <class Friction, class Law, class Rupture>
void with_laws(const options& o, const Friction& friction, const Law& law, const Rupture& rupture,
               const examples::restart& from, const scene::monitor& watch) {
  const auto m = examples::contact(o, friction);
  examples::with_protocol(o, law, rupture, [&](const auto& liquid) { run(o, m, liquid, from, watch); });
}

}  // namespace test
