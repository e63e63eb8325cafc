#include "core/frame/frame_impl.hpp"

namespace spanline {

template class Frame<FrameOptions{.changes = true}>;
template class MeshFrame<FrameOptions{.walker = Walker::edges, .changes = true}>;
template class MeshFrame<FrameOptions{.walker = Walker::edges, .changes = true, .paint = Paint::flat_words}>;
template class MeshFrame<FrameOptions{.walker = Walker::edges, .changes = true, .paint = Paint::smooth_words}>;
template class Frame<FrameOptions{.walker = Walker::both, .changes = true}>;

}  // namespace spanline
