// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/liquid/protocol/concepts.hpp>

#include <type_traits>
#include <utility>
#include <variant>

namespace pendular::protocol {

namespace detail {
template <class P>
inline constexpr bool wants_gravity = requires {
  requires P::needs_gravity;
};
}  // namespace detail

/// One of some local protocols, chosen when the program runs: a program with an option for it compiles one scene instead
/// of one for each. Protocols are asked only where bridges break or form, so the choice costs nothing per step.
template <LocalProtocol... Protocols>
class one_of {
  template <class P>
  struct offer_by {
    decltype(std::declval<P>().offer(bond_side{})) value;
  };
  template <class P>
  struct grant_by {
    decltype(std::declval<P>().settle(std::declval<P>().offer(bond_side{}), 0.0)) value;
  };
  using offers = std::variant<offer_by<Protocols>...>;
  using grants = std::variant<grant_by<Protocols>...>;

 public:
  static constexpr bool needs_gravity = (detail::wants_gravity<Protocols> || ...);

  template <class P>
    requires(std::is_same_v<P, Protocols> || ...)
  explicit one_of(const P& chosen) : chosen_(chosen) {}

  offers offer(const bond_side& side) const {
    return ask([&]<class P>(const P& p) -> offers { return offer_by<P>{p.offer(side)}; });
  }
  offers merge(const offers& a, const offers& b) const {
    return ask([&]<class P>(const P& p) -> offers {
      return offer_by<P>{p.merge(std::get<offer_by<P>>(a).value, std::get<offer_by<P>>(b).value)};
    });
  }
  grants settle(const offers& merged, double film) const {
    return ask([&]<class P>(const P& p) -> grants {
      return grant_by<P>{p.settle(std::get<offer_by<P>>(merged).value, film)};
    });
  }
  double pull(const bond_side& side, const grants& granted) const {
    return ask([&]<class P>(const P& p) -> double { return p.pull(side, std::get<grant_by<P>>(granted).value); });
  }

 private:
  template <class Question>
  auto ask(const Question& question) const {
    return std::visit(question, chosen_);
  }

  std::variant<Protocols...> chosen_;
};

}  // namespace pendular::protocol
