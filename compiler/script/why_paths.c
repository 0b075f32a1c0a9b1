// SPDX-License-Identifier: Apache-2.0
#include "compiler/script/why_paths.h"

#include "compiler/base/buf.h"

const WatchStmt *why_find_transition(const Watch *w, const State *from, const State *to)
{
    for (uint32_t i = 1; i <= w->p->stmts; i++)
        if (w->stmt[i].stmt && w->stmt[i].stmt->kind == ST_TRANSITION && w->stmt[i].state == from && w->stmt[i].stmt->target == to)
            return &w->stmt[i];
    return NULL;
}

// For each state from which a path leads to `to`, sets next[State.number - 1] to the state that follows on the shortest path.
static void search_backwards(Arena *arena, const Watch *w, const State *to, const State **next)
{
    const State **queue = ARENA_ARRAY(arena, const State *, w->p->state.n + 1);
    size_t head = 0, tail = 0;

    queue[tail++] = to;
    for (; head < tail; head++)
        for (uint32_t i = 1; i <= w->p->stmts; i++) {
            const WatchStmt *t = &w->stmt[i];
            if (!t->stmt || t->stmt->kind != ST_TRANSITION || t->stmt->target != queue[head] || t->state == to || next[t->state->number - 1])
                continue;
            next[t->state->number - 1] = queue[head];
            queue[tail++] = t->state;
        }
}

WhyPath why_shortest_path(Arena *arena, const Watch *w, const State *from, const State *to)
{
    const State **next = ARENA_ARRAY(arena, const State *, w->p->state.n);
    WhyPath path = {ARENA_ARRAY(arena, const State *, w->p->state.n + 1), 0};

    search_backwards(arena, w, to, next);
    for (const State *s = from; s && s != to; s = next[s->number - 1])
        path.at[path.n++] = s;
    path.at[path.n++] = to;
    if (!next[from->number - 1])
        path.n = 0;
    return path;
}

const char *why_path_text(Arena *arena, const WhyPath *path)
{
    Buf out;

    buf_init(&out, arena);
    for (size_t i = 0; i < path->n; i++)
        buf_printf(&out, "%s%s", i ? " -> " : "", path->at[i]->name->text);
    return buf_text(&out);
}
