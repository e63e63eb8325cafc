#include "assetc/patch_sides.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <utility>
#include <vector>

namespace spanline::host {
namespace {

using Side = std::array<std::int32_t, 4>;

// A patch beside another one, and whether they turn different sides out.
struct Neighbour {
  std::size_t patch;
  bool opposed;
};

class PatchSides {
 public:
  explicit PatchSides(MeshSource& mesh) : mesh_(mesh), neighbours_(mesh.faces.size()), turned_(mesh.faces.size()) {
    struct Use {
      std::size_t patch;
      bool turned;
    };
    std::map<Side, std::vector<Use>> uses;
    for (std::size_t patch = 0; patch < mesh.faces.size(); ++patch) {
      for (const Side& side : sides_of(patch)) {
        if (side[0] == side[1] && side[1] == side[2] && side[2] == side[3]) continue;  // a pole
        const Side back{side[3], side[2], side[1], side[0]};
        uses[std::min(side, back)].push_back({patch, back < side});
      }
    }
    for (const auto& [side, at] : uses) {
      if (at.size() != 2 || at[0].patch == at[1].patch) continue;
      const bool opposed = at[0].turned == at[1].turned;
      neighbours_[at[0].patch].push_back({at[1].patch, opposed});
      neighbours_[at[1].patch].push_back({at[0].patch, opposed});
    }
  }

  void turn_out() {
    std::vector<bool> reached(mesh_.faces.size());
    for (std::size_t first = 0; first < reached.size(); ++first) {
      if (reached[first]) continue;
      reached[first] = true;
      std::vector<std::size_t> piece{first};
      for (std::size_t i = 0; i < piece.size(); ++i) {
        for (const Neighbour& next : neighbours_[piece[i]]) {
          if (reached[next.patch]) continue;
          reached[next.patch] = true;
          // neighbours_ is of the patches as they were in the file.
          if (next.opposed != turned_[piece[i]]) turn_over(next.patch);
          piece.push_back(next.patch);
        }
      }
      if (volume(piece) < 0) {
        for (const std::size_t patch : piece) turn_over(patch);
      }
    }
  }

 private:
  std::int32_t& corner(std::size_t patch, std::size_t row, std::size_t column) {
    return mesh_.corners[mesh_.faces[patch].first_corner + 4 * row + column].position;
  }
  Vec3 point(std::size_t patch, std::size_t row, std::size_t column) {
    return mesh_.positions[static_cast<std::size_t>(corner(patch, row, column))];
  }
  // Counter-clockwise as seen from the front.
  std::array<Side, 4> sides_of(std::size_t patch) {
    std::array<Side, 4> sides;
    for (std::size_t i = 0; i < 4; ++i) {
      sides[0][i] = corner(patch, 0, i);
      sides[1][i] = corner(patch, i, 3);
      sides[2][i] = corner(patch, 3, 3 - i);
      sides[3][i] = corner(patch, 3 - i, 0);
    }
    return sides;
  }
  void turn_over(std::size_t patch) {
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = 0; j < i; ++j) std::swap(corner(patch, i, j), corner(patch, j, i));
    }
    turned_[patch] = !turned_[patch];
  }
  // Six times what lies between the control nets and their middle.
  double volume(const std::vector<std::size_t>& piece) {
    Vec3 middle;
    for (const std::size_t patch : piece) {
      for (std::size_t i = 0; i < 16; ++i) middle = middle + point(patch, i / 4, i % 4);
    }
    middle = (1.0 / (16.0 * static_cast<double>(piece.size()))) * middle;
    double sum = 0;
    for (const std::size_t patch : piece) {
      for (std::size_t i = 0; i < 9; ++i) {
        const std::size_t row = i / 3, column = i % 3;
        const Vec3 a = point(patch, row, column) - middle, b = point(patch, row, column + 1) - middle;
        const Vec3 c = point(patch, row + 1, column + 1) - middle, d = point(patch, row + 1, column) - middle;
        sum += dot(a, cross(b, c)) + dot(a, cross(c, d));
      }
    }
    return sum;
  }

  MeshSource& mesh_;
  std::vector<std::vector<Neighbour>> neighbours_;
  std::vector<bool> turned_;
};

}  // namespace

void turn_patches_out(MeshSource& mesh) { PatchSides(mesh).turn_out(); }

}  // namespace spanline::host
