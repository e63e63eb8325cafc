#include "lathe.hpp"

namespace spanline::make {

void lathe(Mesh& mesh, const std::vector<std::array<double, 2>>& profile, int steps) {
  for (std::size_t edge = 0; edge < profile.size(); ++edge) {
    const auto& from = profile[edge];
    const auto& to = profile[(edge + 1) % profile.size()];
    const double rise = to[1] - from[1];
    const double inward = from[0] - to[0];
    for (int i = 0; i < steps; ++i) {
      const auto corner = [&](int step, const std::array<double, 2>& end) -> Mesh::Corner {
        const double angle = 2 * kPi * (step % steps) / steps;
        return {polar(end[0], angle) + Vec{0, 0, end[1]}, unit(polar(rise, angle) + Vec{0, 0, inward})};
      };
      mesh.face({corner(i, from), corner(i + 1, from), corner(i + 1, to), corner(i, to)});
    }
  }
}

}  // namespace spanline::make
