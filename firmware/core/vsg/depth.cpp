#include "core/vsg/depth.hpp"

#include <bit>

#include "core/fx/bits.hpp"
#include "core/fx/rare_div.hpp"
#include "core/geom/gradient.hpp"

namespace spanline {

namespace {

std::int32_t pixel_on_screen(std::int32_t v, std::int32_t pixels) {
  const std::int32_t p = v >> 4;
  return p < 0 ? 0 : p >= pixels ? pixels - 1 : p;
}

constexpr std::int32_t centre(std::int32_t pixel) { return pixel * kSubpixels + kSubpixels / 2; }

// The plane of any triangle.
[[gnu::noinline]] DepthPlane exact_plane(const ScreenXY (&at)[3], const std::uint32_t (&value)[3], int bits,
                                         const Screen& screen) {
  const ExactGradient gradient(at, static_cast<std::int32_t>(value[1] - value[0]),
                               static_cast<std::int32_t>(value[2] - value[0]));
  DepthPlane plane;
  plane.ramp.at_zero = value[0] << bits;
  if (gradient.area == 0) return plane;  // covers no pixel
  const std::int32_t column = pixel_on_screen(at[0].x, screen.width);
  const std::int32_t line = pixel_on_screen(at[0].y, screen.height);
  // Distances are below 2^16, and rises below 2^24 with kRampShift, below 2^13 with 16 bits, so this is below 2^63.
  const std::int64_t climb = (gradient.along_x * (centre(column) - at[0].x) +  //
                              gradient.along_y * (centre(line) - at[0].y));
  const auto by_area = [&](std::int64_t v, std::int64_t more) __attribute__((noinline)) {
    return static_cast<std::uint32_t>(rare_floor_div(v * (1 << bits) + more, gradient.area));
  };
  plane.ramp.slope = by_area(gradient.along_x * kSubpixels, gradient.area >> 1);
  plane.down = by_area(gradient.along_y * kSubpixels, gradient.area >> 1);
  plane.ramp.at_zero += by_area(climb, 0) - plane.ramp.slope * static_cast<std::uint32_t>(column) -
                        plane.down * static_cast<std::uint32_t>(line);
  return plane;
}

}  // namespace

// Of a triangle of less than 256 pixels each way that is not too steep both gradients have the same relative error, so
// within the triangle the plane is off by that part of what it rises: 2^-25 of less than 65536 units; by what is cut
// off of a rise of 1024 units and more, a quarter of a unit at most; and by half the last bit a pixel.
DepthPlane value_plane(const ScreenXY (&at)[3], const std::uint32_t (&value)[3], int bits, const Screen& screen) {
  Gradient gradient;
  if (!small_gradient<1 << kDepthBits>(at, static_cast<std::int32_t>(value[1] - value[0]),
                                       static_cast<std::int32_t>(value[2] - value[0]), bits, gradient)) [[unlikely]] {
    return exact_plane(at, value, bits, screen);
  }
  DepthPlane plane;
  plane.ramp.slope = static_cast<std::uint32_t>(gradient.right);
  plane.down = static_cast<std::uint32_t>(gradient.down);
  plane.ramp.at_zero = at_origin(value[0] << bits, at[0], gradient);
  return plane;
}

DepthPlane face_plane(FacetReader& reader, std::uint16_t face, const Screen& screen) {
  struct Corners {
    FacetVertex corner[3];
    unsigned count = 0;
    void begin_contour() {}
    void vertex(const FacetVertex& v) { corner[count++] = v; }
    void end_contour() {}
  } corners;
  reader.select(face);
  reader.read([](std::uint16_t) { return Rgb8{}; }, corners);
  CHECK(corners.count == 3);
  const FacetVertex(&c)[3] = corners.corner;
  return depth_plane({c[0].at, c[1].at, c[2].at}, {c[0].depth, c[1].depth, c[2].depth}, screen);
}

DepthRamp depth_between(const SegmentHalf& left, const SegmentHalf& right) {
  // With l = e / D the way from an edge to its column: width = c_r - c_l + l_l - l_r px, and the column c_l lies l_l /
  // width of the way along. Multiplied by both D that is exact in 64 bits; the quotients then need 32.
  const std::int64_t both = std::int64_t{left.denominator()} * right.denominator();  // at most 2^40
  const std::int64_t lead = std::int64_t{left.error} * right.denominator();
  const std::int64_t width =
      (right.column - left.column) * both + lead - std::int64_t{right.error} * left.denominator();  // at most 2^52
  CHECK(width > 0 && lead <= width);
  const int wide = static_cast<int>(std::bit_width(static_cast<std::uint64_t>(width))) - 32;
  const int shift = wide > 0 ? wide : 0;
  const auto rise = static_cast<std::int64_t>(static_cast<std::int32_t>(right.depth - left.depth));
  DepthRamp ramp;
  // A segment less than a pixel wide covers one column at most and needs no slope.
  if (width >= both) ramp.slope = static_cast<std::uint32_t>(round_div(rise * (both >> shift), width >> shift));
  const auto start = static_cast<std::uint32_t>(round_div(rise * (lead >> shift), width >> shift));
  ramp.at_zero = left.depth + start - ramp.slope * static_cast<std::uint32_t>(left.column);
  return ramp;
}

}  // namespace spanline
