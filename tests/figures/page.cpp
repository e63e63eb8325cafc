#include "page.hpp"

#include <cstdio>
#include <functional>

namespace spanline::figures {
namespace {

std::string fixed(double value, int decimals) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  return text;
}

std::string percent_more(double value, double base) {
  const std::string text = fixed(100 * (value / base - 1), 1);
  return (text[0] == '-' ? text : "+" + text) + " %";
}

using Cell = std::function<std::string(std::size_t object)>;

// A line of a table: two words and a cell for each object.
std::string line(const std::string& label, const std::string& whose, const Cell& cell) {
  std::string text = "| " + label + " | " + whose + " |";
  for (std::size_t i = 0; i < kObjects; ++i) text += " " + cell(i) + " |";
  return text + "\n";
}

std::string head() {
  std::string rule = "|---|---|";
  for (std::size_t i = 0; i < kObjects; ++i) rule += "--:|";
  return line("", "", [](std::size_t i) { return std::string(kObject[i].name); }) + rule + "\n";
}

Cell row_of(const std::vector<ObjectFigures>& all, Measured ObjectFigures::*machine, const char* key, int decimals) {
  return [&all, machine, key, decimals](std::size_t i) { return fixed((all[i].*machine).row(key), decimals); };
}

std::string figure_table(const std::vector<ObjectFigures>& all) {
  std::string text = head();
  for (const SeedRow& row : kSeedRows) {
    text += line(row.label, "ours", row_of(all, &ObjectFigures::vsg6, row.key, row.decimals));
    text += line("", "seed", [&row](std::size_t i) { return std::string(row.values[i]); });
  }
  return text;
}

std::string active_table(const std::vector<ObjectFigures>& all) {
  const SeedRow& seed = seed_row("reference_ratio");
  return head() +
         line("active entries looked at again", "ours",
              [&all](std::size_t i) { return std::to_string(all[i].vsg6.active_references); }) +
         line("R = M/N", "ours", row_of(all, &ObjectFigures::vsg6, seed.key, seed.decimals)) +
         line("R, these counted too", "ours",
              [&all](std::size_t i) { return fixed(all[i].vsg6.ratio_with_active(), 2); }) +
         line("R", "seed", [&seed](std::size_t i) { return std::string(seed.values[i]); });
}

// The objects whose R, taken by `ratio`, is above the seed's.
template <typename Ratio>
std::string above_the_seed(const std::vector<ObjectFigures>& all, Ratio ratio) {
  const SeedRow& seed = seed_row("reference_ratio");
  std::string names;
  for (std::size_t i = 0; i < kObjects; ++i) {
    if (ratio(all[i].vsg6) <= seed_number(seed.values[i])) continue;
    names += (names.empty() ? "" : ", ") + std::string(kObject[i].name);
  }
  return names.empty() ? "none" : names;
}

std::string verdict_on_ratio(const std::vector<ObjectFigures>& all) {
  const auto plain = [](const Measured& m) { return m.row("reference_ratio"); };
  const auto with_active = [](const Measured& m) { return m.ratio_with_active(); };
  const Measured &cube1 = all[3].vsg6, &cube2 = all[4].vsg6;
  return "\nOur R is above the seed's on: " + above_the_seed(all, plain) +
         "; with these looks counted, on: " + above_the_seed(all, with_active) + ".\nCube2's R is " +
         fixed(plain(cube2), 2) + " against Cube1's " + fixed(plain(cube1), 2) + ", and with these looks " +
         fixed(with_active(cube2), 2) + " against " + fixed(with_active(cube1), 2) + ".\n";
}

std::string step_table(const std::vector<ObjectFigures>& all) {
  const auto both = [&all](const char* key, const char* label, int decimals) {
    return line(label, "VSG5", row_of(all, &ObjectFigures::vsg5, key, decimals)) +
           line("", "VSG6", row_of(all, &ObjectFigures::vsg6, key, decimals));
  };
  return head() + both("segment_references", "references M", 0) +
         line("", "step",
              [&all](std::size_t i) {
                return percent_more(all[i].vsg6.row("segment_references"), all[i].vsg5.row("segment_references"));
              }) +
         both("max_segment_blocks", "max blocks", 0) + both("not_appended_percent", "not appended, %", 2);
}

std::string ladder_table(const Measured& vsg5, const Measured& vsg6) {
  std::string names = "| Penetration |", rule = "|---|", references = "| references, seed |",
              blocks = "| max blocks, seed |";
  for (const SeedStep& step : kSeedLadder) {
    names += std::string(" ") + step.name + " |";
    rule += "--:|";
    references += " " + std::to_string(step.references) + " |";
    blocks += " " + std::to_string(step.max_blocks) + " |";
  }
  const auto ours = [&](const std::string& label, const char* key) {
    return "| " + label + ", ours | | | | | " + fixed(vsg5.row(key), 0) + " | " + fixed(vsg6.row(key), 0) + " |\n";
  };
  return names + "\n" + rule + "\n" + references + "\n" + ours("references", "segment_references") + blocks + "\n" +
         ours("max blocks", "max_segment_blocks");
}

std::string comparator_table(const std::vector<ObjectFigures>& all) {
  const auto both = [&all](const char* key, const char* label, int decimals) {
    return line(label, "midpoint", row_of(all, &ObjectFigures::vsg6, key, decimals)) +
           line("", "plane", row_of(all, &ObjectFigures::plane, key, decimals));
  };
  return head() + both("comparator_cycles", "add cycles", 0) + both("cycles_per_test", "adds a test", 2);
}

constexpr const char* kOpening = R"(# Figure 33, ours beside the seed's

Seed 1 (Watkins, *A Real Time Visible Surface Algorithm*, 1970) measures its algorithm on ten objects, on a raster of 512 × 512
points (its Fig. 33). This page repeats the measurement with this engine. It is written by a command, and a test compares it
with what the command would write now:

```
cmake --build --preset host --target spanline-figures
build/host/spanline-figures assets/watkins docs/figure-33.md
```

The frame is `FrameOptions{.comparator = Comparator::midpoint, .x_sort = XSort::list, .statistics = true}`, one band, pools
large enough. `spanline render assets/watkins/NAME.obj --screen --size 512x512 --comparator midpoint --stats -` prints one
object's numbers (its polygons and edges are those of the file it is given).

In the seed's rows `?` marks a figure that the scan leaves unsure, `~` an approximate one, `*` one repaired with row R = M / N,
which the seed cuts off after two decimals.

)";

constexpr const char* kObjectsText = R"(
**Not the same objects.** The seed prints pictures, no coordinates. The shapes in `assets/watkins` are guesses, tuned so that N,
output segments and implied edges come close to the seed's; blocks and references were not tuned. Polygons and edges count the whole
object (`NAME.all.obj`); what is rendered, and measured in every other row, are its facing polygons (`NAME.obj`). An
implied edge counts when it is made; one that is hidden for more than four lines is freed, and made again when it comes back.
Our Cube2 is not crowded; the seed's has its visible edges in the upper right corner, where many segments lie
over one pixel. So the seed's M, blocks and FIFO for Cube2 do not compare with ours, nor does its "over ten times the number of
memory references" of Cube1. Cube2's references over Cube1's, ours: )";

constexpr const char* kFifoText = R"(.

**FIFO** is the least buffer, in segments, of a display at 30 frames a second and a constant line rate when a reference takes
200 ns; the model stands in `host_sim/sim/fifo.hpp`. The seed does not print its own. At our M the generator never falls behind,
so ours is what the fullest line holds, less what is on the display by then. The seed's 2 for Low Area is less than one of its
fuller lines, so it must have counted otherwise; this row shows an order of magnitude, no more.

## What a reference is

M counts reads and writes of segment blocks, in one accessor (`SegmentStore`, `firmware/core/vsg/blocks.hpp`). A block is read
whole into a register, looked at and changed there, and written back when another block is needed: a visit costs a read, and a
write where it changed something. A new block is made in the register without a read; one that is freed is not written. Each
live segment must be read and written once a line, which is two references for its two edges: the floor is M = N, R = 1.

Ours comes closer to this floor than the seed's for reasons that are choices of counting as much as of method:

- The front blocks of the two lists that a line is taken from stay in registers once read (`FrontRegister`,
  `firmware/core/vsg/x_sort.hpp`); the listing reads the front again in each sample span that it does not belong to.
- The last block of the list for the next line is in a register, and the block furthest right so far is kept back in another
  one. A segment which that block has overtaken is put before it without a search and counts as appended. So *not appended*
  counts only what had to pass a second block; in the seed's count the first would have been enough.
- A segment block holds no depth of a triangle: that is a plane in the polygon block, and M leaves polygon blocks out, the
  seed's too. Depth of any other facet comes from the two halves in the segment block.
- The active list is an array of its own; see the next table.

**Add cycles** likewise: a test costs one for the load, one for the comparison and one for each halving. The seed's clipper also
halves its way to the ends of the interval (III.G); ours gets the depth at the left end from the ramp, with a multiplication
that is not counted. The first segment of a span meets nothing and costs the load alone, so where little overlaps the average
is near 1.

## The active list, openly

In the seed the active list is a link through the segment blocks, and each look at an entry from a later span is a read of its
block (label 301 of the listing; leaving the list costs writes besides). Ours is an array with an entry of 16 bytes for each
segment taken on the line: columns, polygon and, once it has been needed, the depth ramp. A later span looks at that entry and
leaves the segment block alone, except for the ramp of a facet that is no triangle, which is worked out from the block when
first asked for and counted in M. The looks are counted apart, and the third row adds them to M; with the writes too it would be
higher still:

)";

constexpr const char* kStepText = R"(
## From VSG5 to VSG6: bucket sort against list sort

The seed's last step replaced Romney's bucket sort of segments in X by a linked list that stays nearly sorted from line to line.
Both are built here (`XSort::buckets`, `XSort::list`); accesses to the buckets' own memory are not counted, in the seed neither.
A segment that leaves the middle of a bucket counts one reference, without the walk to find it. The pictures are the same.

)";

constexpr const char* kLadderText = R"(
Not appended is 0 with buckets, which have no end to miss. The list costs references, for the links of neighbours where a
segment is put in or taken out and for the searches back. The buckets' price is what the table leaves out: a memory of two
bucket arrays as wide as the screen, one access to file and one to take each segment, and a walk over every column of every
line. That is the seed's own reason for the list: it "produced an increase in memory references", and VSG5 "would have been
greater if accesses to the bucket X-sort memory had been counted".

)";

constexpr const char* kComparatorText = R"(
The seed's step cost Penetration 14 % more references; ours costs less, since the registers named above save most searches.
VSG1 to VSG4 are not built; depth by multiplication, VSG4's mark, can be chosen as the comparator.

## Plane against midpoint comparator

The plane comparator (VSG4's multiplier) evaluates both ramps at both ends of the run; the midpoint comparator (VSG5, VSG6)
halves. The pictures are the same, and so is M.

)";

}  // namespace

std::string figure_page(const std::vector<ObjectFigures>& all) {
  const Measured &penetration = all[0].vsg6, &cube1 = all[3].vsg6, &cube2 = all[4].vsg6;
  const auto times = [](double a, double b) { return fixed(a / b, 1); };
  std::string text = kOpening + figure_table(all) + kObjectsText;
  text += times(cube2.row("segment_references"), cube1.row("segment_references")) + kFifoText + active_table(all);
  text += verdict_on_ratio(all);
  text += kStepText + step_table(all) + kLadderText + ladder_table(all[0].vsg5, penetration);
  return text + kComparatorText + comparator_table(all);
}

}  // namespace spanline::figures
