// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../catch.hpp"
#include "../io/scratch.hpp"

#include <pendular/io/checkpoint.hpp>
#include <pendular/io/system_state.hpp>

#include <cstdint>

/// A fresh scene with the state of another, through a checkpoint; both go on with the same bits.
template <class System>
System resumed(System& s, System fresh) {
  const scratch::folder folder;
  s.canonicalise();
  {
    pendular::io::checkpoint_writer out(folder / "state");
    pendular::io::save(out, s);
    out.commit();
  }
  pendular::io::load(pendular::io::checkpoint_reader(folder / "state"), fresh);
  return fresh;
}

/// After so many steps, a resume and as many again both show the same.
template <class System, class Look>
void check_resume(System& s, const System& fresh, std::int64_t steps, const Look& look) {
  s.run(steps);
  auto again = resumed(s, fresh);
  CHECK(look(again) == look(s));
  s.run(steps);
  again.run(steps);
  CHECK(look(again) == look(s));
}
