// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/laplace_young/law.hpp>
#include <pendular/law/all.hpp>
#include <pendular/law/prepared.hpp>

#include <boost/hana/append.hpp>
#include <boost/hana/for_each.hpp>

#include <string>
#include <string_view>
#include <type_traits>
#include <typeinfo>

#ifdef __GNUG__
#include <cxxabi.h>

#include <cstdlib>
#include <memory>
#endif

// Who is judged: every capillary and rupture law of law/all.hpp, and those of the table. Your own law is one line more.
namespace contenders {

inline constexpr auto capillary_laws =
    boost::hana::append(pendular::law::capillary_laws, boost::hana::type_c<pendular::capillary::laplace_young>);
inline constexpr auto rupture_laws =
    boost::hana::append(pendular::law::rupture_laws, boost::hana::type_c<pendular::rupture::laplace_young>);

/// A law for a fluid, whether it needs one to be made or not.
template <class Law>
Law make(const pendular::fluid& f) {
  if constexpr (std::is_constructible_v<Law, const pendular::fluid&> && !std::is_aggregate_v<Law>) {
    return Law(f);
  } else {
    return Law{};
  }
}

/// Its name without namespaces.
template <class Law>
std::string name_of() {
  if constexpr (std::is_same_v<Law, pendular::capillary::richefeu>) return "richefeu";
  if constexpr (std::is_same_v<Law, pendular::capillary::richefeu_harmonic>) return "richefeu_harmonic";
  std::string name = typeid(Law).name();
#ifdef __GNUG__
  int status = 0;
  const std::unique_ptr<char, void (*)(void*)> readable(abi::__cxa_demangle(name.c_str(), nullptr, nullptr, &status),
                                                        std::free);
  if (status == 0) name = readable.get();
#endif
  return name.substr(name.rfind(':') + 1);
}

/// use(name, law) for all of a list.
template <class List, class Use>
void for_each(const List& laws, const pendular::fluid& f, const Use& use) {
  boost::hana::for_each(laws, [&]<class L>(L) {
    using law = typename L::type;
    use(name_of<law>(), make<law>(f));
  });
}

template <class Law>
double pull(const Law& law, const pendular::bridge<double>& b, const pendular::fluid& f) {
  return pendular::attraction(law, b.gap, pendular::prepare(law, b, f), f);
}

}  // namespace contenders
