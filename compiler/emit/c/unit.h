// SPDX-License-Identifier: Apache-2.0
// Shared by the files of the C emitter: the translation unit that is being written, and the functions that write its parts.
//
// Terms: an element is a member of the state vector's struct, `sv->name`; a local is a member of the machine's struct, `m->name`.
#ifndef SMC_EMIT_C_UNIT_H
#define SMC_EMIT_C_UNIT_H

#include "compiler/base/buf.h"
#include "compiler/facts/facts.h"
#include "compiler/ir/ir.h"

// ---- names.c ----

typedef struct CNames {
    const char *prefix;           // prefix of the names of functions: `tank` in tank_step
    const char *type;             // prefix of the names of types: `Tank` in TankSv
    const char *macro;            // prefix of the names of macros and enumerators: `TANK` in TANK_OK
    const char *sv_type;          // name of the state vector's struct: TankSv
    const char *sv_macro;         // prefix of the macros of the state vector: `TANK_SV` in TANK_SV_SIZE
    const char **var;             // by index in IrMachine.var: name of the struct member that stores the variable
    const char **state;           // by index of a state: the state's name in C
    Map element;                  // from the source name of each element of the state vector to its member (const char *)
} CNames;

// An element of the state vector, whether or not the machine declares that it uses it.
typedef struct CElement {
    const char *member;
    SmType type;
    uint32_t offset;
    Str name;                     // its name in the source
    Str region;                   // name of its region; NULL: unknown
    Span span;
} CElement;

// A state vector.
typedef struct CVector {
    CElement *at;                 // its elements, in ascending order of their offsets
    size_t n;
    uint32_t size, hash;          // size in bytes; hash of the layout
    const char *name;             // name of the .sv file or the machine
    bool shared;                  // the state vector comes from a .sv file, so several machines can use it
} CVector;

// Names of what the flight runtime needs for a state vector: access functions, and enumerators of elements and regions.
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
    uint32_t *helper;             // by index in stdlib_text (stdlib_text.h): number of uses of that snippet of stdlib source
    const char **window;          // by rolling window: name of the member of the machine's struct that stores the window's samples
    const char **ring;            // by rolling window: name of the member that stores its sample count and next slot; windows of one size share it
    struct CVarUse *var_use;      // by variable: how the current function uses it
    uint32_t *window_stats_read;  // by window: a bit for each statistic that the code reads
    uint32_t *window_zeros_differ;// by window: a bit for each statistic that some use reads so that -0 and 0 have different results
    uint32_t *window_sample;      // by window: index in the current block of the next instruction that samples it; UINT32_MAX: none (lower.c)
    uint32_t stamps;              // number of functions and blocks so far; see CFn.stamp
    FactMachine *facts;           // possible values of variables
    bool soft;                    // an F64 is an SmF64, not a double (soft.c)
    bool track_stores;            // each step reports which elements it stored
    bool runtime;                 // the output is for the flight runtime (runtime-c)
    bool uses_noinline;           // the code uses the macro SM_NOINLINE
    unsigned key_bits;            // width in bits of the type SmRollKey: the widest sort key of the samples of all windows; 0: no window
    bool self_test;               // init calls the self-test of the arithmetic (guard.c)
    StrPool constant_names;       // remark.c: names of the locals that are constants
    Map constants;                // the set of the names of constants; its arena is NULL until it is filled
} CUnit;

// ---- emit_c.c ----

// Initialises a unit for m.  `prefix` is a C identifier.  The struct of the state vector is named after `sv_prefix`; NULL: after the .sv file
// if there is one, otherwise after `prefix`.
void unit_init(CUnit *u, Arena *a, const IrMachine *m, const char *prefix, const char *sv_prefix);

// Chooses soft numbers (soft.c) or doubles.  With soft numbers no self-test of the arithmetic is emitted.
void unit_set_soft(CUnit *u, bool soft);

// ---- names.c, continued ----

// Whether a name is sm, smvm or pal, or begins with one of these and an underscore.  Such names are reserved for the runtime and the VM.
bool c_has_reserved_prefix(const char *name);
// Turns any text into a C identifier: `my-tank.v2` becomes my_tank_v2, `sm` becomes m_sm.
const char *c_identifier(Arena *arena, const char *text, size_t len);
// Return MyTankV2 and MY_TANK_V2 for my_tank_v2.
const char *c_type_name(Arena *arena, const char *prefix);
const char *c_macro_name(Arena *arena, const char *prefix);
// Whether a member or variable of that name may fail to compile as C99 or C++11 with common headers.
bool c_is_reserved(const char *name);
// Assigns all names of the unit's machine and state vector.  names.sv_type must be set.
void names_init(CUnit *u, const char *prefix);
// Returns the name of the member for the padding bytes at an offset.
const char *c_padding_name(Arena *arena, uint32_t at);
// Assigns the members of the elements of `sv`.  names->sv_type must be set.
void names_assign_elements(Arena *arena, CNames *names, CVector *sv);
void names_assign_runtime(Arena *arena, const CNames *names, const StateVec *sv, CVectorNames *out);

// Initialises `u` for a state vector without a machine and assigns its names, including sv_type and the members.
void c_init_vector_names(Arena *arena, const StateVec *sv, CUnit *u);
// Returns the name of the struct of a machine whose functions begin with `prefix`.
const char *c_machine_type(Arena *arena, const char *prefix, const char *sv_type);

// ---- literal.c ----

// Writes a constant as a C literal of its type.  `bits` is the constant's bit pattern, zero-extended.  Infinities and NaN are calls of a
// helper.
void literal_write(CUnit *u, Buf *out, SmType type, uint64_t bits);
// Writes a finite number with the fewest decimal digits that convert back to it.
void literal_write_finite(Buf *out, double x);

// ---- helpers.c ----

// Counts a use of the snippet `name` of stdlib, so that it is emitted; returns `name`.
const char *helper_require(CUnit *u, const char *name);
// Writes the snippets that were counted as used, and those that they use.  Skips types, which are in the header.
void helpers_write_required(CUnit *u, Buf *out);
// Writes the snippet that defines type `name`.
void helper_write_type(CUnit *u, const char *name, Buf *out);
size_t helper_count(void);                                // number of snippets

// ---- native.c ----

// Writes the source of a stdlib snippet.  Replaces calls on F64, such as sm_add(a, b), by C operators unless numbers are soft.
void native_write(CUnit *u, const char *text, Buf *out);

// ---- remark.c ----

// Returns the source comment at the end of the line of `s`; "" if the line has no comment, or if the comment cannot be copied into a C comment.
const char *remark_of_line(Arena *a, Span s);
// Returns the name of the constant local whose name is the source at `s`; "" if `s` is not such a name.
const char *remark_constant_name(CUnit *u, Span s);
// Returns, by window, the source of the first call that reads it; NULL where unknown.
const char **remark_window_calls(CUnit *u);

// ---- decl.c ----

void c_write_vector_struct(const CUnit *u, Buf *out);
// Writes the check of the struct's size, for the source file: foreign function interfaces read the header, and most cannot evaluate it.
void c_write_vector_check(const CUnit *u, Buf *out);
bool c_has_parameters(const CUnit *u);
void c_write_parameter_types(CUnit *u, Buf *out);        // in parameters.c.  This and the next two write nothing for a machine without parameters
void c_write_parameter_prototypes(const CUnit *u, Buf *out);
void c_write_parameters(CUnit *u, Buf *out);
void c_write_machine_types(CUnit *u, Buf *out);
void c_write_prototypes(const CUnit *u, Buf *out);
const char *c_type_of(const CUnit *u, SmType type);       // the C type of a value of `type`
bool c_is_output(const IrMachine *m, size_t v);           // whether variable v is S or an element that the machine may assign

// ---- guard.c ----

// Writes the includes, and the #error checks and pragmas against compilers and flags that change the meaning of arithmetic.  `name` begins the
// name of the type that checks the size of constants.
void c_write_compiler_checks(Buf *out, const char *name, bool soft);
// These write the declaration and the definition of the function that tests the arithmetic at run time.
void c_write_self_test_declaration(Buf *out);
void c_write_self_test(Buf *out);

// ---- soft.c ----

// Writes the declarations and functions of soft numbers, to be part of the same translation unit.
void c_write_soft_library(Buf *out);

// ---- window.c ----

// Writes a macro for the size of each window whose size depends on SM_ROLL_SMALL.
void c_write_window_sizes(const CUnit *u, Buf *out);
size_t c_ring_owner(const CUnit *u, size_t w);        // returns the first window that shares the ring of window w (stdlib/roll.h)
bool c_begins_ring(const CUnit *u, size_t w);        // whether window w is the first one that uses its ring
// Returns the declarator of the window's member: its name and its size in words, as in `altitude_last_9[12]`.
const char *c_window_declaration(const CUnit *u, size_t w);
void c_write_empty_windows(const CUnit *u, Buf *out);        // the statements of init that empty all windows
// Writes a function for each statistic that window_stats_read lists.
void c_write_statistic_functions(CUnit *u, Buf *out);
uint32_t c_small_roll_words(uint32_t n, uint32_t kind);      // returns sm_roll_words as compiled with SM_ROLL_SMALL, for least memory

// ---- vector.c ----

// These write the part of the header that follows the vector's struct, and the tables in the source file.
void c_write_vector_interface(const CUnit *u, const StateVec *sv, const CVectorNames *n, Buf *out);
void c_write_vector_tables(const CUnit *u, const StateVec *sv, const CVectorNames *n, Buf *out);

// ---- code.c ----

// The parameters and result of a block's function.
typedef struct CSignature {
    bool returns_state;           // the function can make a transition: it returns the number of the next state, or 0
    bool m, sv;                   // the function has a parameter m, the machine; sv, the state vector
} CSignature;

typedef struct CFunction {
    const IrFn *f;
    const Env *begin;             // facts at the start of the function
    const char *name;             // name of the C function
    const char *comment;          // comment line that is written before the function
} CFunction;

// Writes the function as a static C function.
CSignature c_write_function(CUnit *u, const CFunction *what, Buf *out);

// ---- machine.c ----

// Returns the C type for a state's number or 0.  If numbers are soft: the shortest type that can represent the numbers of all states.
const char *c_state_type(const CUnit *u);
// Writes the functions of all blocks, then init, step, state, T and state_name.
void c_write_machine(CUnit *u, Buf *out);

// ---- machine_type.c ----

// These write the machine's SmMachineType for the flight runtime, and its declaration.
void c_write_machine_type(const CUnit *u, Buf *out);
void c_write_machine_type_declaration(const CUnit *u, Buf *out);

#endif
