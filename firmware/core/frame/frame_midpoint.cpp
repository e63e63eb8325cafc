#include "core/frame/frame_impl.hpp"

namespace spanline {

template class Frame<FrameOptions{.comparator = Comparator::midpoint}>;

}  // namespace spanline
