#include "core/frame/band_lines_impl.hpp"

namespace spanline {

template class BandLines<false, Paint::flat_words>;
template class BandLines<false, Paint::smooth_words>;
template class BandLines<false, Paint::flat_words, true>;
template class BandLines<false, Paint::smooth_words, true>;
template Status BandLines<false, Paint::flat_words>::begin(const SceneView&, const CameraRecord&, std::uint16_t,
                                                           AllLines&);
template Status BandLines<false, Paint::flat_words>::begin(const SceneView&, const CameraRecord&, std::uint16_t,
                                                           ChangedLines&);
template Status BandLines<false, Paint::smooth_words>::begin(const SceneView&, const CameraRecord&, std::uint16_t,
                                                             AllLines&);
template Status BandLines<false, Paint::smooth_words>::begin(const SceneView&, const CameraRecord&, std::uint16_t,
                                                             ChangedLines&);
template Status BandLines<false, Paint::flat_words, true>::begin(const SceneView&, const CameraRecord&, std::uint16_t,
                                                                 AllLines&);
template Status BandLines<false, Paint::smooth_words, true>::begin(const SceneView&, const CameraRecord&, std::uint16_t,
                                                                   AllLines&);

}  // namespace spanline
