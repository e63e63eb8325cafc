// What the C++ library asks of a system. The tests may use a heap, the engine that they test has none.
#include <sys/types.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "boards/common/report.hpp"
#include "hal/mcu/semihosting.hpp"

namespace {

alignas(8) std::uint8_t heap[SPANLINE_TEST_HEAP];
std::size_t taken = 0;

[[noreturn]] void end(const char* why) {
  spanline::boards::print(why);
  spanline::hal::semihosting::leave(1);
}

}  // namespace

extern "C" {

void* __dso_handle = nullptr;

void* _sbrk(std::ptrdiff_t more) {
  if (taken + static_cast<std::size_t>(more) > sizeof heap) end("the tests' heap is too small\n");
  void* const block = heap + taken;
  taken += static_cast<std::size_t>(more);
  return block;
}

// A length_error, a failed assertion: the library has no exceptions here.
void abort() { end("abort\n"); }
char* getenv(const char*) { return nullptr; }
void _exit(int) { end("exit\n"); }
int _kill(int, int) { return -1; }
int _getpid() { return 1; }
int _close(int) { return -1; }
off_t _lseek(int, off_t, int) { return 0; }
int _read(int, char*, int) { return 0; }
int _write(int, const char*, int count) { return count; }
int _isatty(int) { return 0; }
int _fstat(int, void*) { return -1; }
}
