// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contender.hpp"

#include <pendular/io/plot.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace peers {

/// Plot of the time per grain and step over the number of grains.
class time_over_size {
 public:
  time_over_size() {
    plot_.title = "The same packing, one core each";
    plot_.x_label = "number of grains";
    plot_.y_label = "processor time per grain and step (ns)";
    plot_.logarithmic_x = plot_.logarithmic_y = true;
    for (const char* label : {"YADE wet", "LIGGGHTS wet", "LAMMPS dry", "pendular, SSE2 wet", "pendular, SSE2 dry",
                              "pendular, AVX-512 wet", "pendular, AVX-512 dry"})
      plot_.curves.push_back({label, {}, {}, pendular::io::curve_style::linespoints});
  }

  void add(double grains, const std::vector<contender>& all) {
    for (const contender& c : all) {
      for (auto& curve : plot_.curves) {
        if (curve.label == c.code + " " + c.scene) curve.x.push_back(grains), curve.y.push_back(c.time());
      }
    }
  }

  void draw(const std::filesystem::path& folder) const {
    for (const char* kind : {".png", ".svg"})
      pendular::io::draw(plot_, folder / (std::string{"against_other_codes"} + kind));
  }

 private:
  pendular::io::plot plot_;
};

}  // namespace peers
