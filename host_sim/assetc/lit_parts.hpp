// What a light sees of the faces of a scene (core/area/light_view.hpp), on the grids of their planes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "assetc/face_plane.hpp"

namespace spanline::host {

// A face in the world that takes light and throws a shadow.
struct LitFace {
  std::vector<Ring3> rings;        // world
  std::optional<FacePlane> plane;  // nothing where the face has no area, and no light falls on it
  Region own;                      // the rings on the grid of the plane, corner by corner
  Color transmission;              // black: opaque
};

// A region of a face, on its grid, and what the light that comes there has gone through.
struct LitPart {
  Color light;
  Region region;
};

struct LitParts {
  std::vector<std::vector<LitPart>> of_face;
  double unit;  // world: of the grid that the light's view is sorted on
};

// The view along `direction` (unit length). Throws InputError, with `place`, where it is too intricate for the pools of
// the area sort.
LitParts find_lit_parts(const std::vector<LitFace>& faces, Vec3 direction, const std::string& place);

}  // namespace spanline::host
