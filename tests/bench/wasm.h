// SPDX-License-Identifier: Apache-2.0
// The row `wasm3`: FOLDER/gen/WORKLOAD.wasm, run by the interpreter wasm3 if the bench was built with it (README.md).
#ifndef BENCH_WASM_H
#define BENCH_WASM_H

#include <stdbool.h>

#include "tests/bench/bench.h"

typedef struct Wasm {
    const Workload *w;
    uint8_t *code;
    void *environment, *runtime;
    void *init, *drive;                 // functions of the module
    uint32_t in, sv;                    // addresses in its memory
    uint32_t next;                      // the number of the next input
} Wasm;

bool wasm_open(Wasm *wasm, const char *folder, const Workload *w);         // false: without wasm3
void wasm_init(void *wasm, void *sv);
void wasm_bring(Wasm *wasm, const void *in, size_t n);                     // the inputs of the following drives into its memory
void wasm_drive(void *wasm, void *sv, const void *in, size_t n);           // n of those inputs, wherever `in` is
void wasm_close(Wasm *wasm);

#endif
