#include "mcu/image.hpp"

#include <cxxabi.h>
#include <gelf.h>
#include <libelf.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string_view>

#include "assetc/input_error.hpp"
#include "assetc/text_file.hpp"

namespace spanline::host {
namespace {

constexpr std::uint32_t kThumb = 1;

std::string demangled(const char* name) {
  if (name[0] != '_' || name[1] != 'Z') return name;  // else a C function `f` would be called `float`
  int status = 0;
  const std::unique_ptr<char, decltype(&std::free)> text(abi::__cxa_demangle(name, nullptr, nullptr, &status),
                                                         &std::free);
  return status == 0 && text ? text.get() : name;
}

constexpr const char* kClone = " [clone ";

// Where what stands in brackets at the end of `name` begins; its length where nothing does.
std::size_t last_brackets(const std::string& name) {
  int depth = 0;
  for (std::size_t at = name.size(); at-- != 0;) {
    depth += name[at] == ')' ? 1 : name[at] == '(' ? -1 : 0;
    if (depth == 0) return name[at] == '(' ? at : name.size();
  }
  return name.size();
}

// Behind the last space outside brackets: a return type stands before it.
std::size_t behind_return_type(const std::string& name) {
  int depth = 0;
  for (std::size_t at = name.size(); at-- != 0;) {
    const char c = name[at];
    depth += c == ')' || c == '>' ? 1 : c == '(' || c == '<' ? -1 : 0;
    if (depth == 0 && c == ' ') return at + 1;
  }
  return 0;
}

// "int n::f<T>(int) const [clone .isra.0]" to "n::f<T>": what a user types after --until.
std::string spoken(const std::string& demangled) {
  constexpr std::string_view kConst = " const";
  std::string name = demangled.substr(0, demangled.find(kClone));
  if (name.ends_with(kConst)) name.resize(name.size() - kConst.size());
  name.resize(last_brackets(name));
  return name.find("operator") == std::string::npos ? name.substr(behind_return_type(name)) : name;
}

std::uint32_t narrow(GElf_Addr value) { return static_cast<std::uint32_t>(value); }

Elf* elf_of(void* elf) { return static_cast<Elf*>(elf); }

}  // namespace

std::string hex(std::uint32_t value) {
  char text[11];
  std::snprintf(text, sizeof text, "0x%08x", value);
  return text;
}

Image::Image(const std::string& path) : path_(path) {
  std::string bytes = read_file(path);
  elf_version(EV_CURRENT);
  const std::unique_ptr<Elf, decltype(&elf_end)> elf(elf_memory(bytes.data(), bytes.size()), &elf_end);
  if (!elf || elf_kind(elf.get()) != ELF_K_ELF) throw InputError(path, "not an ELF file");
  GElf_Ehdr header;
  if (gelf_getehdr(elf.get(), &header) == nullptr) throw InputError(path, "an ELF file with a broken header");
  if (header.e_machine != EM_ARM || header.e_ident[EI_CLASS] != ELFCLASS32 || header.e_ident[EI_DATA] != ELFDATA2LSB) {
    const bool wide = header.e_ident[EI_CLASS] == ELFCLASS64, big = header.e_ident[EI_DATA] == ELFDATA2MSB;
    throw InputError(path, "not for a Cortex-M: the ELF's machine is " + std::to_string(header.e_machine) + " (" +
                               (wide ? "64" : "32") + " bits, " + (big ? "big" : "little") +
                               "-endian), wanted 40 (32 bits, little-endian)");
  }
  if (header.e_type != ET_EXEC) throw InputError(path, "not linked: an executable is wanted, not an object file");
  if ((header.e_entry & kThumb) == 0 && header.e_entry != 0) {
    throw InputError(path, "its entry point " + hex(narrow(header.e_entry)) + " is not Thumb code");
  }
  entry_ = narrow(header.e_entry) & ~kThumb;
  read_segments(elf.get());
  read_sections(elf.get());
  read_symbols(elf.get());
  if (functions_.empty()) throw InputError(path, "has no symbols: link it without -s, do not strip it");
}

void Image::read_segments(void* elf) {
  std::size_t count = 0, size = 0;
  const char* const raw = elf_rawfile(elf_of(elf), &size);
  if (elf_getphdrnum(elf_of(elf), &count) != 0) throw InputError(path_, "its program headers cannot be read");
  for (std::size_t i = 0; i < count; ++i) {
    GElf_Phdr segment;
    if (gelf_getphdr(elf_of(elf), static_cast<int>(i), &segment) == nullptr) {
      throw InputError(path_, "program header " + std::to_string(i) + " cannot be read");
    }
    if (segment.p_type != PT_LOAD || segment.p_filesz == 0) continue;
    if (segment.p_offset > size || segment.p_filesz > size - segment.p_offset) {
      throw InputError(path_, "is cut off: program header " + std::to_string(i) + " points behind its end");
    }
    const std::vector<std::uint8_t> bytes(raw + segment.p_offset, raw + segment.p_offset + segment.p_filesz);
    segments_.push_back({narrow(segment.p_paddr), bytes});
    run_.push_back({narrow(segment.p_vaddr), bytes});
  }
  if (segments_.empty()) throw InputError(path_, "has nothing to load");
}

void Image::read_sections(void* elf) {
  std::size_t names = 0;
  if (elf_getshdrstrndx(elf_of(elf), &names) != 0) throw InputError(path_, "its section headers cannot be read");
  std::size_t headers = 0;
  elf_getphdrnum(elf_of(elf), &headers);
  for (Elf_Scn* section = nullptr; (section = elf_nextscn(elf_of(elf), section)) != nullptr;) {
    GElf_Shdr header;
    if (gelf_getshdr(section, &header) == nullptr || (header.sh_flags & SHF_ALLOC) == 0 || header.sh_size == 0)
      continue;
    const char* const name = elf_strptr(elf_of(elf), names, header.sh_name);
    Section found{name != nullptr ? name : "?",
                  narrow(header.sh_addr),
                  narrow(header.sh_size),
                  header.sh_type != SHT_NOBITS,
                  (header.sh_flags & SHF_WRITE) != 0,
                  narrow(header.sh_addr)};
    for (std::size_t i = 0; i < headers; ++i) {
      GElf_Phdr segment;
      if (gelf_getphdr(elf_of(elf), static_cast<int>(i), &segment) == nullptr || segment.p_type != PT_LOAD) continue;
      if (header.sh_addr >= segment.p_vaddr && header.sh_addr - segment.p_vaddr < segment.p_memsz) {
        found.load_address = narrow(segment.p_paddr + (header.sh_addr - segment.p_vaddr));
      }
    }
    sections_.push_back(found);
  }
}

void Image::read_symbols(void* elf) {
  for (Elf_Scn* section = nullptr; (section = elf_nextscn(elf_of(elf), section)) != nullptr;) {
    GElf_Shdr header;
    if (gelf_getshdr(section, &header) == nullptr || header.sh_type != SHT_SYMTAB || header.sh_entsize == 0) continue;
    Elf_Data* const data = elf_getdata(section, nullptr);
    const std::size_t count = data == nullptr ? 0 : header.sh_size / header.sh_entsize;
    for (std::size_t i = 0; i < count; ++i) {
      GElf_Sym symbol;
      if (gelf_getsym(data, static_cast<int>(i), &symbol) == nullptr || symbol.st_shndx == SHN_UNDEF) continue;
      const char* const mangled = elf_strptr(elf_of(elf), header.sh_link, symbol.st_name);
      if (mangled == nullptr || *mangled == 0) continue;
      const unsigned type = GELF_ST_TYPE(symbol.st_info);
      const std::uint32_t address = narrow(symbol.st_value);
      if (mangled[0] == '$') {
        if (mangled[1] == 't' || mangled[1] == 'd') mappings_.push_back({address, mangled[1] == 't'});
        continue;
      }
      if (type == STT_SECTION || type == STT_FILE) continue;
      const std::string name = demangled(mangled);
      const std::uint32_t place = type == STT_FUNC ? address & ~kThumb : address;
      names_.push_back({name, mangled, place});
      if (type == STT_FUNC) functions_.push_back({name, place, narrow(symbol.st_size)});
      if (type == STT_OBJECT) objects_.push_back({name, place, narrow(symbol.st_size)});
    }
  }
  close_gaps();
}

// Assembly often leaves the size out, and compilers give one function several names.
void Image::close_gaps() {
  const auto by_address = [](const auto& a, const auto& b) { return a.address < b.address; };
  std::stable_sort(objects_.begin(), objects_.end(), by_address);
  std::stable_sort(mappings_.begin(), mappings_.end(), by_address);
  std::stable_sort(functions_.begin(), functions_.end(), [](const Symbol& a, const Symbol& b) {
    return a.address != b.address ? a.address < b.address : a.size != b.size ? a.size > b.size : a.name < b.name;
  });
  const auto same = [](const Symbol& a, const Symbol& b) { return a.address == b.address; };
  functions_.erase(std::unique(functions_.begin(), functions_.end(), same), functions_.end());
  for (std::size_t i = 0; i < functions_.size(); ++i) {
    Symbol& function = functions_[i];
    std::uint32_t end = UINT32_MAX;
    for (const Section& section : sections_) {
      if (function.address - section.address < section.size) end = section.address + section.size;
    }
    if (i + 1 < functions_.size()) end = std::min(end, functions_[i + 1].address);
    if (end == UINT32_MAX) continue;
    function.size = function.size == 0 ? end - function.address : std::min(function.size, end - function.address);
  }
}

int Image::function_at(std::uint32_t address) const {
  const auto after = std::upper_bound(functions_.begin(), functions_.end(), address,
                                      [](std::uint32_t wanted, const Symbol& f) { return wanted < f.address; });
  if (after == functions_.begin()) return -1;
  const Symbol& function = *(after - 1);
  return address - function.address < function.size ? static_cast<int>(after - 1 - functions_.begin()) : -1;
}

std::string Image::name_at(std::uint32_t address) const {
  const int index = function_at(address);
  return index < 0 ? hex(address) : functions_[static_cast<std::size_t>(index)].name;
}

bool Image::Name::is(const std::string& wanted, bool clone) const {
  if (clone != (plain.find(kClone) != std::string::npos)) return wanted == mangled || wanted == plain;
  return wanted == plain || wanted == mangled || wanted == spoken(plain);
}

std::uint32_t Image::address_of(const std::string& name) const {
  const Name* found = nullptr;
  for (const bool clone : {false, true}) {  // a clone is meant only where the compiler has left nothing else
    for (const Name& candidate : names_) {
      if (!candidate.is(name, clone)) continue;
      if (found != nullptr && found->address != candidate.address) {
        throw InputError(path_, "has several symbols '" + printable(name) + "', at " + hex(found->address) + " and " +
                                    hex(candidate.address) + ": give the mangled name");
      }
      found = &candidate;
    }
    if (found != nullptr) return found->address;
  }
  throw InputError(path_, "has no symbol '" + printable(name) + "'");
}

bool Image::defines(const std::string& name) const {
  return std::any_of(names_.begin(), names_.end(),
                     [&](const Name& candidate) { return candidate.is(name, false) || candidate.is(name, true); });
}

bool Image::read(std::uint32_t address, std::uint32_t size, void* out) const {
  const auto copy = [&](std::uint32_t base, const std::vector<std::uint8_t>& bytes) {
    if (address < base || address - base > bytes.size() || bytes.size() - (address - base) < size) return false;
    std::memcpy(out, bytes.data() + (address - base), size);
    return true;
  };
  for (const Loaded& segment : run_) {
    if (copy(segment.address, segment.bytes)) return true;
  }
  for (const Segment& segment : segments_) {
    if (copy(segment.load_address, segment.bytes)) return true;
  }
  return false;
}

}  // namespace spanline::host
