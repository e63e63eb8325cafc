#include "mcu/decoded_code.hpp"

namespace spanline::host {

void DecodedCode::turn_to(std::uint32_t number) {
  std::unique_ptr<Page>& page = pages_[number];
  if (!page) {
    page = std::make_unique<Page>();
    page->index.fill(-1);
  }
  last_page_ = page.get();
  last_number_ = number;
}

std::int32_t DecodedCode::decode(std::uint32_t address, std::uint16_t first, std::uint16_t second) {
  const int function = image_.function_at(address);
  const std::size_t owner = function < 0 ? image_.functions().size() : static_cast<std::size_t>(function);
  entries_.push_back(std::make_unique<Entry>(
      Entry{decoder_.decode(address, first, second), static_cast<std::uint32_t>(owner), places_.at(address)}));
  return static_cast<std::int32_t>(entries_.size()) - 1;
}

}  // namespace spanline::host
