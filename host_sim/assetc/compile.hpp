// The scene compiler: a description in doubles to the flash records of core/scene/format.hpp.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "assetc/camera.hpp"
#include "assetc/scene_description.hpp"
#include "core/scene/format.hpp"

namespace spanline::host {

// The storage behind one MeshRecord.
struct MeshTables {
  std::string name;
  std::vector<Position> positions;
  std::vector<Normal10> vertex_normals;
  std::vector<Normal10> face_normals;
  std::vector<std::uint16_t> corners;
  std::vector<std::uint16_t> contours;
  std::vector<FaceGroup> groups;
  std::vector<CurveRecord> curves;
  std::vector<std::uint16_t> parents;
  std::uint16_t face_count = 0;
  Fx16 origin[3];
  std::int32_t unit = 1;
  std::vector<std::uint16_t> fan_starts;
  std::vector<FanEdge> fans;

  MeshRecord record() const;
};

// What a mesh's records are relative to: mesh = scale * (own - pivot).
struct MeshFit {
  double scale = 1;
  Vec3 pivot;
  Vec3 operator()(Vec3 p) const { return scale * (p - pivot); }
};

// Builds the tables of one mesh. `materials` are those of the scene; `smooth`: some Gouraud material draws it, so
// vertices are split by normal; `on_screen`: positions are screen coordinates. Throws InputError where 16-bit indices
// do not suffice.
MeshTables compile_mesh(const MeshSource& mesh, const std::vector<MaterialSpec>& materials, const MeshFit& fit,
                        bool smooth, bool on_screen);

// A scene as records, with the storage behind them. The records refer into the object, which can be moved.
class CompiledScene {
 public:
  CompiledScene(CompiledScene&&) = default;
  CompiledScene& operator=(CompiledScene&&) = default;
  CompiledScene(const CompiledScene&) = delete;
  CompiledScene& operator=(const CompiledScene&) = delete;

  // Sets instances, default light and camera to `frame` (>= 0). Throws InputError where the camera of that frame sees
  // nothing.
  void show(std::int64_t frame);

  // Looks from elsewhere (the world scale was chosen for eyes within the `reach` given to compile()).
  void look(const View& view);

  // Makes larger faces of coplanar neighbours (merge.hpp). Faces are numbered anew.
  void merge_coplanar(std::uint32_t most_corners);
  void merge_coplanar(std::size_t mesh, std::uint32_t most_corners);
  // Cuts faces into triangles (triangulate.hpp). Faces are numbered anew. The names of the meshes for which that cannot
  // be, which stay as they are.
  std::vector<std::string> triangulate();
  // Puts other tables in the place of a mesh's.
  void replace(std::size_t mesh, MeshTables tables);

  SceneRecord record() const;
  const CameraRecord& camera() const { return camera_; }
  const View& view() const { return view_; }
  const Sphere& bounds() const { return bounds_; }  // of what is drawn in frame 0, in the scene's own units
  const WorldFit& fit() const { return fit_; }
  const std::vector<MeshFit>& mesh_fits() const { return mesh_fits_; }  // of each mesh
  const std::vector<MeshTables>& meshes() const { return meshes_; }
  const std::vector<InstanceRecord>& instances() const { return instances_; }
  const std::vector<MaterialRecord>& materials() const { return materials_; }
  const std::vector<LightRecord>& lights() const { return lights_; }
  const SceneDescription& description() const { return scene_; }
  bool moves() const;

 private:
  friend CompiledScene compile(SceneDescription scene, double reach);
  explicit CompiledScene(SceneDescription scene) : scene_(std::move(scene)) {}
  void place_instances(std::int64_t frame);
  void make_records(std::int64_t frame);

  SceneDescription scene_;
  std::optional<SceneDescription> unshadowed_;  // what shadows are baked from, where there are any
  std::int64_t baked_ = 0;                      // the frame that they were baked in
  Sphere bounds_;
  WorldFit fit_;
  std::vector<MeshFit> mesh_fits_;
  std::vector<MeshTables> meshes_;
  std::vector<MeshRecord> mesh_records_;
  std::vector<InstanceRecord> instances_;
  std::vector<MaterialRecord> materials_;
  std::vector<LightRecord> lights_;
  View view_{};
  CameraRecord camera_{};
};

// Compiles a scene and shows frame 0. One uniform scale is chosen so that every vertex and eye of all frames, and eyes
// up to `reach` bounding radii off the scene's centre, lie within kMaxWorld units. Throws InputError where the scene is
// too large for 16-bit numbers of faces and vertices, or nothing can be seen.
CompiledScene compile(SceneDescription scene, double reach = 0);

}  // namespace spanline::host
