// Values of the command line, strictly read. Each function throws UsageError with the option's name.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "assetc/vec.hpp"
#include "core/base/pixel_format.hpp"

namespace spanline::host {

// "320x240", 1 … 2046 each.
std::pair<std::uint16_t, std::uint16_t> parse_size(const std::string& option, std::string_view text);

// "x,y,z".
Vec3 parse_vector(const std::string& option, std::string_view text);

double parse_real(const std::string& option, std::string_view text);

std::int64_t parse_integer(const std::string& option, std::string_view text, std::int64_t low, std::int64_t high);

// "A:B", both included, 0 <= A <= B.
std::pair<std::int64_t, std::int64_t> parse_range(const std::string& option, std::string_view text);

PixelFormat parse_format(const std::string& option, std::string_view text);

// Pool limits of --pools: "facets=40,segments=30".
struct PoolLimit {
  std::string name;
  std::uint16_t limit;
};
std::vector<PoolLimit> parse_pools(const std::string& option, std::string_view text);

// The pools that --pools knows, in the order of the statistics.
extern const std::vector<std::string> kPoolNames;

}  // namespace spanline::host
