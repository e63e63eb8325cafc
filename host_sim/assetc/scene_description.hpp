// A scene as the user wrote it, in doubles: what the OBJ and JSON readers make and the compiler turns into records.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "assetc/motion.hpp"
#include "assetc/obj.hpp"

namespace spanline::host {

using Shading = MaterialRecord::Shading;

struct MaterialSpec {
  std::string name;
  Color color{200, 205, 215};
  Shading shading = Shading::kFlat;
  Color transmission{};                             // MaterialRecord::transmission
  std::uint16_t reach = MaterialRecord::kAllLight;  // into SceneDescription::reaches
};

// A face of one or more rings; the first is the outline, whose direction says which side is the front. With ring_count
// FaceGroup::kPatches it is a patch, whose corners are its sixteen control points.
struct MeshFace {
  std::uint32_t first_corner;
  std::uint32_t corner_count;
  std::uint32_t first_ring;  // into MeshSource::rings; unused with a single ring
  std::uint32_t ring_count;
  std::int32_t material;  // into SceneDescription::materials, or kNone: `default_material` of the scene
  bool curved = false;    // see FaceGroup::kCurved
};

// A stroke; its points are MeshSource::corners.
struct MeshCurve {
  std::uint32_t first_corner = 0;
  std::uint16_t point_count = 0;
  CurveRecord::Kind kind = CurveRecord::kBezier;
  bool closed = false;
  bool smooth = true;
  double width = 1;               // px
  std::int32_t material = kNone;  // as MeshFace::material

  CurveRecord record(std::uint16_t default_material) const;
};

struct MeshSource {
  std::string name;
  std::string place;  // for messages: the file, or the JSON path of an inline mesh
  std::vector<Vec3> positions;
  std::vector<Vec3> normals;
  std::vector<ObjCorner> corners;
  std::vector<std::uint16_t> rings;  // ring lengths of faces with several
  std::vector<MeshFace> faces;       // all polygons or all patches
  std::vector<MeshCurve> curves;
  std::vector<std::uint16_t> parents;  // the last faces are surface detail on these (detail.hpp)

  bool of_patches() const { return !faces.empty() && faces[0].ring_count == FaceGroup::kPatches; }
};

// How the faces of an OBJ, or patches, are shaded by themselves.
enum class MeshShading { automatic, flat, gouraud, unlit };

struct InstanceSpec {
  std::int32_t mesh = 0;
  std::int32_t material = kNone;
  bool cull = true;
  bool hidden = false;
  bool on_screen = false;           // see InstanceRecord::kScreen; positions in 1/16 px
  bool shadows = true;              // throws shadows and has them thrown on, where the scene has any
  std::optional<Placement> matrix;  // given as it is; otherwise by `pose`
  bool turn_by_axis = false;  // how the four turn numbers of the pose are meant: x, y, z, angle; or x, y, z angles
  Pose pose{0, 0, 0, 0, 0, 0, 0, 1, 1, 1};
  Motion motion;

  Placement placement(std::int64_t frame) const;
};

struct CameraSpec {
  bool has_eye = false;
  bool has_target = false;
  Vec3 eye, target;
  Vec3 up{0, 1, 0};
  double fov = 45;                  // degrees, vertical
  std::optional<double> near, far;  // absent: around the bounding sphere
  Motion motion;
};

struct LightSpec {
  Vec3 direction;  // the way it travels; not zero
  Vec3 intensity{0.75, 0.75, 0.75};
};

struct SceneDescription {
  std::string place;  // the file given on the command line
  std::uint16_t width = 320, height = 240;
  CameraSpec camera;
  Vec3 ambient{0.25, 0.25, 0.25};
  std::optional<std::vector<LightSpec>> lights;  // absent: the default light
  BackgroundRecord background{{18, 22, 42}, {66, 76, 104}};
  bool shadows = false;  // to be baked (bake.hpp)
  std::vector<MaterialSpec> materials;
  std::vector<ReachRecord> reaches;  // made by baking (bake.hpp)
  std::vector<MeshSource> meshes;
  std::vector<InstanceSpec> instances;
};

// Appends the mesh of an OBJ and its materials to `scene`; the index of the new mesh.
std::int32_t add_obj(SceneDescription& scene, const ObjMesh& obj, const std::string& name, const std::string& place,
                     MeshShading shading);

// One instance of an OBJ, seen by the default camera.
SceneDescription describe_obj(const std::string& path, MeshShading shading);

// One instance of an OBJ whose x, y are whole 1/16 px (y down) and z a whole depth 0 … 65535. Throws InputError with
// the line of a vertex that is anything else. Where the file has no colours, faces are painted by their slope and
// number.
SceneDescription describe_screen_obj(const std::string& path);

}  // namespace spanline::host
