// SPDX-License-Identifier: Apache-2.0
// Interface of the engines that can run a machine for a script: reference interpreter, VM, emitted C in another process, a board on
// a serial line.  Each step is one call with typed cells, so that a serial line needs one request and one answer.
//
// A cell is the value's bits in its own type, zero-extended to 64 bits (I8 -1 is 0xff; F32 is its binary32; bool is 0 or 1).
// Variables are numbered as in Program.var.  A cell is read as stored, including NaN.
#ifndef SMC_ENGINE_H
#define SMC_ENGINE_H

#include <stdbool.h>
#include <stdint.h>

#include "compiler/sema/program.h"

typedef struct EngineWrite { uint32_t var; uint64_t cell; } EngineWrite;

typedef enum EngineStatus {
    ENGINE_OK,
    ENGINE_REFUSED,           // time did not advance, so nothing changed (language.md 6.3)
    ENGINE_BROKEN             // the engine itself failed; `error` is the reason
} EngineStatus;

// Whether one machine of an application ran in a tick, and what its next step will be.
typedef struct EngineNext {
    uint32_t state;           // State.number, in the joined Program, of the state that the machine's next step runs
    bool is_first;            // the machine's next step is the first step of that state
    bool ran;                 // the machine ran a step in this tick; false after init
} EngineNext;

typedef struct EngineStep {
    EngineStatus status;
    uint32_t next_state;      // State.number of the state that the next step runs
    bool next_is_first;       // the next step is the first one of that state: after init and after a transition, even to the same state
    EngineNext *machine;      // for an application, by machine, instead of next_state and next_is_first; NULL: one machine
    uint64_t *cell;           // every variable after the step; program->var.n of them
    uint8_t *stored;          // by variable: 1 if the step stored the element, even with the same value
    const uint64_t *outside;  // with faulty sensors: the true values of all variables, which the script reads before the next step; else NULL
} EngineStep;

typedef struct Engine Engine;
struct Engine {
    const char *name;         // as --engine names it: "ref", "vm", "vm-soft", "c"
    const Program *program;
    const char *error;        // after ENGINE_BROKEN: the reason
    void *self;               // the state of this engine, whose type only the engine's own file knows
    // Starts the machine in `state`, as init does (language.md 6): elements are zero, locals have their initial values, then `S` is
    // stored. *out receives the resulting cells.
    EngineStatus (*init)(Engine *e, uint32_t state, EngineStep *out);
    // Writes n cells, runs one step, and stores the result in *out.  A cell may be an element or a local, even a read-only local, but not a
    // constant.
    EngineStatus (*step)(Engine *e, const EngineWrite *write, uint32_t n, EngineStep *out);
    void (*close)(Engine *e);
    Engine *inside;           // the engine to which this one passes every call, such as that of a recorder; NULL: none
};

// Allocates the result of an engine that runs p.
void engine_step_init(EngineStep *s, Arena *arena, const Program *p);
// Returns what the next step of machine i is, as in EngineNext.  Without an application, i is 0.
static inline EngineNext engine_next(const EngineStep *s, size_t i)
{
    return s->machine ? s->machine[i] : (EngineNext){s->next_state, s->next_is_first, true};
}
// Returns NULL if two engines gave bit-identical results; otherwise a sentence in `arena` that names the first difference.
const char *engine_compare(Arena *arena, const Engine *a, const EngineStep *of_a, const Engine *b, const EngineStep *of_b);

// Returns how many machines p has: 1, or for an application the number of its machines.
static inline size_t engine_machines(const Program *p) { return p->joint ? p->joint->member.n : 1; }
// Returns the Program of machine i of p: p itself, or that of the application's machine.
static inline const Program *engine_program(const Program *p, size_t i) { return p->joint ? p->joint->member.at[i].program : p; }
// Returns the name of machine i of p, in the application.
static inline const char *engine_machine_name(const Program *p, size_t i) { return p->joint ? p->joint->member.at[i].name->text : p->name->text; }

// Joins one engine for each machine of an application, in the order of p->joint->member, to an engine for p (language.md 8.71 to 8.83).
// Closing it closes them.
Engine *engine_app_open(Arena *arena, const Program *p, Engine *const *machine);
// Sets, before init, whether the ticks of an engine of an application are the rows of recorded data (language.md 8.84).
void engine_app_set_rows(Engine *e, bool by_rows);
// Returns the engine of machine i; e itself if it is no engine of an application.
Engine *engine_app_machine(Engine *e, size_t i);

// Opens the reference interpreter. p can be an application.
Engine *engine_ref_open(Arena *arena, const Program *p);
// Returns the transition that the last step of the reference interpreter took; NULL if none.
const Stmt *engine_ref_transition(const Engine *ref);

// A view of a machine's state in the reference interpreter.
typedef struct RefView {
    const uint64_t *cell;     // by Var.index
    const struct RefWindows *windows;
    const State *state;       // before a step and during it, the state that it runs; after it, the state of the next step
    uint64_t g;               // G of the last step that ran, or of the current one
    bool is_first;            // before a step and during it: the step is the first of its state
} RefView;

// Callbacks that the reference interpreter calls before every step and every statement that it runs.
typedef struct RefObserver RefObserver;
struct RefObserver {
    void (*before_step)(RefObserver *o, const RefView *r);        // S, T and the windows already have their values for the step
    void (*before_stmt)(RefObserver *o, const RefView *r, const Stmt *s);
};

// The following are for an engine of engine_ref_open that runs one machine.
void engine_ref_observe(Engine *ref, RefObserver *o);         // sets the observer; NULL: none
RefView engine_ref_view(const Engine *ref);
// Copies the state of a machine, but not its observer, to another engine of the same Program.
void engine_ref_copy(Engine *to, const Engine *from);

// Opens the VM, with an image in which p is machine number `machine`.  Returns NULL and sets *error to a sentence if it cannot run it.
Engine *engine_vm_open(Arena *arena, const Program *p, const uint8_t *image, size_t size, uint32_t machine, const char **error);
// Where an engine from engine_vm_open stores a variable, for code that runs the same image on a board or in another process.
typedef struct EngineLocation {
    enum { LOCATION_CONSTANT, LOCATION_TIME, LOCATION_ELEMENT, LOCATION_LOCAL } in;
    uint32_t offset;          // in bytes: in the state vector, or among the locals
    uint32_t output;          // 1 + number of the output, as in smvm_stored; 0: the variable is no output
} EngineLocation;
EngineLocation engine_vm_location(const Engine *e, uint32_t var);
// Opens the VM as compiled for a chip without binary64: engine_vm.c and bytecode-vm/ compiled a second time with the soft type (see the Makefile).
Engine *engine_vm_soft_open(Arena *arena, const Program *p, const uint8_t *image, size_t size, uint32_t machine, const char **error);

#endif
