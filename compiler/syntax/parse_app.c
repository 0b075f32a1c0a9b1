// SPDX-License-Identifier: Apache-2.0
// Parses an application: its sections, options, start values, executors, rate groups and tasks (docs/config.md 10).
#include "compiler/syntax/hints.h"
#include "compiler/syntax/parser_app.h"

static bool at_section_end(const Parser *p) { return p->tok.kind == TOK_HEADER || p->tok.kind == TOK_END; }

// After an error in the entry that began at `at`: skips to the next line, and always makes progress.
static void recover_entry(Parser *p, AstApp *app, uint32_t at)
{
    if (!p->failed)
        return;
    app->lost = true;
    if (p->tok.at == at && !at_section_end(p))
        parser_next(p);
    parser_skip_line(p);
    p->failed = false;
}

// Reports text that begins no entry, with the nearest of the words that begin one.
static void report_unknown_entry(Parser *p, DiagCode code, const char *const *words, size_t n)
{
    const char *near = p->tok.kind == TOK_NAME ? str_nearest(p->tok.text->text, words, n) : NULL;
    Diag *d;

    if (p->tok.kind == TOK_ERROR)
        p->failed = true;
    d = parser_fail(p, code, parser_here(p), parser_describe(p, &p->tok));
    if (near)
        diag_label(p->diags, d, DIAG_label_did_you_mean, near);
    parser_next(p);
}

// ---- [options] ----

static const struct { bool element, file; AppMeasure amount; const char *form; } options[] = {
#define APP_OPTION(name, element, file, amount, form) {element, file, APP_##amount, form},
#include "compiler/syntax/app.def"
};

static const char *const option_words[] = {
#define APP_OPTION(name, element, file, amount, form) #name,
#include "compiler/syntax/app.def"
};

static void add_option(Parser *p, AstApp *app, AstAppOption o)
{
    for (size_t i = 0; i < app->options.n; i++)
        if (app->options.at[i].kind == o.kind) {
            Diag *d = parser_report(p, DIAG_app_option_twice, o.name_span, app_option_name(o.kind));
            diag_note(p->diags, d, app->options.at[i].name_span, DIAG_note_first_here);
            return;
        }
    vec_push(p->arena, &app->options, o);
}

static void parse_option(Parser *p, AstApp *app)
{
    AstAppOption o = {0};
    const char *form;

    if (!app_at_option(p, &o.kind)) {
        report_unknown_entry(p, DIAG_app_option_unknown, option_words, AST_APP_OPTION_COUNT);
        return;
    }
    form = options[o.kind].form;
    o.name_span = parser_here(p);
    parser_next(p);
    if (options[o.kind].element && !app_parse_name(p, &o.element, "the name of an element", form))
        return;
    if (options[o.kind].file && !app_parse_file(p, &o.file, form))
        return;
    if (options[o.kind].amount != APP_NOTHING && !app_parse_amount(p, &o.amount, options[o.kind].amount, form))
        return;
    add_option(p, app, o);
    app_parse_allows(p, o.name_span.at, app);
}

// A line of [options] in another section.
static bool at_stray_option(const Parser *p)
{
    AstAppOptionKind kind;
    TokenKind expected;

    if (p->ahead.first || !app_at_option(p, &kind))
        return false;
    expected = options[kind].file ? TOK_TEXT : options[kind].element ? TOK_NAME : TOK_NUMBER;
    return p->ahead.kind == expected;
}

// Reported once per application: the header of these options is missing.
static void parse_stray_option(Parser *p, AstApp *app)
{
    if (!app->strayed)
        diag_label(p->diags, parser_report(p, DIAG_app_option_place, parser_here(p), p->tok.text->text), DIAG_label_above, "[options]");
    app->strayed = app->lost = true;
    parse_option(p, app);
}

// ---- [start] ----

static void parse_start_value(Parser *p, AstApp *app)
{
    AstStmt *s = ARENA_NEW(p->arena, AstStmt);
    AstWord name = {0};

    if (at_stray_option(p)) {
        parse_stray_option(p, app);
        return;
    }
    s->kind = AST_ASSIGN;
    if (p->tok.kind != TOK_NAME) {
        if (p->tok.kind == TOK_ERROR)
            p->failed = true;
        diag_label(p->diags, parser_fail(p, DIAG_app_form, parser_here(p), "the name of an element", parser_describe(p, &p->tok)),
                   DIAG_label_as_in, "engineMode = 2");
        return;
    }
    name.text = p->tok.text;                      // an element can have the name of a word of another section
    name.span = parser_here(p);
    parser_next(p);
    s->name = name.text;
    s->span = s->name_span = name.span;
    if (p->tok.kind != TOK_ASSIGN) {
        app_report_form(p, "'='", "engineMode = 2");
        return;
    }
    parser_next(p);
    s->value = parse_value_of(p, false);
    s->span = parser_since(p, s->span.at);
    if (!p->failed && !p->tok.first && !at_section_end(p))
        hint_explain(p, HINT_AT_END, NULL);
    if (!p->failed)
        vec_push(p->arena, &app->start, s);
}

// ---- executors ----

static const struct { bool named, file; AppPlace place; const char *form; } tasks[] = {
#define APP_ON_task    APP_ON_TASK
#define APP_ON_machine APP_ON_MACHINE
#define APP_ON_inputs  APP_ON_INPUTS
#define APP_ON_outputs APP_ON_OUTPUTS
#define APP_ON_log     APP_ON_SERVICE
#define APP_ON_keep    APP_ON_SERVICE
#define APP_TASK(word, named, file, option, form) {named, file, APP_ON_##word, form},
#include "compiler/syntax/app.def"
};

static const char *const task_words[] = {
    "every", "at",
#define APP_TASK(word, named, file, option, form) #word,
#include "compiler/syntax/app.def"
};

// Adds the current task, whose kind app_at_task has returned.
static void parse_task(Parser *p, AstApp *app, AstAppTaskKind kind, AstAppRate *r)
{
    AstAppTask t = {0};
    uint32_t at = p->tok.at;

    t.kind = kind;
    t.name.text = p->tok.text;
    t.name.span = parser_here(p);
    parser_next(p);
    if (tasks[kind].named && !app_parse_name(p, &t.name, kind == AST_TASK_task ? "the task's name" : "the machine's name",
                                            tasks[kind].form))
        return;
    if (tasks[kind].file && !app_parse_file(p, &t.file, tasks[kind].form))
        return;
    app_parse_annotations(p, tasks[kind].place, t.name.text->text, at, &t.annotations, app);
    if (!p->failed && r)
        vec_push(p->arena, &r->tasks, t);
}

// every 10 ms:   at 100 Hz:
static void parse_rate(Parser *p, AstAppExecutor *e)
{
    AstAppRate r = {0};
    uint32_t at = p->tok.at;
    bool every = p->tok.text->text[0] == 'e';
    const char *form = every ? "every 10 ms:" : "at 100 Hz:";

    parser_next(p);
    if (!app_parse_amount(p, &r.amount, every ? APP_TIME : APP_FREQUENCY, form))
        return;
    if (p->tok.kind == TOK_COLON)
        parser_next(p);
    else
        app_report_form(p, "':'", form);
    r.span = parser_since(p, at);
    vec_push(p->arena, &e->rates, r);
}

static void parse_entry(Parser *p, AstApp *app, AstAppExecutor *e)
{
    AstAppTaskKind kind;

    if (at_stray_option(p)) {
        parse_stray_option(p, app);
    } else if (app_at_rate(p)) {
        parse_rate(p, e);
    } else if (!app_at_task(p, &kind)) {
        report_unknown_entry(p, DIAG_app_task_unknown, task_words, sizeof task_words / sizeof *task_words);
    } else {
        if (e->rates.n == 0 && !e->lost)
            diag_label(p->diags, parser_report(p, DIAG_app_task_without_rate, parser_here(p), parser_text(p, parser_here(p))),
                       DIAG_label_as_in, "every 10 ms:");
        e->lost = e->lost || e->rates.n == 0;
        parse_task(p, app, kind, e->rates.n ? &e->rates.at[e->rates.n - 1] : NULL);
    }
}

static void parse_executor(Parser *p, AstApp *app, AstWord name, Span header)
{
    AstAppExecutor *e = ARENA_NEW(p->arena, AstAppExecutor);
    TokenKind reserved;
    size_t first = app->allows.n, own;

    e->name = name;
    e->header = header;
    if (lex_is_header_name(name.text->text, name.text->len) &&          // else reported as a header
        (!lex_is_identifier(name.text->text, name.text->len) || lex_is_reserved(name.text, &reserved)))
        parser_report(p, DIAG_executor_name, name.span, name.text->text);
    vec_push(p->arena, &app->executors, e);
    app_parse_annotations(p, APP_ON_EXECUTOR, name.text->text, header.at, &e->annotations, app);
    own = app->allows.n;
    e->lost = e->lost || p->failed;
    recover_entry(p, app, header.at);
    while (!at_section_end(p)) {
        uint32_t at = p->tok.at;
        parse_entry(p, app, e);
        e->lost = e->lost || p->failed;
        recover_entry(p, app, at);
    }
    while (own-- > first)                         // the whole section
        app->allows.at[own].covers.len = p->tok.at - header.at;
}

// ---- sections ----

static void parse_entries(Parser *p, AstApp *app, void (*entry)(Parser *p, AstApp *app))
{
    while (!at_section_end(p)) {
        uint32_t at = p->tok.at;
        entry(p, app);
        recover_entry(p, app, at);
    }
}

// A rate among the options begins an executor whose header is missing or misspelt.
static void parse_app_options(Parser *p, AstApp *app, AstWord name, Span header)
{
    while (!at_section_end(p) && !app_at_rate(p)) {
        uint32_t at = p->tok.at;
        parse_option(p, app);
        recover_entry(p, app, at);
    }
    if (at_section_end(p))
        return;
    app->lost = true;
    if (strcmp(name.text->text, "options") == 0)
        diag_label(p->diags, parser_report(p, DIAG_app_option_unknown, parser_here(p), parser_describe(p, &p->tok)), DIAG_label_above,
                   "[flight]");
    parse_executor(p, app, name, header);
}

// A section that begins with a line of [options] or of [start] has a misspelt name.
static const char *guess_section(const Parser *p)
{
    AstAppOptionKind option;

    if (p->tok.kind == TOK_NAME && p->ahead.kind == TOK_ASSIGN)
        return "start";
    if (p->ahead.first || !app_at_option(p, &option) || (options[option].file && p->ahead.kind != TOK_TEXT))
        return NULL;
    return "options";
}

static bool check_first_section(Parser *p, const Span *seen, Span header, const char *name)
{
    if (!seen->src)
        return true;
    diag_note(p->diags, parser_report(p, DIAG_section_repeated, header, name), *seen, DIAG_note_first_here);
    return false;
}

static bool is_section_of(Parser *p, const AstWord *name, Span header, const char *which)
{
    const char *meant = guess_section(p);

    if (strcmp(name->text->text, which) == 0)
        return true;
    if (!meant || strcmp(meant, which) != 0 || strcmp(name->text->text, "options") == 0 || strcmp(name->text->text, "start") == 0)
        return false;
    diag_label(p->diags, parser_report(p, DIAG_app_section_misspelt, header, name->text->text, format_in(p->arena, "[%s]", which)),
               DIAG_label_did_you_mean,
               format_in(p->arena, "[%s]", which));
    return true;
}

void parse_app_section(Parser *p, AstApp *app)
{
    AstWord name = {p->tok.text, {p->lex.src, p->tok.at + 1, p->tok.len > 2 ? p->tok.len - 2 : 0}};
    Span header = parser_here(p);

    p->failed = false;
    parser_next(p);
    if (is_section_of(p, &name, header, "options")) {
        if (check_first_section(p, &app->options_header, header, "options"))
            app->options_header = header;
        parse_app_options(p, app, name, header);
    } else if (is_section_of(p, &name, header, "start")) {
        if (check_first_section(p, &app->start_header, header, "start"))
            app->start_header = header;
        parse_entries(p, app, parse_start_value);
    } else {
        parse_executor(p, app, name, header);
    }
}
