// SPDX-License-Identifier: BSD-3-Clause
// Bytes per pair and per grain of scenes that differ in one choice each: the table of docs/reference/system.md.
#include <pendular/law/all.hpp>
#include <pendular/liquid/protocol/all.hpp>
#include <pendular/observe/bytes.hpp>
#include <pendular/system.hpp>

#include <string_view>

using namespace pendular;

namespace {

using spring = normal::linear;
using dashpot = damping::viscous;
using floor_only = boundary::walls<boundary::wall<boundary::plane>>;
using wet_floor = boundary::walls<boundary::wall<boundary::plane, boundary::fixed, none, boundary::wettable>>;
template <class Material, class Liquid = dry, class Walls = floor_only, class... Tags>
using scene = pendular::system<Material, Liquid, Walls, velocity_verlet, alone, Tags...>;
template <class Law, class... More>
using water = liquid<fluid, Law, rupture::willett, More...>;

struct temperature {
  using type = double;
  static constexpr std::string_view label = "temperature", unit = "K";
};

using smooth = material<spring, dashpot>;
using cundall = material<spring, dashpot, friction::coulomb_spring>;
using paper = material<spring, dashpot, friction::viscous_coulomb>;

template <class Scene>
constexpr bool takes(std::size_t per_pair, std::size_t per_grain, std::size_t per_grain_at_wall) {
  return observe::bytes_per_pair<Scene> == per_pair && observe::bytes_per_grain<Scene> == per_grain &&
         observe::bytes_per_grain_at_wall<Scene> == per_grain_at_wall;
}

// Dry: list 16 of a pair and 4 at a wall, what acts 32 or 64, gap 8; a load at a wall is one more that acts.
static_assert(takes<scene<material<spring>>>(56, 156, 76));
static_assert(takes<scene<smooth>>(64, 156, 84));                                        // a dashpot
static_assert(takes<scene<material<normal::hertz, dashpot>>>(64, 156, 84));              // a mass
static_assert(takes<scene<material<spring, friction::coulomb_spring>>>(120, 220, 172));  // mass and spring
static_assert(takes<scene<cundall>>(128, 220, 180));                                     // and dashpot
static_assert(takes<scene<paper>>(128, 220, 180));                                       // counts its contacts
static_assert(takes<scene<material<spring, dashpot, friction::viscous_coulomb_explicit>>>(104, 220, 156));
static_assert(takes<scene<material<spring, dashpot, friction::coulomb_spring, energy_book>>>(176, 220, 228));
static_assert(takes<scene<cundall, dry, floor_only, temperature>>(128, 228, 180));

// Wet: 24 and the coefficients of the law per pair, and 8 where bridges form on closing; a film of 8 per grain.
static_assert(takes<scene<paper, water<capillary::richefeu>>>(168, 228, 180));
static_assert(takes<scene<paper, water<capillary::richefeu, protocol::neighbours>>>(176, 228, 180));
static_assert(takes<scene<paper, water<capillary::richefeu, protocol::homogeneous>>>(168, 228, 180));
static_assert(takes<scene<paper, water<capillary::richefeu, protocol::grain_films>>>(176, 228, 180));
static_assert(takes<scene<paper, water<capillary::willett_closed_form, protocol::grain_films>, wet_floor>>(192, 228,
                                                                                                           244));
static_assert(takes<scene<paper, water<capillary::richefeu, viscous::lubrication>>>(168, 228, 180));
static_assert(takes<scene<cundall, water<capillary::willett_closed_form>>>(184, 228, 180));
static_assert(takes<scene<cundall, water<capillary::willett>>>(192, 228, 180));
static_assert(takes<scene<smooth, water<capillary::richefeu>>>(104, 164, 84));

// What a row of four numbers has beside a vector is there to fill its 32 bytes, whoever asks for it: of a grain that has
// no contacts to be counted nothing could be left out.
struct alignas(32) vector_alone {
  vector v;
};
static_assert(sizeof(grain_row::spin) == sizeof(vector_alone) && sizeof(grain_row::force) == sizeof(vector_alone));
static_assert(sizeof(quad) == sizeof(vector_alone));

}  // namespace
