// SPDX-License-Identifier: Apache-2.0
// The state of a machine in the reference interpreter: Engine.self of engine_ref_open.  Tests of swaps copy parts of it.
#ifndef SMC_ENGINE_REF_H
#define SMC_ENGINE_REF_H

#include "compiler/script/engine.h"
#include "compiler/script/ref.h"

typedef struct RefEngine {
    Engine engine;
    Arena *arena;
    const Program *p;
    uint64_t *cell;           // by Var.index: the value as a bit cell (engine.h)
    uint8_t *stored;          // by Var.index: 1 if the last step stored the variable
    RefWindows windows;
    const State *state;       // the state that the next step runs
    bool is_first;            // the next step is the first of its state
    bool has_run;             // a step has run since init
    uint64_t last_g;          // G at the last step that ran
    uint64_t start;           // G at the first step of `state`, from which T counts
    const Stmt *transition;   // the transition that the last step took, or NULL
    RefObserver *observer;    // NULL: none
} RefEngine;

#endif
