#include "oracle/random_camera_scene.hpp"

#include <algorithm>

#include "oracle/random_polygon.hpp"

namespace spanline::oracle {
namespace {

constexpr std::int32_t kUnit = 1 << 23;  // Q1.31: 1/256 world unit
constexpr int kMaxPolygons = 60;

struct Vector {
  int x, y, z;
};

Vector random_vector(Random& random, int size) {
  return {random.between(-size, size), random.between(-size, size), random.between(-size, size)};
}

std::int64_t divide_rounded(std::int64_t value, std::int64_t divisor) {
  return (2 * value + (value < 0 ? -divisor : divisor)) / (2 * divisor);
}

// A polygon in the plane of two whole vectors: exactly plane in mesh units.
std::vector<std::vector<Position>> random_plane_polygon(Random& random) {
  const int size = random.between(3, 30);
  const Vector u = random_vector(random, size);
  const Vector v = random_vector(random, size);
  const Vector origin = random_vector(random, random.percent(50) ? 300 : 1500);
  std::vector<std::vector<Position>> contours;
  for (const Contour& contour : random_polygon(random, {{0, 0}, random.between(20, 127)}, 1)) {
    std::vector<Position>& ring = contours.emplace_back();
    for (const Point& p : contour) {
      ring.push_back({static_cast<std::int16_t>(origin.x + u.x * p.x + v.x * p.y),
                      static_cast<std::int16_t>(origin.y + u.y * p.x + v.y * p.y),
                      static_cast<std::int16_t>(origin.z + u.z * p.x + v.z * p.y)});
    }
  }
  return contours;
}

Transform random_transform(Random& random) {
  const Rotation rotation = random_rotation(random);
  Transform transform{};
  for (int row = 0; row < 3; ++row) {
    const std::int64_t scale = random.between(1 << 15, 3 << 15);  // Q16.16: 0.5 … 1.5, another for each axis
    for (int column = 0; column < 3; ++column) {
      transform.matrix[row][column].raw =
          static_cast<std::int32_t>(divide_rounded(rotation.entry[row][column] * scale, rotation.divisor));
    }
    transform.translation[row].raw = random.between(-2 << 16, 2 << 16);
  }
  return transform;
}

// Looks towards the middle of the world from up to 10 units away, or past it.
CameraRecord random_camera(Random& random) {
  CameraRecord camera{};
  const Rotation rotation = random_rotation(random);
  const std::int64_t distance = random.between(0, random.percent(50) ? 4 << 16 : 10 << 16);  // Q16.16
  const int astray = random.percent(70) ? 0 : 3 << 16;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      camera.axes[row][column].raw =
          static_cast<std::int32_t>(divide_rounded(rotation.entry[row][column] * (1 << 30), rotation.divisor));
    }
  }
  for (int column = 0; column < 3; ++column) {
    camera.eye[column].raw =
        static_cast<std::int32_t>(divide_rounded(rotation.entry[2][column] * distance, rotation.divisor)) +
        random.between(-astray, astray);
  }
  camera.focal.raw = random.between(20 << 12, 150 << 12);
  camera.near_plane.raw = random.between(1 << 12, 1 << 16);
  camera.far_plane.raw = random.between(8 << 16, 200 << 16);
  return camera;
}

}  // namespace

Rotation random_rotation(Random& random) {
  const std::int64_t a = random.between(-9, 9);
  const std::int64_t b = random.between(-9, 9);
  const std::int64_t c = random.between(-9, 9);
  const std::int64_t d = random.between(1, 9);  // never the zero quaternion
  return {{{a * a + b * b - c * c - d * d, 2 * (b * c - a * d), 2 * (b * d + a * c)},
           {2 * (b * c + a * d), a * a - b * b + c * c - d * d, 2 * (c * d - a * b)},
           {2 * (b * d - a * c), 2 * (c * d + a * b), a * a - b * b - c * c + d * d}},
          a * a + b * b + c * c + d * d};
}

CameraScene random_camera_scene(std::uint64_t seed) {
  Random random(seed);
  CameraScene result;
  const int meshes = random.between(1, 3);
  for (int i = 0; i < meshes; ++i) {
    MeshStore& mesh = result.scene.add_mesh({random.percent(50), random.percent(50)}, kUnit);
    const int faces = random.between(1, kMaxPolygons / 4);
    for (int face = 0; face < faces; ++face) mesh.add_face(random_plane_polygon(random), result.scene.add_material());
  }
  const int instances = random.between(1, 4);
  for (int i = 0; i < instances; ++i) {
    const auto flags = random.percent(70) ? InstanceRecord::kTwoSided : InstanceRecord::kNone;
    InstanceRecord& instance = result.scene.add_instance(static_cast<std::uint16_t>(random.below(meshes)), flags);
    instance.transform = random_transform(random);
  }
  result.camera = random_camera(random);
  return result;
}

}  // namespace spanline::oracle
