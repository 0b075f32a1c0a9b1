// SPDX-License-Identifier: Apache-2.0
// A machine as one array of operations on doubles, for runs of many steps: coverage, mutants, searches.  It is built from the IR before any
// pass, so its operations are those of the source.  Its arithmetic is that of stdlib, so its results have the same bits as those of the VM.
//
// A state of a run is one block of memory: a search copies it with memcpy to return to it later.
//
//     FlatMachine *f = flat_new(arena, m, NULL);
//     void *s = arena_alloc(arena, f->size);
//     flat_start(f, s, 1);
//     flat_cells(f, s)[m->g] = 10;                  // inputs, as cells (stdlib/convert.h), by IR variable
//     flat_step(f, s);
//
// With probes it also counts what it executes.  A counter is a number in FlatMachine.hits, which is no part of the state.
#ifndef SMC_FLAT_H
#define SMC_FLAT_H

#include "compiler/ir/ir.h"

// ---- probes: what is counted ----

// A node of a decision, a tree of conditions joined by `and`, `or` and `not`, in postfix order: operands come before their operator.
typedef struct FlatNode {
    enum { NODE_CONDITION, NODE_AND, NODE_OR, NODE_NOT } kind;
    uint32_t a, b;                    // indices of the operands among the nodes; in a CONDITION, a is its number
} FlatNode;

// A window that a condition reads, or a statement.
typedef struct FlatFull {
    uint32_t condition;               // number of the condition that reads it
    uint32_t window;                  // index into IrMachine.window
    uint32_t hit;                     // counter: the window was full when the condition decided
} FlatFull;

// A decision: counts its results, and for each condition the value with which it decided (masking MC/DC, docs/testing.md).
typedef struct FlatDecision {
    const IrFn *fn;
    IrRef value;                      // the temporary of the result
    const FlatNode *node;             // nodes; the last one is the root
    uint32_t nodes;
    const IrRef *condition;           // by number of the condition: its temporary
    uint32_t conditions;
    const FlatFull *full;
    uint32_t fulls;
    uint32_t hit;                     // counters: true, false; then for each condition: decided when true, decided when false
} FlatDecision;

// What is counted, by statement and by state.  A counter of 0 counts nothing, so counter 0 has no meaning.
typedef struct FlatProbes {
    const uint32_t *stmt;             // by Stmt.number: it was executed
    const uint32_t *transition;       // by Stmt.number: this transition was taken
    const uint32_t *entry, *exit;     // by State.number - 1: the state was entered, left
    const FlatFull *const *full;      // by Stmt.number: windows that it reads outside decisions; ends with a counter of 0; NULL: none
    const FlatDecision *decision;     // each is counted where its value is computed; sorted by function, in the order of
                                      // flat_each_function, and by value
    uint32_t decisions;
    uint32_t counters;
    const bool *watched;              // by decision: FlatMachine.watch is called where it is counted; NULL: none
} FlatProbes;

// ---- the machine ----

typedef struct FlatOp {
    uint16_t op;
    uint8_t type, stat;
    uint32_t to, a, b;
} FlatOp;

typedef struct FlatSeen FlatSeen;

// Where the temporaries of a function are.
typedef struct FlatFn {
    const IrFn *fn;
    const uint32_t *slot;             // by IrRef: index into FlatMachine.frame
} FlatFn;

typedef struct FlatMachine {
    const IrMachine *m;
    size_t size;                      // bytes of a state; a multiple of 8
    size_t cells, windows;            // byte offsets in a state
    uint32_t *window_at, *window_kind, *window_size;      // by window: byte offset in a state, kind (stdlib/roll.h), samples
    FlatOp *op;
    uint32_t ops;
    uint32_t sample;                  // index into op; FLAT_NOTHING: no windows
    uint32_t (*block)[BLOCK_COUNT];   // by state from 0: index into op; FLAT_NOTHING: no code
    double *frame;                    // the temporaries of each function, and then constants
    FlatFn *fn;                       // in the order of flat_each_function: the sampling, then entry, step and exit of each state
    uint32_t fns;
    uint8_t *stored;                  // by IR variable: the last step stored it
    const FlatProbes *probes;         // NULL: nothing is counted
    uint64_t *hits;                   // by counter
    FlatSeen *seen;                   // by decision: the last evaluation that was counted; an equal one changes no counter
    uint32_t **decision_at, *value_at;        // by decision: where in the frame its conditions and its value are
    bool *scratch;                    // room to judge the largest decision
    uint32_t taken;                   // Stmt.number of the transition that the last step took; 0: none
    uint64_t fresh;                   // how many counters are no longer 0
    void (*watch)(void *watcher, uint32_t decision);  // called at watched decisions; the frame has their operands
    void *watcher;
} FlatMachine;

#define FLAT_NOTHING UINT32_MAX

// The first bytes of a state of a run.
typedef struct FlatState {
    uint64_t last_g, start;           // G of the last step that ran; G when the current state began
    uint32_t state;                   // number of the state that the next step runs
    bool first, ran;                  // the next step is the first one in `state`; some step has run
} FlatState;

// Prepares a machine.  m is not changed and must outlive the result, and so must `probes`, which can be NULL.
FlatMachine *flat_new(Arena *arena, const IrMachine *m, const FlatProbes *probes);
// Initialises the state of a run as language.md 6.1 and 6.2 say: elements are 0, and S is `state`.
void flat_start(const FlatMachine *f, void *run, uint32_t state);
uint64_t *flat_cells(const FlatMachine *f, void *run);            // the cells of all variables, by IR variable
// Runs one step.  Returns false and changes nothing if G refuses the step (language.md 6.3).
bool flat_step(FlatMachine *f, void *run);
// Sets all counters to 0.
void flat_clear_counts(FlatMachine *f);

// Whether the states of two machines of the same program have the same parts at the same offsets.
bool flat_have_same_layout(const Program *p, const FlatMachine *a, const FlatMachine *b);

#endif
