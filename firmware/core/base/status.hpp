#pragma once

#include <cstdint>

namespace spanline {

// What went wrong, as a word that code can switch on.
enum class Code : std::uint8_t {
  ok,
  bad_record,      // a flash record holds a value that the engine cannot draw; `where` and `field` name it
  bad_argument,    // a caller's size, band or camera is out of range
  pool_exhausted,  // one line needed more blocks than `where` (a pool's name) has; the highest face numbers were left
                   // out
  unclosed,  // a polygon had an odd number of edges on a line (seed 1, listing: UNCLOSED POLYGON); index is the face
};

// The outcome of a fallible call: a code, its place and the figures a person needs to mend it. Trivially copyable, no
// text of its own: `where` and `field` are string literals in flash, or null where all is well, so that such a Status
// is all zeros.
struct Status {
  Code code = Code::ok;
  const char* where = nullptr;  // record type or pool name
  const char* field = nullptr;  // field of that record
  std::uint32_t index = 0;      // which record (or face)
  std::uint32_t line = 0;       // scan line, where one is concerned
  std::uint32_t needed = 0;     // blocks needed, or the offending value
  std::uint32_t limit = 0;      // blocks available, or the largest allowed value

  constexpr bool ok() const { return code == Code::ok; }
};

// The outcomes that are met in many places, each made in one: of a caller's value, of a record that the engine cannot
// draw, and of a pool that `line` needed more of.
Status bad_argument(const char* where, const char* field, std::uint32_t line = 0, std::uint32_t value = 0,
                    std::uint32_t limit = 0);
Status bad_record(const char* record, const char* field, std::uint32_t index = 0, std::uint32_t value = 0);
Status pool_exhausted(const char* pool, std::uint32_t line, std::uint32_t needed, std::uint32_t capacity);

}  // namespace spanline
