// SPDX-License-Identifier: Apache-2.0
// Facts about the variables of one function at one point of it.  Inside a function, its variables are numbered from 0: its slots, at most 64.
// Most points know the same as the beginning of the function, except for a few slots.  So an environment contains these alone, as an array that is
// changed in place.  It costs no memory after the function, unlike an Env, which is never changed.
#ifndef SMC_SLOT_ENV_H
#define SMC_SLOT_ENV_H

#include "compiler/facts/fact.h"

enum { FACT_SLOTS = 64 };             // most slots of a function: the bits of a set of slots

typedef struct SlotEnv SlotEnv;
struct SlotEnv {
    SlotEnv *next;                    // while the environment is free: the next one in the list SlotEnvs.unused
    uint64_t changed;                 // bit set of the slots whose facts are in `fact`; the others have the facts at the function's beginning
    Fact fact[];                      // by slot; valid only for slots in `changed`
};

typedef struct SlotEnvs {             // the environments of one function
    Arena *arena;
    uint32_t slots;              // number of slots of the function
    const Fact *begin;                // by slot: the facts at the beginning of the function
    uint64_t read;                    // bit set of the slots whose facts at the beginning have been read
    SlotEnv *unused;                  // list of freed environments, linked by `next`
} SlotEnvs;

SlotEnv *slot_env_new(SlotEnvs *s);                      // returns an environment with the facts at the beginning of the function
SlotEnv *slot_env_copy(SlotEnvs *s, const SlotEnv *e);
void slot_env_free(SlotEnvs *s, SlotEnv *e);
// Returns the fact about a slot, which is valid until the slot is set.
const Fact *slot_env_find(SlotEnvs *s, const SlotEnv *e, uint32_t slot);
void slot_env_set(SlotEnv *e, uint32_t slot, Fact fact);
// Changes *into to what is true on both of two paths, with the facts *into and *from.
void slot_env_join(SlotEnvs *s, SlotEnv *into, const SlotEnv *from);
// Whether both have the same bits for the same slots of the set.
bool slot_env_is_same(const SlotEnv *a, const SlotEnv *b, uint64_t set);

#endif
