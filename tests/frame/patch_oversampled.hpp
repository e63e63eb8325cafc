// The slow twin of drawing patches: every patch in floating point, 64 x 64 facets each, in a depth buffer of 8 x 8
// samples a pixel. It shares no code with the engine: points come from the scene's description, the view from the
// camera's numbers.
#pragma once

#include <cstdint>
#include <vector>

#include "assetc/compile.hpp"

namespace spanline::test {

class Oversampled {
 public:
  static constexpr int kSamples = 8;  // a pixel, each way

  // For instance 0 of scenes of this size, which stands where its mesh says.
  explicit Oversampled(const host::SceneDescription& scene);

  // Draws it as the scene looks at it. Nothing may lie before the eye.
  void draw(const host::CompiledScene& scene);

  // What all samples within `radius` px of the pixel's centre show: 1 + the patch's number, 0 the background; kSeveral
  // where a boundary is that near, or the picture's.
  static constexpr std::uint32_t kSeveral = 0xffff;
  std::uint32_t only(int column, int line, double radius) const;

  // Whether a sample within `radius` px of the pixel's centre shows `id`: 1 + the patch's number, 0 the background.
  bool shows(std::uint32_t id, int column, int line, double radius) const;

  // Whether a sample within `radius` px shows any patch.
  bool shows_any(int column, int line, double radius) const;

  // Whether a sample within `radius` px shows another part of the model than the patch `id` belongs to, and that patch
  // less than `depth` px behind it: the two pierce each other nearby. Patches that share a side are one part.
  bool pierced_by(std::uint32_t id, int column, int line, double radius, double depth) const;

  // Whether all samples within `radius` px show one and the same part.
  bool inside_a_part(int column, int line, double radius) const;

 private:
  struct Corner {
    double x, y, depth;  // in samples; 1 / distance
  };
  void add(const std::vector<host::Vec3>& control, std::uint16_t id);
  void triangle(const Corner& a, const Corner& b, const Corner& c, std::uint16_t id);
  Corner project(host::Vec3 p) const;
  template <typename Wanted>
  bool any_near(int column, int line, double radius, const Wanted& wanted) const;

  host::View view_;
  host::Axes axes_;
  int width_, height_;                  // in samples
  double focal_ = 0;                    // in samples
  std::vector<std::uint16_t> part_of_;  // by id; 0 for the background
  struct Sample {
    std::uint16_t id = 0, second = 0;  // second: the nearest patch of another part
    float depth = 0, second_depth = 0;
  };
  const Sample& middle(int column, int line) const;
  std::vector<Sample> samples_;
};

}  // namespace spanline::test
