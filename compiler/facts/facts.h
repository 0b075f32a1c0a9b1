// SPDX-License-Identifier: Apache-2.0
// Facts about a whole machine: what its locals can hold when each state's functions begin, and from that what every temporary of
// a function can be, guards on the way to it included.
//
// Elements, and locals that others write, are only known by their type when a function begins; within a function they are what
// was last stored or what a guard let pass.  A machine may be started in any state, with its locals at their initial values.
//
//     FactMachine *fm = facts_of_machine(arena, m);
//     FactFlow flow = facts_of_function(fm, f, facts_begin(fm, state, BLOCK_STEP));     // flow.of[ref]
//
// What a pass changes without changing what the machine means leaves a FactMachine true, as long as variables and windows keep
// their numbers.
#ifndef SMC_FACTS_H
#define SMC_FACTS_H

#include "compiler/facts/env.h"

typedef struct FactMachine FactMachine;

typedef struct FactExit {             // where a block ends
    const Env *env;                   // what is known there, before the branch
    bool then, otherwise;             // IR_BR: whether facts leave that way
} FactExit;

typedef struct FactFlow {             // holds until the next function is looked at
    Fact *of;                         // by temporary of the function; nothing of those in blocks that are not reached
    bool *reached;                    // by block: whether facts leave a way to it
    FactExit *exit;                   // by block; nothing of those that are not reached
} FactFlow;

// Is told of every function that a way leads to; of some more than once, then the last time counts.
typedef struct FactWatch {
    void (*at)(void *context, const IrFn *f, FactFlow flow);
    void (*forget)(void *context);    // all that was told was too much: it is told anew
    void *context;
} FactWatch;

FactMachine *facts_of_machine(Arena *arena, const IrMachine *m);
// The same of a machine that is only ever started in its first state: what analyses speak of.
FactMachine *facts_from_first_state(Arena *arena, const IrMachine *m, const FactWatch *watch);
// The same, where `outside` says of elements what they are whenever a step begins.
FactMachine *facts_supposing(Arena *arena, const IrMachine *m, const Env *outside);
// Where the work of flows goes from now on.
void facts_work_in(FactMachine *fm, Arena *arena);
// Whether a way to this function has been found.
bool facts_reach(const FactMachine *fm, size_t state, int block);

// Before a function of state `state` (from 0) begins; before the sample function.
const Env *facts_begin(const FactMachine *fm, size_t state, int block);
const Env *facts_begin_sample(const FactMachine *fm);

FactFlow facts_of_function(FactMachine *fm, const IrFn *f, const Env *begin);

Fact facts_of_window(const FactMachine *fm, uint32_t window);      // its samples

// ---- inside compiler/facts ----

typedef struct FactEnds {             // with which facts a function ends
    void (*at)(void *context, const IrJump *end, const Env *env);  // a way that ends in IR_RET or IR_GOTO
    void *context;
} FactEnds;

typedef struct FactHome {
    uint32_t var, at;                 // of a temporary: the variable that holds it too, or IR_NONE; since where in the block
} FactHome;

typedef struct FactBegin {            // of a function
    const Env *env;
    bool found, dirty;                // a way to it has been found; env has changed since it was looked at
    unsigned changes;
} FactBegin;

struct FactMachine {
    EnvShape shape;
    const Env *outside;               // what is supposed of elements, or NULL
    const Env *constants;             // that, and locals that nobody writes
    FactBegin (*begin)[BLOCK_COUNT];  // by state
    Fact *window;                     // by window: its samples
    uint32_t *epoch, *stored;         // by variable: the block that wrote it last (counted from 1), and where in it
    uint32_t epochs;
    size_t temps, blocks;             // how many of each the following have room for
    Fact *of;
    FactHome *home;
    bool *reached;
    FactExit *exit;
    const Env **block_begin;
};

FactFlow facts_flow(FactMachine *fm, const IrFn *f, const Env *begin, const FactEnds *ends);

#endif
