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

[[gnu::cold]] Status check_band(Band rest, const Screen& screen) {
  if (!rest.empty() && rest.bottom <= screen.height) return {};
  return bad_argument("band", "bottom", rest.top, rest.bottom, screen.height);
}

[[gnu::cold]] Status line_refused(Slice<std::uint8_t> out, std::uint32_t bytes, std::uint32_t line) {
  return bad_argument("line", out.size() < bytes ? "size" : "alignment", line, out.size(), bytes);
}

[[gnu::cold]] Status check_meshes(const SceneView& scene) {
  const SceneRecord& record = scene.scene();
  if (!record.reaches.empty()) return bad_record("SceneRecord", "reaches");
  if (scene.layered()) return bad_record("SceneRecord", "surface detail or see-through materials");
  for (InstanceCursor at(record); !at.at_end(); at.next()) {
    const std::uint16_t flags = at.instance().flags;
    if ((flags & InstanceRecord::kHidden) != 0) continue;
    if ((flags & (InstanceRecord::kTwoSided | InstanceRecord::kScreen)) != 0) {
      return bad_record("InstanceRecord", "flags", at.index(), flags);
    }
    if (at.mesh().fans.empty()) return bad_record("MeshRecord", "fans", at.instance().mesh);
  }
  return {};
}

[[gnu::cold]] Status check_smooth(const SceneRecord& scene) {
  const std::uint32_t materials = scene.materials.size();
  if (materials > FaceLook::kUnknown) return bad_record("SceneRecord", "materials", 0, materials);
  bool gouraud = false;
  for (const MaterialRecord& material : scene.materials) {
    gouraud = gouraud || material.shading == MaterialRecord::kGouraud;
  }
  // A smooth triangle would need more than its brightness.
  if (gouraud && !LightHue::is_one(scene)) return bad_record("LightRecord", "intensity (of several hues)");
  return {};
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
