#include "core/curve/normals.hpp"

#include <bit>
#include <utility>

#include "core/base/check.hpp"
#include "core/fx/bits.hpp"
#include "core/fx/inverse_root.hpp"

namespace spanline {
namespace {

using Vector = ShortVector;

constexpr int kDirectionBits = Vector::kBits;  // of a tangent

Vector operator-(const Vector& a, const Vector& b) { return {{a.v[0] - b.v[0], a.v[1] - b.v[1], a.v[2] - b.v[2]}}; }
Vector operator-(const Vector& a) { return {{-a.v[0], -a.v[1], -a.v[2]}}; }
Vector difference(const Position& a, const Position& b) { return {{b.x - a.x, b.y - a.y, b.z - a.z}}; }

// Cuts vectors off to at most `bits` bits by a common exponent; they are never made longer.
template <std::size_t N>
void shorten(Vector (&vectors)[N], int bits) {
  std::uint32_t any = 0;
  for (const Vector& a : vectors) any |= a.bits();
  const int down = static_cast<int>(std::bit_width(any)) - bits;
  if (down <= 0) return;
  for (Vector& a : vectors) a = a.shifted(down);
}

Vector cross(const Vector& a, const Vector& b) { return Vector::product(a.direction(), b.direction()); }

// Bernstein's polynomials at at / of, times of^degree.
struct Weights {
  std::int32_t quadratic[3], cubic[4];

  Weights(std::uint32_t at, std::uint32_t of) {
    const auto t = static_cast<std::int32_t>(at), s = static_cast<std::int32_t>(of - at);
    quadratic[0] = s * s, quadratic[1] = 2 * s * t, quadratic[2] = t * t;
    cubic[0] = s * s * s, cubic[1] = 3 * s * s * t, cubic[2] = 3 * s * t * t, cubic[3] = t * t * t;
  }
};

// How many bits a cubic of `steps` steps leaves to its control points in 31: the weights add up to steps^3.
int bits_beside(std::uint32_t steps) {
  const int bits = 30 - 3 * static_cast<int>(std::bit_width(steps - 1));
  return bits < kDirectionBits ? bits : kDirectionBits;
}
static_assert(30 - 3 * std::bit_width(NormalGrid::kMostSteps - 1) == 9 && kDirectionBits < 16);

template <typename V, std::size_t N>
Vector blend(const V* const (&points)[N], const std::int32_t (&weights)[N]) {
  return [&]<std::size_t... kI>(std::index_sequence<kI...>) {
    const auto component = [&](int c) { return (... + (weights[kI] * points[kI]->v[c])); };
    return Vector{{component(0), component(1), component(2)}};
  }
  (std::make_index_sequence<N>());
}

[[gnu::always_inline]] inline Normal10 pack(const Vector& normal) {
  const Vector n = normal.direction();  // its square is at most 3 * 2^28
  const InverseRoot inverse(static_cast<std::uint32_t>(n.v[0] * n.v[0] + n.v[1] * n.v[1] + n.v[2] * n.v[2]));
  const auto scale = static_cast<std::int32_t>(inverse.factor * 511 >> 9);  // at most 2^16
  const auto component = [&](int i) { return shift_round(n.v[i] * scale, 31 - 9 - inverse.up); };
  return Normal10::pack(component(0), component(1), component(2));
}

}  // namespace

PatchTangents::PatchTangents(const PatchShape& patch, const NormalGrid& grid) : grid_(grid) {
  CHECK(grid.rows <= NormalGrid::kMostSteps && grid.columns <= NormalGrid::kMostSteps);
  const int bits = bits_beside(grid.rows);
  Vector differences[12];
  const auto keep = [&](Short(&out)[12]) {
    shorten(differences, bits);
    for (int i = 0; i < 12; ++i) {
      for (int c = 0; c < 3; ++c) out[i].v[c] = static_cast<std::int16_t>(differences[i].v[c]);
    }
  };
  for (int i = 0; i < 12; ++i) differences[i] = difference(patch.at[i / 3][i % 3], patch.at[i / 3][i % 3 + 1]);
  keep(along_);
  for (int i = 0; i < 12; ++i) differences[i] = difference(patch.at[i / 4][i % 4], patch.at[i / 4 + 1][i % 4]);
  keep(across_);
}

NormalRow::NormalRow(const PatchTangents& patch, std::uint32_t row) : row_(row), grid_(patch.grid_) {
  CHECK(row <= grid_.rows);
  const Weights weights(row, grid_.rows);
  const auto& u = patch.along_;
  const auto& v = patch.across_;
  for (int j = 0; j < 3; ++j) along_[j] = blend({&u[j], &u[3 + j], &u[6 + j], &u[9 + j]}, weights.cubic);
  for (int j = 0; j < 4; ++j) across_[j] = blend({&v[j], &v[4 + j], &v[8 + j]}, weights.quadratic);
  shorten(along_, bits_beside(grid_.columns));
  shorten(across_, bits_beside(grid_.columns));
}

Normal10 NormalRow::at(std::uint32_t column) const {
  CHECK(column <= grid_.columns);
  const Weights weights(column, grid_.columns);
  const Vector u = blend({&along_[0], &along_[1], &along_[2]}, weights.quadratic);
  const Vector v = blend({&across_[0], &across_[1], &across_[2], &across_[3]}, weights.cubic);
  Vector normal = cross(u, v);
  if (!normal.is_zero()) return pack(normal);
  // d/du d/dv: near a rim where the derivative along it vanishes, that is so much times the distance from the rim.
  const Vector turns[3] = {across_[1] - across_[0], across_[2] - across_[1], across_[3] - across_[2]};
  const Vector uv = blend({&turns[0], &turns[1], &turns[2]}, weights.quadratic);
  if (row_ == 0 || row_ == grid_.rows) normal = row_ == 0 ? cross(uv, v) : -cross(uv, v);
  if (normal.is_zero() && (column == 0 || column == grid_.columns)) normal = column == 0 ? cross(u, uv) : -cross(u, uv);
  return normal.is_zero() ? Normal10::pack(0, 0, 511) : pack(normal);
}

FacetNormals::FacetNormals(const ClipMatrix& matrix, bool mirrored) {
  Vector rows[3];
  for (int i = 0; i < 3; ++i) rows[i] = {{matrix.linear[i][0], matrix.linear[i][1], matrix.linear[i][2]}};
  shorten(rows, kDirectionBits);
  for (int i = 0; i < 3; ++i) {
    const std::int32_t x = rows[0].v[i], y = rows[1].v[i], w = rows[2].v[i];
    xy_[i] = mirrored ? pack_halves(-x, -y) : pack_halves(x, y);
    w_[i] = mirrored ? -w : w;
  }
}

Normal10 FacetNormals::of(const ClipPoint& a, const ClipPoint& b, const ClipPoint& c, const ClipPoint& d) const {
  // Halves, since a facet may reach from end to end of clip space.
  const auto half = [](const ClipPoint& from, const ClipPoint& to) {
    return Vector{{(to.x >> 1) - (from.x >> 1), (to.y >> 1) - (from.y >> 1), (to.w >> 1) - (from.w >> 1)}};
  };
  const Vector n = Vector::spanned(half(a, c), half(b, d));
  const std::uint32_t xy = pack_halves(n.v[0], n.v[1]);
  // |n| and the matrix are below 2^14 and 2^14 a component.
  const auto back = [&](int i) {
    return static_cast<std::int32_t>(add_products(xy_[i], xy, static_cast<std::uint32_t>(w_[i] * n.v[2])));
  };
  const Vector normal{{back(0), back(1), back(2)}};
  return normal.is_zero() ? Normal10::pack(0, 0, 511) : pack(normal);
}

}  // namespace spanline
