// SPDX-License-Identifier: Apache-2.0
// os_process.h on POSIX systems.
#define _XOPEN_SOURCE 700

#include "compiler/base/os_process.h"
#include "compiler/base/os.h"
#include "compiler/base/os_signal.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

extern char **environ;

// Sets *why to the text of an errno. Always returns false, the result of the failed function.
static bool set_reason(int error, const char **why)
{
    *why = strerror(error);
    return false;
}

// ---- folders ----

// Creates a folder that only this user can access, and stores its path in `path` (n bytes).  Only one may exist at a time.
bool os_temp_folder(char *path, size_t n, const char **why)
{
    const char *base = getenv("TMPDIR");
    const int len = snprintf(path, n, "%s/smc-XXXXXX", base && *base ? base : "/tmp");

    if (len < 0 || (size_t)len >= n) {
        path[0] = '\0';
        return set_reason(ENAMETOOLONG, why);
    }
    os_signals_delay();
    if (mkdtemp(path))
        return true;
    set_reason(errno, why);
    path[0] = '\0';
    os_signals_resume();
    return false;
}

void os_remove_folder(const char *path)
{
    DIR *d = opendir(path);
    const struct dirent *e;

    while (d && (e = readdir(d)) != NULL)
        if (strcmp(e->d_name, ".") != 0 && strcmp(e->d_name, "..") != 0)
            unlinkat(dirfd(d), e->d_name, 0);
    if (d)
        closedir(d);
    rmdir(path);
    os_signals_resume();
}

// ---- processes ----

// Waits for a child to end. Returns its exit code: 128 + the signal's number if a signal ended it, 127 if it is not a child of this process.
static int wait_for_exit(pid_t pid)
{
    int status;

    while (waitpid(pid, &status, 0) < 0)
        if (errno != EINTR)
            return 127;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

static void sleep_10_ms(void)
{
    const struct timespec pause = {0, 10 * 1000 * 1000};

    nanosleep(&pause, NULL);
}

// Waits up to a second for the processes of a group that are children of this process.
static void wait_for_group(pid_t leader)
{
    pid_t ended = 0;

    for (int i = 0; i < 100 && ended >= 0; i++) {
        do
            ended = waitpid(-leader, NULL, WNOHANG);
        while (ended > 0);
        if (ended == 0)
            sleep_10_ms();
    }
}

// Ends a process group whose leader is a child of this process: first with the signal that this process received, after a second with
// SIGKILL.  Where the system can make this process the parent of orphans (Linux), every process of the group has then ended, so none of
// them can create a file in the temporary folder any more.
static void terminate_group(pid_t leader)
{
#ifdef PR_SET_CHILD_SUBREAPER
    prctl(PR_SET_CHILD_SUBREAPER, 1L, 0L, 0L, 0L);
#endif
    kill(-leader, os_signal_waiting());
    wait_for_group(leader);
    kill(-leader, SIGKILL);
    wait_for_group(leader);
}

static void ignore_signal(int number) { (void)number; }

// Waits for the child. Returns false if this process has received a signal that will end it. Signals are blocked except during sigsuspend,
// so that none can arrive between the last check and the wait. SIGCHLD has a handler because an ignored signal does not end sigsuspend.
static bool wait_or_signal(pid_t pid, int *exit_code)
{
    struct sigaction action, before;
    sigset_t blocked, mask;
    int status = 0;
    pid_t ended;

    memset(&action, 0, sizeof action);
    sigemptyset(&action.sa_mask);
    action.sa_handler = ignore_signal;
    sigaction(SIGCHLD, &action, &before);
    sigemptyset(&blocked);
    for (int i = 0; os_signal_at(i); i++)
        sigaddset(&blocked, os_signal_at(i));
    sigaddset(&blocked, SIGCHLD);
    sigprocmask(SIG_BLOCK, &blocked, &mask);
    while ((ended = waitpid(pid, &status, WNOHANG)) == 0 && os_signal_waiting() == 0)
        sigsuspend(&mask);
    sigprocmask(SIG_SETMASK, &mask, NULL);
    sigaction(SIGCHLD, &before, NULL);
    *exit_code = ended < 0 ? 127 : WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return ended != 0;
}

// Returns the environment of this process, with TMPDIR set to `folder`: one block that the caller frees (os_alloc).  NULL: out of memory.
static char **environment_with_tmpdir(const char *folder)
{
    static const char name[] = "TMPDIR=";
    const size_t name_n = sizeof name - 1, folder_n = strlen(folder) + 1;
    size_t n = 0, kept = 0;
    char **list, *variable;

    while (environ[n])
        n++;
    list = os_alloc(NULL, NULL, (n + 2) * sizeof *list + name_n + folder_n);
    if (!list)
        return NULL;
    variable = (char *)(list + n + 2);
    memcpy(variable, name, name_n);
    memcpy(variable + name_n, folder, folder_n);
    for (size_t i = 0; i < n; i++)
        if (strncmp(environ[i], name, name_n) != 0)
            list[kept++] = environ[i];
    list[kept++] = variable;
    list[kept] = NULL;
    return list;
}

// Starts the process in its own process group, for terminate_group. Returns 0 or an errno.
static int spawn_group(pid_t *pid, const char *const *argv, const posix_spawn_file_actions_t *actions, char **environment)
{
    posix_spawnattr_t attributes;
    int error = posix_spawnattr_init(&attributes);

    if (error)
        return error;
    error = posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
    if (!error)
        error = posix_spawnp(pid, argv[0], actions, &attributes, (char *const *)argv, environment);
    posix_spawnattr_destroy(&attributes);
    return error;
}

// Runs the program argv[0] (searched in PATH) with the NULL-terminated list argv, and waits for its end.
bool os_run_program(const char *const *argv, const char *output, const char *temp, int *exit_code, const char **why)
{
    char **const own = temp ? environment_with_tmpdir(temp) : NULL;
    posix_spawn_file_actions_t actions;
    pid_t pid;
    int error = temp && !own ? ENOMEM : posix_spawn_file_actions_init(&actions);

    if (error) {
        os_alloc(NULL, own, 0);
        return set_reason(error, why);
    }
    os_signals_delay();
    error = posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
    if (!error)
        error = posix_spawn_file_actions_addopen(&actions, 1, output, O_WRONLY | O_CREAT | O_TRUNC, 0600);
    if (!error)
        error = posix_spawn_file_actions_adddup2(&actions, 1, 2);
    if (!error)
        error = spawn_group(&pid, argv, &actions, own ? own : environ);
    posix_spawn_file_actions_destroy(&actions);
    os_alloc(NULL, own, 0);
    if (error) {
        set_reason(error, why);
    } else if (!wait_or_signal(pid, exit_code)) {
        terminate_group(pid);
        error = EINTR;
        *why = "interrupted";
    }
    os_signals_resume();
    return error == 0;
}

// Starts the process with fd as its standard input and output. Returns 0 or an errno.
static int spawn_with_stdio(int fd, const char *const *argv, pid_t *pid)
{
    posix_spawn_file_actions_t actions;
    int error = posix_spawn_file_actions_init(&actions);

    if (error)
        return error;
    error = posix_spawn_file_actions_adddup2(&actions, fd, 0);
    if (!error)
        error = posix_spawn_file_actions_adddup2(&actions, fd, 1);
    if (!error)
        error = posix_spawnp(pid, argv[0], &actions, NULL, (char *const *)argv, environ);
    posix_spawn_file_actions_destroy(&actions);
    return error;
}

// Uses a socket pair instead of pipes: writing to a dead partner then returns an error instead of raising a signal.
bool os_partner_start(OsPartner *p, const char *const *argv, const char **why)
{
    int pair[2], error;
    pid_t pid = 0;

    if (socketpair(AF_UNIX, SOCK_STREAM, 0, pair) != 0)
        return set_reason(errno, why);
    fcntl(pair[0], F_SETFD, FD_CLOEXEC);
    fcntl(pair[1], F_SETFD, FD_CLOEXEC);
    error = spawn_with_stdio(pair[1], argv, &pid);
    close(pair[1]);
    if (error) {
        close(pair[0]);
        return set_reason(error, why);
    }
    p->fd = pair[0];
    p->pid = pid;
    return true;
}

// Writes all n bytes to the partner's standard input.
bool os_partner_write(OsPartner *p, const void *bytes, size_t n, const char **why)
{
    for (const char *at = bytes; n > 0;) {
        const ssize_t put = send(p->fd, at, n, MSG_NOSIGNAL);
        if (put < 0 && errno != EINTR)
            return set_reason(errno, why);
        at += put > 0 ? put : 0;
        n -= put > 0 ? (size_t)put : 0;
    }
    return true;
}

// Waits for exactly n bytes from the partner's standard output.
bool os_partner_read(OsPartner *p, void *bytes, size_t n, const char **why)
{
    for (char *at = bytes; n > 0;) {
        const ssize_t got = recv(p->fd, at, n, 0);
        if (got < 0 && errno != EINTR)
            return set_reason(errno, why);
        if (got == 0) {
            *why = "it ended by itself";
            return false;
        }
        at += got > 0 ? got : 0;
        n -= got > 0 ? (size_t)got : 0;
    }
    return true;
}

// Closes the partner's input and waits for the partner's end.
void os_partner_end(OsPartner *p)
{
    close(p->fd);
    wait_for_exit((pid_t)p->pid);
}
