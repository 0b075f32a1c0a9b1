// SPDX-License-Identifier: Apache-2.0
// Matches the states and variables of two machines: by name, and where names differ by what they do.
#include <stdlib.h>
#include <string.h>

#include "compiler/diff/diff_part.h"

static const char *element_name(const Var *v) { return v->element ? v->element->name->text : v->name->text; }

// ---- canonical names ----

static const char *special_name(const Program *p, const Var *v) { return v == p->g ? "G" : v == p->s ? "S" : v == p->t ? "T" : NULL; }

// Sets canonical names for both machines from the match so far: matched variables and states get the same name, all others a name that the other
// machine does not have.
static void set_names(ProgramDiff *d, Canon canon[2])
{
    for (int side = 0; side < 2; side++) {
        Canon *c = &canon[side];
        const Program *p = c->p = side ? d->new.p : d->old.p;
        const Var **var_of = side ? d->old_var_of : d->var_of;
        const uint32_t *state_of = side ? d->old_state_of : d->state_of;
        c->side = side ? "new" : "old";
        c->keeps_numbers = true;
        c->var = ARENA_ARRAY(d->arena, const char *, p->var.n + 1u);
        c->state = ARENA_ARRAY(d->arena, const char *, p->state.n + 2u);
        for (size_t i = 0; i < p->var.n; i++) {
            const Var *v = p->var.at[i], *name = var_of[i] && !side ? var_of[i] : v;
            const char *special = special_name(p, v);
            c->var[i] = special ? special : format_in(d->arena, "%s%s%s", var_of[i] ? "" : c->side, v->kind == VAR_ELEMENT ? "@" : ".",
                                                      v->kind == VAR_ELEMENT ? element_name(name) : name->name->text);
        }
        for (uint32_t s = 1; s <= p->state.n; s++) {
            const State *name = side || !state_of[s] ? p->state.at[s - 1] : d->new.p->state.at[state_of[s] - 1];
            c->state[s] = state_of[s] ? name->name->text : "?";
        }
    }
    for (uint32_t s = 1; s <= d->old.p->state.n; s++)
        canon[0].keeps_numbers = canon[1].keeps_numbers = canon[0].keeps_numbers && (d->state_of[s] == 0 || d->state_of[s] == s);
}

// ---- by name ----

// Records that a variable of the old machine is this one in the new machine.
static void pair_vars(ProgramDiff *d, const Var *old, const Var *new)
{
    d->var_of[old->index] = new;
    d->old_var_of[new->index] = old;
}

static void pair_states(ProgramDiff *d, const State *old, const State *new)
{
    d->state_of[old->number] = new->number;
    d->old_state_of[new->number] = old->number;
}

// Whether x of machine a and y of machine b have the same name. G, S and T match whatever they are called.
static bool same_name(const Program *a, const Var *x, const Program *b, const Var *y)
{
    const char *s = special_name(a, x), *t = special_name(b, y);

    if (s || t)
        return s && t && strcmp(s, t) == 0;
    return x->kind == y->kind && strcmp(x->kind == VAR_ELEMENT ? element_name(x) : x->name->text,
                                        y->kind == VAR_ELEMENT ? element_name(y) : y->name->text) == 0;
}

// Pairs variables and states that have the same name in both machines.
static void match_names(ProgramDiff *d)
{
    const Program *a = d->old.p, *b = d->new.p;

    for (size_t i = 0; i < a->var.n; i++)
        for (size_t k = 0; k < b->var.n; k++)
            if (!d->var_of[i] && !d->old_var_of[k] && same_name(a, a->var.at[i], b, b->var.at[k]))
                pair_vars(d, a->var.at[i], b->var.at[k]);
    for (size_t i = 0; i < a->state.n; i++)
        for (size_t k = 0; k < b->state.n; k++)
            if (strcmp(a->state.at[i]->name->text, b->state.at[k]->name->text) == 0)
                pair_states(d, a->state.at[i], b->state.at[k]);
}

// ---- renamed locals ----

static int compare_texts(const void *a, const void *b) { return strcmp(*(const char *const *)a, *(const char *const *)b); }

// Returns all statements that mention the variable, in which it is called `$`, sorted, a line each.
static const char *list_uses(Arena *arena, const Canon *of, const Var *v)
{
    Canon c = *of;
    VEC(const char *) use = {NULL, 0, 0};
    Buf out;

    c.var = ARENA_ARRAY(arena, const char *, c.p->var.n);
    for (size_t i = 0; i < c.p->var.n; i++)
        c.var[i] = i == v->index ? "$" : of->var[i][0] == 'o' || of->var[i][0] == 'n' ? "?" : of->var[i];
    for (size_t s = 0; s < c.p->state.n; s++)
        for (int b = 0; b < BLOCK_COUNT; b++)
            for (size_t i = 0; i < c.p->state.at[s]->block[b].n; i++) {
                Buf text;
                buf_init(&text, arena);
                canon_stmt(&c, c.p->state.at[s]->block[b].at[i], &text);
                if (strchr(buf_text(&text), '$'))
                    vec_push(arena, &use, buf_text(&text));
            }
    if (use.n)
        qsort(use.at, use.n, sizeof *use.at, compare_texts);
    buf_init(&out, arena);
    for (size_t i = 0; i < use.n; i++)
        buf_printf(&out, "%s\n", use.at[i]);
    return buf_text(&out);
}

// Whether two locals have the same type, initial value and kind, so that one can be the renamed other.
static bool same_form(const Var *a, const Var *b)
{
    return a->kind == VAR_LOCAL && b->kind == VAR_LOCAL && a->type == b->type && a->init == b->init && a->is_constant == b->is_constant &&
           (a->parameter != NULL) == (b->parameter != NULL);
}

// Returns the uses of each local that has no match, by Var.index; NULL for all other variables.
static const char **list_all_uses(ProgramDiff *d, const Canon *c, const Var *const *var_of)
{
    const char **use = ARENA_ARRAY(d->arena, const char *, c->p->var.n + 1u);

    for (size_t i = 0; i < c->p->var.n; i++)
        if (!var_of[i] && c->p->var.at[i]->kind == VAR_LOCAL)
            use[i] = c->p->var.at[i]->is_constant ? "" : list_uses(d->arena, c, c->p->var.at[i]);
    return use;
}

// Pairs locals with equal uses: those that have only one candidate, or the first two if `any`.  Returns whether it has paired some.
static bool pair_locals(ProgramDiff *d, const Canon canon[2], bool any)
{
    const Program *a = d->old.p, *b = d->new.p;
    const char **mine = list_all_uses(d, &canon[0], d->var_of), **theirs = list_all_uses(d, &canon[1], d->old_var_of);
    bool paired = false;

    for (size_t i = 0; i < a->var.n && !(any && paired); i++) {
        const Var *found = NULL;
        size_t candidates = 0;
        for (size_t k = 0; mine[i] && k < b->var.n; k++)
            if (theirs[k] && !d->old_var_of[k] && same_form(a->var.at[i], b->var.at[k]) && strcmp(mine[i], theirs[k]) == 0) {
                found = found ? found : b->var.at[k];
                candidates++;
            }
        if (candidates == 0 || (candidates > 1 && !any))
            continue;
        pair_vars(d, a->var.at[i], found);
        paired = true;
    }
    return paired;
}

// Whether two lists of lines have a line in common.
static bool shares_line(const char *a, const char *b)
{
    for (const char *end; (end = strchr(a, '\n')) != NULL; a = end + 1)
        for (const char *at = b; *at; at = strchr(at, '\n') + 1)
            if (strncmp(at, a, (size_t)(end - a) + 1) == 0)
                return true;
    return false;
}

// Returns the local of p without a match that has the form of `form`; NULL if p has none or several.
static const Var *only_with_form(const Program *p, const Var *const *var_of, const Var *form)
{
    const Var *found = NULL;

    for (size_t i = 0; i < p->var.n; i++)
        if (!var_of[i] && same_form(p->var.at[i], form)) {
            if (found)
                return NULL;
            found = p->var.at[i];
        }
    return found;
}

// Pairs locals that are the only ones of their form, and have a statement in common.
static void match_likely_locals(ProgramDiff *d, const Canon canon[2])
{
    for (size_t i = 0; i < d->old.p->var.n; i++) {
        const Var *a = d->old.p->var.at[i], *b = d->var_of[i] || a->kind != VAR_LOCAL || a->is_constant
            ? NULL : only_with_form(d->new.p, d->old_var_of, a);
        if (b && only_with_form(d->old.p, d->var_of, b) == a && shares_line(list_uses(d->arena, &canon[0], a), list_uses(d->arena, &canon[1], b)))
            pair_vars(d, a, b);
    }
}

// Pairs renamed locals until no more are found.  Each pair changes the names in the statements that mention other locals, so these can then have a
// single candidate.
static void match_locals(ProgramDiff *d, Canon canon[2])
{
    while (pair_locals(d, canon, false) || pair_locals(d, canon, true))
        set_names(d, canon);
}

// ---- renamed states ----

typedef VEC(const char *) Texts;

typedef struct Incoming { Arena *arena; const Canon *c; const State *to; Texts *out; } Incoming;

// Called for each statement: adds the transition to in->to that it is, with its source state and condition.
static void add_incoming(const StmtLocation *at, void *context)
{
    Incoming *in = context;

    if (at->stmt->kind == ST_TRANSITION && at->stmt->target == in->to)
        vec_push(in->arena, in->out, format_in(in->arena, "from %s %s", in->c->state[at->state->number],
                                               canon_condition(in->arena, in->c, at->when)));
}

// Lists the statements of a state and the transitions to it, in canonical form and sorted, to compare it with states of the other machine.
static Texts describe_state(Arena *arena, const Canon *c, const State *s)
{
    Texts out = {NULL, 0, 0};
    Incoming in = {arena, c, s, &out};

    for (int b = 0; b < BLOCK_COUNT; b++)
        for (size_t i = 0; i < s->block[b].n; i++) {
            Buf text;
            buf_init(&text, arena);
            buf_printf(&text, ".%d ", b);
            canon_stmt(c, s->block[b].at[i], &text);
            vec_push(arena, &out, buf_text(&text));
        }
    each_stmt_location(arena, c->p, add_incoming, &in);
    if (out.n)
        qsort(out.at, out.n, sizeof *out.at, compare_texts);
    return out;
}

// Returns which part of two sorted lists is common to both, in percent.
static unsigned similarity_of(const Texts *a, const Texts *b)
{
    size_t i = 0, k = 0, common = 0;

    while (i < a->n && k < b->n) {
        const int order = strcmp(a->at[i], b->at[k]);
        common += order == 0;
        i += order <= 0;
        k += order >= 0;
    }
    return a->n + b->n == 0 ? 0 : (unsigned)(200 * common / (a->n + b->n));
}

enum { RENAMED_LEAST = 60 };      // percent: below it two states are not assumed to be the same one

static void report_renamed_state(ProgramDiff *d, const State *from, const State *to, const char *meaning)
{
    diff_add(d, (DiffChange){.part = DIFF_STATE, .how = DIFF_RENAMED, .weight = DIFF_NOTE, .where = to->name->text, .what = from->name->text,
                             .old = from->name->text, .new = to->name->text, .meaning = meaning});
}

// Pairs the two unmatched states that are most alike.  Returns false if no two are alike enough.
static bool match_most_similar_states(ProgramDiff *d, Canon canon[2])
{
    const State *from = NULL, *to = NULL;
    unsigned best = RENAMED_LEAST - 1;

    set_names(d, canon);
    for (size_t i = 0; i < d->old.p->state.n; i++) {
        const State *s = d->old.p->state.at[i];
        const Texts mine = describe_state(d->arena, &canon[0], s);
        for (size_t k = 0; k < d->new.p->state.n && !d->state_of[s->number]; k++) {
            const State *other = d->new.p->state.at[k];
            const Texts theirs = describe_state(d->arena, &canon[1], other);
            const unsigned like = d->old_state_of[other->number] ? 0 : similarity_of(&mine, &theirs);
            if (like > best) {
                best = like;
                from = s;
                to = other;
            }
        }
    }
    if (!from)
        return false;
    pair_states(d, from, to);
    report_renamed_state(d, from, to, best == 100 ? "certain: its statements and the transitions to it are equal"
                                            : format_in(d->arena, "likely: %u %% of its statements and of the transitions to it are equal", best));
    return true;
}

// ---- a machine in which only names have changed ----

// Returns the next state from index i on that has no match.
static uint32_t next_unmatched(const uint32_t *state_of, size_t states, uint32_t i)
{
    while (i < states && state_of[i + 1])
        i++;
    return i;
}

// Pairs the remaining states and locals in the order of their files.  Returns false if their numbers or forms differ.
static bool pair_in_order(ProgramDiff *d)
{
    const Program *a = d->old.p, *b = d->new.p;
    uint32_t s = 0, t = 0;
    size_t k = 0;

    while ((s = next_unmatched(d->state_of, a->state.n, s)) < a->state.n) {
        t = next_unmatched(d->old_state_of, b->state.n, t);
        if (t == b->state.n)
            return false;
        pair_states(d, a->state.at[s], b->state.at[t]);
    }
    for (size_t i = 0; i < a->var.n; i++) {
        if (d->var_of[i] || a->var.at[i]->kind != VAR_LOCAL)
            continue;
        while (k < b->var.n && (d->old_var_of[k] || b->var.at[k]->kind != VAR_LOCAL))
            k++;
        if (k == b->var.n || !same_form(a->var.at[i], b->var.at[k]))
            return false;
        pair_vars(d, a->var.at[i], b->var.at[k]);
    }
    return true;
}

// Whether every state equals the one it is paired with, in canonical form.
static bool states_are_equal(const ProgramDiff *d, const Canon canon[2])
{
    if (d->old.p->state.n != d->new.p->state.n)
        return false;
    for (uint32_t s = 1; s <= d->old.p->state.n; s++) {
        Buf x, y;
        buf_init(&x, d->arena);
        buf_init(&y, d->arena);
        canon_state(&canon[0], d->old.p->state.at[s - 1], &x);
        canon_state(&canon[1], d->new.p->state.at[d->state_of[s] - 1], &y);
        if (strcmp(buf_text(&x), buf_text(&y)) != 0)
            return false;
    }
    return true;
}

// Pairs everything that has no match by name in the order of the files. Returns whether the machines are then equal; if not, removes these pairs.
static bool match_in_order(ProgramDiff *d, Canon canon[2])
{
    const Program *a = d->old.p, *b = d->new.p;
    ProgramDiff before = *d;

    before.state_of = arena_copy(d->arena, d->state_of, (a->state.n + 1u) * sizeof *d->state_of);
    before.old_state_of = arena_copy(d->arena, d->old_state_of, (b->state.n + 1u) * sizeof *d->old_state_of);
    before.var_of = arena_copy(d->arena, d->var_of, (a->var.n + 1u) * sizeof *d->var_of);
    before.old_var_of = arena_copy(d->arena, d->old_var_of, (b->var.n + 1u) * sizeof *d->old_var_of);
    if (pair_in_order(d)) {
        set_names(d, canon);
        if (states_are_equal(d, canon)) {
            for (uint32_t s = 1; s <= a->state.n; s++)
                if (!before.state_of[s])
                    report_renamed_state(d, a->state.at[s - 1], b->state.at[d->state_of[s] - 1], "certain: only names have changed");
            return true;
        }
    }
    *d = before;
    return false;
}

// ---- all ----

// Pairs the states and variables of both machines, adds what was renamed, added or removed, and sets the canonical names.
void diff_match(ProgramDiff *d, Canon canon[2])
{
    match_names(d);
    if (!match_in_order(d, canon)) {
        set_names(d, canon);
        match_locals(d, canon);
        while (match_most_similar_states(d, canon))
            ;
        set_names(d, canon);
        match_locals(d, canon);
        match_likely_locals(d, canon);
    }
    set_names(d, canon);
    for (int side = 0; side < 2; side++)
        for (uint32_t s = 1; s <= canon[side].p->state.n; s++)
            if (!(side ? d->old_state_of : d->state_of)[s])
                canon[side].state[s] = format_in(d->arena, "%s.%s", canon[side].side, canon[side].p->state.at[s - 1]->name->text);
}
