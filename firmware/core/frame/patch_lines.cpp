#include "core/frame/patch_lines_impl.hpp"

namespace spanline {

template class PatchLines<false>;
template class PatchLines<false, Paint::flat_words>;
template class PatchLines<false, Paint::smooth_words>;

}  // namespace spanline
