// One line of a target's report on a picture whose checksum is known.
#pragma once

#include "boards/common/report.hpp"
#include "core/base/status.hpp"

namespace spanline::target {

// "IMAGE=NAME crc=… expected=… same", or DIFFERS, or FAILED where the status is not ok; whether it is the same.
inline bool report_sum(const char* image, const char* name, const Status& status, std::uint32_t crc,
                       std::uint32_t expected) {
  using boards::print;
  const bool same = status.ok() && crc == expected;
  print(image);
  print("=");
  print(name);
  print(" crc=");
  boards::print_hex(crc);
  print(" expected=");
  boards::print_hex(expected);
  print(same ? " same\n" : status.ok() ? " DIFFERS\n" : " FAILED\n");
  return same;
}

}  // namespace spanline::target
