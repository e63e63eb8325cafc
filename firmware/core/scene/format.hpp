// The flash records: plain data that the scene compiler writes as constexpr tables and the simulator builds in memory.
// One layout, one source. Nothing here is trusted before SceneView has validated it.
#pragma once

#include <cstdint>

#include "core/base/slice.hpp"
#include "core/fx/fixed.hpp"

namespace spanline {

inline constexpr std::uint32_t kMaxSceneFaces = 65535;     // face numbers are 16 bits, 65535 means none
inline constexpr std::uint32_t kMaxSceneVertices = 65535;  // over all instances
inline constexpr std::uint32_t kMaxSceneCurves = 65535;    // over all instances
inline constexpr std::uint32_t kMaxLights = 4;
inline constexpr std::int32_t kMaxWorld = 4096;  // |world coordinate| in units: leaves 3 bits of head-room in Q16.16

// A mesh vertex in mesh units (see MeshRecord::unit). On the screen (InstanceRecord::kScreen) x and y are 1/16 px, y
// down, and z is the depth less 32768 (larger is nearer).
struct Position {
  std::int16_t x, y, z;
};

// Axis-parallel, both ends within; all there is unless told otherwise.
struct PositionBox {
  Position low{INT16_MIN, INT16_MIN, INT16_MIN}, high{INT16_MAX, INT16_MAX, INT16_MAX};

  constexpr bool holds_all() const { return holds(PositionBox{}.low) && holds(PositionBox{}.high); }
  constexpr bool holds(const Position& p) const {
    return low.x <= p.x && p.x <= high.x && low.y <= p.y && p.y <= high.y && low.z <= p.z && p.z <= high.z;
  }
  // One of eight.
  constexpr Position corner(unsigned i) const {
    return {(i & 1) == 0 ? low.x : high.x, (i & 2) == 0 ? low.y : high.y, (i & 4) == 0 ? low.z : high.z};
  }
};

// A unit normal, 10 bits a component, each Q1.9 in -511 … 511, packed x | y << 10 | z << 20.
struct Normal10 {
  std::uint32_t packed;

  static constexpr Normal10 pack(int x, int y, int z) {
    return {(static_cast<std::uint32_t>(x) & 1023u) | (static_cast<std::uint32_t>(y) & 1023u) << 10 |
            (static_cast<std::uint32_t>(z) & 1023u) << 20};
  }
  constexpr std::int32_t x() const { return component(22); }
  constexpr std::int32_t y() const { return component(12); }
  constexpr std::int32_t z() const { return component(2); }

 private:
  constexpr std::int32_t component(int up) const { return static_cast<std::int32_t>(packed << up) >> 22; }
};

struct Rgb8 {
  std::uint8_t r, g, b;
  friend constexpr bool operator==(const Rgb8&, const Rgb8&) = default;
};

struct MaterialRecord {
  enum Shading : std::uint8_t { kFlat, kGouraud, kUnlit };
  static constexpr std::uint16_t kAllLight = 0xffff;
  Rgb8 color;
  Shading shading = kFlat;
  // What part t of the light from behind comes through, of 255, a channel: a pixel is (255 - t) / 255 of the lit colour
  // and t / 255 of what lies behind. All 0: opaque.
  Rgb8 transmission{};
  std::uint16_t reach = kAllLight;  // index into SceneRecord::reaches: how much of each light comes here

  constexpr bool see_through() const { return transmission != Rgb8{}; }
};

// What part of each light reaches a surface, of 255, a channel: 0 in full shadow, in between behind translucent
// polygons. Parallel to SceneRecord::lights.
struct ReachRecord {
  Rgb8 light[kMaxLights];
};

// A run of faces that look alike: the same number of corners, contours and the same material.
// Face i of the run (i < face_count) has the mesh's face number first_face + i and the corners
// [first_corner + i * corners_per_face, + corners_per_face) of MeshRecord::corners. With contour_count > 1 the corners
// are several rings in a row whose lengths stand in MeshRecord::contours from first_contour on (each at least 3; they
// add up to corners_per_face, else the contour is unclosed and the record is refused). Filling is even-odd, so holes
// need no direction.
//
// With contour_count kPatches each face is a bicubic Bezier patch and its kPatchCorners corners are the control points,
// four rows of four. Rows run along v, the points of a row along u; the front is where u, v and the normal are
// right-handed.
//
// With kCurved in contour_count each ring is a closed chain of cubic Bezier curves: of its 3 n corners, n >= 2, every
// third from the first on lies on the outline, the others are control points. Such faces are flat or unlit, and the
// polygon of all their corners says which side is the front.
struct FaceGroup {
  static constexpr std::uint16_t kPatches = 0;
  static constexpr std::uint16_t kPatchCorners = 16;
  static constexpr std::uint16_t kCurved = 0x8000;
  std::uint32_t first_corner;
  std::uint16_t first_face;
  std::uint16_t face_count;
  std::uint16_t corners_per_face;
  std::uint16_t first_contour;
  std::uint16_t contour_count;  // 1: a single ring, first_contour is not used; kPatches; may have kCurved
  std::uint16_t material;       // index into SceneRecord::materials

  constexpr bool curved() const { return (contour_count & kCurved) != 0; }
  constexpr std::uint16_t rings() const { return contour_count & (kCurved - 1); }
};

// An edge as one of its two vertices sees it: what the edge walker starts when its line comes to that vertex. Both
// vertices have it in their fans, each from its own side.
//
// A fan goes round its vertex counter-clockwise, so a face is named once, between the edges that it lies between: the
// face whose ring runs to the fan's vertex is that of the entry before, and of the first one the fan's last. Where a
// vertex has more than one round of faces, an entry whose `to` is the vertex itself stands before each that does not go
// on from the one before, with the face of the round's last.
struct FanEdge {
  static constexpr std::uint16_t kNone = 0xffff;
  static constexpr std::uint32_t kMostFaces = 0x8000;  // of a mesh with fans: kNone is its one negative face
  static constexpr std::uint32_t kMostInFan = 1024;    // entries: checking a fan takes time by their square

  std::uint16_t to;    // the other vertex
  std::uint16_t face;  // mesh face whose ring runs from the fan's vertex to `to`; kNone at a border
};

// A curve, drawn as a stroke of constant width on the screen, over all faces; unlit. Its points are MeshRecord::corners
// [first_corner, + point_count), indices into positions.
struct CurveRecord {
  enum Kind : std::uint8_t {
    kBezier,      // cubic pieces that share their ends: 3 n + 1 points, closed 3 n
    kQuadratic,   // likewise: 2 n + 1 points, closed 2 n
    kBSpline,     // uniform cubic: n + 3 points, closed n
    kCatmullRom,  // runs through all points but the first and the last: n + 3 points, closed n
  };
  enum Flags : std::uint8_t {
    kOpen = 0,
    kClosed = 1,  // the last piece ends where the first begins
    kSmooth = 2,  // anti-aliased; a width of 0 then is one pixel
  };
  static constexpr std::uint16_t kMaxWidth = 64 * 16;  // 1/16 px

  std::uint32_t first_corner;
  std::uint16_t point_count;
  Kind kind;
  std::uint8_t flags;
  std::uint16_t width;     // 1/16 px, joins and ends are round; 0: the pixels that the curve runs through
  std::uint16_t material;  // index into SceneRecord::materials

  // How many cubic pieces the points make; 0 where their number is not one of the kind's.
  constexpr std::uint32_t pieces() const {
    const bool closed = (flags & kClosed) != 0;
    if (kind == kBSpline || kind == kCatmullRom) {
      return closed ? (point_count >= 3 ? point_count : 0) : (point_count >= 4 ? point_count - 3u : 0);
    }
    const std::uint32_t degree = kind == kBezier ? 3 : 2, legs = closed ? point_count : point_count - 1u;
    return point_count != 0 && legs % degree == 0 ? legs / degree : 0;
  }
};

// Shared geometry: faces, curves, or both. World position of a vertex = instance transform of (origin + unit *
// position), where unit is Q1.31 world units for one mesh unit. Groups follow each other by first_face without gaps,
// from 0 to face_count. The faces of a mesh are all polygons or all patches. Patches have no normals in the record:
// they come from their shape.
//
// The last parents.size() faces are surface detail (seed 2): face face_count - parents.size() + i lies on the face
// parents[i], which is no detail itself. Detail shows wherever its parent is visible and it covers; its own depth
// counts for nothing. Of several layers on one parent the highest face number lies on top. On a see-through parent
// detail takes the place of the parent's surface; see-through detail on an opaque parent is refused.
struct MeshRecord {
  const char* name;
  Slice<const Position> positions;
  Slice<const Normal10> vertex_normals;  // one a position, or empty (then Gouraud materials are refused)
  Slice<const Normal10> face_normals;    // one a face, or empty (then only unlit materials are allowed)
  Slice<const std::uint16_t> corners;    // indices into positions
  Slice<const std::uint16_t> contours;   // ring lengths of faces with holes
  Slice<const FaceGroup> groups;
  std::uint16_t face_count;
  Fx16 origin[3];
  std::int32_t unit;  // Q1.31, > 0
  // Of triangle meshes only, for the edge walker: the edges around vertex v are [fan_starts[v], fan_starts[v + 1]) of
  // fans. Both empty: the mesh has no fans.
  Slice<const std::uint16_t> fan_starts = {};
  Slice<const FanEdge> fans = {};
  Slice<const CurveRecord> curves = {};
  Slice<const std::uint16_t> parents = {};  // of the surface detail
  PositionBox box = {};                     // around the positions, the smaller the better

  constexpr bool of_patches() const { return !groups.empty() && groups[0].contour_count == FaceGroup::kPatches; }
};

// World = matrix * mesh + translation. Rows of the matrix are x, y, z; Q16.16.
struct Transform {
  Fx16 matrix[3][3];
  Fx16 translation[3];

  static constexpr Transform identity() {
    const Fx16 one = Fx16::from_int(1);
    return {{{one, {}, {}}, {{}, one, {}}, {{}, {}, one}}, {}};
  }
  friend constexpr bool operator==(const Transform&, const Transform&) = default;
};

struct InstanceRecord {
  enum Flags : std::uint16_t {
    kNone = 0,
    kTwoSided = 1,  // no back-face culling; normals turn to the viewer
    kScreen = 2,    // positions are on the screen already: no transform, no camera, no culling, no light
    kHidden = 4,    // not drawn; its faces keep their numbers
  };
  static constexpr std::uint16_t kOwnMaterials = 0xffff;
  std::uint16_t mesh;
  std::uint16_t flags = kNone;
  std::uint16_t material = kOwnMaterials;  // replaces every material of the mesh, kOwnMaterials keeps them
  Transform transform = Transform::identity();

  friend constexpr bool operator==(const InstanceRecord&, const InstanceRecord&) = default;
};

// A directional light. Intensities are Q8.8 a channel, 256 = full.
struct LightRecord {
  Fx30 direction[3];  // unit vector, the way the light travels, in the world
  std::uint16_t intensity[3];
};

struct BackgroundRecord {
  Rgb8 top;
  Rgb8 bottom;  // the same as top: one colour; otherwise a vertical gradient over the screen's height
  friend constexpr bool operator==(const BackgroundRecord&, const BackgroundRecord&) = default;
};

// Everything that does not move with the viewer. Faces are numbered through the instances in order.
struct SceneRecord {
  Slice<const MeshRecord> meshes;
  Slice<const InstanceRecord> instances;
  Slice<const MaterialRecord> materials;
  Slice<const LightRecord> lights;
  std::uint16_t ambient[3];  // Q8.8 a channel
  BackgroundRecord background;
  Slice<const ReachRecord> reaches = {};
};

// The viewer: right-handed, +Y up, looking along -Z of its own frame.
struct CameraRecord {
  Fx16 eye[3];
  Fx30 axes[3][3];  // rows: right, up, back; orthonormal
  Fx12 focal;       // Q20.12 px: distance of the picture plane in pixels, = height / 2 / tan(fov / 2)
  Fx16 near_plane;  // > 0; depth is near_plane / distance
  Fx16 far_plane;   // > near_plane

  friend constexpr bool operator==(const CameraRecord&, const CameraRecord&) = default;
};

}  // namespace spanline
