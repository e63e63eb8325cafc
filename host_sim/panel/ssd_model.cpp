#include "panel/ssd_model.hpp"

#include <algorithm>

namespace spanline::host {

void SsdModel::reset_state() {
  arguments_.clear();
  wanted_ = 0;
  columns_ = rows_ = {};
  on_ = full_ = false;
  next_ = {};
  clear();
}

void SsdModel::take_command(std::uint8_t byte) {
  if (wanted_ == 0) {
    const auto known = std::find_if(known_.begin(), known_.end(),
                                    [byte](const SsdCommand& c) { return c.first <= byte && byte <= c.last; });
    if (known == known_.end()) return complain("unknown command " + hex(byte));
    command_ = byte;
    wanted_ = known->arguments;
    arguments_.clear();
  } else {
    arguments_.push_back(byte);
    --wanted_;
  }
  if (wanted_ == 0) carry_out(command_);
}

SsdModel::Range SsdModel::range(unsigned size) {
  Range r{arguments_[0], arguments_[1], true};
  if (r.first > r.last || r.last >= size) {
    complain("window " + std::to_string(r.first) + "-" + std::to_string(r.last) + " of " + std::to_string(size));
    r.last = std::min(r.last, size - 1);
    r.first = std::min(r.first, r.last);
  }
  return r;
}

void SsdModel::restart_window() {
  next_ = {columns_.first, rows_.first};
  full_ = false;
}

bool SsdModel::next_place(Place& place) {
  if (wanted_ != 0) {
    complain(hex(command_) + " with " + std::to_string(arguments_.size()) + " of " +
             std::to_string(arguments_.size() + wanted_) + " arguments");
    wanted_ = 0;
  }
  if (!columns_.given || !rows_.given) {
    complain("data without a window");
    return false;
  }
  if (full_) {
    complain("data past the window");
    return false;
  }
  place = next_;
  if (next_.column++ == columns_.last) {
    next_.column = columns_.first;
    full_ = next_.row++ == rows_.last;
  }
  return true;
}

}  // namespace spanline::host
