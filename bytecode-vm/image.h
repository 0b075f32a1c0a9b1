// SPDX-License-Identifier: Apache-2.0
// The layout of an image (docs/bytecode.md) as names, and how its bytes are read in place.  Internal to the VM and to the
// compiler's image writer.
#ifndef SMVM_IMAGE_H
#define SMVM_IMAGE_H

#include <stdbool.h>
#include <stdint.h>

#include "bytecode-vm/config.h"
#include "bytecode-vm/smvm.h"
#include "stdlib/types.h"

enum {
    SMVM_FORMAT = 1,                  // the version of the whole
    SMVM_CRC_AT = 4, SMVM_LENGTH_AT = 8, SMVM_SECTIONS_AT = 11, SMVM_HEADER = 12,
    SMVM_ENTRY = 8,                   // of the section table: id u8, version u8, offset u24, length u24
    SMVM_MUST_KNOW = 0x80             // a section whose id has this bit cannot be skipped
};

enum {
#define SMVM_SECTION(name, id, version, meaning) SMVM_S_##name = id, SMVM_V_##name = version,
#define SMVM_OPERAND(name, number, meaning)
#include "bytecode-vm/image.def"
#undef SMVM_SECTION
#undef SMVM_OPERAND
    SMVM_S_NONE = 0
};

// Kinds of operands.  An entry of the operand table is three bytes: kind in the low 5 bits, payload in the other 19.
enum {
#define SMVM_SECTION(name, id, version, meaning)
#define SMVM_OPERAND(name, number, meaning) SMVM_K_##name = number,
#include "bytecode-vm/image.def"
#undef SMVM_SECTION
#undef SMVM_OPERAND
    SMVM_KINDS,                       // one more than the last
    SMVM_KIND_BITS = 5
};
#define SMVM_PAYLOADS INT32_C(0x80000)                // as many payloads there are
#define SMVM_RAW SM_TYPE_COUNT                        // beside the types: an F64 as it is, NaN included
#define SMVM_INT_LEAST (-INT32_C(0x40000))
#define SMVM_INT_MOST INT32_C(0x3ffff)

enum {
#define SMVM_RULE(number, name, sentence) SMVM_R_##name = number,
#include "bytecode-vm/rules.def"
#undef SMVM_RULE
    SMVM_R_OK = 0
};

typedef enum SmvmOp {
#define SMVM_OP(name, number, shape, meaning) SMVM_##name = number,
#include "bytecode-vm/opcodes.def"
#undef SMVM_OP
    SMVM_OP_LEAST = 0x80              // what is below is no opcode
} SmvmOp;

// What follows an opcode: see opcodes.def.
enum {
    SMVM_SHAPE_D = 1, SMVM_SHAPE_W = 2, SMVM_SHAPE_X = 4, SMVM_SHAPE_Y = 8, SMVM_SHAPE_S = 16, SMVM_SHAPE_J = 32, SMVM_SHAPE_E = 64
};

// A window in the image, four bytes: its size in the low 17 bits, above them its kind as stdlib/roll.h has it.
enum { SMVM_WINDOW_ENTRY = 4, SMVM_WINDOW_SIZE_BITS = 17 };
#define SMVM_WINDOW_SIZE_MASK UINT32_C(0x1ffff)       // no `1u << 17`, for an int may have 16 bits

// Varints: every number below SMVM_VARINT_END has exactly one form, of 1, 2 or 4 bytes, all of them below 0x80.
enum { SMVM_VARINT_1 = 0x60, SMVM_VARINT_2 = 0x78 };
#define SMVM_VARINT_MID 0xc60u                        // the first number that takes four bytes
#define SMVM_VARINT_END (SMVM_VARINT_MID + 0x1000000u)

// DEBUG begins with as many numbers of three bytes: variables, start of the lines, name of the machine, name of the source.
// Then come offsets of names, by state and by operand (0: none), then for each variable its entry and its name's offset.
enum { SMVM_DEBUG_NUMBERS = 4 };

// ---- reading ----

static inline uint8_t smvm_u8(SmvmBytes image, uint32_t at) { return (uint8_t)SMVM_FETCH(image, at); }

static inline uint32_t smvm_uint(SmvmBytes image, uint32_t at, uint8_t bytes)         // little-endian, at most 4 bytes
{
    uint32_t v = 0;
    while (bytes-- > 0)
        v = v << 8 | smvm_u8(image, at + bytes);
    return v;
}

static inline uint32_t smvm_u24(SmvmBytes image, uint32_t at)
{
    return smvm_u8(image, at) | (uint32_t)smvm_u8(image, at + 1) << 8 | (uint32_t)smvm_u8(image, at + 2) << 16;
}

// The bits of a value of so many bytes.
static inline uint64_t smvm_cell(SmvmBytes image, uint32_t at, uint8_t bytes)
{
    return bytes < 8 ? smvm_uint(image, at, bytes) : (uint64_t)smvm_uint(image, at + 4, 4) << 32 | smvm_uint(image, at, 4);
}

// The size of a type is 1 << this.  By the numbers that types have, which an 8-bit computer finds sooner than anything in a table.
#define SMVM_TYPE_SHIFT(type) ((type) < SM_F32 ? (type) & 3 : (type) == SM_BOOL ? 0 : (type) - SM_F32 + 2)
static inline uint8_t smvm_type_shift(uint32_t type) { return (uint8_t)SMVM_TYPE_SHIFT((uint8_t)type); }
#define SM_TYPE(name, wire, spelling, ctype, bytes, kind) typedef char smvm_shift_of_##name[1 << SMVM_TYPE_SHIFT(wire) == (bytes) ? 1 : -1];
#include "stdlib/types.def"
#undef SM_TYPE

// Reads a varint that must end before `end`; moves *at behind it.  False if it does not.
bool smvm_varint(SmvmBytes image, uint32_t *at, uint32_t end, uint32_t *value);

typedef struct SmvmSection { uint8_t id, version; uint32_t at, size; } SmvmSection;

SmvmSection smvm_section(SmvmBytes image, uint32_t index);
uint8_t smvm_sections(SmvmBytes image);               // how many

// Reads what a MACHINE section says into *m and finds its tables.  Gives 0, or the rule that is broken.  Checks only what it
// reads; m->image is set already.
uint8_t smvm_read_machine(SmvmMachine *m, uint32_t at, uint32_t size);

// The same of a machine that runs: all but INIT and DEBUG.
void smvm_again(const SmVm *vm, SmvmMachine *m);

// What a step needs of it, for the memory and the state vector that it was put in.
void smvm_tables(const SmvmMachine *m, const SmVm *vm, SmvmTables *t);

// Where the parts of a machine's memory are; it lies in one piece behind SmVm.
typedef struct SmvmParts {
    uint64_t **window;        // each window's words
    SmF64 *temp;
    uint8_t *local;
    uint8_t *stored;          // bits of the outputs from 64 on
    uint32_t stored_bytes;
} SmvmParts;

// The windows stand first behind it.
static inline uint64_t **smvm_windows_of(SmVm *vm) { return (uint64_t **)(void *)((uint8_t *)vm + (sizeof *vm + 7) / 8 * 8); }
SmvmParts smvm_parts(SmVm *vm, const SmvmMachine *m);

SmvmOperand smvm_operand_at(SmvmBytes image, uint32_t at);     // an entry of the operand table, or one of the same form

static inline uint32_t smvm_window(SmvmBytes image, uint32_t windows_at, uint32_t w)       // an entry of the windows' table
{
    return smvm_uint(image, windows_at + w * SMVM_WINDOW_ENTRY, SMVM_WINDOW_ENTRY);
}

// Start of function `index` in the code, from its start: 0 is the sample function, 1 + 3 * (s - 1) + b block b of state s.
// A function ends where the next one starts.
static inline uint32_t smvm_function_end(const SmvmMachine *m, uint32_t index)
{
    return smvm_uint(m->image, m->functions_at + index * m->width, m->width);
}

uint8_t smvm_shape(uint8_t opcode);                   // 0 if it is none

// Gives 0, or the rule that the IO section breaks, and where (pins.c).
uint8_t smvm_check_pins(SmvmBytes image, uint32_t *at);

// Windows, for all that runs code (interp.c): stdlib/roll.h made for each type is long.
void smvm_sample(uint64_t *w, uint32_t n, uint32_t kind, SmF64 x);
SmF64 smvm_statistic(const uint64_t *w, uint32_t n, uint32_t kind, SmStat stat);

// ---- names, for hosts; DEBUG is not verified, so these check what they read (debug.c) ----

typedef struct SmvmName { uint32_t at, size; } SmvmName;         // in the image; size 0: none

enum { SMVM_NAME_MACHINE = 2, SMVM_NAME_SOURCE = 3 };
SmvmName smvm_name(const SmvmMachine *m, uint32_t which);        // one of the two
SmvmName smvm_state_name(const SmvmMachine *m, uint32_t state);
SmvmName smvm_operand_name(const SmvmMachine *m, uint32_t operand);

uint32_t smvm_variables(const SmvmMachine *m);                   // elements, locals and T that have names
SmvmName smvm_variable(const SmvmMachine *m, uint32_t index, SmvmOperand *o);

// Goes through the lines in code order: starts zeroed; false at the end.
typedef struct SmvmLines { bool open; uint32_t at, left, code, line; } SmvmLines;
bool smvm_next_line(const SmvmMachine *m, SmvmLines *l);         // l->line holds from l->code (an offset in CODE) on

#endif
