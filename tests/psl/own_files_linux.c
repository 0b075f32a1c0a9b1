// SPDX-License-Identifier: Apache-2.0
// Files on Linux: non-volatile memory and logs after a power failure at any time and on a full disk; sockets at a path.
#define _GNU_SOURCE
#include <errno.h>
#include <stdio.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

#include "runtime-c/pal/log.h"
#include "runtime-c/pal/nvm.h"
#include "runtime-c/pal/serial.h"
#include "runtime-c/pal/socket.h"
#include "tests/psl/own_faults_linux.h"
#include "tests/psl/suite.h"

// ---- non-volatile memory ----

#define SIZE 1200u            // three blocks of the copy; neither a power of two nor a multiple of a block

static char memory_name[64];

static PalNvm reopen(void)
{
    PalNvm memory = {0};

    CHECK(pal_nvm_open(&memory, memory_name, SIZE) == SM_OK);
    return memory;
}

static void fill_memory(PalNvm memory, uint8_t value)
{
    uint8_t bytes[SIZE];

    memset(bytes, value, SIZE);
    CHECK(pal_nvm_write(memory, 0, bytes, SIZE) == SM_OK);
}

// Returns the value of all bytes; -1 if they differ.
static int value_of(PalNvm memory)
{
    uint8_t bytes[SIZE];

    memset(bytes, 0, SIZE);
    CHECK(pal_nvm_read(memory, 0, bytes, SIZE) == SM_OK);
    for (uint32_t i = 1; i < SIZE; i++)
        if (bytes[i] != bytes[0])
            return -1;
    return bytes[0];
}

// A new file is on the medium before it gets its name, and the name is on the medium before the call returns.
static void test_order_of_calls(void)
{
    PalNvm memory = reopen();

    fault(-1, 0, false);
    fill_memory(memory, 3);
    no_fault();
    CHECK(strcmp(calls(), "wwwfrf") == 0);
    CHECK(pal_nvm_close(memory) == SM_OK);
}

// Cuts the power before each call in turn.  Afterwards the content is the old or the new one.
static void test_power_cuts(void)
{
    const uint8_t bytes[SIZE] = {0};
    bool done = false, was_old = false, was_new = false;

    for (int calls = 0; calls < 20 && !done; calls++) {
        PalNvm memory = reopen();
        int value;

        fill_memory(memory, 1);
        fault(calls, EIO, true);
        done = pal_nvm_write(memory, 0, bytes, SIZE) == SM_OK;
        no_fault();
        CHECK(pal_nvm_close(memory) == SM_OK);
        memory = reopen();
        value = value_of(memory);
        CHECK(value == (done ? 0 : 1) || value == 0);
        was_old = was_old || value == 1;
        was_new = was_new || (value == 0 && !done);
        CHECK(pal_nvm_close(memory) == SM_OK);
    }
    CHECK(done && was_old && was_new);
}

// A failed write leaves the memory usable, and no temporary file.
static void test_full_disk(void)
{
    PalNvm memory = reopen();
    const uint8_t bytes[SIZE] = {0};
    char name[80];

    snprintf(name, sizeof name, "%s.new", memory_name);
    fill_memory(memory, 1);
    for (int left = 0; left < 3; left++) {
        fault(left, ENOSPC, false);
        CHECK(pal_nvm_write(memory, 0, bytes, SIZE) == SM_E_SPACE);
        CHECK(strchr(calls(), 'u') != NULL);
        no_fault();
        CHECK(value_of(memory) == 1);
        CHECK(access(name, F_OK) != 0);
    }
    fill_memory(memory, 2);
    CHECK(value_of(memory) == 2);
    CHECK(pal_nvm_close(memory) == SM_OK);
}

static void size_on_disk(off_t expected)
{
    struct stat s;

    CHECK(stat(memory_name, &s) == 0 && s.st_size == expected);
}

static void test_file_is_lengthened(void)
{
    PalNvm memory = {0};
    uint8_t x = 5, two[2] = {0, 0};

    CHECK(unlink(memory_name) == 0);
    CHECK(pal_nvm_open(&memory, memory_name, 1) == SM_OK);
    CHECK(pal_nvm_write(memory, 0, &x, 1) == SM_OK);
    CHECK(pal_nvm_close(memory) == SM_OK);
    size_on_disk(1);
    CHECK(pal_nvm_open(&memory, memory_name, 1000) == SM_OK);
    CHECK(pal_nvm_read(memory, 0, two, 2) == SM_OK && two[0] == 5 && two[1] == 0xff);
    CHECK(pal_nvm_close(memory) == SM_OK);
    size_on_disk(1000);
    CHECK(pal_nvm_open(&memory, memory_name, 10) == SM_OK);       // opening never shortens a memory
    CHECK(pal_nvm_read(memory, 999, two, 1) == SM_OK);
    CHECK(pal_nvm_close(memory) == SM_OK);
    size_on_disk(1000);
}

// Reading by name needs no permission to write, and creates, extends and locks nothing.
static void loads(void)
{
    PalNvm memory = {0};
    uint8_t x[11] = {0};
    FILE *f = fopen("key", "w");

    CHECK(f != NULL && fputs("0123456789", f) >= 0 && fclose(f) == 0 && chmod("key", 0400) == 0);
    CHECK(pal_nvm_load("key", x, 10) == SM_OK && memcmp(x, "0123456789", 10) == 0);
    CHECK(pal_nvm_load("key", x, 11) == SM_E_SPACE);
    CHECK(symlink("key", "link") == 0 && pal_nvm_load("link", x, 1) == SM_OK);
    CHECK(pal_nvm_load("absent", x, 1) == SM_E_MISSING && access("absent", F_OK) != 0 && access("absent.new", F_OK) != 0);
    CHECK(pal_nvm_load(".", x, 1) == SM_E_UNSUPPORTED && mkfifo("pipe", 0600) == 0 && pal_nvm_load("pipe", x, 1) == SM_E_UNSUPPORTED);
    CHECK(chmod("key", 0600) == 0 && pal_nvm_open(&memory, "key", 1) == SM_OK && pal_nvm_load("key", x, 1) == SM_OK && pal_nvm_close(memory) == SM_OK);
    CHECK(unlink("key") == 0 && unlink("link") == 0 && unlink("pipe") == 0);
}

static void no_file(void)
{
    PalNvm memory = {0};

    CHECK(pal_nvm_open(&memory, ".", 1) == SM_E_UNSUPPORTED);
    CHECK(mkfifo("pipe", 0600) == 0 && symlink(memory_name, "link") == 0);
    CHECK(pal_nvm_open(&memory, "pipe", 1) == SM_E_UNSUPPORTED);
    CHECK(pal_nvm_open(&memory, "link", 1) == SM_E_UNSUPPORTED);
    CHECK(pal_nvm_open(&memory, "pipe/x", 1) == SM_E_MISSING);
    CHECK(unlink("pipe") == 0 && unlink("link") == 0);
    for (int i = 0; i < 2 * PAL_NVMS; i++)                // a failed call uses up no entry
        CHECK(pal_nvm_open(&memory, ".", 1) == SM_E_UNSUPPORTED);
}

static void no_line(void)
{
    PalSerial line = {0};

    CHECK(pal_serial_open(&line, memory_name, 9600) == SM_E_UNSUPPORTED && line.id == 0);
}

static void test_nvm(void)
{
    snprintf(memory_name, sizeof memory_name, "%s.own", bench.nvm_name);
    test_order_of_calls();
    test_power_cuts();
    test_full_disk();
    test_file_is_lengthened();
    no_file();
    loads();
    no_line();
    unlink(memory_name);
}

// ---- logs ----

#define LOG_NAME "own.log"

static PalLogFile log_opened(void)
{
    PalLogFile file = {0};

    CHECK(pal_log_open(&file, LOG_NAME) == SM_OK);
    return file;
}

// A new file's name is on the medium when open returns.  Writing continues at the end of the file.  Only sync waits for the medium.
static void test_log_order(void)
{
    PalLogFile file;

    fault(-1, 0, false);
    file = log_opened();
    CHECK(pal_log_append(file, "abcd", 4) == SM_OK && pal_log_sync(file) == SM_OK);
    CHECK(pal_log_close(file) == SM_OK);
    file = log_opened();
    CHECK(pal_log_close(file) == SM_OK);
    no_fault();
    CHECK(strcmp(calls(), "fwd") == 0);
}

static void log_full(void)
{
    PalLogFile file = log_opened();
    uint64_t size = 0;

    fault(0, ENOSPC, false);
    CHECK(pal_log_append(file, "efgh", 4) == SM_E_SPACE);
    no_fault();
    CHECK(pal_log_size(file, &size) == SM_OK && size == 6);
    fault(0, EINTR, false);
    CHECK(pal_log_append(file, "gh", 2) == SM_OK);
    fault(0, EINTR, false);
    CHECK(pal_log_sync(file) == SM_OK);
    fault(0, EIO, false);
    CHECK(pal_log_sync(file) == SM_E_DEVICE);
    no_fault();
    CHECK(pal_log_close(file) == SM_OK);
}

static void no_log(void)
{
    PalLogFile file = {0};

    CHECK(mkfifo("pipe", 0600) == 0 && symlink(LOG_NAME, "link") == 0);
    CHECK(pal_log_open(&file, ".") == SM_E_UNSUPPORTED);
    CHECK(pal_log_open(&file, "pipe") == SM_E_UNSUPPORTED);
    CHECK(pal_log_open(&file, "pipe/x") == SM_E_MISSING);
    CHECK(pal_log_open(&file, "/dev/null") == SM_E_UNSUPPORTED);
    CHECK(file.id == 0);
    CHECK(pal_log_open(&file, "link") == SM_OK && pal_log_close(file) == SM_OK);      // a log can be a symbolic link
    fault(0, EIO, false);
    CHECK(pal_log_open(&file, "new.log") == SM_E_DEVICE);
    no_fault();
    CHECK(unlink("pipe") == 0 && unlink("link") == 0 && unlink(LOG_NAME) == 0 && unlink("new.log") == 0);
}

// ---- sockets at a path ----

// Whether two programs can exchange a byte by the path.
static bool is_reached(PalSocket listening, const char *path)
{
    struct sockaddr_un a;
    PalSocket stream = {0};
    PalAddress peer = {{1, 2, 3, 4}, 5};
    const int fd = socket(AF_UNIX, SOCK_STREAM, 0);
    char byte = 'x';
    size_t n = 0;
    bool reached;

    memset(&a, 0, sizeof a);
    a.sun_family = AF_UNIX;
    snprintf(a.sun_path, sizeof a.sun_path, "%s", path);
    reached = connect(fd, (struct sockaddr *)&a, sizeof a) == 0 && pal_socket_accept(listening, &stream, &peer, PAL_SECOND) == SM_OK &&
              write(fd, &byte, 1) == 1 && pal_socket_receive(stream, &byte, 1, &n, PAL_SECOND) == SM_OK && n == 1 &&
              pal_socket_send(stream, &byte, 1, &n, PAL_SECOND) == SM_OK && read(fd, &byte, 1) == 1 && peer.port == 0 && peer.ip[0] == 0;
    close(fd);
    CHECK(stream.id == 0 || pal_socket_close(stream) == SM_OK);
    return reached;
}

enum { STARTS = 12 };

// STARTS programs listen at one path as soon as they can read a byte of `start`, and close it when they can read another byte.  Exactly one
// succeeds.
static void one_of_many(int round)
{
    int start[2], done[2], end[2], succeeded = 0;
    PalSocket s = {0}, c = {0};
    char results[STARTS];
    struct stat file;

    if (round % 2)
        CHECK(pal_socket_listen_local(&s, "left") == SM_OK && link("left", "many") == 0 && pal_socket_close(s) == SM_OK);
    CHECK(pipe(start) == 0 && pipe(done) == 0 && pipe(end) == 0);
    for (int i = 0; i < STARTS; i++)
        if (fork() == 0) {
            char byte = 0;
            SmResult r;
            if (read(start[0], &byte, 1) != 1)
                _exit(1);
            pause_calls((unsigned)(round + 1) * (unsigned)(i + 1) * 7 % 1000);
            r = pal_socket_listen_local(&s, "many");
            pause_calls(0);
            byte = r == SM_OK ? 1 : r == SM_E_BUSY ? 2 : 3;
            if (write(done[1], &byte, 1) != 1 || read(end[0], &byte, 1) != 1)
                _exit(1);
            while (r == SM_OK && pal_socket_accept(s, &c, NULL, 0) == SM_OK)
                (void)pal_socket_close(c);
            _exit(r == SM_OK && pal_socket_close(s) != SM_OK);
        }
    CHECK(write(start[1], results, STARTS) == STARTS);
    for (int i = 0; i < STARTS; i++) {
        CHECK(read(done[0], &results[i], 1) == 1 && (results[i] == 1 || results[i] == 2));
        succeeded += results[i] == 1;
    }
    CHECK(succeeded == 1);
    CHECK(write(end[1], results, STARTS) == STARTS);
    for (int i = 0; i < STARTS; i++) {
        int status;
        CHECK(wait(&status) > 0 && WIFEXITED(status) && WEXITSTATUS(status) == 0);
    }
    CHECK(stat("many", &file) != 0);
    for (int i = 0; i < 2; i++)
        (void)close(start[i]), (void)close(done[i]), (void)close(end[i]);
}

static void local_sockets(void)
{
    PalSocket s = {0}, other = {0};
    PalAddress address;
    char longest[PAL_SOCKET_PATH + 2];
    struct stat file;

    memset(longest, 's', sizeof longest - 1);
    longest[sizeof longest - 1] = '\0';
    CHECK(pal_socket_listen_local(NULL, "path") == SM_E_ARGUMENT && pal_socket_listen_local(&s, NULL) == SM_E_ARGUMENT);
    CHECK(pal_socket_listen_local(&s, "") == SM_E_ARGUMENT && pal_socket_listen_local(&s, longest) == SM_E_ARGUMENT);
    CHECK(pal_socket_listen_local(&s, "nowhere/path") == SM_E_MISSING && s.id == 0);
    longest[PAL_SOCKET_PATH] = '\0';
    CHECK(pal_socket_listen_local(&s, longest) == SM_OK && is_reached(s, longest) && pal_socket_close(s) == SM_OK);
    // only the same user and one program can use it
    CHECK(pal_socket_listen_local(&s, "path") == SM_OK && is_reached(s, "path"));
    CHECK(stat("path", &file) == 0 && S_ISSOCK(file.st_mode) && (file.st_mode & 0777) == 0600);
    CHECK(pal_socket_listen_local(&other, "path") == SM_E_BUSY && other.id == 0);
    CHECK(pal_socket_accept(s, &other, NULL, PAL_SECOND) == SM_OK && pal_socket_close(other) == SM_OK);      // the connection of the attempt
    CHECK(pal_socket_local_address(s, &address) == SM_E_UNSUPPORTED && is_reached(s, "path"));
    CHECK(pal_socket_close(s) == SM_OK && stat("path", &file) != 0);
    // a socket whose program has ended
    CHECK(pal_socket_listen_local(&s, "path") == SM_OK && link("path", "left") == 0 && pal_socket_close(s) == SM_OK);
    CHECK(pal_socket_listen_local(&s, "left") == SM_OK && is_reached(s, "left") && pal_socket_close(s) == SM_OK);
    // many programs at the same time, at a path with a socket that a program has left: one of them listens
    for (int round = 0; round < 20; round++)
        one_of_many(round);
    // other files are not changed
    CHECK(mkdir("folder", 0700) == 0 && symlink("gone", "link") == 0);
    CHECK(pal_socket_listen_local(&s, "folder") == SM_E_FOREIGN && pal_socket_listen_local(&s, "link") == SM_E_FOREIGN);
    CHECK(rmdir("folder") == 0 && unlink("link") == 0);
}

Tally own_files_linux(void)
{
    test_nvm();
    test_log_order();
    log_full();
    no_log();
    local_sockets();
    return TALLY();
}
