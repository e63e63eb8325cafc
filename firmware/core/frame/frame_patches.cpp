#include "core/frame/frame_impl.hpp"

namespace spanline {

template class Frame<FrameOptions{.patches = true}>;
template class MeshFrame<FrameOptions{.patches = true, .walker = Walker::edges}>;
template class MeshFrame<FrameOptions{.patches = true, .walker = Walker::edges, .paint = Paint::flat_words}>;
template class MeshFrame<FrameOptions{.patches = true, .walker = Walker::edges, .paint = Paint::smooth_words}>;
template class Frame<FrameOptions{.patches = true, .walker = Walker::both}>;

}  // namespace spanline
