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
#include <vector>

namespace pendular::io {

/// A number that the user of a scene chose, under a name such as "normal::linear normal_stiffness".
struct parameter {
  std::string name;
  double value;

  bool operator==(const parameter&) const = default;
};

namespace detail {
/// What of a drive changes while it drives is no parameter: `static constexpr std::array state{"velocity"}` names it.
template <class Drive>
bool is_state(std::string_view member) {
  if constexpr (requires { Drive::state; }) {
    const std::string_view own = member.substr(0, member.find('.'));
    return std::find(Drive::state.begin(), Drive::state.end(), own) != Drive::state.end();
  } else {
    return false;
  }
}

template <class Policy, class Visit>
void visit_policy(const std::string& lead, Policy& policy, const Visit& visit) {
  using plain = std::remove_cv_t<Policy>;
  if constexpr (!std::is_same_v<plain, none>) {
    const std::string name = lead + std::string(type_name<plain>()) + " ";
    for_each_named_number("", policy, [&](const std::string& member, auto& v) {
      if (!is_state<plain>(member)) visit(name + member, v);
    });
  }
}

/// Of a shape the lengths: where it stands is state.
template <class Shape, class Visit>
void visit_shape(const std::string& lead, Shape& shape, const Visit& visit) {
  const std::string name = lead + std::string(type_name<std::remove_cv_t<Shape>>()) + " ";
  for_each_named_number("", shape, [&](const std::string& member, auto& v) {
    if (member.find('.') == std::string::npos) visit(name + member, v);
  });
}

template <class System, class Visit>
void visit_parameters(System& s, const Visit& visit) {
  s.for_each_policy([&](auto& policy) { visit_policy("", policy, visit); });
  std::size_t index = 0;
  s.for_each_wall([&](auto& wall, auto&) {
    const std::string lead = "wall " + std::to_string(index++) + ": ";
    visit_shape(lead, wall.shape, visit);
    visit_policy(lead, wall.drive, visit);
    if constexpr (requires { wall.material.for_each_policy([](auto&) {}); }) {
      wall.material.for_each_policy([&](auto& policy) { visit_policy(lead, policy, visit); });
    }
  });
}
}  // namespace detail

/// Every parameter of the policies of a system: laws, fluid, rules, protocol, sources, integrator, and the lengths, drives
/// and materials of its walls. A policy that is no aggregate of up to eight members is passed by.
template <class System>
std::vector<parameter> parameters_of(const System& s) {
  std::vector<parameter> all;
  detail::visit_parameters(s, [&](const std::string& name, const auto& value) {
    all.push_back({name, static_cast<double>(value)});
  });
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
  detail::visit_parameters(s, [&](const std::string& name, auto& value) {
    const parameter* p = given.find(name);
    if (p != nullptr) value = static_cast<std::remove_reference_t<decltype(value)>>(p->value);
  });
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
