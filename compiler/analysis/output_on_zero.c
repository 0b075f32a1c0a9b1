// SPDX-License-Identifier: Apache-2.0
// Outputs that go on because a sensor reads 0, which is what a broken one reads: `pressure < 5: heater = true`, or, where Heat
// switches it on when it begins, `pressure < 5: -> Heat`.
//
// A store is looked at with what has to hold for it, cut into parts that all must hold.  One part holds because the sensor reads 0
// and would not hold of every reading; no part is left to another sensor; and with that reading a run does come to the store
// and ends with the output on.  Who answers a broken sensor on purpose is no case: where that part holds of a reading far above
// and of one far below too, or of none within the @range, or where the machine goes to an @abort state.
#include "compiler/analysis/abort.h"
#include "compiler/analysis/dead_sensor.h"
#include "compiler/analysis/outputs.h"
#include "stdlib/math.h"

enum {
    PARTS = 32,                   // of the innermost guards
    FLOWS = 50                    // sensors asked about in one block
};

typedef struct Part {
    const Expr *e;
    bool holds;
    bool passed;                  // it is that an earlier branch of an `else if` was not taken: whether it was is up to the run
} Part;

typedef struct Parts {
    Part at[PARTS];
    size_t n;
} Parts;

typedef struct Flowed {           // how a block runs when the sensor reads 0
    const IrFn *f;                // NULL: not asked
    const State *state;
    BlockKind block;
    const Env *end;               // what holds at all its ends
    bool ends;
} Flowed;

typedef struct Zero {
    Analysis *a;
    const Sensors *s;
    DeadSensor dead;              // reads 0
    DeadSensor high, low, healthy;    // reads something far above or far below; something within its @range
    AbortBound bound;
    Stores *ask;                  // by Var.index: stores that a sensor may bring about
    bool *aborts;                 // by arm: a transition to an @abort state stands in it
    uint32_t *reached;            // by Stmt.number: the flow that came to it last
    uint32_t flow;                // its number
    uint8_t (*flows)[BLOCK_COUNT];    // by state
    size_t *first;                // by state: its first transition in the list of all
    Flowed last;
    const State *settled;         // the state that the following are of
    const Env *zero, *far_above, *far_below, *in_range;
} Zero;

// ---- what has to hold ----

static void add_part(Parts *p, Part part)
{
    const Expr *e = part.e;

    if (e->kind == EX_UNARY && e->op == SM_OP_NOT) {
        add_part(p, (Part){e->arg[0], !part.holds, part.passed});
    } else if (e->kind == EX_BINARY && e->op == (part.holds ? SM_OP_AND : SM_OP_OR)) {
        add_part(p, (Part){e->arg[0], part.holds, part.passed});
        add_part(p, (Part){e->arg[1], part.holds, part.passed});
    } else if (p->n < PARTS) {
        p->at[p->n++] = part;
    }
}

static bool is_passed(const Condition *c)
{
    return !c->holds && c->stmt->otherwise.n == 1 && c->stmt->otherwise.at[0]->kind == ST_IF;
}

// A flag that is assigned a condition goes on when it holds.
static bool is_guarded_by_value(const StmtPlace *at)
{
    return at->stmt->kind == ST_ASSIGN && at->stmt->var->type == SM_BOOL && !expr_is_constant(at->stmt->value);
}

static Parts parts_of(const StmtPlace *at)
{
    Parts p = {{{NULL, false, false}}, 0};

    if (is_guarded_by_value(at))
        add_part(&p, (Part){at->stmt->value, true, false});
    for (const Condition *when = at->when; when && p.n < PARTS; when = when->outer)
        add_part(&p, (Part){when->stmt->value, when->holds, is_passed(when)});
    return p;
}

// ---- what holds ----

static Fact truth(const Analysis *a, const Env *env, const Part *p)
{
    const Fact f = fact_convert(suppose_value(a, env, p->e), SM_BOOL);

    return p->holds ? f : fact_of_bool(f.hi == 1, f.lo == 0);
}

static bool is_sure(Fact truth) { return truth.lo == 1; }

static bool wants_another(const Zero *z, const Part *p, const Var *sensor)
{
    const Looks l = looks_of_value(z->s, p->e);

    return l.more || l.n > (looks_at(&l, sensor) ? 1u : 0u);
}

// The part that holds because the sensor reads 0; NULL if there is none, or something is left to another sensor.
static const Part *part_because(const Zero *z, const Parts *p, const Var *sensor)
{
    const Part *because = NULL;

    for (size_t i = 0; i < p->n; i++) {
        const Part *part = &p->at[i];
        if (part->passed)
            continue;
        if (!is_sure(truth(&z->dead.what, z->zero, part))) {
            if (wants_another(z, part, sensor))
                return NULL;
        } else if (!because && !is_sure(truth(z->a, z->a->facts->constants, part))) {
            because = part;
        }
    }
    return because;
}

static bool goes_on(const Zero *z, const StmtPlace *at)
{
    const Fact f = fact_convert(suppose_stored(&z->dead.what, z->zero, at->stmt), at->stmt->var->type);

    return is_guarded_by_value(at) ? f.hi == 1 : f.lo > 0 || f.hi < 0;
}

// ---- answers on purpose ----

static size_t arm_of(const Condition *c) { return 2u * c->stmt->number + c->holds; }

static Fact far_off(const Var *v, bool above)
{
    const Fact type = fact_of_type(v->type);

    return fact_of_number(above ? sm_min(type.hi, 1e30) : sm_max(type.lo, -1e30));
}

static bool is_test_of_reading(const Zero *z, const Part *p, const Var *sensor)
{
    if (is_sure(truth(&z->high.what, z->far_above, p)) && is_sure(truth(&z->low.what, z->far_below, p)))
        return true;
    return sensor->range && truth(&z->healthy.what, z->in_range, p).hi == 0;
}

static bool is_answer(const Zero *z, const StmtPlace *at, const Part *because, const Var *sensor)
{
    return (at->when && z->aborts[arm_of(at->when)]) || is_test_of_reading(z, because, sensor);
}

// ---- how the block runs ----

static void note_end(void *context, const IrJump *end, const Env *env)
{
    Zero *z = context;

    (void)end;
    z->last.end = z->last.ends ? env_join(&z->dead.what.facts->shape, z->last.end, env, NULL) : env;
    z->last.ends = true;
}

static void note_stores(Zero *z, const IrFn *f, const FactFlow *flow)
{
    z->flow++;
    for (size_t b = 0; b < f->blk.n; b++)
        if (flow->reached[b]) {
            z->reached[f->blk.at[b].jump.stmt] = z->flow;
            for (size_t i = 0; i < f->blk.at[b].ins.n; i++)
                z->reached[f->ins.at[f->blk.at[b].ins.at[i]].stmt] = z->flow;
        }
}

static void run_block(Zero *z, const StmtPlace *at)
{
    const FactEnds ends = {note_end, z};
    FactFlow flow;

    if (z->last.f && z->last.state == at->state && z->last.block == at->block)
        return;
    z->last = (Flowed){z->a->m->state.at[at->state->number - 1u].block[at->block], at->state, at->block, NULL, false};
    z->flows[at->state->number - 1u][at->block]++;
    flow = facts_flow(z->dead.what.facts, z->last.f, dead_sensor_begin(&z->dead, at->state, at->block), &ends);
    note_stores(z, z->last.f, &flow);
}

// The first store behind one; stores stand in file order.
static size_t next_store(const Stores *list, const StmtPlace *at)
{
    size_t first = 0, end = list->n;

    while (first < end) {
        const size_t middle = first + (end - first) / 2;
        if (list->at[middle].stmt->number > at->stmt->number)
            end = middle;
        else
            first = middle + 1;
    }
    return first;
}

// A later store, in the same arm or alone in the block, has the last word.
static bool is_overwritten(const Zero *z, const StmtPlace *at)
{
    const Stores *list = &z->s->stores[at->stmt->var->index];

    for (size_t i = next_store(list, at); i < list->n; i++) {
        const StmtPlace *later = &list->at[i];
        if (later->state != at->state || later->block != at->block)
            return false;
        if (!later->when || (at->when && arm_of(later->when) == arm_of(at->when)))
            return true;
    }
    return false;
}

static bool ends_on(Zero *z, const StmtPlace *at)
{
    Fact f;

    if (is_overwritten(z, at) || z->flows[at->state->number - 1u][at->block] > FLOWS)
        return false;
    run_block(z, at);
    f = env_get(&z->dead.what.facts->shape, z->last.end, z->a->m->var_of[at->stmt->var->index]);
    return z->reached[at->stmt->number] == z->flow && (f.lo < 0 || f.hi > 0);
}

// ---- transitions ----

static const Stmt *first_switched_on(const Zero *z, const Stmts *stmts)
{
    for (size_t i = 0; i < stmts->n; i++) {
        const Stmt *s = stmts->at[i];
        if (s->kind == ST_ASSIGN && is_output(s->var) && z->a->stmt[s->number].reached && is_on(z->a->stmt[s->number].value))
            return s;
    }
    return NULL;
}

// What the state switches on when it begins, and was not on before; NULL: nothing.
static const Stmt *begun_by(const Zero *z, const StmtPlace *at)
{
    const Stmt *on = first_switched_on(z, &at->stmt->target->block[BLOCK_ENTRY]);

    for (int b = BLOCK_ENTRY; on && b <= BLOCK_STEP; b++)
        if (outputs_switch(z->a, &at->state->block[b], on->var, true))
            return NULL;
    return on;
}

// Whether the same state is gone to without a sensor too, by time or by command: then it goes on anyway.
static bool goes_anyway(const Zero *z, const StmtPlace *at)
{
    for (size_t t = z->first[at->state->number - 1u]; t < z->first[at->state->number]; t++) {
        const Transition *other = &z->a->transition.at[t];
        const Looks l = looks_of_condition(z->s, other->when);
        if (other->to == at->stmt->target && l.n == 0 && !l.more)
            return true;
    }
    return false;
}

static bool is_made(Zero *z, const StmtPlace *at)
{
    if (z->flows[at->state->number - 1u][at->block] > FLOWS || goes_anyway(z, at))
        return false;
    run_block(z, at);
    return z->reached[at->stmt->number] == z->flow;
}

// ---- findings ----

static void settle(Zero *z, const State *state, const Var *sensor)
{
    if (z->settled == state)
        return;
    z->settled = state;
    z->zero = dead_sensor_settled(&z->dead, state);
    z->far_above = dead_sensor_settled(&z->high, state);
    z->far_below = dead_sensor_settled(&z->low, state);
    if (sensor->range)
        z->in_range = dead_sensor_settled(&z->healthy, state);
}

// From the sensor to the output, in order; a part that reads the sensor itself needs no steps.
static void report(Zero *z, const StmtPlace *at, const Stmt *on, const Var *sensor, const Part *because)
{
    const char *name = sensor->name->text;
    const DiagCode text = because->holds ? DIAG_note_holds_at_zero : DIAG_note_fails_at_zero;
    const Stmt *store = looks_through(z->s, because->e, sensor);
    Diag *d = diag_report(z->a->diags, DIAG_output_on_zero, at->stmt->span, on->var->name->text, name);

    if (store) {
        diag_step(z->a->diags, d, store->span, DIAG_note_made_of_sensor, store->var->name->text, name);
        diag_step(z->a->diags, d, because->e->span, text, name);
    } else {
        diag_note(z->a->diags, d, because->e->span, text, name);
    }
    if (on != at->stmt)
        diag_note(z->a->diags, d, on->span, DIAG_note_switched_on, on->var->name->text);
    diag_note(z->a->diags, d, (Span){0}, DIAG_note_zero_advice, name);
}

static void ask(Zero *z, const StmtPlace *at, const Var *sensor)
{
    const Parts parts = parts_of(at);
    const bool moves = at->stmt->kind == ST_TRANSITION;
    const Stmt *on = moves ? begun_by(z, at) : at->stmt;
    const Part *because;

    settle(z, at->state, sensor);
    because = on ? part_because(z, &parts, sensor) : NULL;
    if (because && !is_answer(z, at, because, sensor) && (moves ? is_made(z, at) : goes_on(z, at) && ends_on(z, at)))
        report(z, at, on, sensor, because);
}

static void suppose_readings(Zero *z, const Var *sensor)
{
    dead_sensor_reads(&z->dead, sensor, fact_of_number(sm_from_i32(0)));
    dead_sensor_reads(&z->high, sensor, far_off(sensor, true));
    dead_sensor_reads(&z->low, sensor, far_off(sensor, false));
    if (sensor->range)
        dead_sensor_reads(&z->healthy, sensor, fact_of_range(sensor->range->lo, sensor->range->hi));
}

static void ask_about(Zero *z, const Var *sensor)
{
    const Stores *list = &z->ask[sensor->index];

    if (list->n == 0)
        return;
    z->last.f = NULL;
    z->settled = NULL;
    suppose_readings(z, sensor);
    for (size_t i = 0; i < list->n; i++)
        ask(z, &list->at[i], sensor);
}

static void note_store(Zero *z, const StmtPlace *at)
{
    const Looks l = is_guarded_by_value(at) ? looks_of_value(z->s, at->stmt->value) : looks_of_condition(z->s, at->when);

    for (uint32_t i = 0; i < l.n; i++)
        vec_push(z->a->arena, &z->ask[l.sensor[i]->index], *at);
}

static void note_place(const StmtPlace *at, void *context)
{
    Zero *z = context;

    if (!z->a->stmt[at->stmt->number].reached)
        return;
    if (at->stmt->kind == ST_ASSIGN && is_output(at->stmt->var))
        note_store(z, at);
    if (at->stmt->kind != ST_TRANSITION || !at->when)
        return;
    if (z->bound.bound[at->stmt->target->number - 1u])
        z->aborts[arm_of(at->when)] = true;
    else
        note_store(z, at);
}

void analyse_output_on_zero(Analysis *a)
{
    const Sensors *s = sensors_of(a);
    const size_t n = a->p->var.n;
    Zero z = {.a = a, .s = s, .bound = abort_bound(a), .dead = dead_sensor_new(s), .high = dead_sensor_new(s),
              .low = dead_sensor_new(s), .healthy = dead_sensor_new(s)};

    z.ask = ARENA_ARRAY(a->arena, Stores, n);
    z.aborts = ARENA_ARRAY(a->arena, bool, 2 * (a->p->stmts + 1u));
    z.first = transitions_by_state(a->arena, a->p, &a->transition);
    z.reached = ARENA_ARRAY(a->arena, uint32_t, a->p->stmts + 1u);
    z.flows = arena_array(a->arena, a->p->state.n, sizeof *z.flows);
    each_place(a->arena, a->p, note_place, &z);
    for (size_t v = 0; v < n; v++)
        ask_about(&z, a->p->var.at[v]);
}
