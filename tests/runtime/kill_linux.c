// SPDX-License-Identifier: Apache-2.0
// kill [N]: a program that saves its state vector and logs is killed by SIGKILL at random times and started again, N times (default
// 100).  After each kill the saved vector is complete: the last stored one or the next; and the log contains every appended block.
#define _GNU_SOURCE
#include <setjmp.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include "compiler/report/flight_log.h"
#include "log_parts.h"
#include "runtime-c/keep.h"
#include "runtime-c/pal/clock.h"
#include "runtime-c/pal/thread.h"
#include "tests/heap.h"

enum { LOG_MOST = 1 << 22 };      // bytes; when the log exceeds this, a new one begins

// The progress of the program before it is killed, in memory shared with the killing process.
typedef struct Told {
    uint64_t stored;              // the number of the last stored vector
    uint64_t appended;            // bytes that were appended to the log
    uint64_t ready;               // 0: not started yet
} Told;

static volatile Told *told;
static char folder[40];
static uint8_t kept[2 * SM_KEEP_SIZE(200)];
static SmKeep keep;

// ---- the program ----

static void begin(void)
{
    memset(&keep, 0, sizeof keep);
    reset_log("flight.log");
    keep.memory = "kept";
    keep.sv = &wide_vector;
    keep.buffer = kept;
}

static void run_steps(void *argument)
{
    uint64_t k = *(uint64_t *)argument;

    for (;;) {
        const SmTick tick = {k * TICK, k};

        if (sm_enter(&wide_vector) != SM_OK)
            _exit(2);
        fill_vector(k, 9);
        sm_leave(&wide_vector);
        (void)sm_log_step(&flight, &tick);
        (void)sm_keep_step(&keep, &tick);
        pal_clock_sleep_until(pal_clock_now() + 50 * PAL_MICROSECOND);
        k++;
    }
}

static void write_for_ever(void)
{
    for (;;) {
        (void)sm_log_drain(&flight, PAL_MILLISECOND);
        told->appended = flight.written;
        if (sm_keep_write(&keep) != SM_OK)
            _exit(4);
        told->stored = keep.number;
    }
}

static void program(void)
{
    const PalThreadPlan plan = {"steps", 0, 0};
    PalThread thread = {0};
    uint64_t k;

    begin();
    if (sm_keep_restore(&keep) != SM_OK || sm_log_init(&flight) != SM_OK)
        _exit(1);
    k = wide_sv.time / TICK + 1;
    told->stored = keep.number;
    told->ready = k;
    if (pal_thread_create(&thread, &plan, run_steps, &k) != SM_OK)
        _exit(1);
    write_for_ever();
}

// ---- who kills it ----

static uint32_t seed = 1;

static uint32_t next(uint32_t below)
{
    seed = seed * 1664525u + 1013904223u;
    return (uint32_t)((uint64_t)seed * below >> 32);
}

static void start_and_kill(void)
{
    const pid_t pid = fork();
    int status;

    if (pid == 0)
        program();
    for (int i = 0; i < 20000 && told->ready == 0; i++)
        usleep(100);
    CHECK(told->ready != 0);
    usleep(next(2) == 0 ? next(20000) : next(4000));
    kill(pid, SIGKILL);
    CHECK(waitpid(pid, &status, 0) == pid && WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL);
}

static bool is_whole(void)
{
    const uint64_t k = wide_sv.time / TICK;

    return wide_sv.i64 == -(int64_t)k && wide_sv.state == k % 2 + 1 && wide_sv.u8 == (uint8_t)(0xA5 + k) && wide_sv.f64 == (double)k * 0.25 + 9;
}

// Slot numbers count stored vectors: the last one that the program recorded, or the next.
static void check_stored(void)
{
    begin();
    CHECK(sm_keep_restore(&keep) == SM_OK);
    CHECK(keep.number == told->stored || keep.number == told->stored + 1);
    CHECK(keep.restored == (keep.number > 0) && (!keep.restored || is_whole()));
    CHECK(pal_nvm_close(keep.nvm) == SM_OK && pal_lock_close(keep.lock) == SM_OK);
}

static jmp_buf oom;

static bool is_true(const LogSession *s, const LogItem *r)
{
    const uint64_t k = log_read_time(r) / TICK;
    const LogElement *e = s->d->element;

    return log_read_cell(r, &e[WIDE_E_time]) == k * TICK && log_read_cell(r, &e[WIDE_E_i64]) == (uint64_t)-(int64_t)k &&
        log_read_cell(r, &e[WIDE_E_u8]) == (uint8_t)(0xA5 + k);
}

// Every start has left at most one torn block.  Every appended block is in the log.
static void check_log(const uint8_t *bytes, size_t n, uint32_t starts)
{
    Arena arena;
    Log *log;

    arena_init(&arena, heap_alloc, NULL, &oom);
    if (setjmp(oom))
        abort();
    log = log_read(&arena, bytes, (uint32_t)n);
    CHECK(n >= told->appended && log->damaged_ranges <= starts && log->session.n <= starts && log->session.n + log->damaged_ranges >= 1);
    for (size_t s = 0; s < log->session.n; s++)
        for (size_t i = 0; i < log->session.at[s]->item.n; i++)
            if (log->session.at[s]->item.at[i].kind == ITEM_RECORD)
                CHECK(is_true(log->session.at[s], &log->session.at[s]->item.at[i]));
    arena_free(&arena);
}

static void check_file(uint32_t *starts)
{
    static uint8_t bytes[4 * LOG_MOST];
    FILE *f = fopen("flight.log", "rb");
    const size_t n = f ? fread(bytes, 1, sizeof bytes, f) : 0;

    CHECK(f != NULL && n < sizeof bytes);
    if (f)
        fclose(f);
    if (n == 0)
        return;                                           // killed before the first byte
    check_log(bytes, n, *starts);
    if (n > LOG_MOST || next(16) == 0) {
        CHECK(unlink("flight.log") == 0);
        *starts = 0;
    }
}

int main(int argc, char **argv)
{
    const long n = argc > 1 ? strtol(argv[1], NULL, 10) : 100;
    uint32_t starts = 0;

    // Killing a process does not lose what the system has accepted.  A file system in memory is therefore sufficient, and allows a hundred times
    // as many writes.
    snprintf(folder, sizeof folder, "%s/smc-kill.XXXXXX", access("/dev/shm", W_OK) == 0 ? "/dev/shm" : P_tmpdir);
    told = mmap(NULL, sizeof *told, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    CHECK(told != MAP_FAILED && mkdtemp(folder) != NULL && chdir(folder) == 0);
    for (long i = 0; i < n; i++) {
        memset((void *)(uintptr_t)told, 0, sizeof *told);
        start_and_kill();
        starts++;
        check_stored();
        check_file(&starts);
    }
    unlink("kept.new");
    unlink("flight.log");
    CHECK(unlink("kept") == 0 && chdir("/") == 0 && rmdir(folder) == 0);
    printf("kill: %ld kills, %lu vectors stored\n", n, (unsigned long)keep.number);
    return test_end("kill");
}
