// SPDX-License-Identifier: Apache-2.0
// Requirements of an application that one of its machines decides alone (requirements.md, "Proofs").
//
// A proof about a machine is about all runs in which anything writes its inputs, so about those in the application, too.  It carries over if every
// tick of the application is a step of the machine and the requirement reads only what this machine stores: then each judgement in the application is
// one after a step of the machine.  An input could change between the step and the end of the tick, so a requirement that reads one is not decided.
//
// A violation does not carry over: the other machines may never write what it needs.
#ifndef SMC_PROVE_APP_H
#define SMC_PROVE_APP_H

#include "compiler/sema/requirements.h"

// Returns the index of the machine that decides requirement i of an application; SIZE_MAX: none, and *why is the reason, a clause after "because".
size_t prove_find_machine(Arena *arena, const Requirements *all, size_t i, const char **why);
// Returns the requirements i with decider[i] == machine as requirements of that machine.  decider: by requirement, from prove_find_machine.
const Requirements *prove_of_machine(Arena *arena, const Requirements *all, const size_t *decider, size_t machine);

#endif
