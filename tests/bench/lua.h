// SPDX-License-Identifier: Apache-2.0
// A Lua interpreter as a child process that runs driver.lua.  It measures its own time, so that the cost of communication is not included.
#ifndef BENCH_LUA_H
#define BENCH_LUA_H

#include <stdbool.h>
#include <stdio.h>

typedef struct Lua {
    FILE *to, *from;
    int pid;
} Lua;

typedef enum LuaIs { LUA_HERE, LUA_ABSENT, LUA_BROKEN } LuaIs;

// Starts it.  `command` contains at most five words, as in "luajit -joff".
LuaIs lua_open(Lua *l, const char *command, const char *workload, const char *inputs);
// Sends a line and receives the answer, without its newline.  Returns false if no answer arrives.
bool lua_ask(Lua *l, char *answer, size_t size, const char *line);
void lua_close(Lua *l);

#endif
