// SPDX-License-Identifier: Apache-2.0
#include "compiler/search/goal_text.h"

#include <string.h>

#include "compiler/analysis/transitions.h"
#include "stdlib/convert.h"

struct GoalTexts {
    Arena *arena;
    const Cover *c;
    const char *before;       // begins each sentence: "", or of an application "vent: "
    const char *stem;         // begins the name of each script: "tank", or of an application "stand-vent"
    Transitions transition;
    VEC(StmtLocation) stmt;
};

static void list_stmt(const StmtLocation *at, void *context)
{
    GoalTexts *t = context;

    vec_push(t->arena, &t->stmt, *at);
}

GoalTexts *goal_texts_new(Arena *arena, const Cover *c, const Program *p, size_t machine)
{
    GoalTexts *t = ARENA_NEW(arena, GoalTexts);

    t->arena = arena;
    t->c = c;
    t->before = p->joint ? format_in(arena, "%s: ", engine_machine_name(p, machine)) : "";
    t->stem = p->joint ? format_in(arena, "%s-%s", p->name->text, engine_machine_name(p, machine)) : c->p->name->text;
    t->transition = transitions_of(arena, c->p);
    each_stmt_location(arena, c->p, list_stmt, t);
    return t;
}

// ---- where a place is ----

// Whether the outer span contains the inner one.
static bool contains(Span outer, Span inner)
{
    return outer.at <= inner.at && inner.at + inner.len <= outer.at + outer.len;
}

// Returns the state whose statements contain a place; NULL: several do, or none.
static const State *state_of(const GoalTexts *t, const CoverPlace *p)
{
    const State *found = p->from;

    for (uint32_t i = 0; i < t->stmt.n && !p->from; i++) {
        const StmtLocation *s = &t->stmt.at[i];
        if (!contains(s->stmt->span, p->where) || s->state == found)
            continue;
        if (found)
            return NULL;
        found = s->state;
    }
    return found;
}

// Returns the transition that a goal names; NULL if the goal is no transition.
static const Transition *transition_of(const GoalTexts *t, const CoverPlace *p)
{
    for (uint32_t i = 0; i < t->transition.n; i++)
        if (t->transition.at[i].from == p->from && t->transition.at[i].stmt->span.at == p->span.at)
            return &t->transition.at[i];
    return NULL;
}

// ---- sentences ----

typedef struct Constants { Arena *arena; Buf out; } Constants;

// Adds `name = value` to the list of constants for each constant that the expression names.
static void add_constant(Expr *e, void *context)
{
    Constants *k = context;

    if (e->kind == EX_VAR && e->var->is_constant && !strstr(buf_text(&k->out), format_in(k->arena, "%s = ", e->var->name->text)))
        buf_printf(&k->out, "%s%s = %s", k->out.n ? ", " : " (", e->var->name->text,
                   const_text(k->arena, sm_cell_to_f64(e->var->type, e->var->init)));
}

// Returns the values of the constants in a condition: " (limit = 825, margin = 25)"; "" if it has none.
static const char *constants_of(Arena *arena, const Condition *when)
{
    Constants k = {.arena = arena};

    buf_init(&k.out, arena);
    for (const Condition *c = when; c; c = c->outer)
        expr_walk(c->stmt->value, add_constant, &k);
    if (k.out.n)
        buf_char(&k.out, ')');
    return buf_text(&k.out);
}

static const char *transition_sentence(const GoalTexts *t, const CoverPlace *p)
{
    const Transition *taken = transition_of(t, p);
    const char *when = taken ? condition_text(t->arena, taken->when) : "";

    return *when ? format_in(t->arena, "%s -> %s, taken because %s%s.", p->from->name->text, p->to->name->text, when,
                             constants_of(t->arena, taken->when))
                 : format_in(t->arena, "%s -> %s, taken without a condition.", p->from->name->text, p->to->name->text);
}

static const char *sentence_of(const GoalTexts *t, uint32_t place)
{
    const CoverPlace *p = &t->c->place.at[place];
    const State *state = state_of(t, p);
    const char *in = state ? format_in(t->arena, "In %s, ", state->name->text) : "", *text = source_text(t->arena, p->span);
    const char *value = p->value ? "true" : "false";

    switch (p->kind) {
    case COVER_TRANSITION: return transition_sentence(t, p);
    case COVER_STATEMENT:  return format_in(t->arena, "%s'%s' is executed.", in, text);
    case COVER_GUARD:      return format_in(t->arena, "%s'%s' is %s.", in, text, value);
    case COVER_CONDITION:  return format_in(t->arena, "%s'%s' is %s, and that decides '%s'.", in, text, value,
                                            source_text(t->arena, t->c->place.at[p->result].span));
    case COVER_WINDOW:     return format_in(t->arena, "%s'%s' is full while its value matters.", in, text);
    case COVER_STATE:      return format_in(t->arena, "%s is %s.", p->from->name->text, p->value ? "entered" : "left");
    case COVER_PARAMETER: case COVER_KIND_COUNT: break;        // no goals: a parameter is set, and not reached
    }
    return "";
}

const char *goal_sentence(const GoalTexts *t, uint32_t place) { return format_in(t->arena, "%s%s", t->before, sentence_of(t, place)); }

// ---- names ----

const char *goal_name_part(Arena *arena, const char *text)
{
    Buf out;

    buf_init(&out, arena);
    for (; *text; text++) {
        const char low = *text >= 'A' && *text <= 'Z' ? (char)(*text - 'A' + 'a') : *text;
        if ((low >= 'a' && low <= 'z') || (low >= '0' && low <= '9'))
            buf_char(&out, low);
        else if (out.n && out.at[out.n - 1] != '-')
            buf_char(&out, '-');
    }
    return buf_text(&out);
}

// Returns the number of a place, from 1, among the places of its kind; guards are numbered among the decisions.
static uint32_t number_of(const GoalTexts *t, uint32_t place)
{
    uint32_t n = 0;

    for (uint32_t i = 1; i <= place; i++)
        n += t->c->place.at[i].kind == t->c->place.at[place].kind;
    return n;
}

const char *goal_file_stem(const GoalTexts *t, uint32_t place)
{
    static const char *const word[COVER_KIND_COUNT] = {"", "statement", "guard", "condition", "window", "state"};
    const CoverPlace *p = &t->c->place.at[place];
    const char *machine = t->stem;
    const State *state = state_of(t, p);
    const unsigned long n = number_of(t, place);
    const char *end = p->kind == COVER_STATE ? (p->value ? "entered" : "left") : p->kind == COVER_WINDOW
        ? "full" : p->kind == COVER_STATEMENT ? "executed"
                    : p->value ? "true" : "false";

    if (p->kind == COVER_TRANSITION)
        return format_in(t->arena, "%s-%lu-%s-to-%s", machine, n, goal_name_part(t->arena, p->from->name->text),
                         goal_name_part(t->arena, p->to->name->text));
    return format_in(t->arena, "%s-%s-%lu-%s%s", machine, word[p->kind], n,
                     state ? format_in(t->arena, "%s-", goal_name_part(t->arena, state->name->text)) : "", end);
}
