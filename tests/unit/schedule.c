// SPDX-License-Identifier: Apache-2.0
// Checks which conditionals of a script a step evaluates: all that can be true, in source order, and few others.
#include <string.h>

#include "compiler/script/schedule.h"
#include "compiler/session.h"
#include "tests/test.h"
#include "tests/unit/host.h"
#include "tests/unit/random.h"

enum { GUARDS = 300, TIMES_TRIED = 60, SCRIPTS = 40 };

static const char machine[] = "[state_vector]\nU64 G\nU32 S\nF64 x\n[local]\nU16 k = 7 @read_only\nU8 n = 3\n[A]\n.step\nn = 4\n[B]\n.step\nx = n\n";

// ---- random scripts ----

static uint32_t pick(uint32_t n) { return (uint32_t)(random_u64() >> 32) % n; }

static void write_limit(Buf *b)
{
    static const char *const limit[] = {"k", "n", "x", "(0 / 0)", "(1 / 0)", "(2 * k)", "G", "T", "S"};

    if (pick(3))
        buf_printf(b, "%u", pick(40));
    else
        buf_str(b, limit[pick(sizeof limit / sizeof *limit)]);
}

static void write_comparison(Buf *b)
{
    static const char *const op[] = {"==", "!=", "<", "<=", ">", ">="};
    static const char *const time[] = {"G", "T", "x"};
    const char *const t = time[pick(3)];

    if (pick(6) == 0) {
        write_limit(b);
        buf_printf(b, " %s %s %s ", op[2 + pick(4)], t, op[2 + pick(4)]);
        write_limit(b);
    } else if (pick(2)) {
        buf_printf(b, "%s %s ", t, op[pick(6)]);
        write_limit(b);
    } else {
        write_limit(b);
        buf_printf(b, " %s %s", op[pick(6)], t);
    }
}

static void write_guard(Buf *b, int depth)
{
    const uint32_t form = depth == 0 ? 0 : pick(5);

    if (form <= 1) {
        write_comparison(b);
        return;
    }
    buf_str(b, form == 4 ? "not (" : "(");
    write_guard(b, depth - 1);
    buf_str(b, form == 2 ? " and " : " or ");
    write_guard(b, depth - 1);
    buf_str(b, ")");
}

static void write_script(Buf *b)
{
    static const char *const section[] = {"A", "all_states", "B", "all_states"};

    buf_str(b, "[options]\ndelta_t 1\n");
    for (int i = 0; i < GUARDS; i++) {
        if (i % (GUARDS / 4) == 0)
            buf_printf(b, "[%s]\n", section[i / (GUARDS / 4)]);
        write_guard(b, 2);
        buf_str(b, ": @stop\n");
    }
}

// ---- checks ----

static uint64_t cell_of(double x) { uint64_t u; memcpy(&u, &x, sizeof u); return u; }

// Whether the due items are in source order, occur once each, and no other item has a true guard.
static bool misses_none(const Script *s, const State *state, const uint64_t *cell, const DueItems *due)
{
    size_t next = 0;

    for (size_t i = 0; i < s->section.n; i++)
        for (size_t k = 0; k < s->section.at[i].item.n; k++) {
            const ScriptItem *item = s->section.at[i].item.at[k];
            if (next < due->n && due->at[next] == item)
                next++;
            else if ((!s->section.at[i].state || s->section.at[i].state == state) && ref_true(ref_eval(item->guard, cell, NULL)))
                return false;
        }
    return next == due->n;
}

static Script *compile(Session *s, const char *text, size_t n, const Program **p)
{
    MachineInput in = {source_new(&s->arena, "m.sm", machine, strlen(machine)), NULL, NULL, NULL};

    *p = session_program(s, &in);
    return session_script(s, source_new(&s->arena, "m.ss", text, n), *p);
}

static uint64_t *initial_cells(Session *s, const Program *p)
{
    uint64_t *cell = ARENA_ARRAY(&s->arena, uint64_t, p->var.n);

    for (size_t i = 0; i < p->var.n; i++)
        cell[i] = p->var.at[i]->kind == VAR_LOCAL ? p->var.at[i]->init : 0;
    return cell;
}

static void check_random_script(void)
{
    static const double x_tried[] = {0, 7, 14, -1, 39};
    Session s;
    Buf text;
    const Program *p;
    Script *script;
    uint64_t *cell;
    Schedule *h;
    DueItems due = {0};

    session_init(&s, heap_alloc, NULL, &host_oom);
    buf_init(&text, &s.arena);
    write_script(&text);
    script = compile(&s, buf_text(&text), text.n, &p);
    CHECK(script != NULL);
    if (!script)
        return;
    cell = initial_cells(&s, p);
    h = schedule_new(&s.arena, script, cell);
    for (uint32_t i = 0; i < TIMES_TRIED; i++) {
        const State *state = p->state.at[i % 2];
        cell[p->g->index] = pick(45);
        cell[p->t->index] = pick((uint32_t)cell[p->g->index] + 1);
        cell[p->s->index] = state->number;
        cell[2] = cell_of(x_tried[pick(5)]);        // x
        schedule_find_due(h, &state, 1, cell, &due);
        CHECK(misses_none(script, state, cell, &due));
    }
    session_free(&s);
}

// A script with a conditional for each step: one conditional is evaluated in each step.
static void check_one_a_step(void)
{
    enum { STEPS = 1000 };
    Session s;
    Buf text;
    const Program *p;
    Script *script;
    uint64_t *cell;
    Schedule *h;
    DueItems due = {0};

    session_init(&s, heap_alloc, NULL, &host_oom);
    buf_init(&text, &s.arena);
    buf_str(&text, "[options]\ndelta_t 1\n[A]\n");
    for (unsigned i = 0; i < STEPS; i++)
        buf_printf(&text, i % 3 == 0 ? "G == %u: x = 1\n" : i % 3 == 1 ? "x > 0 and T == %u: x = 1\n" : "%u <= G < %u.5: x = 1\n", i, i);
    buf_str(&text, "G == 2000: @stop\n");
    script = compile(&s, buf_text(&text), text.n, &p);
    CHECK(script != NULL);
    if (!script)
        return;
    cell = initial_cells(&s, p);
    h = schedule_new(&s.arena, script, cell);
    for (unsigned i = 0; i < STEPS; i++) {
        cell[p->g->index] = cell[p->t->index] = i;
        schedule_find_due(h, (const State *const *)p->state.at, 1, cell, &due);
        CHECK(due.n == 1 && due.at[0]->number == i);
    }
    session_free(&s);
}

// A script with a conditional for each period, in a section that not every step visits: a step evaluates those of which it is a multiple.
static void check_periods(void)
{
    enum { PERIODS = 200, STEPS = 2000 };
    Session s;
    Buf text;
    const Program *p;
    Script *script;
    uint64_t *cell;
    Schedule *h;
    DueItems due = {0};

    session_init(&s, heap_alloc, NULL, &host_oom);
    buf_init(&text, &s.arena);
    buf_str(&text, "[options]\ndelta_t 1\n[A]\n");
    for (unsigned i = 1; i <= PERIODS; i++)
        buf_printf(&text, "every %u: @stop\n", i);
    buf_str(&text, "from 50 to 60 { every 7: @stop }\n");
    script = compile(&s, buf_text(&text), text.n, &p);
    CHECK(script != NULL);
    if (!script)
        return;
    cell = initial_cells(&s, p);
    h = schedule_new(&s.arena, script, cell);
    for (unsigned g = 0; g < STEPS; g += 1 + pick(3)) {
        const bool in_range = g >= 50 && g <= 60;
        size_t divisors = 0;
        for (unsigned i = 1; i <= PERIODS; i++)
            divisors += g % i == 0;
        cell[p->g->index] = g;
        schedule_find_due(h, (const State *const *)&p->state.at[pick(2)], 1, cell, &due);
        CHECK(due.n == 0 || (due.n >= divisors && due.n <= divisors + 2 * in_range));
    }
    session_free(&s);
}

int main(void)
{
    host_check(setjmp(host_oom));
    for (int i = 0; i < SCRIPTS; i++)
        check_random_script();
    check_one_a_step();
    check_periods();
    return test_end("schedule");
}
