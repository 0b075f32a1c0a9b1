// SPDX-License-Identifier: Apache-2.0
// Declarations that the disassembler's files share.
#ifndef SMVM_DISASM_H
#define SMVM_DISASM_H

#include "bytecode-vm/image.h"
#include "bytecode-vm/smvm.h"

typedef struct DisasmOutput {
    SmvmWrite write;
    void *context;
    const SmvmMachine *m;     // the machine that is printed
    uint32_t column;          // how many characters the current line has
    SmvmLines lines;          // iterates over the source lines of the machine
    bool more_lines;          // `lines` contains a line that has not been printed yet
} DisasmOutput;

// ---- text (disasm_text.c) ----

void smvm_print(DisasmOutput *o, const char *s);
void smvm_print_padding(DisasmOutput *o, uint32_t column);  // prints at least one space, and further ones up to this column
void smvm_print_unsigned(DisasmOutput *o, uint64_t v);
void smvm_print_signed(DisasmOutput *o, int32_t v);
void smvm_print_hex(DisasmOutput *o, uint64_t v, uint8_t digits);
void smvm_print_f64(DisasmOutput *o, SmF64 x);         // prints x as a decimal if a short one is exact, else like C99's %a
void smvm_print_name(DisasmOutput *o, SmvmName n);
void smvm_print_location(DisasmOutput *o, const char *prefix, const SmvmLocation *p);
void smvm_print_variable(DisasmOutput *o, SmvmVariable is, const SmvmLocation *p);
void smvm_print_state(DisasmOutput *o, uint32_t s);
const char *smvm_type_name(uint32_t type);

// ---- code (disasm_code.c) ----

void smvm_print_function(DisasmOutput *o, uint32_t index);

#endif
