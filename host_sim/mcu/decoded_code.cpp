#include "mcu/decoded_code.hpp"

namespace spanline::host {

void DecodedCode::turn_to(std::uint32_t number) {
  std::unique_ptr<Page>& page = pages_[number];
  if (!page) page = std::make_unique<Page>();
  last_page_ = page.get();
  last_number_ = number;
}

const DecodedCode::Entry& DecodedCode::decode(std::uint32_t address, std::uint16_t first, std::uint16_t second) {
  const int function = image_.function_at(address);
  const std::size_t owner = function < 0 ? image_.functions().size() : static_cast<std::size_t>(function);
  const Instruction insn = decoder_.decode(address, first, second);
  const bool takes_operands = CycleModel::asks_for_operands(core_, insn.kind);
  const bool spins = insn.kind == Kind::branch && insn.direct && insn.target == address;
  const bool special = takes_operands || spins || insn.kind == Kind::if_then || insn.waits || !insn.supported;
  entries_.push_back({insn, static_cast<std::uint32_t>(owner), places_.at(address), marks_.any(address), special});
  return entries_.back();
}

}  // namespace spanline::host
