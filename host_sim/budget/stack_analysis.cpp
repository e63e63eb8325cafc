#include "budget/stack_analysis.hpp"

#include <algorithm>
#include <optional>

#include "assetc/input_error.hpp"
#include "assetc/text_file.hpp"
#include "budget/stack_frame.hpp"

namespace spanline::host {
namespace {

// Tarjan's strongly connected components over the calls, each bounded as soon as it is complete: callees come first.
class Bounds {
 public:
  Bounds(const Image& image, Core core, const StackNotes& notes) : image_(image), decoder_(core), notes_(notes) {}

  StackBound of(std::uint32_t entry) {
    visit(entry);
    StackBound bound;
    bound.bytes = nodes_.at(entry).bound;
    for (std::optional<std::uint32_t> at = entry; at; at = nodes_.at(*at).deepest_callee) {
      const Node& node = nodes_.at(*at);
      const std::uint32_t below = node.deepest_callee ? nodes_.at(*node.deepest_callee).bound : 0;
      bound.path.push_back({image_.name_at(*at), node.bound - below});
    }
    bound.problems = problems_;
    return bound;
  }

 private:
  struct Node {
    StackFrame frame;
    int index = 0, low = 0;
    bool open = true;  // its component is not complete
    std::uint32_t bound = 0;
    std::optional<std::uint32_t> deepest_callee;
  };

  void resolve_pointers(std::uint32_t function, StackFrame& frame) {
    std::vector<StackFrame::Call> resolved;
    const auto note = notes_.callees.find(entry_of(function));
    for (const StackFrame::Call& call : frame.calls) {
      if (call.callee != 0) {
        resolved.push_back(call);
        continue;
      }
      const std::vector<std::uint32_t>* const callees = note != notes_.callees.end() ? &note->second
                                                        : notes_.other_callees       ? &*notes_.other_callees
                                                                                     : nullptr;
      if (callees == nullptr) {
        problems_.push_back("a call through a pointer at " + hex(call.at) + " in " + image_.name_at(call.at));
        continue;
      }
      for (const std::uint32_t callee : *callees) resolved.push_back({call.at, callee, call.depth});
    }
    frame.calls = resolved;
  }

  std::uint32_t entry_of(std::uint32_t address) const {
    const int index = image_.function_at(address);
    return index < 0 ? address : image_.functions()[static_cast<std::size_t>(index)].address;
  }

  void visit(std::uint32_t function) {
    Node& node = nodes_[function];  // a map's nodes stay where they are
    node.index = node.low = ++count_;
    open_.push_back(function);
    node.frame = stack_frame(image_, decoder_, function);
    problems_.insert(problems_.end(), node.frame.problems.begin(), node.frame.problems.end());
    resolve_pointers(function, node.frame);
    for (const StackFrame::Call& call : node.frame.calls) {
      const auto known = nodes_.find(call.callee);
      if (known == nodes_.end()) {
        visit(call.callee);
        node.low = std::min(node.low, nodes_.at(call.callee).low);
      } else if (known->second.open) {
        node.low = std::min(node.low, known->second.index);
      }
    }
    if (node.low == node.index) close(function);
  }

  void close(std::uint32_t root) {
    const auto first = std::find(open_.begin(), open_.end(), root);
    const std::vector<std::uint32_t> members(first, open_.end());
    open_.erase(first, open_.end());
    for (const std::uint32_t member : members) nodes_.at(member).open = false;
    const auto calls_itself = [&](std::uint32_t member) {
      const std::vector<StackFrame::Call>& calls = nodes_.at(member).frame.calls;
      return std::any_of(calls.begin(), calls.end(),
                         [&](const StackFrame::Call& call) { return call.callee == member; });
    };
    if (members.size() == 1 && !calls_itself(root)) {
      bound_plain(nodes_.at(root));
    } else {
      bound_cycle(members);
    }
  }

  void bound_plain(Node& node) {
    node.bound = node.frame.depth;
    for (const StackFrame::Call& call : node.frame.calls) {
      const std::uint32_t total = call.depth + nodes_.at(call.callee).bound;
      if (total < node.bound || (total == node.bound && node.deepest_callee)) continue;
      node.bound = total;
      node.deepest_callee = call.callee;
    }
  }

  // N turns take at most N frames of every member, and then the deepest callee outside.
  void bound_cycle(const std::vector<std::uint32_t>& members) {
    std::uint32_t once = 0, outside = 0, turns = 0;
    std::optional<std::uint32_t> deepest;
    std::string names;
    for (const std::uint32_t member : members) {
      const Node& node = nodes_.at(member);
      once += node.frame.depth;
      names += (names.empty() ? "" : ", ") + image_.name_at(member);
      const auto note = notes_.turns.find(member);
      if (note != notes_.turns.end()) turns = std::max(turns, note->second);
      for (const StackFrame::Call& call : node.frame.calls) {
        const bool inside = std::find(members.begin(), members.end(), call.callee) != members.end();
        if (inside || nodes_.at(call.callee).bound < outside) continue;
        outside = nodes_.at(call.callee).bound;
        deepest = call.callee;
      }
    }
    if (turns == 0) problems_.push_back("recursion: " + names);
    for (const std::uint32_t member : members) {
      nodes_.at(member).bound = std::max(turns, 1u) * once + outside;
      nodes_.at(member).deepest_callee = deepest;
    }
  }

  const Image& image_;
  Decoder decoder_;
  const StackNotes& notes_;
  std::map<std::uint32_t, Node> nodes_;
  std::vector<std::uint32_t> open_;
  std::vector<std::string> problems_;
  int count_ = 0;
};

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t\r");
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

}  // namespace

StackNotes read_stack_notes(const Image& image, const std::string& path) {
  StackNotes notes;
  const std::string text = read_file(path);
  std::size_t line_number = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    std::string line = text.substr(at, end - at);
    at = end + 1;
    ++line_number;
    line = trimmed(line.substr(0, line.find('#')));
    if (line.empty()) continue;
    const std::size_t calls = line.find(" calls "), recurses = line.find(" recurses ");
    constexpr std::string_view kOthers = "others call ";
    if (line.starts_with(kOthers)) {
      if (!notes.other_callees) notes.other_callees.emplace();
      const std::string callee = trimmed(line.substr(kOthers.size()));
      if (callee != "nothing") notes.other_callees->push_back(image.address_of(callee));
    } else if (calls != std::string::npos) {
      std::vector<std::uint32_t>& callees = notes.callees[image.address_of(trimmed(line.substr(0, calls)))];
      const std::string callee = trimmed(line.substr(calls + 7));
      if (callee != "nothing") callees.push_back(image.address_of(callee));
    } else if (recurses != std::string::npos) {
      std::int64_t turns = 0;
      if (!parse_whole(trimmed(line.substr(recurses + 10)), turns) || turns < 1 || turns > 1'000'000) {
        throw InputError(path, line_number, "wanted a number of turns after 'recurses', from 1 to 1000000");
      }
      notes.turns[image.address_of(trimmed(line.substr(0, recurses)))] = static_cast<std::uint32_t>(turns);
    } else {
      throw InputError(path, line_number,
                       "wanted 'CALLER calls CALLEE', 'others call CALLEE' or 'FUNCTION recurses N'");
    }
  }
  return notes;
}

StackBound stack_bound(const Image& image, Core core, std::uint32_t entry, const StackNotes& notes) {
  return Bounds(image, core, notes).of(entry);
}

StackBound exception_bound(const Image& image, Core core, std::uint32_t vectors, const StackNotes& notes) {
  constexpr std::uint32_t kHardFault = 3, kSvc = 11, kPendSv = 14, kSystem = 16;
  constexpr std::uint32_t kBasicFrame = 32 + 4, kFloatFrame = 104 + 4;  // aligned to 8 where need be
  std::uint32_t count = kSystem;
  for (const Image::Symbol& table : image.objects()) {
    if (table.address == vectors) count = table.size / 4;
  }
  std::uint32_t hard_fault = 0;  // vectors that nobody uses lead there, too
  image.read(vectors + kHardFault * 4, 4, &hard_fault);
  StackBound deepest;
  for (std::uint32_t number = kSvc; number < count; ++number) {
    std::uint32_t handler = 0;
    if (number > kSvc && number < kPendSv) continue;  // the debugger's, and a reserved one
    if (!image.read(vectors + number * 4, 4, &handler) || (handler & 1) == 0 || handler == hard_fault ||
        image.function_at(handler & ~1u) < 0)
      continue;
    const StackBound bound = stack_bound(image, core, handler & ~1u, notes);
    if (deepest.path.empty() || bound.bytes > deepest.bytes) deepest = bound;
  }
  const bool has_float = core == Core::m4 || core == Core::m7 || core == Core::m33;
  if (!deepest.path.empty()) {
    const std::uint32_t frame = has_float ? kFloatFrame : kBasicFrame;
    deepest.bytes += frame;
    deepest.path.front().bytes += frame;
  }
  return deepest;
}

}  // namespace spanline::host
