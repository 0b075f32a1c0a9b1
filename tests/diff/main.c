// SPDX-License-Identifier: Apache-2.0
// The campaign: random programs, one a seed, each run on every engine in lock step.
//
//     difftest [--seed=N] [--count=N] [--steps=N] [--jobs=N] [--out=DIR] [--resume] [--print] [--no-reduce] [--no-floors] [--first]
//              [--forms=012h] [--cc=COMMAND]… [--cc-soft=COMMAND]… [--vm=COMMAND]… [--batch=N] [--sound]
//
// Workers process blocks of seeds in turn.  Each worker stores its progress and its counts in a file in DIR, so that --resume continues an
// interrupted campaign.  The seed of a worker that crashes or hangs is reported, and the worker is replaced.
// Every program is run at -O0, -O1, -O2 and with hidden locals (h), or only in the forms that --forms names.
// With --cc, each of these commands compiles the emitted C, which is compared with the reference instead of the VM.  Each program has one form
// unless --forms names several.  --cc-soft does this with numbers in software.  With --vm each of these commands receives the images (batch.h).
// --batch is the number of programs in a batch.  A batch that is too large for the target is divided.  A single program that is too large is
// counted as "no room".
// With --sound each program runs without other engines, from its first state, and is compared with the results of the analyses (sound.h).
// A failing program is reduced and written to DIR/seed-N.  Exit codes: 0 all agree, 1 some differ, 2 usage.
#define _POSIX_C_SOURCE 200809L
#define _DEFAULT_SOURCE

#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "stdlib/crc32.h"
#include "tests/diff/batch.h"
#include "tests/diff/reduce.h"
#include "tests/diff/sound.h"
#include "tests/diff/subject.h"

enum { BLOCK = 500, JOBS_MAX = 64, HANG_SECONDS = 60, VIAS_MAX = 8, BATCH = 50 };         // programs at a time, at most

typedef struct Options {
    uint64_t seed, count;
    uint32_t steps, jobs, batch;
    const char *out;
    bool resume, print, reduce, floors, first, sound;
    unsigned forms;                   // 1u << Form of each form that is run; 0: the command names none
    uint32_t build;                   // identifies this build of the program: results of another build are not resumed
    uint32_t vias;
    Via via[VIAS_MAX];
} Options;

// The progress of a worker, in memory shared with the parent, and in a file for --resume.
typedef struct Tally {
    uint64_t next;                    // the block that the worker processes, counted from 0
    uint64_t seed;                    // the seed that the worker processes
    uint64_t programs, steps, different, rejected, crashed;
    uint64_t transition, saturation, nan, infinity, full_window, refusal, refused, store, change, covered, impossible, finding, no_room;
    uint64_t additions, definition, rule, state_name, span, window_in_time, steps_window, units, parameter, by_hand;      // programs that use each; compared
} Tally;

// ---- one program ----

static void count(Tally *t, const Met *m)
{
    t->programs++;
    t->transition += m->transition;
    t->saturation += m->saturation;
    t->nan += m->nan;
    t->infinity += m->infinity;
    t->full_window += m->full_window;
    t->refusal += m->refusal;
    t->refused += m->refused;
    t->store += m->store;
    t->impossible += m->impossible;
    t->finding += m->finding;
}

static void count_additions(Tally *t, const Gen *g)
{
    bool used[G_STEPS + 1] = { false }, in_time = false;
    gen_additions_used(g, used, &in_time);
    t->additions += g->additions;
    t->definition += used[G_DEFINED];
    t->rule += g->rule.n > 0;
    t->state_name += used[G_STATE];
    t->span += used[G_SPAN];
    t->steps_window += used[G_STEPS];
    t->units += g->units_printed > 0;
    t->parameter += gen_sets_parameter(g);
    t->window_in_time += in_time;
}

static void report_failure(const Options *o, Gen *g, const RunOptions *how, RunResult r, Arena *arena)
{
    char folder[500];
    fprintf(stderr, "seed %llu: %s, step %u: %s\n", (unsigned long long)g->seed,
            r.verdict == VERDICT_REJECTED ? "rejected" : "different", (unsigned)r.step, r.message);
    snprintf(folder, sizeof folder, "%s/seed-%llu", o->out, (unsigned long long)g->seed);
    mkdir(folder, 0777);
    if (o->reduce)
        r = reduce(g, how, r, arena);
    run_write_files(g, how, &r, folder);
    fprintf(stderr, "seed %llu: reduced to %s: %s\n", (unsigned long long)g->seed, folder, r.message);
}

// Returns the options with which the program of a seed is run.
static RunOptions options_of(const Options *o, uint64_t seed)
{
    RunOptions how = run_options_of(seed);
    how.sound = o->sound;
    if (o->forms != 0)
        how.forms = o->forms;
    else if (o->vias != 0)
        how.forms = 1u << rng_mix(seed, 10) % FORM_COUNT;
    return how;
}

static Gen *gen_of(Arena *arena, const Options *o, uint64_t seed)
{
    Gen *g = gen_program(arena, seed, o->steps);
    if (o->sound)
        gen_bias(g);
    return g;
}

static void run_seed(const Options *o, uint64_t seed, Tally *t)
{
    const RunOptions how = options_of(o, seed);
    Arena arena;
    diff_arena_init(&arena);
    Gen *g = gen_of(&arena, o, seed);
    const RunResult r = run_case(g, &how, &arena);
    count(t, &r.met);
    t->steps += g->steps;
    t->change += how.change;
    t->covered += how.cover;
    t->by_hand += how.change && how.what == CHANGE_BY_HAND;
    count_additions(t, g);
    t->different += r.verdict == VERDICT_DIFFERENT;
    t->rejected += r.verdict == VERDICT_REJECTED;
    if (r.verdict != VERDICT_SAME && t->different + t->rejected <= 20)
        report_failure(o, g, &how, r, &arena);
    arena_free(&arena);
}

// ---- a batch of programs, run by others ----

static void count_batch(const Options *o, Gen **g, uint32_t n, RunResult *r, const char *folder, Tally *t, Arena *arena)
{
    for (uint32_t i = 0; i < n; i++) {
        RunOptions how = options_of(o, g[i]->seed);
        t->programs++;
        t->steps += g[i]->steps;
        t->different += r[i].verdict == VERDICT_DIFFERENT;
        t->rejected += r[i].verdict == VERDICT_REJECTED;
        t->no_room += r[i].met.no_room || r[i].verdict == VERDICT_TOO_LARGE;
        how.folder = folder;
        for (uint32_t v = 0; v < o->vias && r[i].verdict != VERDICT_SAME && how.via == NULL; v++)
            if (strstr(r[i].message, o->via[v].command) != NULL)      // the command in which the difference was found
                how.via = &o->via[v];
        if (r[i].verdict != VERDICT_SAME && r[i].verdict != VERDICT_TOO_LARGE && t->different + t->rejected <= 5)
            report_failure(o, g[i], &how, r[i], arena);
    }
}

static void run_seeds_elsewhere(const Options *o, uint64_t first, uint32_t n, Tally *t)
{
    Gen *g[BATCH];
    RunResult r[BATCH];
    unsigned forms[BATCH];
    char folder[500];
    Arena arena;
    diff_arena_init(&arena);
    memset(r, 0, sizeof r);
    snprintf(folder, sizeof folder, "%s/batch-%llu", o->out, (unsigned long long)first);
    mkdir(folder, 0777);
    for (uint32_t i = 0; i < n; i++) {
        g[i] = gen_program(&arena, first + i, o->steps);
        forms[i] = options_of(o, first + i).forms;
    }
    run_batch(g, forms, n, o->via, o->vias, folder, &arena, r);
    const bool split = n > 1 && r[0].verdict == VERDICT_TOO_LARGE;
    if (!split)
        count_batch(o, g, n, r, folder, t, &arena);
    batch_clean(folder);
    arena_free(&arena);
    if (split) {
        run_seeds_elsewhere(o, first, n / 2, t);
        run_seeds_elsewhere(o, first + n / 2, n - n / 2, t);
    }
}

static void print_seed(const Options *o, uint64_t seed)
{
    const RunOptions how = options_of(o, seed);
    RunResult r = { VERDICT_SAME, NULL, 0, { 0 } };
    Arena arena;
    diff_arena_init(&arena);
    run_write_files(gen_of(&arena, o, seed), &how, &r, o->out);
    arena_free(&arena);
}

// ---- a worker ----

static void tally_path(const Options *o, uint32_t worker, char *path, size_t size)
{
    snprintf(path, size, "%s/worker-%u", o->out, (unsigned)worker);
}

static void tally_save(const Options *o, uint32_t worker, const Tally *t)
{
    char path[500], fresh[520];
    tally_path(o, worker, path, sizeof path);
    snprintf(fresh, sizeof fresh, "%s.new", path);
    FILE *f = fopen(fresh, "wb");
    if (f == NULL)
        return;
    fwrite(o, sizeof *o, 1, f);
    fwrite(t, sizeof *t, 1, f);
    fclose(f);
    rename(fresh, path);
}

// Loads the progress of an earlier run of the same campaign.
static void tally_load(const Options *o, uint32_t worker, Tally *t)
{
    char path[500];
    Options then;
    Tally read;
    tally_path(o, worker, path, sizeof path);
    FILE *f = fopen(path, "rb");
    if (f == NULL)
        return;
    if (fread(&then, sizeof then, 1, f) == 1 && fread(&read, sizeof read, 1, f) == 1 &&
        then.seed == o->seed && then.jobs == o->jobs && then.steps == o->steps && then.build == o->build &&
        then.vias == o->vias && then.forms == o->forms && then.sound == o->sound && then.batch == o->batch)
        *t = read;
    fclose(f);
}

// Whether the campaign continues.  With --first it ends at the first failure.
static bool goes_on(const Options *o, const Tally *t) { return !o->first || t->different + t->rejected + t->crashed == 0; }

static void work(const Options *o, uint32_t worker, Tally *t)
{
    const pid_t parent = getppid();
    for (uint64_t block = t->next; block * BLOCK < o->count && getppid() == parent && goes_on(o, t); block += o->jobs) {
        const uint64_t last = (block + 1) * BLOCK < o->count ? (block + 1) * BLOCK : o->count;
        const uint64_t first = t->seed >= o->seed + block * BLOCK && t->next == block ? t->seed - o->seed : block * BLOCK;
        t->next = block;
        for (uint64_t i = first; i < last && goes_on(o, t); i += o->vias != 0 ? o->batch : 1) {
            t->seed = o->seed + i;
            if (o->vias == 0)
                run_seed(o, o->seed + i, t);
            else
                run_seeds_elsewhere(o, o->seed + i, last - i < o->batch ? (uint32_t)(last - i) : o->batch, t);
        }
        t->next = block + o->jobs;
        tally_save(o, worker, t);
    }
}

// ---- the parent ----

static pid_t start_worker(const Options *o, uint32_t worker, Tally *t)
{
    fflush(NULL);
    const pid_t pid = fork();
    if (pid == 0) {
        work(o, worker, t);
        _exit(0);
    }
    return pid;
}

static void watch_worker(const Options *o, Tally *tally, pid_t *pid, uint64_t *seen, time_t *since, uint32_t w)
{
    int status;
    if (waitpid(pid[w], &status, WNOHANG) == pid[w]) {
        pid[w] = 0;
        if (WIFEXITED(status) && WEXITSTATUS(status) == 0)
            return;
        fprintf(stderr, "seed %llu: crashed or hung (wait status %d)\n", (unsigned long long)tally[w].seed, status);
        tally[w].crashed++;
        tally[w].seed++;
        pid[w] = start_worker(o, w, &tally[w]);
    } else if (tally[w].seed != seen[w]) {
        seen[w] = tally[w].seed;
        since[w] = time(NULL);
    } else if (time(NULL) - since[w] > (o->vias != 0 ? 20 : 1) * HANG_SECONDS) {
        kill(pid[w], SIGKILL);
    }
}

static void run_workers(const Options *o, Tally *tally)
{
    pid_t pid[JOBS_MAX];
    uint64_t seen[JOBS_MAX] = { 0 };
    time_t since[JOBS_MAX];
    bool busy = true;
    for (uint32_t w = 0; w < o->jobs; w++) {
        since[w] = time(NULL);
        tally[w].next = w;
        if (o->resume)
            tally_load(o, w, &tally[w]);
        pid[w] = start_worker(o, w, &tally[w]);
    }
    while (busy) {
        nanosleep(&(struct timespec){ 0, 20000000 }, NULL);
        busy = false;
        for (uint32_t w = 0; w < o->jobs; w++) {
            if (pid[w] != 0)
                watch_worker(o, tally, pid, seen, since, w);
            busy |= pid[w] != 0;
        }
    }
}

static void add_up(Tally *sum, const Tally *t)
{
    sum->programs += t->programs;
    sum->steps += t->steps;
    sum->different += t->different;
    sum->rejected += t->rejected;
    sum->crashed += t->crashed;
    sum->transition += t->transition;
    sum->saturation += t->saturation;
    sum->nan += t->nan;
    sum->infinity += t->infinity;
    sum->full_window += t->full_window;
    sum->refusal += t->refusal;
    sum->refused += t->refused;
    sum->store += t->store;
    sum->change += t->change;
    sum->covered += t->covered;
    sum->impossible += t->impossible;
    sum->finding += t->finding;
    sum->no_room += t->no_room;
    sum->additions += t->additions;
    sum->definition += t->definition;
    sum->rule += t->rule;
    sum->state_name += t->state_name;
    sum->span += t->span;
    sum->window_in_time += t->window_in_time;
    sum->steps_window += t->steps_window;
    sum->units += t->units;
    sum->parameter += t->parameter;
    sum->by_hand += t->by_hand;
}

// Reports a share of programs below its floor: the generator no longer produces what the test needs.  With few programs, a share is not
// reliable.
static bool share(const Options *o, const Tally *t, const char *what, uint64_t n, unsigned floor)
{
    const double percent = t->programs != 0 ? 100.0 * (double)n / (double)t->programs : 0;
    const bool low = o->floors && t->programs >= 300 && percent < floor;
    printf("  %-34s %5.1f %%  (at least %u %%)%s\n", what, percent, floor, low ? "  TOO FEW" : "");
    return !low;
}

static bool report_shares(const Options *o, const Tally *t)
{
    const double refused = 100.0 * (double)t->refused / (double)(t->steps != 0 ? t->steps : 1);
    bool good = refused < 25 || !o->floors;
    printf("%.1f %% of the steps are refused (at most 25 %%)\n", refused);
    printf("of these programs\n");
    good &= share(o, t, "store something", t->store, 98);
    good &= share(o, t, "make a transition", t->transition, 65);
    good &= share(o, t, "saturate", t->saturation, 40);
    good &= share(o, t, "meet NaN", t->nan, 20);
    good &= share(o, t, "meet an infinity", t->infinity, 23);
    good &= share(o, t, "fill a window of 2 or more", t->full_window, 75);
    good &= share(o, t, "have a step refused", t->refusal, 95);
    good &= share(o, t, "were compared with a changed one", t->change, 20);
    good &= share(o, t, "had their coverage compared", t->covered, 20);
    good &= share(o, t, "use additions to the language", t->additions, 40);
    good &= share(o, t, "have definitions", t->definition, 30);
    good &= share(o, t, "have rules for all states", t->rule, 15);
    good &= share(o, t, "name a state beside S", t->state_name, 20);
    good &= share(o, t, "have times", t->span, 30);
    good &= share(o, t, "have windows in time", t->window_in_time, 12);
    good &= share(o, t, "have windows in steps", t->steps_window, 10);
    good &= share(o, t, "have units", t->units, 18);
    good &= share(o, t, "read parameters that are set", t->parameter, 8);
    good &= share(o, t, "were compared with themselves by hand", t->by_hand, 8);
    return good;
}

static bool report_sound(const Options *o, const Tally *t)
{
    bool good = true;
    printf("of these programs\n");
    good &= share(o, t, "make a transition", t->transition, 60);
    good &= share(o, t, "meet NaN", t->nan, 20);
    good &= share(o, t, "have a guard that facts decide", t->impossible, 40);
    good &= share(o, t, "have something that a finding calls dead", t->finding, 40);
    return good;
}

static bool report(const Options *o, const Tally *t, double seconds)
{
    bool good = true;
    const uint64_t failed = t->different + t->rejected + t->crashed;
    printf("%llu programs, %llu steps, %.1f s, %.0f programs a second\n", (unsigned long long)t->programs,
           (unsigned long long)t->steps, seconds, (double)t->programs / seconds);
    if (o->sound)
        good = report_sound(o, t);
    else if (o->vias == 0)
        good = report_shares(o, t);
    if (t->no_room > 0)
        printf("%llu programs had no room\n", (unsigned long long)t->no_room);
    printf("difftest: %llu passed, %llu failed (%llu different, %llu rejected, %llu crashed)\n",
           (unsigned long long)(t->programs - t->different - t->rejected), (unsigned long long)failed,
           (unsigned long long)t->different, (unsigned long long)t->rejected, (unsigned long long)t->crashed);
    return good && failed == 0;
}
// ---- options ----

static bool take_number(const char *arg, const char *name, uint64_t *n)
{
    const size_t len = strlen(name);
    char *end;
    if (strncmp(arg, name, len) != 0 || arg[len] != '=')
        return false;
    *n = strtoull(arg + len + 1, &end, 0);
    return *end == '\0' && end != arg + len + 1;
}

static bool take_forms(Options *o, const char *letters)
{
    static const char all[] = "012h";                 // one character for each Form, in the same order
    for (; *letters; letters++) {
        const char *at = strchr(all, *letters);
        if (at == NULL)
            return false;
        o->forms |= 1u << (at - all);
    }
    return o->forms != 0;
}

static bool take_option(Options *o, const char *arg)
{
    uint64_t n = 0;
    if (take_number(arg, "--seed", &o->seed) || take_number(arg, "--count", &o->count))
        return true;
    if (take_number(arg, "--steps", &n) && n >= 1 && n <= GEN_STEPS_MAX)
        return o->steps = (uint32_t)n, true;
    if (take_number(arg, "--jobs", &n) && n >= 1 && n <= JOBS_MAX)
        return o->jobs = (uint32_t)n, true;
    if (strncmp(arg, "--out=", 6) == 0)
        return o->out = arg + 6, true;
    if (o->vias < VIAS_MAX && batch_via(arg, &o->via[o->vias]))
        return o->vias++, true;
    if (take_number(arg, "--batch", &n) && n >= 1 && n <= BATCH)
        return o->batch = (uint32_t)n, true;
    if (strncmp(arg, "--forms=", 8) == 0)
        return take_forms(o, arg + 8);
    if (strcmp(arg, "--resume") == 0)
        return o->resume = true;
    if (strcmp(arg, "--print") == 0)
        return o->print = true;
    if (strcmp(arg, "--sound") == 0)
        return o->sound = true;
    if (strcmp(arg, "--no-reduce") == 0)
        return o->reduce = false, true;
    if (strcmp(arg, "--first") == 0)
        return o->first = true;
    if (strcmp(arg, "--no-floors") == 0)
        return o->floors = false, true;
    return false;
}

static uint32_t checksum_of(const char *path)
{
    uint32_t crc = SM_CRC32_START;
    FILE *f = fopen(path, "rb");
    int c;
    while (f != NULL && (c = getc(f)) != EOF)
        crc = sm_crc32_byte(crc, (uint8_t)c);
    if (f != NULL)
        fclose(f);
    return sm_crc32_end(crc);
}

int main(int argc, char **argv)
{
    Options o = { .seed = 1, .count = 10000, .steps = 100, .jobs = 1, .batch = BATCH, .out = "difftest.out", .reduce = true, .floors = true };
    struct timespec from, to;
    Tally sum = { 0 };
    for (int i = 1; i < argc; i++)
        if (!take_option(&o, argv[i])) {
            fprintf(stderr, "difftest: unknown option '%s'\n", argv[i]);
            return 2;
        }
    o.build = checksum_of(argv[0]);
    mkdir(o.out, 0777);
    if (o.print)
        return print_seed(&o, o.seed), 0;
    for (uint32_t v = 1; v < o.vias; v++)
        if (o.via[v].images != o.via[0].images) {
            fputs("difftest: --cc and --vm do not go together\n", stderr);
            return 2;
        }
    Tally *tally = mmap(NULL, JOBS_MAX * sizeof *tally, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (tally == MAP_FAILED)
        return 3;
    clock_gettime(CLOCK_MONOTONIC, &from);
    run_workers(&o, tally);
    clock_gettime(CLOCK_MONOTONIC, &to);
    for (uint32_t w = 0; w < o.jobs; w++)
        add_up(&sum, &tally[w]);
    return report(&o, &sum, (double)(to.tv_sec - from.tv_sec) + (double)(to.tv_nsec - from.tv_nsec) / 1e9) ? 0 : 1;
}
