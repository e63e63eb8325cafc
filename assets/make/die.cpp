#include "shapes.hpp"

namespace spanline::make {

namespace {

constexpr double kPip = 0.19;     // radius; the die's half side is 1
constexpr double kOffset = 0.52;  // of the outer pips from the middle

// Where the pips of each side lie, in steps of kOffset.
struct Pip {
  int a, b;
};
const std::vector<std::vector<Pip>> kSides = {{{0, 0}},
                                              {{-1, -1}, {1, 1}},
                                              {{-1, -1}, {0, 0}, {1, 1}},
                                              {{-1, -1}, {-1, 1}, {1, -1}, {1, 1}},
                                              {{-1, -1}, {-1, 1}, {0, 0}, {1, -1}, {1, 1}},
                                              {{-1, -1}, {0, -1}, {1, -1}, {-1, 1}, {0, 1}, {1, 1}}};

// Sides 1 to 6; opposite ones add up to seven.
Vec on_side(int side, double a, double b) {
  switch (side) {
    case 1:
      return {a, 1, -b};
    case 2:
      return {a, b, 1};
    case 3:
      return {1, b, -a};
    case 4:
      return {-1, b, a};
    case 5:
      return {-a, b, -1};
    default:
      return {a, -1, b};
  }
}

}  // namespace

Mesh die(const std::string& body, const std::string& pips) {
  Mesh mesh;
  mesh.material(body);
  for (int side = 1; side <= 6; ++side) {
    mesh.flat({on_side(side, -1, -1), on_side(side, 1, -1), on_side(side, 1, 1), on_side(side, -1, 1)});
  }
  mesh.material(pips);
  for (int side = 1; side <= 6; ++side) {
    for (const Pip& pip : kSides[static_cast<std::size_t>(side - 1)]) {
      std::vector<Vec> round;
      constexpr int kCorners = 10;
      for (int i = 0; i < kCorners; ++i) {
        const double angle = 2 * kPi * i / kCorners;
        round.push_back(
            on_side(side, kOffset * pip.a + kPip * std::cos(angle), kOffset * pip.b + kPip * std::sin(angle)));
      }
      mesh.flat(round);
    }
  }
  return mesh;
}

}  // namespace spanline::make
