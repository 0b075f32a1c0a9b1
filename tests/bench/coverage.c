// SPDX-License-Identifier: Apache-2.0
// Measures what coverage costs: workloads on the engines of smc test, the VM and the machine that counts, in short runs that alternate, with the
// same inputs.  The goal is half of the VM's speed.
//
//     coverage [WORKLOAD]...
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "compiler/cover/cover.h"
#include "tests/bench/engines.h"

#define ADDRESS_OF(w) &workload_##w,
static const Workload *const workloads[] = {EACH_WORKLOAD(ADDRESS_OF)};
enum { WORKLOADS = sizeof workloads / sizeof workloads[0], ROUNDS = 15, SV_WORDS = 64 };

typedef enum EngineRow { ROW_VM, ROW_COUNTING, ROW_FLAT, ENGINE_ROWS } EngineRow;

static const char *const row_name[] = {"VM", "with coverage", "the same without counters"};

static uint64_t sv[SV_WORDS];

static double seconds(void) { return (double)clock() / CLOCKS_PER_SEC; }

// Opens the VM on an image as smc test makes it: with names, at -O2.
static Engine *open_vm(CompiledWorkload *c)
{
    const ImageOptions options = {true, NULL};
    IrMachine *m = session_ir(&c->session, c->program, 2);
    Engine *e = NULL;
    const char *error = "the image cannot be built";
    Buf image;

    buf_init(&image, &c->session.arena);
    if (session_image(&c->session, &m, 1, &options, &image))
        e = engine_vm_open(&c->session.arena, c->program, (const uint8_t *)image.at, image.n, 0, &error);
    if (!e) {
        fprintf(stderr, "coverage: %s\n", error);
        exit(2);
    }
    return e;
}

// Returns the nanoseconds of a step in one episode, and the outputs after it.
static double run_episode(Reference *r, const Workload *w, const uint8_t *in, uint8_t *end)
{
    double took;

    memset(sv, 0, sizeof sv);
    reference_init(r, sv);
    w->drive_ref(r, sv, in, w->warm);
    took = -seconds();
    w->drive_ref(r, sv, in + (size_t)w->warm * w->in_size, w->steps - w->warm);
    took += seconds();
    memcpy(end, sv, w->sv_size);
    return took * 1e9 / (w->steps - w->warm);
}

static int compare(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;

    return x < y ? -1 : x > y;
}

// Measures a workload.  Returns whether all engines had the same outputs.
static bool measure(const Workload *w)
{
    CompiledWorkload *c = calloc(1, sizeof *c);
    const size_t size = (size_t)w->steps * w->in_size;
    uint8_t *in = calloc(EPISODES, size), end[ENGINE_ROWS][SV_WORDS * 8];
    double ns[ENGINE_ROWS][ROUNDS];
    Rng random = {UINT64_C(0x9e3779b97f4a7c15)};
    Reference row[ENGINE_ROWS];
    bool same = true;

    compile_workload(c, w);
    for (unsigned e = 0; e < EPISODES; e++)
        w->inputs(&random, in + e * size, w->steps, e);
    for (int i = 0; i < ENGINE_ROWS; i++)
        reference_open(&row[i], c, w->in_size);
    row[ROW_VM].engine = open_vm(c);
    row[ROW_COUNTING].engine = cover_open_engine(cover_new(&c->session.arena, c->program));
    row[ROW_FLAT].engine = engine_flat_open(&c->session.arena, c->program, flat_new(&c->session.arena, ir_build(&c->session.arena, c->program), NULL));
    for (unsigned k = 0; k < ROUNDS; k++) {
        for (int i = 0; i < ENGINE_ROWS; i++)
            ns[i][k] = run_episode(&row[i], w, in + k % EPISODES * size, end[i]);
        same = same && memcmp(end[ROW_VM], end[ROW_COUNTING], w->sv_size) == 0 && memcmp(end[ROW_VM], end[ROW_FLAT], w->sv_size) == 0;
    }
    printf("%-10s", w->name);
    for (int i = 0; i < ENGINE_ROWS; i++) {
        qsort(ns[i], ROUNDS, sizeof ns[i][0], compare);
        printf("  %s %.0f ns", row_name[i], ns[i][ROUNDS / 2]);
    }
    printf("  speed with coverage: %.2f of the VM's%s\n", ns[ROW_VM][ROUNDS / 2] / ns[ROW_COUNTING][ROUNDS / 2], same ? "" : "  OUTPUTS DIFFER");
    session_free(&c->session);
    free(in);
    free(c);
    return same;
}

static bool is_wanted(const char *name, int argc, char **argv)
{
    bool wanted = argc < 2;

    for (int i = 1; i < argc; i++)
        wanted = wanted || strcmp(argv[i], name) == 0;
    return wanted;
}

int main(int argc, char **argv)
{
    bool same = true;

    for (int i = 0; i < WORKLOADS; i++)
        if (is_wanted(workloads[i]->name, argc, argv))
            same = measure(workloads[i]) && same;
    return !same;
}
