#include "core/shade/light.hpp"

#include <bit>

#include "core/fx/bits.hpp"
#include "core/fx/root.hpp"

namespace spanline {

namespace {

using Matrix = std::int32_t[3][3];

// Brings a matrix to 14 bits and a sign by one common shift, so that products of two entries fit 32 bits. Not inline:
// what it keeps is off the stack again when lights are turned.
[[gnu::cold, gnu::noinline]] void normalise(Matrix& m) {
  std::uint32_t largest = 0;
  for (const auto& row : m) {
    for (const std::int32_t entry : row)
      largest |= static_cast<std::uint32_t>(entry < 0 ? -std::int64_t{entry} : entry);
  }
  const int shift = static_cast<int>(std::bit_width(largest)) - 14;
  for (auto& row : m) {
    for (std::int32_t& entry : row) entry = shift > 0 ? entry >> shift : entry * (1 << -shift);
  }
}

std::int32_t column_product(const Matrix& m, int a, int b) {
  return m[0][a] * m[0][b] + m[1][a] * m[1][b] + m[2][a] * m[2][b];
}

// The part of an intensity that reaches a surface: 255 is all of it.
std::uint32_t reached(std::uint32_t intensity, std::uint32_t part) { return (intensity * (part + (part >> 7))) >> 8; }

std::uint32_t in_channel(const Rgb8& color, unsigned channel) {
  return channel == 0 ? color.r : channel == 1 ? color.g : color.b;
}

// Columns of one length, at right angles, within 1 %: the transform only turns, mirrors and scales evenly.
[[gnu::cold]] bool is_uniform(const Matrix& m) {
  const std::int32_t length = column_product(m, 0, 0), slack = length / 128;
  for (int a = 0; a < 3; ++a) {
    for (int b = 0; b <= a; ++b) {
      const std::int32_t off = column_product(m, a, b) - (a == b ? length : 0);
      if (off > slack || off < -slack) return false;
    }
  }
  return true;
}

// Neither the lights nor the ambient light have a hue.
[[gnu::cold]] bool is_grey(const SceneRecord& scene) {
  const auto grey = [](const std::uint16_t(&c)[3]) { return c[0] == c[1] && c[1] == c[2]; };
  for (const LightRecord& light : scene.lights) {
    if (!grey(light.intensity)) return false;
  }
  return grey(scene.ambient);
}

// Whether a uniform matrix mirrors. Its determinant is so far from 0 that half of its bits tell.
bool is_mirrored(const Matrix& m) {
  std::int32_t determinant = 0;
  for (int j = 0, k = 1, l = 2; j < 3; k = l, l = j++) {
    determinant += ((m[0][k] * m[1][l] - m[0][l] * m[1][k]) >> 14) * m[2][j];  // below 2^29
  }
  return determinant < 0;
}

// The cofactor matrix, which turns normals as the matrix turns surfaces, with the sign that keeps them outward when
// mirrored.
[[gnu::cold, gnu::noinline]] void cofactors(const Matrix& m, Matrix& out) {
  const auto next = [](int i) { return i == 2 ? 0 : i + 1; };
  std::int64_t determinant = 0;
  for (int i = 0; i < 3; ++i) {
    const std::int32_t(&below)[3] = m[next(i)], (&above)[3] = m[next(next(i))];
    for (int j = 0; j < 3; ++j) {
      const int k = next(j), l = next(k);
      out[i][j] = below[k] * above[l] - below[l] * above[k];  // below 2^29
      determinant += i == 0 ? std::int64_t{m[i][j]} * out[i][j] : 0;
    }
  }
  if (determinant < 0) {
    for (auto& row : out) {
      for (std::int32_t& entry : row) entry = -entry;
    }
  }
  normalise(out);
}

// value / divisor, cut off, for |value| below 2^46 and divisors of 15 bits whose quotient fits: two digits of 16 bits.
std::int32_t quotient(std::int64_t value, std::uint32_t divisor) {
  const auto magnitude = static_cast<std::uint64_t>(value < 0 ? -value : value);
  const auto upper = static_cast<std::uint32_t>(magnitude >> 16);
  const std::uint32_t rest = upper % divisor << 16 | (static_cast<std::uint32_t>(magnitude) & 0xffffu);
  const auto result = static_cast<std::int32_t>((upper / divisor << 16) + rest / divisor);
  return value < 0 ? -result : result;
}

// The matrix of a transform, normalised.
[[gnu::cold]] void take_shape(const Transform& transform, Matrix& shape) {
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) shape[i][j] = transform.matrix[i][j].raw;
  }
  normalise(shape);
}

// How much longer a uniform matrix makes what it turns.
std::uint32_t length_of(const Matrix& turned) {
  return square_root(static_cast<std::uint32_t>(column_product(turned, 0, 0)));
}

// A light's direction in the mesh, as LightRig::direction_ has it. Where the length is left to each normal, which 0
// says, it stays in units of the matrix. The end of what is written.
[[gnu::cold]] std::int16_t* see(const LightRecord& light, const Matrix& turned, std::uint32_t length,
                                std::int16_t* direction) {
  for (int j = 0; j < 3; ++j) {
    std::int64_t sum = 0;  // Q30 times 14 bits
    for (int k = 0; k < 3; ++k) sum += std::int64_t{light.direction[k].raw} * turned[k][j];
    // Either way it is Q30, of a vector of at most sqrt(3).
    const std::int32_t unit = length != 0 ? quotient(sum, length) : static_cast<std::int32_t>(sum >> 14);
    *direction++ = static_cast<std::int16_t>((unit + unit / 511) >> 16);
  }
  return direction;
}

}  // namespace

[[gnu::cold]] LightRig::LightRig(const SceneRecord& scene, const Transform& transform)
    : scene_(&scene), grey_(is_grey(scene)), channel_(static_cast<std::uint8_t>(LightHue::channel(scene))) {
  take_shape(transform, normal_matrix_);  // what its cofactors are where it is uniform, but for their length
  uniform_ = is_uniform(normal_matrix_);
  if (!uniform_) {
    Matrix shape;
    take_shape(transform, shape);
    cofactors(shape, normal_matrix_);
  }
  const std::uint32_t length = uniform_ ? length_of(normal_matrix_) : 0;
  std::int16_t* direction = direction_[0];
  for (const LightRecord& light : scene.lights) direction = see(light, normal_matrix_, length, direction);
}

[[gnu::cold]] PlainLight::PlainLight(const SceneRecord& scene, const Transform& transform) {
  Matrix shape;
  take_shape(transform, shape);
  fits_ = is_uniform(shape) && !is_mirrored(shape);
  std::int16_t direction[3];
  const LightRecord& light = scene.lights[0];
  see(light, shape, length_of(shape), direction);
  one_ = LightRig::One::of(direction, light.intensity[0], scene.ambient[0]);
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

// How much of each light falls on it, Q1.15.
[[gnu::noinline]] LightRig::Fall LightRig::fall(const Normal10& normal, bool flip) const {
  Fall fall;
  const std::uint32_t length = uniform_ ? 0 : turned_length(normal);
  for (unsigned l = 0; l < scene_->lights.size(); ++l) {
    const std::int16_t(&d)[3] = direction_[l];
    std::int32_t dot = d[0] * normal.x() + d[1] * normal.y() + d[2] * normal.z();  // Q23
    if (!flip) dot = -dot;
    std::uint32_t amount = dot < 0 ? 0 : static_cast<std::uint32_t>(dot) >> 8;
    if (!uniform_) amount = length == 0 ? 0 : (amount << 14) / length;
    fall.amount[l] = amount < 32768 ? amount : 32768;
  }
  return fall;
}

// Q8.8, where all light comes; else where what `reach` lets pass does.
[[gnu::noinline]] std::uint32_t LightRig::sum(const Fall& fall, unsigned channel, const ReachRecord* reach) const {
  std::uint32_t sum = scene_->ambient[channel];
  for (unsigned l = 0; l < scene_->lights.size(); ++l) {
    std::uint32_t intensity = scene_->lights[l].intensity[channel];
    if (reach != nullptr) intensity = reached(intensity, in_channel(reach->light[l], channel));
    sum += (fall.amount[l] * intensity + (1u << 14)) >> 15;
  }
  return sum;
}

std::uint32_t LightRig::sum(const Normal10& normal, bool flip) const {
  return sum(fall(normal, flip), channel_, nullptr);
}

Rgb8 LightRig::shade(const Normal10& normal, const MaterialRecord& material, bool flip) const {
  if (material.shading == MaterialRecord::kUnlit) return material.color;
  const ReachRecord* const reach =
      material.reach == MaterialRecord::kAllLight ? nullptr : &scene_->reaches[material.reach];
  const Fall fall = this->fall(normal, flip);
  const auto lit = [&](std::uint8_t channel, unsigned i) {
    const std::uint32_t v = (channel * sum(fall, i, reach) + 128) >> 8;
    return static_cast<std::uint8_t>(v < 255 ? v : 255);
  };
  return {lit(material.color.r, 0), lit(material.color.g, 1), lit(material.color.b, 2)};
}

}  // namespace spanline
