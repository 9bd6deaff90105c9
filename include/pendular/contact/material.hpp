// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/contact/energy_book.hpp>
#include <pendular/contact/memory.hpp>
#include <pendular/core/bundle.hpp>
#include <pendular/law/check.hpp>

#include <tuple>
#include <type_traits>

namespace pendular {

namespace detail {
inline constexpr auto plays_normal = []<class P>() { return NormalLaw<P>; };
inline constexpr auto plays_damping = []<class P>() { return DampingLaw<P>; };
inline constexpr auto plays_friction = []<class P>() { return FrictionLaw<P>; };
inline constexpr auto plays_book = []<class P>() { return std::is_same_v<P, energy_book>; };

template <class P>
inline constexpr bool plays_in_material =
    NormalLaw<P> || DampingLaw<P> || FrictionLaw<P> || std::is_same_v<P, energy_book> || std::is_same_v<P, none>;

/// Stops the compilation with the sentence of its ladder at a law that is one in double alone.
template <class P>
consteval bool climbs_its_ladder() {
  if constexpr (NormalLaw<P>) {
    return check::normal_law<P>;
  } else if constexpr (DampingLaw<P>) {
    return check::damping_law<P>;
  } else if constexpr (FrictionLaw<P>) {
    return check::friction_law<P>;
  } else {
    return true;
  }
}
}  // namespace detail

/// The dry contact of two grains: one normal law, and at most one damping law, one friction law and an `energy_book`,
/// in any order.
template <class... Policies>
class material {
  static_assert((detail::plays_in_material<Policies> && ...),
                "every policy of a material must be a normal, damping or friction law, energy_book or none; "
                "check::normal_law<my_law> says what yours lacks (docs/reference/material.md)");
  static_assert(detail::players<detail::plays_normal, Policies...>() == 1,
                "a material needs exactly one normal law, such as normal::linear{1e3} (docs/reference/material.md)");
  static_assert(detail::players<detail::plays_damping, Policies...>() <= 1,
                "a material takes at most one damping law (docs/reference/material.md)");
  static_assert(detail::players<detail::plays_friction, Policies...>() <= 1,
                "a material takes at most one friction law (docs/reference/material.md)");
  static_assert((detail::climbs_its_ladder<Policies>() && ...));

 public:
  using normal_law = detail::player_t<detail::plays_normal, Policies...>;
  using damping_law = detail::player_t<detail::plays_damping, Policies...>;
  using friction_law = detail::player_t<detail::plays_friction, Policies...>;

  static constexpr bool has_damping = DampingLaw<damping_law>;
  static constexpr bool has_friction = FrictionLaw<friction_law>;
  static constexpr bool prepares_dashpot =
      detail::PreparesDashpot<damping_law> && !detail::ResistsBeside<damping_law, double> && requires {
    requires normal_law::has_constant_stiffness;
  };
  static constexpr bool has_memory = (detail::Remembers<Policies, double> || ...);
  static constexpr bool counts_contacts = requires { requires friction_law::counts_contacts; };
  static constexpr bool keeps_energy_book = detail::players<detail::plays_book, Policies...>() > 0;

  template <class T>
  using memory = pair_memory<T, Policies...>;

  constexpr explicit material(Policies... policies) : policies_(policies...) {
    const auto validate_one = [](const auto& policy) {
      if constexpr (requires { validate(policy); }) validate(policy);
    };
    std::apply([&](const auto&... policy) { (validate_one(policy), ...); }, policies_);
  }

  /// visit(policy) in the order they were given.
  template <class Visit>
  void for_each_policy(const Visit& visit) const {
    std::apply([&](const auto&... policy) { (visit(policy), ...); }, policies_);
  }

  const normal_law& normal() const { return detail::player<detail::plays_normal>(policies_); }
  const damping_law& damping() const { return detail::player<detail::plays_damping>(policies_); }
  const friction_law& friction() const { return detail::player<detail::plays_friction>(policies_); }

 private:
  std::tuple<Policies...> policies_;
};

template <class... Policies>
material(Policies...) -> material<Policies...>;

}  // namespace pendular
