// SPDX-License-Identifier: Apache-2.0
// Tests the guarantees of compiler/base/os.h for files: they are complete or absent, on the medium before they get their name, and have the mode
// of the file that they replace.  Also links, and names that are refused.     files FOLDER     (it is emptied)
// fsync, rename and fchmod are wrapped (-Wl,--wrap), so that the test can observe their order.
#define _XOPEN_SOURCE 700

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "compiler/base/os.h"
#include "tests/test.h"

static char calls[100];               // the calls in order: s fsync, r rename, m fchmod
static int failing;                   // the letter of the call that fails

static void note(char call)
{
    const size_t n = strlen(calls);

    if (n + 1 < sizeof calls)
        calls[n] = call;
}

int __real_fsync(int fd);
int __real_rename(const char *from, const char *to);
int __real_fchmod(int fd, mode_t mode);
int __wrap_fsync(int fd);
int __wrap_rename(const char *from, const char *to);
int __wrap_fchmod(int fd, mode_t mode);

static int fail(void) { return errno = EIO, -1; }

int __wrap_fsync(int fd) { return note('s'), failing == 's' ? fail() : __real_fsync(fd); }
int __wrap_rename(const char *from, const char *to) { return note('r'), failing == 'r' ? fail() : __real_rename(from, to); }
int __wrap_fchmod(int fd, mode_t mode) { return note('m'), failing == 'm' ? fail() : __real_fchmod(fd, mode); }

// ---- helpers ----

static bool put(const char *path, const char *text)
{
    const OsOutput out = {path, text, strlen(text)};
    const char *failed, *why;

    memset(calls, 0, sizeof calls);
    return os_write_files(&out, 1, &failed, &why);
}

static bool stream(const char *path, const char *text, bool keep)
{
    const char *why;
    OsStream s;

    memset(calls, 0, sizeof calls);
    return os_stream_open(&s, path, &why) && os_stream_put(&s, text, strlen(text), &why) && os_stream_close(&s, keep, &why);
}

static bool holds(const char *path, const char *text)
{
    const char *why;
    char *found;
    size_t n;
    bool same;

    if (!os_read_file(path, 1000, &found, &n, &why))
        return false;
    same = strcmp(found, text) == 0;
    os_alloc(NULL, found, 0);
    return same;
}

static mode_t mode_of(const char *path)
{
    struct stat st;

    return lstat(path, &st) == 0 ? st.st_mode & 07777 : 0;
}

static bool is_link(const char *path)
{
    struct stat st;

    return lstat(path, &st) == 0 && S_ISLNK(st.st_mode);
}

static size_t entries(const char *folder)
{
    const char *why;
    char **names;
    size_t n = 0;

    if (!os_list_folder(folder, &names, &n, &why))
        return 0;
    os_alloc(NULL, names, 0);
    return n;
}

// ---- the promises ----

static void whole_or_not_at_all(void)
{
    static const char letters[] = "smr";
    const OsOutput two[] = {{"a", "new", 3}, {"no/such/b", "new", 3}};
    const char *failed, *why;
    size_t before;

    CHECK(put("a", "old") && holds("a", "old"));
    CHECK(strcmp(calls, "msr") == 0);                 // mode and content before the name
    CHECK(stream("a", "OLD", true) && holds("a", "OLD") && strcmp(calls, "msr") == 0);
    before = entries(".");
    CHECK(stream("a", "never", false) && holds("a", "OLD") && entries(".") == before);
    for (size_t i = 0; i < 3; i++) {
        failing = letters[i];
        CHECK(!put("a", "new") && holds("a", "OLD") && entries(".") == before);
        CHECK(!stream("a", "new", true) && holds("a", "OLD") && entries(".") == before);
    }
    failing = 0;
    CHECK(!os_write_files(two, 2, &failed, &why) && strcmp(failed, "no/such/b") == 0 && holds("a", "OLD") && entries(".") == before);
}

static void test_modes(void)
{
    static const mode_t mode[] = {0600, 0640, 0644, 0755};

    umask(022);
    CHECK(put("fresh", "x") && mode_of("fresh") == 0644);
    CHECK(stream("fresh too", "x", true) && mode_of("fresh too") == 0644);
    umask(077);
    CHECK(put("private", "x") && mode_of("private") == 0600);
    umask(022);
    for (size_t i = 0; i < sizeof mode / sizeof *mode; i++) {
        CHECK(chmod("fresh", mode[i]) == 0 && put("fresh", "y") && mode_of("fresh") == mode[i]);
        CHECK(stream("fresh", "z", true) && mode_of("fresh") == mode[i] && holds("fresh", "z"));
    }
    if (geteuid() == 0) {                             // only root can change the owner of a file
        struct stat st;
        CHECK(chown("fresh", 1234, 4321) == 0 && put("fresh", "w") && stat("fresh", &st) == 0);
        CHECK(st.st_uid == 1234 && st.st_gid == 4321 && (st.st_mode & 07777) == 0755);
    }
}

static void symbolic_links(void)
{
    const char *why;

    CHECK(os_make_folder("far", &why) && put("far/target", "old") && chmod("far/target", 0640) == 0 && symlink("far/target", "link") == 0);
    CHECK(symlink("link", "link to link") == 0 && symlink("far/not yet", "dangling") == 0);
    CHECK(put("link", "1") && is_link("link") && holds("far/target", "1") && mode_of("far/target") == 0640);
    CHECK(stream("link", "2", true) && is_link("link") && holds("far/target", "2"));
    CHECK(put("link to link", "3") && is_link("link to link") && is_link("link") && holds("far/target", "3"));
    CHECK(put("dangling", "4") && is_link("dangling") && holds("far/not yet", "4") && !is_link("far/not yet"));
    CHECK(symlink("nowhere/at all", "lost") == 0 && !put("lost", "5") && is_link("lost"));
    CHECK(symlink("circle", "circle") == 0 && !put("circle", "6") && is_link("circle"));
    CHECK(!stream("lost", "7", true) && entries("far") == 2);
    CHECK(symlink("far", "folder") == 0 && !put("folder", "8") && put("folder/target", "9") && holds("far/target", "9"));
}

// As os.h documents: another hard link keeps the old content.
static void test_hard_links(void)
{
    CHECK(put("one", "old") && link("one", "two") == 0 && put("one", "new"));
    CHECK(holds("one", "new") && holds("two", "old"));
}

static void test_names(void)
{
    static const char *const bad[] = {"a\nb", "a\tb", "\x1b[31m", "a\x7f", "far/\r", "a\nb/c"};
    const char *why;
    char *text;
    size_t n;

    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        const size_t before = entries(".");
        why = "";
        CHECK(!put(bad[i], "x") && !stream(bad[i], "x", true) && entries(".") == before);
        CHECK(!os_read_file(bad[i], 100, &text, &n, &why) && strcmp(why, "its name contains a control character") == 0);
        CHECK(!os_make_folder(bad[i], &why) && !os_write_private(bad[i], "x", 1, &why));
    }
    CHECK(put("Höhe über \"Grund\" $1 #2", "x") && holds("Höhe über \"Grund\" $1 #2", "x"));
}

int main(int argc, char **argv)
{
    if (argc != 2 || chdir(argv[1]) != 0)
        return 2;
    whole_or_not_at_all();
    test_modes();
    symbolic_links();
    test_hard_links();
    test_names();
    return test_end("host-files");
}
