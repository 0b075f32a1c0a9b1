// SPDX-License-Identifier: Apache-2.0
// An application as a flat machine (flat.h): one of its machines is seen from inside, with probes, while each step runs a tick of all machines
// (language.md 8.71 to 8.76).  The state of a run contains those of all machines.
//
//     const FlatView *v = flat_view_new(arena, joint, machine, ir);
//     FlatMachine *f = flat_app_join(arena, flat_new(arena, v->m, probes), v->app);
//
// The machine's own variables come first in the view, then the elements of the application that it does not list.  So the view has every element,
// and its cells are the state vector of the application.
#ifndef SMC_FLAT_APP_H
#define SMC_FLAT_APP_H

#include "compiler/cover/flat.h"

// One machine of the application.
typedef struct FlatMember {
    FlatMachine *f;           // NULL: the machine of the view, which the flat machine of the application itself runs
    const uint32_t *cell;     // by IR variable of f: the view's IR variable with the same element; IR_NONE: a local or T
    uint64_t every;           // the machine steps once in so many ticks
    uint32_t mode;            // the view's IR variable of its @mode; IR_NONE: none
    uint32_t s;               // the view's IR variable that is its S
    uint32_t state;           // State.number of the state in which it starts
} FlatMember;

typedef struct FlatStart { uint32_t var; uint64_t cell; } FlatStart;       // an IR variable of the view, and its value in [start]

struct FlatApp {
    FlatMember *member;       // in the order in which they step in a tick
    uint32_t members;
    VEC(FlatStart) start;
    size_t size;              // bytes that the state of a run has beyond that of the view's machine
};

typedef struct FlatView {
    const Program *p;         // the machine; its variables are followed by the elements that it does not list
    const IrMachine *m;       // its IR, with the same additional variables
    const uint32_t *joint;    // by Var.index of p: index of the same variable in the joined Program
    const uint32_t *own;      // by Var.index of the joined Program: index of the same variable in p; UINT32_MAX: a local or T of another machine
    const FlatApp *app;
} FlatView;

// Returns the view from machine number `machine` of a joined Program.  ir: by machine, its IR.
const FlatView *flat_view_new(Arena *arena, const Program *joint, size_t machine, const IrMachine *const *ir);
// Makes the steps of f, which was built from the IR of a view, ticks of the application.  Returns f.
FlatMachine *flat_app_join(FlatMachine *f, const FlatApp *app);
// Returns the state of another machine than the view's, which is number `machine` of the application, within the state of a run.
void *flat_app_state(const FlatMachine *f, void *run, uint32_t machine);
// Adds the states of the other machines to a hash.
uint64_t flat_app_hash(const FlatMachine *f, const void *run, uint64_t hash);

// For flat.c: flat_start and flat_step of a machine with FlatMachine.app.
void flat_app_start(const FlatMachine *f, void *run);
void flat_app_step(FlatMachine *f, void *run);

#endif
