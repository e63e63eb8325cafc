// Unicorn's hooks, as calls of whoever watches the core.
#pragma once

#include <unicorn/unicorn.h>

#include <cstdint>
#include <string>

#include "mcu/image.hpp"

namespace spanline::host {

// Watcher: on_code(address) before each instruction, on_access(write, address, size), on_interrupt(number), and
// fail(what) where memory is touched that is not there.
template <typename Watcher>
class CoreHooks {
 public:
  static void add(uc_engine* engine, Watcher* watcher) {
    add_one(engine, watcher, UC_HOOK_CODE, code);
    add_one(engine, watcher, UC_HOOK_MEM_READ | UC_HOOK_MEM_WRITE, access);
    add_one(engine, watcher, UC_HOOK_MEM_INVALID, missing);
    add_one(engine, watcher, UC_HOOK_INTR, interrupt);
  }

 private:
  // The library takes any function pointer as void*; a hook of an empty range concerns all addresses.
  template <typename Callback>
  static void add_one(uc_engine* engine, Watcher* watcher, int type, Callback* callback) {
    uc_hook hook = 0;
    uc_hook_add(engine, &hook, type, reinterpret_cast<void*>(callback), watcher, std::uint64_t{1}, std::uint64_t{0});
  }

  static Watcher& of(void* data) { return *static_cast<Watcher*>(data); }

  static void code(uc_engine*, std::uint64_t address, std::uint32_t, void* data) {
    of(data).on_code(static_cast<std::uint32_t>(address));
  }
  static void access(uc_engine*, uc_mem_type type, std::uint64_t address, int size, std::int64_t, void* data) {
    of(data).on_access(type == UC_MEM_WRITE, static_cast<std::uint32_t>(address), static_cast<std::uint32_t>(size));
  }
  static void interrupt(uc_engine*, std::uint32_t number, void* data) { of(data).on_interrupt(number); }
  static bool missing(uc_engine*, uc_mem_type type, std::uint64_t address, int, std::int64_t, void* data) {
    const bool write = type == UC_MEM_WRITE_UNMAPPED || type == UC_MEM_WRITE_PROT;
    const bool fetch = type == UC_MEM_FETCH_UNMAPPED || type == UC_MEM_FETCH_PROT;
    const bool flash = type == UC_MEM_WRITE_PROT;
    of(data).fail(std::string(write   ? "writes "
                              : fetch ? "executes "
                                      : "reads ") +
                  hex(static_cast<std::uint32_t>(address)) +
                  (flash ? ", which is flash" : ", where nothing is modelled"));
    return false;
  }
};

}  // namespace spanline::host
