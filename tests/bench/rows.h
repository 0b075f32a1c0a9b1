// SPDX-License-Identifier: Apache-2.0
// The rows of a workload.  Each has its own loop: as in a user's program, the loop calls the step directly, and the compiler knows the size of
// the data that it copies.
#ifndef BENCH_ROWS_H
#define BENCH_ROWS_H

#include <stdlib.h>
#include <string.h>

#include "bytecode-vm/smvm.h"
#include "tests/bench/bench.h"

// The fields of a Workload that its name determines.
#define WORKLOAD(w, W)                                                                                         \
    .name = #w, .in_size = sizeof(W##In), .sv_size = sizeof(W##Sv), .inputs = inputs, WORKLOAD_DRIVES

#ifndef __wasm__
#define WORKLOAD_DRIVES .row = row, .drive_in_place = drive_in_place, .drive_decoded = drive_decoded, .drive_ref = drive_ref

#if defined(__GNUC__)
#define NOINLINE __attribute__((noinline))    // by its name valgrind finds it
#else
#define NOINLINE
#endif

#define DRIVE(name, In, Sv, Machine, step)                                                                     \
    static NOINLINE void drive_##name(void *machine, void *vector, const void *inputs, size_t n)               \
    {                                                                                                          \
        Machine *m = machine;                                                                                  \
        Sv *sv = vector;                                                                                       \
        const In *in = inputs;                                                                                 \
        for (; n > 0; n--, in++) {                                                                             \
            memcpy(sv, in, sizeof *in);                                                                        \
            step(m, sv);                                                                                       \
        }                                                                                                      \
    }

#define BY_HAND(name, In, Sv, Machine, function)                                                               \
    static void init_##name(void *m, void *sv) { function##_init(m, sv); }                                     \
    DRIVE(name, In, Sv, Machine, function##_step)

#define EMITTED(name, In, Sv, Machine, function)                                                               \
    static void init_##name(void *m, void *sv)                                                                 \
    {                                                                                                          \
        if (function##_init(m, sv, 1) != 0)                                                                    \
            abort();                                                                                           \
    }                                                                                                          \
    DRIVE(name, In, Sv, Machine, function##_step)

// Defines all rows of workload w.  W is the name in the types of its machine.
#define WORKLOAD_ROWS(w, W)                                                                                    \
    static void init_empty(void *m, void *sv) { bench_nothing(m, sv); }                                        \
    DRIVE(empty, W##In, W##Sv, void, bench_nothing)                                                            \
    BY_HAND(native, W##In, W##Sv, W##Native, w##_native)                                                       \
    BY_HAND(f64, W##In, W##Sv, W##F64, w##_f64)                                                                \
    EMITTED(c_o0, W##In, W##Sv, W##O0, w##_o0)                                                                 \
    EMITTED(c_o1, W##In, W##Sv, W##O1, w##_o1)                                                                 \
    EMITTED(c_o2, W##In, W##Sv, W##O2, w##_o2)                                                                 \
    EMITTED(c_os, W##In, W##Sv, W##Os, w##_os)                                                                 \
    DRIVE(in_place, W##In, W##Sv, SmVm, smvm_step)                                                             \
    DRIVE(decoded, W##In, W##Sv, SmvmDecoded, smvm_step_decoded)                                               \
    DRIVE(ref, W##In, W##Sv, void, bench_reference_step)                                                       \
    static const Row row[ROWS] = {                                                                             \
        {"empty", 0, init_empty, drive_empty, 0},                                                              \
        {"native", sizeof(W##Native), init_native, drive_native, 0},                                           \
        {"f64", sizeof(W##F64), init_f64, drive_f64, 1},                                                       \
        {"c-O0", sizeof(W##O0), init_c_o0, drive_c_o0, 1},                                                     \
        {"c-O1", sizeof(W##O1), init_c_o1, drive_c_o1, 1},                                                     \
        {"c-O2", sizeof(W##O2), init_c_o2, drive_c_o2, 1},                                                     \
        {"c-Os", sizeof(W##Os), init_c_os, drive_c_os, 1},                                                     \
    };

#else
// The row `wasm3`: `f64` with a loop in WebAssembly, on inputs that are in its memory already (wasm.c).
#define WORKLOAD_DRIVES .row = NULL
#define EXPORT(name) __attribute__((export_name(#name)))

#define WORKLOAD_ROWS(w, W)                                                                                    \
    static W##In wasm_in[MOST_STEPS];                                                                          \
    static W##Sv wasm_sv;                                                                                      \
    static W##F64 wasm_machine;                                                                                \
    EXPORT(in) void *in_(void) { return wasm_in; }                                                             \
    EXPORT(sv) void *sv_(void) { return &wasm_sv; }                                                            \
    EXPORT(init) void init_(void)                                                                              \
    {                                                                                                          \
        memset(&wasm_sv, 0, sizeof wasm_sv);                                                                   \
        w##_f64_init(&wasm_machine, &wasm_sv);                                                                 \
    }                                                                                                          \
    EXPORT(drive) void drive_(unsigned from, unsigned to)                                                      \
    {                                                                                                          \
        for (; from < to; from++) {                                                                            \
            memcpy(&wasm_sv, &wasm_in[from], sizeof wasm_in[from]);                                            \
            w##_f64_step(&wasm_machine, &wasm_sv);                                                             \
        }                                                                                                      \
    }
#endif

#endif
