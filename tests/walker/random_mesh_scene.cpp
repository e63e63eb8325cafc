#include "walker/random_mesh_scene.hpp"

#include <cmath>

#include "assetc/fans.hpp"
#include "oracle/random.hpp"
#include "oracle/random_camera_scene.hpp"

namespace spanline::test {
namespace {

using oracle::Random;

constexpr std::int32_t kUnit = 1 << 21;  // Q1.31: 1/1024 world unit
constexpr int kReach = 8000;             // mesh units

using Corner = std::uint16_t;
struct Mesh {
  std::vector<Position> positions;
  std::vector<Corner> corners;

  void vertex(double x, double y, double z) {
    positions.push_back({static_cast<std::int16_t>(std::lround(x)), static_cast<std::int16_t>(std::lround(y)),
                         static_cast<std::int16_t>(std::lround(z))});
  }
  void face(int a, int b, int c) {
    for (const int v : {a, b, c}) corners.push_back(static_cast<Corner>(v));
  }
  // Quads over a grid of columns x rows vertices, split one way or the other.
  void grid(Random& random, int columns, int rows) {
    for (int row = 0; row + 1 < rows; ++row) {
      for (int column = 0; column + 1 < columns; ++column) {
        const int a = row * columns + column, b = a + 1, c = a + columns, d = c + 1;
        if (random.percent(50)) {
          face(a, b, d);
          face(a, d, c);
        } else {
          face(a, b, c);
          face(b, d, c);
        }
      }
    }
  }
};

Mesh soup(Random& random) {
  Mesh mesh;
  const int vertices = random.between(3, 40), faces = random.between(1, 60);
  const int reach = random.percent(50) ? kReach : 600;
  for (int i = 0; i < vertices; ++i) {
    mesh.vertex(random.between(-reach, reach), random.between(-reach, reach), random.between(-reach, reach));
  }
  for (int i = 0; i < faces; ++i) mesh.face(random.below(vertices), random.below(vertices), random.below(vertices));
  return mesh;
}

Mesh sheet(Random& random) {
  Mesh mesh;
  const int columns = random.between(2, 12), rows = random.between(2, 12);
  const int noise = random.percent(30) ? 0 : random.between(1, 3000);
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      mesh.vertex((2.0 * column / (columns - 1) - 1) * kReach, (2.0 * row / (rows - 1) - 1) * kReach,
                  random.between(-noise, noise));
    }
  }
  mesh.grid(random, columns, rows);
  return mesh;
}

Mesh body(Random& random) {
  constexpr double kPi = 3.14159265358979;
  Mesh mesh;
  const int columns = random.between(4, 14), rows = random.between(3, 9);
  const int size = random.between(300, kReach);
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const double around = 2 * kPi * column / (columns - 1), down = kPi * row / (rows - 1);
      const double r = size * (1 - 0.001 * random.below(random.percent(50) ? 1 : 400));
      mesh.vertex(r * std::sin(down) * std::cos(around), r * std::cos(down), r * std::sin(down) * std::sin(around));
    }
  }
  mesh.grid(random, columns, rows);
  return mesh;
}

Mesh slivers(Random& random) {
  Mesh mesh;
  const int count = random.between(1, 30);
  for (int i = 0; i < count; ++i) {
    const int x = random.between(-kReach, kReach), y = random.between(-kReach, kReach);
    const int dx = random.between(-kReach, kReach), dy = random.between(-kReach, kReach);
    for (int k = 0; k < 3; ++k) {
      const int part = random.between(-100, 100);
      mesh.vertex((x + dx * part / 100) / 2.0 + random.between(-9, 9),
                  (y + dy * part / 100) / 2.0 + random.between(-9, 9), random.between(-kReach, kReach));
    }
    mesh.face(3 * i, 3 * i + 1, 3 * i + 2);
  }
  return mesh;
}

// Some faces once more, begun at another corner or run the other way.
void repeat_faces(Random& random, Mesh& mesh) {
  const std::size_t faces = mesh.corners.size() / 3;
  for (std::size_t face = 0; face < faces; ++face) {
    if (!random.percent(30)) continue;
    const int first = random.below(3), step = random.percent(70) ? 1 : 2;
    const Corner* const corner = mesh.corners.data() + 3 * face;
    const int a = corner[first], b = corner[(first + step) % 3], c = corner[(first + 2 * step) % 3];
    mesh.face(a, b, c);
  }
}

Normal10 random_normal(Random& random) {
  return Normal10::pack(random.between(-511, 511), random.between(-511, 511), random.between(-511, 511));
}

host::MeshTables tables_of(Random& random, const Mesh& mesh, int materials) {
  host::MeshTables tables;
  tables.name = "random";
  tables.positions = mesh.positions;
  tables.corners = mesh.corners;
  tables.face_count = static_cast<std::uint16_t>(mesh.corners.size() / 3);
  tables.unit = kUnit;
  for (std::size_t i = 0; i < tables.face_count; ++i) tables.face_normals.push_back(random_normal(random));
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) tables.vertex_normals.push_back(random_normal(random));
  // One group, or two of different materials.
  const int cut = tables.face_count > 1 && random.percent(50) ? random.between(1, tables.face_count - 1) : 0;
  const auto group = [&](int first, int end) {
    tables.groups.push_back({static_cast<std::uint32_t>(3 * first), static_cast<std::uint16_t>(first),
                             static_cast<std::uint16_t>(end - first), 3, 0, 1,
                             static_cast<std::uint16_t>(random.below(materials))});
  };
  if (cut != 0) group(0, cut);
  group(cut, tables.face_count);
  host::build_fans(tables);
  return tables;
}

std::int32_t fixed(double value, int fraction) {
  return static_cast<std::int32_t>(std::lround(std::ldexp(value, fraction)));
}

Transform random_transform(Random& random) {
  const oracle::Rotation rotation = oracle::random_rotation(random);
  const double scale = random.between(30, 150) / 100.0;
  Transform transform{};
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      const double entry = static_cast<double>(rotation.entry[row][column]) / static_cast<double>(rotation.divisor);
      transform.matrix[row][column].raw = fixed(scale * entry, 16);
    }
    transform.translation[row].raw = fixed(random.between(-300, 300) / 100.0, 16);
  }
  return transform;
}

CameraRecord random_camera(Random& random) {
  const oracle::Rotation rotation = oracle::random_rotation(random);
  CameraRecord camera{};
  const double distance = random.percent(20) ? random.between(3, 20) : random.between(20, 60);
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      const double entry = static_cast<double>(rotation.entry[row][column]) / static_cast<double>(rotation.divisor);
      camera.axes[row][column].raw = fixed(entry, 30);
      if (row == 2) camera.eye[column].raw = fixed(distance * entry, 16);
    }
  }
  camera.focal.raw = fixed(random.percent(50) ? random.between(20, 300) : random.between(200, 1500), 12);
  camera.near_plane.raw = fixed(0.5, 16);
  camera.far_plane.raw = fixed(100, 16);
  return camera;
}

// Ambient light of any hue, and lights of another one, from where they may.
void tint(Random& random, MeshScene& scene) {
  for (std::uint16_t& channel : scene.ambient) channel = static_cast<std::uint16_t>(random.below(200));
  int hue[3];
  for (int& channel : hue) channel = random.below(256);
  scene.lights.clear();
  for (int count = random.between(0, 3); count > 0; --count) {
    LightRecord light{};
    light.direction[random.below(3)].raw = random.percent(50) ? Fx30::kOne : -Fx30::kOne;
    const double amount = random.between(10, 120) / 100.0;
    for (int i = 0; i < 3; ++i) light.intensity[i] = static_cast<std::uint16_t>(std::lround(amount * hue[i]));
    scene.lights.push_back(light);
  }
}

}  // namespace

SceneRecord MeshScene::record() {
  mesh_records.clear();
  for (const host::MeshTables& mesh : meshes) mesh_records.push_back(mesh.record());
  const auto slice = [](const auto& items) { return Slice(items.data(), static_cast<std::uint32_t>(items.size())); };
  return {
      slice(mesh_records),     slice(instances), slice(materials), slice(lights), {ambient[0], ambient[1], ambient[2]},
      {{9, 9, 9}, {9, 9, 200}}};
}

MeshScene random_mesh_scene(std::uint64_t seed) {
  Random random(seed);
  MeshScene scene;
  const int materials = random.between(1, 3);
  for (int i = 0; i < materials; ++i) {
    const auto channel = [&] { return static_cast<std::uint8_t>(random.below(256)); };
    scene.materials.push_back({{channel(), channel(), channel()},
                               random.percent(20)   ? MaterialRecord::kUnlit
                               : random.percent(50) ? MaterialRecord::kGouraud
                                                    : MaterialRecord::kFlat});
  }
  LightRecord light{};
  light.direction[2].raw = -Fx30::kOne;
  for (std::uint16_t& intensity : light.intensity) intensity = 192;
  scene.lights.push_back(light);
  const int meshes = random.between(1, 3);
  for (int i = 0; i < meshes; ++i) {
    const int kind = random.below(10);
    Mesh mesh = kind < 3 ? soup(random) : kind < 6 ? sheet(random) : kind < 9 ? body(random) : slivers(random);
    if (random.percent(20)) repeat_faces(random, mesh);
    scene.meshes.push_back(tables_of(random, mesh, materials));
  }
  const int instances = random.between(1, 4);
  for (int i = 0; i < instances; ++i) {
    InstanceRecord instance{};
    instance.mesh = static_cast<std::uint16_t>(random.below(meshes));
    if (random.percent(5)) instance.flags = InstanceRecord::kHidden;
    instance.transform = i > 0 && random.percent(15) ? scene.instances.back().transform : random_transform(random);
    scene.instances.push_back(instance);
  }
  scene.camera = random_camera(random);
  scene.screen = {static_cast<std::uint16_t>(random.between(1, 320)),
                  static_cast<std::uint16_t>(random.between(1, 240)),
                  static_cast<PixelFormat>(random.percent(70) ? 0 : random.below(4))};
  if (random.percent(50)) tint(random, scene);
  return scene;
}

}  // namespace spanline::test
