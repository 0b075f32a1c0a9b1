// SPDX-License-Identifier: Apache-2.0
// Names in scope: finds what a name refers to.  Reports an unknown name once, with the most similar known one.
#include "compiler/sema/member.h"
#include "compiler/syntax/time_unit.h"

#include <string.h>

// ---- guesses ----

static char to_lower(char c)
{
    return c >= 'A' && c <= 'Z' ? (char)(c - 'A' + 'a') : c;
}

static bool is_same_but_for_case(const char *a, const char *b)
{
    for (; *a && *b; a++, b++)
        if (to_lower(*a) != to_lower(*b))
            return false;
    return *a == *b;
}

// Starts a search for the known name that is most similar to `wanted`.  At most a third of its characters, and at most 3, can differ.
Guess guess_init(Str wanted)
{
    size_t typos = wanted->len / 3;
    Guess g = {wanted, NULL, (typos < 3 ? typos : 3) + 1};

    return g;
}

void guess_consider(Guess *g, Str candidate)
{
    size_t distance = str_distance(g->wanted->text, candidate->text, g->limit);

    if (distance > 0 && is_same_but_for_case(g->wanted->text, candidate->text))
        distance = g->limit > 1 ? 1 : 0;
    if (distance >= g->limit)
        return;
    g->best = candidate;
    g->limit = distance;
}

// Adds the label "did you mean …?" to d, if a near word was found.
void guess_add_label(Diags *diags, Diag *d, const Guess *g)
{
    if (g->best)
        diag_label(diags, d, DIAG_label_did_you_mean, g->best->text);
}

// Uses up one of the remaining searches for a similar name; returns false if none remains.  Each search compares the name with all known
// names, so without a limit a hostile file would take quadratic time.
static bool use_up_guess(unsigned *guesses)
{
    if (*guesses == 0)
        return false;
    --*guesses;
    return true;
}

Str suggest_element(Diags *diags, Diag *d, unsigned *guesses, const StateVec *sv, Str name)
{
    Guess g = guess_init(name);

    if (!use_up_guess(guesses))
        return NULL;
    for (size_t i = 0; i < sv->element.n; i++)
        guess_consider(&g, sv->element.at[i]->name);
    guess_add_label(diags, d, &g);
    return g.best;
}

Str suggest_state(Diags *diags, Diag *d, unsigned *guesses, const Program *p, Str name)
{
    Guess g = guess_init(name);

    if (!use_up_guess(guesses))
        return NULL;
    for (size_t i = 0; i < p->state.n; i++)
        guess_consider(&g, p->state.at[i]->name);
    guess_add_label(diags, d, &g);
    return g.best;
}

// Adds a name to the set of names already reported.  Returns whether it was not yet in the set.
static bool add_reported_name(Map *reported, Str name)
{
    if (map_find(reported, name))
        return false;
    map_put(reported, name, (void *)name);
    return true;
}

// ---- variables ----

Var *scope_find_variable(const Sema *s, Str name)
{
    Var *v = map_find(&s->p->by_name, name);

    return v || !s->in_script ? v : map_find(&s->script_local, name);
}

// Whether the name was declared twice, so that its meaning is uncertain.
bool scope_is_doubtful(const Sema *s, Str name)
{
    return map_find(&s->doubtful, name) != NULL;
}

// Adds a note that points at the declaration of a name of the machine.
void scope_note_declared(Sema *s, Diag *d, Str name)
{
    const Span *span = map_find(&s->declared_at, name);
    const Var *v = scope_find_variable(s, name);
    const Define *define = map_find(&s->defines, name);

    if (!span && !v && define)
        span = &define->span;
    if (span)
        diag_note(s->diags, d, *span, DIAG_note_declared_here, name->text);
    else if (v && v->span.src)
        diag_note(s->diags, d, v->span, DIAG_note_declared_here, v->name->text);
}

// A name or function of another language or a spreadsheet, and the advice for it (foreign_names.def).
typedef struct ForeignName {
    const char *name;
    DiagCode label;
    const char *argument;         // text for the placeholder of the label; "" if the label has none
} ForeignName;

static const ForeignName foreign_names[] = {
#define FOREIGN_NAME(name, label, argument) {name, DIAG_##label, argument},
#include "compiler/sema/foreign_names.def"
};

static const ForeignName foreign_functions[] = {
#define FOREIGN_FUNCTION(name, label, argument) {name, DIAG_##label, argument},
#include "compiler/sema/foreign_names.def"
};

static const ForeignName *find_foreign(const ForeignName *table, size_t n, const char *name)
{
    for (size_t i = 0; i < n; i++)
        if (is_same_but_for_case(name, table[i].name))
            return &table[i];
    return NULL;
}

// Labels d with the advice for a name or function, or with that for scripts.
static void label_foreign(const Sema *s, Diag *d, const ForeignName *f)
{
    static const struct { DiagCode label, in_script; } other[] = {
        {DIAG_label_never_nan, DIAG_label_write_zero}, {DIAG_label_print_in_script, DIAG_label_print_value},
        {DIAG_label_wait, DIAG_label_wait_in_script}};
    const char *after = d->span.src->text + d->span.at + d->span.len;
    const char *argument = f->label == DIAG_label_wait ? time_unit_format_call(s->arena, after) : f->argument;
    DiagCode label = f->label;

    for (size_t i = 0; i < sizeof other / sizeof *other; i++)
        if (s->in_script && label == other[i].label) {
            label = other[i].in_script;
            break;
        }
    diag_label(s->diags, d, label, argument);
}

// Whether an assignment follows the name, so that the name is no value.
static bool is_assigned(Span name)
{
    const char *after = name.src->text + name.at + name.len;

    after += strspn(after, " \t");
    return after[0] == '=' && after[1] != '=';
}

// Suggests what to write for a word of another language (True, on, pi) or a keyword in the wrong case (ELSE).  Returns false if
// foreign_names.def does not list the word.
static bool suggest_spelling(Sema *s, Diag *d, Str name)
{
    const ForeignName *f = find_foreign(foreign_names, sizeof foreign_names / sizeof *foreign_names, name->text);

    if (!f || (f->label == DIAG_label_did_you_mean && is_assigned(d->span)))
        return false;
    label_foreign(s, d, f);
    if (strcmp(f->name, "true") == 0 || strcmp(f->name, "false") == 0)
        diag_edit(s->diags, d, d->span, f->argument);
    return true;
}

static void suggest_variable(Sema *s, Diag *d, Str name)
{
    Guess g = guess_init(name);

    for (size_t i = 0; s->in_script && i < s->script_local.cap; i++)
        if (s->script_local.key[i])
            guess_consider(&g, s->script_local.key[i]);
    for (size_t i = 0; i < s->p->var.n; i++) {
        guess_consider(&g, s->p->var.at[i]->name);
        if (s->p->var.at[i]->alias)
            guess_consider(&g, s->p->var.at[i]->alias);
    }
    for (size_t i = 0; i < s->defines.cap; i++)
        if (s->defines.key[i])
            guess_consider(&g, s->defines.key[i]);
    guess_add_label(s->diags, d, &g);
    if (g.best)
        scope_note_declared(s, d, g.best);
}

// Records d if it is the first report of an unknown name.  If a script knows no name of its machine, the checker later adds a note to d
// that the script may belong to another machine.
static void record_first_unknown(Sema *s, Diag *d)
{
    if (!s->unknown)
        s->unknown = d;
}

// Whether a name contains letters outside ASCII.  The lexer has reported them.
static bool has_foreign_letter(Str name)
{
    for (size_t i = 0; i < name->len; i++)
        if (name->text[i] & 0x80)
            return true;
    return false;
}

// Reports a name that scope_find_variable does not find; once per name.
void scope_report_unknown(Sema *s, Str name, Span span)
{
    const Element *unlisted = s->sv ? map_find(&s->sv->by_name, name) : NULL;
    const State *state = map_find(&s->p->state_by_name, name);
    const SmBuiltinInfo *fn = scope_find_function(s, name);
    Diag *d;

    if (s->no_elements || map_find(&s->lost->word, name) || has_foreign_letter(name) || !add_reported_name(&s->unknown_name, name))
        return;
    if (s->in_script && report_member_name(s, name, span, false))
        return;
    if (fn && !unlisted) {
        diag_report(s->diags, DIAG_function_without_call, span, name->text, name->text, fn->usage);
        return;
    }
    d = diag_report(s->diags, DIAG_unknown_element, span, name->text);
    record_first_unknown(s, d);
    if (unlisted) {
        diag_label(s->diags, d, DIAG_label_list_it, sm_type_info[unlisted->type].spelling, unlisted->name->text);
        diag_note(s->diags, d, unlisted->span, DIAG_note_declared_here, unlisted->name->text);
    } else if (state && s->in_script) {
        diag_label(s->diags, d, DIAG_label_tests_for_state, state->name->text, s->p->s ? s->p->s->report_name->text : "S", state->name->text);
    } else if (state) {
        diag_label(s->diags, d, DIAG_label_is_a_state, state->name->text, state->name->text, s->p->s ? s->p->s->report_name->text : "S",
                   state->name->text);
    } else if (!suggest_spelling(s, d, name) && use_up_guess(&s->guesses))
        suggest_variable(s, d, name);
}

// ---- states ----

// Returns the state, or NULL after reporting the name; once per name.
State *scope_find_state(Sema *s, const Program *m, Str name, Span span)
{
    State *state = map_find(&m->state_by_name, name);
    Str similar;
    Diag *d;

    s->knows_a_name |= state != NULL;
    if (state || map_find(&s->lost->word, name) || !add_reported_name(&s->unknown_state, name))
        return state;
    if (s->in_script && m == s->p && report_member_name(s, name, span, true))
        return NULL;
    d = diag_report(s->diags, DIAG_unknown_state, span, name->text);
    record_first_unknown(s, d);
    label_state_of_machine(s, m, name, span, d);
    if (d->label || s->guesses == 0)
        return NULL;
    similar = suggest_state(s->diags, d, &s->guesses, m, name);
    if (similar)
        diag_note(s->diags, d, ((State *)map_find(&m->state_by_name, similar))->span, DIAG_note_declared_here, similar->text);
    else if (strcmp(name->text, "all_states") == 0)
        diag_label(s->diags, d, DIAG_label_all_states_target);
    else if (!s->in_script && !scope_find_variable(s, name))
        diag_label(s->diags, d, DIAG_label_add_section, name->text);
    return NULL;
}

// ---- functions ----

const SmBuiltinInfo *scope_find_function(const Sema *s, Str name)
{
    return map_find(&s->functions, name);
}

void scope_report_unknown_function(Sema *s, Str name, Span span)
{
    Guess g = guess_init(name);
    const char *dot = strrchr(name->text, '.');                   // time.sleep
    const ForeignName *foreign = find_foreign(foreign_functions, sizeof foreign_functions / sizeof *foreign_functions, dot ? dot + 1 : name->text);
    Diag *d;

    if (map_find(&s->lost->word, name) || !add_reported_name(&s->unknown_function, name))
        return;
    if (scope_find_variable(s, name) || map_find(&s->defines, name)) {
        d = diag_report(s->diags, DIAG_not_a_function, span, name->text);
        diag_label(s->diags, d, DIAG_label_not_a_function, name->text, name->text);
        scope_note_declared(s, d, name);
        return;
    }
    d = diag_report(s->diags, DIAG_unknown_function, span, name->text);
    for (int i = 0; i < SM_FN_COUNT && !foreign; i++)
        guess_consider(&g, str_c(s->strings, sm_builtin_info[i].name));
    guess_add_label(s->diags, d, &g);
    if (foreign)
        label_foreign(s, d, foreign);
    if (!s->functions_noted && (!foreign || foreign->label == DIAG_label_no_such_function)) {
        const char *list[2] = {"", ""};           // the names of the functions: [0] of values, [1] of windows
        for (int i = 0; i < SM_FN_COUNT; i++) {
            const char **to = &list[sm_builtin_info[i].is_roll];
            *to = format_in(s->arena, "%s%s%s", *to, **to ? ", " : "", sm_builtin_info[i].name);
        }
        diag_note(s->diags, d, (Span){0}, DIAG_note_functions, list[0], list[1]);
        s->functions_noted = true;
    }
}
