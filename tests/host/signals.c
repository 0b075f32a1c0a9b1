// SPDX-License-Identifier: Apache-2.0
// A signal ends `smc test --engine=c` while the C compiler runs.  It must leave no folder in TMPDIR, no process and no incomplete trace, and the
// exit code must identify the signal.  The same is tested for output to a pipe that is not read.
//     signals SMC MACHINE SCRIPT FOLDER     (FOLDER is empty; absolute paths)
#define _XOPEN_SOURCE 700

#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "compiler/base/os.h"
#include "tests/test.h"

static const char *smc, *machine, *script;
static char whole[1 << 20];                           // the trace of a run without a signal
static size_t whole_n;

// Every POSIX signal that ends a process unless it is caught, except those that a program's own faults cause.
static const int numbers[] = {SIGINT, SIGTERM, SIGHUP, SIGPIPE, SIGQUIT, SIGXCPU, SIGALRM, SIGVTALRM, SIGPROF, SIGUSR1, SIGUSR2};
enum { NUMBERS = sizeof numbers / sizeof *numbers, AT_ANY_TIME = 3 };       // the first AT_ANY_TIME signals are sent at many times

static void sleep_ms(long ms)
{
    const struct timespec t = {ms / 1000, ms % 1000 * 1000000};

    nanosleep(&t, NULL);
}

// Starts the command in its own process group, as a shell does.  `output` is its standard output.
static pid_t start_with(const char *engine, int output)
{
    const struct rlimit none = {0, 0};
    const pid_t pid = fork();

    if (pid == 0) {
        const int quiet = open("/dev/null", O_WRONLY);
        setpgid(0, 0);
        for (size_t i = 0; i < NUMBERS; i++)
            signal(numbers[i], SIG_DFL);              // a shell that runs tests in the background ignores some
        setrlimit(RLIMIT_CORE, &none);
        dup2(output < 0 ? quiet : output, 1);
        dup2(quiet, 2);
        execl(smc, "smc", "test", machine, script, engine, "--trace=made/trace.csv", (char *)NULL);
        _exit(127);
    }
    return pid;
}

static pid_t start(const char *cc)
{
    setenv("CC", cc, 1);
    return start_with("--engine=c", -1);
}

static int end_of(pid_t pid)
{
    int status;

    while (waitpid(pid, &status, 0) < 0)
        continue;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

static size_t entries(const char *folder)
{
    const char *why;
    char **names;
    size_t n = 99;

    if (os_list_folder(folder, &names, &n, &why))
        os_alloc(NULL, names, 0);
    return n;
}

// A compiler that writes the ids of itself and of a child to `ids` and then waits.  It answers --version at once.  A signal ends it before it
// has removed its temporary file, as can happen to gcc.
static void make_slow_compiler(void)
{
    static const char text[] = "#!/bin/sh\n[ \"$1\" = --version ] && exit 0\n: >\"$TMPDIR/own\"\nsleep 30 &\necho $$ $! >ids.new\nmv ids.new ids\nwait\n";
    const OsOutput out = {"slow cc", text, sizeof text - 1};
    const char *failed, *why;

    CHECK(os_write_files(&out, 1, &failed, &why) && chmod("slow cc", 0755) == 0);
}

static bool read_ids(long *a, long *b)
{
    FILE *f = fopen("ids", "r");
    bool ok = f && fscanf(f, "%ld %ld", a, b) == 2;

    if (f)
        fclose(f);
    return ok;
}

// Whether the process has ended.  Its parent may notice this later.
static bool has_ended(long pid)
{
    for (int i = 0; i < 200; i++, sleep_ms(10))
        if (kill((pid_t)pid, 0) != 0)
            return true;
    return false;
}

static void during_the_compiler(int number)
{
    long compiler = 0, child = 0;
    pid_t pid;

    remove("ids");
    pid = start("'./slow cc'");
    for (int i = 0; i < 1000 && !read_ids(&compiler, &child); i++)
        sleep_ms(10);
    CHECK(compiler > 0 && child > 0 && entries("tmp") == 1);
    kill(pid, number);
    CHECK(end_of(pid) == 128 + number);
    CHECK(compiler > 0 && has_ended(compiler) && child > 0 && has_ended(child));
    CHECK(entries("tmp") == 0 && entries("made") == 0);
}

static size_t read_trace(char *out, size_t most)
{
    FILE *f = fopen("made/trace.csv", "rb");
    const size_t n = f ? fread(out, 1, most, f) : 0;

    if (f)
        fclose(f);
    return n;
}

static void undisturbed(void)
{
    CHECK(end_of(start("cc")) == 0);
    whole_n = read_trace(whole, sizeof whole);
    CHECK(whole_n > 0 && whole_n < sizeof whole && remove("made/trace.csv") == 0);
}

static bool is_whole(void)
{
    static char now[sizeof whole];

    return read_trace(now, sizeof now) == whole_n && memcmp(now, whole, whole_n) == 0;
}

// Sends a signal after a number of milliseconds, with the real compiler.  The command may have ended by then, or have written its trace.
static void test_signal_at_any_time(int number, long ms)
{
    const pid_t pid = start("cc");
    int code;

    sleep_ms(ms);
    kill(pid, number);
    code = end_of(pid);
    CHECK(code == 0 || code == 128 + number);
    CHECK(entries("tmp") == 0);
    CHECK(entries("made") == 1 ? is_whole() : entries("made") == 0 && code != 0);
    remove("made/trace.csv");
}

// As in `smc test ...  piped to true`: the report is written while the trace is unfinished.
static void test_closed_pipe(void)
{
    static const char *const engines[] = {"--engine=vm", "--engine=c"};
    int end[2];

    setenv("CC", "cc", 1);
    for (size_t i = 0; i < sizeof engines / sizeof *engines; i++) {
        CHECK(pipe(end) == 0 && close(end[0]) == 0);
        CHECK(end_of(start_with(engines[i], end[1])) == 128 + SIGPIPE);
        CHECK(close(end[1]) == 0 && entries("tmp") == 0 && entries("made") == 0);
    }
}

int main(int argc, char **argv)
{
    char tmp[1000];

    if (argc != 5 || chdir(argv[4]) != 0 || mkdir("tmp", 0777) != 0 || mkdir("made", 0777) != 0)
        return 2;
    smc = argv[1];
    machine = argv[2];
    script = argv[3];
    snprintf(tmp, sizeof tmp, "%s/tmp", argv[4]);
    setenv("TMPDIR", tmp, 1);
    make_slow_compiler();
    undisturbed();
    test_closed_pipe();
    for (size_t i = 0; i < NUMBERS; i++) {
        during_the_compiler(numbers[i]);
        for (long ms = 1; ms < 400 && i < AT_ANY_TIME; ms += 23)
            test_signal_at_any_time(numbers[i], ms);
    }
    return test_end("host-signals");
}
