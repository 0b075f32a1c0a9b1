// SPDX-License-Identifier: Apache-2.0
// Hosts and an application as separate processes, connected by a socket, TCP or a serial line.  Either is killed with SIGKILL at every stage,
// and `smc swap` itself is run.  Clauses 12.43 to 12.54 of docs/swapping.md.  The application counts in the element `out`; it stops when the
// test closes a pipe.
//     reach SMC               tests
//     reach SMC --measure     prints how long a swap takes on this computer
#define _GNU_SOURCE
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "compiler/base/os_serial.h"
#include "compiler/device/app_host.h"
#include "runtime-c/pal/clock.h"
#include "tests/swap/stage.h"
#include "tests/test.h"

#define COUNT(by) A "[local]\nU32 n = 0\n[A] @swap\n.step\nn = n + " #by "\nout = n\n"
#define WAITS A "[local]\nU32 n = 0\n[A]\n.step\nn = n + 1\nout = n\n-> B\n[B] @swap\n.step\nout = n\n"

static SwapMachine one, ten;
static const char *smc;
static char socket_name[] = "stand.sock";
static const char *storage;   // the file of the application's storage; NULL: none

// ---- the application ----

typedef struct Process { pid_t pid; } Process;

static void run_application(SmSwapPlace place, const char *name, uint16_t port, const char *key)
{
    const StagePlan plan = {.a = &one, .room = STAGE_ROOM, .trial = 3000, .period = {PAL_MILLISECOND, 0}};

    stage_set_up(&plan);
    stage_reach(place, name, key);
    stage.link.number_memory = key != NULL ? "numbers" : NULL;
    stage.link.address.port = port;
    if (storage != NULL)
        stage_store(storage, 4096, key != NULL ? stage.link.key : NULL);
    _exit(sm_app_run(&stage.app) == SM_OK ? 0 : 1);
}

static pid_t start(SmSwapPlace place, const char *name, uint16_t port, const char *key)
{
    const pid_t pid = fork();

    if (pid == 0)
        run_application(place, name, port, key);
    return pid;
}

static void end(pid_t pid)
{
    int status;

    CHECK(kill(pid, SIGKILL) == 0 && waitpid(pid, &status, 0) == pid);
}

// ---- a host ----

typedef struct Host {
    int fd;
    SerialLine line;
    LinkHost link;
    ApplicationInfo info;
} Host;

static bool host_send(void *context, const uint8_t *bytes, size_t n) { return os_serial_send(((Host *)context)->fd, bytes, n); }
static int host_receive(void *context, uint8_t *bytes, size_t room, uint32_t wait) { return os_serial_receive(((Host *)context)->fd, bytes, room, wait); }
static uint32_t host_now(void *context) { (void)context; return os_milliseconds(); }

static void sleep_ms(unsigned ms) { (void)usleep(1000 * ms); }

static bool use_descriptor(Host *h, int fd)
{
    h->fd = fd;
    h->line = (SerialLine){h, host_send, host_receive, host_now};
    link_host_init(&h->link, &h->line, 500, 4, 1);
    return application_query(&h->link, &h->info);
}

// Connects as soon as the application accepts connections.
static bool connect_host(Host *h, const char *where)
{
    const char *why;
    bool open = false;
    int fd;

    for (int i = 0; i < 100 && !open; i++) {
        open = os_line_open(where, 115200, &fd, &why);
        if (!open)
            sleep_ms(20);
    }
    return open && use_descriptor(h, fd);
}

static void make_swap(Buf *out, const SwapMachine *m)
{
    const ApplicationChange change = {"a", SM_SWAP_CONTINUE, NULL, m->image, m->image_size};

    buf_init(out, &one.session.arena);
    application_write_swap(&change, 1, NULL, 0, out);
}

static uint8_t wait_for_phase(Host *h, SmSwapPhase last)
{
    ApplicationSwap s = {0};

    for (int i = 0; i < 500 && application_read_swap(&h->link, &s) && s.phase <= (uint8_t)last && s.phase != SM_SWAP_IDLE; i++)
        sleep_ms(5);
    return s.phase;
}

static uint32_t running_checksum(Host *h)
{
    ApplicationMachine m;

    return application_read_machine(&h->link, 0, &m) ? m.checksum : 0;
}

// Sends a swap, waits for its trial and confirms it.
static void swap_and_confirm(Host *h, const SwapMachine *m, uint16_t session)
{
    ApplicationSwap s;
    Buf swap;

    make_swap(&swap, m);
    CHECK(application_send_swap(&h->link, &h->info, &swap, NULL, 0, session) == APPLICATION_DONE);
    CHECK(wait_for_phase(h, SM_SWAP_WAITING) == SM_SWAP_TRIAL && running_checksum(h) == stage_identity(m));
    CHECK(application_read_swap(&h->link, &s) && application_confirm(&h->link, &s, NULL));
    CHECK(wait_for_phase(h, SM_SWAP_TRIAL) == SM_SWAP_CONFIRMED);
}

// ---- places ----

static void test_path(void)
{
    struct stat s;
    Host h;
    pid_t first, second;
    int status;

    // clause 12.44: the access mode of the socket
    first = start(SM_SWAP_AT_PATH, socket_name, 0, NULL);
    CHECK(connect_host(&h, socket_name) && stat(socket_name, &s) == 0 && (s.st_mode & 0777) == 0600);
    swap_and_confirm(&h, &ten, 3);
    close(h.fd);
    // another application already uses the socket
    second = start(SM_SWAP_AT_PATH, socket_name, 0, NULL);
    CHECK(waitpid(second, &status, 0) == second && WIFEXITED(status) && WEXITSTATUS(status) == 1);
    CHECK(connect_host(&h, socket_name) && running_checksum(&h) == stage_identity(&ten));
    close(h.fd);
    // clause 12.48: after a restart the built-in machine runs; clause 12.44: a socket of a killed application is replaced
    end(first);
    CHECK(stat(socket_name, &s) == 0 && S_ISSOCK(s.st_mode));
    first = start(SM_SWAP_AT_PATH, socket_name, 0, NULL);
    CHECK(connect_host(&h, socket_name) && running_checksum(&h) == stage_identity(&one));
    close(h.fd);
    end(first);
    // the path is a file that is not a socket
    CHECK(unlink(socket_name) == 0 && close(open(socket_name, O_CREAT | O_WRONLY, 0644)) == 0);
    first = start(SM_SWAP_AT_PATH, socket_name, 0, NULL);
    CHECK(waitpid(first, &status, 0) == first && WIFEXITED(status) && WEXITSTATUS(status) == 1);
    CHECK(stat(socket_name, &s) == 0 && S_ISREG(s.st_mode) && unlink(socket_name) == 0);
}

// clause 12.45: without an address, the loopback interface is used
static void test_tcp(void)
{
    const uint16_t port = (uint16_t)(20000 + getpid() % 20000);
    char where[32];
    Host h;
    const pid_t app = start(SM_SWAP_AT_ADDRESS, "", port, NULL);

    snprintf(where, sizeof where, ":%u", (unsigned)port);
    CHECK(connect_host(&h, where));
    swap_and_confirm(&h, &ten, 3);
    close(h.fd);
    end(app);
}

// clause 12.35: a serial line
static void test_line(void)
{
    const int master = posix_openpt(O_RDWR | O_NOCTTY);
    Host h;
    pid_t app;

    if (master < 0 || grantpt(master) != 0 || unlockpt(master) != 0) {
        printf("swap/reach: no pseudo-terminal, so no serial line\n");
        return;
    }
    app = start(SM_SWAP_AT_LINE, ptsname(master), 0, NULL);
    sleep_ms(300);
    CHECK(use_descriptor(&h, master));
    swap_and_confirm(&h, &ten, 3);
    end(app);
    close(master);
}

// ---- ends ----

// clause 12.43: a host is killed in the middle of a transfer, and another one follows
static void test_killed_host(void)
{
    const pid_t app = start(SM_SWAP_AT_PATH, socket_name, 0, NULL);
    Host h;
    Buf swap;
    pid_t host;
    int status;

    make_swap(&swap, &ten);
    host = fork();
    if (host == 0) {
        uint8_t body[9] = {7};
        sm_link_store(body + 2, (uint32_t)swap.n, 3);
        if (connect_host(&h, socket_name) && link_request(&h.link, LINK_BEGIN, body, sizeof body))
            (void)kill(getpid(), SIGKILL);
        _exit(1);
    }
    CHECK(waitpid(host, &status, 0) == host && WIFSIGNALED(status));
    CHECK(connect_host(&h, socket_name) && running_checksum(&h) == stage_identity(&one));
    CHECK(application_send_swap(&h.link, &h.info, &swap, NULL, 0, 3) == APPLICATION_BEGIN && h.link.result == SM_E_BUSY);
    sleep_ms(3100);
    swap_and_confirm(&h, &ten, 4);
    close(h.fd);
    end(app);
}

// clauses 12.33, 12.48: the application is killed after each stage of a swap.  It starts again with the built-in machine.
static void test_killed_application(void)
{
    Buf swap;

    make_swap(&swap, &ten);
    for (int stage_of_swap = 0; stage_of_swap < 6; stage_of_swap++) {
        Host h;
        ApplicationSwap s;
        uint8_t body[200] = {7};
        pid_t app = start(SM_SWAP_AT_PATH, socket_name, 0, NULL);

        CHECK(connect_host(&h, socket_name));
        sm_link_store(body + 2, (uint32_t)swap.n, 3);
        sm_link_store(body + 5, application_swap_checksum(&swap), 4);
        if (stage_of_swap == 1 || stage_of_swap == 2)
            CHECK(link_request(&h.link, LINK_BEGIN, body, 9) && h.link.result == SM_OK);
        if (stage_of_swap == 2) {
            sm_link_store(body + 2, 0, 3);
            memcpy(body + 5, swap.at, 100);
            CHECK(link_request(&h.link, LINK_DATA, body, 105) && h.link.result == SM_OK);
        }
        if (stage_of_swap >= 3)
            CHECK(application_send_swap(&h.link, &h.info, &swap, NULL, 0, 3) == APPLICATION_DONE);
        if (stage_of_swap >= 4)
            CHECK(wait_for_phase(&h, SM_SWAP_WAITING) == SM_SWAP_TRIAL);
        if (stage_of_swap >= 5)
            CHECK(application_read_swap(&h.link, &s) && application_confirm(&h.link, &s, NULL));
        end(app);
        CHECK(!application_read_swap(&h.link, &s) && !h.link.answered);
        close(h.fd);
        app = start(SM_SWAP_AT_PATH, socket_name, 0, NULL);
        CHECK(connect_host(&h, socket_name) && running_checksum(&h) == stage_identity(&one));
        swap_and_confirm(&h, &ten, 5);
        close(h.fd);
        end(app);
    }
}

// clauses 12.48, 12.49: the application is killed as soon as CONFIRM is answered.  It starts with the new machine.
static void test_stored(void)
{
    const SwapMachine *const other[] = {&ten, &one};

    storage = "stored";
    for (int i = 0; i < 2; i++) {
        ApplicationSwap s;
        ApplicationMachine m;
        Buf swap;
        Host h;
        pid_t app = start(SM_SWAP_AT_PATH, socket_name, 0, NULL);

        make_swap(&swap, other[i]);
        CHECK(connect_host(&h, socket_name) && running_checksum(&h) == stage_identity(i == 0 ? &one : &ten));
        CHECK(application_send_swap(&h.link, &h.info, &swap, NULL, 0, 3) == APPLICATION_DONE && wait_for_phase(&h, SM_SWAP_WAITING) == SM_SWAP_TRIAL);
        CHECK(application_read_swap(&h.link, &s) && application_confirm(&h.link, &s, NULL));
        end(app);
        close(h.fd);
        app = start(SM_SWAP_AT_PATH, socket_name, 0, NULL);
        CHECK(connect_host(&h, socket_name) && running_checksum(&h) == stage_identity(other[i]));
        CHECK(application_read_machine(&h.link, 0, &m) && m.is_built_in == (i == 1) && m.is_stored == (i == 0));
        close(h.fd);
        end(app);
    }
    storage = NULL;
}

// ---- the command ----

static int command(const char *arguments)
{
    char line[512];
    int status;

    snprintf(line, sizeof line, "%s %s >out 2>&1", smc, arguments);
    status = system(line);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

// Whether the output of the last command contains a text.
static bool printed(const char *text)
{
    static char out[8192];
    FILE *f = fopen("out", "r");
    const size_t n = f ? fread(out, 1, sizeof out - 1, f) : 0;

    if (f)
        fclose(f);
    out[n] = '\0';
    if (strstr(out, text) == NULL)
        printf("'%s' is not in:\n%s", text, out);
    return strstr(out, text) != NULL;
}

static void write_file(const char *name, const char *text)
{
    FILE *f = fopen(name, "w");

    CHECK(f != NULL && fputs(text, f) >= 0 && fclose(f) == 0);
}

// clause 12.53, clause 12.54
static void test_command(void)
{
    pid_t app = start(SM_SWAP_AT_PATH, socket_name, 0, NULL);
    Host h;
    int status;

    write_file("stage.sv", STAGE_SV);
    write_file("a.sm", COUNT(10));
    write_file("other.sm", "[state_vector]\nU64 t @alias G\nU32 s @alias S\n[B] @swap\n");
    write_file("waits.sm", WAITS);
    CHECK(connect_host(&h, socket_name));
    close(h.fd);
    CHECK(command("swap a.sm --sv stage.sv -w --to=stand.sock") == 2 && printed("swap requires --continue or --restart"));
    CHECK(command("swap a.sm --sv stage.sv -w --to=stand.sock --continue --confirm") == 0);
    CHECK(printed("kept     state A, local n") && printed("confirmed until the application ends") && printed("swap_store"));
    CHECK(command("swap a.sm --sv stage.sv -w --to=stand.sock --restart=A --wait") == 1 && printed("it was not confirmed in time"));
    CHECK(command("swap a.sm --sv stage.sv -w --to=stand.sock --restart=Nowhere") == 1 && printed("no state of the name"));
    CHECK(command("swap other.sm -w --to=stand.sock --continue") == 1 && printed("those that can be swapped are: a"));
    CHECK(command("swap a=other.sm -w --to=stand.sock --continue") == 1 && printed("compiled for another state vector") && printed("--sv=stand.sv"));
    // clause 10.32: the bindings of a machine, from the application or from --bind
    write_file("any.sm", "[state_vector]\nU64 time @alias G\nU32 state @alias S\nF64 p\nF64 x\n[A] @swap\n.step\n    x = p\n");
    write_file("stage.app", "[options]\nstate_vector \"stage.sv\"\ntime time 1 ms\n[e]\nevery 1 ms:\nmachine a \"any.sm\" { state = sa  x = out } @bytecode\n");
    CHECK(command("swap a=any.sm --app stage.app -w --to=stand.sock --restart --confirm") == 0);
    CHECK(command("swap a=any.sm --sv stage.sv --bind state=sa,x=more -w --to=stand.sock --restart --confirm") == 0);
    CHECK(command("swap a=any.sm --sv stage.sv -w --to=stand.sock --restart") == 1 && printed("no element 'state'"));
    CHECK(command("swap b=any.sm --app stage.app -w --to=stand.sock --restart") == 1 && printed("no machine 'b'; its machines are: a"));
    CHECK(command("swap a=any.sm --app stage.app --sv stage.sv --to=stand.sock --restart") == 2 && printed("neither --sv nor --bind"));
    CHECK(command("swap a.sm --sv stage.sv -w --to=stand.sock --restart --confirm") == 0);
    CHECK(command("build a.sm --sv stage.sv -w -g -o new.smb") == 0);
    CHECK(command("swap a=new.smb --to=stand.sock --continue") == 0 && printed("on trial"));
    CHECK(command("swap a=new.smb --to=stand.sock --continue") == 1 && printed("another swap is in progress"));
    CHECK(command("device list --port=stand.sock") == 0 && printed("on trial"));
    CHECK(command("device confirm --port=stand.sock") == 0 && printed("was confirmed"));
    CHECK(command("device confirm --port=stand.sock") == 1 && printed("no swap is on trial"));
    CHECK(command("device info --port=stand.sock") == 0 && printed("application stage: 1 machine,"));
    CHECK(command("device log --port=stand.sock") == 0 && printed("SWAP of machine 0"));
    CHECK(command("device erase 00112233 --port=stand.sock") == 1);
    CHECK(command("flash new.smb --port=stand.sock") == 1 && printed("is an application and not a board: 'smc swap"));
    CHECK(command("swap a=waits.sm --sv stage.sv -w --to=stand.sock --restart --confirm") == 0);
    end(app);
    CHECK(command("swap a.sm --sv stage.sv -w --to=stand.sock --continue") == 3);
    // clause 12.51: with a storage, and a return to the built-in machine
    storage = "stored";
    app = start(SM_SWAP_AT_PATH, socket_name, 0, NULL);
    CHECK(connect_host(&h, socket_name));
    close(h.fd);
    CHECK(command("device info --port=stand.sock") == 0 && printed(", built in"));
    CHECK(command("swap a.sm --sv stage.sv -w --to=stand.sock --continue --confirm") == 0 && printed("also runs after a restart"));
    CHECK(command("device info --port=stand.sock") == 0 && printed(", stored"));
    end(app);
    app = start(SM_SWAP_AT_PATH, socket_name, 0, NULL);
    CHECK(connect_host(&h, socket_name));
    close(h.fd);
    CHECK(command("device info --port=stand.sock") == 0 && printed(", stored"));
    CHECK(command("device log --port=stand.sock") == 0 && printed("STORED of machine 0, image "));
    CHECK(command("device erase 00112233 --port=stand.sock") == 1 && printed("smc swap NAME=built-in"));
    CHECK(command("swap a=built-in --to=stand.sock --continue") == 0 && printed("the built-in image"));
    CHECK(command("device confirm --port=stand.sock") == 0 && printed(", built in"));
    end(app);
    storage = NULL;
    CHECK(command("swap built-in --to=stand.sock --continue") == 2 && printed("'built-in' is not a machine"));
    // clause 12.46, clause 12.47: with a key.  If its file is missing, the application does not start, and creates no file.
    app = start(SM_SWAP_AT_PATH, socket_name, 0, "absent.key");
    CHECK(waitpid(app, &status, 0) == app && WIFEXITED(status) && WEXITSTATUS(status) == 1);
    CHECK(access("absent.key", F_OK) != 0 && access("numbers", F_OK) != 0);
    CHECK(command("key stand.key") == 0 && command("key other.key") == 0);
    app = start(SM_SWAP_AT_PATH, socket_name, 0, "stand.key");
    CHECK(connect_host(&h, socket_name) && h.info.requires_signature);
    close(h.fd);
    CHECK(command("swap a.sm --sv stage.sv -w --to=stand.sock --continue") == 1 && printed("name the file of the key with --key"));
    CHECK(command("swap a.sm --sv stage.sv -w --to=stand.sock --continue --key=other.key") == 1 && printed("not with key"));
    for (int i = 0; i < 3; i++)                            // more than one request in a second
        CHECK(command("swap a.sm --sv stage.sv -w --to=stand.sock --continue --confirm --key=stand.key") == 0 && printed("confirmed"));
    CHECK(command("swap a.sm --sv stage.sv -w --to=stand.sock --continue --key=stand.key") == 0 && printed("on trial"));
    CHECK(command("device confirm --port=stand.sock") == 1 && command("device confirm --port=stand.sock --key=stand.key") == 0);
    end(app);
}

// ---- times ----

enum { SWAPS_MEASURED = 101, STATES = 60 };

static int compare_times(const void *a, const void *b)
{
    const uint64_t x = *(const uint64_t *)a, y = *(const uint64_t *)b;

    return (x > y) - (x < y);
}

static void print_median(const char *what, uint64_t *ns)
{
    qsort(ns, SWAPS_MEASURED, sizeof *ns, compare_times);
    printf("  %-40s %8.1f us, at most %8.1f us\n", what, (double)ns[SWAPS_MEASURED / 2] / 1000, (double)ns[SWAPS_MEASURED - 1] / 1000);
}

// Writes a machine of at least 300 lines: STATES states of five lines, locals and windows.
static char *long_machine(void)
{
    static char text[STATES * 160 + 1024];
    size_t n = (size_t)snprintf(text, sizeof text, "%s[local]\nF64 n = 0\n", A);

    for (int i = 0; i < STATES; i++)
        n += (size_t)snprintf(text + n, sizeof text - n, "[S%d] @swap\n.step\n    n = n + roll_avg(p + %d, 8)\n    out = n * %d\n    p > %d: -> S%d\n", i, i % 4, i,
                              1000 + i, (i + 1) % STATES);
    return text;
}

// Measures on this computer how long a swap of a machine of 300 lines for itself takes, in one thread.
static void measure(void)
{
    static SwapMachine m;
    uint64_t prepare[SWAPS_MEASURED], with[SWAPS_MEASURED], without[SWAPS_MEASURED], t;
    const StagePlan plan = {.a = &m, .room = STAGE_ROOM, .trial = 1000000};

    machine_compile(&m, long_machine(), STAGE_SV, 2, true);
    stage_begin(&plan);
    for (int i = 0; i < SWAPS_MEASURED; i++) {
        stage_tick(0);
        (void)pal_clock_sleep_until(sm_executor_due(&stage.executor[0]));
        t = pal_clock_now();
        sm_executor_tick(&stage.executor[0]);
        without[i] = pal_clock_now() - t;
        CHECK(stage_swap("a", &m, SM_SWAP_CONTINUE, NULL) == SM_OK);
        t = pal_clock_now();
        while (sm_swaps_prepare(&stage.swaps)) {}
        prepare[i] = pal_clock_now() - t;
        (void)pal_clock_sleep_until(sm_executor_due(&stage.executor[0]));
        t = pal_clock_now();
        sm_executor_tick(&stage.executor[0]);
        with[i] = pal_clock_now() - t;
        CHECK(stage_phase() == SM_SWAP_TRIAL && sm_swap_confirm(&stage.swaps) == SM_OK);
    }
    printf("swap of a machine with %d states, an image of %u bytes; median and most of %d:\n", STATES, (unsigned)m.image_size, SWAPS_MEASURED);
    print_median("preparation", prepare);
    print_median("a tick with the exchange", with);
    print_median("a tick without", without);
    machine_free(&m);
}

int main(int argc, char **argv)
{
    const char *base = getenv("TMPDIR");
    char folder[200], *full;

    if (argc > 2 && strcmp(argv[2], "--measure") == 0) {
        measure();
        return test_end("swap/reach");
    }
    snprintf(folder, sizeof folder, "%s/smc-reach.XXXXXX", base && strlen(base) < 150 ? base : P_tmpdir);
    if (argc < 2 || (full = realpath(argv[1], NULL)) == NULL || mkdtemp(folder) == NULL || chdir(folder) != 0)
        return 1;
    smc = full;
    (void)signal(SIGPIPE, SIG_IGN);
    machine_compile(&one, COUNT(1), STAGE_SV, 2, true);
    machine_compile(&ten, COUNT(10), STAGE_SV, 2, true);
    test_path();
    test_tcp();
    test_line();
    test_killed_host();
    test_killed_application();
    test_stored();
    test_command();
    machine_free(&one);
    machine_free(&ten);
    free(full);
    if (chdir("/") == 0) {
        char line[256];
        snprintf(line, sizeof line, "rm -rf %s", folder);
        CHECK(system(line) == 0);
    }
    return test_end("swap/reach");
}
