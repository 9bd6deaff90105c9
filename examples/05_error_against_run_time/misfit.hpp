// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

// How far every law is from Laplace-Young.
namespace misfit {

/// One law on one bridge. Forces in units of kappa R_h; gaps in those of the exact rupture distance D_r.
struct of_bridge {
  std::string law;
  double contact_angle;  // degrees
  double size_ratio;
  double volume;        // V_b / (R_i R_j)^{3/2}
  double contact;       // |f - f_exact| at contact
  double inner, whole;  // largest over 0 to 0.8 D_r and 0 to D_r
  double root_mean;     // root of the mean square over 0 to D_r
  double work;          // relative error of the work from contact to D_r, signed
  bool valid;           // the law says it is made for this bridge
};

struct of_rupture {
  std::string law;
  double contact_angle, size_ratio, volume;
  double distance;  // relative error, signed
  bool valid;
};

struct all {
  std::vector<of_bridge> bridges;
  std::vector<of_rupture> ruptures;
};

/// Every law on every bridge of the study: size ratios 1, 1.2, 2, 4, 10; contact angles 0, 20, 40, 60 degrees; volumes
/// 1e-6 to 0.1.
all judge();

/// Over all bridges of one law: worst and median.
struct summary {
  std::string law;
  double contact, inner, whole, whole_median, root_mean_median, work_median;  // work: of the absolute value
  double usual;        // largest over 0 to D_r for ratios to 2, angles to 40 degrees, volumes 1e-4 to 0.03
  double where_valid;  // largest over 0 to D_r where the law says it is valid; NaN if nowhere
};
std::vector<summary> summarise(const std::vector<of_bridge>& bridges);

struct rupture_summary {
  std::string law;
  double worst, median, usual;  // of the absolute relative error
};
std::vector<rupture_summary> summarise(const std::vector<of_rupture>& ruptures);

}  // namespace misfit
