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
    void *init, *drive;                 // the functions of the module
    uint32_t in, sv;                    // addresses in the memory of the module
    uint32_t next;                      // index of the next input
} Wasm;

bool wasm_open(Wasm *wasm, const char *folder, const Workload *w);         // returns false if the bench was built without wasm3
void wasm_init(void *wasm, void *sv);
void wasm_bring(Wasm *wasm, const void *in, size_t n);                     // copies the inputs of the next drives to the memory of the module
void wasm_drive(void *wasm, void *sv, const void *in, size_t n);           // steps n of those inputs; `in` is not read
void wasm_close(Wasm *wasm);

#endif
