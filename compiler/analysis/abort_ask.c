// SPDX-License-Identifier: Apache-2.0
// What the ability to abort hangs on.  Of each state only those sensors can be the one that it hangs on that every way to an @abort
// state looks at: another way is left whatever they read.  But any that a way looks at may, when it reads 0, make another transition
// before that way's turn comes.  Questions are sorted by sensor, since what a dead one does to windows and locals is the
// same for all states.
#include "compiler/analysis/abort.h"
#include "compiler/analysis/dead_sensor.h"

enum {
    CONSTANTS = 12,               // numbers in a state's guards from which values to stick at are made
    CANDIDATES = 2 * CONSTANTS + 4,
    ENOUGH = 50000                // stores and samples looked at: after that no sensor is supposed to stick
};

typedef enum Reading { READS_0, READS_ABOVE, READS_BELOW, READINGS } Reading;

typedef VEC(AbortRow *) Rows;

typedef struct Asking {
    Analysis *a;
    const AbortBound *b;
    const Sensors *s;
    DeadSensor dead;
    Rows *ask, *watch;            // by Var.index: the rows all of whose ways, any of whose ways look at that sensor
    unsigned *no_way;             // by state: of the sensor being asked about, the readings that leave no way
    const Transition **instead;   // by state: of that sensor, the first transition it makes when no way is left
    bool fires;                   // what a flow has found out: a way can be made
    VEC(uint32_t) others;         // and these other transitions, by Stmt.number
} Asking;

static size_t at(const State *s) { return s->number - 1u; }

// ---- what ways look at ----

static void note_looks(Asking *k, AbortWay *w)
{
    const Looks l = looks_of_condition(k->s, w->first->when);

    w->sensor = ARENA_ARRAY(k->a->arena, const Var *, l.n + 1);
    for (; w->sensors < l.n; w->sensors++)
        w->sensor[w->sensors] = l.sensor[w->sensors];
    w->by_time = l.time;
    w->by_input = l.input;
}

static bool all_look_at(const AbortRow *r, const Var *v)
{
    for (size_t w = 0; w < r->way.n; w++) {
        bool looks = !abort_is_sure(&r->way.at[w]);
        for (size_t i = 0; i < r->way.at[w].sensors; i++)
            looks |= r->way.at[w].sensor[i] == v;
        if (!looks)
            return false;
    }
    return true;
}

static const AbortWay *first_sure(const AbortRow *r)
{
    for (size_t w = 0; w < r->way.n; w++)
        if (abort_is_sure(&r->way.at[w]))
            return &r->way.at[w];
    return NULL;
}

static void note_watched(Asking *k, AbortRow *r, const AbortWay *w)
{
    for (size_t i = 0; i < w->sensors; i++) {
        Rows *rows = &k->watch[w->sensor[i]->index];
        if (rows->n == 0 || rows->at[rows->n - 1] != r)
            vec_push(k->a->arena, rows, r);
    }
}

static void look_at_row(Asking *k, AbortRow *r)
{
    const AbortWay *first;

    for (size_t w = 0; w < r->way.n; w++) {
        note_looks(k, &r->way.at[w]);
        note_watched(k, r, &r->way.at[w]);
    }
    first = first_sure(r);
    for (size_t i = 0; first && i < first->sensors; i++)
        if (all_look_at(r, first->sensor[i]))
            vec_push(k->a->arena, &k->ask[first->sensor[i]->index], r);
}

// ---- one question: whether a way can still be made ----

static void note_end(void *context, const IrJump *end, const Env *env)
{
    Asking *k = context;

    (void)env;
    if (end->kind != IR_GOTO)
        return;
    if (k->b->bound[end->state - 1u] && k->b->steps[end->state - 1u] != ABORT_NOT_BOUNDED)
        k->fires = true;
    else
        vec_push(k->a->arena, &k->others, end->stmt);
}

static bool can_abort(Asking *k, const State *s)
{
    const FactEnds ends = {note_end, k};

    k->fires = false;
    k->others.n = 0;
    for (int b = BLOCK_ENTRY; b <= BLOCK_STEP && !k->fires; b++) {
        const IrFn *f = k->a->m->state.at[at(s)].block[b];
        if (f && facts_reach(k->a->facts, at(s), b))
            facts_flow(k->dead.what.facts, f, dead_sensor_begin(&k->dead, s, (BlockKind)b), &ends);
    }
    return k->fires;
}

// ---- a sensor that reads 0 or leaves its range ----

static bool reading_of(const Var *v, Reading reading, Fact *f)
{
    const Fact type = fact_of_type(v->type);

    *f = type;
    switch (reading) {
    case READS_0: *f = fact_of_number(sm_from_i32(0)); return true;
    case READS_ABOVE: f->lo = v->range ? fact_above(type, v->range->hi) : 0; return v->range && f->lo <= type.hi;
    case READS_BELOW: f->hi = v->range ? fact_below(type, v->range->lo) : 0; return v->range && f->hi >= type.lo;
    case READINGS: break;
    }
    return false;
}

static bool was_made(const Asking *k, const Transition *t)
{
    for (size_t i = 0; i < k->others.n; i++)
        if (k->others.at[i] == t->stmt->number)
            return true;
    return false;
}

// Where a way looks at other things too, it is this transition that comes before its turn.
static const Transition *made_instead(const Asking *k, const AbortRow *r, const Var *v)
{
    for (size_t i = 0; i < k->a->transition.n && !all_look_at(r, v); i++) {
        const Transition *t = &k->a->transition.at[i];
        if (t->from == r->state && was_made(k, t) && condition_on(k->s, t->when, v))
            return t;
    }
    return NULL;
}

static void ask_reading(Asking *k, const Var *v, Reading reading)
{
    const Rows *rows = reading == READS_0 ? &k->watch[v->index] : &k->ask[v->index];
    Fact f;

    if (!reading_of(v, reading, &f))
        return;
    dead_sensor_reads(&k->dead, v, f);
    for (size_t i = 0; i < rows->n; i++) {
        const size_t s = at(rows->at[i]->state);
        if (can_abort(k, rows->at[i]->state))
            continue;
        k->no_way[s] |= 1u << reading;
        if (!k->instead[s])
            k->instead[s] = made_instead(k, rows->at[i], v);
    }
}

static bool is_outside(const Var *v, Reading reading)
{
    Fact f;

    return reading_of(v, reading, &f) && f.lo <= 0 && f.hi >= 0;
}

// What a reading includes is not said twice.
static const char *text_of(Asking *k, const Var *v, unsigned no_way)
{
    const bool above = no_way >> READS_ABOVE & 1, below = no_way >> READS_BELOW & 1;
    const bool zero = (no_way >> READS_0 & 1) && !(above && is_outside(v, READS_ABOVE)) && !(below && is_outside(v, READS_BELOW));
    Buf out;

    buf_init(&out, k->a->arena);
    buf_str(&out, zero ? "0" : "");
    if (below)
        buf_printf(&out, "%sless than %s", zero ? " or " : "", const_text(k->a->arena, v->range->lo));
    if (above)
        buf_printf(&out, "%smore than %s", zero || below ? " or " : "", const_text(k->a->arena, v->range->hi));
    return buf_text(&out);
}

static void ask_blind(Asking *k, const Var *v)
{
    const Rows *rows = &k->watch[v->index];

    for (size_t i = 0; i < rows->n; i++) {
        k->no_way[at(rows->at[i]->state)] = 0;
        k->instead[at(rows->at[i]->state)] = NULL;
    }
    for (int reading = 0; reading < READINGS; reading++)
        ask_reading(k, v, (Reading)reading);
    for (size_t i = 0; i < rows->n; i++) {
        AbortRow *r = rows->at[i];
        if (r->blind || k->no_way[at(r->state)] == 0)
            continue;
        r->blind = v;
        r->blind_at = text_of(k, v, k->no_way[at(r->state)]);
        r->instead = k->instead[at(r->state)];
    }
}

// ---- a sensor that sticks ----

typedef struct Constants {
    const Sensors *s;
    double at[CONSTANTS];         // in order
    size_t n;
} Constants;

static void add_constant(Constants *c, double x)
{
    size_t i = c->n;

    if (!(x > -FACT_EXACT && x < FACT_EXACT) || c->n == CONSTANTS)
        return;
    for (size_t k = 0; k < c->n; k++)
        if (c->at[k] == x)
            return;
    for (; i > 0 && c->at[i - 1] > x; i--)
        c->at[i] = c->at[i - 1];
    c->at[i] = x;
    c->n++;
}

static void note_constant(Expr *e, void *context)
{
    if (expr_is_constant(e))
        add_constant(context, const_eval(e));
}

// What a guard compares a local with says less than what the local is made of.
static void note_constants(Expr *e, void *context)
{
    Constants *c = context;
    const Stores *stores = &c->s->stores[e->kind == EX_VAR ? e->var->index : 0];

    note_constant(e, c);
    if (e->kind != EX_VAR || e->var->kind != VAR_LOCAL)
        return;
    for (size_t i = 0; i < stores->n && i < CONSTANTS; i++) {
        expr_walk(stores->at[i].stmt->value, note_constant, c);
        for (const Condition *when = stores->at[i].when; when && c->n < CONSTANTS; when = when->outer)
            expr_walk(when->stmt->value, note_constant, c);
    }
}

static Constants constants_of(const Asking *k, const AbortRow *r)
{
    Constants c = {k->s, {0}, 0};

    for (size_t w = 0; w < r->way.n; w++)
        for (const Condition *when = r->way.at[w].first->when; when && c.n < CONSTANTS; when = when->outer)
            expr_walk(when->stmt->value, note_constants, &c);
    return c;
}

typedef struct Candidates { double at[CANDIDATES]; size_t n; } Candidates;

// A value that the sensor can have while it is healthy.
static void add_candidate(Candidates *out, const Var *v, double x)
{
    const Fact f = fact_convert(fact_of_number(x), v->type);

    if (!v->range || (f.lo >= v->range->lo && f.lo <= v->range->hi))
        out->at[out->n++] = f.lo;
}

// Between the numbers that guards compare with, beyond them, and these numbers themselves.
static Candidates candidates_of(const Constants *c, const Var *v)
{
    Candidates out = {{0}, 0};

    if (v->range)
        add_candidate(&out, v, v->range->lo + (v->range->hi - v->range->lo) / 2);
    for (size_t i = 1; i < c->n; i++)
        add_candidate(&out, v, c->at[i - 1] + (c->at[i] - c->at[i - 1]) / 2);
    if (c->n > 0) {
        add_candidate(&out, v, c->at[0] - 1);
        add_candidate(&out, v, c->at[c->n - 1] + 1);
    }
    for (size_t i = 0; i < c->n; i++)
        add_candidate(&out, v, c->at[i]);
    add_candidate(&out, v, 0);
    return out;
}

// Rows that ask about one value after the other ask one question.
static bool no_way_at(Asking *k, const AbortRow *r, const Var *v, double x)
{
    if (k->dead.sensor != v || k->dead.reads.lo != x || k->dead.reads.hi != x)
        dead_sensor_reads(&k->dead, v, fact_of_number(x));
    return !can_abort(k, r->state);
}

static void ask_stuck(Asking *k, AbortRow *r, const Var *v, double x)
{
    if (r->single || k->dead.work > ENOUGH || !no_way_at(k, r, v, x))
        return;
    r->single = v;
    r->stuck = x;
}

static void ask_single(Asking *k, const Var *v)
{
    const Rows *rows = &k->ask[v->index];
    Candidates *c = ARENA_ARRAY(k->a->arena, Candidates, rows->n);

    for (size_t i = 0; i < rows->n; i++) {
        const Constants constants = constants_of(k, rows->at[i]);
        c[i] = candidates_of(&constants, v);
    }
    for (size_t n = 0; n < CANDIDATES; n++)
        for (size_t i = 0; i < rows->n; i++)
            if (n < c[i].n)
                ask_stuck(k, rows->at[i], v, c[i].at[n]);
}

// ---- the whole ----

static void ask_about(Asking *k, const Var *v)
{
    if (k->watch[v->index].n > 0)
        ask_blind(k, v);
    if (k->ask[v->index].n > 0)
        ask_single(k, v);
}

void abort_ask(Analysis *a, AbortMatrix *x, const AbortBound *b)
{
    const Sensors *sensors = sensors_of(a);
    Asking k = {a, b, sensors, dead_sensor_new(sensors), ARENA_ARRAY(a->arena, Rows, a->p->var.n),
                ARENA_ARRAY(a->arena, Rows, a->p->var.n), ARENA_ARRAY(a->arena, unsigned, x->n),
                ARENA_ARRAY(a->arena, const Transition *, x->n), false, {0}};

    x->sensors = sensors;
    for (size_t s = 0; s < x->n; s++)
        look_at_row(&k, &x->row[s]);
    for (size_t v = 0; v < a->p->var.n; v++)
        ask_about(&k, a->p->var.at[v]);
}
