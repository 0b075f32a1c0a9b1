// SPDX-License-Identifier: Apache-2.0
// Facts about a whole machine: the possible values of its locals when each state's functions begin.  From these, the possible
// values of every temporary of a function are derived, including what the guards around it imply.
//
// When a function begins, only the type of elements, and of locals that other code writes, is known.  Within a function, stores and
// guards add facts about them.  A machine may be started in any state, with its locals at their initial values.
//
//     FactMachine *fm = facts_of_machine(arena, m);
//     FactFlow flow = facts_of_block(fm, state, BLOCK_STEP);     // flow.of[ref]
//
// A pass that preserves the meaning of the machine leaves a FactMachine valid, unless it renumbers variables or windows.
#ifndef SMC_FACTS_H
#define SMC_FACTS_H

#include "compiler/facts/env.h"
#include "compiler/facts/slot_env.h"

typedef struct FactMachine FactMachine;

typedef struct FactExit {             // the end of a block
    const Env *env;                   // IR_BR, IR_GOTO: the facts at the end of the block, before its branch is taken; NULL without FactEnds.exits
    bool then, otherwise;             // IR_BR: whether the facts allow that edge to be taken
} FactExit;

typedef struct FactFlow {             // valid until the next function is analysed
    Fact *of;                         // by temporary: the possible values of the temporary; undefined in unreached blocks
    bool *reached;                    // by block: whether the facts allow a path to the block
    FactExit *exit;                   // by block: the facts at the end of the block; undefined for unreached blocks
} FactFlow;

FactMachine *facts_of_machine(Arena *arena, const IrMachine *m);
// Computes the facts of a machine that is only ever started in its first state, as analyses assume.
FactMachine *facts_from_first_state(Arena *arena, const IrMachine *m);
// The same for a machine that is only ever started in this state, counted from 0.
FactMachine *facts_from_state(Arena *arena, const IrMachine *m, uint32_t state);
// Like facts_from_state, with facts about T when .step of each state begins.
FactMachine *facts_with_times(Arena *arena, const IrMachine *m, uint32_t state, const Fact *time);
// Like facts_from_first_state, but assumes that the elements satisfy `assumed` whenever a step begins.
FactMachine *facts_assuming(Arena *arena, const IrMachine *m, const Env *assumed);
// Makes later calls of facts_of_function allocate from `arena`.
void facts_set_arena(FactMachine *fm, Arena *arena);
// Whether the facts allow a path to this function.  Not for facts_of_machine, which assumes that each state can be the first.
bool facts_may_reach(const FactMachine *fm, size_t state, int block);

// Return the facts when a function of state `state` (from 0) begins, and when the sample function begins.
const Env *facts_at_begin(const FactMachine *fm, size_t state, int block);
const Env *facts_at_begin_of_sample(const FactMachine *fm);

// Returns the facts in function f, which begins with the facts `begin`.
FactFlow facts_of_function(FactMachine *fm, const IrFn *f, const Env *begin);
// Returns the facts in a function that the state must have.  Reuses the recorded facts of the function's last visit if it began with the same facts.
FactFlow facts_of_block(FactMachine *fm, size_t state, int block);
// Forgets the recorded visits.  Call it when functions of the machine have changed.
void facts_forget_visits(FactMachine *fm);

Fact facts_of_window(const FactMachine *fm, uint32_t window);      // the fact that is true of all samples of the window

// ---- inside compiler/facts ----

typedef struct FactEnds {             // options of facts_flow: what to do with the facts at each end of a function
    void (*visit)(void *context, const IrJump *end, const Env *env);  // called for each IR_RET or IR_GOTO that may be reached; NULL: no call
    void *context;
    bool all;                         // `visit` receives all facts; if false, only facts about private variables and assumed facts
    bool exits;                       // the caller needs FactExit.env, with all facts
    const Fact *time;                 // what is known about T when the function begins; NULL: nothing
    struct FactFn *fn;                // receives a record of this visit, for the next one; NULL: no record, as with `all` or `exits`
} FactEnds;

typedef struct FactHome {
    uint32_t var;                     // a variable with the same value as a temporary; IR_NONE: none is known
    uint32_t at;                      // position in the block from which on variable and temporary have the same value
} FactHome;

typedef struct FactSlot {
    uint32_t var;
    IrBlkRef last_load;               // the last block that loads the variable
} FactSlot;

typedef struct FactUpdate {           // a slot and the fact about it: the one that was loaded, stored or added
    uint32_t slot;
    Fact fact;
} FactUpdate;

// What a visit of a block has found.  Another visit finds the same if the block loads the same facts.
typedef struct FactEffect {
    bool known;                       // the block has been visited
    bool then, otherwise;             // whether each edge can be taken, as in FactExit
    uint32_t loads, stores, on_then, on_otherwise;      // how many facts the arrays contain: loaded, stored, and added on each edge
    FactUpdate *load;                 // the facts about the variables that the block loads
    FactUpdate *update;               // the facts that the block stores, followed by those that its edges `then` and `otherwise` add
} FactEffect;

typedef struct FactEnd {              // an IR_RET or IR_GOTO that the last visit of a function has reached
    const IrJump *jump;
    bool is_as_before;                // the facts at this end are those at the previous end of the list
    uint32_t updates;                 // how many facts about private variables differ from those at the beginning, unless is_as_before
} FactEnd;

typedef struct FactFn {               // the record of the last visit of a function, so that the next visit needs less work
    FactSlot *slot;                   // by slot: the variable of the slot; NULL: not visited yet, or too many variables for slots
    uint32_t slots;
    FactEffect *effect;               // by block; NULL: visits are not repeated (FactMachine.has_variable_locals)
    Fact *begin;                      // by slot: the fact at the beginning of the function in the last visit
    uint64_t read;                    // a set of slots: those whose facts at the beginning the last visit has read
    FactFlow flow;                    // of the last visit
    VEC(FactEnd) end;                 // the ends of the last visit
    VEC(FactUpdate) update;           // for all entries of `end` in turn: the facts that differ from those at the beginning
} FactFn;

typedef struct FactSlotOf {           // the slot of a variable, if `function` is FactMachine.functions
    uint32_t slot, function;
} FactSlotOf;

typedef union FactPoint {             // the facts at one point of a function
    SlotEnv *slots;                   // for a function with slots: the facts by slot; belongs to this point alone
    const Env *all;                   // for a function with too many variables for slots: the facts about all variables of the machine
} FactPoint;

typedef struct FactRefined {          // what an edge adds about a slot; valid if `edge` is the number of the current edge
    Fact fact;
    uint32_t edge;
} FactRefined;

typedef struct FactBegin {            // what is known at the beginning of a function
    const Env *env;
    bool found, dirty;                // a path to the function has been found; `env` has changed since the last visit of the function
    unsigned changes;                 // how often `env` has changed
    const Env *joined;                // the facts that were merged into `env` last: merging them again changes nothing
} FactBegin;

struct FactMachine {
    const IrMachine *m;
    EnvShape shape;
    Arena local;                      // the environments of slots in the current function
    Fact slot_begin[FACT_SLOTS];      // by slot of the current function: the fact at the beginning of the function
    const Env *assumed;               // the facts that are assumed of elements, or NULL
    bool has_variable_locals;         // the machine writes private locals; else all functions begin with the facts `constants`
    const Fact *time;                 // by state: what the caller knows about T when .step begins; NULL: nothing
    const Env *constants;             // `assumed`, and the values of locals that no code writes
    FactBegin (*begin)[BLOCK_COUNT];  // [state][block]: the facts at the beginning of each function
    FactFn (*fn)[BLOCK_COUNT];        // [state][block]: a record of the last visit of each function; NULL: visits are not recorded
    Fact *window;                     // by window: the fact that is true of all its samples
    uint32_t *epoch, *stored;         // by variable: value of `epochs` at the last block visit that stored to it; position of that store
    uint32_t epochs;                  // number of block visits so far
    uint32_t functions, edges;        // number of functions analysed so far; number of edges followed in them
    FactSlotOf *slot_of;              // by variable: its slot in the function that was analysed last
    FactSlot slot[FACT_SLOTS];        // the slots of the current function
    VEC(FactUpdate) load, update;     // the facts that the effect of the current block will contain (FactEffect)
    FactRefined *refined;             // by slot, or by variable where a function has too many for slots
    uint32_t *refined_slot;           // the slots about which the current edge adds facts
    Fact zero;                        // the fact of the number 0 in a U64
    size_t temps, blocks;             // capacity of the following tables, in temporaries and in blocks; every call of facts_flow uses them
    Fact *of;
    FactHome *home;
    bool *reached;
    FactExit *exit;
    FactPoint *block_begin;
};

// Computes the facts of all temporaries and blocks of f, which begins with the facts `begin`.  `ends` may be NULL.
FactFlow facts_flow(FactMachine *fm, const IrFn *f, const Env *begin, const FactEnds *ends);

#endif
