#include "budget/sweep.hpp"

namespace spanline::host {

// Core cycles at zero wait states, from counted frames of the benchmark's scenes S1, S3 and S4, flat, by the segment
// walker (`./dev bench`): the sum of references and pixels meets each of them within 5 %. What a face costs once more,
// per band after the first, from the demos' cycles before their first line.
const std::vector<FramePrice>& frame_prices() {
  static const std::vector<FramePrice> kPrices = {
      {"m0+", 655, 1.7, 1500}, {"m3", 352, 1.8, 600}, {"m4", 350, 1.7, 600}};
  return kPrices;
}

double estimated_cycles(const FramePrice& price, const FrameWork& work) {
  return price.reference * static_cast<double>(work.references) + price.pixel * static_cast<double>(work.pixels) +
         price.face_again * static_cast<double>(work.faces_again);
}

}  // namespace spanline::host
