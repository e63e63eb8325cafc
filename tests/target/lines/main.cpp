// The golden pictures in lines on a target, as tests/target/golden has the others.
#include "golden/lines.hpp"
#include "golden_main.hpp"

namespace {

spanline::LineMemory<spanline::golden::kLineBudget> memory;

}  // namespace

int main() { spanline::target::report_pictures("lines", spanline::golden::kLinePictures, memory.storage()); }
