// SPDX-License-Identifier: Apache-2.0
// A run of a script for smc why, whose machines are watched (watch.h).
#ifndef SMC_WHY_RUN_H
#define SMC_WHY_RUN_H

#include "compiler/script/script_run.h"
#include "compiler/script/why.h"
#include "compiler/script/why_near.h"
#include "compiler/script/why_words.h"

typedef struct WhyRun {
    Arena *arena;
    const Script *s;
    const ScriptOptions *given;       // the options of the caller of why_ask
    WhyQuestion q;            // the question
    ScriptOptions o;          // the options of this run
    Diags silent;             // receives the diagnostics of the run, which nothing shows
    ScriptRun run;
    Engine *engine;           // the engine of the run: the machine, or all machines of the application
    Engine **machine;         // by machine: the engine that runs it
    Watch **watch;            // by machine: what it did; NULL: the run is not watched
    WhyNear *near;            // by Stmt.number, for the machine of the question: how near each transition was; NULL: not recorded
    uint64_t last_g;          // G of the last step
    uint64_t g_before;        // G of the step before the last one
} WhyRun;

// Runs the script to the step that `q` names, or to its end.  wrap: replaces the engine of machine q->machine, or NULL; then the run is
// not watched.
void why_run(WhyRun *r, Arena *arena, const Script *s, const ScriptOptions *o, const WhyQuestion *q,
             Engine *(*wrap)(void *context, WhyRun *r, Engine *ref),
             void *context);

// Returns the Program of machine i.
const Program *why_program(const Program *p, size_t i);

// ---- why_change.c ----

typedef VEC(WhyChange) WhyChanges;

// Lists inputs that would each have changed the outcome of the step in which `r` ended: the transition that it takes, or with q.of the value of
// that variable after it.  With q.to, only outcomes that concern this state.  guard: the statements whose conditions are tried.  Returns false if not
// all values of parameters were tried, because each needs a run.
bool why_find_changes(const WhyRun *r, const WatchStmt *const *guard, size_t guards, WhyChanges *out);
// Returns the value that a change tries, in words: "above 825" if that is what it means.
const char *why_change_text(const WhyRun *r, const WhyChange *c);

#endif
