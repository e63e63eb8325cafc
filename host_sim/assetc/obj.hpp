// A small strict reader of Wavefront OBJ: polygons of any number of corners, and colours by material library.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "assetc/color.hpp"
#include "assetc/vec.hpp"

namespace spanline::host {

inline constexpr std::int32_t kNone = -1;

struct ObjCorner {
  std::int32_t position;        // index into positions, from 0
  std::int32_t normal = kNone;  // index into normals, or kNone
};

struct ObjFace {
  std::uint32_t first_corner;
  std::uint32_t corner_count;  // at least 3
  std::int32_t material;       // index into materials, or kNone
  std::uint32_t line;          // of the file, from 1
};

struct ObjMaterial {
  std::string name;
  Color color;
  Color transmission{};  // what part of the light from behind comes through, of 255
};

struct ObjMesh {
  std::vector<Vec3> positions;
  std::vector<std::uint32_t> position_lines;  // the line of each position, for messages of later stages
  std::vector<Vec3> normals;
  std::vector<ObjCorner> corners;
  std::vector<ObjFace> faces;  // in the order of the `f` lines
  std::vector<ObjMaterial> materials;
};

// Reads `v`, `vn`, `f`, `mtllib` and `usemtl`; counts `vt`; passes over `o`, `g`, `s`. Everything else is an error, and
// so are numbers that are not finite, indices that are zero or out of range, faces with fewer than three corners or a
// corner twice in a row, more than 65,535 faces, or none. Throws InputError with file and line.
ObjMesh read_obj(const std::string& path);

// The same from text in memory; `name` stands for the file in messages and its folder is where material libraries are.
ObjMesh parse_obj(const std::string& name, std::string_view text);

// The materials of an MTL file: `newmtl`, `Kd`, `d` (how opaque), `Tr` (1 - d; where both stand, `d` counts) and `Tf`
// (the colour of what comes through); other statements of the format are passed over. A material without `Kd` is white.
// Throws InputError with file and line.
std::vector<ObjMaterial> read_mtl(const std::string& path);
std::vector<ObjMaterial> parse_mtl(const std::string& name, std::string_view text);

}  // namespace spanline::host
