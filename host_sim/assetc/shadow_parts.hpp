// How the lights of a scene divide a face: parts that all lights reach alike.
#pragma once

#include <array>
#include <map>
#include <vector>

#include "assetc/lit_parts.hpp"

namespace spanline::host {

// A part of a face, on its grid, and what of each light reaches it.
struct ShadowPart {
  ReachRecord reach;
  Region region;
};

class ShadowParts {
 public:
  // `face` is the region of the face on the plane's grid.
  ShadowParts(Region face, RegionClipper& clipper);

  // What a light sees of the face; for each light once. `grain`: units of the plane's grid that a point may be off.
  void add_light(std::size_t light, const std::vector<LitPart>& lit, std::int32_t grain);

  // The parts that lie on the face, the largest first.
  std::vector<ShadowPart> finish();

 private:
  using Part = std::array<std::uint8_t, 3>;  // of one light, a channel
  using Reach = std::array<Part, kMaxLights>;
  using Shared = std::vector<std::pair<Part, Region>>;  // of a face

  Shared share(const std::vector<LitPart>& lit, std::int32_t grain);
  Region joined(const Region& a, const Region& b);
  void divide(std::size_t light, const Shared& shared);

  Region face_;
  RegionClipper& clipper_;
  std::map<Reach, Region> parts_;  // of the face and its margin
  std::int32_t grain_ = 1;         // of all lights the coarsest
};

}  // namespace spanline::host
