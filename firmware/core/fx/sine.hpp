#pragma once

#include "core/fx/fixed.hpp"

namespace spanline {

// Sine and cosine of a binary angle, Q2.30, within 2^-24 of the exact value; exact at the quarters of a turn.
Fx30 sine(Turn16 angle);
Fx30 cosine(Turn16 angle);

}  // namespace spanline
