#include "boards/common/frame_marks.hpp"

// Two different texts: functions with one and the same body may become one.
[[gnu::noinline, gnu::used]] void frame_begin_mark() { asm volatile("/* a frame begins */"); }
[[gnu::noinline, gnu::used]] void frame_end_mark() { asm volatile("/* a frame has ended */"); }
