#include "assetc/input_error.hpp"
#include "budget/sweep.hpp"

namespace spanline::host {

// Core cycles at zero wait states, fitted to counted frames of the benchmark. The segment walker's: S1, S3 and S4,
// flat; references and pixels meet each within 5 %. The edge walker's (`./dev bench`): these and balls of 120, 960 and
// 3,024 triangles; each within 13 %. What a face costs once more, per band after the first, is from the demos' cycles
// before their first line.
const std::vector<FramePrice>& frame_prices() {
  static const std::vector<FramePrice> kPrices = [] {
    std::vector<FramePrice> prices;
    for (const bool gouraud : {false, true}) {
      prices.push_back({"m0+", Walker::segments, gouraud, {.pixels = 1.7, .references = 655, .faces_again = 1500}});
      prices.push_back({"m3", Walker::segments, gouraud, {.pixels = 1.8, .references = 352, .faces_again = 600}});
      prices.push_back({"m4", Walker::segments, gouraud, {.pixels = 1.7, .references = 350, .faces_again = 600}});
    }
    const auto edges = [&](const char* core, bool gouraud, double pixel, double face, double crossing, double overlap) {
      prices.push_back(
          {core, Walker::edges, gouraud, {.pixels = pixel, .faces = face, .crossings = crossing, .overlaps = overlap}});
    };
    edges("m0+", false, 2.8, 76.5, 61.3, 242.5);
    edges("m0+", true, 2.6, 0, 123.8, 269);
    edges("m3", false, 2.0, 95, 37.2, 180);
    edges("m3", true, 1.7, 0, 89.6, 182);
    edges("m4", false, 2.0, 39.7, 37.4, 174.6);
    edges("m4", true, 1.77, 0, 82.7, 150);
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
