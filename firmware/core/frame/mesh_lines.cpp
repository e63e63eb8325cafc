#include "core/frame/mesh_frame.hpp"
#include "core/frame/mesh_lines_impl.hpp"

namespace spanline {

// Takes another value for what is not drawn, which no word has: of the pool's, since those of faces that are not set
// any more may be kept.
[[gnu::cold]] std::uint16_t FaceWords::avoid() {
  const std::uint16_t old = not_drawn_;
  std::uint16_t* const first = &words_[1];
  std::uint16_t* const end = first + words_.capacity();
  const auto taken = [&] {
    for (const std::uint16_t* word = first; word != end; ++word) {
      if (*word == not_drawn_) return true;
    }
    return false;
  };
  do {
    not_drawn_ = static_cast<std::uint16_t>(not_drawn_ + 0x9e37);  // odd: comes round every value
  } while (not_drawn_ == old || taken());
  for (std::uint16_t* word = first; word != end; ++word) {
    if (*word == old) *word = not_drawn_;
  }
  return not_drawn_;
}

Status check_band(Band rest, const Screen& screen) {
  if (!rest.empty() && rest.bottom <= screen.height) return {};
  return bad_argument("band", "bottom", rest.top, rest.bottom, screen.height);
}

[[gnu::cold]] Status line_refused(Slice<std::uint8_t> out, std::uint32_t bytes, std::uint32_t line) {
  return bad_argument("line", out.size() < bytes ? "size" : "alignment", line, out.size(), bytes);
}

[[gnu::cold]] Status beyond_view(std::uint32_t instance) {
  return bad_record("InstanceRecord", "transform (beyond the view)", instance);
}

[[gnu::cold]] Status walker_shortage(const EdgeWalker& walker, bool overlaps, std::uint16_t line) {
  const std::uint32_t capacity = overlaps ? OverlapSet::kMost : walker.edge_capacity();
  return pool_exhausted(overlaps ? "overlaps" : "edges", line, capacity + 1, capacity);
}

template class MeshLines<false>;
template class MeshLines<false, Paint::flat_words>;
template class MeshLines<false, Paint::smooth_words>;
template class MeshLines<false, Paint::flat_words, true>;
template class MeshLines<false, Paint::smooth_words, true>;

template Status MeshLines<false>::begin(const SceneView&, const CameraRecord&, std::uint16_t, AllLines&);
template Status MeshLines<false>::begin(const SceneView&, const CameraRecord&, std::uint16_t, ChangedLines&);
template Status MeshLines<false, Paint::flat_words>::begin(const SceneView&, const CameraRecord&, std::uint16_t,
                                                           AllLines&);
template Status MeshLines<false, Paint::flat_words>::begin(const SceneView&, const CameraRecord&, std::uint16_t,
                                                           ChangedLines&);
template Status MeshLines<false, Paint::smooth_words>::begin(const SceneView&, const CameraRecord&, std::uint16_t,
                                                             AllLines&);
template Status MeshLines<false, Paint::flat_words, true>::begin(const SceneView&, const CameraRecord&, std::uint16_t,
                                                                 AllLines&);
template Status MeshLines<false, Paint::smooth_words, true>::begin(const SceneView&, const CameraRecord&, std::uint16_t,
                                                                   AllLines&);
template Status MeshLines<false, Paint::smooth_words>::begin(const SceneView&, const CameraRecord&, std::uint16_t,
                                                             ChangedLines&);

}  // namespace spanline
