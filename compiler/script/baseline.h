// SPDX-License-Identifier: Apache-2.0
// The runs of scripts without any change, with which runs of changed machines, with faulty sensors or with other parameters are compared.
//
// 1. A script that fails by itself shows nothing about a change.  It is left out.
// 2. A requirement that a run violates by itself is not judged in the changed runs of that script.  The rest of the script counts.
#ifndef SMC_BASELINE_H
#define SMC_BASELINE_H

#include "compiler/script/script.h"

typedef struct BaselineRun {
    const char *name;         // name of the script's file
    const char *why;          // why the script is left out, as a phrase with the script as its subject: "fails at tank.ss:9"; NULL: it counts
    const uint8_t *ignored;   // ScriptOptions.ignored of the changed runs: the requirements that this run violates; NULL: none
} BaselineRun;

typedef struct Baseline {
    Arena *arena;
    const Requirements *requirements;         // judged in the runs; NULL: none
    VEC(BaselineRun) run;
    uint32_t left_out, ignoring;      // number of scripts that are left out; of others in which a requirement is not judged
} Baseline;

void baseline_init(Baseline *b, Arena *arena, const Requirements *rq);
// Adds the run of the next script, which neither a change nor a violation has ended.  s: NULL if it does not compile; r is not read then.
// Returns whether the script counts.
bool baseline_add(Baseline *b, const char *name, const Script *s, const ScriptResult *r);
// Whether every script counts, with all requirements.
bool baseline_is_complete(const Baseline *b);
// Appends lines that name what is left out and what is not judged; nothing if it is complete.
void baseline_write_text(const Baseline *b, Buf *out);
// Appends the same as two members of a JSON object, each after a comma; nothing if it is complete.
void baseline_write_json(const Baseline *b, Buf *out);
// Calls `add` with each of these lines as a sentence.
void baseline_list(const Baseline *b, void *context, void (*add)(void *context, const char *sentence));

#endif
