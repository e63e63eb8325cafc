#include "core/frame/frame_impl.hpp"

namespace spanline {

template class Frame<FrameOptions{.comparator = Comparator::plane, .layers = true}>;
template class Frame<FrameOptions{.patches = true, .layers = true}>;

}  // namespace spanline
