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

#define SMVM_MAGIC (0x6d73u | UINT32_C(0x620000))      // 's' 'm' 'b', as a number
enum {
    SMVM_FORMAT = 2,                  // the version of the whole
    SMVM_CRC_AT = 4, SMVM_LENGTH_AT = 8, SMVM_SECTIONS_AT = 11, SMVM_HEADER = 12,
    SMVM_ENTRY = 8,                   // of the section table: id u8, version u8, offset u24, length u24
    SMVM_MUST_KNOW = 0x80             // a section whose id has this bit cannot be skipped
};

enum {
#define SMVM_SECTION(name, id, version, meaning) SMVM_S_##name = id, SMVM_V_##name = version,
#include "bytecode-vm/image.def"
#undef SMVM_SECTION
    SMVM_S_NONE = 0
};

enum {
#define SMVM_RULE(number, name, sentence) SMVM_R_##name = number,
#include "bytecode-vm/rules.def"
#undef SMVM_RULE
    SMVM_R_OK = 0
};

// Opcodes; of those that come in several, the first.
typedef enum SmvmOp {
#define SMVM_OP(name, first, last, shape, meaning) SMVM_##name = first,
#include "bytecode-vm/opcodes.def"
#undef SMVM_OP
    SMVM_OP_LEAST = 0x80              // what is below is no opcode
} SmvmOp;

enum { SMVM_RAW = SM_TYPE_COUNT };    // as the type of a local: an F64 as it is, NaN included

// Relations of X to the other number; a sum of them is one in the low bits of jxy and jxn, or what follows set.
enum { SMVM_LESS = 1, SMVM_EQUAL = 2, SMVM_GREATER = 4, SMVM_UNORDERED = 8 };

// What follows an opcode, and what it does with the registers: see opcodes.def.
enum {
    SMVM_SHAPE_L = 1, SMVM_SHAPE_E = 2, SMVM_SHAPE_N = 4, SMVM_SHAPE_F = 8, SMVM_SHAPE_D = 0x10, SMVM_SHAPE_O = 0x20, SMVM_SHAPE_S = 0x40,
    SMVM_SHAPE_K = 0x80, SMVM_SHAPE_W = 0x100, SMVM_SHAPE_T = 0x200, SMVM_SHAPE_M = 0x400, SMVM_SHAPE_J = 0x800,
    SMVM_SHAPE_FOLLOWS = 0xfff,       // of these, as many varints follow as there are bits, in the order of the bits
    SMVM_SHAPE_X = 0x1000, SMVM_SHAPE_Y = 0x2000, SMVM_SHAPE_GX = 0x4000
};
#define SMVM_SHAPE_GY UINT32_C(0x8000)
#define SMVM_SHAPE_FY UINT32_C(0x10000)
#define SMVM_SHAPE_Z UINT32_C(0x20000)                // every opcode that exists has one of these

// A place in the image, three bytes, of a local or element whose type is not said by an opcode: offset in units of the type's
// size in the low 16 bits and the topmost 4, type in the 4 between.
enum { SMVM_PLACE = 3 };
#define SMVM_PLACES UINT32_C(0x100000)                // as many offsets there are

// A window in the image, four bytes: its size in the low 17 bits, above them its kind as stdlib/roll.h has it.
enum { SMVM_WINDOW_ENTRY = 4, SMVM_WINDOW_SIZE_BITS = 17 };
#define SMVM_WINDOW_SIZE_MASK UINT32_C(0x1ffff)       // no `1u << 17`, for an int may have 16 bits

// Varints: every number below SMVM_VARINT_END has exactly one form, of 1, 2 or 4 bytes, all of them below 0x80.
enum { SMVM_VARINT_1 = 0x60, SMVM_VARINT_2 = 0x78 };
#define SMVM_VARINT_MID 0xc60u                        // the first number that takes four bytes
#define SMVM_VARINT_END (SMVM_VARINT_MID + 0x1000000u)

// DEBUG begins with as many numbers of three bytes: variables, start of the lines, name of the machine, name of the source.
// Then come offsets of names, by state (0: none), then for each variable what it is, its place and its name's offset.
enum { SMVM_DEBUG_NUMBERS = 4, SMVM_DEBUG_VARIABLE = 7 };

// ---- reading ----

static inline uint8_t smvm_u8(SmvmBytes image, SmvmAt at) { return (uint8_t)SMVM_FETCH(image, at); }

uint32_t smvm_uint(SmvmBytes image, SmvmAt at, uint8_t bytes);   // little-endian, at most 4 bytes

// The bits of a number of so many bytes, in memory as this computer has them.
void smvm_get(SmvmBytes image, SmvmAt at, void *to, uint8_t bytes);

static inline uint32_t smvm_u24(SmvmBytes image, SmvmAt at) { return smvm_uint(image, at, 3); }

// The bits of a value of so many bytes.
static inline uint64_t smvm_cell(SmvmBytes image, SmvmAt at, uint8_t bytes)
{
    uint64_t v;

    if (bytes < 8)
        return smvm_uint(image, at, bytes);
    smvm_get(image, at, &v, 8);
    return v;
}

// The size of a type is 1 << this, RAW's too.  By the numbers that types have, which an 8-bit computer finds sooner than anything in a table.
#define SMVM_TYPE_SHIFT(type) ((type) < SM_F32 ? (type) & 3 : (type) == SM_BOOL ? 0 : (type) == SM_F32 ? 2 : 3)
SMVM_INLINE uint8_t smvm_type_shift(uint32_t type) { return (uint8_t)SMVM_TYPE_SHIFT((uint8_t)type); }
uint8_t smvm_shift(uint8_t type);                     // the same, for what is to be small
#define SM_TYPE(name, wire, spelling, ctype, bytes, kind) typedef char smvm_shift_of_##name[1 << SMVM_TYPE_SHIFT(wire) == (bytes) ? 1 : -1];
#include "stdlib/types.def"
#undef SM_TYPE

// A place or size of up to three bytes.  What no image here can have is SMVM_NOWHERE, which is beyond the end of every one.
#define SMVM_NOWHERE ((SmvmAt)-1)
SmvmAt smvm_at(SmvmBytes image, SmvmAt at, uint8_t bytes);

// Where the next so many bytes are, and goes behind them; 0: there are not so many.
SmvmAt smvm_take(SmvmReader *r, uint8_t bytes);

// Reads a varint that must end before r->end, into r->n: SMVM_NOWHERE where it is too large for that.
typedef enum SmvmFound { SMVM_THERE, SMVM_CUT_SHORT, SMVM_TOO_LARGE } SmvmFound;
SmvmFound smvm_number(SmvmReader *r);

// Reads a varint of any size, even one that an SmvmAt cannot hold (a constant can be such a number), and moves *at past it.
// False if the varint does not end before `end`; then *value is unchanged.
static inline bool smvm_varint(SmvmBytes image, SmvmAt *at, SmvmAt end, uint32_t *value)
{
    const SmvmAt first = *at;
    SmvmReader r;
    SmvmFound found;

    r.image = image;
    r.at = first;
    r.end = end;
    found = smvm_number(&r);
    *at = r.at;
    if (found == SMVM_THERE)
        *value = r.n;
    else if (found == SMVM_TOO_LARGE)                 // it has four bytes
        *value = SMVM_VARINT_MID + ((smvm_u8(image, first) & 7u) * UINT32_C(0x200000) + smvm_u8(image, first + 1) * UINT32_C(0x4000) +
                                    smvm_u8(image, first + 2) * UINT32_C(0x80) + smvm_u8(image, first + 3));
    return found != SMVM_CUT_SHORT;
}

// What smvm_ram_size is on a computer with pointers of 64 bits, wherever this is compiled: for reports, which are the same everywhere.
enum { SMVM_OWN_64 = 56 };                            // up to the pointers to the windows
#define SMVM_OWN ((sizeof(SmVm) + 7) / 8 * 8)
typedef char smvm_own_64_is_right[sizeof(void *) != 8 || SMVM_KEEP_TABLES || sizeof(SmvmAt) != 4 || SMVM_OWN == SMVM_OWN_64 ? 1 : -1];
static inline uint32_t smvm_ram_size_64(const SmvmMachine *m)
{
    const uint32_t pointers = (m->windows * (uint32_t)sizeof(uint64_t *) + 7) / 8 * 8;

    return smvm_ram_size(m) - (uint32_t)SMVM_OWN - pointers + SMVM_OWN_64 + 8u * m->windows;
}

// What the sections of a machine, and IO, ask for before them and bar.
enum { SMVM_A_MACHINE = 1, SMVM_A_CODE = 2, SMVM_AN_INIT = 4, SMVM_A_SAFE = 8, SMVM_AN_IO = 16 };

typedef struct SmvmKind {
    uint8_t id, version;
    uint8_t asks, bars, gives;        // of what stood before it
    uint8_t part;             // where in SmvmMachine its place and size are noted; 0: nowhere
} SmvmKind;

typedef struct SmvmSection {  // as the image says: not checked
    uint8_t id;
    SmvmAt at, size;
    SmvmKind kind;            // all zero where id and version are not known
} SmvmSection;

void smvm_section(SmvmBytes image, uint8_t index, SmvmSection *s);
uint8_t smvm_sections(SmvmBytes image);               // how many

// The first section of an id and the version that is known of it, from its beginning to its end.  False: there is none.
bool smvm_find(SmvmBytes image, uint8_t id, SmvmReader *r);

// Reads machine `number` and gives 0, or the rule that its MACHINE section breaks; SMVM_R_GROUP: there is no such machine.
uint8_t smvm_look(SmvmBytes image, uint8_t number, SmvmMachine *m);

// The same of a machine that runs: all but INIT and DEBUG.
void smvm_again(const SmVm *vm, SmvmMachine *m);

// What a step needs of it, for the memory and the state vector that it was put in.
void smvm_tables(const SmvmMachine *m, const SmVm *vm, SmvmTables *t);

// Where the parts of a machine's memory are; it lies in one piece behind SmVm.
typedef struct SmvmParts {
    uint64_t **window;        // each window's words
    uint8_t *local;
    uint8_t *stored;          // bits of the outputs from 64 on
    uint32_t stored_bytes;
} SmvmParts;

// The windows stand first behind it.
static inline uint64_t **smvm_windows_of(SmVm *vm) { return (uint64_t **)(void *)((uint8_t *)vm + (sizeof *vm + 7) / 8 * 8); }
SmvmParts smvm_parts(SmVm *vm, const SmvmMachine *m);

SmvmPlace smvm_place(SmvmBytes image, SmvmAt at);            // its type may be none that exists

static inline uint32_t smvm_window(SmvmBytes image, SmvmAt windows_at, SmvmAt w)     // an entry of the windows' table
{
    return smvm_uint(image, (SmvmAt)(windows_at + w * SMVM_WINDOW_ENTRY), SMVM_WINDOW_ENTRY);
}

// What it says.  (Of 16 bits: that is shorter on an 8-bit computer.)
static inline uint32_t smvm_window_size(uint32_t entry) { return entry & SMVM_WINDOW_SIZE_MASK; }
static inline uint16_t smvm_window_kind(uint32_t entry) { return (uint16_t)((uint16_t)(entry >> 16) >> (SMVM_WINDOW_SIZE_BITS - 16)); }

// Start of function `index` in the code, from its start: 0 is the sample function, 1 + 3 * (s - 1) + b block b of state s.
// A function ends where the next one starts.
static inline SmvmAt smvm_function_end(const SmvmMachine *m, SmvmAt index)
{
    return smvm_at(m->image, (SmvmAt)(m->functions_at + index * m->width), (uint8_t)m->width);
}

// The shape of an opcode in fewer bits: what follows it in the low four, above them those from SMVM_SHAPE_X on.  0: it is none.
enum {
    SMVM_NOTHING, SMVM_AN_L, SMVM_AN_E, SMVM_AN_N, SMVM_AN_F, SMVM_A_D, SMVM_AN_O, SMVM_AN_S, SMVM_A_K, SMVM_A_W, SMVM_A_T, SMVM_AN_M, SMVM_A_J,
    SMVM_K_AND_W, SMVM_N_AND_J
};
uint16_t smvm_form(uint8_t opcode);
uint32_t smvm_shape(uint8_t opcode);                  // 0 if it is none

// Gives 0, or the rule that the IO section breaks, and where (pins.c).
uint8_t smvm_check_pins(SmvmBytes image, SmvmAt *at);

// Windows, for all that runs code (interp.c): stdlib/roll.h made for each type is long.
void smvm_sample(uint64_t *w, uint32_t n, uint32_t kind, SmF64 x);
SmF64 smvm_statistic(const uint64_t *w, uint32_t n, uint32_t kind, SmStat stat);

// Elements, as the interpreter reads and writes them: sm_load and sm_store without a second text of them (interp.c).
SmF64 smvm_load(uint8_t type, const void *at);
void smvm_store(SmF64 x, uint8_t type, void *at);

// ---- names, for hosts; DEBUG is not verified, so these check what they read (debug.c) ----

typedef struct SmvmName { SmvmAt at; uint32_t size; } SmvmName;  // in the image; size 0: none

enum { SMVM_NAME_MACHINE = 2, SMVM_NAME_SOURCE = 3 };
SmvmName smvm_name(const SmvmMachine *m, uint32_t which);        // one of the two
SmvmName smvm_state_name(const SmvmMachine *m, uint32_t state);

uint32_t smvm_variables(const SmvmMachine *m);                   // elements, locals and T that have names; by what they are, type and place
typedef enum SmvmVariable { SMVM_IS_LOCAL, SMVM_IS_ELEMENT, SMVM_IS_TIME } SmvmVariable;
SmvmName smvm_variable(const SmvmMachine *m, uint32_t index, SmvmVariable *is, SmvmPlace *place);
SmvmName smvm_name_of(const SmvmMachine *m, SmvmVariable is, const SmvmPlace *place);        // of T `place` is not asked

// Goes through the lines in code order: starts zeroed; false at the end.
typedef struct SmvmLines { bool open; SmvmAt at; uint32_t left, code, line; } SmvmLines;
bool smvm_next_line(const SmvmMachine *m, SmvmLines *l);         // l->line holds from l->code (an offset in CODE) on

#endif
