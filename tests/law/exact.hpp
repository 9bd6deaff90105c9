// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

// A scalar of fifty digits. Boost.Multiprecision is behind it, in exact.cpp alone, because it costs ten seconds of
// compilation wherever its exp and log are called.
namespace every_scalar {

class exact {
 public:
  struct number;

  exact() : exact(0.0) {}
  exact(double value);
  explicit exact(const number& n);

  explicit operator double() const;
  const number& value() const { return *value_; }

  exact operator-() const;
  exact& operator+=(const exact& b) { return *this = *this + b; }
  exact& operator-=(const exact& b) { return *this = *this - b; }
  exact& operator*=(const exact& b) { return *this = *this * b; }
  exact& operator/=(const exact& b) { return *this = *this / b; }

  friend exact operator+(const exact& a, const exact& b);
  friend exact operator-(const exact& a, const exact& b);
  friend exact operator*(const exact& a, const exact& b);
  friend exact operator/(const exact& a, const exact& b);
  friend bool operator<(const exact& a, const exact& b);
  friend bool operator>(const exact& a, const exact& b) { return b < a; }
  friend bool operator<=(const exact& a, const exact& b) { return !(b < a); }
  friend bool operator>=(const exact& a, const exact& b) { return !(a < b); }

  friend exact exp(const exact& x);
  friend exact log(const exact& x);
  friend exact sqrt(const exact& x);
  friend exact cbrt(const exact& x);
  friend exact abs(const exact& x);
  friend exact sin(const exact& x);
  friend exact cos(const exact& x);
  friend exact pow(const exact& x, const exact& exponent);

 private:
  std::shared_ptr<const number> value_;
};

}  // namespace every_scalar
