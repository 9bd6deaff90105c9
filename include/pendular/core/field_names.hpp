// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/fields.hpp>

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <type_traits>

namespace pendular {

namespace detail {
// A name is read out of how the compiler writes the address of a member of an object that is declared and never there.
template <class T>
struct kept {
  T value;
};
#ifdef __clang__
#pragma clang diagnostic push
#pragma clang diagnostic ignored "-Wundefined-var-template"
#pragma clang diagnostic ignored "-Wundefined-internal"  // of types in unnamed namespaces
#endif
template <class T>
extern const kept<T> nowhere;

template <class T>
struct address {
  const T* of;
};
template <class T>
address(const T*) -> address<T>;

template <auto Address>
consteval std::string_view signature_with() {
  return __PRETTY_FUNCTION__;
}
template <class T>
consteval std::string_view signature_of() {
  return __PRETTY_FUNCTION__;
}

/// g++ writes "... S::name)}; ...", clang++ "... .name}]".
template <auto Address>
consteval std::string_view member_name() {
  const std::string_view text = signature_with<Address>();
#ifdef __clang__
  const std::size_t end = text.rfind('}');
#else
  const std::size_t end = text.find(")}");
#endif
  const std::size_t begin = text.find_last_of(".:", end) + 1;
  return text.substr(begin, end - begin);
}

template <class S>
consteval auto field_names_of() {
  constexpr std::size_t count = field_count<S>();
  if constexpr (count == 0) {
    return std::array<std::string_view, 0>{};
  } else if constexpr (count == 1) {
    const auto& [a] = nowhere<S>.value;
    return std::array{member_name<address{&a}>()};
  } else if constexpr (count == 2) {
    const auto& [a, b] = nowhere<S>.value;
    return std::array{member_name<address{&a}>(), member_name<address{&b}>()};
  } else if constexpr (count == 3) {
    const auto& [a, b, c] = nowhere<S>.value;
    return std::array{member_name<address{&a}>(), member_name<address{&b}>(), member_name<address{&c}>()};
  } else if constexpr (count == 4) {
    const auto& [a, b, c, d] = nowhere<S>.value;
    return std::array{member_name<address{&a}>(), member_name<address{&b}>(), member_name<address{&c}>(),
                      member_name<address{&d}>()};
  } else if constexpr (count == 5) {
    const auto& [a, b, c, d, e] = nowhere<S>.value;
    return std::array{member_name<address{&a}>(), member_name<address{&b}>(), member_name<address{&c}>(),
                      member_name<address{&d}>(), member_name<address{&e}>()};
  } else if constexpr (count == 6) {
    const auto& [a, b, c, d, e, f] = nowhere<S>.value;
    return std::array{member_name<address{&a}>(), member_name<address{&b}>(), member_name<address{&c}>(),
                      member_name<address{&d}>(), member_name<address{&e}>(), member_name<address{&f}>()};
  } else if constexpr (count == 7) {
    const auto& [a, b, c, d, e, f, g] = nowhere<S>.value;
    return std::array{member_name<address{&a}>(), member_name<address{&b}>(), member_name<address{&c}>(),
                      member_name<address{&d}>(), member_name<address{&e}>(), member_name<address{&f}>(),
                      member_name<address{&g}>()};
  } else {
    const auto& [a, b, c, d, e, f, g, h] = nowhere<S>.value;
    return std::array{member_name<address{&a}>(), member_name<address{&b}>(), member_name<address{&c}>(),
                      member_name<address{&d}>(), member_name<address{&e}>(), member_name<address{&f}>(),
                      member_name<address{&g}>(), member_name<address{&h}>()};
  }
}
#ifdef __clang__
#pragma clang diagnostic pop
#endif
}  // namespace detail

/// Names of the members of an aggregate of up to eight members, in order of declaration.
template <class S>
inline constexpr auto field_names = detail::field_names_of<S>();

/// Name of a type without the library's own namespace: "normal::linear".
template <class T>
constexpr std::string_view type_name() {
  constexpr std::string_view text = detail::signature_of<T>();
  constexpr std::string_view lead = "T = ";
  const std::size_t begin = text.find(lead) + lead.size();
  const std::size_t end = text.find_first_of(";]", begin);
  std::string_view name = text.substr(begin, end - begin);
  constexpr std::string_view ours = "pendular::";
  if (name.substr(0, ours.size()) == ours) name.remove_prefix(ours.size());
  return name;
}

/// visit("member", number) for every double or integer inside an aggregate, members of members as "member.its_member". What
/// is no aggregate of up to eight members is passed by.
template <class S, class Visit>
void for_each_named_number(const std::string& lead, S& s, Visit&& visit) {
  using plain = std::remove_cv_t<S>;
  if constexpr (std::is_arithmetic_v<plain>) {
    visit(lead, s);
  } else if constexpr (std::is_aggregate_v<plain> && std::is_class_v<plain>) {
    std::size_t k = 0;
    for_each_field(s, [&](auto& member) {
      const std::string name{field_names<plain>[k++]};
      for_each_named_number(lead.empty() ? name : lead + "." + name, member, visit);
    });
  }
}

}  // namespace pendular
