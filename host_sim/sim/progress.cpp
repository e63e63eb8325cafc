#include "sim/progress.hpp"

#include <unistd.h>

#include <iostream>

namespace spanline::host {

Progress::Progress(std::string what, std::int64_t total)
    : what_(std::move(what)), total_(total), terminal_(isatty(STDERR_FILENO) != 0) {}

Progress::~Progress() { clear_line(); }

void Progress::clear_line() {
  if (terminal_ && shown_) std::cerr << "\r\x1b[K" << std::flush;
  shown_ = false;
}

void Progress::step() {
  ++done_;
  if (total_ == 1) return;
  const auto pause = terminal_ ? std::chrono::milliseconds(100) : std::chrono::milliseconds(10000);
  const auto now = Clock::now();
  if (now - last_ < pause) return;
  last_ = now;
  const std::string text = what_ + " " + std::to_string(done_) + " of " + std::to_string(total_);
  std::cerr << (terminal_ ? "\r\x1b[K" + text : text + "\n") << std::flush;
  shown_ = true;
}

void Progress::warn(const std::string& text) {
  clear_line();
  std::cerr << "spanline: warning: " << text << "\n";
}

}  // namespace spanline::host
