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
    uint32_t a, b;                    // indices of the operands in FlatDecision.node; in a CONDITION, a is the number of the condition
} FlatNode;

// A rolling window that a condition or a statement reads, and the counter for whether it is full.
typedef struct FlatFull {
    uint32_t condition;               // in a decision: number of the condition that reads the window
    uint32_t window;                  // index into IrMachine.window
    uint32_t hit;                     // counter: the window was full when the condition decided, or when the statement was executed
} FlatFull;

// A decision: counts its results, and for each condition the value with which it decided (masking MC/DC, docs/testing.md).
typedef struct FlatDecision {
    const IrFn *fn;
    IrRef value;                      // the temporary of the result
    const FlatNode *node;             // the nodes of the decision; the last one is the root
    uint32_t nodes;
    const IrRef *condition;           // by number of the condition: the temporary with its value
    uint32_t conditions;
    const FlatFull *full;             // the windows that conditions read
    uint32_t fulls;
    uint32_t hit;                     // index of the first counter.  Counters: result true, false; for each condition: decided when true, when false
} FlatDecision;

// What is counted.  Entries are indices of counters in FlatMachine.hits; index 0 means that nothing is counted, so counter 0 is unused.
typedef struct FlatProbes {
    const uint32_t *stmt;             // by Stmt.number: the statement was executed
    const uint32_t *transition;       // by Stmt.number: the transition was taken
    const uint32_t *entry, *exit;     // by State.number - 1: the state was entered, left
    const FlatFull *const *full;      // by Stmt.number: the windows that the statement reads outside decisions; the last entry has hit 0; NULL: none
    const FlatDecision *decision;     // each is counted where its value is computed.  Sorted by function, in the order of
                                      // flat_each_function, then by FlatDecision.value
    uint32_t decisions;
    uint32_t counters;                // number of counters, including the unused counter 0
    const bool *watched;              // by decision: FlatMachine.watch is called where the decision is counted; NULL: none
} FlatProbes;

// ---- the machine ----

typedef struct FlatOp {
    uint16_t op;                      // an IrOp, or an OP_ constant of flat.c
    uint8_t type, stat;               // SmType of the result; SmStat
    uint32_t to, a, b;                // mostly indices into FlatMachine.frame: of the result, of the operands; else as `op` defines
} FlatOp;

typedef struct FlatSeen FlatSeen;
typedef struct FlatApp FlatApp;

// Where the temporaries of a function are.
typedef struct FlatFn {
    const IrFn *fn;
    const uint32_t *slot;             // by IrRef: index into FlatMachine.frame
} FlatFn;

typedef struct FlatMachine {
    const IrMachine *m;
    size_t size;                      // size in bytes of the state of a run; a multiple of 8
    size_t cells, windows;            // byte offsets in that state of the variables, and of the windows
    uint32_t *window_at, *window_kind, *window_size;      // by window: byte offset in the state, kind (stdlib/roll.h), number of samples
    FlatOp *op;
    uint32_t ops;
    uint32_t sample;                  // index in `op` of the code that samples all windows; FLAT_NOTHING: the machine has no windows
    uint32_t (*block)[BLOCK_COUNT];   // by State.number - 1: index in `op` of the code of entry, step and exit; FLAT_NOTHING: no code
    double *frame;                    // the temporaries of all functions, and then constants
    FlatFn *fn;                       // in the order of flat_each_function: the sampling, then entry, step and exit of each state
    uint32_t fns;
    uint8_t *stored;                  // by IR variable: 1 if the last step stored it
    const FlatProbes *probes;         // what is counted; NULL: nothing
    uint64_t *hits;                   // the counters
    FlatSeen *seen;                   // by decision: the last evaluation that was counted; an equal one changes no counter
    uint32_t **decision_at, *value_at;        // by decision: the indices in `frame` of its conditions; of its result
    bool *scratch;                    // working memory of count_decision, large enough for every decision
    uint32_t taken;                   // Stmt.number of the transition that the last step took; 0: none
    const FlatApp *app;               // a step is a tick of this application, of which this is one machine (flat_app.h); NULL: the machine runs alone
    size_t own;                       // with `app`: bytes of the state of a run before those of the application
    bool ran;                         // with `app`: this machine ran a step in the last tick
    bool moved;                       // the last step took a transition: of this machine, or with `app` of any machine
    uint64_t fresh;                   // number of counters that are no longer 0
    void (*watch)(void *watcher, uint32_t decision);  // called at watched decisions, while `frame` has the values of their conditions
    void *watcher;                    // passed to `watch`
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
// Runs one step.  Returns false and changes nothing if G does not allow it, because G has not increased (language.md 6.3).  With `app`, runs a tick
// of all machines and returns true.
bool flat_step(FlatMachine *f, void *run);
// The same without regard to FlatMachine.app: for flat_app.c.
bool flat_step_alone(FlatMachine *f, void *run);
// Sets all counters to 0.
void flat_clear_counts(FlatMachine *f);

// Whether the states of two machines of the same program have the same parts at the same offsets.
bool flat_have_same_layout(const Program *p, const FlatMachine *a, const FlatMachine *b);

#endif
