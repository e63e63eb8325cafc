// Bus and pins as a driver sees them, with a controller's model at their far end.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "panel/panel_model.hpp"

namespace spanline::host {

// The wires between a driver and a model, and the record of what crossed them.
struct Bench {
  // Kinds of a record of two bytes: the kind, then the byte or the level.
  enum Kind : std::uint8_t { command, data, select, reset };

  PanelModel& model;
  SimClock& clock;
  bool keep_log = false;
  std::vector<std::uint8_t> log = {};
  bool data_level = false, select_level = true, reset_level = true;
  bool in_flight = false;

  void record(Kind kind, std::uint8_t value) {
    if (keep_log) log.insert(log.end(), {kind, value});
  }
};

// Satisfies hal::OutPin: one of the panel's three.
class SimPin {
 public:
  enum Role { data, select, reset };
  SimPin(Bench& bench, Role role) : bench_(&bench), role_(role) {}

  void set(bool level) {
    bool& now = role_ == data ? bench_->data_level : role_ == select ? bench_->select_level : bench_->reset_level;
    if (level == now) return;
    now = level;
    if (bench_->in_flight) bench_->model.complain("pin moved with a transfer in flight");
    if (role_ == data) return bench_->model.set_data(level);
    bench_->record(role_ == select ? Bench::select : Bench::reset, level ? 1 : 0);
    if (role_ == select) return bench_->model.set_select(level);
    bench_->model.set_reset(level);
  }

 private:
  Bench* bench_;
  Role role_;
};

// Satisfies hal::SpiBus, hal::SpiModes and hal::SpiReads. The bytes of a transfer are read when it is waited for, so
// that a line that is overwritten in flight shows. A fault can be planted.
class SimBus {
 public:
  explicit SimBus(Bench& bench) : bench_(bench) {}

  void set_mode(std::uint8_t mode) { mode_ = mode; }
  std::uint32_t set_clock(std::uint32_t hz) { return clock_hz_ = std::min(hz, fastest_hz_); }

  hal::Fault write(Slice<const std::uint8_t> bytes) {
    if (bench_.in_flight) bench_.model.complain("bus written to with a transfer in flight");
    if (fails()) return fault_;
    shift(bytes);
    return hal::Fault::none;
  }
  hal::Fault start(Slice<const std::uint8_t> bytes) {
    if (bench_.in_flight) return hal::Fault::dma_error;
    if (fails()) return fault_;
    pending_ = bytes;
    bench_.in_flight = true;
    return hal::Fault::none;
  }
  hal::Fault wait() {
    if (!bench_.in_flight) return hal::Fault::none;
    bench_.in_flight = false;
    if (fails()) return fault_;
    shift(pending_);
    return hal::Fault::none;
  }

  hal::Fault read(Slice<std::uint8_t> answer) {
    if (bench_.in_flight) bench_.model.complain("bus read from with a transfer in flight");
    if (fails()) return fault_;
    for (std::uint8_t& byte : answer) byte = unplugged_ ? floating_ : bench_.model.answer(clock_hz_);
    return hal::Fault::none;
  }

  // The operation after `after` more ones, and all that follow, end in `fault`; Fault::none mends the bus.
  void plant(hal::Fault fault, unsigned after) {
    fault_ = fault;
    fuse_ = after;
  }
  // What set_clock can reach at most.
  void limit_clock(std::uint32_t hz) { fastest_hz_ = hz; }
  // Nothing is there any more; the receive line floats and reads as `byte`.
  void unplug(std::uint8_t byte) {
    unplugged_ = true;
    floating_ = byte;
  }
  // Runs at `hz` whatever was asked for.
  void force_clock(std::uint32_t hz) { clock_hz_ = hz; }

 private:
  bool fails() {
    if (fault_ == hal::Fault::none) return false;
    if (fuse_ == 0) return true;
    --fuse_;
    return false;
  }
  void shift(Slice<const std::uint8_t> bytes) {
    for (const std::uint8_t byte : bytes) {
      bench_.clock.advance_ns(8'000'000'000u / std::max<std::uint64_t>(clock_hz_, 1));
      bench_.record(bench_.data_level ? Bench::data : Bench::command, byte);
      bench_.model.shift(byte, clock_hz_, mode_);
    }
  }

  Bench& bench_;
  Slice<const std::uint8_t> pending_;
  hal::Fault fault_ = hal::Fault::none;
  unsigned fuse_ = 0;
  std::uint32_t clock_hz_ = 1'000'000, fastest_hz_ = UINT32_MAX;
  std::uint8_t mode_ = 0, floating_ = 0;
  bool unplugged_ = false;
};

}  // namespace spanline::host
