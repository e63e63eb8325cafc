#include "oracle/random_layers.hpp"

namespace spanline::oracle {
namespace {

Rgb8 random_transmission(Random& random) {
  const auto channel = [&random] { return static_cast<std::uint8_t>(random.percent(20) ? 255 : random.below(256)); };
  const std::uint8_t least = static_cast<std::uint8_t>(random.between(1, 255));  // not opaque
  return {least, channel(), channel()};
}

// A point on the line through two corners, a little past them at most.
Position random_point(Random& random, const std::vector<Position>& outline) {
  const int count = static_cast<int>(outline.size());
  const Position& a = outline[static_cast<std::size_t>(random.below(count))];
  const Position& b = outline[static_cast<std::size_t>(random.below(count))];
  const int part = random.between(-2, 18);  // sixteenths
  const auto mix = [part](int from, int to) {
    const int value = from + (to - from) * part / 16;
    return static_cast<std::int16_t>(value < -32768 ? -32768 : value > 32767 ? 32767 : value);
  };
  return {mix(a.x, b.x), mix(a.y, b.y), mix(a.z, b.z)};
}

}  // namespace

void add_random_layers(SceneStore& scene, Random& random) {
  constexpr int kChances[] = {0, 10, 50, 100};
  const int chance = kChances[random.below(4)];
  for (MaterialRecord& material : scene.materials()) {
    if (random.percent(chance)) material.transmission = random_transmission(random);
  }
  for (std::uint16_t i = 0; i < scene.mesh_count(); ++i) {
    MeshStore& mesh = scene.mesh(i);
    const int faces = mesh.face_count();
    const int favourite = random.below(faces);
    for (int more = random.below(13); more > 0; --more) {
      const auto parent = static_cast<std::uint16_t>(random.percent(30) ? favourite : random.below(faces));
      std::vector<Position> contour;
      for (int corners = random.between(3, 5); corners > 0; --corners) {
        contour.push_back(random_point(random, mesh.outline(parent)));
      }
      if (random.percent(30)) contour[0].z = static_cast<std::int16_t>(random.between(-32768, 32767));
      const std::uint16_t material = scene.add_material();
      const bool over_glass = scene.materials()[mesh.material(parent)].see_through();
      if (over_glass && random.percent(50)) scene.materials()[material].transmission = random_transmission(random);
      mesh.add_detail(parent, contour, material);
    }
  }
}

}  // namespace spanline::oracle
