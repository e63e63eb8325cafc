#include "core/frame/patch_lines_impl.hpp"

namespace spanline {

template class PatchLines<false>;

}  // namespace spanline
