// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/bundle.hpp>
#include <pendular/core/copyable.hpp>
#include <pendular/core/expects.hpp>
#include <pendular/law/concepts.hpp>
#include <pendular/law/prepared.hpp>
#include <pendular/liquid/formation.hpp>
#include <pendular/liquid/protocol/concepts.hpp>
#include <pendular/liquid/protocol/none.hpp>
#include <pendular/liquid/source/concepts.hpp>

#include <concepts>
#include <tuple>
#include <type_traits>

namespace pendular {

/// Rule for the gap below which two wet grains are joined. With `needs_closing = true` only a pair that was not below it
/// in the step before is.
template <class F>
concept FormationRule = Copyable<F> && requires(const F rule, const double rupture_distance) {
  { rule.reach(rupture_distance) } -> std::convertible_to<double>;
  { rule.minimum_volume } -> std::convertible_to<double>;
};

namespace detail {
inline constexpr auto plays_fluid = []<class P>() { return std::is_same_v<P, fluid>; };
inline constexpr auto plays_capillary = []<class P>() { return CapillaryLaw<P>; };
inline constexpr auto plays_rupture = []<class P>() { return RuptureLaw<P>; };
inline constexpr auto plays_viscous = []<class P>() { return ViscousBridgeLaw<P>; };
inline constexpr auto plays_formation = []<class P>() { return FormationRule<P>; };
inline constexpr auto plays_protocol = []<class P>() { return Protocol<P>; };
inline constexpr auto plays_source = []<class P>() { return Source<P>; };

template <class P>
inline constexpr bool plays_in_liquid =
    std::is_same_v<P, fluid> || CapillaryLaw<P> || RuptureLaw<P> || ViscousBridgeLaw<P> || FormationRule<P> ||
    Protocol<P> || Source<P> || std::is_same_v<P, none>;

template <class Given, class Default>
using given_or = std::conditional_t<std::is_same_v<Given, none>, Default, Given>;
}  // namespace detail

/// Errors: input_error for a policy of a liquid with a parameter out of bounds.
template <class P>
constexpr void check_policy(const P& policy) {
  if constexpr (requires { validate(policy); }) validate(policy);
  if constexpr (Source<P> || GlobalProtocol<P>) {
    expects(policy.period > 0, "the period of a source or global protocol (steps)", static_cast<double>(policy.period),
            "at least 1", "docs/reference/liquid.md");
  }
}

/// The wet side of a scene: fluid, capillary law and rupture law, and at most one viscous bridge law, one formation rule
/// and one redistribution protocol, and any number of sources and sinks, in any order. Without a protocol the liquid of a
/// broken bond stays on its grains; without a rule bridges form within the rupture distance under a global protocol and at
/// contact otherwise.
template <class... Policies>
class liquid {
  static_assert((detail::plays_in_liquid<Policies> && ...),
                "every policy of a liquid must be a fluid, a capillary, rupture or viscous bridge law, a formation "
                "rule, a protocol, a source or none; check::capillary_law<my_law> says what yours lacks "
                "(docs/reference/liquid.md)");
  static_assert(detail::players<detail::plays_fluid, Policies...>() == 1,
                "a liquid needs exactly one fluid, such as fluid::water() (docs/reference/liquid.md)");
  static_assert(detail::players<detail::plays_capillary, Policies...>() == 1,
                "a liquid needs exactly one capillary law, such as capillary::richefeu{} (docs/reference/liquid.md)");
  static_assert(detail::players<detail::plays_rupture, Policies...>() == 1,
                "a liquid needs exactly one rupture law, such as rupture::lian{} (docs/reference/liquid.md)");
  static_assert(detail::players<detail::plays_viscous, Policies...>() <= 1,
                "a liquid takes at most one viscous bridge law (docs/reference/liquid.md)");
  static_assert(detail::players<detail::plays_formation, Policies...>() <= 1,
                "a liquid takes at most one formation rule (docs/reference/liquid.md)");
  static_assert(detail::players<detail::plays_protocol, Policies...>() <= 1,
                "a liquid takes at most one redistribution protocol (docs/reference/liquid.md)");

 public:
  using capillary_law = detail::player_t<detail::plays_capillary, Policies...>;
  using rupture_law = detail::player_t<detail::plays_rupture, Policies...>;
  using viscous_law = detail::player_t<detail::plays_viscous, Policies...>;
  using protocol_type = detail::player_t<detail::plays_protocol, Policies...>;  // or none
  using formation_rule = detail::given_or<
      detail::player_t<detail::plays_formation, Policies...>,
      std::conditional_t<GlobalProtocol<protocol_type>, formation::within_rupture_distance, formation::at_contact>>;

  static constexpr bool is_viscous = ViscousBridgeLaw<viscous_law>;
  static constexpr bool redistributes_locally = LocalProtocol<protocol_type>;
  static constexpr bool forms_on_closing = redistributes_locally && requires {
    requires formation_rule::needs_closing;
  };
  static constexpr bool redistributes_globally = GlobalProtocol<protocol_type>;
  static constexpr bool has_sources = detail::players<detail::plays_source, Policies...>() > 0;
  static constexpr bool needs_gravity = requires { requires protocol_type::needs_gravity; };

  constexpr explicit liquid(Policies... policies) : policies_(policies...) { check(); }

  /// Errors: input_error for a policy with a parameter out of bounds, or one that was made for another fluid.
  constexpr void check() const {
    std::apply([&](const auto&... policy) { (check_policy(policy), ...); }, policies_);
    const auto match_one = [&](const auto& policy) {
      if constexpr (requires { policy.expect_fluid(substance()); }) policy.expect_fluid(substance());
    };
    std::apply([&](const auto&... policy) { (match_one(policy), ...); }, policies_);
  }

  const fluid& substance() const { return detail::player<detail::plays_fluid>(policies_); }
  const capillary_law& law() const { return detail::player<detail::plays_capillary>(policies_); }
  const viscous_law& viscous() const requires(ViscousBridgeLaw<viscous_law>) {
    return detail::player<detail::plays_viscous>(policies_);
  }
  const rupture_law& rupture() const { return detail::player<detail::plays_rupture>(policies_); }
  protocol_type redistribution() const { return detail::player<detail::plays_protocol>(policies_); }
  formation_rule formation() const { return given<detail::plays_formation, formation_rule>(); }

  /// visit(policy) in the order they were given.
  template <class Visit>
  void for_each_policy(const Visit& visit) const {
    std::apply([&](const auto&... policy) { (visit(policy), ...); }, policies_);
  }

  /// visit(source) for all sources and sinks in the order they were given.
  template <class Visit>
  void for_each_source(const Visit& visit) const {
    const auto visit_one = [&]<class P>(const P& policy) {
      if constexpr (Source<P>) visit(policy);
    };
    std::apply([&](const auto&... policy) { (visit_one(policy), ...); }, policies_);
  }

  double rupture_distance(const bridge<double>& b) const { return rupture().distance(b, substance()); }

 private:
  template <auto Role, class Default>
  Default given() const {
    if constexpr (detail::players<Role, Policies...>() == 0) {
      return Default{};
    } else {
      return detail::player<Role>(policies_);
    }
  }

  std::tuple<Policies...> policies_;
};

template <class... Policies>
liquid(Policies...) -> liquid<Policies...>;

}  // namespace pendular
