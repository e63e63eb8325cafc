#include "core/frame/frame_impl.hpp"

namespace spanline {

template class Frame<FrameOptions{.patches = true, .points = true}>;

}  // namespace spanline
