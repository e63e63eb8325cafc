#include "frames/rivals.hpp"

#include <algorithm>

namespace spanline::bench {
namespace {

// tgx (with the M4's float unit) takes 307 KB for colour and depth, 31 KB in bands; small3dlib 230 to 460 KB; EmberGL
// 20 KB, in tiles.
constexpr Rival kRivals[] = {
    {"tgx", "S1", "m4", "flat", 358 + 113},
    {"tgx", "S1", "m4", "gouraud", 589 + 113},
    {"tgx", "S3", "m4", "flat", 1'089 + 113},
    {"tgx", "S3", "m4", "gouraud", 1'453 + 113},
    {"tgx", "S4", "m4", "flat", 2'247 + 113},
    {"tgx", "S4", "m4", "gouraud", 2'671 + 113},
    {"tgx", "S3", "m3", "flat", 8'325},
    {"tgx, 24-line bands", "S3", "m4", "flat", 4'136},
    {"small3dlib", "S1", "m4", "flat", 787 + 346},
    {"small3dlib", "S1", "m4", "gouraud", 1'177 + 346},
    {"small3dlib", "S3", "m4", "flat", 2'133 + 346},
    {"small3dlib", "S3", "m4", "gouraud", 2'710 + 346},
    {"small3dlib", "S4", "m4", "flat", 3'404 + 346},
    {"small3dlib", "S4", "m4", "gouraud", 4'009 + 346},
    {"small3dlib", "S1", "m3", "flat", 1'110},
    {"small3dlib", "S3", "m3", "flat", 2'427},
    {"small3dlib", "S4", "m3", "flat", 3'674},
    {"small3dlib", "S1", "m0plus", "flat", 1'639},
    {"small3dlib", "S3", "m0plus", "flat", 5'479},
    {"small3dlib", "S4", "m0plus", "flat", 9'690},
    {"EmberGL", "S1", "m4", "gouraud", 1'722},
    {"EmberGL", "S3", "m4", "gouraud", 3'822},
    {"EmberGL", "S4", "m4", "gouraud", 4'398},
};

}  // namespace

std::vector<Rival> rivals_of(const std::string& scene, const std::string& cpu, const std::string& shading) {
  std::vector<Rival> found;
  for (const Rival& rival : kRivals) {
    if (scene == rival.scene && cpu == rival.cpu && shading == rival.shading) found.push_back(rival);
  }
  std::sort(found.begin(), found.end(), [](const Rival& a, const Rival& b) { return a.thousands < b.thousands; });
  return found;
}

}  // namespace spanline::bench
