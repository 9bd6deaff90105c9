// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/boundary/wall_contacts.hpp>

#include <tuple>
#include <type_traits>

namespace pendular::detail {

template <class>
inline constexpr bool always_false = false;

template <class Wall, class Material>
using wall_material =
    std::conditional_t<std::is_same_v<decltype(Wall::material), none>, Material, decltype(Wall::material)>;

template <class Material, class Bonds, class Walls>
struct wall_contacts_of {
  static_assert(always_false<Walls>, "a system needs its walls between material or liquid and integrator, such as "
                                     "boundary::walls{} (docs/reference/boundary.md)");
  using type = std::tuple<>;
};
template <class Material, class Bonds, class... W>
struct wall_contacts_of<Material, Bonds, boundary::walls<W...>> {
  static_assert(((!wall_material<W, Material>::has_friction || Material::has_friction) && ...),
                "a wall with friction needs grains with friction, which alone can turn (docs/reference/boundary.md)");
  static_assert(((!wall_material<W, Material>::counts_contacts || Material::counts_contacts) && ...),
                "a wall with friction::viscous_coulomb needs grains with it too, because it counts their contacts "
                "(docs/reference/boundary.md)");
  using type = std::tuple<boundary::wall_contacts<W, wall_material<W, Material>, Bonds, Material::has_friction,
                                                  Material::keeps_energy_book>...>;
};

}  // namespace pendular::detail
