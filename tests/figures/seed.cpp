#include "seed.hpp"

#include <cstdlib>
#include <stdexcept>

namespace spanline::figures {

const std::array<Object, kObjects> kObject = {{{"Penetration", "penetration"},
                                               {"E-S", "e-s"},
                                               {"Low Area", "low-area"},
                                               {"Cube1", "cube1"},
                                               {"Cube2", "cube2"},
                                               {"Shape1", "shape1"},
                                               {"Shape2", "shape2"},
                                               {"Sheet", "sheet"},
                                               {"Simple1", "simple1"},
                                               {"Simple2", "simple2"}}};

// clang-format off
const std::vector<SeedRow> kSeedRows = {
    {"polygons", "polygons", 0, {"50*", "202", "100", "150", "150", "100", "100?", "192*", "148", "148"}},
    {"edges", "edges", 0, {"105", "480", "210", "300", "300*", "201", "201", "308", "308", "308"}},
    {"edge_crossings", "crossings N", 0,
     {"8802", "15278", "9164", "~7575*", "15410", "12424", "25590", "12500", "6175", "~6680*"}},
    {"implied_edges", "implied edges", 0, {"14", "5?", "45?", "0", "0", "0?", "0", "0", "0", "21"}},
    {"output_segments", "output segments", 0,
     {"3844", "7052", "4193", "1228", "7710?", "5630", "12023", "6935", "1652", "2263?"}},
    {"segment_blocks", "segment blocks ever taken", 0,
     {"56", "146?", "105?", "75*", "121?", "50", "76?", "200?", "66", "90"}},
    {"max_segment_blocks", "max blocks", 0, {"23", "40", "31", "30?", "50?", "24", "50", "31?", "18", "22"}},
    {"segment_references", "references M", 0,
     {"24291", "47030", "~24050*", "~8065?", "80945", "34314", "79762", "26970", "9039*", "14926"}},
    {"reference_ratio", "R = M/N", 2,
     {"2.75*", "3.07", "2.62", "1.06", "5.25*", "2.76*", "3.11", "2.15", "1.46", "2.23"}},
    {"comparator_cycles", "add cycles", 0,
     {"32925", "47174", "25641", "10274", "109190?", "30227", "85941", "24176?", "10503?", "18647?"}},
    {"cycles_per_test", "adds a test", 2,
     {"3.38?", "2.60?", "3.23?", "2.89", "2.05?", "2.22?", "2.66", "2.07", "2.74?", "2.94?"}},
    {"not_appended_percent", "not appended, %", 2,
     {"2.96", "3.48", "4.06", "0.00?", "4.2?", "1.69", "0.52", "1.17", "1.12", "1.07"}},
    {"fifo_segments", "FIFO, segments", 0, {"10", "30", "2", "7", "1700", "10", "1600?", "25", "5", "?"}},
};
// clang-format on

const SeedRow& seed_row(const std::string& key) {
  for (const SeedRow& row : kSeedRows) {
    if (key == row.key) return row;
  }
  throw std::out_of_range(key);
}

double seed_number(const std::string& printed) {
  const std::size_t first = printed.find_first_of("0123456789");
  return first == std::string::npos ? 0 : std::strtod(printed.c_str() + first, nullptr);
}

const std::array<SeedStep, 6> kSeedLadder = {{{"VSG1", 137607, 76},
                                              {"VSG2", 101892, 44},
                                              {"VSG3", 37919, 25},
                                              {"VSG4", 21730, 24},
                                              {"VSG5", 21224, 23},
                                              {"VSG6", 24291, 23}}};

}  // namespace spanline::figures
