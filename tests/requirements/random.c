// SPDX-License-Identifier: Apache-2.0
// Checks random requirements in runs of random machines: the monitor against a slow evaluation of the whole run by the definitions of
// docs/requirements.md.  It shares no code with the monitor, the parser or the reference: conditions are separate trees, which are printed for
// smc.  Situations are also copied elsewhere and back, and must give the same results.
//     random SEED COUNT [--print]
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compiler/base/buf.h"
#include "compiler/script/engine.h"
#include "compiler/script/monitor.h"
#include "tests/diff/subject.h"

enum { STEPS = 60, REQUIREMENTS = 8, DEPTH = 3 };

// ---- conditions ----

typedef enum CondKind {
    C_TRUTH,                  // a variable as a condition
    C_LESS, C_EQUAL,          // variable, number
    C_STATE,                  // S == state
    C_NOT, C_AND, C_OR, C_IMPLIES,
    C_PREV, C_RISING, C_FALLING,      // of a condition
    C_HELD,                   // held(condition, n steps)
    C_MAX, C_OLDEST,          // roll_max(variable, n) > number; prev(variable) > number
    C_KINDS
} CondKind;

typedef struct Cond Cond;
struct Cond {
    CondKind kind;
    const Var *var;
    const char *number;
    uint32_t state;           // its number
    uint32_t n;
    const Cond *a, *b;
};

typedef struct Demand {
    RequirementKind kind;
    const Cond *a, *b, *c;    // as in Requirement
    bool named[3];            // a, b, c is the name of a state
    uint64_t within;
} Demand;

// A recorded run.
typedef struct Run {
    const Program *p;
    uint64_t *cell[STEPS];    // by step, by variable
    size_t steps;
    uint64_t least;           // the least by which G advances
} Run;

typedef struct Maker { Arena *arena; Rng rng; const Run *run; } Maker;

static Cond *new_cond(Maker *m, CondKind kind)
{
    Cond *c = ARENA_NEW(m->arena, Cond);

    c->kind = kind;
    return c;
}

// Returns the value of a cell as conditions read it: a stored NaN is 0.
static double value_of(const Var *v, uint64_t cell)
{
    const unsigned bits = 8 * sm_type_info[v->type].bytes;
    double x;
    float f;
    uint32_t low;

    switch (sm_type_info[v->type].kind) {
    case SM_KIND_BOOL: return cell != 0;
    case SM_KIND_UNSIGNED: return (double)cell;
    case SM_KIND_SIGNED: return (double)(bits == 64 ? (int64_t)cell : (int64_t)(cell << (64 - bits)) / (INT64_C(1) << (64 - bits)));
    case SM_KIND_FLOAT:
        low = (uint32_t)cell;
        memcpy(&f, &low, sizeof f);
        memcpy(&x, &cell, sizeof x);
        x = bits == 32 ? (double)f : x;
        return x != x ? 0 : x;
    }
    return 0;
}

static const Var *any_var(Maker *m) { return m->run->p->var.at[rng_below(&m->rng, (uint32_t)m->run->p->var.n)]; }

// Returns a number near a value of the variable, so that comparisons have both results.
static const char *any_number(Maker *m, const Var *v)
{
    const double x = value_of(v, m->run->cell[rng_below(&m->rng, (uint32_t)m->run->steps)][v->index]);
    const char *text = format_in(m->arena, "%.17g", x);

    return fabs(x) < 1e15 && !strchr(text, 'e') ? text : "0";
}

static Cond *any_cond(Maker *m, unsigned depth)
{
    static const CondKind leaves[] = {C_TRUTH, C_LESS, C_EQUAL, C_STATE, C_STATE, C_MAX, C_OLDEST};
    Cond *c = new_cond(m, depth == 0 || rng_percent(&m->rng, 40) ? leaves[rng_below(&m->rng, 7)] : (CondKind)rng_below(&m->rng, C_KINDS));

    c->var = any_var(m);
    c->number = any_number(m, c->var);
    c->state = 1 + rng_below(&m->rng, (uint32_t)m->run->p->state.n);
    c->n = 1 + rng_below(&m->rng, 5);
    if (depth > 0 && c->kind >= C_NOT && c->kind <= C_HELD) {
        c->a = any_cond(m, depth - 1);
        c->b = any_cond(m, depth - 1);
    }
    return c;
}

static Cond *state_cond(Maker *m)
{
    Cond *c = new_cond(m, C_STATE);

    c->state = 1 + rng_below(&m->rng, (uint32_t)m->run->p->state.n);
    return c;
}

static Demand any_demand(Maker *m)
{
    Demand d = {.kind = (RequirementKind)rng_below(&m->rng, REQUIREMENT_LEADS_TO + 1)};
    const Cond **part[] = {&d.a, &d.b, &d.c};

    for (int i = 0; i < 3; i++) {
        d.named[i] = (d.kind == REQUIREMENT_BEFORE || d.kind == REQUIREMENT_AFTER) && rng_percent(&m->rng, 60);
        *part[i] = d.named[i] ? state_cond(m) : any_cond(m, DEPTH);
    }
    if (d.kind == REQUIREMENT_NEVER && d.a->kind == C_IMPLIES)
        d.kind = REQUIREMENT_BEFORE;
    if (d.kind == REQUIREMENT_ALWAYS && rng_percent(&m->rng, 40))
        d.a = NULL;
    d.within = rng_below(&m->rng, 8) * (m->run->least > 1 ? m->run->least / 2 : 7);
    return d;
}

// ---- as text ----

static void print_cond(const Program *p, const Cond *c, Buf *out);

static void print_call(const Program *p, const char *name, const Cond *c, Buf *out)
{
    buf_printf(out, "%s(", name);
    print_cond(p, c->a, out);
    if (c->kind == C_HELD)
        buf_printf(out, ", %u steps", (unsigned)c->n);
    buf_char(out, ')');
}

static void print_infix(const Program *p, const char *word, const Cond *c, Buf *out)
{
    buf_char(out, '(');
    print_cond(p, c->a, out);
    buf_printf(out, " %s ", word);
    print_cond(p, c->b, out);
    buf_char(out, ')');
}

static void print_cond(const Program *p, const Cond *c, Buf *out)
{
    const char *name = c->var ? c->var->name->text : "";

    switch (c->kind) {
    case C_TRUTH:   buf_str(out, name); break;
    case C_LESS:    buf_printf(out, "(%s < %s)", name, c->number); break;
    case C_EQUAL:   buf_printf(out, "(%s == %s)", name, c->number); break;
    case C_STATE:   buf_printf(out, "(%s == %u)", p->s->name->text, (unsigned)c->state); break;
    case C_NOT:     buf_str(out, "(not ("), print_cond(p, c->a, out), buf_str(out, "))"); break;
    case C_AND:     print_infix(p, "and", c, out); break;
    case C_OR:      print_infix(p, "or", c, out); break;
    case C_IMPLIES: print_infix(p, "implies", c, out); break;
    case C_PREV:    print_call(p, "prev", c, out); break;
    case C_RISING:  print_call(p, "rising", c, out); break;
    case C_FALLING: print_call(p, "falling", c, out); break;
    case C_HELD:    print_call(p, "held", c, out); break;
    case C_MAX:     buf_printf(out, "(roll_max(%s, %u) > %s)", name, (unsigned)c->n, c->number); break;
    case C_OLDEST:  buf_printf(out, "(prev(%s) > %s)", name, c->number); break;
    case C_KINDS:   break;
    }
}

static void print_operand(const Program *p, const Cond *c, bool named, Buf *out)
{
    if (named) {
        buf_str(out, p->state.at[c->state - 1]->name->text);
        return;
    }
    buf_char(out, '(');
    print_cond(p, c, out);
    buf_char(out, ')');
}

static void print_demand(const Program *p, const Demand *d, Buf *out)
{
    switch (d->kind) {
    case REQUIREMENT_NEVER:
        buf_str(out, "never ");
        print_cond(p, d->a, out);
        break;
    case REQUIREMENT_ALWAYS:
        buf_str(out, "always ");
        if (d->a) {
            print_cond(p, d->a, out);
            buf_str(out, " implies ");
        } else
            buf_str(out, "0 + ");                      // prevents that an implication in the operand counts as the premise
        print_cond(p, d->b, out);
        break;
    case REQUIREMENT_BEFORE: case REQUIREMENT_AFTER:
        buf_str(out, "never ");
        print_operand(p, d->a, d->named[0], out);
        buf_str(out, d->kind == REQUIREMENT_BEFORE ? " before " : " after ");
        print_operand(p, d->b, d->named[1], out);
        if (d->kind == REQUIREMENT_BEFORE)
            break;
        buf_str(out, " without ");
        print_operand(p, d->c, d->named[2], out);
        break;
    case REQUIREMENT_LEADS_TO:
        buf_str(out, "always ");
        print_cond(p, d->a, out);
        buf_str(out, " leads to ");
        print_cond(p, d->b, out);
        buf_printf(out, " within %" PRIu64, d->within);
        break;
    }
    buf_char(out, '\n');
}

// ---- the slow evaluation ----

static double var_at(const Run *r, const Var *v, size_t k) { return value_of(v, r->cell[k][v->index]); }

// Returns the value of a condition as a number: that of the variable, otherwise 0 or 1.  prev has the number of its operand.
static double number_at(const Run *r, const Cond *c, size_t k);
static bool at(const Run *r, const Cond *c, size_t k) { return number_at(r, c, k) != 0; }

static bool held_at(const Run *r, const Cond *c, size_t k)
{
    // With a step, time that advances by more than two of them ends the run (language.md 7.32).
    for (size_t i = 0; i < c->n; i++) {
        const uint64_t step = r->p->step;
        if (i > k || !at(r, c->a, k - i))
            return false;
        if (i + 1 < c->n && step && i < k && r->cell[k - i][r->p->g->index] - r->cell[k - i - 1][r->p->g->index] > 2 * step)
            return false;
    }
    return true;
}

static double max_at(const Run *r, const Cond *c, size_t k)
{
    double best = var_at(r, c->var, k);

    for (size_t i = 1; i < c->n && i <= k; i++)
        best = fmax(best, var_at(r, c->var, k - i));
    return best;
}

static double number_at(const Run *r, const Cond *c, size_t k)
{
    const size_t before = k ? k - 1 : 0;

    switch (c->kind) {
    case C_TRUTH:   return var_at(r, c->var, k);
    case C_LESS:    return var_at(r, c->var, k) < strtod(c->number, NULL);
    case C_EQUAL:   return var_at(r, c->var, k) == strtod(c->number, NULL);
    case C_STATE:   return var_at(r, r->p->s, k) == c->state;
    case C_NOT:     return !at(r, c->a, k);
    case C_AND:     return at(r, c->a, k) && at(r, c->b, k);
    case C_OR:      return at(r, c->a, k) || at(r, c->b, k);
    case C_IMPLIES: return !at(r, c->a, k) || at(r, c->b, k);
    case C_PREV:    return number_at(r, c->a, before);
    case C_RISING:  return at(r, c->a, k) && !at(r, c->a, before);
    case C_FALLING: return !at(r, c->a, k) && at(r, c->a, before);
    case C_HELD:    return held_at(r, c, k);
    case C_MAX:     return max_at(r, c, k) > strtod(c->number, NULL);
    case C_OLDEST:  return var_at(r, c->var, before) > strtod(c->number, NULL);
    case C_KINDS:   break;
    }
    return 0;
}

static uint64_t g_at(const Run *r, size_t k) { return r->cell[k][r->p->g->index]; }

// The last step before k with c; -1: none.
static long last_before(const Run *r, const Cond *c, size_t k)
{
    for (long i = (long)k - 1; i >= 0; i--)
        if (at(r, c, (size_t)i))
            return i;
    return -1;
}

static bool has_between(const Run *r, const Cond *c, long after, size_t before)
{
    for (size_t i = (size_t)after + 1; i < before; i++)
        if (at(r, c, i))
            return true;
    return false;
}

// Sets for each step what a `leads to` decides there.  Returns whether it is undecided after step `end` - 1.
static bool slow_leads_to(const Run *r, const Demand *d, size_t end, MonitorResult *result)
{
    for (size_t i = 0; i < end; i++)
        result[i] = MONITOR_IDLE;
    for (size_t i = 0; i < end; i++) {
        size_t k = i;
        if (!at(r, d->a, i))
            continue;
        // Whether no later step can have e, because the time of the next one is certainly later than t.
        while (k < end && !at(r, d->b, k) && g_at(r, k) - g_at(r, i) < d->within && d->within - (g_at(r, k) - g_at(r, i)) >= r->least)
            k++;
        if (k == end)
            return true;
        result[k] = at(r, d->b, k) && g_at(r, k) - g_at(r, i) <= d->within ? MONITOR_JUDGED : MONITOR_VIOLATED;
        i = k;
    }
    return false;
}

static MonitorResult slow_result(const Run *r, const Demand *d, size_t k)
{
    long last;

    switch (d->kind) {
    case REQUIREMENT_NEVER: return at(r, d->a, k) ? MONITOR_VIOLATED : MONITOR_JUDGED;
    case REQUIREMENT_ALWAYS:
        if (d->a && !at(r, d->a, k))
            return MONITOR_IDLE;
        return at(r, d->b, k) ? MONITOR_JUDGED : MONITOR_VIOLATED;
    case REQUIREMENT_BEFORE:
        if (!at(r, d->a, k))
            return MONITOR_IDLE;
        return last_before(r, d->b, k) >= 0 ? MONITOR_JUDGED : MONITOR_VIOLATED;
    case REQUIREMENT_AFTER:
        if (!at(r, d->a, k) || (last = last_before(r, d->b, k)) < 0)
            return MONITOR_IDLE;
        return has_between(r, d->c, last, k) ? MONITOR_JUDGED : MONITOR_VIOLATED;
    case REQUIREMENT_LEADS_TO: break;
    }
    return MONITOR_IDLE;
}

// ---- one program ----

// Runs the machine on the reference, and records the steps that were not refused.  With `regular`, G advances by the same amount in each step.
static void record_run(Run *r, const Subject *s, const Gen *g, Arena *arena, bool regular)
{
    EngineWrite write[GEN_VARS_MAX];
    Engine *ref = engine_ref_open(arena, s->program);
    EngineStep out;

    r->p = s->program;
    r->steps = 0;
    r->least = regular ? s->program->step ? s->program->step : 10 : 1;
    engine_step_init(&out, arena, r->p);
    ref->init(ref, 1 + (uint32_t)(g->seed % r->p->state.n), &out);
    for (uint32_t k = 0; k < STEPS; k++) {
        const uint32_t n = subject_writes(s, g, k, write);
        for (uint32_t i = 0; i < n && regular; i++)
            if (write[i].var == r->p->g->index)
                write[i].cell = k * r->least;
        if (ref->step(ref, write, n, &out) == ENGINE_OK)
            r->cell[r->steps++] = arena_copy(arena, out.cell, r->p->var.n * sizeof *out.cell);
    }
}

static struct { uint64_t result[REQUIREMENT_LEADS_TO + 1][MONITOR_VIOLATED + 1], undecided, programs, copies, smaller; } met;

// Steps through the run and compares each requirement up to its first violation.
static const char *compare(Maker *m, const Requirements *q, const Demand *demand)
{
    const Run *r = m->run;
    Monitor *monitor = monitor_new(m->arena, q, r->least > 1 ? r->least : 0);
    char *situation = arena_alloc(m->arena, monitor->size), *copy = arena_alloc(m->arena, monitor->size);
    bool done[REQUIREMENTS] = {false};
    MonitorResult lead[REQUIREMENTS][STEPS];
    uint64_t since;

    for (size_t i = 0; i < REQUIREMENTS; i++)
        if (demand[i].kind == REQUIREMENT_LEADS_TO)
            slow_leads_to(r, &demand[i], r->steps, lead[i]);
    monitor_start(monitor, situation);
    for (size_t k = 0; k < r->steps; k++) {
        if (rng_percent(&m->rng, 30)) {                // continue on a copy, which must not change this situation
            memcpy(copy, situation, monitor->size);
            for (size_t ahead = k; ahead < r->steps && ahead < k + 4; ahead++)
                monitor_step(monitor, copy, r->cell[ahead]);
            if (rng_percent(&m->rng, 50)) {            // continue in another block of memory
                char *other = arena_alloc(m->arena, monitor->size);
                memcpy(other, situation, monitor->size);
                memset(situation, 0xa5, monitor->size);
                situation = other;
            }
            met.copies++;
        }
        monitor_step(monitor, situation, r->cell[k]);
        for (size_t i = 0; i < REQUIREMENTS; i++) {
            const Demand *d = &demand[i];
            const MonitorResult slow = d->kind == REQUIREMENT_LEADS_TO ? lead[i][k] : slow_result(r, d, k);
            if (done[i])
                continue;
            if (slow != monitor->result[i])
                return format_in(m->arena, "R%lu in step %lu: %d, but the monitor has %d", (unsigned long)i + 1, (unsigned long)k + 1, slow, monitor->result[i]);
            met.result[d->kind][slow]++;
            done[i] = slow == MONITOR_VIOLATED;
        }
    }
    for (size_t i = 0; i < REQUIREMENTS; i++) {
        MonitorResult unused[STEPS];
        const bool is_lead = demand[i].kind == REQUIREMENT_LEADS_TO && !done[i];
        if (is_lead && slow_leads_to(r, &demand[i], r->steps, unused) != monitor_is_open(monitor, situation, i, &since))
            return format_in(m->arena, "R%lu at the end: the monitor has it %s", (unsigned long)i + 1, monitor_is_open(monitor, situation, i, &since) ? "open" : "decided");
        met.undecided += is_lead && monitor_is_open(monitor, situation, i, &since);
    }
    return NULL;
}

// Steps a monitor of all requirements, and one of each alone.
static const char *compare_alone(Maker *m, const Requirements *q)
{
    const Run *r = m->run;
    Monitor *all = monitor_new(m->arena, q, 1), *alone[REQUIREMENTS];
    char *of_all = arena_alloc(m->arena, all->size), *of[REQUIREMENTS];

    monitor_start(all, of_all);
    for (size_t i = 0; i < REQUIREMENTS; i++) {
        alone[i] = monitor_new(m->arena, q, 1);
        monitor_judge_only(alone[i], i);
        met.smaller += alone[i]->size < all->size;
        of[i] = arena_alloc(m->arena, alone[i]->size);
        monitor_start(alone[i], of[i]);
    }
    for (size_t k = 0; k < r->steps; k++) {
        monitor_step(all, of_all, r->cell[k]);
        for (size_t i = 0; i < REQUIREMENTS; i++) {
            monitor_step(alone[i], of[i], r->cell[k]);
            if (alone[i]->result[i] != all->result[i])
                return format_in(m->arena, "R%lu in step %lu: %d alone, and %d with the others", (unsigned long)i + 1, (unsigned long)k + 1, alone[i]->result[i], all->result[i]);
        }
    }
    return NULL;
}

static const char *test_program(uint64_t seed, Arena *arena, Subject *s, const char **text)
{
    Gen *g = gen_program(arena, seed, STEPS);
    Demand demand[REQUIREMENTS];
    Run run;
    Maker m = {arena, {rng_mix(seed, 77)}, &run};
    const char *error = subject_compile(s, g, arena);
    const char *wrong;
    const Source *src;
    const Requirements *q;
    Buf rq;

    *text = "";
    if (error)
        return error;
    gen_plan_time(g);
    record_run(&run, s, g, arena, seed % 2);
    if (run.steps == 0)
        return NULL;
    met.programs++;
    buf_init(&rq, arena);
    for (int i = 0; i < REQUIREMENTS; i++) {
        demand[i] = any_demand(&m);
        buf_printf(&rq, "R%d \"random\" ", i + 1);
        print_demand(run.p, &demand[i], &rq);
    }
    *text = buf_text(&rq);
    src = source_new(&s->session.arena, "random.rq", buf_text(&rq), rq.n);
    q = session_requirements(&s->session, &src, 1, run.p);
    if (!q) {
        Buf why;
        const DiagStyle style = {false, 3};
        buf_init(&why, arena);
        diags_render_text(&s->session.diags, &style, &why);
        return buf_text(&why);
    }
    wrong = compare(&m, q, demand);
    return wrong ? wrong : compare_alone(&m, q);
}

// Whether every kind of requirement has had every result, and the rest of the test has run.
static bool was_thorough(uint64_t count)
{
    bool good = met.programs * 10 >= count * 9 && met.undecided > 0 && met.copies > 0 && met.smaller > count / 2;

    for (int kind = 0; kind <= REQUIREMENT_LEADS_TO; kind++)
        for (int result = kind == REQUIREMENT_NEVER ? MONITOR_JUDGED : MONITOR_IDLE; result <= MONITOR_VIOLATED; result++)
            if (met.result[kind][result] < count / 20) {
                printf("kind %d has had result %d only %" PRIu64 " times\n", kind, result, met.result[kind][result]);
                good = false;
            }
    return good;
}

int main(int argc, char **argv)
{
    const uint64_t seed = argc > 1 ? strtoull(argv[1], NULL, 10) : 1, count = argc > 2 ? strtoull(argv[2], NULL, 10) : 1000;
    uint64_t passed = 0, failed = 0;

    for (uint64_t i = seed; i < seed + count; i++) {
        Arena arena;
        Subject s;
        const char *wrong, *text;

        diff_arena_init(&arena);
        wrong = test_program(i, &arena, &s, &text);
        passed += !wrong;
        failed += wrong != NULL;
        if (wrong || argc > 3)
            printf("seed %" PRIu64 ": %s\n%s", i, wrong ? wrong : "passed", text);
        subject_free(&s);
        arena_free(&arena);
    }
    if (!was_thorough(count))
        failed++;
    printf("%" PRIu64 " passed, %" PRIu64 " failed\n", passed, failed);
    return failed > 0;
}
