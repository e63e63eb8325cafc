// The work, and nothing else.
#include "work.hpp"

void reset() {
  work();
  leave();
}
