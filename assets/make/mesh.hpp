#pragma once

#include <array>
#include <map>
#include <ostream>
#include <string>
#include <vector>

#include "vec.hpp"

namespace spanline::make {

// A polygon mesh under construction. Positions and normals that print alike are one, so neighbours share their vertices
// and the mesh is watertight by construction; corners that fall together are dropped, and so are faces left with fewer
// than three.
class Mesh {
 public:
  struct Corner {
    Vec position;
    Vec normal;  // unit length, outward
  };

  // One face, corners counter-clockwise as seen from outside.
  void face(const std::vector<Corner>& corners);
  // The same with one normal for the whole face, taken from its corners (Newell's sum, so n-gons may be concave).
  void flat(const std::vector<Vec>& corners);
  // Faces that follow wear this material of the mesh's .mtl file.
  void material(const std::string& name);

  // Writes OBJ: `comment` first, then v, vn and f lines in the order of making.
  void write(std::ostream& out, const std::string& comment, const std::string& mtl = "") const;

 private:
  using Key = std::array<long, 3>;
  struct Pool {
    std::map<Key, int> index;
    std::vector<Key> values;
    int add(Vec value, double scale);
  };
  struct Face {
    std::vector<std::array<int, 2>> corners;
    std::string material;
  };

  Pool positions_;
  Pool normals_;
  std::vector<Face> faces_;
  std::string material_;
};

}  // namespace spanline::make
