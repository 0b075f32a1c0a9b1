// SPDX-License-Identifier: Apache-2.0
// Checks what a watch records in runs of random machines: the truth of each guard against the branch that the step executed, and each
// `since` against a search back through the whole run.
//
// Then the answers of smc why to random questions about random scripts.  Each change that an answer names is written into the script, which runs
// again: the step must have the outcome that the answer claims, and with "just above" or "just below" a limit, the limit itself must not do.
// The step that is called nearest is checked against all sets of conditions whose truth could be exchanged.
//     random SEED COUNT
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compiler/script/script.h"
#include "compiler/script/why.h"
#include "compiler/script/why_near.h"
#include "stdlib/convert.h"
#include "tests/diff/subject.h"

enum { STEPS = 60, NODES_MOST = 64 };

static struct { uint64_t guards, branches, changed, claims, stays, stored, parameters, sides, nearest, never, distances, several, gaps; } met;

// Returns whether the first statement of a branch was executed in the step.
static bool was_executed(const Watch *w, const Stmts *branch) { return branch->n && w->stmt[branch->at[0]->number].step == w->step; }

static const char *check_guard(Arena *arena, const Watch *w, const WatchStmt *s, uint8_t (*truth)[NODES_MOST], uint64_t step, uint32_t stmts)
{
    const bool is_true = watch_truth(s, s->value, 0);

    if (was_executed(w, is_true ? &s->stmt->otherwise : &s->stmt->then) || ((is_true ? s->stmt->then.n : s->stmt->otherwise.n) && !was_executed(w, is_true ? &s->stmt->then : &s->stmt->otherwise)))
        return format_in(arena, "statement %lu: its guard was recorded as %d, but the step executed the other branch", (unsigned long)s->stmt->number, is_true);
    met.branches += was_executed(w, &s->stmt->then) || was_executed(w, &s->stmt->otherwise);
    for (uint32_t i = 0; i < s->nodes && i < NODES_MOST; i++) {
        const uint8_t now = (uint8_t)(1 + watch_truth(s, s->value, i));
        uint64_t since = step;
        truth[step * stmts + s->stmt->number][i] = now;
        while (since > 1 && truth[(since - 1) * stmts + s->stmt->number][i] == now)
            since--;
        if (s->since[i] != since)
            return format_in(arena, "statement %lu, node %lu: since step %" PRIu64 ", not %" PRIu64, (unsigned long)s->stmt->number, (unsigned long)i, s->since[i], since);
        met.changed += since > 1 && since < step;
    }
    met.guards++;
    return NULL;
}

static const char *run(Subject *s, Gen *g, Arena *arena)
{
    const Program *p = s->program;
    const uint32_t stmts = p->stmts + 1;
    uint8_t (*truth)[NODES_MOST] = arena_array(arena, (STEPS + 1) * (size_t)stmts, sizeof *truth);
    EngineWrite write[GEN_VARS_MAX];
    Engine *ref = engine_ref_open(arena, p);
    uint64_t steps = 0;
    Watch *w = watch_new(arena, p, &steps, 3);
    EngineStep out;
    const char *why = NULL;

    watch_attach(w, ref);
    engine_step_init(&out, arena, p);
    ref->init(ref, 1 + (uint32_t)(g->seed % p->state.n), &out);
    for (uint32_t k = 0; k < STEPS && !why; k++) {
        if (ref->step(ref, write, subject_writes(s, g, k, write), &out) != ENGINE_OK)
            continue;
        steps++;
        for (uint32_t i = 1; i < stmts && !why; i++)
            if (w->stmt[i].stmt && w->stmt[i].stmt->kind == ST_IF && w->stmt[i].step == steps)
                why = check_guard(arena, w, &w->stmt[i], truth, steps, stmts);
        if (!why && engine_ref_transition(ref) != (w->passages && watch_passage(w, 0)->step == steps ? watch_passage(w, 0)->by->stmt : NULL))
            why = "the transition was not recorded";
    }
    return why;
}

// ---- scripts ----

enum { QUESTIONS = 16, LEAVES_MOST = 10 };

// How far a step was from a transition: SIZE_MAX levels if it could not take it.
typedef struct Far { size_t level, conditions; } Far;

typedef struct Told {
    Arena *arena;
    Subject *s;
    Rng rng;
    const char *items, *stop; // the script is its head, the items, what is added, and the stop
    uint64_t delta;
    Engine *engine;
    Watch *w;                 // NULL: only the last step counts
    uint64_t steps, until;    // the run ends after step `until`
    const State *state[STEPS + 1], *next[STEPS + 1];  // by step: the state that it ran; the target of the transition that it took, or NULL
    uint64_t *cell[STEPS + 1];
    Far *far[STEPS + 1];      // by step, by target
    const char *wrong;        // NULL, or a distance that is wrong
} Told;

static bool truth_of(const WatchStmt *s, uint32_t i, const bool *leaf)
{
    const WatchNode *n = &s->node[i];
    bool any = false, all = true;

    if (n->kind == WATCH_LEAF)
        return leaf[i];
    for (uint32_t k = i + 1; k < n->end; k = s->node[k].end) {
        const bool is = truth_of(s, k, leaf);
        any |= is;
        all &= is;
    }
    return n->kind == WATCH_AND ? all : n->kind == WATCH_OR ? any : !any;
}

// Returns how many conditions of a guard must change, by trying all sets of them; SIZE_MAX: they are too many.
static size_t fewest_changes(const WatchStmt *s, bool wanted)
{
    uint32_t at[LEAVES_MOST], n = 0;
    size_t fewest = SIZE_MAX;

    for (uint32_t i = 0; i < s->nodes; i++)
        if (s->node[i].kind == WATCH_LEAF && n++ < LEAVES_MOST)
            at[n - 1] = i;
    for (uint32_t set = 0; n <= LEAVES_MOST && s->nodes <= NODES_MOST && set < 1u << n; set++) {
        bool leaf[NODES_MOST];
        size_t changes = 0;
        for (uint32_t i = 0; i < n; i++) {
            leaf[at[i]] = watch_truth(s, s->value, at[i]) != (set >> i & 1);
            changes += set >> i & 1;
        }
        if (truth_of(s, 0, leaf) == wanted && changes < fewest)
            fewest = changes;
    }
    return fewest;
}

static bool is_less(Far a, Far b) { return a.level != b.level ? a.level < b.level : a.conditions < b.conditions; }

static void check_distance(Told *t, const WatchStmt *x, Far f)
{
    const WhyDistance d = why_distance(t->w, x);

    if (f.conditions == SIZE_MAX)
        return;
    if (d.level != f.level || d.conditions != f.conditions || d.gap < 0 || d.gap > d.conditions)
        t->wrong = format_in(t->arena, "step %" PRIu64 ", statement %lu: %lu levels and %lu conditions, not %lu and %lu", t->w->step, (unsigned long)x->stmt->number,
                             (unsigned long)d.level, (unsigned long)d.conditions, (unsigned long)f.level, (unsigned long)f.conditions);
    met.distances++;
    met.several += f.conditions > 1;
}

// Notes how far the step was from each state.
static void note_far(Told *t, Far *far)
{
    for (uint32_t i = 0; i < t->s->program->state.n; i++)
        far[i].level = SIZE_MAX;
    for (uint32_t i = 1; i <= t->s->program->stmts; i++) {
        const WatchStmt *x = &t->w->stmt[i];
        Far f = {x->step != t->w->step, 0};
        if (!x->stmt || x->stmt->kind != ST_TRANSITION || x->state != t->w->state || (x->block == BLOCK_ENTRY && !t->w->is_first))
            continue;
        for (const WatchStmt *o = x; o->parent; o = o->parent) {
            const size_t few = o->parent->step == t->w->step ? fewest_changes(o->parent, !o->in_else) : 0;
            f.level += o->parent->step != t->w->step;
            f.conditions = few == SIZE_MAX || f.conditions == SIZE_MAX ? SIZE_MAX : f.conditions + few;
        }
        check_distance(t, x, f);
        if (is_less(f, far[x->stmt->target->number - 1]))
            far[x->stmt->target->number - 1] = f;
    }
}

static void note(void *context, const ScriptStep *step)
{
    Told *t = context;
    const Program *p = t->s->program;
    const Stmt *taken = engine_ref_transition(t->engine);
    const uint64_t k = step->number;

    t->steps = k;
    if (k > STEPS)
        return;
    t->state[k] = step->state;
    t->next[k] = taken ? taken->target : NULL;
    t->cell[k] = ARENA_ARRAY(t->arena, uint64_t, p->var.n);
    memcpy(t->cell[k], step->cell, p->var.n * sizeof(uint64_t));
    if (t->w) {
        t->far[k] = ARENA_ARRAY(t->arena, Far, p->state.n);
        note_far(t, t->far[k]);
    }
}

static bool is_over(void *context) { return ((Told *)context)->steps >= ((Told *)context)->until; }

// settings: lines of [options].  added: items.
static const Script *compile_script(Told *t, const char *settings, const char *added)
{
    Session *s = &t->s->session;
    const char *text = format_in(&s->arena, "[options]\ndelta_t %" PRIu64 "\n%s[all_states]\n%s%s%s", t->delta, settings, t->items, added, t->stop);

    return session_script(s, source_new(&s->arena, "random.ss", text, strlen(text)), t->s->program);
}

// Runs a script to step `until`, and notes its steps in *t.
static void run_script(Told *t, const Script *script, uint64_t until, bool is_watched)
{
    ScriptOptions o = {.max_steps = STEPS, .after_step = note, .is_cancelled = is_over, .context = t, .is_silent = true, .continues = true};

    t->until = until;
    t->steps = 0;
    t->engine = engine_ref_open(t->arena, t->s->program);
    t->w = NULL;
    if (is_watched) {
        t->w = watch_new(t->arena, t->s->program, &t->steps, 0);
        watch_attach(t->w, t->engine);
    }
    script_run(t->arena, &t->s->session.diags, script, &t->engine, 1, &o);
}

static const char *errors_of(const Told *t)
{
    Buf out;

    buf_init(&out, t->arena);
    diags_render_text(&t->s->session.diags, &(DiagStyle){false, 3}, &out);
    return buf_text(&out);
}

// Returns a value as the scripts have it.
static const char *value_text(Arena *arena, const Var *v, uint64_t cell)
{
    Buf out;

    buf_init(&out, arena);
    format_cell_shortest(&out, v->type, cell);
    return buf_text(&out);
}

static uint64_t any_cell(Told *t, const Var *v)
{
    const SmTypeInfo *info = &sm_type_info[v->type];
    const double small = (double)rng_below(&t->rng, 24) - (info->kind == SM_KIND_UNSIGNED ? 0 : 8);

    return info->kind == SM_KIND_BOOL ? rng_below(&t->rng, 2) : ref_convert(v->type, info->kind == SM_KIND_FLOAT && rng_percent(&t->rng, 50) ? small / 4 : small);
}

// Prints random inputs of each step.
static void print_items(Told *t, const Gen *g, Buf *out)
{
    for (uint32_t k = 0; k < STEPS; k++)
        for (size_t i = 2; i < g->var.n; i++) {
            const GVar *x = g->var.at[i];
            const Var *v = t->s->program->var.at[t->s->index[x->id]];
            if (x->outside && !x->removed && (x->listed || x->is_local) && rng_percent(&t->rng, k == 0 ? 80 : 15))
                buf_printf(out, "%s == %" PRIu64 ": %s = %s\n", g->var.at[0]->name, k * t->delta, x->name, value_text(t->arena, v, any_cell(t, v)));
        }
}

// ---- what an answer claims ----

// Whether the outcome of a step is another one, and what the question is about.
static bool is_asked(const Told *was, const Told *is, uint64_t k, const WhyQuestion *q)
{
    if (q->of)
        return was->cell[k][q->of->index] != is->cell[k][q->of->index];
    return was->next[k] != is->next[k] && (!q->to || was->state[k] == q->to || was->next[k] == q->to || is->next[k] == q->to);
}

// Runs the script with a variable changed in step k.  Returns false if the script cannot have this value.
static bool run_changed(const Told *was, Told *is, const char *time, uint64_t k, const Var *v, uint64_t cell)
{
    const char *value = value_text(was->arena, v, cell);
    const Script *script;

    *is = *was;
    if (v->parameter)
        script = compile_script(is, format_in(was->arena, "set %s %s\n", v->name->text, value), "");
    else
        script = compile_script(is, "", format_in(was->arena, "%s == %" PRIu64 ": %s = %s\n", time, (k - 1) * was->delta, v->name->text, value));
    if (!script || was->s->session.diags.errors)
        return false;
    run_script(is, script, k, false);
    return is->steps == k;
}

static bool is_refused(const Var *parameter, uint64_t cell)
{
    return parameter_judge(parameter, sm_cell_to_f64(parameter->type, cell), &cell) != SM_REFUSAL_NONE;
}

static const char *check_change(const Told *was, const char *time, uint64_t k, const WhyQuestion *q, const WhyLine *line)
{
    const WhyChange *c = &line->change;
    Told *is = ARENA_NEW(was->arena, Told);
    const uint64_t limit = ref_convert(c->var->type, c->limit);

    if (!run_changed(was, is, time, k, c->var, c->cell))
        return format_in(was->arena, "step %" PRIu64 ": the script cannot have the change of '%s': %s", k, line->text, errors_of(was));
    if (q->of ? is->cell[k][q->of->index] != c->stored : is->next[k] != c->next)
        return format_in(was->arena, "step %" PRIu64 ": '%s' is wrong", k, line->text);
    if (!is_asked(was, is, k, q))
        return format_in(was->arena, "step %" PRIu64 ": '%s' makes no difference", k, line->text);
    met.claims++;
    met.stays += !q->of && !c->next;
    met.stored += q->of != NULL;
    met.parameters += c->var->parameter != NULL;
    if (is->state[k] != was->state[k])
        return format_in(was->arena, "step %" PRIu64 ": '%s': it runs another state", k, line->text);
    if (c->side == 0 || ref_read(c->var->type, limit) != c->limit || (c->var->parameter && is_refused(c->var, limit)))
        return NULL;
    met.sides++;
    if (run_changed(was, is, time, k, c->var, limit) && is->state[k] == was->state[k] && is_asked(was, is, k, q))
        return format_in(was->arena, "step %" PRIu64 ": '%s', and with the limit itself too", k, line->text);
    return NULL;
}

static const Expr *without_not(const Expr *e)
{
    while (e->kind == EX_UNARY && e->op == SM_OP_NOT)
        e = e->arg[0];
    return e;
}

// Whether a condition is a variable, or compares it.
static bool depends_on(const Expr *e, const Var *v)
{
    if (e->kind == EX_VAR)
        return e->var == v;
    for (uint32_t i = 0; watch_is_relation(e) && i < e->n; i++)
        if (e->arg[i]->kind == EX_VAR && e->arg[i]->var == v)
            return true;
    return false;
}

// Checks the gap of the only condition of an answer that depends on the variable of a change, if it has one: how far the value was from the limit.
static const char *check_gap(const Told *t, const WhyLine *first, const WhyLine *change)
{
    const WhyChange *c = &change->change;
    const double was = ref_read(c->var->type, c->was), gap = c->limit > was ? c->limit - was : was - c->limit;
    const WhyLine *found = NULL;
    size_t n = 0;

    for (const WhyLine *l = first; l < change; l++)
        if (l->e && depends_on(without_not(l->e), c->var)) {
            found = l;
            n++;
        }
    if (n != 1 || !found->has_gap || without_not(found->e)->kind != EX_BINARY)
        return NULL;
    met.gaps++;
    return found->gap == gap ? NULL : format_in(t->arena, "'%s' has the gap %g, but '%s'", found->text, found->gap, change->text);
}

// Checks that no step was nearer to a state than the one that the answer names; 0: it names none.  says_never: it says that no step could go there.
static const char *check_nearest(const Told *t, const State *to, uint64_t named, bool says_never)
{
    const uint32_t i = to->number - 1;
    bool taken = false, could = false;

    for (uint64_t k = 1; k <= t->steps; k++) {
        taken |= t->next[k] == to;
        could |= t->far[k][i].level != SIZE_MAX;
        if (named && is_less(t->far[k][i], t->far[named][i]))
            return format_in(t->arena, "step %" PRIu64 " was nearer to %s than step %" PRIu64, k, to->name->text, named);
    }
    if (named && t->far[named][i].level == SIZE_MAX)
        return format_in(t->arena, "step %" PRIu64 " could not go to %s", named, to->name->text);
    if (t->state[t->steps] != to && (named != 0) != (could && !taken))
        return format_in(t->arena, "step %" PRIu64 " is named as the nearest to %s, but could: %d, taken: %d", named, to->name->text, could, taken);
    if (t->state[t->steps] != to && t->next[t->steps] != to && says_never == could)
        return format_in(t->arena, "a step could go to %s: %d", to->name->text, could);
    met.nearest += named != 0;
    met.never += !could;
    return NULL;
}

// Returns the second state of "... A -> B -> C; ..." or "A -> B was ...".
static const State *second_state(const Program *p, const char *path)
{
    const char *name = strstr(path, " -> ") + 4;

    for (size_t i = 0; i < p->state.n; i++) {
        const size_t n = strlen(p->state.at[i]->name->text);
        if (strncmp(p->state.at[i]->name->text, name, n) == 0 && (name[n] == ' ' || name[n] == ';'))
            return p->state.at[i];
    }
    return NULL;
}

// Asks a question, and checks the answer.
static const char *check_answer(const Told *t, const char *time, const Script *script, const WhyQuestion *q)
{
    const ScriptOptions o = {.max_steps = STEPS};
    WhyQuestion about = *q;
    const WhyAnswer a = why_ask(t->arena, script, &o, q);
    uint64_t k = q->of ? 0 : a.step, named = 0;
    const WhyLine *first = a.line.at;
    bool says_never = false;
    const char *wrong = NULL;

    if (a.status != WHY_ANSWERED)
        return "there is no answer";
    for (uint32_t i = 0; i < a.line.n && !wrong; i++) {
        const WhyLine *l = &a.line.at[i];
        if (l->kind == WHY_STEP && l->step)
            k = l->step;
        if (l->kind == WHY_NEAREST) {
            named = k = l->step;
            first = l;
            about.to = second_state(t->s->program, l->text);
        }
        if (l->kind == WHY_HEADING && strstr(l->text, "the shortest path is "))
            about.to = second_state(t->s->program, l->text);  // the answer is about the first transition of the path
        says_never |= l->kind == WHY_REMARK && strstr(l->text, "was never in a state from which");
        if (says_never)
            break;
        if (l->kind == WHY_CHANGE && !(wrong = check_change(t, time, k, &about, l)))
            wrong = check_gap(t, first, l);
    }
    return wrong || !q->to || q->at_step ? wrong : check_nearest(t, q->to, named, says_never);
}

static const char *check_answers(Subject *s, const Gen *g, Arena *arena)
{
    Told *t = ARENA_NEW(arena, Told);
    const Program *p = s->program;
    const char *time = g->var.at[0]->name, *wrong = NULL;
    const Script *script;
    Buf items;

    *t = (Told){.arena = arena, .s = s, .rng = {rng_mix(g->seed, 77)}, .delta = p->step ? p->step : 10};
    buf_init(&items, arena);
    print_items(t, g, &items);
    t->items = buf_text(&items);
    t->stop = format_in(arena, "%s == %" PRIu64 ": @stop\n", time, (STEPS - 1) * t->delta);
    script = compile_script(t, "", "");
    if (!script || s->session.diags.errors)
        return errors_of(t);
    run_script(t, script, STEPS, true);
    wrong = t->wrong;
    for (int i = 0; i < QUESTIONS && !wrong; i++) {
        WhyQuestion q = {.at_step = i > 1 ? 1 + rng_below(&t->rng, STEPS) : 0};
        if (i < 5)
            q.to = p->state.at[rng_below(&t->rng, (uint32_t)p->state.n)];
        else if (i < 10)
            q.of = p->var.at[rng_below(&t->rng, (uint32_t)p->var.n)];
        wrong = check_answer(t, time, script, &q);
    }
    return wrong;
}

int main(int argc, char **argv)
{
    const uint64_t seed = argc > 1 ? strtoull(argv[1], NULL, 10) : 1, count = argc > 2 ? strtoull(argv[2], NULL, 10) : 500;
    uint64_t failed = 0;

    for (uint64_t i = 0; i < count; i++) {
        Arena arena;
        Subject s;
        Gen *g;
        const char *why;
        diff_arena_init(&arena);
        g = gen_program(&arena, rng_mix(seed, i), STEPS);
        why = subject_compile(&s, g, &arena);
        if (!why)
            why = run(&s, g, &arena);
        if (!why)
            why = check_answers(&s, g, &arena);
        if (why) {
            printf("seed %" PRIu64 ", program %" PRIu64 ": %s\n", seed, i, why);
            failed++;
        }
        subject_free(&s);
        arena_free(&arena);
    }
    if (met.guards < 10 * count || met.branches < count || met.changed < count) {
        printf("too little was met: %" PRIu64 " guards, %" PRIu64 " branches, %" PRIu64 " changes\n", met.guards, met.branches, met.changed);
        failed++;
    }
    if (5 * met.claims < count || 15 * met.stays < count || 200 * met.stored < count || 120 * met.parameters < count || 20 * met.sides < count ||
        5 * met.nearest < count || met.never < count / 3 || met.distances < 40 * count || 10 * met.several < count ||
        40 * met.gaps < count) {
        printf("too few answers were checked\n");
        failed++;
    }
    printf("%" PRIu64 " claims: %" PRIu64 " stay, %" PRIu64 " of values, %" PRIu64 " of parameters, %" PRIu64 " next to a limit; nearest steps: %" PRIu64 ", %" PRIu64 " impossible; distances: %" PRIu64 ", %" PRIu64
           " of several conditions; gaps: %" PRIu64 "\n",
           met.claims, met.stays, met.stored, met.parameters, met.sides, met.nearest, met.never, met.distances, met.several, met.gaps);
    printf("%" PRIu64 " passed, %" PRIu64 " failed\n", count - (failed < count ? failed : count), failed);
    return failed > 0;
}
