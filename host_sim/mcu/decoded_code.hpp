// Instructions already decoded, by address: a run asks for the same ones millions of times.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <memory>
#include <unordered_map>

#include "mcu/cycle_model.hpp"
#include "mcu/decoder.hpp"
#include "mcu/image.hpp"
#include "mcu/marks.hpp"
#include "mcu/places.hpp"

namespace spanline::host {

// Code that changes after it has run is not noticed.
class DecodedCode {
 public:
  struct Entry {
    Instruction insn;
    std::uint32_t function = 0;  // index of Image::functions(), or their number
    std::uint32_t place = 0;     // of places()
    bool marked = false;         // one of the run's Marks
    // To the machine it is more than time: an operand to be looked at, an IT, an end.
    bool special = false;
  };

  DecodedCode(const Image& image, const DebugInfo& debug, Core core, const Marks& marks)
      : image_(image), core_(core), marks_(marks), decoder_(core), places_(image, debug) {}

  // `read`: the halfword at an address.
  template <typename Read>
  const Entry& at(std::uint32_t address, Read read) {
    const Entry*& slot = slot_of(address);
    if (slot == nullptr) {
      const std::uint16_t first = read(address);
      slot = &decode(address, first, thumb_size(first) == 4 ? read(address + 2) : std::uint16_t{0});
    }
    return *slot;
  }

  const Places& places() const { return places_; }

 private:
  static constexpr std::uint32_t kPageBytes = 4096;
  using Page = std::array<const Entry*, kPageBytes / 2>;

  const Entry*& slot_of(std::uint32_t address) {
    if (address / kPageBytes != last_number_) turn_to(address / kPageBytes);
    return (*last_page_)[address % kPageBytes / 2];
  }
  void turn_to(std::uint32_t number);
  const Entry& decode(std::uint32_t address, std::uint16_t first, std::uint16_t second);

  const Image& image_;
  Core core_;
  const Marks& marks_;
  Decoder decoder_;
  Places places_;
  std::unordered_map<std::uint32_t, std::unique_ptr<Page>> pages_;
  std::uint32_t last_number_ = UINT32_MAX;
  Page* last_page_ = nullptr;
  std::deque<Entry> entries_;  // where they are they stay
};

}  // namespace spanline::host
