#include "core/frame/frame_impl.hpp"

namespace spanline {

template class MeshFrame<FrameOptions{.walker = Walker::edges}>;
template class MeshFrame<FrameOptions{.walker = Walker::edges, .paint = Paint::flat_words}>;
template class MeshFrame<FrameOptions{.walker = Walker::edges, .paint = Paint::smooth_words}>;
template class MeshFrame<FrameOptions{.walker = Walker::edges, .bands = true, .paint = Paint::flat_words}>;
template class MeshFrame<FrameOptions{.walker = Walker::edges, .bands = true, .paint = Paint::smooth_words}>;
template class MeshFrame<FrameOptions{
    .walker = Walker::edges, .bands = true, .paint = Paint::flat_words, .plain = true}>;
template class MeshFrame<FrameOptions{
    .walker = Walker::edges, .bands = true, .paint = Paint::smooth_words, .plain = true}>;
template class MeshFrame<FrameOptions{.walker = Walker::edges, .paint = Paint::flat_words, .plain = true}>;
template class MeshFrame<FrameOptions{.walker = Walker::edges, .paint = Paint::smooth_words, .plain = true}>;
template class Frame<FrameOptions{.walker = Walker::both}>;

}  // namespace spanline
