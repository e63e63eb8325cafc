#include "assetc/extent.hpp"

namespace spanline::host {
namespace {

const MeshSource& mesh_of(const SceneDescription& scene, const InstanceSpec& instance) {
  return scene.meshes[static_cast<std::size_t>(instance.mesh)];
}

// Farthest that a point of the box is from the mesh's own origin: no turn moves it further.
double radius_about_origin(const Box& box) {
  const Vec3 far{std::max(std::fabs(box.low.x), std::fabs(box.high.x)),
                 std::max(std::fabs(box.low.y), std::fabs(box.high.y)),
                 std::max(std::fabs(box.low.z), std::fabs(box.high.z))};
  return length(far);
}

double stretch_of(const Pose& pose) { return largest({pose[7], pose[8], pose[9]}); }

}  // namespace

Box used_box(const MeshSource& mesh) {
  Box box;
  for (const ObjCorner& corner : mesh.corners) box.add(mesh.positions[static_cast<std::size_t>(corner.position)]);
  return box;
}

Sphere bounding_sphere(const SceneDescription& scene) {
  std::vector<Vec3> points;
  for (const InstanceSpec& instance : scene.instances) {
    if (instance.hidden || instance.on_screen) continue;
    const MeshSource& mesh = mesh_of(scene, instance);
    const Placement place = instance.placement(0);
    for (const ObjCorner& corner : mesh.corners) {
      points.push_back(place(mesh.positions[static_cast<std::size_t>(corner.position)]));
    }
  }
  Box box;
  for (const Vec3& p : points) box.add(p);
  if (box.empty()) return {};
  Sphere sphere{box.centre(), 0};
  for (const Vec3& p : points) sphere.radius = std::max(sphere.radius, length(p - sphere.centre));
  return sphere;
}

Box reach_of_instances(const SceneDescription& scene, const std::vector<Box>& boxes) {
  Box reach;
  for (const InstanceSpec& instance : scene.instances) {
    if (instance.on_screen) continue;
    const MeshSource& mesh = mesh_of(scene, instance);
    if (instance.motion.keys.empty()) {
      const Placement place = instance.placement(0);
      for (const ObjCorner& corner : mesh.corners) {
        reach.add(place(mesh.positions[static_cast<std::size_t>(corner.position)]));
      }
      continue;
    }
    const double radius = radius_about_origin(boxes[static_cast<std::size_t>(instance.mesh)]);
    for (const MotionKey& key : instance.motion.keys) {
      const double r = radius * stretch_of(key.pose);
      const Vec3 at{key.pose[0], key.pose[1], key.pose[2]};
      reach.add(at - Vec3{r, r, r});
      reach.add(at + Vec3{r, r, r});
    }
  }
  return reach;
}

double largest_stretch(const InstanceSpec& instance) {
  if (instance.matrix) {
    double most = 0;
    for (const Vec3& row : instance.matrix->rows) most = std::max(most, length(row));
    return most;
  }
  double most = instance.motion.keys.empty() ? stretch_of(instance.pose) : 0;
  for (const MotionKey& key : instance.motion.keys) most = std::max(most, stretch_of(key.pose));
  return most;
}

}  // namespace spanline::host
