#include "core/geom/clip_matrix.hpp"

namespace spanline {

[[gnu::cold]] bool ClipMatrix::fits() const {
  constexpr std::int32_t kMost = (1 << 30) - (1 << 14) - 1;
  for (int i = 0; i < 3; ++i) {
    for (const std::int32_t c : linear[i]) {
      if (c > kMost || c < -kMost) return false;
    }
    if (farthest(i) > INT32_MAX) return false;
  }
  return true;
}

LongRow::LongRow(const ClipMatrix& matrix, int row)
    : start_(std::int64_t{matrix.offset[row]} * (1 << 15) + (1 << 14)),
      linear_{matrix.linear[row][0], matrix.linear[row][1], matrix.linear[row][2]} {}

SplitRow::SplitRow(const ClipMatrix& matrix, int row) : offset_(static_cast<std::uint32_t>(matrix.offset[row])) {
  for (int i = 0; i < 3; ++i) {
    const CoefficientParts c(matrix.linear[row][i]);
    high_[i] = static_cast<std::uint32_t>(c.high);
    low_[i] = c.low;
  }
}

PackedRow::PackedRow(const ClipMatrix& matrix, int row) : offset_(static_cast<std::uint32_t>(matrix.offset[row])) {
  const CoefficientParts x(matrix.linear[row][0]), y(matrix.linear[row][1]), z(matrix.linear[row][2]);
  high_xy_ = pack_halves(x.high, y.high);
  low_xy_ = pack_halves(x.low, y.low);
  z_ = pack_halves(z.high, z.low);
}

ClipRows::ClipRows(const ClipMatrix& matrix) : rows_{{matrix, 0}, {matrix, 1}, {matrix, 2}} {}

}  // namespace spanline
