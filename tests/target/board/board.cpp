// What start-up and fault reports ask of a board: this one has no light, and nothing starts its timer.
#include "boards/common/report.hpp"

void spanline::boards::light(bool) {}
extern "C" void tick() {}
