// SPDX-License-Identifier: Apache-2.0
// What can run a machine, seen from the script engine: reference interpreter, VM, emitted C in another process, a board
// behind a serial line.  One exchange a step, in typed bit cells, so that a link costs one message each way.
//
// A cell is the value's bits in its own type, zero-extended to 64 (I8 -1 is 0xff; F32 its binary32; bool 0 or 1).
// Variables are numbered as in Program.var.  A cell that is read is as stored, NaN included.
#ifndef SMC_ENGINE_H
#define SMC_ENGINE_H

#include <stdbool.h>
#include <stdint.h>

#include "compiler/sema/program.h"

typedef struct EngineWrite { uint32_t var; uint64_t cell; } EngineWrite;

typedef enum EngineStatus {
    ENGINE_OK,
    ENGINE_REFUSED,           // time did not advance: nothing changed (language.md 6.1)
    ENGINE_BROKEN             // the engine itself failed; `error` says how
} EngineStatus;

typedef struct EngineStep {
    EngineStatus status;
    uint32_t next_state;      // number of the state the next step will run
    bool next_is_first;       // that will be a first step: after init and after a transition, one to the same state too
    uint64_t *cell;           // every variable after the step; program->var.n of them
    uint8_t *stored;          // 1 for each element that the step stored, by variable
} EngineStep;

typedef struct Engine Engine;
struct Engine {
    const char *name;         // "ref", "vm", "vm-soft", "c"
    const Program *program;
    const char *error;        // after ENGINE_BROKEN: what happened
    void *self;
    // Puts the machine at `state`: elements zero, locals at their initial values, then `S`, as init does (language.md 6).
    // Gives in *out the cells as they are then.
    EngineStatus (*init)(Engine *e, uint32_t state, EngineStep *out);
    // Writes n cells (locals too, read-only ones that are no constants included), steps, and tells what is there then.
    EngineStatus (*step)(Engine *e, const EngineWrite *write, uint32_t n, EngineStep *out);
    void (*close)(Engine *e);
};

// Space for the answer of an engine that runs p.
void engine_step_init(EngineStep *s, Arena *arena, const Program *p);
// NULL when two engines gave the same answer bit for bit; else a sentence that names the first difference, in arena.
const char *engine_compare(Arena *arena, const Engine *a, const EngineStep *of_a, const Engine *b, const EngineStep *of_b);

// The reference interpreter.
Engine *engine_ref_open(Arena *arena, const Program *p);
const Stmt *engine_ref_transition(const Engine *ref);      // that the last step made; NULL: none
// The VM, on an image that holds p as machine number `machine`.
Engine *engine_vm_open(Arena *arena, const Program *p, const uint8_t *image, size_t size, uint32_t machine, const char **error);
// Where an engine that engine_vm_open gave keeps a variable, for who runs its image elsewhere.
typedef struct EnginePlace {
    enum { PLACE_CONSTANT, PLACE_TIME, PLACE_ELEMENT, PLACE_LOCAL } in;
    uint32_t offset;          // in bytes: in the state vector, or among the locals
    uint32_t output;          // 1 + its number among the machine's outputs, as smvm_stored has them; 0: it is none
} EnginePlace;
EnginePlace engine_vm_place(const Engine *e, uint32_t var);
// The VM as it is on a chip without binary64: engine_vm.c and bytecode-vm/, compiled once more with the soft type (see the Makefile).
Engine *engine_vm_soft_open(Arena *arena, const Program *p, const uint8_t *image, size_t size, uint32_t machine, const char **error);

#endif
