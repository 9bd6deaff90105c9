// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/law/capillary/pair_radius.hpp>
#include <pendular/law/inputs.hpp>
#include <pendular/law/validity.hpp>

namespace pendular::viscous {

/// Viscous force of a liquid bridge, in the lubrication limit:
///     f_n = 6 pi eta R*^2 (v_n / D) (1 - 1 / sqrt(1 + 2 V_b / (pi R_h D^2)))^2,
///     f_t = 6 pi eta R* v_t ((8/15) ln(R*/D) + 0.9588),
/// R* = R_i R_j / (R_i + R_j), R_h = 2 R*; the last factor of f_n takes the finite volume, f_t is never less than nothing.
/// The film is never thinner than `least_gap` R*, overlap included.
/// Units: N s/m from Pa s, m, m3. Valid while gap and filling angle are small, at small Reynolds and capillary numbers.
/// Source: M. J. Adams, V. Perchard 1985, Inst. Chem. Eng. Symp. Ser. 91, 147; O. Pitois, P. Moucheront, X. Chateau 2000,
/// J. Colloid Interface Sci. 231, 26; A. J. Goldman, R. G. Cox, H. Brenner 1967, Chem. Eng. Sci. 22, 637.
struct lubrication {
  static constexpr validity valid{.planes = true};

  double least_gap = 1e-2;  // of the film over R*

  template <Scalar T>
  bridge_resistance<T> resistance(const bridge<T>& b, const fluid& f) const {
    const T reduced = T(0.5) * capillary::harmonic_radius(b);
    const T film = max(b.gap, T(T(least_gap) * reduced));
    const T area = b.volume / (T(std::numbers::pi) * reduced);  // 2 V_b / (pi R_h)
    const T length = sqrt(T(film * film + area));
    const T filled = area / (length * (length + film));  // 1 - film/length
    const T scale = T(6 * std::numbers::pi * f.viscosity) * reduced;
    const T sliding = max(T(T(8.0 / 15) * log(T(reduced / film)) + T(0.9588)), T(0));
    return {T(scale * reduced / film * filled * filled), T(scale * sliding * unit_step(b.volume))};
  }
};

inline void validate(const lubrication& law) {
  expects(law.least_gap > 0 && law.least_gap < 1, "the least gap of a viscous bridge over R*", law.least_gap,
          "in (0, 1)", "docs/reference/laws.md");
}

}  // namespace pendular::viscous
