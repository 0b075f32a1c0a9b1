// SPDX-License-Identifier: Apache-2.0
// A workload compiled in this process: images for the VM, and the reference interpreter as one of the rows.
#ifndef BENCH_ENGINES_H
#define BENCH_ENGINES_H

#include <stdbool.h>

#include "bytecode-vm/smvm.h"
#include "compiler/compile.h"
#include "compiler/script/engine.h"
#include "tests/bench/bench.h"

enum { LEVELS = 3 };

typedef struct CompiledWorkload {
    Session session;
    Program *program;
    Buf image[LEVELS];                  // at -O0, -O1, -O2, without a debug section
} CompiledWorkload;

// Reads and compiles a workload.  On failure it prints the error to standard error and ends the program.
void compile_workload(CompiledWorkload *c, const Workload *w);

// A machine on the VM, interpreted in place or decoded.
typedef struct VmRow {
    SmvmMachine m;
    SmVm *vm;                           // of `size` bytes
    uint32_t size;
    SmvmDecoded *decoded;               // of decoded_size bytes; NULL: in place
    uint32_t decoded_size;
} VmRow;

void vm_row_open(VmRow *v, CompiledWorkload *c, const Buf *image);
void vm_row_decode(VmRow *v, CompiledWorkload *c, void *sv);      // for steps on sv
void vm_row_init(void *vm_row, void *sv);

// The reference interpreter on a state vector in memory.
typedef struct Reference {
    Engine *engine;
    EngineStep answer;
    EngineWrite *write;                 // the elements that a step reads as inputs
    uint32_t inputs;
} Reference;

void reference_open(Reference *r, CompiledWorkload *c, size_t in_size);
void reference_init(void *reference, void *sv);

#endif
