// SPDX-License-Identifier: Apache-2.0
// Declarations that the disassembler's files share.
#ifndef SMVM_DISASM_H
#define SMVM_DISASM_H

#include "bytecode-vm/image.h"
#include "bytecode-vm/smvm.h"

typedef struct DisasmOutput {
    SmvmWrite write;
    void *context;
    const SmvmMachine *m;
    uint32_t column;
    SmvmLines lines;
    bool more_lines;
} DisasmOutput;

// ---- text (disasm_text.c) ----

void smvm_text(DisasmOutput *o, const char *s);
void smvm_text_pad(DisasmOutput *o, uint32_t column);  // at least one space, and more up to this column
void smvm_text_number(DisasmOutput *o, uint64_t v);
void smvm_text_whole(DisasmOutput *o, int32_t v);
void smvm_text_hex(DisasmOutput *o, uint64_t v, uint8_t digits);
void smvm_text_f64(DisasmOutput *o, SmF64 x);         // as a decimal if a short one is exact, else like C99's %a
void smvm_text_name(DisasmOutput *o, SmvmName n);
void smvm_text_location(DisasmOutput *o, const char *space, const SmvmLocation *p);
void smvm_text_variable(DisasmOutput *o, SmvmVariable is, const SmvmLocation *p);
void smvm_text_state(DisasmOutput *o, uint32_t s);
const char *smvm_type_name(uint32_t type);

// ---- code (disasm_code.c) ----

void smvm_text_function(DisasmOutput *o, uint32_t index);

#endif
