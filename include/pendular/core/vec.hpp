// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/scalar.hpp>

namespace pendular {

/// Three components of any Scalar. A plain struct, because an Eigen vector cannot hold lanes as coefficients.
template <class T>
struct Vec3 {
  T x, y, z;
};

template <class T>
Vec3(T, T, T) -> Vec3<T>;

template <class T>
Vec3<T> operator+(const Vec3<T>& a, const Vec3<T>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class T>
Vec3<T> operator-(const Vec3<T>& a, const Vec3<T>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class T>
Vec3<T> operator-(const Vec3<T>& a) {
  return {-a.x, -a.y, -a.z};
}
template <class T>
Vec3<T> operator*(const T& s, const Vec3<T>& a) {
  return {s * a.x, s * a.y, s * a.z};
}
template <class T>
Vec3<T>& operator+=(Vec3<T>& a, const Vec3<T>& b) {
  return a = a + b;
}
template <class T>
Vec3<T>& operator-=(Vec3<T>& a, const Vec3<T>& b) {
  return a = a - b;
}
template <class T>
bool operator==(const Vec3<T>& a, const Vec3<T>& b) {
  return a.x == b.x && a.y == b.y && a.z == b.z;
}

template <class T>
T dot(const Vec3<T>& a, const Vec3<T>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class T>
Vec3<T> cross(const Vec3<T>& a, const Vec3<T>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class T>
T norm(const Vec3<T>& a) {
  return sqrt(dot(a, a));
}

/// The part of a perpendicular to the unit vector n.
template <class T>
Vec3<T> tangential_part(const Vec3<T>& a, const Vec3<T>& n) {
  const T along = dot(a, n);
  return a - along * n;
}

/// a, shortened to the given length where it is longer; 0/0 is 0, and a length below 0 counts as 0.
template <class T>
Vec3<T> shortened_to(const Vec3<T>& a, const T& length) {
  const T allowed = max(length, T(0));
  const T longest = max(T(max(norm(a), allowed)), T(tiny));
  const T factor = allowed / longest;
  return factor * a;
}

using vector = Vec3<double>;

}  // namespace pendular
