// An image as it is flashed: what an ELF file says about its memory and its names.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace spanline::host {

class Image {
 public:
  struct Segment {
    std::uint32_t load_address;  // where the flash programmer puts it
    std::vector<std::uint8_t> bytes;
  };
  struct Section {
    std::string name;
    std::uint32_t address, size;
    bool in_file;  // has contents, which also lie at `load_address`
    bool writable;
    std::uint32_t load_address;
  };
  struct Symbol {
    std::string name;  // demangled
    std::uint32_t address, size;
  };
  // Where code (thumb) or data begins, by the mapping symbols $t and $d.
  struct Mapping {
    std::uint32_t address;
    bool code;
  };

  // Throws InputError where `path` is not a 32-bit little-endian Arm executable with Thumb code and symbols.
  explicit Image(const std::string& path);

  const std::string& path() const { return path_; }
  std::uint32_t entry() const { return entry_; }  // bit 0 is clear
  const std::vector<Segment>& segments() const { return segments_; }
  const std::vector<Section>& sections() const { return sections_; }   // those that take memory
  const std::vector<Symbol>& functions() const { return functions_; }  // by address; sizes never overlap the next one
  const std::vector<Symbol>& objects() const { return objects_; }      // by address
  const std::vector<Mapping>& mappings() const { return mappings_; }   // by address

  // The index in functions() of the one that `address` lies in, or -1.
  int function_at(std::uint32_t address) const;

  // "reset" or "0x00000040" where no function is.
  std::string name_at(std::uint32_t address) const;

  // The address of the symbol (demangled, mangled, or demangled without return type and
  // parameters). Throws InputError where there
  // is none, or several of that name.
  std::uint32_t address_of(const std::string& name) const;

  // Whether there is one, by any of its names.
  bool defines(const std::string& name) const;

  // Reads through addresses of execution first (code copied to RAM included), then through load addresses. False where
  // nothing is.
  bool read(std::uint32_t address, std::uint32_t size, void* out) const;

 private:
  struct Loaded {
    std::uint32_t address;
    std::vector<std::uint8_t> bytes;
  };
  struct Name {
    std::string plain, mangled;
    std::uint32_t address;
    // By any of its names; by the spoken one where it is a clone, or is none.
    bool is(const std::string& wanted, bool clone) const;
  };
  void read_segments(void* elf);
  void read_sections(void* elf);
  void read_symbols(void* elf);
  void close_gaps();

  std::string path_;
  std::uint32_t entry_ = 0;
  std::vector<Segment> segments_;
  std::vector<Loaded> run_;
  std::vector<Section> sections_;
  std::vector<Symbol> functions_, objects_;
  std::vector<Mapping> mappings_;
  std::vector<Name> names_;
};

// "0x0000beef".
std::string hex(std::uint32_t value);

}  // namespace spanline::host
