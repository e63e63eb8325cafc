// How faces become the runs of alike ones that a MeshRecord holds.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "assetc/compile.hpp"

namespace spanline::host {

// A face whose corners stand in MeshTables::corners already.
struct TableFace {
  std::uint32_t first_corner;
  std::uint32_t corner_count;
  std::vector<std::uint16_t> rings;  // their lengths; empty: a single one
  std::uint16_t material;
  bool patch = false;
  bool curved = false;
};

// Appends a face after those that `tables` has: its group, ring lengths and number. `place` is for messages. Throws
// InputError where 16-bit indices do not suffice.
void append_face(MeshTables& tables, const TableFace& face, const std::string& place);

}  // namespace spanline::host
