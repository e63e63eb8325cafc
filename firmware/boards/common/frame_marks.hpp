// Where a frame begins and ends, for whoever counts from outside: every image has these two symbols, never inlined.
#pragma once

extern "C" {

// Right before a frame is prepared; what moves the scene to that frame lies between the marks, too.
void frame_begin_mark();

// Right after its last line has been handed over, and has left where there is a wire.
void frame_end_mark();
}
