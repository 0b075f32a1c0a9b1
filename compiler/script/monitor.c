// SPDX-License-Identifier: Apache-2.0
#include "compiler/script/monitor.h"

#include <string.h>

// What is remembered of the steps so far for a requirement.  Comments begin with RequirementKind; a, b and c are its conditions.
typedef struct Memory {
    uint64_t since;           // AFTER: G of the last step in which b was true; LEADS_TO: G of the first step with a, for which b is still awaited
    bool seen;                // BEFORE, AFTER: b was true in some step so far
    bool open;                // AFTER: c has not been true since b was last true; LEADS_TO: b is still awaited
} Memory;

// The fields of a RefWindow, of the same names, that a step changes; the samples are stored after them.
typedef struct WindowMemory {
    uint64_t last;
    uint32_t next, filled;
    bool ran;
} WindowMemory;

// A situation consists of a Memory for each requirement, then a WindowMemory for each window, then the samples of all windows.
static Memory *memories_of(void *situation) { return situation; }
static WindowMemory *window_memories(const Monitor *m, void *situation) { return (WindowMemory *)(memories_of(situation) + m->what->at.n); }

// Computes the offset of the samples of each used window in a situation, and the size of a situation.
static void place_windows(Monitor *m)
{
    m->size = m->what->at.n * sizeof(Memory) + m->windows.n * sizeof(WindowMemory);
    for (size_t i = 0; i < m->windows.n; i++) {
        m->samples_at[i] = m->size;
        if (!m->windows.at[i].is_unused)
            m->size += ref_window_samples(&m->what->window.at[i]) * sizeof(uint64_t);
    }
}

Monitor *monitor_new(Arena *arena, const Requirements *what, uint64_t delta_t)
{
    Monitor *m = ARENA_NEW(arena, Monitor);

    m->what = what;
    m->step = delta_t > 0 || what->program->joint ? delta_t : 1;
    m->result = arena_alloc(arena, what->at.n);
    m->ran = what->program->joint ? ARENA_ARRAY(arena, bool, what->program->joint->member.n) : NULL;
    m->samples_at = ARENA_ARRAY(arena, size_t, what->window.n);
    m->end = what->at.n;
    ref_windows_init_unplaced(&m->windows, arena, &what->window);
    place_windows(m);
    return m;
}

// Called by expr_walk for each part of a condition: marks a window as used.  expr_walk also visits the sampled expression and the windows in it.
static void mark_used(Expr *e, void *context)
{
    const Monitor *m = context;

    if (e->kind == EX_ROLL)
        m->windows.at[e->window].is_unused = false;
}

void monitor_judge_only(Monitor *m, size_t requirement)
{
    const Requirement *r = &m->what->at.at[requirement];
    Expr *const part[] = {(Expr *)r->a, (Expr *)r->b, (Expr *)r->c};

    m->first = requirement;
    m->end = requirement + 1;
    for (size_t i = 0; i < m->windows.n; i++)
        m->windows.at[i].is_unused = true;
    for (size_t i = 0; i < sizeof part / sizeof *part; i++)
        if (part[i])
            expr_walk(part[i], mark_used, m);
    place_windows(m);
}

void monitor_start(const Monitor *m, void *situation) { memset(situation, 0, m->size); }

// ---- the windows of a situation ----

// Sets m->windows to the windows of a situation.
static void load_windows(Monitor *m, void *situation)
{
    for (size_t i = 0; i < m->windows.n; i++) {
        const WindowMemory *from = &window_memories(m, situation)[i];
        RefWindow *w = &m->windows.at[i];
        ref_window_place(w, (char *)situation + m->samples_at[i]);
        w->last = from->last;
        w->ran = from->ran;
        w->next = from->next;
        w->filled = from->filled;
    }
}

static void store_windows(const Monitor *m, void *situation)
{
    for (size_t i = 0; i < m->windows.n; i++) {
        const RefWindow *w = &m->windows.at[i];
        WindowMemory *to = &window_memories(m, situation)[i];
        to->last = w->last;
        to->ran = w->ran;
        to->next = w->next;
        to->filled = w->filled;
    }
}

// ---- a step ----

static MonitorResult result_of(bool met) { return met ? MONITOR_JUDGED : MONITOR_VIOLATED; }

// Judges `never a before b`: a step with a violates it unless an earlier step had b (requirements.md 13.10).
static MonitorResult judge_before(Memory *mem, bool a, bool b)
{
    const MonitorResult result = a ? result_of(mem->seen) : MONITOR_IDLE;

    mem->seen = mem->seen || b;
    return result;
}

// Judges `never a after b without c`: a step with a violates it if no step since the last earlier step with b had c (requirements.md 13.11).
static MonitorResult judge_after(Memory *mem, bool a, bool b, bool c, uint64_t g)
{
    const MonitorResult result = a && mem->seen ? result_of(!mem->open) : MONITOR_IDLE;

    if (b && result != MONITOR_VIOLATED)              // `since` is read only for messages, which need its value before a violation
        mem->since = g;
    mem->seen = mem->seen || b;
    mem->open = b || (mem->open && !c);
    return result;
}

// Judges `always a leads to b within t`: the first step with a that no step with b has followed yet is undecided (requirements.md 13.12).
static MonitorResult judge_leads_to(const Monitor *m, Memory *mem, bool a, bool b, uint64_t within, uint64_t g)
{
    uint64_t passed;

    if (!mem->open && a) {
        mem->open = true;
        mem->since = g;
    }
    if (!mem->open)
        return MONITOR_IDLE;
    passed = g - mem->since;
    if (passed <= within && !b && within - passed >= m->step)
        return MONITOR_IDLE;
    mem->open = false;
    return result_of(b && passed <= within);
}

// Whether condition e, which is number i (0: a, 1: b, 2: c) of requirement r, is true. A condition about the state of a machine is false in a tick in
// which the machine did not step.
static bool is_true(const Monitor *m, const Requirement *r, int i, const Expr *e, const uint64_t *cell)
{
    return e && (r->machine[i] == 0 || m->ran[r->machine[i] - 1]) && ref_true(ref_eval(e, cell, &m->windows));
}

// Judges one requirement after a step; `mem`: what is remembered of earlier steps for it.
static MonitorResult judge_requirement(const Monitor *m, const Requirement *r, Memory *mem, const uint64_t *cell, uint64_t g)
{
    const bool a = is_true(m, r, 0, r->a, cell), b = is_true(m, r, 1, r->b, cell);

    switch (r->kind) {
    case REQUIREMENT_NEVER:    return result_of(!a);
    case REQUIREMENT_ALWAYS:   return r->a && !a ? MONITOR_IDLE : result_of(b);
    case REQUIREMENT_BEFORE:   return judge_before(mem, a, b);
    case REQUIREMENT_AFTER:    return judge_after(mem, a, b, is_true(m, r, 2, r->c, cell), g);
    case REQUIREMENT_LEADS_TO: return judge_leads_to(m, mem, a, b, r->within, g);
    }
    return MONITOR_IDLE;
}

bool monitor_step(Monitor *m, void *situation, const uint64_t *cell)
{
    const uint64_t g = cell[m->what->program->g->index];
    bool violated = false;

    load_windows(m, situation);
    ref_windows_sample(&m->windows, cell);
    store_windows(m, situation);
    for (size_t i = m->first; i < m->end; i++) {
        m->result[i] = (uint8_t)judge_requirement(m, &m->what->at.at[i], &memories_of(situation)[i], cell, g);
        violated = violated || m->result[i] == MONITOR_VIOLATED;
    }
    return violated;
}

bool monitor_is_open(const Monitor *m, const void *situation, size_t requirement, uint64_t *since)
{
    const Memory *mem = (const Memory *)situation + requirement;

    *since = mem->since;
    return m->what->at.at[requirement].kind == REQUIREMENT_LEADS_TO && mem->open;
}
