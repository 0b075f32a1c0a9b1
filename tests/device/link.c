// SPDX-License-Identifier: Apache-2.0
// Tests smc flash and smc device with a board that is a program (board.c).  This program connects them through terminals.  It loses and damages
// bytes, and kills the board or smc during an update.  Afterwards the old or the new image must run, and another update must succeed.
//   link SMC BOARD FOLDER OLD.smb NEW.smb PARAMETERS.smb [RUNS [SEED]]         with SLOTS=1 in the environment the board has one slot
//   link forge SIGNED.smb [N]     changes the code of a signed image, at its last byte or the N-th from the end, and corrects the checksum
#define _XOPEN_SOURCE 700
#define _DEFAULT_SOURCE
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <termios.h>
#include <time.h>
#include <unistd.h>

#include "stdlib/crc32.h"
#include "tests/test.h"

enum { TEXT = 4096, ARGS = 8, PATH = 512 };

typedef struct Terminal { int master, slave; char name[128]; } Terminal;

typedef struct Trouble {
    unsigned bad;             // one byte in this many is lost or damaged; 0: none
    long kill_board, kill_smc;        // after this many bytes in both directions; 0: never
    bool for_good;            // the board is not started again after it was killed
} Trouble;

static Terminal at_board, at_smc;
static const char *smc, *board, *images[2], *with_parameters;
static char memory[PATH], output[PATH], said[TEXT];
static pid_t board_pid;
static bool one_slot;                  // the image that is built into the board may run, too
static uint64_t random_state = 88172645463325252u;

static unsigned random_below(unsigned n)
{
    random_state ^= random_state << 13;
    random_state ^= random_state >> 7;
    random_state ^= random_state << 17;
    return (unsigned)(random_state >> 11) % n;
}

// ---- terminals and programs ----

static bool open_terminal(Terminal *t)
{
    struct termios raw;

    t->master = posix_openpt(O_RDWR | O_NOCTTY);
    if (t->master < 0 || grantpt(t->master) != 0 || unlockpt(t->master) != 0)
        return false;
    snprintf(t->name, sizeof t->name, "%s", ptsname(t->master));
    t->slave = open(t->name, O_RDWR | O_NOCTTY);             // held open, so that the terminal continues to exist when a program ends
    if (t->slave < 0 || tcgetattr(t->slave, &raw) != 0)
        return false;
    cfmakeraw(&raw);
    return tcsetattr(t->slave, TCSANOW, &raw) == 0 && fcntl(t->master, F_SETFD, FD_CLOEXEC) == 0 &&
           fcntl(t->slave, F_SETFD, FD_CLOEXEC) == 0;
}

static pid_t start(const char *const *argv, const char *to)
{
    const pid_t pid = fork();

    if (pid == 0) {
        const int fd = open(to, O_WRONLY | O_CREAT | O_TRUNC, 0644);
        dup2(fd, 1);
        dup2(fd, 2);
        execv(argv[0], (char *const *)(size_t)argv);
        _exit(127);
    }
    return pid;
}

static void start_board(void)
{
    const char *const argv[] = {board, at_board.name, memory, NULL};

    ioctl(at_board.slave, TIOCNXCL);                         // removes the exclusive access that the program before had requested
    board_pid = start(argv, "/dev/null");
}

static void kill_board(void)
{
    int status;

    kill(board_pid, SIGKILL);
    waitpid(board_pid, &status, 0);
}

// ---- the line ----

static long carry_bytes(int from, int to, const Trouble *t)
{
    unsigned char bytes[256], out[256];
    const ssize_t got = read(from, bytes, sizeof bytes);
    size_t n = 0;

    for (ssize_t i = 0; i < got; i++) {
        const unsigned bad = t->bad ? random_below(t->bad * 2) : 2;
        if (bad != 0)
            out[n++] = bad == 1 ? (unsigned char)(bytes[i] ^ (1u << random_below(8))) : bytes[i];
    }
    return n > 0 && write(to, out, n) != (ssize_t)n ? 0 : got > 0 ? got : 0;
}

static void read_output(void)
{
    FILE *f = fopen(output, "r");
    const size_t n = f ? fread(said, 1, TEXT - 1, f) : 0;

    said[n] = '\0';
    if (f)
        fclose(f);
}

// Runs smc with these arguments and the port.  Returns its exit code, or 128 + the signal that ended it.
static int run_smc(const Trouble *t, const char *a, const char *b, const char *c, const char *d)
{
    char port[160];
    const char *const argv[ARGS] = {smc, a, b, port, c, c ? d : NULL, NULL};
    struct pollfd p[2] = {{at_board.master, POLLIN, 0}, {at_smc.master, POLLIN, 0}};
    long carried = 0;
    int status;
    pid_t pid;

    snprintf(port, sizeof port, "--port=%s", at_smc.name);
    tcflush(at_smc.slave, TCIOFLUSH);
    ioctl(at_smc.slave, TIOCNXCL);
    pid = start(argv, output);
    while (waitpid(pid, &status, WNOHANG) == 0) {
        const long before = carried;
        if (poll(p, 2, 5) > 0) {
            carried += p[0].revents & POLLIN ? carry_bytes(at_board.master, at_smc.master, t) : 0;
            carried += p[1].revents & POLLIN ? carry_bytes(at_smc.master, at_board.master, t) : 0;
        }
        if (t->kill_smc && before < t->kill_smc && carried >= t->kill_smc)
            kill(pid, random_below(2) ? SIGKILL : SIGINT);
        if (t->kill_board && before < t->kill_board && carried >= t->kill_board) {
            kill_board();
            if (!t->for_good)
                start_board();
        }
    }
    read_output();
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

static const Trouble none;
static int run_on_good_line(const char *a, const char *b, const char *c) { return run_smc(&none, a, b, c, NULL); }
static int set_on_good_line(const char *setting, const char *option) { return run_smc(&none, "device", "set", setting, option); }
static bool output_contains(const char *text) { return strstr(said, text) != NULL; }

// ---- tests ----

static void checksum_of(const char *path, char text[9])
{
    unsigned char head[8] = {0};
    FILE *f = fopen(path, "rb");

    if (f) {
        CHECK(fread(head, 1, 8, f) == 8);
        fclose(f);
    }
    snprintf(text, 9, "%02x%02x%02x%02x", head[7], head[6], head[5], head[4]);
}

// Whether the line of the list with this checksum contains `what`.
static bool is_listed(const char *path, const char *what)
{
    char checksum[9];
    const char *line, *end, *found;

    checksum_of(path, checksum);
    if ((line = strstr(said, checksum)) == NULL || (end = strchr(line, '\n')) == NULL)
        return false;
    found = strstr(line, what);
    return found && found < end;
}

static void test_image_is_sent_and_stored(void)
{
    CHECK(run_on_good_line("device", "list", NULL) == 0 && output_contains("slot 0: no image") && output_contains("built in: "));
    CHECK(run_on_good_line("device", "confirm", NULL) == 1 && output_contains("nothing to confirm"));
    CHECK(run_on_good_line("flash", images[0], "--dry-run") == 0 && output_contains("nothing was sent"));
    CHECK(run_on_good_line("flash", images[0], NULL) == 0 && output_contains("on trial (2 starts left)") && output_contains("without that, the previous image runs again"));
    CHECK(run_on_good_line("device", "info", NULL) == 0 && output_contains("no update may begin: image ") && output_contains(" is on trial; 'smc device confirm' keeps it"));
    CHECK(run_on_good_line("flash", images[0], "--period=7") == 1 && output_contains("nothing was sent: image "));
    CHECK(run_on_good_line("flash", images[0], "--dry-run") == 0 && output_contains(" runs already; nothing was sent"));
    CHECK(run_on_good_line("flash", images[1], NULL) == 1 && output_contains("on trial; 'smc device confirm' keeps it, 'smc device erase "));
    CHECK(run_on_good_line("flash", images[1], "--dry-run") == 1 && output_contains("nothing was sent: ") && output_contains("on trial; 'smc device confirm' keeps it, 'smc device erase "));
    CHECK(run_on_good_line("device", "confirm", NULL) == 0 && is_listed(images[0], ", confirmed"));
    CHECK(run_on_good_line("device", "confirm", NULL) == 1 && output_contains("no image is on trial") && is_listed(images[0], ", runs, confirmed"));
    CHECK(run_on_good_line("flash", images[0], NULL) == 0 && output_contains("it runs already"));
    CHECK(run_on_good_line("flash", images[1], "--confirm") == 0 && is_listed(images[1], ", runs, confirmed"));
    CHECK(run_on_good_line("device", "info", NULL) == 0 && output_contains("2 slots of ") && output_contains("an update may begin"));
    CHECK(run_on_good_line("device", "log", NULL) == 0 && output_contains("START of app 0") && output_contains("STATE of machine 0, from 0, to 1"));
}

static void arm_board(bool armed)
{
    char path[PATH + 8];
    FILE *f;

    snprintf(path, sizeof path, "%s.armed", memory);
    if (armed)
        CHECK((f = fopen(path, "w")) != NULL && fclose(f) == 0);
    else
        CHECK(remove(path) == 0);
}

static void test_armed_board_refuses(void)
{
    arm_board(true);
    CHECK(run_on_good_line("flash", images[0], NULL) == 1 && output_contains("nothing was sent: the board is armed; disarm it first"));
    CHECK(run_on_good_line("device", "confirm", NULL) == 1 && output_contains("the board is armed"));
    CHECK(run_on_good_line("device", "info", NULL) == 0 && output_contains("no update may begin: it is armed"));
    arm_board(false);
    CHECK(run_on_good_line("device", "list", NULL) == 0 && is_listed(images[1], ", runs"));
}

// Runs smc without a board.
static int run_without_board_argv(const char *const *argv)
{
    int status;
    const pid_t pid = start(argv, output);

    waitpid(pid, &status, 0);
    read_output();
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128;
}

static int run_without_board(const char *a, const char *b, const char *c, const char *d)
{
    const char *const argv[ARGS] = {smc, a, b, c, d, NULL};

    return run_without_board_argv(argv);
}

static void restart_board(void)
{
    kill_board();
    start_board();
}

// Restarts the board until its list has the text for the image.  Returns the number of restarts.  A trial has STARTS_MOST short starts.  Each
// start lasts `ms` milliseconds and the time of a list.
enum { STARTS_MOST = 12 };
static int restarts_until(const char *image, const char *text, long ms)
{
    const struct timespec pause = {ms / 1000, ms % 1000 * 1000000};
    int n = 0;

    do {
        restart_board();
        nanosleep(&pause, NULL);
        n++;
    } while (run_on_good_line("device", "list", NULL) == 0 && !is_listed(image, text) && n <= STARTS_MOST);
    return n;
}

// Builds an image of n machines with these states.
enum { MACHINES = 5 };
static bool build_image(const char *states, int machines, char *image)
{
    static char source[MACHINES][PATH + 16];
    char out[PATH + 16];
    const char *argv[MACHINES + 5] = {smc, "build", "-w", out};
    FILE *f;

    snprintf(image, PATH + 16, "%s.made.smb", memory);
    snprintf(out, sizeof out, "-o%s", image);
    for (int i = 0; i < machines; i++) {
        snprintf(source[i], sizeof source[i], "%s.made%d.sm", memory, i);
        argv[4 + i] = source[i];
        if ((f = fopen(source[i], "w")) == NULL)
            return false;
        fprintf(f, "[state_vector]\nU64 t @alias G\nU32 s @alias S\nF64 x\nbool down\n\n%s\n", states);
        if (fclose(f) != 0)
            return false;
    }
    return run_without_board_argv(argv) == 0;
}

// An image that needs a feature that the firmware lacks, or more time than the board has, is not sent.
static void test_too_large_image_is_not_sent(void)
{
    static const char roots[] = "[A] .step\n    x = sqrt(sqrt(sqrt(sqrt(sqrt(x + 1) / 3 + 1) / 3 + 1) / 3 + 1) / 3 + 1)\n";
    char image[PATH + 16], plain[PATH + 8], proposed[32] = "";
    const char *at;
    FILE *f;

    snprintf(plain, sizeof plain, "%s.plain", memory);
    CHECK(run_on_good_line("device", "info", NULL) == 0 && output_contains(" machines, with rolling windows, a step every 10 ms, of up to 14400 cycles in each of them"));
    CHECK(build_image(roots, 1, image) && run_on_good_line("flash", image, "--dry-run") == 0);
    CHECK(run_on_good_line("flash", image, "--period=1") == 1 && output_contains(" cycles; in 1 ms the board has 14400 cycles for it; --period=") && output_contains("nothing was sent"));
    if ((at = strstr(said, "--period=")) != NULL)
        snprintf(proposed, sizeof proposed, "%.*s", (int)strcspn(at, " "), at);
    CHECK(strcmp(proposed, "--period=1") != 0 && run_on_good_line("flash", image, proposed) == 0 && run_on_good_line("device", "confirm", NULL) == 0);
    CHECK(build_image("[A]", MACHINES, image) && run_on_good_line("flash", image, NULL) == 1 && output_contains(" has 5 machines, the board runs ") && output_contains("nothing was sent"));
    if (!getenv("NO_KEY")) {           // a board that is controlled by files
        CHECK(build_image("[A] .step\n    x = roll_avg(x, 3)\n", 1, image) && run_on_good_line("flash", image, "--dry-run") == 0);
        CHECK((f = fopen(plain, "w")) != NULL && fclose(f) == 0);
        restart_board();
        CHECK(run_on_good_line("device", "info", NULL) == 0 && output_contains("at most 2 machines, without rolling windows, without parameters"));
        CHECK(run_on_good_line("flash", image, NULL) == 1 && output_contains("has rolling windows (roll_...), and this board's firmware is built without them; nothing was sent"));
        CHECK(build_image("[A] .step\n    x = atan2(x, 2) + cos(x)\n", 1, image) && run_on_good_line("flash", image, NULL) == 1);
        CHECK(output_contains("calls cos(), and this board's firmware is built without it: that of a Mega has all functions") && output_contains("nothing was sent"));
        CHECK(run_on_good_line("flash", with_parameters, NULL) == 1 && output_contains("has parameters, and this board's firmware is built without them or is older than they are; nothing was sent"));
        CHECK(remove(plain) == 0);
        restart_board();
        CHECK(run_on_good_line("flash", image, "--period=100") == 0 && run_on_good_line("device", "confirm", NULL) == 0);
    }
    CHECK(run_on_good_line("flash", images[1], "--confirm") == 0 && is_listed(images[1], ", runs, confirmed"));
}

// Builds the image of a machine with two numbers and two bools that are connected to these pins.
static bool build_image_of_pins(const char *pins, char *image)
{
    static const char *const suffix[] = {"sv", "io", "sm"};
    const char *const text[] = {"[M]\nU64 t\nU32 s\nF64 x\nF64 y\nbool down\nbool up\n", pins,
                                "[state_vector]\nU64 t @alias G\nU32 s @alias S\nF64 x\nF64 y\nbool down\nbool up\n\n[A]\n"};
    char path[3][PATH + 16], out[PATH + 16], sv[PATH + 32], io[PATH + 32];
    const char *const argv[] = {smc, "build", "-w", out, path[2], sv, io, NULL};
    FILE *f;

    snprintf(image, PATH + 16, "%s.pins.smb", memory);
    for (int i = 0; i < 3; i++) {
        snprintf(path[i], sizeof path[i], "%s.pins.%s", memory, suffix[i]);
        if ((f = fopen(path[i], "w")) == NULL || fputs(text[i], f) == EOF || fclose(f) != 0)
            return false;
    }
    snprintf(out, sizeof out, "-o%s", image);
    snprintf(sv, sizeof sv, "--sv=%s", path[0]);
    snprintf(io, sizeof io, "--io=%s", path[1]);
    return run_without_board_argv(argv) == 0;
}

// The pins of a Mega, as in docs/boards.md.
static void test_pins_are_checked(void)
{
    static const struct { const char *pins, *said; } wrong[] = {
        {"[digital]\no 70 down\n", " uses digital output 70, which this board does not have"},
        {"[digital]\ni 1 down\n", " uses digital input 1, which this board does not have or uses itself"},
        {"[analog]\ni 16 x\n", " uses analog input 16, which"},
        {"[digital]\ni 2 down @pull_down\n", " uses digital input 2 with @pull_down, which this board does not have"},
        {"[analog]\ni 0 x\n\n[digital]\ni 54 down\n", " uses digital input 54 and analog input 0, which are one pin of this board"},
        {"[analog]\no 9 x\n\n[digital]\no 9 down\n", " uses digital output 9 and analog output 9, which are one pin"},
    };
    char image[PATH + 16];

    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        CHECK(build_image_of_pins(wrong[i].pins, image));
        CHECK(run_on_good_line("flash", image, i % 2 ? "--dry-run" : NULL) == 1 && output_contains(wrong[i].said) && output_contains("; nothing was sent\n"));
    }
    CHECK(build_image_of_pins("[analog]\ni 0 x\no 9 y\n\n[digital]\ni 55 down\no 10 up\n", image));
    CHECK(run_on_good_line("flash", image, "--dry-run") == 0 && !output_contains("warning"));
    CHECK(run_on_good_line("flash", images[0], "--dry-run") == 0 && output_contains("smc: warning: ") && output_contains("names no pins: on this board it reads nothing and switches nothing"));
}

// language.md 5.46: a board refuses updates in a state without @safe, if its machine has a state with @safe.
static void test_machine_in_unsafe_state_refuses(void)
{
    char aloft[PATH + 16];

    CHECK(build_image("[Aloft] .step\n    down: -> Down\n\n[Down] @safe", 1, aloft) && run_on_good_line("flash", aloft, NULL) == 0 && is_listed(aloft, ", runs, on trial"));
    CHECK(output_contains("warning: machine 1 of ") && output_contains(" starts in a state that is not marked @safe"));
    CHECK(run_on_good_line("device", "info", NULL) == 0 && output_contains("no update may begin: a machine is in a state that is not marked @safe"));
    CHECK(run_on_good_line("flash", images[0], NULL) == 1 && output_contains("nothing was sent: a machine is in a state that is not marked @safe; bring it into one that is"));
    CHECK(output_contains("or let its trial end: it has 2 more starts"));
    CHECK(run_on_good_line("device", "confirm", NULL) == 1 && output_contains("it was not confirmed: a machine is in a state that is not marked @safe"));
    CHECK(restarts_until(images[1], ", runs, confirmed", 0) <= STARTS_MOST);         // until its trial ends
    CHECK(build_image("[Aloft] @safe .step\n    down: -> Down\n\n[Down] @safe", 1, aloft) && run_on_good_line("flash", aloft, "--confirm") == 0 && !output_contains("starts in a state") && is_listed(aloft, ", runs, confirmed"));
    CHECK(run_on_good_line("flash", images[1], "--confirm") == 0 && is_listed(images[1], ", runs, confirmed"));
}

// A trial without a confirmation ends after its starts, and the board reports that.  A start counts in full if the image has run for some time:
// 10 s, but 0.2 s on the board that is a program.
static void test_trial_ends(bool is_program)
{
    int starts;

    CHECK(run_on_good_line("flash", images[0], "--period=20ms") == 0 && is_listed(images[0], ", every 20 ms, on trial"));
    starts = restarts_until(images[1], ", runs, confirmed", 0);
    CHECK(starts >= 3 && starts <= STARTS_MOST);
    CHECK(is_listed(images[0], ", not chosen, its trial ended: it was not confirmed within its starts"));
    CHECK(run_on_good_line("device", "confirm", NULL) == 1 && output_contains("no image is on trial") && output_contains("smc: the trial of image "));
    CHECK(output_contains(" has ended: it was not confirmed within its starts; 'smc flash' sends it again"));
    CHECK(run_on_good_line("flash", images[0], NULL) == 0 && !output_contains("trial ended") && run_on_good_line("device", "list", NULL) == 0 && !output_contains("trial ended"));
    CHECK(restarts_until(images[1], ", runs, confirmed", is_program ? 400 : 0) <= (is_program ? 3 : STARTS_MOST));
}

// An Arduino restarts when DTR is switched on, so the command leaves it on.
static void test_line_stays_on(void)
{
    struct termios t;

    CHECK(tcgetattr(at_smc.slave, &t) == 0);
    t.c_cflag |= HUPCL;
    CHECK(tcsetattr(at_smc.slave, TCSANOW, &t) == 0 && run_on_good_line("device", "list", NULL) == 0);
    CHECK(tcgetattr(at_smc.slave, &t) == 0 && (t.c_cflag & HUPCL) == 0);
}

static void test_image_is_erased(void)
{
    char path[9];

    checksum_of(images[0], path);
    CHECK(run_on_good_line("device", "erase", "12345678") == 1 && output_contains("no slot contains an image with the checksum 12345678"));
    CHECK(run_on_good_line("device", "erase", path) == 0 && !is_listed(images[0], "bytes") && is_listed(images[1], ", runs"));
    CHECK(run_on_good_line("device", "erase", "x") == 2);
    CHECK(run_on_good_line("flash", images[0], NULL) == 0 && run_on_good_line("device", "list", NULL) == 0 && is_listed(images[1], ", runs again if the chosen one does not"));
    CHECK(run_on_good_line("device", "erase", path) == 0 && is_listed(images[0], ", runs, until the next start"));
    CHECK(output_contains("is erased, but it runs until the next start of the board") && !output_contains("trial ended"));
    CHECK(run_on_good_line("device", "confirm", NULL) == 1 && output_contains("the image that runs is no longer selected, because it was erased"));
    restart_board();
    CHECK(run_on_good_line("device", "list", NULL) == 0 && is_listed(images[1], ", runs, confirmed") && is_listed(images[0], ", not chosen"));
}

// Changes the code at the end of an image, and corrects its checksum (of all bytes except 4 to 7).
static bool forge_image(const char *path, size_t from_end)
{
    unsigned char bytes[TEXT];
    uint32_t crc = SM_CRC32_START;
    FILE *f = fopen(path, "r+b");
    const size_t n = f ? fread(bytes, 1, sizeof bytes, f) : 0;

    if (n < 48 || from_end < 1 || from_end > n)
        return false;
    bytes[n - from_end] ^= 1;
    for (size_t i = 0; i < n; i++)
        crc = i / 4 == 1 ? crc : sm_crc32_byte(crc, bytes[i]);
    crc = sm_crc32_end(crc);
    for (int i = 0; i < 4; i++)
        bytes[4 + i] = (unsigned char)(crc >> 8 * i);
    rewind(f);
    return fwrite(bytes, 1, n, f) == n && fclose(f) == 0;
}

// With a key: the confirmed image is not signed, and no longer runs.  Signed images are accepted in the order of their numbers.
static void test_board_with_a_key(void)
{
    char key[PATH + 8], with[PATH + 16], out[PATH], to[PATH + 8];

    snprintf(key, sizeof key, "%s.key", memory);
    snprintf(with, sizeof with, "--key=%s", key);
    snprintf(out, sizeof out, "%s", images[1]);
    strcpy(strrchr(out, '/') + 1, "signed.smb");
    snprintf(to, sizeof to, "-o%s", out);
    remove(key);
    CHECK(run_without_board("key", key, NULL, NULL) == 0 && run_without_board("key", key, NULL, NULL) == 3);
    restart_board();
    CHECK(run_on_good_line("device", "list", NULL) == 0 && output_contains("built in: no image; nothing runs"));
    CHECK(run_on_good_line("flash", images[0], NULL) == 1 && output_contains("the board accepts signed images only: 'smc sign ") && output_contains("nothing was sent"));
    CHECK(run_without_board("sign", images[0], with, to) == 0 && !output_contains("warning") && chmod(key, 0640) == 0);
    CHECK(run_without_board("sign", out, with, "--number=7") == 0 && output_contains("smc: warning: other users can read '"));
    CHECK(chmod(key, 0600) == 0 && run_on_good_line("flash", out, "--confirm") == 0 && is_listed(out, ", runs, confirmed"));
    CHECK(run_on_good_line("device", "info", NULL) == 0 && output_contains("takes signed images only, with key ") && output_contains(", with numbers above 7"));
    CHECK(run_on_good_line("flash", out, NULL) == 0 && output_contains("it runs already"));
    CHECK(run_on_good_line("flash", out, "--period=20") == 1 && output_contains("has number 7, but the board has confirmed number 7"));
    CHECK(run_without_board("sign", images[1], with, to) == 0 && run_without_board("sign", out, with, "--number=7") == 0);
    CHECK(run_on_good_line("flash", out, NULL) == 1 && output_contains("has number 7, but the board has confirmed number 7") && output_contains("nothing was sent"));
    CHECK(run_without_board("sign", out, with, NULL) == 0 && run_on_good_line("flash", out, "--confirm") == 0 && is_listed(out, ", runs, confirmed"));
    CHECK(run_without_board("sign", images[0], with, to) == 0 && run_without_board("sign", out, with, "--number=4000000000") == 0 && forge_image(out, 1));
    CHECK(run_on_good_line("flash", out, with) == 1 && output_contains(" was changed after it was signed with the key '") && output_contains("nothing was sent"));
    CHECK(run_on_good_line("flash", out, NULL) == 1 && output_contains("the image was not accepted: the board accepts only images that are signed with its key"));
    CHECK(output_contains("the board keeps the image that it ran before"));
    remove(key);
    CHECK(run_without_board("key", key, NULL, NULL) == 0 && run_without_board("sign", images[0], with, to) == 0);      // not the board's key
    CHECK(run_without_board("sign", out, with, "--number=4000000000") == 0);
    CHECK(run_on_good_line("flash", out, with) == 1 && output_contains(" is signed with key ") && output_contains("but the board accepts only images signed with key ") && output_contains("nothing was sent"));
    CHECK(run_on_good_line("flash", images[1], with) == 1 && output_contains(" is not signed; nothing was sent"));
    CHECK(remove(key) == 0 && remove(out) == 0);
    restart_board();
    CHECK(run_on_good_line("flash", images[1], "--confirm") == 0 && is_listed(images[1], ", runs, confirmed"));
}

static void test_no_board_answers(void)
{
    const Trouble gone = {0, 300, 0, true};

    CHECK(run_smc(&gone, "flash", images[0], NULL, NULL) == 3 && output_contains(": the board no longer answers"));
    CHECK(output_contains("the board keeps the image that it ran before"));
    CHECK(run_on_good_line("device", "info", NULL) == 3 && output_contains("no answer from '"));
    start_board();
    CHECK(run_on_good_line("device", "list", NULL) == 0 && is_listed(images[1], ", runs, confirmed"));
}

// ---- parameters ----

// The parameters of the image: `F64 limit = 775 @range 700 800` and `U8 count = 3 @range 1 9`.  A setting runs on trial.  After the trial has ended, the
// value from before is there, or with one slot the built-in image.
static void test_parameters_are_set(void)
{
    CHECK(run_on_good_line("flash", with_parameters, "--period=20") == 0 && run_on_good_line("device", "confirm", NULL) == 0);
    CHECK(run_on_good_line("device", "parameters", NULL) == 0 && output_contains("limit = 775 psi (F64, 700 to 800, default 775)\n"));
    CHECK(output_contains("count = 3 (U8, 1 to 9, default 3)\n") && is_listed(with_parameters, ", runs, every 20 ms, confirmed"));
    CHECK(set_on_good_line("limit=750", "--dry-run") == 0 && output_contains("limit = 750 psi") && output_contains("nothing was sent"));
    CHECK(set_on_good_line("limit=775", NULL) == 0 && output_contains("the image that runs already has these values; nothing was sent"));
    CHECK(set_on_good_line("limit=750", "count=9") == 0 && output_contains(", runs, every 20 ms, on trial (2 starts left)"));
    CHECK(run_on_good_line("device", "parameters", NULL) == 0 && output_contains("limit = 750 psi") && output_contains("count = 9 "));
    CHECK(set_on_good_line("limit=760", NULL) == 1 && output_contains(" is on trial; 'smc device confirm' keeps it"));
    CHECK(run_on_good_line("device", "confirm", NULL) == 0);
    restart_board();
    CHECK(run_on_good_line("device", "parameters", NULL) == 0 && output_contains("limit = 750 psi") && output_contains(", runs, every 20 ms, confirmed"));
    CHECK(set_on_good_line("limit=760", "--confirm") == 0 && output_contains(", runs, every 20 ms, confirmed"));
    CHECK(set_on_good_line("limit=790", NULL) == 0);
    for (int i = 0; i <= STARTS_MOST; i++) {
        restart_board();
        CHECK(run_on_good_line("device", "list", NULL) == 0);
    }
    CHECK(run_on_good_line("device", "parameters", NULL) == 0 && !output_contains("limit = 790"));
    CHECK(one_slot ? !output_contains("limit = ") : output_contains("limit = 760 psi") && output_contains("count = 9 "));
}

// Settings that are refused change nothing and send nothing.
static void test_settings_are_refused(void)
{
    static const struct { const char *setting, *why; int code; } wrong[] = {
        {"limit=801", "cannot set parameter 'limit' to 801: the value is above the range", 1},
        {"limit=699", "cannot set parameter 'limit' to 699: the value is below the range", 1},
        {"limit=hot", "cannot set parameter 'limit' to hot: the value is not a number", 1},
        {"count=2.5", "cannot set parameter 'count' to 2.5: the value of an integer must be a whole number", 1},
        {"Limit=750", "cannot set parameter 'Limit' to 750: the machine has no such parameter", 1},
        {"limit", "expected the name of a parameter and its value", 2}, {"=3", "expected the name of a parameter and its value", 2}, {NULL, "device set requires parameters and their values", 2}};

    CHECK(run_on_good_line("flash", with_parameters, "--confirm") == 0);
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        CHECK(set_on_good_line(wrong[i].setting, NULL) == wrong[i].code && output_contains(wrong[i].why));
        CHECK(wrong[i].code != 1 || output_contains("nothing was sent"));
    }
    CHECK(set_on_good_line("limit=750", "count=0") == 1 && output_contains("cannot set parameter 'count' to 0: the value is below the range"));
    arm_board(true);
    CHECK(set_on_good_line("limit=750", NULL) == 1 && output_contains("nothing was sent: the board is armed; disarm it first"));
    CHECK(run_on_good_line("device", "parameters", NULL) == 0 && output_contains("limit = 775 psi") && output_contains("count = 3 "));
    arm_board(false);
    CHECK(run_on_good_line("device", "parameters", "--confirm") == 2 && output_contains("device parameters does not accept --confirm"));
    CHECK(run_on_good_line("device", "parameters", NULL) == 0 && is_listed(with_parameters, ", runs, confirmed"));
    CHECK(run_on_good_line("flash", images[0], "--confirm") == 0);
    CHECK(run_on_good_line("device", "parameters", NULL) == 0 && output_contains("logic ") && !output_contains(" default "));
    CHECK(set_on_good_line("limit=750", NULL) == 1 && output_contains("cannot set parameter 'limit' to 750: the machine has no such parameter"));
}

// A board without a key runs a signed image.  Its values change only with the key, so that the signature fits them.
static void test_signed_image_is_signed_again(void)
{
    char key[PATH + 16], with[PATH + 24], out[PATH + 16], to[PATH + 24];

    snprintf(key, sizeof key, "%s.other.key", memory);
    snprintf(with, sizeof with, "--key=%s", key);
    snprintf(out, sizeof out, "%s.other.smb", memory);
    snprintf(to, sizeof to, "-o%s", out);
    CHECK(run_without_board("key", key, NULL, NULL) == 0 && run_without_board("sign", with_parameters, with, to) == 0);
    CHECK(run_on_good_line("flash", out, "--confirm") == 0 && is_listed(out, ", runs, confirmed"));
    CHECK(set_on_good_line("limit=750", NULL) == 1 && output_contains("the image is signed, and its signature covers the values: --key=FILE signs it again; nothing was sent"));
    CHECK(run_smc(&none, "device", "set", "limit=750", with) == 0 && run_on_good_line("device", "confirm", NULL) == 0);
    CHECK(run_on_good_line("device", "parameters", NULL) == 0 && output_contains("limit = 750 psi"));
    CHECK(remove(key) == 0 && remove(out) == 0);
}

// A newer version of the machine: `limit` has a narrower range, and `count` another name.  Settings belong to the image in which they were made: no value
// of the old image is carried over, and names and values are judged by the image that runs.
static void test_settings_end_with_their_image(void)
{
    char newer[PATH + 16], to[PATH + 24];

    snprintf(newer, sizeof newer, "%s.newer.smb", memory);
    snprintf(to, sizeof to, "-o%s", newer);
    CHECK(run_without_board("build", "-w", "tests/device/newer.sm", to) == 0);
    CHECK(run_on_good_line("flash", with_parameters, "--confirm") == 0);
    CHECK(run_on_good_line("device", "parameters", NULL) == 0 && set_on_good_line("limit=750", "count=9") == 0 && run_on_good_line("device", "confirm", NULL) == 0);
    CHECK(run_on_good_line("flash", newer, "--confirm") == 0);
    CHECK(run_on_good_line("device", "parameters", NULL) == 0 && output_contains("limit = 775 psi (F64, 760 to 800, default 775)\n"));
    CHECK(output_contains("hits = 3 (U8, 1 to 9, default 3)\n") && !output_contains("count"));
    CHECK(set_on_good_line("count=9", NULL) == 1 && output_contains("cannot set parameter 'count' to 9: the machine has no such parameter"));
    CHECK(set_on_good_line("limit=750", "hits=9") == 1 && output_contains("cannot set parameter 'limit' to 750: the value is below the range"));
    CHECK(run_on_good_line("device", "parameters", NULL) == 0 && output_contains("limit = 775 ") && output_contains("hits = 3 "));
    CHECK(set_on_good_line("limit=760", "hits=9") == 0 && run_on_good_line("device", "confirm", NULL) == 0);
    CHECK(run_on_good_line("flash", with_parameters, "--confirm") == 0);
    CHECK(run_on_good_line("device", "parameters", NULL) == 0 && output_contains("limit = 775 psi (F64, 700 to 800") && output_contains("count = 3 "));
    CHECK(remove(newer) == 0);
}

// A board with a key accepts a setting that is signed with it, once more than before.
static void test_settings_are_signed(void)
{
    char key[PATH + 8], with[PATH + 16], out[PATH + 16], to[PATH + 24];
    const char *const late[] = {smc, "sign", with_parameters, with, to, "--number=3999999000", NULL};
    const char *const last[] = {smc, "sign", with_parameters, with, to, "--number=4000000000", NULL};

    snprintf(key, sizeof key, "%s.key", memory);
    snprintf(with, sizeof with, "--key=%s", key);
    snprintf(out, sizeof out, "%s.signed.smb", memory);
    snprintf(to, sizeof to, "-o%s", out);
    sleep(1);                                     // the number of a signature is the second in which it is made
    CHECK(run_without_board("key", key, NULL, NULL) == 0 && run_without_board("sign", with_parameters, with, to) == 0);
    restart_board();
    CHECK(run_on_good_line("flash", out, "--confirm") == 0 && is_listed(out, ", runs, confirmed"));
    CHECK(set_on_good_line("limit=750", NULL) == 1 && output_contains("the image is signed, and its signature covers the values: --key=FILE signs it again; nothing was sent"));
    for (int i = 0; i < 2; i++) {
        char setting[16];
        sleep(1);
        snprintf(setting, sizeof setting, "limit=%d", 751 + i);
        CHECK(run_smc(&none, "device", "set", setting, with) == 0 && run_on_good_line("device", "confirm", NULL) == 0);
        CHECK(run_on_good_line("device", "parameters", NULL) == 0 && output_contains(setting[8] == '1' ? "limit = 751" : "limit = 752") && output_contains(", runs, confirmed"));
    }
    CHECK(run_without_board_argv(late) == 0 && run_on_good_line("flash", out, "--confirm") == 0);      // the board knows a number that is ahead of the clock
    CHECK(run_smc(&none, "device", "set", "limit=753", with) == 0 && run_on_good_line("device", "confirm", NULL) == 0);
    CHECK(run_on_good_line("device", "parameters", NULL) == 0 && output_contains("limit = 753 "));
    CHECK(run_without_board_argv(last) == 0 && run_on_good_line("flash", out, "--confirm") == 0);
    CHECK(run_smc(&none, "device", "set", "limit=754", with) == 1 && output_contains("4000000000"));   // there is no number after the last one
    CHECK(remove(key) == 0 && run_without_board("key", key, NULL, NULL) == 0);             // not the board's key
    CHECK(run_smc(&none, "device", "set", "limit=760", with) == 1 && output_contains("but the board accepts only images signed with key ") && output_contains("nothing was sent"));
    CHECK(remove(key) == 0 && remove(out) == 0);
    restart_board();
    CHECK(run_on_good_line("flash", images[1], "--confirm") == 0);
}

// While a setting is sent, the line is bad, or the board or smc is killed.  Afterwards all values are those from before or all are those of the setting.
static void test_setting_over_a_bad_line(void)
{
    Trouble t = {0, 0, 0, false};
    int code;

    if (run_on_good_line("device", "parameters", NULL) != 0 || !output_contains("limit = 775 ") || !output_contains("count = 3 "))
        CHECK(run_on_good_line("device", "list", NULL) == 0 && run_on_good_line("flash", with_parameters, "--confirm") == 0);
    switch (random_below(3)) {
    case 0: t.bad = 300 + random_below(2000); break;
    case 1: t.kill_board = 1 + (long)random_below(3000); break;
    default: t.kill_smc = 1 + (long)random_below(3000);
    }
    code = run_smc(&t, "device", "set", "limit=750", "count=9");
    CHECK(code == 0 || code == 1 || code == 3 || code == 128 + SIGINT || code == 128 + SIGKILL);
    CHECK(run_on_good_line("device", "parameters", NULL) == 0);
    if (output_contains("limit = "))
        CHECK(output_contains("limit = 750 ") ? output_contains("count = 9 ") : code != 0 && output_contains("limit = 775 ") && output_contains("count = 3 "));
    else
        CHECK(one_slot && code != 0);
    if (output_contains("on trial"))
        CHECK(run_on_good_line("device", "confirm", NULL) == 0);
}

// Over a bad line the update succeeds or fails.  Afterwards an update over a good line succeeds.
static void test_update_over_a_bad_line(int target)
{
    Trouble t = {0, 0, 0, false};
    int code;

    switch (random_below(4)) {
    case 0: t.bad = 300 + random_below(2000); break;
    case 1: t.kill_board = 1 + (long)random_below(2200); break;
    case 2: t.kill_smc = 1 + (long)random_below(2200); break;
    default: t.bad = 1000; t.kill_board = 1 + (long)random_below(2200);
    }
    code = run_smc(&t, "flash", images[target], NULL, NULL);
    CHECK(code == 0 || code == 1 || code == 3 || code == 128 + SIGINT || code == 128 + SIGKILL);
    CHECK(run_on_good_line("device", "list", NULL) == 0 && (is_listed(images[0], ", runs") || is_listed(images[1], ", runs") || (one_slot && output_contains(", runs"))));
    CHECK(code != 0 || is_listed(images[target], ", runs"));
    if (is_listed(images[1 - target], "on trial"))
        CHECK(run_on_good_line("device", "confirm", NULL) == 0);
    CHECK(run_on_good_line("flash", images[target], "--confirm") == 0 && is_listed(images[target], ", runs, confirmed"));
}

static void test_one_slot(void)
{
    CHECK(run_on_good_line("device", "list", NULL) == 0 && output_contains("slot 0: no image") && output_contains(", runs"));
    test_line_stays_on();
    CHECK(run_on_good_line("flash", images[0], NULL) == 0 && output_contains("on trial (2 starts left)"));
    CHECK(run_on_good_line("flash", images[1], NULL) == 1 && output_contains("on trial; 'smc device confirm' keeps it, 'smc device erase "));
    CHECK(restarts_until(images[0], "trial ended", 0) <= STARTS_MOST && is_listed(images[0], ", not chosen, its trial ended: it was not confirmed within its starts"));
    CHECK(run_on_good_line("device", "confirm", NULL) == 1 && output_contains("nothing to confirm") && output_contains("smc: the trial of image "));
    CHECK(run_on_good_line("flash", images[0], "--confirm") == 0 && run_on_good_line("flash", images[1], "--confirm") == 0);
    CHECK(run_on_good_line("flash", images[0], "--dry-run") == 0 && output_contains("smc: warning: the board has one slot: image "));
    CHECK(output_contains("would be sent to the board; nothing was sent") && !output_contains("error"));
    CHECK(run_on_good_line("device", "info", NULL) == 0 && output_contains("1 slot of ") && is_listed(images[1], ", runs, confirmed"));
    test_parameters_are_set();
    test_settings_are_refused();
}

static void test_two_slots(void)
{
    test_image_is_sent_and_stored();
    test_armed_board_refuses();
    test_machine_in_unsafe_state_refuses();
    test_too_large_image_is_not_sent();
    test_pins_are_checked();
    test_line_stays_on();
    test_trial_ends(!getenv("NO_KEY"));
    test_image_is_erased();
    test_no_board_answers();
    test_parameters_are_set();
    test_settings_are_refused();
    test_settings_end_with_their_image();
    if (!getenv("NO_KEY")) {           // a board that has its key from a file
        test_signed_image_is_signed_again();
        test_board_with_a_key();
        test_settings_are_signed();
    }
}

int main(int argc, char **argv)
{
    const int runs = argc > 7 ? atoi(argv[7]) : 8;

    if (argc >= 3 && argc <= 4 && strcmp(argv[1], "forge") == 0)
        return !forge_image(argv[2], argc == 4 ? strtoul(argv[3], NULL, 10) : 1);
    if (argc < 7)
        return fprintf(stderr, "link SMC BOARD FOLDER OLD.smb NEW.smb PARAMETERS.smb [RUNS [SEED]]\n"), 2;
    one_slot = getenv("SLOTS") != NULL;
    smc = argv[1];
    board = argv[2];
    images[0] = argv[4];
    images[1] = argv[5];
    with_parameters = argv[6];
    random_state *= argc > 8 ? strtoul(argv[8], NULL, 10) : 1;
    snprintf(memory, sizeof memory, "%s/board.memory", argv[3]);
    snprintf(output, sizeof output, "%s/board.memory.key", argv[3]);
    remove(memory);
    remove(output);
    snprintf(output, sizeof output, "%s/board.output", argv[3]);
    if (!open_terminal(&at_board) || !open_terminal(&at_smc))
        return printf("device: 0 passed, 0 failed, 1 skipped: no terminals here\n"), 0;
    start_board();
    if (one_slot)
        test_one_slot();
    else
        test_two_slots();
    if (!one_slot)                     // an update that fails leaves the other of the two images
        CHECK(run_on_good_line("flash", images[1], "--confirm") == 0 && is_listed(images[1], ", runs, confirmed"));
    for (int i = 0; i < runs; i++)
        test_update_over_a_bad_line(i % 2);
    for (int i = 0; i < runs; i++)
        test_setting_over_a_bad_line();
    kill_board();
    return test_end("device");
}
