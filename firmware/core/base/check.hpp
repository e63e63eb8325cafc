// Debug traps. CHECK guards invariants of our own making; it is never the answer to bad input (that is a Status).
#pragma once

#if defined(SPANLINE_CHECKS) && SPANLINE_CHECKS
#define CHECK(condition) ((condition) ? void() : __builtin_trap())
#else
#define CHECK(condition) void(sizeof(!(condition)))
#endif
