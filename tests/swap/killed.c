// SPDX-License-Identifier: Apache-2.0
// An application on Linux that stores swaps in a file.  It is killed at each system call that writes, and in other runs each of these calls
// fails.  After a restart the machine runs that was confirmed before, or the one that was being confirmed (docs/swapping.md 12.49, 12.50).  ld's
// --wrap replaces the calls by those of this test.
#define _GNU_SOURCE
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/swap/stage.h"
#include "tests/test.h"

#define COUNT(by) A "[local]\nU32 n = 0\n[A] @swap\n.step\nn = n + " #by "\nout = n\n"

ssize_t __real_write(int fd, const void *from, size_t n);
ssize_t __wrap_write(int fd, const void *from, size_t n);
int __real_fsync(int fd);
int __wrap_fsync(int fd);
int __real_rename(const char *from, const char *to);
int __wrap_rename(const char *from, const char *to);
int __real_ftruncate(int fd, off_t n);
int __wrap_ftruncate(int fd, off_t n);

// ---- the calls ----

typedef enum Fault { KILL, FAIL_ONCE, FAIL_FOR_GOOD } Fault;

static Fault fault;
static int left = -1;         // number of calls that still succeed; below 0: all

// Returns whether the current call fails.  Does not return if the application is killed.
static bool fails(void)
{
    if (left < 0 || left-- > 0)
        return false;
    if (fault == KILL)
        (void)kill(getpid(), SIGKILL);
    if (fault == FAIL_FOR_GOOD)
        left = 0;
    errno = EIO;
    return true;
}

// A write that fails has already written half of its bytes.
ssize_t __wrap_write(int fd, const void *from, size_t n) { return fails() ? (void)__real_write(fd, from, n / 2), -1 : __real_write(fd, from, n); }
int __wrap_fsync(int fd) { return fails() ? -1 : __real_fsync(fd); }
int __wrap_rename(const char *from, const char *to) { return fails() ? -1 : __real_rename(from, to); }
int __wrap_ftruncate(int fd, off_t n) { return fails() ? -1 : __real_ftruncate(fd, n); }

// ---- the application ----

enum { RUNS_ONE = 10, RUNS_TEN, RUNS_MANY, RUNS_OTHER, CONFIRMED, RETURNED, NOT_STARTED };

static SwapMachine one, ten, many;
static const SwapMachine *next;       // the machine to which the application swaps; NULL: none
static int outcome;
static bool confirms;         // the application requests the confirmation

static int running_image(void)
{
    SmSwapMachineState s;

    memset(&s, 0, sizeof s);
    (void)sm_swap_machine(&stage.swaps, 0, &s);
    return s.identity == stage_identity(&one) ? RUNS_ONE : s.identity == stage_identity(&ten) ? RUNS_TEN : s.identity == stage_identity(&many) ? RUNS_MANY : RUNS_OTHER;
}

// Each tick: begins the swap, confirms it once, and stops when it has ended.
static void act(const SmTick *tick)
{
    const SmSwapPhase phase = stage_phase();

    if (next == NULL || phase == SM_SWAP_CONFIRMED || phase == SM_SWAP_RETURNED) {
        outcome = next == NULL ? 0 : phase == SM_SWAP_CONFIRMED ? CONFIRMED : RETURNED;
        sm_app_stop(&stage.app);
    } else if (phase == SM_SWAP_IDLE) {
        if (tick->number > 1)
            (void)stage_swap("a", next, SM_SWAP_CONTINUE, NULL);
    } else if (phase == SM_SWAP_TRIAL && !confirms) {
        confirms = sm_swap_confirm(&stage.swaps) == SM_OK;
    }
}

// Runs the application in a child process.  Returns the machine that it runs, or how its swap ended; 0 if it was killed.
static int run(const SwapMachine *to, int calls, Fault with)
{
    const StagePlan plan = {.a = &one, .room = STAGE_ROOM, .trial = 20, .period = {PAL_MILLISECOND, 0}, .act = act};
    const pid_t pid = fork();
    int status;

    if (pid == 0) {
        next = to;
        left = calls;
        fault = with;
        stage_set_up(&plan);
        stage_store("stored", 512, NULL);
        if (sm_app_run(&stage.app) != SM_OK)
            _exit(NOT_STARTED);
        _exit(to != NULL ? outcome : running_image());
    }
    CHECK(pid > 0 && waitpid(pid, &status, 0) == pid);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 0;
}

static int start_again(void) { return run(NULL, -1, KILL); }

// Confirms `ten`, or `many` if `was_stored`, with a fault at each system call in turn.
static void test(Fault with, bool was_stored)
{
    const int before = was_stored ? RUNS_TEN : RUNS_ONE, after = was_stored ? RUNS_MANY : RUNS_TEN;
    unsigned old_runs = 0, new_runs = 0;
    int end = 0, calls = 0;

    if (was_stored)
        CHECK(run(&ten, -1, KILL) == CONFIRMED && start_again() == RUNS_TEN && rename("stored", "first") == 0);
    for (; end != CONFIRMED || calls < 2; calls++) {
        int runs;
        (void)unlink("stored.new");
        CHECK(was_stored ? system("cp first stored") == 0 : unlink("stored") == 0 || errno == ENOENT);
        end = run(was_stored ? &many : &ten, calls, with);
        CHECK(end == 0 ? with == KILL : end == CONFIRMED || with != KILL);
        runs = start_again();
        CHECK(runs == before || runs == after);
        if (end == CONFIRMED)
            CHECK(runs == after);
        if (end == RETURNED && with == FAIL_ONCE)
            CHECK(runs == before);
        if (calls % 5 == 0)                                // the next swap is stored
            CHECK(run(&many, -1, KILL) == CONFIRMED && start_again() == RUNS_MANY);
        old_runs += runs == before;
        new_runs += runs == after;
    }
    (void)unlink("stored");
    CHECK(old_runs > 6 && new_runs > 0 && calls > 8);
}

int main(void)
{
    const char *base = getenv("TMPDIR");
    char folder[200], line[256];

    snprintf(folder, sizeof folder, "%s/smc-killed.XXXXXX", base && strlen(base) < 150 ? base : P_tmpdir);
    if (mkdtemp(folder) == NULL || chdir(folder) != 0)
        return 1;
    machine_compile(&one, COUNT(1), STAGE_SV, 2, true);
    machine_compile(&ten, COUNT(10), STAGE_SV, 2, true);
    machine_compile(&many, COUNT(1000), STAGE_SV, 2, true);
    for (Fault with = KILL; with <= FAIL_FOR_GOOD; with++) {
        test(with, false);
        test(with, true);
    }
    machine_free(&one);
    machine_free(&ten);
    machine_free(&many);
    snprintf(line, sizeof line, "rm -rf %s", folder);
    CHECK(chdir("/") == 0 && system(line) == 0);
    return test_end("swap/killed");
}
