// SPDX-License-Identifier: Apache-2.0
// The layout of an image (docs/bytecode.md) as constants, and functions that read its bytes in place.  Internal to the VM and to the
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
    SMVM_FORMAT = 2,                  // the version of the image format as a whole
    SMVM_CRC_AT = 4, SMVM_LENGTH_AT = 8, SMVM_SECTIONS_AT = 11, SMVM_HEADER = 12,     // offsets in the header; bytes of the header
    SMVM_SECTION_ENTRY = 8,           // bytes of an entry of the section table: id u8, version u8, offset u24, length u24
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

// The opcodes of opcodes.def; for a row with a range of opcodes, the first opcode of the range.
typedef enum SmvmOp {
#define SMVM_OP(name, first, last, shape, meaning) SMVM_##name = first,
#include "bytecode-vm/opcodes.def"
#undef SMVM_OP
    SMVM_OP_FIRST = 0x80              // bytes below are never opcodes
} SmvmOp;

enum { SMVM_RAW = SM_TYPE_COUNT };    // as the type of a local: an F64 that is stored unchanged, NaN included

// Lists that apply the macro M to each of their items.  SMVM_EACH_TYPE: the types of values in memory, in the order of their numbers
// (SmType).  SMVM_EACH_KIND: also RAW.  SMVM_EACH_RELATION: every set of relations that an opcode can have (jxy, jxn).
#define SMVM_EACH_TYPE(M) M(I8) M(I16) M(I32) M(I64) M(U8) M(U16) M(U32) M(U64) M(F32) M(F64) M(BOOL)
#define SMVM_EACH_KIND(M) SMVM_EACH_TYPE(M) M(RAW)
#define SMVM_EACH_RELATION(M) M(1) M(2) M(3) M(4) M(5) M(6) M(7) M(8) M(9) M(10) M(11) M(12) M(13) M(14)
enum {
#define SM_TYPE(name, wire, spelling, ctype, bytes, kind) SMVM_KIND_##name = wire,
#include "stdlib/types.def"
#undef SM_TYPE
    SMVM_KIND_RAW = SMVM_RAW
};

// The elementary functions: SMVM_exp and so on is their opcode, SMVM_FN_exp and so on their number, its operand.  From SMVM_FN_OF_TWO on they
// also read Y.
enum {
#define SM_ELEMENTARY(name, arguments, number) SMVM_##name = SMVM_fn, SMVM_FN_##name = (number),
#include "stdlib/elementary.def"
#undef SM_ELEMENTARY
    SMVM_FN_OF_TWO = 16, SMVM_FN_MAX = 32
};

// Relations of X to the other operand.  The low bits of jxy and jxn, and the operand of set, are sums of these bits.
enum { SMVM_LESS = 1, SMVM_EQUAL = 2, SMVM_GREATER = 4, SMVM_UNORDERED = 8, SMVM_ANY_RELATION = 15 };

// The operands of an opcode, and its effect on the registers: see opcodes.def.
enum {
    SMVM_SHAPE_L = 1, SMVM_SHAPE_E = 2, SMVM_SHAPE_N = 4, SMVM_SHAPE_F = 8, SMVM_SHAPE_D = 0x10, SMVM_SHAPE_O = 0x20, SMVM_SHAPE_S = 0x40,
    SMVM_SHAPE_K = 0x80, SMVM_SHAPE_W = 0x100, SMVM_SHAPE_T = 0x200, SMVM_SHAPE_M = 0x400, SMVM_SHAPE_J = 0x800,
    SMVM_SHAPE_FOLLOWS = 0xfff,       // mask of the operands: for each set bit, one varint follows the opcode, in the order of the bits
    SMVM_SHAPE_X = 0x1000, SMVM_SHAPE_Y = 0x2000, SMVM_SHAPE_GX = 0x4000
};
#define SMVM_SHAPE_GY UINT32_C(0x8000)
#define SMVM_SHAPE_FY UINT32_C(0x10000)
#define SMVM_SHAPE_Z UINT32_C(0x20000)                // nonzero for every opcode, so that each has a shape

// The location of a local or element whose type the opcode does not imply, as three bytes in the image.  The offset, in units of the type's
// size, is in the low 16 bits and the highest 4; the type is in the 4 between.
enum { SMVM_LOCATION_BYTES = 3 };
#define SMVM_LOCATION_OFFSETS UINT32_C(0x100000)      // every offset in a location is below this

// A window in the image, four bytes: its size in the low 17 bits, above them its kind as defined in stdlib/roll.h.
enum { SMVM_WINDOW_ENTRY = 4, SMVM_WINDOW_SIZE_BITS = 17 };
#define SMVM_WINDOW_SIZE_MASK UINT32_C(0x1ffff)       // not `1u << 17`: an int may have 16 bits

// Varints: every number below SMVM_VARINT_END has exactly one encoding, of 1, 2 or 4 bytes, all of them below 0x80.  The first byte is
// below SMVM_VARINT_1 if it is the only one, and below SMVM_VARINT_2 if there are two.
enum { SMVM_VARINT_1 = 0x60, SMVM_VARINT_2 = 0x78 };
#define SMVM_VARINT_MID 0xc60u                        // the first number that needs four bytes
#define SMVM_VARINT_END (SMVM_VARINT_MID + 0x1000000u)

// DEBUG begins with SMVM_DEBUG_NUMBERS numbers of three bytes: how many variables there are, and the offsets of the lines, of the machine's
// name and of the source's name.  Next is the offset of each state's name (0: none).  Then each variable has SMVM_DEBUG_VARIABLE bytes:
// its SmvmVariable, its location and its name's offset.
enum { SMVM_DEBUG_NUMBERS = 4, SMVM_DEBUG_VARIABLE = 7 };
// The longest name of the samples of a window.  A longer name is not written, because a part of the name does not identify what is sampled.
enum { SMVM_SAMPLE_NAME_MAX = 2000 };

// ---- reading ----

static inline uint8_t smvm_u8(SmvmBytes image, SmvmAt at) { return (uint8_t)SMVM_FETCH(image, at); }

uint32_t smvm_uint(SmvmBytes image, SmvmAt at, uint8_t bytes);   // reads a little-endian number of at most 4 bytes

// Reads the bits of a number of `bytes` bytes into memory, in the byte order of this computer.
void smvm_read_bits(SmvmBytes image, SmvmAt at, void *to, uint8_t bytes);

static inline uint32_t smvm_u24(SmvmBytes image, SmvmAt at) { return smvm_uint(image, at, 3); }

// Returns the bits of the value of `bytes` bytes at this offset of the image.
static inline uint64_t smvm_cell(SmvmBytes image, SmvmAt at, uint8_t bytes)
{
    uint64_t v;

    if (bytes < 8)
        return smvm_uint(image, at, bytes);
    smvm_read_bits(image, at, &v, 8);
    return v;
}

// The size of a type is 1 << this, also for RAW.  Computed from the type's number, which an 8-bit computer does faster than a table lookup.
#define SMVM_TYPE_SHIFT(type) ((type) < SM_F32 ? (type) & 3 : (type) == SM_BOOL ? 0 : (type) == SM_F32 ? 2 : 3)
SMVM_INLINE uint8_t smvm_type_shift(uint32_t type) { return (uint8_t)SMVM_TYPE_SHIFT((uint8_t)type); }
uint8_t smvm_shift(uint8_t type);                     // smvm_type_shift as a call that is never inlined, for small code
#define SM_TYPE(name, wire, spelling, ctype, bytes, kind) typedef char smvm_shift_of_##name[1 << SMVM_TYPE_SHIFT(wire) == (bytes) ? 1 : -1];
#include "stdlib/types.def"
#undef SM_TYPE

// Reads an offset or size of up to three bytes.  A value that no image on this target can have becomes SMVM_NOWHERE, beyond every image.
#define SMVM_NOWHERE ((SmvmAt)-1)
SmvmAt smvm_read_offset(SmvmBytes image, SmvmAt at, uint8_t bytes);

// Returns the offset of the next `bytes` bytes and moves past them; 0: fewer are left.
SmvmAt smvm_skip(SmvmReader *r, uint8_t bytes);

// Reads a varint that must end before r->end into r->n.  If an SmvmAt cannot hold it, r->n is SMVM_NOWHERE.
typedef enum SmvmVarintStatus { SMVM_VARINT_OK, SMVM_VARINT_CUT_SHORT, SMVM_VARINT_TOO_LARGE } SmvmVarintStatus;
SmvmVarintStatus smvm_read_number(SmvmReader *r);

// Reads a varint of any size, even one that an SmvmAt cannot hold (a constant can be such a number), and moves *at past it.
// False if the varint does not end before `end`; then *value is unchanged.
static inline bool smvm_read_varint(SmvmBytes image, SmvmAt *at, SmvmAt end, uint32_t *value)
{
    const SmvmAt first = *at;
    SmvmReader r;
    SmvmVarintStatus found;

    r.image = image;
    r.at = first;
    r.end = end;
    found = smvm_read_number(&r);
    *at = r.at;
    if (found == SMVM_VARINT_OK)
        *value = r.n;
    else if (found == SMVM_VARINT_TOO_LARGE)          // a value that is too large has four bytes
        *value = SMVM_VARINT_MID + ((smvm_u8(image, first) & 7u) * UINT32_C(0x200000) + smvm_u8(image, first + 1) * UINT32_C(0x4000) +
                                    smvm_u8(image, first + 2) * UINT32_C(0x80) + smvm_u8(image, first + 3));
    return found != SMVM_VARINT_CUT_SHORT;
}

// The smvm_ram_size of a computer with 64-bit pointers, wherever this is compiled: for reports, which must not depend on the host.
enum { SMVM_VM_BYTES_64 = 96 };                       // the size of SmVm, tables included; the pointers to the windows follow
#define SMVM_VM_BYTES ((sizeof(SmVm) + 7) / 8 * 8)
typedef char smvm_own_64_is_right[sizeof(void *) != 8 || !SMVM_KEEP_TABLES || sizeof(SmvmAt) != 4 || SMVM_VM_BYTES == SMVM_VM_BYTES_64 ? 1 : -1];
static inline uint32_t smvm_ram_size_64(const SmvmMachine *m)
{
    const uint32_t pointers = (m->windows * (uint32_t)sizeof(uint64_t *) + 7) / 8 * 8;

    return smvm_ram_size(m) - (uint32_t)SMVM_VM_BYTES - pointers + SMVM_VM_BYTES_64 + 8u * m->windows;
}

// Flags for the order of sections.  Each kind of section sets a flag, and requires or forbids that earlier sections have set others.
enum { SMVM_HAS_MACHINE = 1, SMVM_HAS_CODE = 2, SMVM_HAS_INIT = 4, SMVM_HAS_SAFE = 8, SMVM_HAS_IO = 16, SMVM_HAS_PARAMETERS = 32 };

typedef struct SmvmSectionKind {
    uint8_t id, version;
    uint8_t requires, forbids, provides;  // sets of these flags: required before the section, forbidden before it, and set by it
    uint8_t part;             // offset in SmvmMachine of the two fields for the section's offset and size; 0: SmvmMachine has none for it
} SmvmSectionKind;

typedef struct SmvmSection {  // a section as its entry in the section table describes it; the verifier checks that separately
    uint8_t id;
    SmvmAt at, size;                 // offset in the image; number of bytes
    SmvmSectionKind kind;     // properties of the section by its id and version; all zero if these are unknown
} SmvmSection;

void smvm_read_section(SmvmBytes image, uint8_t index, SmvmSection *s);
uint8_t smvm_section_count(SmvmBytes image);          // how many sections the image has

// Finds the first section of this id, in its known version, and sets r to it.  Returns false if the image has no such section.
bool smvm_find_section(SmvmBytes image, uint8_t id, SmvmReader *r);

// Reads the properties of machine `number` into *m.  Returns 0, or the rule that its MACHINE section breaks; SMVM_R_GROUP: no such machine.
uint8_t smvm_read_machine(SmvmBytes image, uint8_t number, SmvmMachine *m);

// Reads the machine that runs at vm again, except for its INIT, DEBUG and SAFE sections.
void smvm_reread_machine(const SmVm *vm, SmvmMachine *m);

// Extracts the tables of m that a step needs, for the memory at vm.
void smvm_tables(const SmvmMachine *m, const SmVm *vm, SmvmTables *t);

// Where the parts of a machine's memory are.  The memory is one block after SmVm.
typedef struct SmvmParts {
    uint64_t **window;        // by window: the words of the window (stdlib/roll.h)
    uint8_t *local;                  // the locals
    uint8_t *stored;          // a bit for each output from the 64th on (counted from 0): whether the last step stored it
    uint32_t stored_bytes;
} SmvmParts;

// Returns the array of pointers to the windows, which directly follows SmVm in memory.
static inline uint64_t **smvm_windows_of(SmVm *vm) { return (uint64_t **)(void *)((uint8_t *)vm + (sizeof *vm + 7) / 8 * 8); }
SmvmParts smvm_parts(SmVm *vm, const SmvmMachine *m);

SmvmLocation smvm_location(SmvmBytes image, SmvmAt at);      // reads the location at `at`, whose type number is not checked

// An entry of PARAMETERS: a location, four numbers of its type, and two texts, each a varint n, n bytes and a 0.
enum { SMVM_PARAMETER_LOWEST, SMVM_PARAMETER_HIGHEST, SMVM_PARAMETER_DEFAULT, SMVM_PARAMETER_VALUE, SMVM_PARAMETER_NUMBERS };
typedef struct SmvmParameterEntry {
    SmvmLocation location;
    uint8_t bytes;            // size of the parameter's type
    SmvmAt numbers;           // offset in the image of its SMVM_PARAMETER_NUMBERS numbers
    SmvmAt name[2], size[2];  // offsets in the image and lengths of the parameter's name and unit
} SmvmParameterEntry;

SmvmReader smvm_parameters(const SmvmMachine *m);     // returns a reader of the section, at its first entry
bool smvm_read_parameter(SmvmReader *r, SmvmParameterEntry *p);    // reads the next entry; false at the end, or if the entry is not complete
static inline SmvmAt smvm_parameter_number(const SmvmParameterEntry *p, uint8_t which) { return (SmvmAt)(p->numbers + (unsigned)which * p->bytes); }

static inline uint32_t smvm_window(SmvmBytes image, SmvmAt windows_at, SmvmAt w)     // reads entry w of the table of windows
{
    return smvm_uint(image, (SmvmAt)(windows_at + w * SMVM_WINDOW_ENTRY), SMVM_WINDOW_ENTRY);
}

// These return the parts of an entry of the table of windows.  (The kind has 16 bits because the code is then shorter on an 8-bit computer.)
static inline uint32_t smvm_window_size(uint32_t entry) { return entry & SMVM_WINDOW_SIZE_MASK; }
static inline uint16_t smvm_window_kind(uint32_t entry) { return (uint16_t)((uint16_t)(entry >> 16) >> (SMVM_WINDOW_SIZE_BITS - 16)); }

// Returns the end of function `index`, as an offset in the code.  Function 0 is the sample function; 1 + 3 * (s - 1) + b is block b of state s.
// A function starts where the previous one ends.
static inline SmvmAt smvm_function_end(const SmvmMachine *m, SmvmAt index)
{
    return smvm_read_offset(m->image, (SmvmAt)(m->functions_at + index * m->width), (uint8_t)m->width);
}

// The packed shape of an opcode: its shape in 16 bits.  The low four bits are one of the constants below, for the operands; the others are
// the bits of the shape from SMVM_SHAPE_X on.  0: the opcode does not exist.
enum {
    SMVM_OPERAND_NONE, SMVM_OPERAND_L, SMVM_OPERAND_E, SMVM_OPERAND_N, SMVM_OPERAND_F, SMVM_OPERAND_D, SMVM_OPERAND_O, SMVM_OPERAND_S,
    SMVM_OPERAND_K, SMVM_OPERAND_W, SMVM_OPERAND_T, SMVM_OPERAND_M, SMVM_OPERAND_J, SMVM_OPERANDS_K_W, SMVM_OPERANDS_N_J
};
uint16_t smvm_packed_shape(uint8_t opcode);
uint32_t smvm_shape(uint8_t opcode);                  // returns the SMVM_SHAPE_ bits; 0: no such opcode

// Returns 0, or the rule that the IO section breaks, and sets *at to the offset of the error (pins.c).
uint8_t smvm_check_pins(SmvmBytes image, SmvmAt *at);

// Returns the value of elementary function n of x, or of x and y (function.c).
SmF64 smvm_call(uint8_t n, SmF64 x, SmF64 y);

// Add x as a sample to window w of n slots, and read a statistic of w (stdlib/roll.h).  For a window of times, x is its event, at the time of the
// step that vm runs.  All interpreters call these (interp.c): the code of roll.h is long, so only one copy is compiled.
void smvm_sample(const SmVm *vm, uint64_t *w, uint32_t n, uint32_t kind, SmF64 x);
SmF64 smvm_statistic(const uint64_t *w, uint32_t n, uint32_t kind, SmStat stat);

// Read and write one value of a type in memory, for code outside the interpreter: sm_load and sm_store without a second copy of their
// code (interp.c).
SmF64 smvm_load(uint8_t type, const void *at);
void smvm_store(SmF64 x, uint8_t type, void *at);

// ---- names, source lines and marks, for hosts (debug.c); DEBUG, SWAP and ABORT are not verified, so these check what they read ----

// Whether a state is marked in section `id` of the machine: SMVM_S_SWAP or SMVM_S_ABORT.
bool smvm_is_marked(const SmvmMachine *m, uint8_t id, uint32_t state);

typedef struct SmvmName { SmvmAt at; uint32_t size; } SmvmName;  // where a name is in the image; size 0: no name

enum { SMVM_NAME_MACHINE = 2, SMVM_NAME_SOURCE = 3 };
SmvmName smvm_name(const SmvmMachine *m, uint32_t which);        // returns the name of the machine or of its source; `which` is one of these
SmvmName smvm_state_name(const SmvmMachine *m, uint32_t state);

uint32_t smvm_variables(const SmvmMachine *m);                   // number of variables with names; they are sorted by SmvmVariable, type, offset
// SMVM_IS_SAMPLE: what a window samples.  Its location has type 0, and the number of the window as its offset.
typedef enum SmvmVariable { SMVM_IS_LOCAL, SMVM_IS_ELEMENT, SMVM_IS_TIME, SMVM_IS_SAMPLE } SmvmVariable;
SmvmName smvm_variable(const SmvmMachine *m, uint32_t index, SmvmVariable *is, SmvmLocation *location);
SmvmName smvm_name_of(const SmvmMachine *m, SmvmVariable is, const SmvmLocation *location);  // `location` is ignored for T

// Iterates over the source lines in code order.  All fields are zero at the start.  smvm_next_line returns false at the end.
typedef struct SmvmLines { bool open; SmvmAt at; uint32_t left, code, line; } SmvmLines;
bool smvm_next_line(const SmvmMachine *m, SmvmLines *l);         // l->line applies from l->code (an offset in CODE) on

#endif
