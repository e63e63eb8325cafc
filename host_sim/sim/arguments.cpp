#include "sim/arguments.hpp"

#include <algorithm>

#include "assetc/text_file.hpp"
#include "core/geom/screen.hpp"
#include "sim/usage_error.hpp"

namespace spanline::host {
namespace {

[[noreturn]] void refuse(const std::string& option, std::string_view text, const std::string& wanted) {
  throw UsageError(option + ": '" + printable(text) + "' is not " + wanted);
}

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (;;) {
    const std::size_t end = text.find(separator);
    parts.push_back(text.substr(0, end));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

constexpr std::int64_t kMaxFrame = 1'000'000'000;

}  // namespace

const std::vector<std::string> kPoolNames = {"facets",  "edges",    "polygons",     "segments",       "samples",
                                             "implied", "vertices", "patch_facets", "patch_vertices", "point_lines",
                                             "curves",  "strands",  "layers"};

std::pair<std::uint16_t, std::uint16_t> parse_size(const std::string& option, std::string_view text) {
  const std::vector<std::string_view> sides = split(text, 'x');
  std::int64_t side[2] = {};
  const auto good = [&](std::size_t i) {
    return parse_whole(sides[i], side[i]) && side[i] >= 1 && side[i] <= kMaxExtent;
  };
  if (sides.size() != 2 || !good(0) || !good(1)) {
    refuse(option, text, "WxH with 1 to " + std::to_string(kMaxExtent) + " pixels each");
  }
  return {static_cast<std::uint16_t>(side[0]), static_cast<std::uint16_t>(side[1])};
}

Vec3 parse_vector(const std::string& option, std::string_view text) {
  const std::vector<std::string_view> parts = split(text, ',');
  double v[3] = {};
  bool good = parts.size() == 3;
  for (std::size_t i = 0; good && i < 3; ++i) good = parse_number(parts[i], v[i]);
  if (!good) refuse(option, text, "three numbers x,y,z");
  return {v[0], v[1], v[2]};
}

double parse_real(const std::string& option, std::string_view text) {
  double value = 0;
  if (!parse_number(text, value)) refuse(option, text, "a number");
  return value;
}

std::int64_t parse_integer(const std::string& option, std::string_view text, std::int64_t low, std::int64_t high) {
  std::int64_t value = 0;
  if (!parse_whole(text, value) || value < low || value > high) {
    refuse(option, text, "a whole number from " + std::to_string(low) + " to " + std::to_string(high));
  }
  return value;
}

std::pair<std::int64_t, std::int64_t> parse_range(const std::string& option, std::string_view text) {
  const std::vector<std::string_view> ends = split(text, ':');
  if (ends.size() != 2) refuse(option, text, "a range A:B of frames");
  const std::int64_t first = parse_integer(option, ends[0], 0, kMaxFrame);
  return {first, parse_integer(option, ends[1], first, kMaxFrame)};
}

PixelFormat parse_format(const std::string& option, std::string_view text) {
  if (text == "rgb565") return PixelFormat::rgb565;
  if (text == "grey8") return PixelFormat::grey8;
  if (text == "grey4") return PixelFormat::grey4;
  if (text == "mono1") return PixelFormat::mono1;
  refuse(option, text, "one of rgb565, grey8, grey4, mono1");
}

std::vector<PoolLimit> parse_pools(const std::string& option, std::string_view text) {
  std::vector<PoolLimit> limits;
  for (const std::string_view part : split(text, ',')) {
    const std::size_t equals = part.find('=');
    if (equals == std::string_view::npos) refuse(option, part, "NAME=N");
    const std::string name(part.substr(0, equals));
    if (std::find(kPoolNames.begin(), kPoolNames.end(), name) == kPoolNames.end()) {
      refuse(option, name,
             "one of facets, edges, polygons, segments, samples, implied, vertices, layers, "
             "patch_facets, patch_vertices, point_lines, curves, strands");
    }
    limits.push_back({name, static_cast<std::uint16_t>(parse_integer(option, part.substr(equals + 1), 0, 65534))});
  }
  return limits;
}

}  // namespace spanline::host
