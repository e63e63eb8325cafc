#include "mcu/instruction_kinds.hpp"

#include <capstone/capstone.h>

namespace spanline::host {

Kind kind_of(unsigned capstone_id) {
  switch (capstone_id) {
    case ARM_INS_MUL:
      return Kind::multiply;
    case ARM_INS_MLA:
    case ARM_INS_MLS:
      return Kind::multiply_accumulate;
    case ARM_INS_UMULL:
    case ARM_INS_SMULL:
      return Kind::long_multiply;
    case ARM_INS_UMLAL:
    case ARM_INS_SMLAL:
      return Kind::long_multiply_accumulate;
    case ARM_INS_UDIV:
      return Kind::divide_unsigned;
    case ARM_INS_SDIV:
      return Kind::divide_signed;
    case ARM_INS_LDR:
    case ARM_INS_LDRB:
    case ARM_INS_LDRH:
    case ARM_INS_LDRSB:
    case ARM_INS_LDRSH:
    case ARM_INS_LDRT:
    case ARM_INS_LDRBT:
    case ARM_INS_LDRHT:
    case ARM_INS_LDRSBT:
    case ARM_INS_LDRSHT:
      return Kind::load;
    case ARM_INS_STR:
    case ARM_INS_STRB:
    case ARM_INS_STRH:
    case ARM_INS_STRT:
    case ARM_INS_STRBT:
    case ARM_INS_STRHT:
      return Kind::store;
    case ARM_INS_LDM:
    case ARM_INS_LDMDB:
    case ARM_INS_POP:
    case ARM_INS_VLDMIA:
    case ARM_INS_VLDMDB:
    case ARM_INS_VPOP:
    case ARM_INS_VLDR:
      return Kind::load_multiple;
    case ARM_INS_STM:
    case ARM_INS_STMDB:
    case ARM_INS_PUSH:
    case ARM_INS_VSTMIA:
    case ARM_INS_VSTMDB:
    case ARM_INS_VPUSH:
    case ARM_INS_VSTR:
      return Kind::store_multiple;
    case ARM_INS_LDRD:
      return Kind::load_pair;
    case ARM_INS_STRD:
      return Kind::store_pair;
    case ARM_INS_B:
      return Kind::branch;
    case ARM_INS_BL:
      return Kind::call;
    case ARM_INS_CBZ:
    case ARM_INS_CBNZ:
      return Kind::compare_branch;
    case ARM_INS_BX:
    case ARM_INS_BLX:
      return Kind::exchange;
    case ARM_INS_TBB:
    case ARM_INS_TBH:
      return Kind::table_branch;
    case ARM_INS_IT:
      return Kind::if_then;
    case ARM_INS_MRS:
    case ARM_INS_MSR:
      return Kind::special;
    case ARM_INS_LDREX:
    case ARM_INS_LDREXB:
    case ARM_INS_LDREXH:
    case ARM_INS_STREX:
    case ARM_INS_STREXB:
    case ARM_INS_STREXH:
      return Kind::exclusive;
    case ARM_INS_DMB:
    case ARM_INS_DSB:
    case ARM_INS_ISB:
      return Kind::barrier;
    case ARM_INS_VMLA:
    case ARM_INS_VMLS:
    case ARM_INS_VNMLA:
    case ARM_INS_VNMLS:
    case ARM_INS_VFMA:
    case ARM_INS_VFMS:
    case ARM_INS_VFNMA:
    case ARM_INS_VFNMS:
      return Kind::float_accumulate;
    case ARM_INS_VDIV:
    case ARM_INS_VSQRT:
      return Kind::float_divide;
    default:
      return Kind::alu;
  }
}

}  // namespace spanline::host
