// SPDX-License-Identifier: Apache-2.0
// A Lua as a child process that runs driver.lua: it times itself, so that the cost of communication does not count.
#ifndef BENCH_LUA_H
#define BENCH_LUA_H

#include <stdbool.h>
#include <stdio.h>

typedef struct Lua {
    FILE *to, *from;
    int pid;
} Lua;

typedef enum LuaIs { LUA_HERE, LUA_ABSENT, LUA_BROKEN } LuaIs;

// command: its words, "luajit -joff"; not more than five.
LuaIs lua_open(Lua *l, const char *command, const char *workload, const char *inputs);
// Sends a line; false if no answer comes.  The answer, without its newline, is in `answer`.
bool lua_ask(Lua *l, char *answer, size_t size, const char *line);
void lua_close(Lua *l);

#endif
