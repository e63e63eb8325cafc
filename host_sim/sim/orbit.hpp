// A viewer that goes around a target.
#pragma once

#include "assetc/camera.hpp"

namespace spanline::host {

class Orbit {
 public:
  // Begins at `view` of a picture of `height` lines, and stays between a tenth of the bounds' radius from the target
  // and `reach` radii from their centre.
  Orbit(const View& view, const Sphere& bounds, std::uint16_t height, double reach);

  // Turns by angles in degrees: to the right about the world's Y, and upwards, short of the poles.
  void turn(double right, double up);

  // Multiplies the distance.
  void zoom(double factor);

  // The view from there; near and far enclose the bounds.
  View view() const;

 private:
  View start_;
  Sphere bounds_;
  std::uint16_t height_px_;
  double reach_;
  double distance_, azimuth_, height_;  // radians
};

}  // namespace spanline::host
