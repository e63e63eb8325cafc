// Arm's semihosting, as far as bare images use it: characters out, and the end of the run.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

namespace spanline::host {

struct SemihostingAnswer {
  bool known = false;
  std::uint32_t r0 = 0;
  std::optional<std::uint32_t> exit_code;
};

// `read`: one byte of the image's memory, nothing where there is none. What it says is appended to `output`.
SemihostingAnswer answer_semihosting(std::uint32_t operation, std::uint32_t argument,
                                     const std::function<std::optional<std::uint8_t>(std::uint32_t)>& read,
                                     std::uint64_t microseconds, std::string& output);

}  // namespace spanline::host
