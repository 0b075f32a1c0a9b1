// SPDX-License-Identifier: Apache-2.0
// The bench: the application of the test stand, as it is, on the simulated platform, between pins that behave like a stand
// (bench_world.c) and break on demand (bench_faults.def).  Each fault is tried at several moments between two steps, each time in a
// process of its own, since an application starts once.  `bench` tries all; `bench -v` also says how long each took to be safe.
#define _POSIX_C_SOURCE 200809L
#include <stdio.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "bench_world.h"
#include "runtime-c/psl/sim/sim.h"
#include "stand.h"
#include "teststand_app.h"

#define STATE(name) (1u << STAND_STATE_##name)
enum {
    IN_CHILL = STATE(Chill), IN_IGNITE = STATE(Ignite), IN_START = STATE(Start), IN_BURN = STATE(Burn),
    IN_SHUTDOWN = STATE(Shutdown)
};

static const struct Fault {
    const char *what;
    Kind kind;
    int argument;
    unsigned states;
    int after, reason, within;
} faults[] = {
#define FAULT(what, kind, argument, states, after, reason, within) {what, kind, argument, states, after, reason, within},
#include "bench_faults.def"
#undef FAULT
};

static struct {
    const struct Fault *fault;
    uint32_t state;           // in which it is put in
    int phase;                // ms behind the beginning of a step
    World world;
    uint32_t last_state;
    int ms, in_state;         // since the start; since the state began
    int unsafe;               // ms after the fault when the stand was last seen not safe
    bool burnt;
} run;

// ---- the fault ----

static void put_in(void)
{
    const struct Fault *f = run.fault;

    run.world.kind     = f->kind;
    run.world.argument = f->argument;
    if (f->kind == KEY || f->kind == NO_OUTPUTS)
        run.world.key = false;
    if (f->kind == NO_CHANNELS)
        sim_break(SIM_aio_read, 0, SM_E_DEVICE);
    if (f->kind == NO_SWITCHES)
        sim_break(SIM_dio_read, 0, SM_E_DEVICE);
    if (f->kind == SLOW || f->kind == HANGS)
        sim_delay(SIM_aio_read, (uint64_t)f->argument * PAL_MILLISECOND);
    if (f->kind == NO_OUTPUTS)
        sim_break(SIM_dio_write, 0, SM_E_DEVICE);
}

// What has to be done again while it lasts.
static void keep_up(void)
{
    const struct Fault *f = run.fault;

    if (f->kind == FAILS && run.ms % 10 == 9)             // of the next step's readings, in the order of teststand.io, this one
        sim_fail(SIM_aio_read, (uint32_t)f->argument, SM_E_DEVICE);
    if (f->kind == NO_OUTPUTS && run.world.since == f->argument)
        sim_break(SIM_dio_write, 0, SM_OK);
    if (f->kind == HANGS && run.world.since == 20)        // by now a reading has begun that takes all that time
        sim_delay(SIM_aio_read, 0);
    run.world.off = sim_watchdog_fired();
}

// ---- a millisecond ----

static void look(void)
{
    if (!world_is_safe(&run.world))
        run.unsafe = run.world.since;
    if (run.last_state == STAND_STATE_Burn)
        run.burnt = true;
}

static void count_time(void)
{
    uint32_t state = teststand_standState();

    run.in_state = state == run.last_state ? run.in_state + 1 : 0;
    run.last_state = state;
    run.ms++;
}

// The operator turns the key after three seconds, and lets go of it after twenty.
static void operate(void)
{
    if (run.ms == 3000)
        run.world.key = true;
    if (run.ms == 20000)
        run.world.key = false;
}

// A firing takes 24 s; after an abort it is enough to see the tank empty.
static void look_for_the_end(void)
{
    if (run.ms == 24000 || run.world.since == run.fault->within + 4500)
        sm_app_stop(&teststand_app);
}

static void millisecond(void)
{
    count_time();
    operate();
    if (run.world.since == 0 && run.last_state == run.state && run.in_state >= run.fault->after + run.phase)
        put_in();
    if (run.world.kind != NOTHING) {
        run.world.since++;
        keep_up();
    }
    world_step(&run.world);
    look();
    look_for_the_end();
}

// ---- the verdict ----

static int complain(const char *what, int is, int should)
{
    printf("%s, in state %s: %s: %d, not %d\n", run.fault->what, stand_state_name(run.state), what, is, should);
    return 1;
}

// A firing that nothing disturbs burns, and ends where it began.
static int judge_firing(void)
{
    return !run.burnt || run.last_state != STAND_STATE_Idle || teststand_abortReason() != 0
        ? complain("reason of an abort", teststand_abortReason(), 0) : 0;
}

static int judge_abort(void)
{
    const struct Fault *f = run.fault;

    if (run.world.since == 0)
        return complain("the fault was put in", 0, 1);
    if (run.unsafe > f->within)
        return complain("safe after so many ms", run.unsafe, f->within);
    if (teststand_abortReason() != f->reason)
        return complain("reason", teststand_abortReason(), f->reason);
    if (run.world.chamber > 3 || run.world.tank > 3)
        return complain("bar in the chamber and the tank", (int)(run.world.chamber + run.world.tank), 2);
    return 0;
}

static int try_one(const struct Fault *f, uint32_t state, int phase)
{
    sim_reset();
    run.fault = f;
    run.state = state;
    run.phase = phase;
    world_begin(&run.world);
    sim_every(PAL_MILLISECOND, millisecond);
    if (sm_app_run(&teststand_app) != SM_OK)
        return complain("started", 0, 1);
    return f->kind == NOTHING ? judge_firing() : judge_abort();
}

// ---- all of them ----

static void say(const struct Fault *f)
{
    printf("%-48s %-8s +%d ms: safe after %5d ms, reason %d\n", f->what, stand_state_name(run.state), run.phase, run.unsafe,
           teststand_abortReason());
}

static bool try_apart(const struct Fault *f, uint32_t state, int phase, bool verbose)
{
    int status = 1;
    pid_t child;

    fflush(stdout);
    child = fork();
    if (child == 0) {
        int bad = try_one(f, state, phase);

        if (verbose && !bad)
            say(f);
        fflush(stdout);
        _exit(bad);
    }
    return child > 0 && waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

int main(int argc, char **argv)
{
    bool verbose = argc > 1 && strcmp(argv[1], "-v") == 0;
    int passed = 0, failed = 0;

    for (size_t i = 0; i < sizeof faults / sizeof *faults; i++)
        for (uint32_t state = 1; state <= STAND_STATES; state++)
            for (int phase = 0; phase < 10 && faults[i].states >> state & 1; phase += 3)
                *(try_apart(&faults[i], state, phase, verbose) ? &passed : &failed) += 1;
    printf("%d passed, %d failed\n", passed, failed);
    return failed > 0;
}
