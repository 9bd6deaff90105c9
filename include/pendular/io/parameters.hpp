// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/expects.hpp>
#include <pendular/core/field_names.hpp>
#include <pendular/core/none.hpp>

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace pendular::io {

/// A number that the user of a scene chose, under a name such as "normal::linear normal_stiffness".
struct parameter {
  std::string name;
  double value;

  bool operator==(const parameter&) const = default;
};

namespace detail {
/// Where a parameter is kept. Its type is forgotten here, so that what reads, writes and compares is compiled once.
struct parameter_place {
  std::string name;
  const void* address;
  double (*read)(const void* address);
  void (*write)(void* address, double value);

  template <class Number>
  static parameter_place of(std::string name, const Number& number) {
    return {std::move(name), &number, [](const void* a) { return static_cast<double>(*static_cast<const Number*>(a)); },
            [](void* a, double value) { *static_cast<Number*>(a) = static_cast<Number>(value); }};
  }
};

/// Collects the numbers of an aggregate under its name, but those that `left_out` names.
class parameter_places {
 public:
  template <class Aggregate>
  void add(const std::string& lead, const Aggregate& a, bool (*left_out)(std::string_view member)) {
    lead_ = lead + std::string(type_name<Aggregate>()) + " ";
    left_out_ = left_out;
    for_each_named_number("", a, *this);
  }
  template <class Number>
  void operator()(const std::string& member, const Number& number) {
    if (!left_out_(member)) all_.push_back(parameter_place::of(lead_ + member, number));
  }
  const std::vector<parameter_place>& all() const { return all_; }

 private:
  std::vector<parameter_place> all_;
  std::string lead_;
  bool (*left_out_)(std::string_view) = nullptr;
};

/// What of a drive changes while it drives is no parameter: `static constexpr std::array state{"velocity"}` names it.
template <class Policy>
bool is_state(std::string_view member) {
  if constexpr (requires { Policy::state; }) {
    const std::string_view own = member.substr(0, member.find('.'));
    return std::find(Policy::state.begin(), Policy::state.end(), own) != Policy::state.end();
  } else {
    return false;
  }
}
/// Of a shape the lengths are parameters: where it stands is state.
inline bool is_inside_another(std::string_view member) { return member.find('.') != std::string_view::npos; }

template <class Policy>
void add_policy(parameter_places& places, const std::string& lead, const Policy& policy) {
  if constexpr (!std::is_same_v<Policy, none>) places.add(lead, policy, &is_state<Policy>);
}

template <class System>
std::vector<parameter_place> places_of(const System& s) {
  parameter_places places;
  s.for_each_policy([&](const auto& policy) { add_policy(places, "", policy); });
  std::size_t index = 0;
  s.for_each_wall([&](const auto& wall, const auto&) {
    const std::string lead = "wall " + std::to_string(index++) + ": ";
    places.add(lead, wall.shape, &is_inside_another);
    add_policy(places, lead, wall.drive);
    if constexpr (requires { wall.material.for_each_policy([](const auto&) {}); }) {
      wall.material.for_each_policy([&](const auto& policy) { add_policy(places, lead, policy); });
    }
  });
  return places.all();
}
}  // namespace detail

/// Every parameter of the policies of a system: laws, fluid, rules, protocol, sources, integrator, and the lengths, drives
/// and materials of its walls. A policy that is no aggregate of up to eight members is passed by.
template <class System>
std::vector<parameter> parameters_of(const System& s) {
  std::vector<parameter> all;
  for (const detail::parameter_place& p : detail::places_of(s)) all.push_back({p.name, p.read(p.address)});
  return all;
}

namespace detail {
/// Finds parameters by their names one after the other: two policies of one type have the same names, in the same order.
class in_turn {
 public:
  explicit in_turn(const std::vector<parameter>& all) : all_(all) {}
  /// The next of this name, or nothing.
  const parameter* find(const std::string& name) {
    for (std::size_t k = 0; k < all_.size(); ++k) {
      const std::size_t place = (next_ + k) % all_.size();
      if (all_[place].name != name) continue;
      next_ = place + 1;
      return &all_[place];
    }
    return nullptr;
  }

 private:
  const std::vector<parameter>& all_;
  std::size_t next_ = 0;
};
}  // namespace detail

/// Gives a system the parameters of these names that it has. Called before anything is made of them.
template <class System>
void take_parameters(System& s, const std::vector<parameter>& from) {
  detail::in_turn given(from);
  for (const detail::parameter_place& place : detail::places_of(s)) {
    const parameter* p = given.find(place.name);
    if (p != nullptr) place.write(const_cast<void*>(place.address), p->value);  // of a system that may be written to
  }
}

/// One line for each that is not the same: "normal::linear normal_stiffness is 1000 in the file and 500 in the program".
inline std::vector<std::string> differences(const std::vector<parameter>& file, const std::vector<parameter>& program) {
  std::vector<std::string> lines;
  detail::in_turn given(file);
  for (const parameter& p : program) {
    const parameter* q = given.find(p.name);
    if (q == nullptr) {
      lines.push_back(p.name + " is not in the file");
    } else if (q->value != p.value) {
      lines.push_back(p.name + " is " + pendular::detail::number(q->value) + " in the file and " +
                      pendular::detail::number(p.value) + " in the program");
    }
  }
  return lines;
}

}  // namespace pendular::io
