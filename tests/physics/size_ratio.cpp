// SPDX-License-Identifier: BSD-3-Clause

// Friction between grains of very different size: where half-step velocities hold a grain that should fall (Vyas et al.
// 2025) and synchronised ones do not.
#include "between_spheres.hpp"

#include <array>

using namespace between_spheres;

TEST_CASE("with synchronised velocities a small sphere falls off two large ones where a rigid one does") {
  for (const double ratio : {1.0, 3.0, 10.0, 30.0}) {
    const wedge w{ratio, 0.5};
    const fall f = fallen<velocity_verlet>(w, 25);
    CAPTURE(ratio, f.angle, rigid_fall(w));
    CHECK(f.angle == near(0.03, rigid_fall(w)));
    CHECK(f.held_force < 2);
  }
}

TEST_CASE("with half-step velocities it falls off late by an error of first order where friction cannot hold it") {
  for (const double ratio : {1.0, 3.0}) {
    const wedge w{ratio, 0.5};
    REQUIRE(w.mu < w.ring() / w.held());  // the wedge is too open
    const double exact = rigid_fall(w);
    const std::array<double, 2> late{fallen<half_step_velocity_verlet>(w, 25).angle - exact,
                                     fallen<half_step_velocity_verlet>(w, 50).angle - exact};
    CAPTURE(ratio, late);
    CHECK(late[0] > 0.3);
    CHECK(late[0] < 0.7);
    CHECK(late[0] / late[1] == near(0.4, 2.0));
  }
}

TEST_CASE("with half-step velocities it never falls off where friction can hold a wedge") {
  // The slip of half a step ago measured against the normal of now has a part out of the wedge, v theta' dt / 2, at
  // every step; the springs add it up and press the sphere in, at any size ratio where the tangent of
  // the wedge, ring / held, is below mu.
  for (const wedge& w : {wedge{10, 0.5}, wedge{30, 0.5}, wedge{1, 2.0}}) {
    REQUIRE(w.mu > w.ring() / w.held());
    const fall f = fallen<half_step_velocity_verlet>(w, 25);
    CAPTURE(w.size_ratio, f.angle, f.held_force);
    CHECK(std::isinf(f.angle));
    CHECK(f.held_force > 100);
    CHECK(fallen<velocity_verlet>(w, 25).angle == near(0.03, rigid_fall(w)));
  }
}
