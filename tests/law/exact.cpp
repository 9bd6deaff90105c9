// SPDX-License-Identifier: BSD-3-Clause
#include "exact.hpp"
#include "../catch.hpp"

#include <pendular/law/normal/hertz.hpp>
#include <pendular/law/rupture/lian.hpp>

#include <boost/multiprecision/cpp_bin_float.hpp>

using fifty_digits = boost::multiprecision::cpp_bin_float_50;
using namespace pendular;

namespace every_scalar {

struct exact::number {
  fifty_digits digits;
};

namespace {
const fifty_digits& of(const exact& x) { return x.value().digits; }
exact made(const fifty_digits& digits) { return exact(exact::number{digits}); }
}  // namespace

exact::exact(double value) : value_(std::make_shared<const number>(number{fifty_digits(value)})) {}
exact::exact(const number& n) : value_(std::make_shared<const number>(n)) {}
exact::operator double() const { return static_cast<double>(of(*this)); }
exact exact::operator-() const { return made(-of(*this)); }

exact operator+(const exact& a, const exact& b) { return made(of(a) + of(b)); }
exact operator-(const exact& a, const exact& b) { return made(of(a) - of(b)); }
exact operator*(const exact& a, const exact& b) { return made(of(a) * of(b)); }
exact operator/(const exact& a, const exact& b) { return made(of(a) / of(b)); }
bool operator<(const exact& a, const exact& b) { return of(a) < of(b); }

exact exp(const exact& x) { return made(boost::multiprecision::exp(of(x))); }
exact log(const exact& x) { return made(boost::multiprecision::log(of(x))); }
exact sqrt(const exact& x) { return made(boost::multiprecision::sqrt(of(x))); }
exact cbrt(const exact& x) { return made(boost::multiprecision::cbrt(of(x))); }
exact abs(const exact& x) { return made(boost::multiprecision::abs(of(x))); }
exact sin(const exact& x) { return made(boost::multiprecision::sin(of(x))); }
exact cos(const exact& x) { return made(boost::multiprecision::cos(of(x))); }
exact pow(const exact& x, const exact& exponent) { return made(boost::multiprecision::pow(of(x), of(exponent))); }

}  // namespace every_scalar

TEST_CASE("a law in fifty digits is right in forty") {
  using exact = fifty_digits;
  const normal::hertz law{1.5, 0.5};
  const approach<exact> a{exact("-0.0625"), 0, 1, 2, 2};
  const exact root = exact(law.stiffness(a)) / 2;  // of the overlap: a quarter
  CHECK(exact(pendular::abs(exact(root - exact("0.25")))) < exact("1e-45"));
  const bridge<exact> b{0, exact("1e-9"), exact("5e-4"), exact("5e-4")};
  const exact distance = rupture::lian{}.distance(b, fluid::water());
  CHECK(exact(pendular::abs(exact(distance - exact("1e-3")))) < exact("1e-45"));
}
