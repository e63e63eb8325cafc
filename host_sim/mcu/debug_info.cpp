#include "mcu/debug_info.hpp"

#include <dwarf.h>
#include <elfutils/libdw.h>
#include <fcntl.h>
#include <unistd.h>

#include <functional>
#include <map>

namespace spanline::host {
namespace {

// "fill<unsigned>" is "fill"; operators that contain the sign stay whole.
std::string without_arguments(const std::string& name) {
  const std::size_t at = name.find('<');
  return at == std::string::npos || at == 0 || name.rfind("operator", 0) == 0 ? name : name.substr(0, at);
}

std::string name_of(Dwarf_Die& die) {
  Dwarf_Attribute attribute;
  const char* const name = dwarf_formstring(dwarf_attr_integrate(&die, DW_AT_name, &attribute));
  return name == nullptr ? "" : name;
}

std::uint32_t number_of(Dwarf_Die& die, unsigned attribute_name, std::uint32_t otherwise) {
  Dwarf_Attribute attribute;
  Dwarf_Word value = 0;
  if (dwarf_formudata(dwarf_attr_integrate(&die, attribute_name, &attribute), &value) != 0) return otherwise;
  return static_cast<std::uint32_t>(value);
}

bool type_of(Dwarf_Die& die, Dwarf_Die& type) {
  Dwarf_Attribute attribute;
  return dwarf_formref_die(dwarf_attr_integrate(&die, DW_AT_type, &attribute), &type) != nullptr;
}

// The type behind aliases and qualifiers.
bool named_type_of(Dwarf_Die& die, Dwarf_Die& type) {
  bool found = type_of(die, type);
  while (found && (dwarf_tag(&type) == DW_TAG_typedef || dwarf_tag(&type) == DW_TAG_const_type)) {
    Dwarf_Die alias = type;
    found = type_of(alias, type);
  }
  return found;
}

// Calls `visit` with every child.
void each_child(Dwarf_Die& die, const std::function<void(Dwarf_Die&)>& visit) {
  Dwarf_Die child;
  if (dwarf_child(&die, &child) != 0) return;
  do visit(child);
  while (dwarf_siblingof(&child, &child) == 0);
}

}  // namespace

struct DebugInfo::Reader {
  // A function, or an inlined call in it, with the code that belongs to it.
  struct Scope {
    Frame frame;
    std::vector<std::pair<Dwarf_Addr, Dwarf_Addr>> ranges;
    std::vector<Scope> inlined;

    bool holds(Dwarf_Addr address) const {
      for (const auto& [from, to] : ranges) {
        if (address >= from && address < to) return true;
      }
      return false;
    }
  };

  int file = -1;
  Dwarf* dwarf = nullptr;
  std::vector<Scope> functions;
  std::map<Dwarf_Addr, std::string> variables;  // files by address

  explicit Reader(const std::string& path) : file(open(path.c_str(), O_RDONLY)) {
    if (file >= 0) dwarf = dwarf_begin(file, DWARF_C_READ);
    each_unit([this](Dwarf_Die& unit) {
      read_scopes(unit, functions);
      read_variables(unit);
    });
  }
  ~Reader() {
    dwarf_end(dwarf);
    if (file >= 0) close(file);
  }
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;

  void each_unit(const std::function<void(Dwarf_Die&)>& visit) const {
    if (dwarf == nullptr) return;
    Dwarf_CU* unit = nullptr;
    Dwarf_Die die;
    while (dwarf_get_units(dwarf, unit, &unit, nullptr, nullptr, &die, nullptr) == 0) visit(die);
  }

  // Scopes with code below `die`; what lies between (blocks, namespaces, classes) is no scope of its own.
  static void read_scopes(Dwarf_Die& die, std::vector<Scope>& out) {
    each_child(die, [&out](Dwarf_Die& child) {
      const int tag = dwarf_tag(&child);
      const bool is_code = tag == DW_TAG_subprogram || tag == DW_TAG_inlined_subroutine;
      if (!is_code) {
        if (tag == DW_TAG_lexical_block || tag == DW_TAG_namespace || tag == DW_TAG_structure_type ||
            tag == DW_TAG_class_type) {
          read_scopes(child, out);
        }
        return;
      }
      Scope scope;
      Dwarf_Addr base = 0, from = 0, to = 0;
      for (std::ptrdiff_t at = 0; (at = dwarf_ranges(&child, at, &base, &from, &to)) > 0;) {
        if (from < to) scope.ranges.emplace_back(from, to);
      }
      if (scope.ranges.empty()) return;
      const char* const source = dwarf_decl_file(&child);
      scope.frame = {without_arguments(name_of(child)), source == nullptr ? "" : source};
      read_scopes(child, scope.inlined);
      out.push_back(std::move(scope));
    });
  }

  void read_variables(Dwarf_Die& die) {
    each_child(die, [this](Dwarf_Die& child) {
      if (dwarf_tag(&child) != DW_TAG_variable) return read_variables(child);
      Dwarf_Attribute attribute;
      Dwarf_Op* place = nullptr;
      std::size_t operations = 0;
      const char* const source = dwarf_decl_file(&child);
      if (source == nullptr ||
          dwarf_getlocation(dwarf_attr(&child, DW_AT_location, &attribute), &place, &operations) != 0 ||
          operations != 1 || place->atom != DW_OP_addr) {
        return;
      }
      variables.emplace(place->number, source);
    });
  }

  static Member member_of(Dwarf_Die& die) {
    Member member{name_of(die), "", number_of(die, DW_AT_data_member_location, 0), 0};
    Dwarf_Die type;
    if (!named_type_of(die, type)) return member;
    if (dwarf_tag(&type) == DW_TAG_array_type) {
      each_child(type, [&member](Dwarf_Die& bound) {
        if (dwarf_tag(&bound) == DW_TAG_subrange_type) member.elements *= number_of(bound, DW_AT_upper_bound, 0) + 1;
      });
      Dwarf_Die element;
      if (named_type_of(type, element)) type = element;
    }
    member.type = name_of(type);
    member.bytes = number_of(type, DW_AT_byte_size, 0) * member.elements;
    return member;
  }

  static void find_structure(Dwarf_Die& die, const std::string& name_begin, std::optional<Structure>& found) {
    each_child(die, [&](Dwarf_Die& child) {
      const int tag = dwarf_tag(&child);
      if (tag == DW_TAG_namespace) find_structure(child, name_begin, found);
      if (found || (tag != DW_TAG_class_type && tag != DW_TAG_structure_type) ||
          name_of(child).rfind(name_begin, 0) != 0 || number_of(child, DW_AT_byte_size, 0) == 0) {
        return;
      }
      found.emplace();
      found->bytes = number_of(child, DW_AT_byte_size, 0);
      each_child(child, [&found](Dwarf_Die& part) {
        if (dwarf_tag(&part) == DW_TAG_member) found->members.push_back(member_of(part));
      });
    });
  }
};

DebugInfo::DebugInfo(const std::string& path) : reader_(std::make_unique<Reader>(path)) {}

DebugInfo::~DebugInfo() = default;

std::vector<DebugInfo::Frame> DebugInfo::frames_at(std::uint32_t address) const {
  std::vector<Frame> frames;
  const std::vector<Reader::Scope>* scopes = &reader_->functions;
  while (scopes != nullptr) {
    const std::vector<Reader::Scope>* deeper = nullptr;
    for (const Reader::Scope& scope : *scopes) {
      if (!scope.holds(address)) continue;
      frames.push_back(scope.frame);
      deeper = &scope.inlined;
      break;
    }
    scopes = deeper;
  }
  return frames;
}

std::string DebugInfo::file_of(std::uint32_t address) const {
  const auto variable = reader_->variables.find(address);
  if (variable != reader_->variables.end()) return variable->second;
  const std::vector<Frame> frames = frames_at(address);
  return frames.empty() ? "" : frames.front().file;
}

std::optional<DebugInfo::Structure> DebugInfo::structure(const std::string& name_begin) const {
  std::optional<Structure> found;
  reader_->each_unit([&](Dwarf_Die& unit) {
    if (!found) Reader::find_structure(unit, name_begin, found);
  });
  return found;
}

}  // namespace spanline::host
