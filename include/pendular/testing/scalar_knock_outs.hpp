// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/law/concepts.hpp>

#include <boost/hana/tuple.hpp>
#include <boost/hana/type.hpp>

namespace pendular::testing::knock_out {

// These model their concept, which asks in double, and must be refused by the ladder: they do not take every scalar.
namespace in_double_only {
struct normal_law {
  double repulsion(const approach<double>& a) const { return -a.gap; }
};
struct damping_law {
  double resistance(const approach<double>& a, double k) const { return k * a.closing_speed; }
};
struct damping_law_by_its_preparation {
  template <Scalar T>
  T resistance(const approach<T>& a, const T& k) const {
    return k * a.closing_speed;
  }
  prepared_dashpot<double> prepare(double, double k) const { return {k}; }
  double resistance(const approach<double>& a, const prepared_dashpot<double>& made) const {
    return made.coefficient * a.closing_speed;
  }
};
struct damping_law_beside_spring {
  double resistance(const approach<double>& a, const elastic<double>& e) const { return e.push * a.closing_speed; }
};
struct normal_law_with_memory {
  template <class T>
  struct contact_memory {
    T deepest;
  };
  double repulsion(const approach<double>& a, contact_memory<double>& memory) const { return memory.deepest - a.gap; }
};
struct friction_law {
  Vec3<double> traction(const slip<double>& s, double) const { return -s.velocity; }
};
struct friction_law_with_memory {
  template <class T>
  struct contact_memory {
    Vec3<T> force;
  };
  Vec3<double> traction(const slip<double>&, double, contact_memory<double>& memory) const { return memory.force; }
};
struct capillary_law {
  double attraction(const bridge<double>& b, const fluid&) const { return b.radius_i; }
};
struct capillary_law_by_its_preparation {
  template <class T>
  using coefficients = T;
  template <Scalar T>
  T attraction(const bridge<T>& b, const fluid&) const {
    return b.radius_i;
  }
  double prepare(const bridge<double>& b, const fluid&) const { return b.radius_i; }
  double attraction(double, double c) const { return c; }
};
struct rupture_law {
  double distance(const bridge<double>& b, const fluid&) const { return b.radius_i; }
};
struct mean_radius {
  double of(const bridge<double>& b) const { return b.radius_i; }
};
struct viscous_bridge_law {
  bridge_resistance<double> resistance(const bridge<double>&, const fluid&) const { return {}; }
};
}  // namespace in_double_only

// The same for the result: in some scalar it is an expression, whose operands are gone.
namespace returns_an_expression {
struct normal_law {
  template <Scalar T>
  auto repulsion(const approach<T>& a) const {
    return T(2) * a.gap;
  }
};
struct damping_law {
  template <Scalar T>
  auto resistance(const approach<T>& a, const T& k) const {
    return k * a.closing_speed;
  }
};
struct damping_law_by_its_preparation {
  template <Scalar T>
  T resistance(const approach<T>& a, const T& k) const {
    return k * a.closing_speed;
  }
  template <Scalar T>
  prepared_dashpot<T> prepare(const T&, const T& k) const {
    return {k};
  }
  template <Scalar T>
  auto resistance(const approach<T>& a, const prepared_dashpot<T>& made) const {
    return made.coefficient * a.closing_speed;
  }
};
struct damping_law_beside_spring {
  template <Scalar T>
  auto resistance(const approach<T>& a, const elastic<T>& e) const {
    return e.push * a.closing_speed;
  }
};
struct friction_law {
  template <class T>
  struct expression {
    T factor;
    const Vec3<T>& vector;
    operator Vec3<T>() const { return factor * vector; }
  };
  template <Scalar T>
  expression<T> traction(const slip<T>& s, const T&) const {
    return {T(-1), s.velocity};
  }
};
struct capillary_law {
  template <Scalar T>
  auto attraction(const bridge<T>& b, const fluid&) const {
    return T(2) * b.radius_i;
  }
};
struct capillary_law_by_its_preparation {
  template <class T>
  using coefficients = T;
  template <Scalar T>
  T prepare(const bridge<T>& b, const fluid&) const {
    return b.radius_i;
  }
  template <Scalar T>
  auto attraction(const T& gap, const T& c) const {
    return c * gap;
  }
};
struct rupture_law {
  template <Scalar T>
  auto distance(const bridge<T>& b, const fluid&) const {
    return T(2) * b.radius_i;
  }
};
struct mean_radius {
  template <Scalar T>
  auto of(const bridge<T>& b) const {
    return T(2) * b.radius_i;
  }
};
}  // namespace returns_an_expression

}  // namespace pendular::testing::knock_out
