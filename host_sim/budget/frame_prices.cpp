#include "assetc/input_error.hpp"
#include "budget/sweep.hpp"

namespace spanline::host {

namespace {

// A row of edge_prices.inc.
struct EdgePrice {
  const char* core;
  bool gouraud;
  double each[4];  // pixel, face, crossing, depth test more than the crossings'
};
constexpr EdgePrice kEdgePrices[] = {
#include "budget/edge_prices.inc"
};

}  // namespace

// Core cycles at zero wait states, fitted to counted frames of the benchmark. The segment walker's: S1, S3 and S4,
// flat; references and pixels meet each within 5 %. The edge walker's (tests/bench/prices.sh): these and balls of 120,
// 960 and 3,024 triangles. What a face costs once more, per band after the first, is from the demos' cycles before
// their first line.
const std::vector<FramePrice>& frame_prices() {
  static const std::vector<FramePrice> kPrices = [] {
    std::vector<FramePrice> prices;
    for (const bool gouraud : {false, true}) {
      prices.push_back({"m0+", Walker::segments, gouraud, {.pixels = 1.7, .references = 655, .faces_again = 1500}});
      prices.push_back({"m3", Walker::segments, gouraud, {.pixels = 1.8, .references = 352, .faces_again = 600}});
      prices.push_back({"m4", Walker::segments, gouraud, {.pixels = 1.7, .references = 350, .faces_again = 600}});
    }
    for (const EdgePrice& price : kEdgePrices) {
      const auto& [pixel, face, crossing, overlap] = price.each;
      prices.push_back({price.core,
                        Walker::edges,
                        price.gouraud,
                        {.pixels = pixel, .faces = face, .crossings = crossing, .overlaps = overlap}});
    }
    return prices;
  }();
  return kPrices;
}

const FramePrice& price_of(const std::string& core, Walker walker, bool gouraud) {
  for (const FramePrice& price : frame_prices()) {
    if (price.core == core && price.walker == walker && price.gouraud == gouraud) return price;
  }
  throw InputError(core, "has no price");
}

double estimated_cycles(const FramePrice& price, const FrameWork& work) {
  const FrameWork& each = price.cycles;
  return each.pixels * work.pixels + each.faces * work.faces + each.crossings * work.crossings +
         each.overlaps * work.overlaps + each.references * work.references + each.faces_again * work.faces_again;
}

}  // namespace spanline::host
