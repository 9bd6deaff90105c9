// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/io/checkpoint.hpp>
#include <pendular/io/state/grains.hpp>
#include <pendular/io/state/liquid.hpp>
#include <pendular/io/state/parameters.hpp>
#include <pendular/io/state/rows.hpp>
#include <pendular/io/state/walls.hpp>

#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace pendular::io {

namespace detail {

template <class System>
std::string composition() {
  return __PRETTY_FUNCTION__;
}

}  // namespace detail

/// Writes the whole state of a system; call System::canonicalise() first, so that the run that goes on and the run that
/// is resumed take the same steps to the last bit.
template <class System>
void save(checkpoint_writer& out, const System& s) {
  static_assert(!System::is_part, "a checkpoint keeps a scene in one piece, not a part of it (docs/reference/host.md)");
  const auto& g = s.particles();
  const auto view = s.view();
  out.put("system.composition", std::string_view{detail::composition<System>()});
  detail::put_parameters(out, parameters_of(s));
  out.put("system.steps", s.step_count());
  out.put("system.time", s.time());
  out.put("system.clock", std::vector<double>{s.clock_began().time, static_cast<double>(s.clock_began().step)});
  out.put("system.next_id", g.next_id());
  out.put("grain.id", detail::by_id<pendular::column::id>(g));
  System::grains_type::for_each_column([&](auto column) {
    using tag = decltype(column);
    out.put(detail::record_of<tag>(), detail::by_id<tag>(g));
  });
  const auto pair_key = [&](std::size_t p, std::vector<std::int64_t>& keys) {
    keys.insert(keys.end(), {view.id[view.grain_i(p)], view.id[view.grain_j(p)]});
  };
  detail::put_rows(out, "pair.rows", s.contacts(), view.pairs, pair_key);
  detail::put_work(out, "pair", s.contacts());
  if constexpr (System::wet) detail::put_liquid(out, s);
  detail::put_walls(out, s);
  detail::put_driven(out, s.driven());
}

namespace detail {
/// Sets the clock and lists the neighbours, wide enough for the bridges that are still to be put back.
template <class System>
void list_again(const checkpoint_reader& in, System& s) {
  const auto steps = in.get<std::int64_t>("system.steps");
  const auto began = in.get<std::vector<double>>("system.clock", 2);
  expect_count("steps", steps);
  if (!(began[1] >= 0 && began[1] <= static_cast<double>(steps)) || !std::isfinite(began[0])) {
    refuse_content("its clock stands at step " + std::to_string(steps));
  }
  s.resume_at(steps, {began[0], static_cast<std::int64_t>(began[1])});
  const auto time = in.get<double>("system.time");
  if (!std::isfinite(time)) refuse_content("its time is " + pendular::detail::number(time) + " s");
  if (s.time() != time) s.resume_at(steps, {time, steps});  // another time step from here on
  if constexpr (System::wet) {
    get_films(in, s);
    const auto reach = in.get<double>("liquid.reach");
    if (!(reach >= 0 && std::isfinite(reach)))
      refuse_content("its bridges reach " + pendular::detail::number(reach) + " m");
    s.canonicalise(reach);
  } else {
    s.canonicalise();
  }
}

template <class System>
std::vector<std::string> load_into(const checkpoint_reader& in, System& s, winner wins) {
  if (in.get<std::string>("system.composition") != composition<System>()) {
    throw std::runtime_error("the checkpoint was written by a scene of other laws, protocol or walls: resume with the "
                             "options it was started with");
  }
  std::vector<std::string> differing = settle_parameters(in, s, wins);
  const std::vector<parameter> of_walls = wall_parameters(s);
  get_grains(in, s.particles());
  get_walls(in, s);
  if (wins == winner::program) take_parameters(s, of_walls);
  get_driven(in, s);
  get_work(in, "pair", s.contacts());
  list_again(in, s);
  const row_index rows(s.particles());
  if constexpr (System::wet) get_bridges(in, s, rows);
  const auto view = s.view();
  const auto pair_row = [&](const std::int64_t* key) { return pair_of(s, view, rows, key); };
  get_rows(in, "pair.rows", s.contacts(), 2, pair_row);
  get_wall_rows(in, s, rows);
  s.expect_limits();
  return differing;
}
}  // namespace detail

/// Puts the state back into a system of the same composition that has no grains yet. Answers one line for every parameter
/// that differs; without a winner these are an error.
/// Errors: std::runtime_error for a checkpoint of another composition, of other parameters or with content that does not
/// fit, input_error for one that breaks a limit. The system is then as it was.
template <class System>
std::vector<std::string> load(const checkpoint_reader& in, System& s, winner wins = winner::nobody) requires requires {
  typename System::rows_type;
}
{
  static_assert(!System::is_part, "a checkpoint is read into a scene in one piece (docs/reference/host.md)");
  pendular::expects(s.particles().size() == 0, "the number of grains of a system into which a checkpoint is read",
                    static_cast<double>(s.particles().size()), "0", "docs/how-to/resume.md");
  System loaded = s;
  std::vector<std::string> differing = detail::load_into(in, loaded, wins);
  s = std::move(loaded);
  return differing;
}

}  // namespace pendular::io
