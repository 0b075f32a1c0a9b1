// SPDX-License-Identifier: Apache-2.0
#include "tests/bench/wasm.h"

#ifndef BENCH_WASM3

bool wasm_open(Wasm *wasm, const char *folder, const Workload *w) { (void)wasm; (void)folder; (void)w; return false; }
void wasm_init(void *wasm, void *sv) { (void)wasm; (void)sv; }
void wasm_bring(Wasm *wasm, const void *in, size_t n) { (void)wasm; (void)in; (void)n; }
void wasm_drive(void *wasm, void *sv, const void *in, size_t n) { (void)wasm; (void)sv; (void)in; (void)n; }
void wasm_close(Wasm *wasm) { (void)wasm; }

#else

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "wasm3.h"

#if defined(__GNUC__)
#define NOINLINE __attribute__((noinline))    // by its name valgrind finds it
#else
#define NOINLINE
#endif

enum { STACK = 64 * 1024, MOST_CODE = 1 << 20 };

static void must(const char *what, const char *error)
{
    if (error) {
        fprintf(stderr, "bench: wasm3: %s: %s\n", what, error);
        exit(2);
    }
}

static IM3Function function(const Wasm *wasm, const char *name)
{
    IM3Function f = NULL;

    must(name, m3_FindFunction(&f, wasm->runtime, name));
    return f;
}

static uint32_t address(const Wasm *wasm, const char *name)
{
    const IM3Function f = function(wasm, name);
    uint32_t at = 0;

    must(name, m3_CallV(f));
    must(name, m3_GetResultsV(f, &at));
    return at;
}

static uint8_t *memory(const Wasm *wasm, uint32_t at, size_t n)
{
    uint32_t size = 0;
    uint8_t *m = m3_GetMemory(wasm->runtime, &size, 0);

    must("memory", at > size || n > size - at ? "too small" : NULL);
    return m + at;
}

static uint32_t read_module(Wasm *wasm, const char *folder)
{
    char path[400];
    size_t n;
    FILE *f;

    snprintf(path, sizeof path, "%s/gen/%s.wasm", folder, wasm->w->name);
    f = fopen(path, "rb");
    must(path, f ? NULL : "cannot be read");
    wasm->code = malloc(MOST_CODE);
    n = fread(wasm->code, 1, MOST_CODE, f);
    fclose(f);
    return (uint32_t)n;
}

bool wasm_open(Wasm *wasm, const char *folder, const Workload *w)
{
    IM3Module module = NULL;
    uint32_t n;

    wasm->w = w;
    n = read_module(wasm, folder);
    wasm->environment = m3_NewEnvironment();
    wasm->runtime = m3_NewRuntime(wasm->environment, STACK, NULL);
    must("parse", m3_ParseModule(wasm->environment, &module, wasm->code, n));
    must("load", m3_LoadModule(wasm->runtime, module));
    wasm->in = address(wasm, "in");
    wasm->sv = address(wasm, "sv");
    wasm->init = function(wasm, "init");
    wasm->drive = function(wasm, "drive");
    return true;
}

static void take(const Wasm *wasm, void *sv) { memcpy(sv, memory(wasm, wasm->sv, wasm->w->sv_size), wasm->w->sv_size); }

void wasm_init(void *self, void *sv)
{
    Wasm *wasm = self;

    must("init", m3_CallV(wasm->init));
    take(wasm, sv);
}

void wasm_bring(Wasm *wasm, const void *in, size_t n)
{
    const size_t size = n * wasm->w->in_size;

    memcpy(memory(wasm, wasm->in, size), in, size);
    wasm->next = 0;
}

static NOINLINE void drive_wasm(const Wasm *wasm, uint32_t n) { must("drive", m3_CallV(wasm->drive, wasm->next, wasm->next + n)); }

void wasm_drive(void *self, void *sv, const void *in, size_t n)
{
    Wasm *wasm = self;

    (void)in;
    drive_wasm(wasm, (uint32_t)n);
    wasm->next += (uint32_t)n;
    take(wasm, sv);
}

void wasm_close(Wasm *wasm)
{
    m3_FreeRuntime(wasm->runtime);
    m3_FreeEnvironment(wasm->environment);
    free(wasm->code);
}

#endif
