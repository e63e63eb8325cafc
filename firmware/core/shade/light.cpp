#include "core/shade/light.hpp"

#include <bit>

#include "core/fx/bits.hpp"
#include "core/fx/root.hpp"

namespace spanline {

namespace {

using Matrix = std::int32_t[3][3];

// Brings a matrix of entries in(row, column) to 14 bits and a sign by one common shift, so that products of two entries
// fit 32 bits. Not inline: what it keeps is off the stack again when lights are turned.
template <typename In>
[[gnu::cold, gnu::noinline]] void normalise(const In& in, Matrix& out) {
  std::uint64_t largest = 0;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) largest |= static_cast<std::uint64_t>(in(i, j) < 0 ? -in(i, j) : in(i, j));
  }
  const int shift = static_cast<int>(std::bit_width(largest)) - 14;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const std::int64_t entry = in(i, j);
      out[i][j] = static_cast<std::int32_t>(shift > 0 ? entry >> shift : entry * (std::int64_t{1} << -shift));
    }
  }
}

std::int32_t column_product(const Matrix& m, int a, int b) {
  return m[0][a] * m[0][b] + m[1][a] * m[1][b] + m[2][a] * m[2][b];
}

// The part of an intensity that reaches a surface: 255 is all of it.
std::uint32_t reached(std::uint32_t intensity, std::uint32_t part) { return (intensity * (part + (part >> 7))) >> 8; }

// Columns of one length, at right angles, within 1 %.
bool is_uniform(const Matrix& m) {
  const std::int32_t length = column_product(m, 0, 0);
  const auto near = [&](std::int32_t value, std::int32_t expected) {
    const std::int32_t d = value - expected;
    return (d < 0 ? -d : d) <= length / 128;
  };
  return near(column_product(m, 1, 1), length) && near(column_product(m, 2, 2), length) &&
         near(column_product(m, 0, 1), 0) && near(column_product(m, 0, 2), 0) && near(column_product(m, 1, 2), 0);
}

// The cofactor matrix, which turns normals as the matrix turns surfaces, with the sign that keeps them outward when
// mirrored.
void cofactors(const Matrix& m, Matrix& out) {
  const auto minor = [&m](int i, int j) {
    const int i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
    return std::int64_t{m[i1][j1]} * m[i2][j2] - std::int64_t{m[i1][j2]} * m[i2][j1];
  };
  const std::int64_t determinant = m[0][0] * minor(0, 0) + m[0][1] * minor(0, 1) + m[0][2] * minor(0, 2);
  normalise([&](int i, int j) { return determinant < 0 ? -minor(i, j) : minor(i, j); }, out);
}

// value / divisor, cut off, for |value| below 2^46 and divisors of 15 bits whose quotient fits: two digits of 16 bits.
std::int32_t quotient(std::int64_t value, std::uint32_t divisor) {
  const auto magnitude = static_cast<std::uint64_t>(value < 0 ? -value : value);
  const auto upper = static_cast<std::uint32_t>(magnitude >> 16);
  const std::uint32_t rest = upper % divisor << 16 | (static_cast<std::uint32_t>(magnitude) & 0xffffu);
  const auto result = static_cast<std::int32_t>((upper / divisor << 16) + rest / divisor);
  return value < 0 ? -result : result;
}

}  // namespace

[[gnu::cold]] LightRig::LightRig(const SceneRecord& scene, const Transform& transform)
    : count_(scene.lights.size()), reaches_(scene.reaches) {
  Matrix shape, turned;
  normalise([&](int i, int j) { return std::int64_t{transform.matrix[i][j].raw}; }, shape);
  uniform_ = is_uniform(shape);
  const LightHue hue(scene);
  one_hue_ = hue.one();
  channel_ = static_cast<std::int8_t>(hue.channel());
  cofactors(shape, turned);
  const std::uint32_t length = square_root(static_cast<std::uint32_t>(column_product(turned, 0, 0)));
  for (std::uint32_t l = 0; l < count_; ++l) {
    const LightRecord& light = scene.lights[l];
    for (int j = 0; j < 3; ++j) {
      std::int64_t sum = 0;  // Q30 times 14 bits
      for (int k = 0; k < 3; ++k) sum += std::int64_t{light.direction[k].raw} * turned[k][j];
      // Where the length is left to each normal, the direction stays in units of the cofactors.
      // Either way it is Q30, of a vector of at most sqrt(3).
      const std::int32_t unit = uniform_ && length != 0 ? quotient(sum, length) : static_cast<std::int32_t>(sum >> 14);
      direction_[l][j] = static_cast<std::int16_t>((unit + unit / 511) >> 16);
      intensity_[l][j] = light.intensity[j];
    }
  }
  for (int i = 0; i < 3; ++i) {
    ambient_[i] = scene.ambient[i];
    grey_ = grey_ && ambient_[i] == ambient_[0];
    for (std::uint32_t l = 0; l < count_; ++l) grey_ = grey_ && intensity_[l][i] == intensity_[l][0];
    for (int j = 0; j < 3; ++j) normal_matrix_[i][j] = static_cast<std::int16_t>(turned[i][j]);
  }
}

// |cofactors * normal| in units of 2^14 / 512.
std::uint32_t LightRig::turned_length(const Normal10& normal) const {
  std::uint32_t square = 0;
  for (const auto& row : normal_matrix_) {
    const std::int32_t c =
        (row[0] * normal.x() + row[1] * normal.y() + row[2] * normal.z()) >> 9;  // 15 bits and a sign
    square += static_cast<std::uint32_t>(c * c);
  }
  return square_root(square);
}

// Q1.15.
[[gnu::always_inline]] inline std::int32_t LightRig::diffuse(unsigned light, const Normal10& normal, bool flip,
                                                             std::uint32_t length) const {
  const std::int16_t(&d)[3] = direction_[light];
  std::int32_t dot = d[0] * normal.x() + d[1] * normal.y() + d[2] * normal.z();  // Q23
  if (!flip) dot = -dot;
  if (dot <= 0) return 0;
  dot >>= 8;
  if (!uniform_) dot = length == 0 ? 0 : static_cast<std::int32_t>((static_cast<std::uint32_t>(dot) << 14) / length);
  return dot < 32768 ? dot : 32768;
}

std::uint32_t LightRig::sum_of_all(const Normal10& normal, bool flip) const {
  std::uint32_t sum = ambient_[channel_];
  const std::uint32_t length = uniform_ ? 0 : turned_length(normal);
  for (unsigned l = 0; l < count_; ++l) {
    sum += (static_cast<std::uint32_t>(diffuse(l, normal, flip, length)) * intensity_[l][channel_] + (1u << 14)) >> 15;
  }
  return sum;
}

Rgb8 LightRig::shade(const Normal10& normal, const MaterialRecord& material, bool flip) const {
  if (material.shading == MaterialRecord::kUnlit) return material.color;
  std::uint32_t sum[3] = {ambient_[0], ambient_[1], ambient_[2]};  // Q8.8
  const std::uint32_t length = uniform_ ? 0 : turned_length(normal);
  for (unsigned l = 0; l < count_; ++l) {
    const auto amount = static_cast<std::uint32_t>(diffuse(l, normal, flip, length));
    if (material.reach == MaterialRecord::kAllLight) {
      for (int i = 0; i < 3; ++i) sum[i] += (amount * intensity_[l][i] + (1u << 14)) >> 15;
    } else {
      const Rgb8& part = reaches_[material.reach].light[l];
      const std::uint8_t reach[3] = {part.r, part.g, part.b};
      for (int i = 0; i < 3; ++i) sum[i] += (amount * reached(intensity_[l][i], reach[i]) + (1u << 14)) >> 15;
    }
  }
  const auto lit = [&](std::uint8_t channel, int i) {
    const std::uint32_t v = (channel * sum[i] + 128) >> 8;
    return static_cast<std::uint8_t>(v < 255 ? v : 255);
  };
  return {lit(material.color.r, 0), lit(material.color.g, 1), lit(material.color.b, 2)};
}

}  // namespace spanline
