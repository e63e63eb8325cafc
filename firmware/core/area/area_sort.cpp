#include "core/area/area_sort.hpp"

namespace spanline::area {

void SortCounts::add(const SortCounts& other) {
  constexpr std::uint32_t SortCounts::*kDone[] = {
      &SortCounts::clips,      &SortCounts::pairs,  &SortCounts::depth_tests, &SortCounts::pierced,
      &SortCounts::recursions, &SortCounts::cyclic, &SortCounts::dropped,     &SortCounts::details};
  constexpr std::uint16_t SortCounts::*kMost[] = {&SortCounts::polygons, &SortCounts::borders, &SortCounts::pieces,
                                                  &SortCounts::films, &SortCounts::frames};
  for (const auto done : kDone) this->*done += other.*done;
  for (const auto most : kMost) {
    if (this->*most < other.*most) this->*most = other.*most;
  }
}

Status AreaSort::solve() {
  sort_by_source();
  pools_.frames[1] = {};
  depth_ = 1;
  if (translucent_ && panes_ != Panes::unnamed && status_.ok()) add_backdrop();
  if (!status_.ok() || !pierce_all() || !settle() || !make_pieces() || !run()) visible_ = {};
  counts_.borders = borders_.most();
  counts_.pieces = pieces_.ever_used();
  counts_.films = films_.ever_used();
  return status_;
}

// In the base frame everything is in front of nothing. A frame is finished when only clip polygons are left in its
// list.
bool AreaSort::run() {
  while (depth_ != 0) {
    if (const std::uint16_t clip = offender(); clip == 0) {
      if (!show_and_pop()) return false;
    } else if (!push(clip)) {
      return false;
    }
  }
  return true;
}

// The first polygon of the current list that is not on the stack; all of them lie in front of the clip polygon.
std::uint16_t AreaSort::offender() const {
  for (std::uint16_t i = pools_.frames[depth_].inside.first; i != 0; i = pieces_[i].next) {
    if (!polygon_of(pieces_[i]).on_stack) return pieces_[i].name;
  }
  return 0;
}

bool AreaSort::push(std::uint16_t clip) {
  NamedPolygon& polygon = pools_.polygons[clip];
  if (depth_ == pools_.frames.capacity()) return exhausted("frames", depth_, polygon.source);
  std::uint16_t piece = pools_.frames[depth_].inside.first;
  pools_.frames[depth_].inside = {};
  pools_.frames[++depth_] = {clip, {}, {}};
  polygon.on_stack = true;
  if (depth_ > counts_.frames) counts_.frames = depth_;
  if (depth_ > 2) ++counts_.recursions;
  while (piece != 0) {
    const std::uint16_t next = pieces_[piece].next;
    if (!divide(piece)) return false;
    piece = next;
  }
  return true;
}

// What a few signs tell without the clipper; nearly always all that is to be known where both are convex.
AreaSort::Place AreaSort::place_of(const Piece& piece, const NamedPolygon& clip) const {
  if (!piece.bounds.overlaps(clip.bounds) || borders_.has_beside(clip.border, piece.border) ||
      borders_.has_beside(piece.border, clip.border)) {
    return Place::apart;
  }
  return borders_.holds(clip.border, piece.border) ? Place::within : Place::unknown;
}

// The x-y sort of one piece to the area of the clip polygon.
bool AreaSort::divide(std::uint16_t index) {
  SortFrame& frame = pools_.frames[depth_];
  const NamedPolygon& clip = pools_.polygons[frame.clip];
  Piece& piece = pieces_[index];
  if (piece.name == frame.clip) return keep_inside(index);
  ++counts_.pairs;
  const Place place = place_of(piece, clip);
  if (place == Place::apart) {
    append(frame.outside, index);
    return true;
  }
  if (place == Place::within) return keep_inside(index);
  ++counts_.clips;
  clipper_.clear();
  borders_.each(piece.border, [&](const BorderEdge& edge) { clipper_.edge(Role::subject, edge.from, edge.to); });
  borders_.each(clip.border, [&](const BorderEdge& edge) { clipper_.edge(Role::clip, edge.from, edge.to); });
  if (const Status status = clipper_.clip(); !status.ok()) {
    return exhausted(status.where, static_cast<std::uint16_t>(status.limit), polygon_of(piece).source);
  }
  CHECK(clipper_.counts().rounded == 0);
  if (clipper_.first_main(List::inside) == 0) {
    append(frame.outside, index);
    return true;
  }
  if (clipper_.first_main(List::outside) == 0) return keep_inside(index);
  const Piece like = piece;
  borders_.release(piece.border);
  pieces_.give(index);
  PieceList inside;
  if (!take_pieces(List::outside, like, frame.outside) || !take_pieces(List::inside, like, inside)) return false;
  for (std::uint16_t i = inside.first; i != 0;) {
    const std::uint16_t next = pieces_[i].next;
    if (!keep_inside(i)) return false;
    i = next;
  }
  return true;
}

// Step c of the seed for one piece inside the area: what lies behind an opaque clip polygon goes, what lies behind a
// translucent one is marked. A translucent polygon's own pieces are not needed any more, unless panes are shown: all
// behind it bears its mark.
bool AreaSort::keep_inside(std::uint16_t index) {
  SortFrame& frame = pools_.frames[depth_];
  const NamedPolygon& clip = pools_.polygons[frame.clip];
  Piece& piece = pieces_[index];
  const bool own = piece.name == frame.clip;
  if (!own) ++counts_.depth_tests;
  if (own ? clip.opacity == Opacity::opaque || panes_ != Panes::named : nearer(piece, frame.clip)) {
    if (!own && polygon_of(piece).on_stack) ++counts_.cyclic;
    append(frame.inside, index);
    return true;
  }
  if (own || clip.opacity == Opacity::opaque) {
    release(index);
    return true;
  }
  if (panes_ != Panes::unnamed) {
    const std::uint16_t film = films_.take();
    if (film == 0) return exhausted("films", films_.capacity(), clip.source);
    films_[film] = {frame.clip, piece.films};
    piece.films = film;
  }
  append(frame.inside, index);
  return true;
}

// No two polygons pierce each other, so a piece lies on one side of the clip polygon; borders that were rounded may
// reach across their line by a unit, hence the corner that lies farthest off decides.
bool AreaSort::nearer(const Piece& piece, std::uint16_t clip) const {
  const NamedPolygon &front = polygon_of(piece), &back = pools_.polygons[clip];
  std::int64_t before = 0, behind = 0;
  borders_.each(piece.border, [&](const BorderEdge& edge) {
    const std::int64_t lead = value(front, edge.from) - value(back, edge.from);
    if (lead > before) before = lead;
    if (-lead > behind) behind = -lead;
  });
  return before != behind ? before > behind : front.source < back.source;
}

// What is seen of a convex solid lies on the farthest of its planes.
std::int64_t AreaSort::value(const NamedPolygon& polygon, GridPoint p) const {
  if (!polygon.silhouette || polygon.source == kBackdrop) return polygon.plane.value(p);
  std::int64_t least = INT64_MAX;
  for (std::uint16_t i = 0; i < polygon.details; ++i) {
    const std::int64_t value = pools_.polygons[polygon.first_detail + i].plane.value(p);
    if (value < least) least = value;
  }
  return least;
}

// The area of the clip polygon is finished: what is left is visible, and the list goes on with what it cut off.
bool AreaSort::show_and_pop() {
  SortFrame& frame = pools_.frames[depth_--];
  for (std::uint16_t i = frame.inside.first; i != 0;) {
    const std::uint16_t next = pieces_[i].next;
    if (!show(i)) return false;
    i = next;
  }
  if (depth_ == 0) return true;
  pools_.polygons[frame.clip].on_stack = false;
  pools_.frames[depth_].inside = frame.outside;
  return true;
}

bool AreaSort::show(std::uint16_t index) {
  const NamedPolygon& polygon = polygon_of(pieces_[index]);
  if (polygon.source == kBackdrop && !polygon.silhouette && pieces_[index].films == 0) {
    release(index);
    return true;
  }
  if (!sort_films(pieces_[index])) return false;
  PieceList rest;
  append(rest, index);
  if (!show_detail(rest, polygon)) return false;
  for (std::uint16_t i = rest.first; i != 0;) {
    const std::uint16_t next = pieces_[i].next;
    if (polygon.silhouette) {
      release(i);
    } else {
      append(visible_, i);
    }
    i = next;
  }
  return true;
}

// Cuts detail out of visible pieces, the topmost first; what is under none of it stays in `rest`.
bool AreaSort::show_detail(PieceList& rest, const NamedPolygon& host) {
  for (std::uint16_t i = 0; i < host.details; ++i) {
    std::uint16_t piece = rest.first;
    rest = {};
    while (piece != 0) {
      const std::uint16_t next = pieces_[piece].next;
      if (!cut_detail(piece, static_cast<std::uint16_t>(host.first_detail + i), rest)) return false;
      piece = next;
    }
  }
  return true;
}

bool AreaSort::cut_detail(std::uint16_t index, std::uint16_t name, PieceList& rest) {
  const NamedPolygon& detail = pools_.polygons[name];
  const Piece piece = pieces_[index];
  const Place place = place_of(piece, detail);
  if (place != Place::unknown) {
    if (place == Place::within) pieces_[index].name = name;
    append(place == Place::within ? visible_ : rest, index);
    return true;
  }
  ++counts_.details;
  clipper_.clear();
  borders_.each(piece.border, [&](const BorderEdge& edge) { clipper_.edge(Role::subject, edge.from, edge.to); });
  borders_.each(detail.border, [&](const BorderEdge& edge) { clipper_.edge(Role::clip, edge.from, edge.to); });
  if (const Status status = clipper_.clip(); !status.ok()) {
    return exhausted(status.where, static_cast<std::uint16_t>(status.limit), detail.source);
  }
  release(index);
  const Piece like{{}, {}, name, piece.films, 0};
  return take_pieces(List::outside, piece, rest) && take_pieces(List::inside, like, visible_);
}

// Marks were set in the order in which polygons became the clip polygon; pieces share the ends of their lists of marks,
// so the list in order is a new one.
bool AreaSort::sort_films(Piece& piece) {
  std::uint16_t sorted = 0;
  for (std::uint16_t i = piece.films; i != 0; i = films_[i].next) {
    const std::uint16_t film = films_.take();
    if (film == 0) return exhausted("films", films_.capacity(), pools_.polygons[films_[i].name].source);
    const Piece pane{piece.border, piece.bounds, films_[i].name, 0, 0};
    std::uint16_t* place = &sorted;
    while (*place != 0 && !nearer(pane, films_[*place].name)) place = &films_[*place].next;
    films_[film] = {films_[i].name, *place};
    *place = film;
  }
  piece.films = sorted;
  return true;
}

// A list of the clipper as pieces `like` another.
bool AreaSort::take_pieces(List list, const Piece& like, PieceList& to) {
  struct Reader {
    AreaSort& sort;
    const Piece& like;
    PieceList& to;
    Border border;
    GridPoint start, last;
    bool open = false, fits = true;

    void begin_polygon() { border = {}; }
    void begin_contour() { open = false; }
    void vertex(std::int32_t x, std::int32_t y) {
      const GridPoint at{static_cast<std::int16_t>(x), static_cast<std::int16_t>(y)};
      if (open) sort.borders_.append(border, last, at);
      if (!open) start = at;
      open = true;
      last = at;
    }
    void end_contour() { sort.borders_.append(border, last, start); }
    void end_polygon() {
      const std::uint16_t index = sort.pieces_.take();
      if (index == 0) fits = false;
      if (!fits) return;
      sort.pieces_[index] = {border, sort.borders_.bounds(border), like.name, like.films, 0};
      sort.append(to, index);
    }
  } reader{*this, like, to, {}, {}, {}};
  clipper_.read(list, reader);
  const std::uint16_t source = pools_.polygons[like.name].source;
  if (!reader.fits) return exhausted("pieces", pieces_.capacity(), source);
  return borders_fit(source);
}

void AreaSort::append(PieceList& list, std::uint16_t piece) {
  pieces_[piece].next = 0;
  if (list.first == 0) {
    list.first = piece;
  } else {
    pieces_[list.last].next = piece;
  }
  list.last = piece;
}

void AreaSort::release(std::uint16_t piece) {
  borders_.release(pieces_[piece].border);
  pieces_.give(piece);
}

}  // namespace spanline::area
