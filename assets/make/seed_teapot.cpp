#include <cmath>
#include <stdexcept>

#include "assetc/bpt.hpp"
#include "shapes.hpp"

namespace spanline::make {

namespace {

constexpr std::size_t kWithoutBottom = 28;
constexpr double kFoot = 0.15;

// To five digits behind the point, so that a difference is as short as its terms; never -0.
double rounded(double v) { return std::round(v * 1e5) / 1e5 + 0.0; }

}  // namespace

void write_seed_teapot(const std::string& bpt, std::ostream& out) {
  const std::vector<host::BptPatch> patches = host::read_bpt(bpt);
  if (patches.size() < kWithoutBottom) throw std::runtime_error(bpt + ": has fewer than 28 patches");
  out << kWithoutBottom << "\n";
  for (std::size_t i = 0; i < kWithoutBottom; ++i) {
    out << "3 3\n";
    for (const auto& row : patches[i].points) {
      for (const host::Vec3& p : row)
        out << rounded(p.x) << " " << rounded(p.z - kFoot) << " " << rounded(-p.y) << "\n";
    }
  }
}

}  // namespace spanline::make
