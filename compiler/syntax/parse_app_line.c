// SPDX-License-Identifier: Apache-2.0
// Parses the parts of an application's lines: words, file names, amounts with their units, annotations.
#include "compiler/syntax/hints.h"
#include "compiler/syntax/parser_app.h"

#include "compiler/syntax/number.h"

// ---- words ----

static const char *const options[] = {
#define APP_OPTION(name, element, file, amount, example) #name,
#include "compiler/syntax/app.def"
};

static const char *const tasks[] = {
#define APP_TASK(word, named, file, option, example) #word,
#include "compiler/syntax/app.def"
};

static const char *const annotations[] = {
#define APP_ANNOTATION(name, takes, executor, task, machine, outputs, service, example) #name,
#include "compiler/syntax/app.def"
};

const char *app_option_name(AstAppOptionKind kind) { return options[kind]; }
const char *app_task_word(AstAppTaskKind kind) { return tasks[kind]; }
const char *app_annotation_name(AstAppAnnotationKind kind) { return annotations[kind]; }

// Returns the option that the task requires; AST_APP_OPTION_COUNT if it requires none.
AstAppOptionKind app_find_required_option(AstAppTaskKind kind)
{
    static const AstAppOptionKind needs[] = {
#define AST_APP_COUNT AST_APP_OPTION_COUNT
#define APP_TASK(word, named, file, option, example) AST_APP_##option,
#include "compiler/syntax/app.def"
#undef AST_APP_COUNT
    };
    return needs[kind];
}

// Returns the index of the next token among n words; n if it is another one.
static int find_word(const Parser *p, const char *const *words, int n)
{
    int i = 0;

    while (i < n && (p->tok.kind != TOK_NAME || strcmp(p->tok.text->text, words[i]) != 0))
        i++;
    return i;
}

// Whether the next word begins a line of [options]; sets *kind to its option.
bool app_match_option(const Parser *p, AstAppOptionKind *kind)
{
    *kind = (AstAppOptionKind)find_word(p, options, AST_APP_OPTION_COUNT);
    return *kind < AST_APP_OPTION_COUNT;
}

// Whether the next word begins a task of a rate group; sets *kind to its kind.
bool app_match_task(const Parser *p, AstAppTaskKind *kind)
{
    *kind = (AstAppTaskKind)find_word(p, tasks, AST_APP_TASK_COUNT);
    return *kind < AST_APP_TASK_COUNT;
}

// Whether the next tokens begin a rate, with `every` or `at`.
bool app_is_at_rate(const Parser *p)
{
    static const char *const words[] = {"every", "at"};

    return find_word(p, words, 2) < 2;
}

// Whether the next token begins another entry on a new line, so that it is not the name or file that the current entry lacks.
static bool begins_entry(const Parser *p)
{
    AstAppOptionKind option;
    AstAppTaskKind task;

    return p->tok.first && (app_match_option(p, &option) || app_match_task(p, &task) || app_is_at_rate(p));
}

// ---- parts of a line ----

// Reports that the source lacks `expected` at the next token, and shows `example`, a correct line.
void app_report_expected(Parser *p, const char *expected, const char *example)
{
    if (p->tok.kind == TOK_ERROR)
        p->failed = true;
    diag_label(p->diags, parser_fail(p, DIAG_app_form, parser_missing_span(p), expected, parser_describe_found(p)),
               DIAG_label_as_in, example);
}

bool app_parse_name(Parser *p, AstWord *into, const char *expected, const char *example)
{
    TokenKind reserved;

    if (p->tok.kind == TOK_NAME && !begins_entry(p)) {
        into->text = p->tok.text;
        into->span = parser_token_span(p);
        parser_advance(p);
        if (p->tok.kind == TOK_MINUS && p->tok.at == into->span.at + into->span.len)
            diag_label(p->diags, parser_fail(p, DIAG_expected_end, parser_token_span(p), parser_describe(p, &p->tok)),
                       DIAG_label_name_letters);
        return !p->failed;
    }
    if (!p->tok.first && p->tok.text && p->tok.kind != TOK_TEXT && lex_find_reserved(p->tok.text, &reserved))
        parser_fail(p, DIAG_name_reserved, parser_token_span(p), p->tok.text->text);
    else
        app_report_expected(p, expected, example);
    return false;
}

bool app_parse_file(Parser *p, AstWord *into, const char *example)
{
    if (p->tok.kind != TOK_TEXT) {
        app_report_expected(p, "the name of a file in quotes", example);
        return false;
    }
    into->text = p->tok.text;
    into->span = parser_token_span(p);
    parser_advance(p);
    return true;
}

typedef struct Unit { const char *spelling; AppMeasure of; uint64_t factor; } Unit;

static const Unit units[] = {
#define APP_UNIT(spelling, of, factor) {spelling, APP_##of, factor},
#include "compiler/syntax/app.def"
};

static const char *const unit_lists[] = {"", "", "ns, us, ms or s", "Hz or kHz", "B or KB"};

// Returns the unit that the word at the next token probably means, such as s for `seconds`; NULL if it means no unit of this measure.
static const char *find_unit_synonym(Parser *p, AppMeasure of)
{
    const char *ours = p->tok.kind == TOK_NAME ? hint_find_synonym(HINT_UNITS, p->tok.text->text) : NULL;

    for (size_t i = 0; ours && i < sizeof units / sizeof *units; i++)
        if (units[i].of == of && strcmp(units[i].spelling, ours) == 0)
            return ours;
    return NULL;
}

// `every` takes a time and `at` a frequency. If the unit u after the number fits the other keyword, returns the line with that keyword;
// else NULL. `example` begins with the keyword that was written.
static const char *format_other_rate(Parser *p, const Unit *u, Span number, const char *example)
{
    const char *word = NULL;

    if (u && u->of == APP_FREQUENCY && strncmp(example, "every ", 6) == 0)
        word = "at";
    else if (u && u->of == APP_TIME && strncmp(example, "at ", 3) == 0)
        word = "every";
    return word ? format_in(p->arena, "%s %s %s", word, parser_text(p, number), u->spelling) : NULL;
}

// Parses the unit after a number. Returns false after reporting that the unit is missing or belongs to another measure.
static bool parse_unit(Parser *p, AstAmount *into, Span number, const char *example)
{
    const Unit *u = NULL;
    const char *near;
    Diag *d;

    for (size_t i = 0; p->tok.kind == TOK_NAME && !u && i < sizeof units / sizeof *units; i++)
        if (strcmp(p->tok.text->text, units[i].spelling) == 0)
            u = &units[i];
    if (u && u->of == into->of) {
        into->factor = u->factor;
        parser_advance(p);
        return true;
    }
    if (p->tok.kind != TOK_NAME || begins_entry(p)) {
        app_report_expected(p, format_in(p->arena, "a unit: %s", unit_lists[into->of]), example);
        return false;
    }
    d = parser_fail(p, DIAG_unit_unknown, parser_token_span(p), p->tok.text->text, unit_lists[into->of]);
    near = format_other_rate(p, u, number, example);
    if (!near)
        near = find_unit_synonym(p, into->of);
    if (near)
        diag_label(p->diags, d, DIAG_label_did_you_mean, near);
    return false;
}

bool app_parse_amount(Parser *p, AstAmount *into, AppMeasure of, const char *example)
{
    uint32_t at = p->tok.at;
    Span number;

    if (p->tok.kind != TOK_NUMBER) {
        app_report_expected(p, "a number", example);
        return false;
    }
    into->of = of;
    into->factor = 1;
    into->is_exact = number_to_decimal(p->lex.src->text + at, p->tok.len, &into->digits, &into->exponent);
    number = parser_token_span(p);
    parser_advance(p);
    if (of != APP_NUMBER && !parse_unit(p, into, number, example))
        return false;
    into->span = parser_span_since(p, at);
    return true;
}

// ---- annotations ----

typedef enum AppArguments { TAKES_NOTHING, TAKES_ELEMENT, TAKES_STATE, TAKES_NUMBER, TAKES_OVERRUN } AppArguments;

static const struct { AppArguments takes; bool on[APP_ANNOTATION_TARGETS]; const char *example; } rows[] = {
#define APP_ANNOTATION(name, takes, executor, task, machine, outputs, service, example) \
    {TAKES_##takes, {executor, task, machine, outputs, service, false}, example},
#include "compiler/syntax/app.def"
};

// Parses the argument of @overrun: `skip`, or `catch_up` and a number. Returns false after reporting an error.
static bool parse_overrun(Parser *p, AstAppAnnotation *a)
{
    const char *example = rows[a->kind].example;

    if (p->tok.kind != TOK_NAME || (strcmp(p->tok.text->text, "skip") != 0 && strcmp(p->tok.text->text, "catch_up") != 0)) {
        app_report_expected(p, "skip or catch_up", example);
        return false;
    }
    app_parse_name(p, &a->word, "", example);
    return a->word.text->text[0] == 's' || app_parse_amount(p, &a->amount, APP_NUMBER, example);
}

// Returns false after reporting an error.
static bool parse_annotation_arguments(Parser *p, AstAppAnnotation *a)
{
    switch (rows[a->kind].takes) {
    case TAKES_NOTHING: return true;
    case TAKES_ELEMENT: return app_parse_name(p, &a->word, "the name of an element", rows[a->kind].example);
    case TAKES_STATE:   return app_parse_name(p, &a->word, "the name of a state", rows[a->kind].example);
    case TAKES_NUMBER:  return app_parse_amount(p, &a->amount, APP_NUMBER, rows[a->kind].example);
    case TAKES_OVERRUN: return parse_overrun(p, a);
    }
    return true;
}

static void parse_annotation(Parser *p, AppAnnotationTarget target, const char *owner, AstAppAnnotations *into)
{
    static const char *const places[] = {"an executor", "a task", "a machine", "'outputs'", "'log', 'keep' and 'send'", "'inputs' and 'receive'"};
    AstAppAnnotation a = {0};
    int row = 0;

    while (row < AST_APP_ANNOTATION_COUNT && strcmp(p->tok.text->text, annotations[row]) != 0)
        row++;
    if (row == AST_APP_ANNOTATION_COUNT) {
        const char *here[AST_APP_ANNOTATION_COUNT + 1];
        Diag *d = parser_fail(p, DIAG_annotation_unknown, parser_token_span(p), p->tok.text->text);
        size_t n = 0;
        for (int i = 0; i < AST_APP_ANNOTATION_COUNT; i++)
            if (rows[i].on[target])
                here[n++] = annotations[i];
        here[n++] = "allow";
        parser_label_annotations(p, d, here, n);
        return;
    }
    a.kind = (AstAppAnnotationKind)row;
    a.span = parser_token_span(p);
    if (!rows[row].on[target])
        parser_fail(p, DIAG_app_annotation_place, a.span, annotations[row], places[target]);
    parser_advance(p);
    if (!parse_annotation_arguments(p, &a) || p->failed)
        return;
    a.span = parser_span_since(p, a.span.at);
    for (size_t i = 0; i < into->n; i++)
        if (into->at[i].kind == a.kind) {
            Diag *d = parser_report(p, DIAG_annotation_repeated, a.span, annotations[row], owner);
            diag_note(p->diags, d, into->at[i].span, DIAG_note_first_here);
            return;
        }
    vec_push(p->arena, into, a);
}

// Parses every @allow that follows an option, which begins at `from`.
void app_parse_allows(Parser *p, uint32_t from, AstApp *app)
{
    while (!p->failed && parser_is_allow(&p->tok)) {
        AstAppAllow a = {parse_allow(p), {0}};

        a.covers = parser_span_since(p, from);
        if (a.is)
            vec_push(p->arena, &app->allows, a);
    }
}

// Parses all annotations that follow; `owner` is the name of the annotated line.
void app_parse_annotations(Parser *p, AppAnnotationTarget target, const char *owner, uint32_t from, AstAppAnnotations *into, AstApp *app)
{
    for (app_parse_allows(p, from, app); !p->failed && p->tok.kind == TOK_ANNOTATION; app_parse_allows(p, from, app))
        parse_annotation(p, target, owner, into);
}
