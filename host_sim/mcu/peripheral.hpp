// Registers of a chip, as far as our firmware touches them.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

namespace spanline::host {

class Peripheral {
 public:
  Peripheral(std::string name, std::uint32_t base, std::uint32_t bytes)
      : name_(std::move(name)), base_(base), bytes_(bytes) {}
  Peripheral(const Peripheral&) = delete;
  Peripheral& operator=(const Peripheral&) = delete;
  virtual ~Peripheral() = default;

  const std::string& name() const { return name_; }
  std::uint32_t base() const { return base_; }
  std::uint32_t bytes() const { return bytes_; }

  // Words at `offset`; nothing, or false, where no register is modelled.
  virtual std::optional<std::uint32_t> read(std::uint32_t offset) = 0;
  virtual bool write(std::uint32_t offset, std::uint32_t value) = 0;

  // Its clock runs and it has left reset.
  virtual bool alive() const { return true; }

 private:
  std::string name_;
  std::uint32_t base_, bytes_;
};

// Registers that keep what was written to them.
class RegisterBank : public Peripheral {
 public:
  struct Reset {
    std::uint32_t offset, value;
  };
  RegisterBank(std::string name, std::uint32_t base, std::uint32_t bytes, std::initializer_list<Reset> registers)
      : Peripheral(std::move(name), base, bytes), registers_(registers) {}

  std::optional<std::uint32_t> read(std::uint32_t offset) override {
    const Reset* const found = find(offset);
    return found == nullptr ? std::nullopt : std::optional(found->value);
  }
  bool write(std::uint32_t offset, std::uint32_t value) override {
    Reset* const found = find(offset);
    if (found != nullptr) found->value = value;
    return found != nullptr;
  }

 protected:
  // `offset` must be one of the registers.
  std::uint32_t& at(std::uint32_t offset) { return find(offset)->value; }
  std::uint32_t at(std::uint32_t offset) const { return const_cast<RegisterBank*>(this)->find(offset)->value; }

 private:
  Reset* find(std::uint32_t offset) {
    for (Reset& entry : registers_) {
      if (entry.offset == offset) return &entry;
    }
    return nullptr;
  }

  std::vector<Reset> registers_;
};

}  // namespace spanline::host
