// SPDX-License-Identifier: Apache-2.0
// What the files of the C emitter share: the unit of C that is being written, and its chapters.
//
// Words used throughout: an element is a member of the state vector's struct, `sv->name`; a local is a member of the
// machine's struct, `m->name`.
#ifndef SMC_EMIT_C_UNIT_H
#define SMC_EMIT_C_UNIT_H

#include "compiler/base/buf.h"
#include "compiler/facts/facts.h"
#include "compiler/ir/ir.h"

// ---- names.c ----

typedef struct CNames {
    const char *prefix;           // tank: of functions
    const char *type;             // Tank: of types
    const char *macro;            // TANK: of constants
    const char *sv_type;          // TankSv
    const char *sv_macro;         // TANK_SV
    const char **var;             // by IrMachine.var: the member
    const char **state;           // by state
    Map element;                  // name to member (const char *): all elements of the state vector
} CNames;

// An element of the state vector, whether the machine lists it or not.
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
    const char *name;             // of the .sv file or the machine
    bool shared;                  // more than one machine may use it: there is a .sv
} CVector;

// The names of the runtime's view of a vector: functions for its elements, enumerators for elements and regions.
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
    uint32_t *helper;             // by stdlib_text: how often this text of stdlib is needed
    const char **window;          // by window: its member
    struct CVarUse *var_use;      // by variable: what the function in hand does with it
    uint32_t *window_asked;       // by window: a bit for each statistic that the code asks it
    uint32_t *window_sample;      // by window: where the block in hand gives it its sample
    uint32_t stamps;              // functions and blocks so far
    FactMachine *facts;    // what values can be
    bool soft;                    // F64 is SmF64 (soft.c)
    bool track_stores;            // each step tells which elements it stored
    bool runtime;                 // for runtime-c
    const char *fit;              // the name of the self-test; NULL: nothing to test
    StrPool constant_names;       // locals that are constants, for remarks
    Map constants;
} CUnit;

// ---- emit_c.c ----

// Makes a unit for m.  `prefix` is an identifier; `sv_prefix` is what the vector's struct is called after, NULL: the .sv file
// where there is one, else the prefix.
void unit_init(CUnit *u, Arena *a, const IrMachine *m, const char *prefix, const char *sv_prefix);

void unit_soften(CUnit *u, bool soft);

// ---- names.c, continued ----

// Whether a name stands, or begins as those do, that runtime and VM have for themselves: sm_, smvm_, pal_.
bool c_is_ours(const char *name);
// A C identifier made of any text: `my-tank.v2` gives my_tank_v2, `sm` gives m_sm.
const char *c_identifier(Arena *arena, const char *text, size_t len);
// MyTankV2 and MY_TANK_V2 of my_tank_v2.
const char *c_type_name(Arena *arena, const char *prefix);
const char *c_macro_name(Arena *arena, const char *prefix);
// Whether a member or variable of that name would not compile as C99 or C++11 with the usual headers.
bool c_is_reserved(const char *name);
void names_init(CUnit *u, const char *prefix);
const char *c_padding_name(Arena *arena, uint32_t at);
// The members of the vector's elements; sv_type must be set.
void names_elements(Arena *arena, CNames *names, CVector *sv);
void names_runtime(Arena *arena, const CNames *names, const StateVec *sv, CVectorNames *out);

// The names of a vector alone, sv_type and members among them; `u` is empty before.
void c_vector_names(Arena *arena, const StateVec *sv, CUnit *u);
// How the struct of a machine is called whose names begin with `prefix`.
const char *c_machine_type(Arena *arena, const char *prefix, const char *sv_type);

// ---- literal.c ----

// A constant of a type as C writes it; `bits` is its cell.  Infinities and NaN use a helper.
void literal_put(CUnit *u, Buf *out, SmType type, uint64_t bits);
// A finite number as people write it.
void literal_put_finite(Buf *out, double x);

// ---- helpers.c ----

// Notes that a function of stdlib is used and gives its name back.
const char *helper_use(CUnit *u, const char *name);
// The texts of those in use and of what they need, but for types, which the header has.
void helpers_put(CUnit *u, Buf *out);
void helper_type_put(CUnit *u, const char *name, Buf *out);
size_t helper_count(void);

// ---- native.c ----

// A text of stdlib with C's own operators in place of its functions on F64; as it is for soft ones.
void native_put(CUnit *u, const char *text, Buf *out);

// ---- remark.c ----

// The comment at the end of the line of `s`, "" when there is none that could stand in C.
const char *remark_at(Arena *a, Span s);
// The name of the constant local that stands at `s`, "" if something else does.
const char *remark_constant(CUnit *u, Span s);
// By window: the first call that asks it, as in the source; NULL where that is not known.
const char **remark_windows(CUnit *u);

// ---- decl.c ----

void put_vector_struct(const CUnit *u, Buf *out);
void put_machine_types(CUnit *u, Buf *out);
void put_prototypes(const CUnit *u, Buf *out);
const char *c_type_of(const CUnit *u, SmType type);       // of a member
bool c_is_output(const IrMachine *m, size_t v);      // whether the machine can store it: S, or an element that it may assign

// ---- guard.c ----

// What stops a compiler that would change the meaning, and the includes.
void put_guards(Buf *out, const char *what, bool soft);
// The function `name`, which tries the arithmetic at run time.
void put_self_test(const char *name, Buf *out);

// ---- soft.c ----

// Header and code of the numbers, for one translation unit.
void put_soft_library(Buf *out);

// ---- window.c ----

// A window's member: its name and how many words it takes.
const char *window_declaration(const CUnit *u, size_t w);
void put_empty_windows(const CUnit *u, Buf *out);
// A function for each statistic that the code asks.
void put_statistics(CUnit *u, Buf *out);
uint32_t small_roll_words(uint32_t n, uint32_t kind);      // sm_roll_words where memory matters most

// ---- vector.c ----

// What goes behind the struct into the header, and into the code.
void put_vector_interface(const CUnit *u, const StateVec *sv, const CVectorNames *n, Buf *out);
void put_vector_tables(const CUnit *u, const StateVec *sv, const CVectorNames *n, Buf *out);

// ---- code.c ----

// How a block's function is called.
typedef struct CSignature {
    bool returns_state;           // it may make a transition: gives the state's number, or 0
    bool m, sv;                   // which of the two it takes
} CSignature;

typedef struct CFunction {
    const IrFn *f;
    const Env *begin;      // what is known when it begins
    const char *name;
    const char *comment;          // stands in front of it
} CFunction;

// Writes it as a static C function.
CSignature put_function(CUnit *u, const CFunction *what, Buf *out);

// ---- machine.c ----

// The type that holds a state's number, or 0: where numbers are soft, as short as can be.
const char *c_state_type(const CUnit *u);
void put_machine(CUnit *u, Buf *out);      // the functions of all blocks, then init, step, state and state_name

// ---- machine_type.c ----

void put_machine_type(const CUnit *u, Buf *out);
void put_machine_type_prototype(const CUnit *u, Buf *out);

#endif
