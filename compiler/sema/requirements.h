// SPDX-License-Identifier: Apache-2.0
// Typed requirements (docs/requirements.md) of a machine or of an application: the checker's output for files without errors.  Conditions are
// expressions over the variables of the machine, and sample after its step.  Nothing changes them after the check.
#ifndef SMC_REQUIREMENTS_H
#define SMC_REQUIREMENTS_H

#include "compiler/sema/program.h"

typedef enum RequirementKind {
    REQUIREMENT_NEVER,        // never a
    REQUIREMENT_ALWAYS,       // always b; with a: always a implies b
    REQUIREMENT_BEFORE,       // never a before b
    REQUIREMENT_AFTER,        // never a after b without c
    REQUIREMENT_LEADS_TO      // always a leads to b within `within`
} RequirementKind;

typedef struct Requirement {
    RequirementKind kind;
    Str id, text;
    Span span;                // position of the id
    Expr *a, *b, *c;          // the conditions of the requirement, as RequirementKind names them; NULL: its kind has no such condition
    uint32_t machine[3];      // for a, b and c: 0, or if the condition names a state of an application's machine, 1 + the index of that
                              // machine. Such a condition is true only in ticks in which the machine steps
    uint64_t within;          // LEADS_TO: the time limit in units of G
} Requirement;

typedef struct Requirements {
    const Program *program;
    VEC(Requirement) at;      // the requirements of all files, in the order of the files
    Map by_id;                // id to Requirement
    Windows window;           // the windows that the conditions sample
} Requirements;

#endif
