// SPDX-License-Identifier: BSD-3-Clause
#include "figures.hpp"

#include "contenders.hpp"

#include <pendular/io/plot.hpp>
#include <pendular/laplace_young/solve.hpp>

#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>

namespace figures {
namespace {

using namespace pendular;

void draw_both(const io::plot& p, const std::filesystem::path& folder, const std::string& name) {
  for (const char* kind : {".png", ".svg"}) io::draw(p, folder / (name + kind));
}

double time_of(const std::vector<cost::of_law>& times, const std::string& law) {
  for (const cost::of_law& t : times) {
    if (t.law == law) return t.in_lanes;
  }
  return std::nan("");
}

std::string text(const char* format, double a, double b) {
  char out[64];
  std::snprintf(out, sizeof out, format, a, b);
  return out;
}

struct pair_of_spheres {
  double volume, ratio;  // V_b / (R_i R_j)^{3/2}
};
constexpr pair_of_spheres shown[] = {{1e-3, 1}, {1e-2, 1}, {1e-1, 1}, {1e-2, 2}, {1e-2, 4}};

}  // namespace

void pareto(const std::vector<misfit::summary>& laws, const std::vector<cost::of_law>& times,
            const std::filesystem::path& folder) {
  io::plot p{"Capillary laws: error against run time",
             "time per evaluation in lanes of double (ns)",
             "worst error to rupture, median bridge (κ R_h)",
             {}};
  p.logarithmic_x = p.logarithmic_y = true;
  for (const misfit::summary& l : laws) {
    const double time = time_of(times, l.law);
    bool beaten = false;
    for (const misfit::summary& other : laws) {
      beaten |= time_of(times, other.law) < time && other.whole_median < l.whole_median;
    }
    const std::size_t n = p.curves.size();
    // One curve a law, each with a mark and colour of its own; seven of both go round.
    p.curves.push_back(
        {l.law + (beaten ? "" : " (front)"), {time}, {l.whole_median}, io::curve_style::points, n + n / 7});
  }
  draw_both(p, folder, "error_against_run_time");
}

void paper(const std::filesystem::path& folder) {
  const double radius = 1e-3;
  const fluid f = fluid::water();
  io::plot over_gap{"The paper's law (lines) and direct integration (points)", "gap (µm)", "attraction (µN)", {}};
  io::plot scaled{
      "The same integration, scaled as the paper scales it", "gap over λ", "attraction over κ √(R_i R_j)", {}};
  for (std::size_t n = 0; n < std::size(shown); ++n) {
    const double mean = radius * std::sqrt(shown[n].ratio);
    const bridge<double> b{0, shown[n].volume * mean * mean * mean, radius, shown[n].ratio * radius};
    laplace_young::bridges_of_volume exact({b.radius_i, b.radius_j, 0, b.volume, f.surface_tension});
    const auto c = capillary::richefeu{}.prepare(b, f);
    const std::string label = text("V/R³ = %g, r = %g", shown[n].volume, shown[n].ratio);
    io::curve law{label, {}, {}, io::curve_style::lines, n}, points{"", {}, {}, io::curve_style::points, n};
    io::curve collapse{label, {}, {}, io::curve_style::linespoints, n};
    for (int k = 0; k <= 40; ++k) {
      const double gap = exact.rupture_distance() * k / 40, force = exact.at(gap)->attraction;
      law.x.push_back(1e6 * gap);
      law.y.push_back(1e6 * c.attraction(gap));
      if (k % 2 == 0) points.x.push_back(1e6 * gap), points.y.push_back(1e6 * force);
      if (k % 2 == 0) collapse.x.push_back(gap * c.decay_rate), collapse.y.push_back(force / c.amplitude);
    }
    over_gap.curves.insert(over_gap.curves.end(), {law, points});
    scaled.curves.push_back(collapse);
  }
  io::curve printed{"exp(-gap/λ)", {}, {}, io::curve_style::dashed, 6};
  for (int k = 0; k <= 60; ++k) printed.x.push_back(0.1 * k), printed.y.push_back(std::exp(-0.1 * k));
  scaled.curves.push_back(printed);
  scaled.x_range = {0, 5};
  draw_both(over_gap, folder, "paper_figure_1b");
  draw_both(scaled, folder, "paper_figure_1c");
}

}  // namespace figures
