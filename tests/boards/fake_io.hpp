// Registers without hardware: a device answers for every address, and parts of it can be broken.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

namespace spanline::hal {

// Plain memory, until a model derives from it. The device made last is the one that FakeIo reaches.
class FakeDevice {
 public:
  FakeDevice() { current() = this; }
  FakeDevice(const FakeDevice&) = delete;
  FakeDevice& operator=(const FakeDevice&) = delete;
  virtual ~FakeDevice() = default;

  // These bits of the register at `address` read as 0, or as 1, from now on.
  void stick_low(std::uint32_t address, std::uint32_t bits) { low_[address] |= bits; }
  void stick_high(std::uint32_t address, std::uint32_t bits) { high_[address] |= bits; }

  std::uint32_t read(std::uint32_t address) {
    ++reads_;
    const std::uint32_t value = get(address);
    return (value & ~low_[address]) | high_[address];
  }
  void write(std::uint32_t address, std::uint32_t value) { set(address, value); }
  std::uint32_t reads() const { return reads_; }

  // Memory that DMA is to reach, by the address that the driver was given for it.
  std::uint32_t address_of(const void* memory) {
    memories_.push_back(static_cast<const std::uint8_t*>(memory));
    return kMemory + static_cast<std::uint32_t>(memories_.size());
  }
  const std::uint8_t* memory_at(std::uint32_t address) const { return memories_.at(address - kMemory - 1); }

  static FakeDevice*& current() {
    static FakeDevice* device = nullptr;
    return device;
  }

 protected:
  virtual std::uint32_t get(std::uint32_t address) { return words_[address]; }
  virtual void set(std::uint32_t address, std::uint32_t value) { words_[address] = value; }

  std::map<std::uint32_t, std::uint32_t> words_;

 private:
  static constexpr std::uint32_t kMemory = 0x2000'0000;
  std::map<std::uint32_t, std::uint32_t> low_, high_;
  std::vector<const std::uint8_t*> memories_;
  std::uint32_t reads_ = 0;
};

struct FakeIo {
  static std::uint32_t get(std::uint32_t address) { return FakeDevice::current()->read(address); }
  static void set(std::uint32_t address, std::uint32_t value) { FakeDevice::current()->write(address, value); }
  static std::uint32_t address_of(const void* memory) { return FakeDevice::current()->address_of(memory); }
};

}  // namespace spanline::hal
