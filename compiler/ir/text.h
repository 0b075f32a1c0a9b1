// SPDX-License-Identifier: Apache-2.0
// Words of the IR text format that print.c and ir_read.c share.
#ifndef SMC_IR_TEXT_H
#define SMC_IR_TEXT_H

#include "compiler/ir/ir.h"

extern const char *const ir_stat_name[SM_STAT_COUNT];         // names of the statistics, by SmStat: avg median …
extern const char *const ir_block_name[BLOCK_COUNT];          // names of the blocks, by BlockKind: entry step exit

#endif
