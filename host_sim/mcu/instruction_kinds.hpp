#pragma once

#include "mcu/instruction.hpp"

namespace spanline::host {

// What an instruction is to the cycle rules, by capstone's number of it. Jumps by ADD PC and MOV PC are `alu` here.
Kind kind_of(unsigned capstone_id);

}  // namespace spanline::host
