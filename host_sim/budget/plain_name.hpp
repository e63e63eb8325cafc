#pragma once

#include <string>

namespace spanline::host {

// A demangled name as people say it: without parameters, template arguments, result and anonymous namespaces.
// "void spanline::Sorter<A>::run<B>(B&)": "spanline::Sorter::run".
std::string plain_name(const std::string& demangled);

}  // namespace spanline::host
