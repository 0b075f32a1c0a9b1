// SPDX-License-Identifier: Apache-2.0
// Measures the speed of the compiler: to bytecode, from memory to memory, with all warnings, as the command compiles.  Also measures a C
// compiler on the emitted C, and `smc test` on long scripts.  Prints "value" records to standard output.
//
//     compile CC FOLDER SMC      FOLDER: where files may be written; SMC: the command
#define _POSIX_C_SOURCE 200809L
#define _DEFAULT_SOURCE                   // for the fields of getrusage
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "tests/bench/shapes.h"

static double now(void) { return (double)clock() / CLOCKS_PER_SEC; }

// The cost of one compilation.  `memory` is in bytes.
typedef struct Cost { double seconds; unsigned lines; size_t memory; } Cost;

static bool compile(const Shape *shape, unsigned n, int level, Cost *cost)
{
    MachineInput in = {0};
    ImageOptions options = {false, NULL};
    IrMachine *m;
    jmp_buf oom;
    Session s;
    Buf image;
    Program *p;
    size_t source;

    pool_empty();
    session_init(&s, pool_alloc, NULL, &oom);
    if (setjmp(oom) != 0)
        return false;
    in.sm = shape_source(&s, "m.sm", shape->write, n);
    source = pool_used();
    cost->seconds = -now();
    p = session_program(&s, &in);
    s.warnings = 1u << DIAG_GROUP_ALL;                // as `smc build` without -W
    session_analyse(&s, p);
    m = session_ir(&s, p, level);
    buf_init(&image, &s.arena);
    if (!session_image(&s, &m, 1, &options, &image))
        return false;
    cost->seconds += now();
    cost->lines = in.sm->lines;
    cost->memory = pool_used() - source;
    return true;
}

// Returns the lowest cost of `tries` runs: other programs can only slow a run down.
static Cost best(const char *name, unsigned n, int level, int tries)
{
    const Shape *shape = shape_find(name);
    Cost least = {1e9, 0, 0}, cost;

    for (; tries > 0; tries--) {
        if (!compile(shape, n, level, &cost)) {
            fprintf(stderr, "compile: %s %u at -O%d does not compile\n", name, n, level);
            exit(1);
        }
        if (cost.seconds < least.seconds)
            least = cost;
    }
    return least;
}

static void throughput(void)
{
    for (int level = 0; level <= 2; level++) {
        const Cost c = best("states", 10000, level, 3);
        printf("value compile lines-O%d %.0f lines/s\n", level, c.lines / c.seconds);
        printf("value compile 10000-states-O%d %.3f s\n", level, c.seconds);
        printf("value compile 10000-states-memory-O%d %.0f MB\n", level, (double)c.memory / 1e6);
    }
}

static void growth(void)
{
    for (int level = 0; level <= 2; level++) {
        const Cost small = best("statements", 1000, level, 20), large = best("statements", 100000, level, 2);
        printf("value compile 1000-statements-O%d %.5f s\n", level, small.seconds);
        printf("value compile 100000-statements-O%d %.3f s\n", level, large.seconds);
        printf("value compile growth-of-100-times-O%d %.0f times\n", level, large.seconds / small.seconds);
    }
}

static void extremes(void)
{
    for (int level = 0; level <= 2; level += 2) {
        printf("value compile 16000-variables-O%d %.3f s\n", level, best("locals", 16000, level, 2).seconds);
        printf("value compile 1000-nested-O%d %.4f s\n", level, best("nested", 1000, level, 5).seconds);
    }
}

// Measures ordinary input of many kinds, with warnings, at the default level.
static void shapes_at_default(void)
{
    static const struct { const char *name; unsigned n; } ordinary[] = {
        {"mission", 2500}, {"guards", 10000}, {"conditionals", 20000}, {"elements", 8000}, {"windows", 4000},
    };

    for (size_t i = 0; i < sizeof ordinary / sizeof ordinary[0]; i++) {
        const Cost c = best(ordinary[i].name, ordinary[i].n, 2, 3);
        printf("value compile lines-%s-O2 %.0f lines/s\n", ordinary[i].name, c.lines / c.seconds);
    }
}

// Sizes that could take minutes or all memory are reached in increasing sizes.  The next size is measured only if a quadratic increase would be
// acceptable.
#define ROOM 2.0                  // seconds
static const double room_memory = 400e6;

static void states_by_locals(void)
{
    const Shape *shape = shape_find("states_locals");
    Cost c = {0, 0, 0};
    unsigned n = 250;

    for (; n <= 2000 && c.seconds < ROOM && (double)c.memory < room_memory; n *= 2) {
        if (!compile(shape, n, 2, &c))
            break;
        printf("value compile %u-states-%u-locals-time %.3f s\n", n, n, c.seconds);
        printf("value compile %u-states-%u-locals-memory %.0f MB\n", n, n, (double)c.memory / 1e6);
    }
    if (n <= 2000)
        printf("note compile: %u states with %u locals would take too long: not measured\n", n, n);
}

// ---- the C compiler ----

static bool write_file(const char *path, const Buf *text)
{
    FILE *f = fopen(path, "w");

    return f && fwrite(buf_text(text), 1, text->n, f) == text->n && fclose(f) == 0;
}

static bool emit(const char *folder, unsigned states, int level)
{
    EmitCOptions options;
    MachineInput in = {0};
    Buf header, code;
    jmp_buf oom;
    Program *p;
    Session s;

    pool_empty();
    session_init(&s, pool_alloc, NULL, &oom);
    if (setjmp(oom) != 0)
        return false;
    in.sm = shape_source(&s, "m.sm", shape_find("states")->write, states);
    p = session_program(&s, &in);
    memset(&options, 0, sizeof options);
    options.header = "m.h";
    buf_init(&header, &s.arena);
    buf_init(&code, &s.arena);
    session_emit_c(&s, session_ir(&s, p, level), &options, &header, &code);
    return write_file(format_in(&s.arena, "%s/m.h", folder), &header) && write_file(format_in(&s.arena, "%s/m.c", folder), &code);
}

static double of(struct timeval t) { return (double)t.tv_sec + (double)t.tv_usec * 1e-6; }

static void c_compiler(const char *cc, const char *folder)
{
    char command[600];
    struct rusage use;

    if (!emit(folder, 1000, 2))
        exit(1);
    snprintf(command, sizeof command, "%s -O2 -c %s/m.c -o %s/m.o", cc, folder, folder);
    if (system(command) != 0)
        exit(1);
    getrusage(RUSAGE_CHILDREN, &use);
    printf("value gcc 1000-states-time %.2f s\n", of(use.ru_utime) + of(use.ru_stime));
    printf("value gcc 1000-states-memory %.0f MB\n", (double)use.ru_maxrss / 1024);
}

// ---- scripts ----

// Measures `smc test`: seconds, and megabytes.  Returns false if it fails or exceeds the limit.
static bool test_script(const char *smc, const char *sm, const char *ss, double *took, double *memory)
{
    static const struct rlimit limit = {60, 60};          // seconds of processor time
    struct rusage use;
    int status;
    pid_t pid;

    fflush(NULL);
    pid = fork();
    if (pid == 0) {
        setrlimit(RLIMIT_CPU, &limit);
        if (!freopen("/dev/null", "w", stdout))
            _exit(1);
        execl(smc, smc, "test", "-w", sm, ss, (char *)NULL);
        _exit(1);
    }
    if (pid < 0 || wait4(pid, &status, 0, &use) < 0)
        return false;
    *took = of(use.ru_utime) + of(use.ru_stime);
    *memory = (double)use.ru_maxrss / 1024;
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

static bool write_script(const char *sm, const char *ss, unsigned n)
{
    const Shape *shape = shape_find("script_blocks");
    Buf machine, script;
    jmp_buf oom;
    Session s;

    pool_empty();
    session_init(&s, pool_alloc, NULL, &oom);
    if (setjmp(oom) != 0)
        return false;
    buf_init(&machine, &s.arena);
    buf_init(&script, &s.arena);
    shape->write(&machine, n);
    shape->ss(&script, n);
    return write_file(sm, &machine) && write_file(ss, &script);
}

static void scripts(const char *folder, const char *smc)
{
    double took = 0, memory = 0;
    char sm[500], ss[500];
    unsigned n = 1000;

    snprintf(sm, sizeof sm, "%s/script.sm", folder);
    snprintf(ss, sizeof ss, "%s/script.ss", folder);
    for (; n <= 1000000 && took < ROOM && memory < 2 * room_memory / 1e6; n *= 10) {
        if (!write_script(sm, ss, n) || !test_script(smc, sm, ss, &took, &memory))
            break;
        printf("value script %u-blocks-time %.3f s\n", n, took);
        printf("value script %u-blocks-memory %.0f MB\n", n, memory);
    }
    if (n <= 1000000)
        printf("note script: %u blocks would take too long: not measured\n", n);
}

// The C compiler runs first: a child begins with the memory of this process, which would count as the child's.
int main(int argc, char **argv)
{
    if (argc != 4 || !pool_open())
        return 2;
    c_compiler(argv[1], argv[2]);
    scripts(argv[2], argv[3]);
    throughput();
    growth();
    extremes();
    shapes_at_default();
    states_by_locals();
    return 0;
}
