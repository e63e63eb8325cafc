// The golden pictures on a target.
#include "golden_main.hpp"

namespace {

spanline::FrameMemory<spanline::golden::kBudget> memory;

}  // namespace

int main() { spanline::target::report_pictures("golden", spanline::golden::kPictures, memory.storage()); }
