// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/boundary/check.hpp>
#include <pendular/boundary/wall_contacts.hpp>

#include <tuple>
#include <type_traits>

namespace pendular::detail {

template <class Wall, class Material>
using wall_material =
    std::conditional_t<std::is_same_v<decltype(Wall::material), none>, Material, decltype(Wall::material)>;

/// The contacts of each wall in a tuple of them.
template <class Material, class Bonds, class Walls>
struct contacts_of_each;
template <class Material, class Bonds, class... W>
struct contacts_of_each<Material, Bonds, std::tuple<W...>> {
  static_assert(((!wall_material<W, Material>::has_friction || Material::has_friction) && ...),
                "a wall with friction needs grains with friction, which alone can turn (docs/reference/boundary.md)");
  static_assert(((!wall_material<W, Material>::counts_contacts || Material::counts_contacts) && ...),
                "a wall with friction::viscous_coulomb needs grains with it too, because it counts their contacts "
                "(docs/reference/boundary.md)");
  using type = std::tuple<boundary::wall_contacts<W, wall_material<W, Material>, Bonds, Material::has_friction,
                                                  Material::keeps_energy_book>...>;
};

template <class Material, class Bonds, class Boundary>
struct wall_contacts_of {
  static_assert(check::boundary<Boundary>);
  using type = std::tuple<>;
};
template <class Material, class Bonds, boundary::Boundary Boundary>
struct wall_contacts_of<Material, Bonds, Boundary>
    : contacts_of_each<Material, Bonds,
                       typename boundary::detail::parts_in<boundary::detail::parts_t<Boundary>>::type> {
  static_assert(check::boundary<Boundary>);
};

}  // namespace pendular::detail
