// SPDX-License-Identifier: Apache-2.0
// Shared by the files of the C emitter: the unit of C that is being written, and its parts.
//
// Terms: an element is a member of the state vector's struct, `sv->name`; a local is a member of the machine's struct, `m->name`.
#ifndef SMC_EMIT_C_UNIT_H
#define SMC_EMIT_C_UNIT_H

#include "compiler/base/buf.h"
#include "compiler/facts/facts.h"
#include "compiler/ir/ir.h"

// ---- names.c ----

typedef struct CNames {
    const char *prefix;           // tank: for functions
    const char *type;             // Tank: for types
    const char *macro;            // TANK: for constants
    const char *sv_type;          // TankSv
    const char *sv_macro;         // TANK_SV
    const char **var;             // by IrMachine.var: the member
    const char **state;           // by state
    Map element;                  // name to member (const char *): all elements of the state vector
} CNames;

// An element of the state vector, whether or not the machine lists it.
typedef struct CElement {
    const char *member;
    SmType type;
    uint32_t offset;
    Str name;                     // as in the source
    Str region;                   // NULL when unknown
    Span span;
} CElement;

typedef struct CVector {
    CElement *at;
    size_t n;
    uint32_t size, hash;
    const char *name;             // name of the .sv file or the machine
    bool shared;                  // several machines can use it: there is a .sv
} CVector;

// Names for the runtime's view of a vector: functions for its elements, enumerators for elements and regions.
typedef struct CVectorNames {
    const char **getter, **setter;    // by element: rocket_altitude, rocket_set_altitude
    const char **element;             // by element: ROCKET_E_altitude
    const char **region;              // by region: ROCKET_R_Sensors
    const char **reader, **writer;    // by region: rocket_read_Sensors, rocket_write_Sensors
} CVectorNames;

typedef struct CUnit {
    Arena *arena;
    const IrMachine *m;
    CNames names;
    CVector sv;
    uint32_t *helper;             // by stdlib_text: number of uses of this snippet of stdlib
    const char **window;          // by window: its member
    struct CVarUse *var_use;      // by variable: how the current function uses it
    uint32_t *window_asked;       // by window: a bit for each statistic that the code reads
    uint32_t *window_sample;      // by window: where the current block samples it
    uint32_t stamps;              // number of functions and blocks so far
    FactMachine *facts;    // possible values
    bool soft;                    // F64 is SmF64 (soft.c)
    bool track_stores;            // each step reports which elements it stored
    bool runtime;                 // for runtime-c
    const char *fit;              // the name of the self-test; NULL: nothing to test
    StrPool constant_names;       // locals that are constants, for remarks
    Map constants;
} CUnit;

// ---- emit_c.c ----

// Initialises a unit for m.  `prefix` is an identifier.  `sv_prefix` names the vector's struct; NULL: the name of the .sv file if there is
// one, else the prefix.
void unit_init(CUnit *u, Arena *a, const IrMachine *m, const char *prefix, const char *sv_prefix);

void unit_soften(CUnit *u, bool soft);

// ---- names.c, continued ----

// Whether a name is, or begins like, those reserved for the runtime and the VM: sm_, smvm_, pal_.
bool c_is_ours(const char *name);
// Turns any text into a C identifier: `my-tank.v2` becomes my_tank_v2, `sm` becomes m_sm.
const char *c_identifier(Arena *arena, const char *text, size_t len);
// MyTankV2 and MY_TANK_V2 for my_tank_v2.
const char *c_type_name(Arena *arena, const char *prefix);
const char *c_macro_name(Arena *arena, const char *prefix);
// Whether a member or variable of that name would not compile as C99 or C++11 with the usual headers.
bool c_is_reserved(const char *name);
void names_init(CUnit *u, const char *prefix);
const char *c_padding_name(Arena *arena, uint32_t at);
// Names the members of the vector's elements; sv_type must be set.
void names_elements(Arena *arena, CNames *names, CVector *sv);
void names_runtime(Arena *arena, const CNames *names, const StateVec *sv, CVectorNames *out);

// The names of a vector alone, including sv_type and the members.  Initialises `u`.
void c_vector_names(Arena *arena, const StateVec *sv, CUnit *u);
// The name of the struct of a machine whose names begin with `prefix`.
const char *c_machine_type(Arena *arena, const char *prefix, const char *sv_type);

// ---- literal.c ----

// Writes a constant as a C literal of its type; `bits` is its cell.  Infinities and NaN use a helper.
void literal_write(CUnit *u, Buf *out, SmType type, uint64_t bits);
// Writes a finite number in its usual decimal form.
void literal_write_finite(Buf *out, double x);

// ---- helpers.c ----

// Counts a use of a stdlib function and returns its name.
const char *helper_use(CUnit *u, const char *name);
// Writes the snippets in use and those that they need, except types, which are in the header.
void helpers_write(CUnit *u, Buf *out);
void helper_write_type(CUnit *u, const char *name, Buf *out);
size_t helper_count(void);

// ---- native.c ----

// Writes a snippet of stdlib with C's own operators instead of its functions on F64; unchanged if numbers are soft.
void native_write(CUnit *u, const char *text, Buf *out);

// ---- remark.c ----

// The comment at the end of the line of `s`, "" if there is none that can appear in C.
const char *remark_at(Arena *a, Span s);
// The name of the constant local at `s`, "" if `s` is something else.
const char *remark_constant(CUnit *u, Span s);
// By window: the source text of the first call that reads it; NULL where unknown.
const char **remark_windows(CUnit *u);

// ---- decl.c ----

void c_write_vector_struct(const CUnit *u, Buf *out);
void c_write_machine_types(CUnit *u, Buf *out);
void c_write_prototypes(const CUnit *u, Buf *out);
const char *c_type_of(const CUnit *u, SmType type);       // of a member
bool c_is_output(const IrMachine *m, size_t v);      // whether the machine can store it: S, or an element that it may assign

// ---- guard.c ----

// Writes the includes, and the checks that stop a compiler that would change the meaning.
void c_write_guards(Buf *out, const char *what, bool soft);
// Writes the function `name`, which tests the arithmetic at run time.
void c_write_self_test(const char *name, Buf *out);

// ---- soft.c ----

// Writes header and code of the soft numbers, for a single translation unit.
void c_write_soft_library(Buf *out);

// ---- window.c ----

// A window's member: its name and its size in words.
const char *c_window_declaration(const CUnit *u, size_t w);
void c_write_empty_windows(const CUnit *u, Buf *out);
// Writes a function for each statistic that the code reads.
void c_write_statistics(CUnit *u, Buf *out);
uint32_t c_small_roll_words(uint32_t n, uint32_t kind);      // sm_roll_words with SM_ROLL_SMALL, for least memory

// ---- vector.c ----

// Write what follows the struct in the header, and the code.
void c_write_vector_interface(const CUnit *u, const StateVec *sv, const CVectorNames *n, Buf *out);
void c_write_vector_tables(const CUnit *u, const StateVec *sv, const CVectorNames *n, Buf *out);

// ---- code.c ----

// The parameters and result of a block's function.
typedef struct CSignature {
    bool returns_state;           // it can make a transition: returns the state's number, or 0
    bool m, sv;                   // which of the two it needs as parameters
} CSignature;

typedef struct CFunction {
    const IrFn *f;
    const Env *begin;      // facts at its start
    const char *name;
    const char *comment;          // precedes it
} CFunction;

// Writes it as a static C function.
CSignature c_write_function(CUnit *u, const CFunction *what, Buf *out);

// ---- machine.c ----

// The type that holds a state's number or 0: the shortest possible if numbers are soft.
const char *c_state_type(const CUnit *u);
void c_write_machine(CUnit *u, Buf *out);      // the functions of all blocks, then init, step, state and state_name

// ---- machine_type.c ----

void c_write_machine_type(const CUnit *u, Buf *out);
void c_write_machine_type_prototype(const CUnit *u, Buf *out);

#endif
