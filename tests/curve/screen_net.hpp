// A patch on the screen in floating point, its control points projected: what baselines that know no perspective draw.
#pragma once

#include <array>
#include <map>
#include <utility>

#include "curve/curves.hpp"
#include "curve/patch_scene.hpp"

namespace spanline::test {

class ScreenNet {
 public:
  At control[4][4];  // rows along v, the points of a row along u; px

  // The patch lies before the eye as a whole.
  ScreenNet(const PatchView& view, const PatchPoints& points);

  At at(double u, double v) const;

  struct Derivatives {
    At along_u, along_v;
    // Positive where v lies clockwise of u on the screen.
    double turn() const { return along_u.x * along_v.y - along_u.y * along_v.x; }
  };
  Derivatives derivatives(double u, double v) const;

  std::array<Cubic, 4> sides() const;

  // The pixels whose centres the patch covers, by line and column, with the place on it within a 32nd of it: of what
  // turns to the left, and of what turns to the right. Where one of them lies over itself, one of its places.
  struct Root {
    double u, v;
  };
  using Sheet = std::map<std::pair<int, int>, Root>;
  std::array<Sheet, 2> sheets() const;
};

}  // namespace spanline::test
