// SPDX-License-Identifier: Apache-2.0
// A machine compiled from text to an image with names, and its memory in the VM.
#ifndef SM_SWAP_MACHINE_H
#define SM_SWAP_MACHINE_H

#include "bytecode-vm/image.h"
#include "bytecode-vm/swap.h"
#include "compiler/session.h"
#include "compiler/script/engine_ref.h"

typedef struct SwapMachine {
    Session session;
    const Program *program;
    IrMachine *ir;
    const uint8_t *image;
    uint32_t image_size;
    SmvmMachine m;
    SmVm *vm;                 // smvm_ram_size(&m) bytes
    uint32_t ram;
    void *decoded_memory;
    SmvmDecoded *decoded;
} SwapMachine;

// Builds the image of a program that s->session has compiled, and allocates its memory.  Returns false if there is no image.
bool machine_build(SwapMachine *s, int opt_level, bool names);
// Compiles a machine and builds its image.  `sv` may be NULL.  An error ends the test.
void machine_compile(SwapMachine *s, const char *sm, const char *sv, int opt_level, bool names);
// Starts the machine in `state`.  Without a state vector, only prepares it.
SmResult machine_start(SwapMachine *s, void *sv, uint32_t state);
SmResult machine_decode(SwapMachine *s, void *sv);
void machine_free(SwapMachine *s);

// Returns a plan in memory of exactly its size, which the caller frees.  Returns NULL on failure; *result is the reason.
SmvmSwap *machine_plan(const SwapMachine *from, const SwapMachine *to, SmResult *result);

// Continues `from` in `to` with the reference interpreter, by the names and expressions of the programs.  Returns false, and changes nothing, if
// `to` has no state with that name.  `from_has` and `to_has`, by window: whether the image contains it.
bool reference_continue(const RefEngine *from, RefEngine *to, const bool *from_has, const bool *to_has);
void reference_restart(const RefEngine *from, RefEngine *to, uint32_t state);
// Returns for each window of the program whether the image contains it under a name.
const bool *machine_windows(SwapMachine *s);

#endif
