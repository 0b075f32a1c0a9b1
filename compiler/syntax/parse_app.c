// SPDX-License-Identifier: Apache-2.0
// Parses an application: its sections, options, start values, executors, rate groups and tasks (docs/config.md 10).
#include "compiler/syntax/hints.h"
#include "compiler/syntax/parser_app.h"

static bool is_at_section_end(const Parser *p) { return p->tok.kind == TOK_HEADER || p->tok.kind == TOK_END; }

// After an error in the entry that began at `at`: skips to the next line, and at least one token, so that parsing never loops.
static void recover_entry(Parser *p, AstApp *app, uint32_t at)
{
    if (!p->failed)
        return;
    app->lost = true;
    if (p->tok.at == at && !is_at_section_end(p))
        parser_advance(p);
    parser_skip_line(p);
    p->failed = false;
}

// Reports text that does not begin an entry. Suggests the most similar of `words`, which begin one.
static void report_unknown_entry(Parser *p, DiagCode code, const char *const *words, size_t n)
{
    const char *near = p->tok.kind == TOK_NAME ? str_nearest(p->tok.text->text, words, n) : NULL;
    Diag *d;

    if (p->tok.kind == TOK_ERROR)
        p->failed = true;
    d = parser_fail(p, code, parser_token_span(p), parser_describe(p, &p->tok));
    if (near)
        diag_label(p->diags, d, DIAG_label_did_you_mean, near);
    parser_advance(p);
}

// ---- [options] ----

static const struct { bool element, file; AppMeasure amount; const char *example; } options[] = {
#define APP_OPTION(name, element, file, amount, example) {element, file, APP_##amount, example},
#include "compiler/syntax/app.def"
};

static const char *const option_words[] = {
#define APP_OPTION(name, element, file, amount, example) #name,
#include "compiler/syntax/app.def"
};

static void parse_option(Parser *p, AstApp *app)
{
    AstAppOption o = {0};
    const AstAppOption *first = NULL;
    const char *example;

    if (!app_match_option(p, &o.kind)) {
        report_unknown_entry(p, DIAG_app_option_unknown, option_words, AST_APP_OPTION_COUNT);
        return;
    }
    example = options[o.kind].example;
    o.name_span = parser_token_span(p);
    parser_advance(p);
    if (options[o.kind].element && !app_parse_name(p, &o.element, "the name of an element", example))
        return;
    if (options[o.kind].file && !app_parse_file(p, &o.file, example))
        return;
    if (options[o.kind].amount != APP_NOTHING && !app_parse_amount(p, &o.amount, options[o.kind].amount, example))
        return;
    for (size_t i = 0; i < app->options.n && !first; i++)
        if (app->options.at[i].kind == o.kind)
            first = &app->options.at[i];
    if (first)
        diag_note(p->diags, parser_report(p, DIAG_app_option_twice, o.name_span, app_option_name(o.kind)), first->name_span,
                  DIAG_note_first_here);
    else
        vec_push(p->arena, &app->options, o);
    app_parse_allows(p, o.name_span.at, app);
}

// Whether the next token begins a line of [options], which is misplaced in the current section.
static bool is_at_stray_option(const Parser *p)
{
    AstAppOptionKind kind;
    TokenKind expected;

    if (p->ahead.first || !app_match_option(p, &kind))
        return false;
    expected = options[kind].file ? TOK_TEXT : options[kind].element ? TOK_NAME : TOK_NUMBER;
    return p->ahead.kind == expected;
}

// Parses an option that is in another section. Reports only the first of an application, because the header [options] is probably missing.
static void parse_stray_option(Parser *p, AstApp *app)
{
    if (!app->strayed)
        diag_label(p->diags, parser_report(p, DIAG_app_option_place, parser_token_span(p), p->tok.text->text), DIAG_label_above, "[options]");
    app->strayed = app->lost = true;
    parse_option(p, app);
}

// ---- [start] ----

static void parse_start_value(Parser *p, AstApp *app)
{
    AstStmt *s = ARENA_NEW(p->arena, AstStmt);
    AstWord name = {0};

    if (is_at_stray_option(p)) {
        parse_stray_option(p, app);
        return;
    }
    s->kind = AST_ASSIGN;
    if (p->tok.kind != TOK_NAME) {
        if (p->tok.kind == TOK_ERROR)
            p->failed = true;
        diag_label(p->diags, parser_fail(p, DIAG_app_form, parser_token_span(p), "the name of an element", parser_describe(p, &p->tok)),
                   DIAG_label_as_in, "engineMode = 2");
        return;
    }
    name.text = p->tok.text;                      // the element's name may equal a keyword of another section
    name.span = parser_token_span(p);
    parser_advance(p);
    s->name = name.text;
    s->span = s->name_span = name.span;
    if (p->tok.kind != TOK_ASSIGN) {
        app_report_expected(p, "'='", "engineMode = 2");
        return;
    }
    parser_advance(p);
    s->value = parse_value_of(p, false);
    s->span = parser_span_since(p, s->span.at);
    if (!p->failed && !p->tok.first && !is_at_section_end(p))
        hint_explain(p, HINT_AT_END, NULL);
    if (!p->failed)
        vec_push(p->arena, &app->start, s);
}

// ---- executors ----

static const struct { bool named, file; AppAnnotationTarget target; const char *example; } tasks[] = {
#define APP_ON_task    APP_ON_TASK
#define APP_ON_machine APP_ON_MACHINE
#define APP_ON_inputs  APP_ON_INPUTS
#define APP_ON_outputs APP_ON_OUTPUTS
#define APP_ON_receive APP_ON_INPUTS
#define APP_ON_send    APP_ON_SERVICE
#define APP_ON_log     APP_ON_SERVICE
#define APP_ON_keep    APP_ON_SERVICE
#define APP_TASK(word, named, file, option, example) {named, file, APP_ON_##word, example},
#include "compiler/syntax/app.def"
};

static const char *const task_words[] = {
    "every", "at",
#define APP_TASK(word, named, file, option, example) #word,
#include "compiler/syntax/app.def"
};

// Parses the current task, whose kind app_match_task has returned, and adds it to r.
static void parse_task(Parser *p, AstApp *app, AstAppTaskKind kind, AstAppRate *r)
{
    AstAppTask t = {0};
    uint32_t at = p->tok.at;

    t.kind = kind;
    t.name.text = p->tok.text;
    t.name.span = parser_token_span(p);
    parser_advance(p);
    if (tasks[kind].named && !app_parse_name(p, &t.name, kind == AST_TASK_task ? "the task's name" : "the machine's name",
                                            tasks[kind].example))
        return;
    if (tasks[kind].file && !app_parse_file(p, &t.file, tasks[kind].example))
        return;
    app_parse_annotations(p, tasks[kind].target, t.name.text->text, at, &t.annotations, app);
    if (kind == AST_TASK_machine && !p->failed && p->tok.kind == TOK_LBRACE) {
        app_parse_bindings(p, &t.bindings);
        app_parse_annotations(p, tasks[kind].target, t.name.text->text, at, &t.annotations, app);
    }
    if (!p->failed && r)
        vec_push(p->arena, &r->tasks, t);
}

// Parses the line that begins a rate group: every 10 ms: or at 100 Hz:
static void parse_rate(Parser *p, AstAppExecutor *e)
{
    AstAppRate r = {0};
    uint32_t at = p->tok.at;
    bool every = p->tok.text->text[0] == 'e';
    const char *example = every ? "every 10 ms:" : "at 100 Hz:";

    parser_advance(p);
    if (!app_parse_amount(p, &r.amount, every ? APP_TIME : APP_FREQUENCY, example))
        return;
    if (p->tok.kind == TOK_COLON)
        parser_advance(p);
    else
        app_report_expected(p, "':'", example);
    r.span = parser_span_since(p, at);
    vec_push(p->arena, &e->rates, r);
}

static void parse_entry(Parser *p, AstApp *app, AstAppExecutor *e)
{
    AstAppTaskKind kind;

    if (is_at_stray_option(p)) {
        parse_stray_option(p, app);
    } else if (app_is_at_rate(p)) {
        parse_rate(p, e);
    } else if (!app_match_task(p, &kind)) {
        report_unknown_entry(p, DIAG_app_task_unknown, task_words, sizeof task_words / sizeof *task_words);
    } else {
        if (e->rates.n == 0 && !e->lost)
            diag_label(p->diags, parser_report(p, DIAG_app_task_without_rate, parser_token_span(p), parser_text(p, parser_token_span(p))),
                       DIAG_label_as_in, "every 10 ms:");
        e->lost = e->lost || e->rates.n == 0;
        parse_task(p, app, kind, e->rates.n ? &e->rates.at[e->rates.n - 1] : NULL);
    }
}

// Parses the section of an executor: its annotations, and rates with their tasks.
static void parse_executor(Parser *p, AstApp *app, AstWord name, Span header)
{
    AstAppExecutor *e = ARENA_NEW(p->arena, AstAppExecutor);
    TokenKind reserved;
    size_t first = app->allows.n, own;

    e->name = name;
    e->header = header;
    if (lex_is_header_name(name.text->text, name.text->len) &&          // the lexer has reported any other header
        (!lex_is_identifier(name.text->text, name.text->len) || lex_find_reserved(name.text, &reserved)))
        parser_report(p, DIAG_executor_name, name.span, name.text->text);
    vec_push(p->arena, &app->executors, e);
    app_parse_annotations(p, APP_ON_EXECUTOR, name.text->text, header.at, &e->annotations, app);
    own = app->allows.n;
    e->lost = e->lost || p->failed;
    recover_entry(p, app, header.at);
    while (!is_at_section_end(p)) {
        uint32_t at = p->tok.at;
        parse_entry(p, app, e);
        e->lost = e->lost || p->failed;
        recover_entry(p, app, at);
    }
    while (own-- > first)                         // an @allow after the header covers the whole section
        app->allows.at[own].covers.len = p->tok.at - header.at;
}

// ---- sections ----

// Parses [options]. If a rate follows the options, it begins an executor whose header is missing or misspelt; parses that as well.
static void parse_app_options(Parser *p, AstApp *app, AstWord name, Span header)
{
    while (!is_at_section_end(p) && !app_is_at_rate(p)) {
        uint32_t at = p->tok.at;
        parse_option(p, app);
        recover_entry(p, app, at);
    }
    if (is_at_section_end(p))
        return;
    app->lost = true;
    if (strcmp(name.text->text, "options") == 0)
        diag_label(p->diags, parser_report(p, DIAG_app_option_unknown, parser_token_span(p), parser_describe(p, &p->tok)), DIAG_label_above,
                   "[flight]");
    parse_executor(p, app, name, header);
}

// Returns false after reporting a second section with this name; `seen`: the header of the first one, its src is NULL if this section is the first.
static bool check_section_is_first(Parser *p, const Span *seen, Span header, const char *name)
{
    if (!seen->src)
        return true;
    diag_note(p->diags, parser_report(p, DIAG_section_repeated, header, name), *seen, DIAG_note_first_here);
    return false;
}

// Whether a section is the section `which`, "options" or "start". The name decides; if the section has another name, its first line decides, and
// the name, which is probably misspelt, is reported.
static bool match_section(Parser *p, const AstWord *name, Span header, const char *which)
{
    const char *meant = NULL;
    AstAppOptionKind option;

    if (strcmp(name->text->text, which) == 0)
        return true;
    if (p->tok.kind == TOK_NAME && p->ahead.kind == TOK_ASSIGN)
        meant = "start";
    else if (!p->ahead.first && app_match_option(p, &option) && (!options[option].file || p->ahead.kind == TOK_TEXT))
        meant = "options";
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
    Span header = parser_token_span(p);

    p->failed = false;
    parser_advance(p);
    if (match_section(p, &name, header, "options")) {
        if (check_section_is_first(p, &app->options_header, header, "options"))
            app->options_header = header;
        parse_app_options(p, app, name, header);
    } else if (match_section(p, &name, header, "start")) {
        if (check_section_is_first(p, &app->start_header, header, "start"))
            app->start_header = header;
        while (!is_at_section_end(p)) {
            uint32_t at = p->tok.at;
            parse_start_value(p, app);
            recover_entry(p, app, at);
        }
    } else {
        parse_executor(p, app, name, header);
    }
}
