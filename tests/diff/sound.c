// SPDX-License-Identifier: Apache-2.0
// Runs the program with the reference's arithmetic and windows, and checks the claims of facts and findings at every point: about variables at
// the start of a function and at a guard, about stored values, about code that is never executed, and about states that are never reached.
#include "tests/diff/sound.h"

#include <stdio.h>
#include <string.h>

#include "compiler/analysis/analysis.h"
#include "compiler/script/ref.h"
#include "stdlib/convert.h"
#include "stdlib/math.h"
#include "tests/diff/watch.h"

typedef struct Claim { uint32_t var; Fact fact; } Claim;         // the variable: index in Program.var
typedef VEC(Claim) Claims;

typedef struct Never {                // the findings that claim what a statement never does
    bool at_all, then, otherwise;
} Never;

typedef struct Sound {
    Arena *arena;
    Analysis a;
    const Program *p;
    uint64_t *cell;
    RefWindows windows;
    const State *state;
    bool is_first, has_run;
    uint64_t last_g, start;
    Claims (*begin)[BLOCK_COUNT];     // by state
    Claims *at;                       // by Stmt.number: where a guard is evaluated or a transition is made
    Never *never;                     // by Stmt.number
    bool *no_state, (*no_block)[BLOCK_COUNT];
    const char *wrong;
} Sound;

static void wrong(Sound *r, const char *what, Span span)
{
    if (r->wrong)
        return;
    r->wrong = format_in(r->arena, "%s: '%.*s' in state '%s'", what, span.src ? (int)(span.len < 60 ? span.len : 60) : 0,
                         span.src ? span.src->text + span.at : "", r->state->name->text);
}

// ---- facts ----

static bool is_within(Fact f, double x)
{
    if (x != x)
        return f.nan;
    return x >= f.lo && x <= f.hi && (!f.whole || sm_trunc(x) == x) && (!f.f32 || sm_from_f32(sm_round_f32(x)) == x) &&
           (x != 0 || sm_bits(x) == 0 || f.minus_zero);
}

static void check_claims(Sound *r, const Claims *c, Span span)
{
    for (size_t i = 0; i < c->n && !r->wrong; i++) {
        const Var *v = r->p->var.at[c->at[i].var];
        const double x = ref_read(v->type, r->cell[v->index]);
        if (!is_within(c->at[i].fact, x))
            wrong(r, format_in(r->arena, "%s is %.17g, said to be from %.17g to %.17g", v->name->text, x, c->at[i].fact.lo, c->at[i].fact.hi), span);
    }
}

static void check_value(Sound *r, const Stmt *s, double x)
{
    const Fact f = r->a.stmt[s->number].value;

    if (!is_within(f, x))
        wrong(r, format_in(r->arena, "%.17g is stored, said to be from %.17g to %.17g%s", x, f.lo, f.hi, f.whole ? ", whole" : ""), s->span);
}

static void check_executed(Sound *r, const Stmt *s)
{
    if (!r->a.stmt[s->number].reached)
        wrong(r, "a statement is executed that facts do not reach", s->span);
    if (r->never[s->number].at_all)
        wrong(r, "a statement is executed that a finding calls dead", s->span);
    check_claims(r, &r->at[s->number], s->span);
}

static void check_way(Sound *r, const Stmt *s, bool holds)
{
    const StmtFact *f = &r->a.stmt[s->number];
    const Never *n = &r->never[s->number];

    if (holds ? !f->then : !f->otherwise)
        wrong(r, holds ? "a guard holds that facts exclude" : "a guard does not hold that facts say holds", s->span);
    if (!is_within(f->value, holds))
        wrong(r, "a guard's value is against facts", s->span);
    if (holds ? n->then : n->otherwise)
        wrong(r, holds ? "a guard holds of which a finding says never" : "a guard does not hold of which a finding says always", s->span);
}

// ---- a step ----

static const State *execute(Sound *r, const Stmts *list)
{
    for (size_t i = 0; i < list->n && !r->wrong; i++) {
        const Stmt *s = list->at[i];
        const State *target = NULL;
        check_executed(r, s);
        if (s->kind == ST_TRANSITION)
            return s->target;
        const double x = ref_eval(s->value, r->cell, &r->windows);
        if (s->kind == ST_ASSIGN) {
            check_value(r, s, x);
            r->cell[s->var->index] = ref_convert(s->var->type, x);
        } else {
            check_way(r, s, ref_true(x));
            target = execute(r, ref_true(x) ? &s->then : &s->otherwise);
        }
        if (target)
            return target;
    }
    return NULL;
}

static const State *run_block(Sound *r, BlockKind b)
{
    const size_t s = r->state->number - 1;

    if (!facts_may_reach(r->a.facts, s, b))
        wrong(r, "a block runs that facts do not reach", r->state->span);
    if (r->no_block[s][b])
        wrong(r, "a block runs that a finding calls dead", r->state->block_span[b]);
    check_claims(r, &r->begin[s][b], r->state->span);
    return execute(r, &r->state->block[b]);
}

static void run_state(Sound *r, bool first)
{
    const State *target = NULL;

    if (r->no_state[r->state->number - 1])
        wrong(r, "the machine is where a finding says that it cannot be", r->state->span);
    if (first)
        target = run_block(r, BLOCK_ENTRY);
    if (!target)
        target = run_block(r, BLOCK_STEP);
    if (!target)
        return;
    run_block(r, BLOCK_EXIT);
    r->state = target;
    r->is_first = true;
}

static bool step(Sound *r, Met *met)
{
    const uint64_t g = r->cell[r->p->g->index];
    const bool first = r->is_first, refused = g == UINT64_MAX || (r->has_run && g <= r->last_g);

    met->refused += refused;
    met->refusal |= refused;
    if (refused)
        return true;
    r->has_run = true;
    r->last_g = g;
    r->is_first = false;
    if (first) {
        r->cell[r->p->s->index] = r->state->number;
        r->start = g;
    }
    r->cell[r->p->t->index] = g - r->start;
    ref_windows_sample(&r->windows, r->cell);
    run_state(r, first);
    met->transition |= r->is_first;
    return r->wrong == NULL;
}

static void start(Sound *r)
{
    for (size_t i = 0; i < r->p->var.n; i++)
        r->cell[i] = r->p->var.at[i]->kind == VAR_LOCAL ? r->p->var.at[i]->init : 0;
    ref_windows_clear(&r->windows);
    r->state = r->p->state.at[0];
    r->cell[r->p->s->index] = 1;
    r->is_first = true;
    r->has_run = false;
}

// ---- what is proved before it runs ----

static Claims claims_of(Sound *r, const Env *env)
{
    Claims out = { 0 };

    for (uint32_t v = 0; v < r->p->var.n; v++) {
        const uint32_t var = r->a.m->var_of[v];
        const Claim c = { v, var == IR_NONE ? fact_of_type(r->p->var.at[v]->type) : env_get(&r->a.facts->shape, env, var) };
        if (!fact_equal(c.fact, fact_of_type(r->p->var.at[v]->type)))
            vec_push(r->arena, &out, c);
    }
    return out;
}

static void claim_stmt(const Stmt *s, void *context)
{
    Sound *r = context;

    if (s->kind != ST_ASSIGN && env_of_stmt(&r->a, s))
        r->at[s->number] = claims_of(r, env_of_stmt(&r->a, s));
}

static void claim_all(Sound *r)
{
    for (size_t s = 0; s < r->p->state.n; s++)
        for (int b = 0; b < BLOCK_COUNT; b++)
            if (facts_may_reach(r->a.facts, s, b))
                r->begin[s][b] = claims_of(r, facts_at_begin(r->a.facts, s, b));
    each_stmt(r->p, claim_stmt, r);
}

// ---- findings ----

typedef struct Finding {
    Sound *r;
    const Diag *d;
} Finding;

static void take_of_stmt(const Stmt *s, void *context)
{
    const Finding *f = context;
    Never *n = &f->r->never[s->number];

    switch ((int)f->d->code) {
    case DIAG_shadowed_transition: case DIAG_duplicate_guard: case DIAG_guard_never: case DIAG_guard_contradiction:
        n->then |= s->kind == ST_IF && s->value->span.at == f->d->span.at;
        break;
    case DIAG_guard_always: case DIAG_guard_tautology:
        n->otherwise |= s->kind == ST_IF && s->value->span.at == f->d->span.at;
        break;
    case DIAG_after_transition: case DIAG_dead_code: case DIAG_dead_rest: case DIAG_dead_else:
        n->at_all |= s->span.at == f->d->span.at;
        break;
    }
}

static void take_of_state(Sound *r, const State *s, const Diag *d)
{
    const size_t i = s->number - 1;

    r->no_state[i] |= (d->code == DIAG_unreachable_state || d->code == DIAG_impossible_state) && d->span.at == s->span.at;
    for (size_t n = 0; n < d->notes.n; n++)
        r->no_state[i] |= strncmp(d->notes.at[n].text, "and so state", 12) == 0 && d->notes.at[n].span.at == s->span.at;
    r->no_block[i][BLOCK_STEP] |= d->code == DIAG_dead_step && d->span.at == s->block_span[BLOCK_STEP].at;
    r->no_block[i][BLOCK_EXIT] |= d->code == DIAG_dead_exit && d->span.at == s->block_span[BLOCK_EXIT].at;
}

static void take_findings(Sound *r, const Diags *diags)
{
    for (size_t i = 0; i < diags->list.n; i++) {
        Finding f = { r, diags->list.at[i] };
        each_stmt(r->p, take_of_stmt, &f);
        for (size_t s = 0; s < r->p->state.n; s++)
            take_of_state(r, r->p->state.at[s], f.d);
    }
}

typedef struct Count { const Sound *r; bool impossible, finding; } Count;

static void count_stmt(const Stmt *s, void *context)
{
    Count *c = context;
    const StmtFact *f = &c->r->a.stmt[s->number];
    const Never *n = &c->r->never[s->number];

    c->impossible |= f->reached && s->kind == ST_IF && (!f->then || !f->otherwise);
    c->finding |= n->at_all || n->then || n->otherwise;
}

// ---- the case ----

// The analysis `trials` takes by far the longest, and claims nothing that holds for every input.  Some programs run it to check that it ends.
static bool is_run(const char *analysis, const Gen *g) { return strcmp(analysis, "trials") != 0 || g->seed % 20 == 0; }

static void prepare(Sound *r, Subject *s, const Gen *g, Arena *arena)
{
    Arena *a = &s->session.arena;
    const Program *p = s->program;

    memset(r, 0, sizeof *r);
    r->arena = arena;
    r->p = p;
    r->cell = ARENA_ARRAY(a, uint64_t, p->var.n);
    ref_windows_init(&r->windows, a, &p->window);
    r->begin = arena_array(a, p->state.n, sizeof *r->begin);
    r->at = ARENA_ARRAY(a, Claims, p->stmts + 1u);
    r->never = ARENA_ARRAY(a, Never, p->stmts + 1u);
    r->no_state = ARENA_ARRAY(a, bool, p->state.n);
    r->no_block = arena_array(a, p->state.n, sizeof *r->no_block);
    analysis_begin(&r->a, a, &s->session.diags, p);
    const size_t first = s->session.diags.list.n;
#define ANALYSIS(name, group, sentence) if (is_run(#name, g)) analyse_##name(&r->a);
#include "compiler/analysis/analyses.def"
#undef ANALYSIS
    complete_all_states_findings(&r->a, first);
    claim_all(r);
    take_findings(r, &s->session.diags);
    start(r);
}

static void run_steps(Sound *r, const Subject *s, const Gen *g, RunResult *out)
{
    EngineWrite write[GEN_VARS_MAX];
    uint32_t state;

    for (uint32_t k = 0; k < g->steps && !r->wrong; k++) {
        out->step = k;
        if (gen_restarts(g, k, &state))
            start(r);
        if (g->skip[k])
            continue;
        const uint32_t n = subject_writes(s, g, k, write);
        for (uint32_t i = 0; i < n; i++)
            r->cell[write[i].var] = write[i].cell;
        if (!step(r, &out->met))
            break;
    }
}

RunResult run_sound(Gen *g, Arena *arena)
{
    static Subject s;
    static Sound r;
    RunResult out = { VERDICT_REJECTED, NULL, 0, { 0 } };

    memset(&watch, 0, sizeof watch);
    out.message = subject_compile(&s, g, arena);
    if (out.message == NULL) {
        Count c = { &r, false, false };
        prepare(&r, &s, g, arena);
        run_steps(&r, &s, g, &out);
        each_stmt(s.program, count_stmt, &c);
        out.met.impossible = c.impossible;
        out.met.finding = c.finding;
        out.met.nan = watch.nan > 0;
        out.message = r.wrong;
        out.verdict = r.wrong ? VERDICT_DIFFERENT : VERDICT_SAME;
    }
    subject_free(&s);
    return out;
}
