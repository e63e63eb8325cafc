// What seed 1 printed: Fig. 32 and Fig. 33, rebuilt from the scan.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace spanline::figures {

inline constexpr std::size_t kObjects = 10;

// The ten objects in the seed's order.
struct Object {
  const char* name;  // the seed's
  const char* file;  // the stem of its files in assets/watkins
};
extern const std::array<Object, kObjects> kObject;

// A row of Fig. 33. `key` is the row's name in the statistics of `spanline render --stats`; the values carry the marks
// of the scan: ? unsure, * repaired with R = M / N, ~ read off another row.
struct SeedRow {
  const char* key;
  const char* label;
  int decimals;
  std::array<const char*, kObjects> values;
};
extern const std::vector<SeedRow> kSeedRows;

// The row of that key. Throws std::out_of_range where there is none.
const SeedRow& seed_row(const std::string& key);

// A printed value without its marks; a lone "?" is 0.
double seed_number(const std::string& printed);

// Penetration through the six steps of the seed's algorithm (Fig. 32).
struct SeedStep {
  const char* name;
  int references;
  int max_blocks;
};
extern const std::array<SeedStep, 6> kSeedLadder;

}  // namespace spanline::figures
