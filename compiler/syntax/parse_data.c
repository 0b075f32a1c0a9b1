// SPDX-License-Identifier: Apache-2.0
// Parses [data] of a script: a file with recorded data, and what is done with its columns (language.md 8.54).
#include "compiler/syntax/parser.h"

typedef enum DataTakes { TAKES_NOTHING, TAKES_TEXT, TAKES_TEXT_UNIT, TAKES_WORD } DataTakes;

static const struct { const char *word; AstDataSlot slot; DataTakes takes; const char *words; } rows[] = {
#define DATA_WORD(word, slot, takes, words) {#word, AST_DATA_##slot, TAKES_##takes, words},
#include "compiler/syntax/data_words.def"
#undef DATA_WORD
};

enum { ROWS = sizeof rows / sizeof *rows };

// Returns the row of data_words.def with this word; ROWS: none.
static size_t find_row(const char *word)
{
    size_t i = 0;

    while (i < ROWS && strcmp(rows[i].word, word) != 0)
        i++;
    return i;
}

static bool at_compare(const Parser *p) { return p->tok.kind == TOK_ANNOTATION && strcmp(p->tok.text->text, "compare") == 0; }

// Whether the next line is one of [data]. No conditional of a state's section begins as these lines do.
bool parser_at_data(const Parser *p)
{
    if (p->tok.kind != TOK_NAME)
        return at_compare(p);
    if (p->ahead.kind == TOK_ASSIGN || p->ahead.kind == TOK_TEXT)
        return true;
    if (find_row(p->tok.text->text) == ROWS)
        return false;
    return p->ahead.kind == TOK_NAME || p->ahead.kind == TOK_ANNOTATION || p->ahead.kind == TOK_HEADER || p->ahead.kind == TOK_END;
}

// ---- parts of a line ----

// Reports that `expected` is missing after `after`.
static void fail_expected(Parser *p, const char *after, const char *expected)
{
    if (p->tok.kind == TOK_ERROR)
        p->failed = true;
    parser_fail(p, DIAG_data_expected, parser_missing_span(p), expected, after, parser_describe_found(p));
}

static void parse_text(Parser *p, const char *after, const char *expected, Str *text, Span *span)
{
    if (p->tok.kind != TOK_TEXT || p->tok.first) {
        fail_expected(p, after, expected);
        return;
    }
    *text = p->tok.text;
    *span = parser_token_span(p);
    parser_advance(p);
}

// Whether `word` is in a list such as "us, ms, s, min or h".
static bool is_in_list(const char *list, Str word)
{
    for (const char *at = list; *at; at += strcspn(at, " "), at += strspn(at, " "))
        if (strcspn(at, ", ") == word->len && memcmp(at, word->text, word->len) == 0 && strcmp(word->text, "or") != 0)
            return true;
    return false;
}

static void parse_word(Parser *p, const char *after, const char *words, Str *word, Span *span)
{
    if (p->tok.kind != TOK_NAME || p->tok.first || !is_in_list(words, p->tok.text)) {
        fail_expected(p, after, words);
        return;
    }
    *word = p->tok.text;
    *span = parser_token_span(p);
    parser_advance(p);
}

// Reports text that follows a complete line of [data].
static void end_line(Parser *p)
{
    if (!p->failed && !p->tok.first && p->tok.kind != TOK_HEADER && p->tok.kind != TOK_END)
        hint_explain(p, HINT_AT_END, NULL);
}

// ---- lines ----

static void parse_setting(Parser *p, AstData *d, size_t row)
{
    const char *word = rows[row].word;
    AstDataSetting *s = &d->setting[rows[row].slot], was = *s;

    s->word = p->tok.text;
    s->span = parser_token_span(p);
    parser_advance(p);
    if (rows[row].takes == TAKES_TEXT || rows[row].takes == TAKES_TEXT_UNIT)
        parse_text(p, word, row == find_row("file") ? "the name of a file in quotes" : "the name of a column in quotes", &s->text, &s->text_span);
    if (!p->failed && (rows[row].takes == TAKES_WORD || rows[row].takes == TAKES_TEXT_UNIT))
        parse_word(p, rows[row].takes == TAKES_WORD ? word : "the name of the column", rows[row].words, &s->value, &s->value_span);
    if (was.word)
        diag_note(p->diags, parser_report(p, DIAG_data_repeated, s->span, word), was.span, DIAG_note_first_here);
}

// Parses `P1 = "PT-101"`, a line of [data].  parse_line parses the annotations that follow.
static void parse_column(Parser *p, AstDataLine *line)
{
    parser_advance(p);
    parser_advance(p);
    parse_text(p, "'='", "the name of a column in quotes", &line->column, &line->column_span);
}

// Skips the word if it follows in the same line; returns whether it did.
static bool accept_word(Parser *p, const char *word)
{
    if (p->tok.kind != TOK_NAME || p->tok.first || strcmp(p->tok.text->text, word) != 0)
        return false;
    parser_advance(p);
    return true;
}

// Parses `@compare valveOpen "VALVE_CMD" tolerance 0 delay 20 ms`.
static void parse_compare(Parser *p, AstDataLine *line)
{
    parser_advance(p);
    if (p->tok.kind != TOK_NAME || p->tok.first) {
        fail_expected(p, "@compare", "the name of an element");
        return;
    }
    line->element = p->tok.text;
    line->element_span = parser_token_span(p);
    parser_advance(p);
    parse_text(p, "the element", "the name of a column in quotes", &line->column, &line->column_span);
    if (!p->failed && accept_word(p, "tolerance") && !parse_signed_number(p, &line->tolerance))
        fail_expected(p, "tolerance", "a number");
    if (p->failed || !accept_word(p, "delay"))
        return;
    if (p->tok.kind == TOK_NUMBER && !p->tok.first)
        line->delay = parse_number(p);
    else
        fail_expected(p, "delay", "a time");
}

static void parse_line(Parser *p, AstData *d)
{
    AstDataLine line = {.element = p->tok.text, .element_span = parser_token_span(p), .is_compare = at_compare(p)};

    if (line.is_compare)
        parse_compare(p, &line);
    else
        parse_column(p, &line);
    if (!p->failed && p->tok.kind == TOK_ANNOTATION && !p->tok.first)
        parse_annotations(p, AST_ON_DATA, line.element, line.element_span, &line.annotations);
    end_line(p);
    if (!p->failed)
        vec_push(p->arena, &d->line, line);
}

static void report_no_line(Parser *p)
{
    const char *words[ROWS + 1] = {"compare"}, *near;
    Diag *d;

    for (size_t i = 0; i < ROWS; i++)
        words[i + 1] = rows[i].word;
    if (p->tok.kind == TOK_ERROR)
        p->failed = true;
    near = p->tok.kind == TOK_NAME || p->tok.kind == TOK_ANNOTATION ? str_nearest(p->tok.text->text, words, ROWS + 1) : NULL;
    d = parser_fail(p, DIAG_data_line, parser_token_span(p), parser_describe(p, &p->tok));
    if (near)
        diag_label(p->diags, d, DIAG_label_did_you_mean, strcmp(near, "compare") == 0 ? "@compare" : near);
    parser_advance(p);
}

void parse_data(Parser *p, AstSection *s)
{
    s->data = ARENA_NEW(p->arena, AstData);
    while (p->tok.kind != TOK_HEADER && p->tok.kind != TOK_END) {
        const size_t row = p->tok.kind == TOK_NAME ? find_row(p->tok.text->text) : ROWS;
        p->failed = false;
        if (parser_at_include(p)) {
            parser_report_late_include(p);
        } else if (at_compare(p) || (p->tok.kind == TOK_NAME && p->ahead.kind == TOK_ASSIGN && !p->ahead.first)) {
            parse_line(p, s->data);
        } else if (row < ROWS) {
            parse_setting(p, s->data, row);
            end_line(p);
        } else {
            report_no_line(p);
        }
        s->data->is_lost = s->data->is_lost || p->failed;
        if (p->failed)
            parser_skip_line(p);
    }
    p->failed = false;
}
