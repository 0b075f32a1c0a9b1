// SPDX-License-Identifier: Apache-2.0
// The engines by name, as --engine and the header `on` of a case name them, and a function that opens any of them.
#ifndef SMC_ENGINES_H
#define SMC_ENGINES_H

#include "compiler/session.h"

typedef enum EngineKind { ENGINE_REF, ENGINE_VM, ENGINE_VM_SOFT, ENGINE_C, ENGINE_C_SOFT, ENGINE_KINDS } EngineKind;

extern const char *const engine_name[ENGINE_KINDS];

// The engines of one program, in the order of EngineKind. They can be closed at any time, even twice.
typedef struct EngineSet {
    Engine *at[ENGINE_KINDS + 1];     // one entry more than there are kinds: for the engine that measures coverage
    size_t n;
    const char *error;        // the reason if engines_open has failed
} EngineSet;

// Sets of kinds are bits: 1u << kind.
unsigned engines_named(const char *name);             // comma-separated names; "all" means all but c-soft; 0: one name is unknown
unsigned engines_in_list(const char *list);           // returns the set of engines in a list such as `ref vm c`; other words are ignored
// Opens the engines of `which`. Returns false after a failure: set->error is the reason, and the set contains the engines opened before.
bool engines_open(EngineSet *set, Session *s, const Program *p, unsigned which, int opt_level);
void engines_close(EngineSet *set);

#endif
