// SPDX-License-Identifier: Apache-2.0
// Requirements of an application that one of its machines decides alone (requirements.md, "Proofs").
//
// A proof about a machine is about all runs in which anything writes its inputs, so about those in the application, too.  It carries over if every
// tick of the application is a step of the machine, no other machine writes the elements that it assigns, and the requirement reads only what this
// machine stores: then each judgement in the application is one after a step of the machine.  An input could change between the step and the end of
// the tick, so a requirement that reads one is not decided.
//
// A violation does not carry over: the other machines may never write what it needs.
#ifndef SMC_PROVE_APP_H
#define SMC_PROVE_APP_H

#include "compiler/prove/prove.h"

typedef struct ProveApp {
    Arena *arena;
    const Requirements *what; // of the application
    const Requirements **own; // by machine: the requirements that it decides, as requirements of its own; NULL: it decides none
    size_t *decider;          // by requirement: the machine that decides it; SIZE_MAX: none
    const char **why;         // by requirement: why no machine decides it, a clause after "because"; NULL: a machine does
    const ProveResult **of;   // by machine: the verdicts on `own`; NULL: prove_app_run has not decided them
} ProveApp;

ProveApp *prove_app_new(Arena *arena, const Requirements *what);
// Decides the requirements of a machine, which has some.  The application has the step and the first state: those of `o` are not used.
const ProveResult *prove_app_run(ProveApp *a, size_t machine, const ProveOptions *o);
// Returns the verdicts on all requirements of the application, in their order, from what prove_app_run has decided: PROVE_ALONE instead of
// PROVE_VIOLATED, and PROVE_INTERRUPTED without a machine that decides it.
const ProveResult *prove_app_verdicts(const ProveApp *a);
// Returns the verdict of its machine on requirement i; NULL: no machine decides it.
const ProveOf *prove_app_verdict(const ProveApp *a, size_t i);
// Appends the lines that support the verdict on requirement i.
void prove_app_write_reason(const ProveApp *a, size_t i, size_t indent, Buf *out);

#endif
