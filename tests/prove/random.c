// SPDX-License-Identifier: Apache-2.0
// Checks verdicts of smc prove on random machines and random requirements.  No run shares code with the prover's exploration: the monitor judges
// runs of the reference interpreter, and longer ones of a flat machine, which is built from the same IR as the prover's models.
//
//   proved     no random run violates the requirement, all within the assumptions of the verdict, and each step has the invariants
//   vacuous    and no step comes to the premise
//   exhaustive on machines with few inputs, all sequences of some values of the inputs, step by step, as long as they are few
//
// Every third program is one whose variables are maxima, minima and sums of each other (related_text.h), and every third one has windows of
// conditions in several forms (held_text.h).  Parameters have any values in their ranges if the proof does not assume those of the source, inputs
// have values in @range if it assumes that, and runs begin in the state that the prover was given.
//
//     random SEED COUNT [STEPS]
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compiler/cover/flat.h"
#include "compiler/prove/prove.h"
#include "compiler/script/monitor.h"
#include "compiler/search/search.h"
#include "stdlib/convert.h"
#include "tests/diff/subject.h"
#include "tests/prove/held_text.h"
#include "tests/prove/related_text.h"

enum { REQUIREMENTS = 6, DEPTH = 2, RECORDED = 200, POOL = 256, LAYER_MOST = 500, LAYERS = 24, CHOICES_MOST = 27, INTERPRETED_MOST = 256, KINDS = 3, WRITES = 64 };

typedef enum Kind { KIND_RELATED, KIND_HELD, KIND_ANY } Kind;      // of a program: its seed modulo KINDS

typedef struct Test {
    Arena *arena;
    Rng rng;
    const Program *p;
    const IrMachine *m;
    FlatMachine *flat;
    uint64_t delta_t;
    uint32_t init_state;      // State.number
    double pool[POOL];        // values that matter: constants of the program with their neighbours, and extreme ones
    uint32_t pooled;
    const Requirements *q;
    Monitor *monitor;
    uint64_t *cell;           // by Program.var
    bool any_parameters;      // ProveOptions.any_parameters
} Test;

static struct { uint64_t programs, verdict[PROVE_VERDICTS], judged[5], sliced, loose, windows, compared, violations, steps, layers, exhausted, related, with_ranges, with_parameters, settings, interpreted; } met;

// ---- values ----

static void add_value(Test *t, double x)
{
    if (t->pooled < POOL)
        t->pool[t->pooled++] = x;
}

static void add_numbers(Expr *e, void *context)
{
    Test *t = context;

    if (e->kind != EX_NUMBER)
        return;
    add_value(t, e->number);
    add_value(t, e->number + 1);
    add_value(t, e->number - 1);
}

static void add_stmts(Test *t, const Stmts *list)
{
    for (uint32_t i = 0; i < list->n; i++) {
        if (list->at[i]->value)
            expr_walk(list->at[i]->value, add_numbers, t);
        add_stmts(t, &list->at[i]->then);
        add_stmts(t, &list->at[i]->otherwise);
    }
}

static void find_values(Test *t)
{
    static const double always[] = {0, 1, -1, 2, 100, -0.0, 1e9, -1e300, 0.5};

    for (size_t i = 0; i < sizeof always / sizeof *always; i++)
        add_value(t, always[i]);
    add_value(t, 1 / always[0]);
    for (uint32_t v = 0; v < t->p->var.n; v++) {
        const Parameter *p = t->p->var.at[v]->parameter;
        for (int k = -1; p && k <= 1; k++) {
            add_value(t, p->lo + k);
            add_value(t, p->hi + k);
            add_value(t, ref_read(t->p->var.at[v]->type, p->standard) + k);
        }
    }
    for (uint32_t s = 0; s < t->p->state.n; s++)
        for (int b = 0; b < BLOCK_COUNT; b++)
            add_stmts(t, &t->p->state.at[s]->block[b]);
}

static uint64_t any_cell(Test *t, SmType type)
{
    if (rng_percent(&t->rng, 2) && (type == SM_F64 || type == SM_F32))
        return type == SM_F64 ? UINT64_C(0x7ff8000000000000) : 0x7fc00000;       // NaN, which reads as 0
    return sm_cell_from_f64(type, t->pool[rng_below(&t->rng, rng_percent(&t->rng, 30) ? 6 : t->pooled)]);
}

// Returns a value that the assumptions allow an input.
static uint64_t cell_of_input(Test *t, const ProveOf *of, const Var *v)
{
    const uint64_t cell = any_cell(t, v->type);
    const double x = ref_read(v->type, cell);

    if (!(of->assumed >> PROVE_RANGES & 1) || !v->range || (x >= v->range->lo && x <= v->range->hi))
        return cell;
    return sm_cell_from_f64(v->type, rng_percent(&t->rng, 50) ? v->range->lo : v->range->hi);
}

// Returns a value to which a parameter can be set.
static uint64_t cell_of_parameter(Test *t, const Var *v)
{
    const Parameter *p = v->parameter;
    const double x = ref_read(v->type, any_cell(t, v->type));

    if (x > p->lo && x < p->hi)
        return sm_cell_from_f64(v->type, x);
    return rng_percent(&t->rng, 30) ? v->init : sm_cell_from_f64(v->type, rng_percent(&t->rng, 50) ? p->lo : p->hi);
}

// ---- requirements as text ----

// A condition on a rolling window of the machine, which can have the same samples in the requirement.
static void print_window(Test *t, const char *relation, const char *number, Buf *out)
{
    const Window *w = &t->p->window.at[rng_below(&t->rng, t->p->window.n)];
    const bool held = rng_percent(&t->rng, 40);
    const Span span = held ? w->sample->span : w->span;

    buf_str(out, held ? "(held((" : rng_percent(&t->rng, 40) ? "(prev(" : "((");
    buf_put(out, span.src->text + span.at, span.len);
    if (held)
        buf_printf(out, ") %s %s, %lu steps))", relation, number, (unsigned long)(w->size > 1 ? w->size - rng_below(&t->rng, 2) : 1));
    else
        buf_printf(out, ") %s %s)", relation, number);
    met.windows++;
}

static void print_condition(Test *t, unsigned depth, Buf *out)
{
    static const char *const relation[] = {"<", "<=", ">", ">=", "==", "!="};
    const Var *v = t->p->var.at[rng_below(&t->rng, t->p->var.n)];
    const char *number = const_text(t->arena, t->pool[rng_below(&t->rng, t->pooled)]);

    if (strchr(number, 'i') || strchr(number, 'n'))
        number = "7";
    if (depth > 0 && rng_percent(&t->rng, 45)) {
        static const char *const call[] = {"not (", "rising(", "falling(", "held(", "prev("};
        const uint32_t kind = rng_below(&t->rng, 8);
        buf_str(out, kind < 5 ? call[kind] : "(");
        print_condition(t, depth - 1, out);
        if (kind == 3)
            buf_printf(out, ", %u steps", 1 + (unsigned)rng_below(&t->rng, 4));
        if (kind >= 5) {
            buf_str(out, kind == 5 ? " and " : kind == 6 ? " or " : " implies ");
            print_condition(t, depth - 1, out);
        }
        buf_char(out, ')');
        return;
    }
    if (t->p->window.n && rng_percent(&t->rng, 10)) {
        print_window(t, relation[rng_below(&t->rng, 6)], number, out);
        return;
    }
    switch (rng_below(&t->rng, 8)) {
    case 0: buf_printf(out, "(%s)", v->name->text); break;
    case 1: case 2: case 3: buf_printf(out, "(%s == %u)", t->p->s->name->text, 1 + (unsigned)rng_below(&t->rng, t->p->state.n)); break;
    case 4:
        if (rng_percent(&t->rng, 50)) {
            buf_printf(out, "(roll_%s(%s %s %s, %u) == 1)", rng_percent(&t->rng, 50) ? "max" : "min", v->name->text, relation[rng_below(&t->rng, 6)], number,
                       2 + (unsigned)rng_below(&t->rng, 3));
            break;
        }
        buf_printf(out, "(roll_%s(%s, %u) > %s)", rng_percent(&t->rng, 50) ? "max" : "min", v->name->text, 1 + (unsigned)rng_below(&t->rng, 4), number);
        break;
    case 5: buf_printf(out, "(T %s %lu)", relation[rng_below(&t->rng, 6)], (unsigned long)(rng_below(&t->rng, 8) * t->delta_t)); break;
    default: buf_printf(out, "(%s %s %s)", v->name->text, relation[rng_below(&t->rng, 6)], number);
    }
}

// What two conditions on the same samples have in common.
typedef struct Samples { const char *of, *number; uint32_t size; } Samples;

static void print_samples(Test *t, const Samples *s, Buf *out)
{
    static const char *const relation[] = {"<", "<=", ">", ">="};
    const char *r = relation[rng_below(&t->rng, 4)], *prev = rng_percent(&t->rng, 15) ? "prev" : "", *bound = rng_percent(&t->rng, 50) ? "min" : "max";
    const unsigned size = s->size + (rng_percent(&t->rng, 30) ? rng_below(&t->rng, 2) : 0);

    switch (rng_below(&t->rng, 4)) {
    case 0: buf_printf(out, "%s(held(%s %s %s, %u steps))", prev, s->of, r, s->number, size); break;
    case 1: buf_printf(out, "%s(%s %s %s)", prev, s->of, r, s->number); break;
    case 2: buf_printf(out, "(%s(roll_%s(%s, %u)) %s %s)", prev, bound, s->of, size, r, s->number); break;
    default: buf_printf(out, "(roll_%s(%s, %u) %s %s)", bound, s->of, size, r, s->number);
    }
}

// A requirement on the samples of one window, compared in two ways with a number.
static void print_samples_requirement(Test *t, Buf *out)
{
    const Var *v = t->p->var.at[rng_below(&t->rng, t->p->var.n)], *w = t->p->var.at[rng_below(&t->rng, t->p->var.n)];
    const Window *of = t->p->window.n && rng_percent(&t->rng, 60) ? &t->p->window.at[rng_below(&t->rng, t->p->window.n)] : NULL;
    const bool always = rng_percent(&t->rng, 50);
    Samples s = {.number = "1", .size = of ? of->size : 1 + rng_below(&t->rng, 4)};

    s.of = of ? format_in(t->arena, "(%.*s)", (int)of->sample->span.len, of->sample->span.src->text + of->sample->span.at)
         : rng_percent(&t->rng, 70) ? v->name->text : format_in(t->arena, "(%s - %s)", v->name->text, w->name->text);
    if (rng_percent(&t->rng, 50))
        s.number = const_text(t->arena, t->pool[rng_below(&t->rng, t->pooled)]);
    if (strchr(s.number, 'i') || strchr(s.number, 'n'))
        s.number = "0";
    buf_str(out, always ? "always " : "never ");
    print_samples(t, &s, out);
    buf_str(out, always ? " implies " : " and ");
    print_samples(t, &s, out);
    buf_char(out, '\n');
}

// Returns a number that the machine or the requirement computes from variables.
static const char *any_number(Test *t, const Var *v)
{
    const char *name = v->name->text;

    switch (rng_below(&t->rng, 8)) {
    case 0: return format_in(t->arena, "prev(%s)", name);
    case 1: return format_in(t->arena, "roll_median(%s, %u)", name, 2 + (unsigned)rng_below(&t->rng, 3));
    case 2: return format_in(t->arena, "(%s + 1)", name);
    default: return name;
    }
}

// A requirement on two variables, or on a variable and the one of the step before.
static void print_related_requirement(Test *t, Buf *out)
{
    static const char *const relation[] = {"<", "<=", ">", ">=", "==", "!="};
    const Var *v = t->p->var.at[rng_below(&t->rng, t->p->var.n)], *w = rng_percent(&t->rng, 40) ? v : t->p->var.at[rng_below(&t->rng, t->p->var.n)];
    const char *a = any_number(t, v), *b = any_number(t, w), *r = relation[rng_below(&t->rng, 6)];
    const bool always = rng_percent(&t->rng, 50);

    buf_str(out, always ? "always " : "never ");
    if (rng_percent(&t->rng, 50)) {
        print_condition(t, 1, out);
        buf_str(out, always ? " implies " : " and ");
    }
    switch (rng_below(&t->rng, 3)) {
    case 0: buf_printf(out, "abs(%s - %s) %s %u", a, b, r, (unsigned)rng_below(&t->rng, 4)); break;
    case 1: buf_printf(out, "%s - %s %s %u", a, b, r, (unsigned)rng_below(&t->rng, 3)); break;
    default: buf_printf(out, "%s(%s %s %s)", rng_percent(&t->rng, 30) ? "not " : "", a, r, b);
    }
    buf_char(out, '\n');
}

static void print_operand(Test *t, Buf *out)
{
    if (rng_percent(&t->rng, 60))
        buf_str(out, t->p->state.at[rng_below(&t->rng, t->p->state.n)]->name->text);
    else {
        buf_char(out, '(');
        print_condition(t, DEPTH, out);
        buf_char(out, ')');
    }
}

static void print_requirement(Test *t, Buf *out)
{
    switch (rng_below(&t->rng, 7)) {
    case 5: print_samples_requirement(t, out); return;
    case 6: print_related_requirement(t, out); return;
    case 0:
        buf_str(out, "never not (");
        print_condition(t, DEPTH, out);
        buf_str(out, " and ");
        print_condition(t, DEPTH, out);
        buf_str(out, ")\n");
        return;
    case 1:
        buf_str(out, "always ");
        print_condition(t, DEPTH, out);
        buf_str(out, " implies ");
        print_condition(t, DEPTH, out);
        break;
    case 2:
        buf_str(out, "never ");
        print_operand(t, out);
        buf_str(out, " before ");
        print_operand(t, out);
        break;
    case 3:
        buf_str(out, "never ");
        print_operand(t, out);
        buf_str(out, " after ");
        print_operand(t, out);
        buf_str(out, " without ");
        print_operand(t, out);
        break;
    default:
        buf_str(out, "always ");
        print_condition(t, DEPTH, out);
        buf_str(out, " leads to ");
        print_condition(t, DEPTH, out);
        buf_printf(out, " within %lu", (unsigned long)(rng_below(&t->rng, 6) * t->delta_t + rng_below(&t->rng, 3)));
    }
    buf_char(out, '\n');
}

// ---- runs ----

static bool assumes(const ProveOf *of, ProveAssumption a) { return of->assumed >> a & 1; }

static void load_cells(Test *t, void *run)
{
    const uint64_t *flat = flat_cells(t->flat, run);

    for (uint32_t v = 0; v < t->p->var.n; v++)
        t->cell[v] = t->m->var_of[v] == IR_NONE ? t->p->var.at[v]->init : flat[t->m->var_of[v]];
}

static bool is_input(const Test *t, const Var *v) { return v->kind == VAR_ELEMENT && v != t->p->g && v != t->p->s; }

static bool is_premise(const Test *t, const Requirement *r, bool seen)
{
    return r->kind == REQUIREMENT_NEVER || !r->a || (ref_true(ref_eval(r->a, t->cell, &t->monitor->windows)) && (r->kind != REQUIREMENT_AFTER || seen));
}

// Returns what is wrong with a step; NULL: nothing.
static const char *judge(Test *t, const ProveOf *of, void *situation, uint32_t state, bool *seen)
{
    const size_t n = (size_t)(of->what - t->q->at.at);
    const ProveInvariant *i = &of->invariant[state - 1];
    bool premise;

    monitor_step(t->monitor, situation, t->cell);
    if (t->monitor->result[n] == MONITOR_VIOLATED)
        return "is violated";
    premise = is_premise(t, of->what, *seen);
    *seen = *seen || (of->what->b && ref_true(ref_eval(of->what->b, t->cell, &t->monitor->windows)));
    if (premise && of->verdict == PROVE_VACUOUS)
        return "comes to its premise";
    if (!i->reached)
        return "has a step in a state that is never reached";
    for (uint32_t k = 0; k < i->bound.n; k++) {
        const double x = ref_read(i->bound.at[k].var->type, t->cell[i->bound.at[k].var->index]);
        if (!(x >= i->bound.at[k].fact.lo && x <= i->bound.at[k].fact.hi))
            return format_in(t->arena, "has %s = %g in %s", i->bound.at[k].var->name->text, x, i->state->name->text);
    }
    return NULL;
}

// A run on a flat machine, or on the reference interpreter.
typedef struct Run {
    void *flat;               // NULL: on the interpreter
    Engine *engine;
    EngineStep step;          // the result of its last step
    EngineWrite write[WRITES];        // before the next step: `writes` of them
    uint32_t writes;
} Run;

static void begin_run(Test *t, Run *r, bool is_flat)
{
    memset(r, 0, sizeof *r);
    if (is_flat) {
        r->flat = arena_alloc(t->arena, t->flat->size);
        flat_start(t->flat, r->flat, t->init_state);
        return;
    }
    met.interpreted++;
    r->engine = engine_ref_open(t->arena, t->p);
    engine_step_init(&r->step, t->arena, t->p);
    r->engine->init(r->engine, t->init_state, &r->step);
}

static void end_run(Run *r)
{
    if (r->engine)
        r->engine->close(r->engine);
}

static uint32_t state_of_run(const Run *r) { return r->flat ? ((FlatState *)r->flat)->state : r->step.next_state; }

static void set_cell(Test *t, Run *r, const Var *v, uint64_t cell)
{
    if (r->flat)
        flat_cells(t->flat, r->flat)[t->m->var_of[v->index]] = cell;
    else if (r->writes < WRITES)
        r->write[r->writes++] = (EngineWrite){v->index, cell};
}

// Runs a step, and loads the values after it.  Returns false if the engine refuses it.
static bool run_step(Test *t, Run *r)
{
    const uint32_t writes = r->writes;

    met.steps++;
    r->writes = 0;
    if (!r->flat) {
        if (r->engine->step(r->engine, r->write, writes, &r->step) != ENGINE_OK)
            return false;
        memcpy(t->cell, r->step.cell, t->p->var.n * sizeof *t->cell);
        return true;
    }
    if (!flat_step(t->flat, r->flat))
        return false;
    load_cells(t, r->flat);
    return true;
}

// Sets the parameters to any values, if the assumptions allow it.
static void set_parameters(Test *t, const ProveOf *of, Run *r)
{
    for (uint32_t v = 0; v < t->p->var.n && !assumes(of, PROVE_PARAMETERS); v++)
        if (t->p->var.at[v]->parameter && t->m->var_of[v] != IR_NONE)
            set_cell(t, r, t->p->var.at[v], cell_of_parameter(t, t->p->var.at[v]));
}

// Returns the first G of a run: any if the assumptions allow it.
static uint64_t first_time(Test *t, const ProveOf *of)
{
    return assumes(of, PROVE_ZERO_START) || rng_percent(&t->rng, 50) ? 0 : rng_below(&t->rng, 100000);
}

static const char *run_randomly(Test *t, const ProveOf *of, uint64_t steps)
{
    void *situation = arena_alloc(t->arena, t->monitor->size);
    const uint32_t change = 1 + rng_below(&t->rng, 60);
    const bool is_flat = steps > INTERPRETED_MOST;
    uint64_t g = first_time(t, of);
    const char *wrong = NULL;
    bool seen = false;
    Run run;

    monitor_start(t->monitor, situation);
    begin_run(t, &run, is_flat);
    set_parameters(t, of, &run);
    for (uint64_t k = 0; k < steps && !wrong; k++, g += t->delta_t) {
        const uint32_t state = state_of_run(&run);
        for (uint32_t v = 0; v < t->p->var.n; v++) {
            const Var *var = t->p->var.at[v];
            const bool is_kept = var->written && assumes(of, k == 0 ? PROVE_ZERO_START : PROVE_OWN_OUTPUTS);
            if (is_input(t, var) && !is_kept && t->m->var_of[v] != IR_NONE && (k == 0 || rng_percent(&t->rng, change)))
                set_cell(t, &run, var, cell_of_input(t, of, var));
        }
        set_cell(t, &run, t->p->g, g);
        if (!run_step(t, &run))
            wrong = "refuses a step";
        else
            wrong = judge(t, of, situation, state, &seen);
        if (wrong)
            wrong = format_in(t->arena, "%s in step %" PRIu64 " of a run %s", wrong, k + 1, is_flat ? "of the flat machine" : "of the interpreter");
    }
    end_run(&run);
    return wrong;
}

// ---- all runs ----

typedef struct Situation { char *at; bool seen; } Situation;       // the machine, then the monitor

static uint64_t hash_of(const char *at, size_t n)
{
    uint64_t h = UINT64_C(1469598103934665603);

    for (size_t i = 0; i < n; i++)
        h = (h ^ (unsigned char)at[i]) * UINT64_C(1099511628211);
    return h ^ h >> 29;
}

typedef struct Layer { Situation at[LAYER_MOST]; uint32_t n; uint32_t slot[4 * LAYER_MOST]; } Layer;

static bool add_to_layer(Test *t, Layer *to, const char *at, bool seen)
{
    const size_t size = t->flat->size + t->monitor->size;
    uint64_t s = (hash_of(at, size) + seen) % (4 * LAYER_MOST);

    for (; to->slot[s]; s = (s + 1) % (4 * LAYER_MOST))
        if (to->at[to->slot[s] - 1].seen == seen && memcmp(to->at[to->slot[s] - 1].at, at, size) == 0)
            return true;
    if (to->n == LAYER_MOST)
        return false;
    to->at[to->n].at = arena_copy(t->arena, at, size);
    to->at[to->n].seen = seen;
    to->slot[s] = ++to->n;
    return true;
}

// Explores all sequences of three values for each input, as long as the situations of a step are few.  All have the same G, so equal ones are one.
static const char *run_all(Test *t, const ProveOf *of)
{
    const size_t size = t->flat->size + t->monitor->size;
    uint32_t input[3], inputs = 0, choices = 1;
    uint64_t value[3][3];
    Layer *now = arena_alloc(t->arena, sizeof *now), *next = arena_alloc(t->arena, sizeof *next);
    char *work = arena_alloc(t->arena, size);

    for (uint32_t v = 0; v < t->p->var.n; v++) {
        const Var *var = t->p->var.at[v];
        if (!is_input(t, var) || var->written || !var->read)
            continue;
        if (inputs == 3)
            return NULL;
        input[inputs] = t->m->var_of[v];
        for (int k = 0; k < 3; k++)
            value[inputs][k] = cell_of_input(t, of, var);
        inputs++;
        choices *= 3;
    }
    flat_start(t->flat, work, t->init_state);
    for (uint32_t v = 0; v < t->p->var.n && !assumes(of, PROVE_PARAMETERS); v++)
        if (t->p->var.at[v]->parameter && t->m->var_of[v] != IR_NONE)
            flat_cells(t->flat, work)[t->m->var_of[v]] = cell_of_parameter(t, t->p->var.at[v]);
    monitor_start(t->monitor, work + t->flat->size);
    add_to_layer(t, now, work, false);
    for (uint32_t k = 0; k < LAYERS; k++) {
        Layer *swap;
        next->n = 0;
        memset(next->slot, 0, sizeof next->slot);
        for (uint32_t i = 0; i < now->n; i++)
            for (uint32_t c = 0; c < choices; c++) {
                bool seen = now->at[i].seen;
                const char *wrong;
                uint32_t state, of_choice = c;
                memcpy(work, now->at[i].at, size);
                for (uint32_t v = 0; v < inputs; v++, of_choice /= 3)
                    flat_cells(t->flat, work)[input[v]] = value[v][of_choice % 3];
                flat_cells(t->flat, work)[t->m->g] = k * t->delta_t;
                state = ((FlatState *)(void *)work)->state;
                flat_step(t->flat, work);
                met.steps++;
                load_cells(t, work);
                if ((wrong = judge(t, of, work + t->flat->size, state, &seen)) != NULL)
                    return format_in(t->arena, "%s in step %u of all runs", wrong, (unsigned)k + 1);
                if (!add_to_layer(t, next, work, seen))
                    return NULL;
            }
        met.layers++;
        swap = now, now = next, next = swap;
    }
    met.exhausted++;
    return NULL;
}

// ---- violations ----

typedef struct Violation { Test *t; const ProveOf *of; void *situation; uint64_t step; } Violation;

static void judge_violation(void *context, uint64_t step, const EngineStep *result)
{
    Violation *v = context;

    monitor_step(v->t->monitor, v->situation, result->cell);
    if (v->step == 0 && v->t->monitor->result[v->of->what - v->t->q->at.at] == MONITOR_VIOLATED)
        v->step = step;
}

// Whether a scenario violates the requirement in its last step, as a monitor of all requirements judges it.
static bool is_violated(Test *t, const ProveOf *of)
{
    Violation v = {t, of, arena_alloc(t->arena, t->monitor->size), 0};
    Engine *e = engine_ref_open(t->arena, t->p);

    monitor_start(t->monitor, v.situation);
    scenario_run(t->arena, t->p, of->scenario, e, judge_violation, &v);
    e->close(e);
    met.violations++;
    return v.step == of->scenario->steps;
}

// ---- one program ----

// Counts the parameters that a violation sets.  Each has to be set in the first step, to a value of its range, and only if any value was asked for.
static const char *check_settings(const Test *t, const Scenario *s)
{
    bool any = false;

    for (size_t i = 0; i < s->changes; i++) {
        const ScenarioChange *c = &s->change[i];
        const Parameter *p = t->p->var.at[c->var]->parameter;
        if (p && (!t->any_parameters || c->step != 1 || c->kind != SCENARIO_HOLD || !(p->lo <= c->a && c->a <= p->hi)))
            return "sets a parameter that it cannot set so";
        any = any || p;
    }
    met.settings += any;
    return NULL;
}

static bool has_parameter(const Test *t)
{
    for (uint32_t v = 0; v < t->p->var.n; v++)
        if (t->p->var.at[v]->parameter)
            return true;
    return false;
}

static const char *check_verdict(Test *t, const ProveOf *of, uint64_t steps)
{
    const char *wrong = NULL;

    met.verdict[of->verdict]++;
    if (of->verdict == PROVE_VIOLATED && !is_violated(t, of))
        return format_in(t->arena, "%s is violated, but its scenario does not end with that", of->what->id->text);
    if (of->verdict == PROVE_VIOLATED && (wrong = check_settings(t, of->scenario)) != NULL)
        return format_in(t->arena, "the script that violates %s %s", of->what->id->text, wrong);
    if (of->verdict != PROVE_PROVED && of->verdict != PROVE_VACUOUS)
        return NULL;
    if (t->any_parameters && assumes(of, PROVE_PARAMETERS))
        return format_in(t->arena, "%s is proved for one setting of the parameters only", of->what->id->text);
    met.judged[of->what->kind]++;
    met.sliced += of->irrelevant > 0;
    met.loose += of->is_loose;
    met.compared += of->is_compared;
    met.related += of->is_related;
    met.with_ranges += assumes(of, PROVE_RANGES);
    met.with_parameters += has_parameter(t) && !assumes(of, PROVE_PARAMETERS);
    for (uint64_t done = 0, length = 64; !wrong && done < steps; done += length, length = length < steps / 4 ? length * 2 : length)
        wrong = run_randomly(t, of, length);
    if (!wrong)
        wrong = run_all(t, of);
    return wrong ? format_in(t->arena, "%s is %s, but a run %s", of->what->id->text, of->verdict == PROVE_PROVED ? "proved" : "vacuous", wrong) : NULL;
}

// What the text of a program says about its requirements.
typedef struct Text { Kind kind; Related related; Held held; } Text;

static const char *compile_program(Test *t, uint64_t seed, Text *of, Subject *s)
{
    Buf sm;

    if (of->kind == KIND_ANY)
        return subject_compile(s, gen_program(t->arena, seed, 10), t->arena);
    buf_init(&sm, t->arena);
    if (of->kind == KIND_RELATED)
        of->related = related_print_machine(&t->rng, &sm);
    else
        of->held = held_print_machine(&t->rng, &sm);
    return subject_compile_text(s, buf_text(&sm), t->arena);
}

static void print_requirements(Test *t, const Text *of, Buf *out)
{
    for (int i = 0; i < REQUIREMENTS; i++) {
        buf_printf(out, "R%d \"random\" ", i + 1);
        if (of->kind == KIND_RELATED)
            related_print_requirement(&t->rng, &of->related, out);
        else if (of->kind == KIND_HELD)
            held_print_requirement(&t->rng, &of->held, out);
        else
            print_requirement(t, out);
    }
}

static void begin_test(Test *t, Subject *s)
{
    t->p = s->program;
    t->m = ir_build(t->arena, t->p);
    t->flat = flat_new(t->arena, t->m, NULL);
    t->delta_t = t->p->step ? t->p->step : 10;
    t->init_state = rng_percent(&t->rng, 80) ? 1 : 1 + rng_below(&t->rng, t->p->state.n);
    t->cell = ARENA_ARRAY(t->arena, uint64_t, t->p->var.n);
    find_values(t);
}

static const char *text_of_diags(Test *t, Subject *s)
{
    const DiagStyle style = {false, 3};
    Buf why;

    buf_init(&why, t->arena);
    diags_render_text(&s->session.diags, &style, &why);
    return buf_text(&why);
}

static const char *test_program(uint64_t seed, Arena *arena, Subject *s, uint64_t steps, const char **text)
{
    ProveOptions o = {.effort = 5000, .visits = 15000};
    Test t = {.arena = arena, .rng = {rng_mix(seed, 4711)}};
    Text of = {.kind = (Kind)(seed % KINDS)};
    const char *wrong = compile_program(&t, seed, &of, s);
    const Source *src;
    const ProveResult *r;
    Buf rq;

    *text = "";
    if (wrong)
        return wrong;
    begin_test(&t, s);
    o.init_state = t.p->state.at[t.init_state - 1];
    o.assume_ranges = rng_percent(&t.rng, of.kind == KIND_HELD ? 60 : 30);
    o.any_parameters = t.any_parameters = seed / KINDS % 3 == 0;
    buf_init(&rq, arena);
    print_requirements(&t, &of, &rq);
    *text = buf_text(&rq);
    src = source_new(&s->session.arena, "random.rq", buf_text(&rq), rq.n);
    t.q = session_requirements(&s->session, &src, 1, t.p);
    if (!t.q)
        return text_of_diags(&t, s);
    met.programs++;
    t.monitor = monitor_new(arena, t.q, t.delta_t);
    r = prove_run(arena, t.q, &o);
    if (r->bug)
        return r->bug;
    for (uint32_t i = 0; !wrong && i < r->n; i++)
        wrong = check_verdict(&t, &r->of[i], steps);
    return wrong;
}

// Prints what the random programs did not have often enough, and returns how much that is: a campaign that lacks it shows nothing about it.
static uint64_t count_missed_floors(uint64_t programs)
{
    static const struct { const char *what; const uint64_t *n; unsigned least; } floors[] = {       // `least`: in 1000 programs
        {"compiled programs", &met.programs, 900}, {"proved", &met.verdict[PROVE_PROVED], 500}, {"scripts of violations", &met.violations, 1000},
        {"proofs without some variables", &met.sliced, 500}, {"proofs with windows of any value", &met.loose, 50},
        {"proofs with compared samples", &met.compared, 25}, {"proofs with differences", &met.related, 20},
        {"proofs with ranges", &met.with_ranges, 20}, {"proofs of any parameters", &met.with_parameters, 100}, {"violations by set parameters", &met.settings, 5},
        {"interpreted runs", &met.interpreted, 1000},
    };
    uint64_t missed = 0;

    for (size_t i = 0; i < sizeof floors / sizeof *floors; i++)
        if (*floors[i].n * 1000 < programs * floors[i].least) {
            printf("%s: %" PRIu64 ", and %u in 1000 programs are required\n", floors[i].what, *floors[i].n, floors[i].least);
            missed++;
        }
    return missed;
}

int main(int argc, char **argv)
{
    const uint64_t seed = argc > 1 ? strtoull(argv[1], NULL, 10) : 1, count = argc > 2 ? strtoull(argv[2], NULL, 10) : 100;
    const uint64_t steps = argc > 3 ? strtoull(argv[3], NULL, 10) : 3000;
    uint64_t failed = 0;

    for (uint64_t i = seed; i < seed + count; i++) {
        Arena arena;
        Subject s;
        const char *wrong, *text;

        diff_arena_init(&arena);
        wrong = test_program(i, &arena, &s, steps, &text);
        failed += wrong != NULL;
        if (wrong) {
            printf("seed %" PRIu64 ": %s\n%s", i, wrong, text);
            fflush(stdout);
        }
        subject_free(&s);
        arena_free(&arena);
    }
    printf("%" PRIu64 " programs: %" PRIu64 " proved, %" PRIu64 " vacuous, %" PRIu64 " violated, %" PRIu64 " undecided; %" PRIu64 " steps, %" PRIu64 " layers, %" PRIu64
           " explored to the end; %" PRIu64 " proofs without some variables, %" PRIu64 " with windows of any value, %" PRIu64 " windows of machines, %" PRIu64 " with compared samples, %" PRIu64 " with differences, %" PRIu64 " with ranges, %" PRIu64 " of any parameters; %" PRIu64 " violations by set parameters; %" PRIu64 " runs interpreted\n", met.programs, met.verdict[0], met.verdict[1], met.verdict[2], met.verdict[3], met.steps, met.layers, met.exhausted,
           met.sliced, met.loose, met.windows, met.compared, met.related, met.with_ranges, met.with_parameters, met.settings, met.interpreted);
    failed += count_missed_floors(count);
    printf("verdicts on random requirements: %" PRIu64 " passed, %" PRIu64 " failed\n", met.programs, failed);
    return failed > 0;
}
