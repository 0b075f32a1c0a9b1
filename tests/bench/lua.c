// SPDX-License-Identifier: Apache-2.0
#define _POSIX_C_SOURCE 200809L
#include "tests/bench/lua.h"

#include <fcntl.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

enum { WORDS = 5, NOT_FOUND = 127 };

static void become(const int *in, const int *out, const char *command, const char *workload, const char *inputs)
{
    static char text[100], driver[] = "tests/bench/driver.lua", name[40], path[400];
    char *argv[WORDS + 4] = {0};
    int n = 0;

    dup2(in[0], 0);
    dup2(out[1], 1);
    close(in[0]);
    close(in[1]);
    close(out[0]);
    close(out[1]);
    snprintf(text, sizeof text, "%s", command);
    for (char *word = strtok(text, " "); word && n < WORDS; word = strtok(NULL, " "))
        argv[n++] = word;
    snprintf(name, sizeof name, "%s", workload);
    snprintf(path, sizeof path, "%s", inputs);
    argv[n++] = driver;
    argv[n++] = name;
    argv[n++] = path;
    execvp(argv[0], argv);
    _exit(NOT_FOUND);
}

bool lua_ask(Lua *l, char *answer, size_t size, const char *line)
{
    if (fputs(line, l->to) == EOF || fputs("\n", l->to) == EOF || fflush(l->to) != 0)
        return false;
    if (!fgets(answer, (int)size, l->from))
        return false;
    answer[strcspn(answer, "\n")] = 0;
    return true;
}

static int end_of(Lua *l)                             // returns the exit code
{
    int status = 0;

    fclose(l->to);
    fclose(l->from);
    waitpid(l->pid, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

LuaIs lua_open(Lua *l, const char *command, const char *workload, const char *inputs)
{
    int in[2], out[2];
    char answer[20];

    if (pipe(in) != 0 || pipe(out) != 0)
        return LUA_BROKEN;
    fflush(NULL);
    l->pid = fork();
    if (l->pid == 0)
        become(in, out, command, workload, inputs);
    close(in[0]);
    close(out[1]);
    fcntl(in[1], F_SETFD, FD_CLOEXEC);        // otherwise the next child inherits the pipe, and this child never sees the end of its input
    fcntl(out[0], F_SETFD, FD_CLOEXEC);
    l->to = fdopen(in[1], "w");
    l->from = fdopen(out[0], "r");
    if (lua_ask(l, answer, sizeof answer, "count 0 0"))
        return LUA_HERE;
    return end_of(l) == NOT_FOUND ? LUA_ABSENT : LUA_BROKEN;
}

void lua_close(Lua *l)
{
    end_of(l);
}
