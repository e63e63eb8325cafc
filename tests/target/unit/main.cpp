// The engine's own tests on a target: all that are linked in.
#include <gtest/gtest.h>

#include "hal/mcu/semihosting.hpp"

int main() { spanline::hal::semihosting::leave(testing::run_all() ? 0 : 1); }
