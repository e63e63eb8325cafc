#include "core/frame/band_lines_impl.hpp"

namespace spanline {

template class BandLines<false, Paint::flat_words>;
template class BandLines<false, Paint::smooth_words>;

}  // namespace spanline
