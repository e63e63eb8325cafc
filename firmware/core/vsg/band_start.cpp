#include "core/vsg/band_start.hpp"

namespace spanline {

void start_band_fans_plain(BandStart& start) {
  do {
    if (start.at() >= start.count || start.most() > start.room()) return;
    start.each_to_start([&start](const FromVertex& from, PackedXY bottom, CoverKey begins, CoverKey ends) {
      ActiveEdge* const out = start.out++;
      out->toggle = begins - ends;
      from.run(*out, bottom, static_cast<FaceId>(ends));
      if (out->x < out[-1].x) [[unlikely]]
        insert_back(start.begin, out, ActiveEdge{*out});
    });
    start.vertex = start.band[start.vertex].next;
  } while (start.vertex != 0);
}

}  // namespace spanline
