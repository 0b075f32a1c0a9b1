// SPDX-License-Identifier: Apache-2.0
// Measures the cost of a step: every workload on every row, in short runs that alternate, with the same inputs.
//
//     steps FOLDER check [WORKLOAD]...       checks that all rows have the outputs of the reference
//     steps FOLDER time SECONDS WORKLOAD     prints "time" records to standard output
//     steps FOLDER count WORKLOAD            under callgrind: drives each row twice, of which the second is counted; prints names and steps
//     steps FOLDER inputs WORKLOAD           writes FOLDER/WORKLOAD.count, one episode for a Lua under callgrind
//     steps FOLDER sizes WORKLOAD            prints "value" records
//
// Files are written in FOLDER.  A record is a line of words that report.awk reads.
#define _POSIX_C_SOURCE 200809L
#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "stdlib/convert.h"
#include "tests/bench/engines.h"
#include "tests/bench/lua.h"
#include "tests/bench/wasm.h"

#define ADDRESS_OF(w) &workload_##w,
static const Workload *const workloads[] = {EACH_WORKLOAD(ADDRESS_OF)};
enum { WORKLOADS = sizeof workloads / sizeof workloads[0] };

static const struct { const char *name, *command; } luas[] = {
    {"lua", "lua5.4"}, {"luajit-int", "luajit -joff"}, {"luajit", "luajit"},
};
enum { LUAS = sizeof luas / sizeof luas[0] };

// ---- runners: rows of all kinds made alike ----

enum { ROUNDS = 2000, MANY = 32, SV_WORDS = 64 };

typedef struct Runner {
    const char *name;
    int exact;
    size_t size;
    void (*init)(void *self, void *sv);
    void (*drive)(void *machine, void *sv, const void *in, size_t n);
    void *self, *machine;             // the arguments of init and of drive
    const VmRow *vm;                  // NULL: not a row of the VM
    Lua *lua;                         // NULL: not a row of Lua
    Wasm *wasm;                       // NULL: not a row of WebAssembly
    unsigned every;                   // the row is measured in one of this many rounds
    double ns[ROUNDS];                // nanoseconds per step, by round; below 0: not measured in that round
} Runner;

typedef struct Bench {
    const Workload *w;
    const char *folder;
    CompiledWorkload compiled;
    Reference reference;
    VmRow in_place[LEVELS], decoded[LEVELS];
    Lua lua[LUAS];
    Wasm wasm;
    uint8_t *in;                      // the inputs of all episodes
    Runner runner[MANY];
    unsigned runners;
    unsigned skipped, failed;         // number of Lua interpreters that are not installed; that do not run
    double asking;                    // seconds that one reading of the clock takes
} Bench;

static uint64_t sv[SV_WORDS];

static void *in_heap(size_t size)
{
    void *p = calloc(1, size > 0 ? size : 1);

    if (!p) {
        fprintf(stderr, "bench: out of memory\n");
        exit(2);
    }
    return p;
}

static Runner *add(Bench *b, const char *name, int exact)
{
    Runner *r = &b->runner[b->runners++];

    r->name = name;
    r->exact = exact;
    r->every = 1;
    return r;
}

static void add_rows(Bench *b)
{
    for (int i = 0; i < ROWS; i++) {
        const Row *row = &b->w->row[i];
        Runner *r = add(b, row->name, row->exact);
        r->size = row->size;
        r->init = row->init;
        r->drive = row->drive;
        r->self = r->machine = in_heap(row->size);
    }
}

static void add_in_place(Bench *b, const char *name, VmRow *vm, const Buf *image)
{
    Runner *r = add(b, name, 1);

    vm_row_open(vm, &b->compiled, image);
    r->init = vm_row_init;
    r->drive = b->w->drive_in_place;
    r->self = vm;
    r->machine = vm->vm;
    r->vm = vm;
}

static void add_decoded(Bench *b, const char *name, VmRow *vm, const Buf *image)
{
    Runner *r;

    add_in_place(b, name, vm, image);
    vm_row_decode(vm, &b->compiled, sv);
    r = &b->runner[b->runners - 1];
    r->drive = b->w->drive_decoded;
    r->machine = vm->decoded;
}

static void add_vms(Bench *b)
{
    static const char *const in_place[LEVELS] = {"in-place-O0", "in-place-O1", "in-place-O2"};
    static const char *const decoded[LEVELS] = {"decoded-O0", "decoded-O1", "decoded-O2"};

    for (int level = 0; level < LEVELS; level++)
        add_in_place(b, in_place[level], &b->in_place[level], &b->compiled.image[level]);
    for (int level = 0; level < LEVELS; level++)
        add_decoded(b, decoded[level], &b->decoded[level], &b->compiled.image[level]);
}

static void add_reference(Bench *b)
{
    Runner *r = add(b, "ref", 1);

    reference_open(&b->reference, &b->compiled, b->w->in_size);
    r->init = reference_init;
    r->drive = b->w->drive_ref;
    r->self = r->machine = &b->reference;
}

static void add_wasm(Bench *b)
{
    Runner *r;

    if (!wasm_open(&b->wasm, b->folder, b->w))
        return;
    r = add(b, "wasm3", 1);
    r->init = wasm_init;
    r->drive = wasm_drive;
    r->self = r->machine = r->wasm = &b->wasm;
}

// ---- inputs ----

static const void *input(const Bench *b, unsigned episode, unsigned step)
{
    return b->in + ((size_t)episode * b->w->steps + step) * b->w->in_size;
}

static void make_inputs(Bench *b)
{
    Rng r = {UINT64_C(0x9e3779b97f4a7c15)};

    b->in = in_heap((size_t)EPISODES * b->w->steps * b->w->in_size);
    for (unsigned e = 0; e < EPISODES; e++)
        b->w->inputs(&r, (void *)(b->in + (size_t)e * b->w->steps * b->w->in_size), b->w->steps, e);
}

static int is_input(const Bench *b, const Element *e) { return e->offset < b->w->in_size; }

static double value(const Element *e, const void *vector)
{
    return sm_load(e->type, (const uint8_t *)vector + e->offset);
}

static void print_names(const Bench *b, FILE *f, int of_inputs, int types)
{
    const StateVec *v = b->compiled.program->sv;

    for (size_t i = 0; i < v->element.n; i++)
        if (is_input(b, v->element.at[i]) == of_inputs)
            fprintf(f, "%s ", types ? sm_type_info[v->element.at[i]->type].spelling : v->element.at[i]->name->text);
    fputs("\n", f);
}

// Writes inputs in the form that driver.lua reads.
static void write_inputs(const Bench *b, const char *path, unsigned episodes)
{
    const StateVec *v = b->compiled.program->sv;
    size_t inputs = 0;
    FILE *f = fopen(path, "w");

    if (!f) {
        fprintf(stderr, "bench: cannot write %s\n", path);
        exit(2);
    }
    for (size_t i = 0; i < v->element.n; i++)
        inputs += (size_t)is_input(b, v->element.at[i]);
    fprintf(f, "%zu %zu %u %u %u\n", inputs, v->element.n - inputs, episodes, b->w->steps, b->w->warm);
    print_names(b, f, 1, 0);
    print_names(b, f, 1, 1);
    print_names(b, f, 0, 0);
    for (unsigned i = 0; i < episodes * b->w->steps; i++) {
        for (size_t k = 0; k < inputs; k++)
            fprintf(f, "%.17g ", value(v->element.at[k], input(b, 0, i)));
        fputs("\n", f);
    }
    fclose(f);
}

static void add_luas(Bench *b, unsigned episodes)
{
    char path[400];

    snprintf(path, sizeof path, "%s/%s.inputs", b->folder, b->w->name);
    write_inputs(b, path, episodes);
    for (int i = 0; i < LUAS; i++) {
        const LuaIs is = lua_open(&b->lua[i], luas[i].command, b->w->name, path);
        if (is == LUA_HERE)
            add(b, luas[i].name, 0)->lua = &b->lua[i];
        else
            fprintf(stderr, "%s: %s %s\n", b->w->name, luas[i].command, is == LUA_ABSENT ? "is not here: skipped" : "does not run");
        b->skipped += is == LUA_ABSENT;
        b->failed += is == LUA_BROKEN;
    }
}

static Bench *begin(const char *folder, const Workload *w)
{
    Bench *b = in_heap(sizeof *b);

    b->w = w;
    b->folder = folder;
    compile_workload(&b->compiled, w);
    make_inputs(b);
    add_rows(b);
    add_vms(b);
    add_reference(b);
    add_wasm(b);
    return b;
}

static void end(Bench *b)
{
    for (unsigned i = 0; i < b->runners; i++)
        if (b->runner[i].lua)
            lua_close(b->runner[i].lua);
    wasm_close(&b->wasm);
    session_free(&b->compiled.session);
    free(b->in);
    for (int i = 0; i < ROWS; i++)
        free(b->runner[i].machine);
    free(b);
}

static void start(const Runner *r)
{
    memset(sv, 0, sizeof sv);
    r->init(r->self, sv);
}

// Copies inputs that the row needs in another memory, before the clock starts.
static void prepare_inputs(const Runner *r, const void *in, size_t n)
{
    if (r->wasm)
        wasm_bring(r->wasm, in, n);
}

// ---- whether they all do the same ----

// Returns the state vector after each step of an episode, as this row computes it.
static uint8_t *trace(const Bench *b, const Runner *r, unsigned episode, unsigned steps)
{
    uint8_t *at = in_heap(steps * b->w->sv_size);

    start(r);
    for (unsigned i = 0; i < steps; i++) {
        prepare_inputs(r, input(b, episode, i), 1);
        r->drive(r->machine, sv, input(b, episode, i), 1);
        memcpy(at + i * b->w->sv_size, sv, b->w->sv_size);
    }
    return at;
}

// The same for a row of Lua.
static uint8_t *trace_lua(const Bench *b, const Runner *r, unsigned episode, unsigned steps)
{
    const StateVec *v = b->compiled.program->sv;
    uint8_t *at = in_heap(steps * b->w->sv_size);
    char line[500], path[400], answer[20];
    FILE *f;
    double x;

    snprintf(path, sizeof path, "%s/%s.outputs", b->folder, b->w->name);
    snprintf(line, sizeof line, "check %u %u %s", episode, steps, path);
    if (!lua_ask(r->lua, answer, sizeof answer, line) || !(f = fopen(path, "r")))
        return at;
    for (unsigned i = 0; i < steps; i++)
        for (size_t k = 0; k < v->element.n; k++)
            if (!is_input(b, v->element.at[k]) && fscanf(f, "%lf", &x) == 1)
                sm_store(v->element.at[k]->type, at + i * b->w->sv_size + v->element.at[k]->offset, x);
    fclose(f);
    return at;
}

static int same(const Element *e, const void *a, const void *b, int exact)
{
    const double x = value(e, a), y = value(e, b);

    if (exact || (e->type != SM_F32 && e->type != SM_F64))
        return memcmp((const uint8_t *)a + e->offset, (const uint8_t *)b + e->offset, sm_type_info[e->type].bytes) == 0;
    return fabs(x - y) <= 1e-4 + 1e-5 * fabs(x);
}

static int differs(const Bench *b, const Runner *r, const uint8_t *expected, const uint8_t *got, unsigned steps)
{
    const StateVec *v = b->compiled.program->sv;

    for (unsigned i = 0; i < steps; i++)
        for (size_t k = 0; k < v->element.n; k++) {
            const Element *e = v->element.at[k];
            const size_t at = i * b->w->sv_size;
            if (!is_input(b, e) && !same(e, expected + at, got + at, r->exact)) {
                fprintf(stderr, "%s: %s: step %u: %s is %.17g, not %.17g\n", b->w->name, r->name, i + 1, e->name->text,
                        value(e, got + at), value(e, expected + at));
                return 1;
            }
        }
    return 0;
}

static int checks(const Bench *b, const Runner *r, const uint8_t *expected, unsigned episode)
{
    uint8_t *got = r->lua ? trace_lua(b, r, episode, b->w->check) : trace(b, r, episode, b->w->check);
    const int bad = differs(b, r, expected, got, b->w->check);

    free(got);
    return bad;
}

static const Runner *find(const Bench *b, const char *name)
{
    for (unsigned i = 0; i < b->runners; i++)
        if (strcmp(b->runner[i].name, name) == 0)
            return &b->runner[i];
    return NULL;
}

// Returns the number of rows that fail.  Adds the number of the others to *passed.
static unsigned check_all(const Bench *b, unsigned episode, unsigned *passed)
{
    uint8_t *expected = trace(b, find(b, "ref"), episode, b->w->check);
    unsigned failed = 0;

    for (unsigned i = 0; i < b->runners; i++)
        if (strcmp(b->runner[i].name, "empty") != 0 && strcmp(b->runner[i].name, "ref") != 0) {
            const int bad = checks(b, &b->runner[i], expected, episode);
            failed += (unsigned)bad;
            *passed += !bad;
        }
    free(expected);
    return failed;
}

static void check(const char *folder, const Workload *w, unsigned *passed, unsigned *failed, unsigned *skipped)
{
    Bench *b = begin(folder, w);

    add_luas(b, w->other + 1);
    *failed += check_all(b, 0, passed) + b->failed;
    if (w->other != 0)
        *failed += check_all(b, w->other, passed);
    *skipped += b->skipped;
    end(b);
}

// ---- time ----

static double seconds(clockid_t clock)
{
    struct timespec t;

    clock_gettime(clock, &t);
    return (double)t.tv_sec + (double)t.tv_nsec * 1e-9;
}

static double wall(void) { return seconds(CLOCK_MONOTONIC); }
static double cpu(void) { return seconds(CLOCK_PROCESS_CPUTIME_ID); }  // of this process: it excludes the time of other processes on the core

// Returns the cost of reading the clock, which is part of every run.
static double cost_of_asking(void)
{
    double least = 1, took;

    for (int i = 0; i < 1000; i++) {
        took = -cpu();
        took += cpu();
        least = took < least ? took : least;
    }
    return least;
}

static double lua_seconds(const Runner *r, unsigned episode)
{
    char line[40], answer[40];

    snprintf(line, sizeof line, "run %u", episode);
    return lua_ask(r->lua, answer, sizeof answer, line) ? strtod(answer, NULL) : -1;
}

// Returns nanoseconds per step.
static double sample(const Bench *b, const Runner *r, unsigned episode)
{
    const unsigned n = b->w->steps - b->w->warm;
    double took;

    if (r->lua)
        return lua_seconds(r, episode) * 1e9 / n;
    start(r);
    prepare_inputs(r, input(b, episode, 0), b->w->steps);
    r->drive(r->machine, sv, input(b, episode, 0), b->w->warm);
    took = -cpu();
    r->drive(r->machine, sv, input(b, episode, b->w->warm), n);
    took += cpu();
    return (took - b->asking) * 1e9 / n;
}

// Slow rows are measured in fewer rounds, to leave time for the others.  `every` is odd, so that each row is measured in every episode.
static void set_pace(Bench *b)
{
    b->asking = cost_of_asking();
    for (unsigned i = 0; i < b->runners; i++) {
        const double ns = sample(b, &b->runner[i], 0) * b->w->steps;
        b->runner[i].every = 1 + 2 * (unsigned)(ns / 4e6);
    }
}

static unsigned run_rounds(Bench *b, double time)
{
    const double before = wall();
    unsigned round = 0;

    for (; round < ROUNDS && (round < 2 * EPISODES || wall() - before < time); round++)
        for (unsigned i = 0; i < b->runners; i++) {
            Runner *r = &b->runner[(round + i) % b->runners];
            r->ns[round] = round % r->every == 0 ? sample(b, r, round % EPISODES) : -1;
        }
    return round;
}

static int ascending(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;

    return (x > y) - (x < y);
}

typedef struct Spread { double quarter, median, three_quarters; unsigned n; } Spread;

static Spread spread(const Runner *r, unsigned rounds)
{
    Spread s = {0, 0, 0, 0};
    double x[ROUNDS];

    for (unsigned i = 0; i < rounds; i++)
        if (r->ns[i] >= 0)
            x[s.n++] = r->ns[i];
    qsort(x, s.n, sizeof *x, ascending);
    s.quarter = x[s.n / 4];
    s.median = x[s.n / 2];
    s.three_quarters = x[s.n * 3 / 4];
    return s;
}

// Returns the best run of an episode, only from rounds in which the other row ran too: the best of many runs is not comparable to the best of
// few.  Below 0 if there was no such round.
static double best_of(const Runner *r, const Runner *other, unsigned episode, unsigned rounds)
{
    double least = -1;

    for (unsigned i = episode; i < rounds; i += EPISODES)
        if (r->ns[i] >= 0 && other->ns[i] >= 0 && (least < 0 || r->ns[i] < least))
            least = r->ns[i];
    return least;
}

// Returns the mean of these best runs over the episodes that both rows have run.
static double best(const Runner *r, const Runner *other, unsigned rounds)
{
    double sum = 0;
    unsigned n = 0;

    for (unsigned e = 0; e < EPISODES; e++) {
        const double ns = best_of(r, other, e, rounds);
        if (ns >= 0) {
            sum += ns;
            n++;
        }
    }
    return sum / n;
}

static double ratio(const Bench *b, const Runner *r, const char *to, unsigned rounds)
{
    const Runner *other = find(b, to);

    return best(r, other, rounds) / best(other, r, rounds);
}

static void print_time(const Bench *b, const Runner *r, unsigned rounds)
{
    const Spread s = spread(r, rounds);

    printf("time %s %s %.4g ", b->w->name, r->name, best(r, r, rounds));
    printf("%.4g %.4g %.4g %u ", s.quarter, s.median, s.three_quarters, s.n);
    printf("%.4g %.4g\n", ratio(b, r, "native", rounds), ratio(b, r, "f64", rounds));
}

static void measure(Bench *b, double time)
{
    unsigned rounds;

    set_pace(b);
    rounds = run_rounds(b, time);
    for (unsigned i = 0; i < b->runners; i++)
        print_time(b, &b->runner[i], rounds);
}

static int time_rows(const char *folder, double time, const Workload *w)
{
    Bench *b = begin(folder, w);
    unsigned passed = 0, bad;

    add_luas(b, EPISODES);
    bad = check_all(b, 0, &passed) + b->failed;
    if (bad == 0)
        measure(b, time);
    end(b);
    return bad != 0;
}

// ---- instructions ----

static int count(const char *folder, const Workload *w)
{
    Bench *b = begin(folder, w);

    for (unsigned i = 0; i < b->runners; i++) {
        Runner *r = &b->runner[i];
        start(r);
        prepare_inputs(r, input(b, 0, 0), w->steps);
        r->drive(r->machine, sv, input(b, 0, 0), w->warm);
        r->drive(r->machine, sv, input(b, 0, w->warm), w->count);
        printf("%s %s %u\n", w->name, r->name, w->count);
    }
    end(b);
    return 0;
}

static int inputs_only(const char *folder, const Workload *w)
{
    Bench *b = begin(folder, w);
    char path[400];

    snprintf(path, sizeof path, "%s/%s.count", folder, w->name);
    write_inputs(b, path, 1);
    end(b);
    return 0;
}

// ---- sizes ----

static void print_size(const Bench *b, const char *what, unsigned long bytes)
{
    printf("value %s %s %lu bytes\n", b->w->name, what, bytes);
}

static int sizes(const char *folder, const Workload *w)
{
    Bench *b = begin(folder, w);
    const VmRow *vm = &b->in_place[LEVELS - 1];

    print_size(b, "image-O0", (unsigned long)b->compiled.image[0].n);
    print_size(b, "image-O1", (unsigned long)b->compiled.image[1].n);
    print_size(b, "image-O2", (unsigned long)b->compiled.image[2].n);
    print_size(b, "ram-native", (unsigned long)find(b, "native")->size);
    print_size(b, "ram-f64", (unsigned long)find(b, "f64")->size);
    print_size(b, "ram-c-O2", (unsigned long)find(b, "c-O2")->size);
    print_size(b, "ram-vm-O2", vm->size);
    if (vm->m.windows == 0)
        print_size(b, "ram-vm-O2-beside-locals", vm->size - vm->m.locals);
    print_size(b, "ram-decoded-O2", b->decoded[LEVELS - 1].decoded_size);
    end(b);
    return 0;
}

// ---- the command ----

static const Workload *workload(const char *name)
{
    for (int i = 0; i < WORKLOADS; i++)
        if (strcmp(workloads[i]->name, name) == 0)
            return workloads[i];
    fprintf(stderr, "bench: there is no workload '%s'\n", name);
    exit(2);
}

static int check_some(const char *folder, char **names, int n)
{
    unsigned passed = 0, failed = 0, skipped = 0;

    for (int i = 0; i < n; i++)
        check(folder, workload(names[i]), &passed, &failed, &skipped);
    for (int i = 0; n == 0 && i < WORKLOADS; i++)
        check(folder, workloads[i], &passed, &failed, &skipped);
    if (skipped > 0)
        printf("bench: %u passed, %u failed, %u skipped\n", passed, failed, skipped);
    else
        printf("bench: %u passed, %u failed\n", passed, failed);
    return failed != 0;
}

int main(int argc, char **argv)
{
    const char *what = argc > 2 ? argv[2] : "";

    signal(SIGPIPE, SIG_IGN);
    if (strcmp(what, "check") == 0)
        return check_some(argv[1], argv + 3, argc - 3);
    if (strcmp(what, "time") == 0 && argc == 5)
        return time_rows(argv[1], strtod(argv[3], NULL), workload(argv[4]));
    if (strcmp(what, "count") == 0 && argc == 4)
        return count(argv[1], workload(argv[3]));
    if (strcmp(what, "inputs") == 0 && argc == 4)
        return inputs_only(argv[1], workload(argv[3]));
    if (strcmp(what, "sizes") == 0 && argc == 4)
        return sizes(argv[1], workload(argv[3]));
    fprintf(stderr, "usage: steps FOLDER check|time|count|inputs|sizes …; see its source\n");
    return 2;
}
