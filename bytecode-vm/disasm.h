// SPDX-License-Identifier: Apache-2.0
// Declarations that the disassembler's files share.
#ifndef SMVM_DISASM_H
#define SMVM_DISASM_H

#include "bytecode-vm/image.h"
#include "bytecode-vm/smvm.h"

typedef struct Out {
    SmvmWrite write;
    void *context;
    const SmvmMachine *m;
    uint32_t column;
    SmvmLines lines;
    bool more_lines;
} Out;

// ---- text (disasm_text.c) ----

void smvm_text(Out *o, const char *s);
void smvm_text_pad(Out *o, uint32_t column);          // at least one space, and more up to this column
void smvm_text_number(Out *o, uint64_t v);
void smvm_text_whole(Out *o, int32_t v);
void smvm_text_hex(Out *o, uint64_t v, uint8_t digits);
void smvm_text_f64(Out *o, SmF64 x);                  // as a decimal if a short one is exact, else like C99's %a
void smvm_text_name(Out *o, SmvmName n);
void smvm_text_place(Out *o, const char *space, const SmvmPlace *p);
void smvm_text_variable(Out *o, SmvmVariable is, const SmvmPlace *p);
void smvm_text_state(Out *o, uint32_t s);
const char *smvm_type_name(uint32_t type);

// ---- code (disasm_code.c) ----

void smvm_text_function(Out *o, uint32_t index);

#endif
