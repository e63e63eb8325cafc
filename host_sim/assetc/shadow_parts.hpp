// How the lights of a scene divide a face: parts that all lights reach alike.
#pragma once

#include <array>
#include <map>
#include <vector>

#include "assetc/face_plane.hpp"

namespace spanline::host {

// A polygon that throws a shadow.
struct Occluder {
  std::size_t instance, face;
  std::vector<Ring3> rings;  // world
  Color transmission;        // black: opaque
};

// A part of a face, on its grid, and what of each light reaches it.
struct ShadowPart {
  ReachRecord reach;
  Region region;
};

class ShadowParts {
 public:
  // `face` is the region of the face on the plane's grid.
  ShadowParts(Region face, const FacePlane& plane, RegionClipper& clipper);

  // For each light once: the shadows that polygons throw in it, in any order.
  void begin_light(std::size_t light);
  void shade(const Region& shadow, Color transmission);
  void end_light();

  // The parts that lie on the face, the largest first.
  std::vector<ShadowPart> finish();

 private:
  using Part = std::array<std::uint8_t, 3>;  // of one light, a channel
  using Reach = std::array<Part, kMaxLights>;

  template <typename Key>
  void add(std::map<Key, Region>& to, const Key& key, const Region& region);

  Region face_;
  RegionClipper& clipper_;
  std::map<Reach, Region> parts_;
  std::size_t light_ = 0;
  std::map<Part, Region> lit_;  // of the light in hand: all of the face and its margin
};

}  // namespace spanline::host
