// SPDX-License-Identifier: Apache-2.0
// Tests the guarantees of compiler/base/os.h for files, folders and signals that the command's own tests cannot observe.  It creates its own
// folder.
#define _XOPEN_SOURCE 700
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "compiler/base/os.h"
#include "tests/test.h"

static const char *why, *which;

static bool write_file(const char *path, const char *text, size_t n)
{
    const OsOutput out = {path, text, n};

    return os_write_files(&out, 1, &which, &why);
}

static bool holds(const char *path, const char *text, size_t n)
{
    char *found;
    size_t len;
    bool same;

    if (!os_read_file(path, SIZE_MAX, &found, &len, &why))
        return false;
    same = len == n && memcmp(found, text, n) == 0 && found[n] == '\0';
    os_alloc(NULL, found, 0);
    return same;
}

static size_t files(void)
{
    char **names;
    size_t n = 0;

    CHECK(os_list_folder(".", &names, &n, &why));
    os_alloc(NULL, names, 0);
    return n;
}

// Files of every length are read completely: the reader's buffer doubles, and can be full exactly at the end.
static void test_lengths(void)
{
    enum { LONGEST = 70000 };
    char *text = malloc(LONGEST);

    CHECK(text != NULL);
    for (size_t i = 0; text && i < LONGEST; i++)
        text[i] = (char)('a' + i * i % 23);
    for (size_t n = 0; text && n < LONGEST; n = n == 10 ? 16370 : n == 16400 ? 32750 : n == 32790 ? 65520 : n == 65560 ? LONGEST : n + 1)
        CHECK(write_file("long", text, n) && holds("long", text, n));
    CHECK(!os_read_file("long", 100, &text, &(size_t){0}, &why) && strcmp(why, "the file is too large") == 0);
    CHECK(unlink("long") == 0);
    free(text);
}

// Several outputs: if one cannot be written, none is replaced, and no temporary file remains.
static void test_all_or_none(void)
{
    const OsOutput out[] = {{"first", "new", 3}, {"folder", "new", 3}, {"third", "new", 3}};

    CHECK(write_file("first", "old", 3) && mkdir("folder", 0777) == 0);
    CHECK(!os_write_files(out, 3, &which, &why) && strcmp(which, "folder") == 0 && strcmp(why, "it is a folder") == 0);
    CHECK(holds("first", "old", 3) && access("third", F_OK) != 0 && files() == 2);
    CHECK(rmdir("folder") == 0 && unlink("first") == 0);
}

// A stream's file appears when it is closed with `keep`.  Until then, and if it is closed without `keep`, the old file remains.
static void test_stream(void)
{
    OsStream s;

    for (int keep = 0; keep < 2; keep++) {
        CHECK(write_file("trace", "old", 3));
        CHECK(os_stream_open(&s, "trace", &why) && os_stream_put(&s, "new text", 8, &why));
        CHECK(holds("trace", "old", 3) && files() == 2);
        CHECK(os_stream_close(&s, keep != 0, &why));
        CHECK(keep ? holds("trace", "new text", 8) : holds("trace", "old", 3));
        CHECK(files() == 1);
    }
    CHECK(unlink("trace") == 0);
}

static void (*handler_of(int number))(int)
{
    struct sigaction now;

    return sigaction(number, NULL, &now) == 0 ? now.sa_handler : SIG_ERR;
}

static void own_handler(int number) { (void)number; }

// A signal that the caller ignores, as under nohup, stays ignored.  The handlers of the others are restored after writing.
static void test_signals(void)
{
    OsStream s;

    CHECK(signal(SIGHUP, SIG_IGN) != SIG_ERR && signal(SIGTERM, SIG_DFL) != SIG_ERR);
    CHECK(write_file("a", "text", 4) && handler_of(SIGHUP) == SIG_IGN && handler_of(SIGTERM) == SIG_DFL && handler_of(SIGINT) == SIG_DFL);
    CHECK(os_stream_open(&s, "a", &why) && handler_of(SIGHUP) == SIG_IGN && handler_of(SIGTERM) != SIG_DFL);
    CHECK(handler_of(SIGPIPE) != SIG_DFL && handler_of(SIGQUIT) != SIG_DFL && handler_of(SIGXCPU) != SIG_DFL);
    CHECK(os_stream_close(&s, true, &why) && handler_of(SIGHUP) == SIG_IGN && handler_of(SIGTERM) == SIG_DFL);
    CHECK(signal(SIGHUP, SIG_DFL) == SIG_IGN && unlink("a") == 0);
    CHECK(signal(SIGUSR1, own_handler) == SIG_DFL && write_file("a", "text", 4) && handler_of(SIGUSR1) == own_handler);
    CHECK(signal(SIGUSR1, SIG_DFL) == own_handler && unlink("a") == 0);
}

static void test_folders(void)
{
    static const char *const made[] = {"zebra", "alpha", "mike", "Mike", "a", "z1", "b2", "b10", "echo", "kilo"};
    char **names;
    size_t n = 0;

    for (size_t i = 0; i < sizeof made / sizeof *made; i++)
        CHECK(write_file(made[i], "", 0));
    CHECK(os_list_folder(".", &names, &n, &why) && n == sizeof made / sizeof *made);
    for (size_t i = 1; i < n; i++)
        CHECK(strcmp(names[i - 1], names[i]) < 0);
    os_alloc(NULL, names, 0);
    CHECK(link("alpha", "beta") == 0 && symlink("alpha", "gamma") == 0);
    CHECK(os_same_file("alpha", "beta") && os_same_file("alpha", "./gamma") && os_same_file("alpha", "alpha"));
    CHECK(!os_same_file("alpha", "mike") && !os_same_file("alpha", "nothing") && !os_same_file("-", "-"));
    for (size_t i = 0; i < sizeof made / sizeof *made; i++)
        CHECK(unlink(made[i]) == 0);
    CHECK(unlink("beta") == 0 && unlink("gamma") == 0 && files() == 0);
}

// A folder that cannot be created: the reason is that of the failed attempt.
static void test_make_folder(void)
{
    const uid_t user = geteuid();

    CHECK(os_make_folder("new", &why) && os_make_folder("new", &why) && os_is_folder("new") && chmod("new", 0555) == 0);
    CHECK(symlink("nothing", "lost") == 0 && !os_make_folder("lost", &why) && strcmp(why, strerror(EEXIST)) == 0);
    CHECK(!os_make_folder("no/such", &why) && strcmp(why, strerror(ENOENT)) == 0);
    CHECK(chmod(".", 0755) == 0 && (user != 0 || seteuid(65534) == 0));           // root may write everywhere
    CHECK(!os_make_folder("new/inner", &why) && strcmp(why, strerror(EACCES)) == 0);
    CHECK(seteuid(user) == 0 && unlink("lost") == 0 && rmdir("new") == 0);
}

// A key is never overwritten, and only its owner can read it.
static void test_private(void)
{
    struct stat st;

    umask(0);
    CHECK(os_write_private("key", "secret", 6, &why) && holds("key", "secret", 6) && stat("key", &st) == 0 && (st.st_mode & 0777) == 0600);
    CHECK(os_is_private("key") && !os_write_private("key", "other", 5, &why) && holds("key", "secret", 6));
    CHECK(chmod("key", 0640) == 0 && !os_is_private("key") && chmod("key", 0604) == 0 && !os_is_private("key"));
    CHECK(chmod("key", 0622) == 0 && os_is_private("key") && os_is_private("nothing") && unlink("key") == 0);
}

int main(void)
{
    char folder[] = P_tmpdir "/smc-files.XXXXXX";

    CHECK(mkdtemp(folder) != NULL && chdir(folder) == 0);
    test_lengths();
    test_all_or_none();
    test_stream();
    test_signals();
    test_folders();
    test_make_folder();
    test_private();
    CHECK(chdir("/") == 0 && rmdir(folder) == 0);
    return test_end("folders");
}
