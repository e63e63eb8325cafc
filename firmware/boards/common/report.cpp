#include "boards/common/report.hpp"

#include "boards/common/run_request.hpp"
#include "hal/mcu/semihosting.hpp"

namespace spanline::boards {
namespace {

// About a tenth of a second at 50 to 180 MHz: whoever counts flashes needs no clock, and after a fault there may be
// none.
void pause(std::uint32_t tenths) {
  for (std::uint32_t turns = tenths * 3'000'000; turns != 0; --turns) asm volatile("");
}

void flash(bool is_long) {
  light(true);
  pause(is_long ? 8 : 2);
  light(false);
  pause(4);
}

void print_digits(std::uint32_t number, std::uint32_t base) {
  char digits[11];
  char* at = digits + sizeof digits - 1;
  *at = 0;
  do {
    *--at = "0123456789abcdef"[number % base];
    number /= base;
  } while (number != 0);
  print(at);
}

}  // namespace

void print(const char* text) {
  if (request().made()) hal::semihosting::print(text);
}

void print(std::uint32_t number) { print_digits(number, 10); }

void print_hex(std::uint32_t number) {
  print("0x");
  print_digits(number, 16);
}

void print_pair(const char* key, std::uint32_t value) {
  print(key);
  print("=");
  print(value);
  print("\n");
}

void stop(const char* cause, std::uint32_t code, std::uint32_t status, std::uint32_t at) {
  print("fault: ");
  print(cause);
  print(", status=");
  print_hex(status);
  print(" at=");
  print_hex(at);
  print("\n");
  if (request().made()) hal::semihosting::leave(1);
  for (;;) {
    for (std::uint32_t i = 0; i < code; ++i) flash(true);
    pause(20);
    for (std::uint32_t bit = 32; bit != 0; --bit) flash((status >> (bit - 1) & 1) != 0);
    pause(40);
  }
}

}  // namespace spanline::boards
