#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace spanline::host {

// A line on standard error that tells how far a run is: kept up to date on a terminal, otherwise a new one every ten
// seconds. Runs of one step are silent.
class Progress {
 public:
  Progress(std::string what, std::int64_t total);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void step();

  // A whole line of its own.
  void warn(const std::string& text);

 private:
  using Clock = std::chrono::steady_clock;
  void clear_line();

  std::string what_;
  std::int64_t total_, done_ = 0;
  bool terminal_;
  bool shown_ = false;
  Clock::time_point last_ = Clock::now();
};

}  // namespace spanline::host
