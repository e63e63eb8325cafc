#pragma once

#include <cstdint>

namespace spanline {

// floor_div() and round_div() of 64 bits for what is divided rarely: digit by digit, about nine instructions for each
// bit of the quotient, in a tenth of the code that the compiler's division takes on a core without a long one.
std::int64_t rare_floor_div(std::int64_t dividend, std::int64_t divisor);
std::int64_t rare_round_div(std::int64_t dividend, std::int64_t divisor);

}  // namespace spanline
