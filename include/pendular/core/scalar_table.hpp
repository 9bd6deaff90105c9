// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/fields.hpp>
#include <pendular/core/lanes.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace pendular {

/// One row of Record<double> per pair, kept as one column per number, read and written a block of rows at a time as
/// Record<block> or a row at a time as Record<double>. An empty record makes an empty table.
template <template <class> class Record>
class scalar_table {
 public:
  static constexpr std::size_t width = scalar_count<double, Record<double>>;

  void resize(std::size_t rows) {
    for (auto& column : columns_) column.resize(rows, 0.0);
  }

  Record<block> load_block(std::size_t first_row) const {
    Record<block> record;
    std::size_t k = 0;
    for_each_scalar<block>(record, [&](block& value) { value = pendular::load(columns_[k++].data() + first_row); });
    return record;
  }
  void store_block(std::size_t first_row, const Record<block>& record) {
    std::size_t k = 0;
    for_each_scalar<block>(record,
                           [&](const block& value) { pendular::store(columns_[k++].data() + first_row, value); });
  }

  Record<double> row(std::size_t index) const {
    Record<double> record{};
    std::size_t k = 0;
    for_each_scalar<double>(record, [&](double& value) { value = columns_[k++][index]; });
    return record;
  }
  void set_row(std::size_t index, const Record<double>& record) {
    std::size_t k = 0;
    for_each_scalar<double>(record, [&](const double& value) { columns_[k++][index] = value; });
  }

  /// Row p becomes what was row origin[p], or zeros where origin[p] < 0; rows are padded with zeros.
  void carry(std::span<const std::int32_t> origin, std::size_t rows) {
    for (auto& column : columns_) {
      std::vector<double> moved(rows, 0.0);
      for (std::size_t p = 0; p < origin.size(); ++p) {
        if (origin[p] >= 0) moved[p] = column[static_cast<std::size_t>(origin[p])];
      }
      column.swap(moved);
    }
  }

  std::span<double> column(std::size_t k) { return columns_[k]; }
  std::span<const double> column(std::size_t k) const { return columns_[k]; }

 private:
  std::array<std::vector<double>, width> columns_;
};

}  // namespace pendular
