#include "core/frame/frame_impl.hpp"

namespace spanline {

template class Frame<FrameOptions{.comparator = Comparator::plane, .layers = true}>;

}  // namespace spanline
