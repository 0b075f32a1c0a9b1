// SPDX-License-Identifier: Apache-2.0
// Hints about malformed guards by time, such as `at 1 s, 2 s:` or `at 5 s for 1 s:`, and about guards by time in a machine: only scripts have them.
#include <string.h>

#include "compiler/syntax/hint_rules.h"
#include "compiler/syntax/hint_words.h"
#include "compiler/syntax/time_unit.h"

// Returns the guard by time `when lo` or `when lo to hi` as a comparison with G, which can be joined to others; NULL if no comparison means the
// same. `hi`: NULL without `to`.
static const char *format_comparison(Parser *p, AstWhen when, const AstExpr *lo, const AstExpr *hi)
{
    const char *a = parser_text(p, lo->span);

    if (when == AST_FROM && hi)
        return format_in(p->arena, "%s <= G < %s", a, parser_text(p, hi->span));
    if (when == AST_FROM || when == AST_EVERY)
        return NULL;
    return format_in(p->arena, "G %s %s", when == AST_AT ? "==" : ">=", a);
}

enum { TIMES_MAX = 16 };      // the most times in a list

// A list of n times, as in `at 1 s, 2 s:`.  hi: the ends of ranges, or NULL for times that are no ranges; units: how many times have a unit.
typedef struct Times { size_t n, units; const AstExpr *lo[TIMES_MAX], *hi[TIMES_MAX]; } Times;

// Adds a time range from lo to hi. t->units counts the ranges whose lo has a unit.
static void add_time(Times *t, const AstExpr *lo, const AstExpr *hi)
{
    t->lo[t->n] = lo;
    t->hi[t->n++] = hi;
    t->units += lo->unit != TIME_NONE;
}

static bool is_at_separator(const Parser *p) { return p->tok.kind == TOK_COMMA || p->tok.kind == TOK_AND || p->tok.kind == TOK_OR; }

// Reads a time, and a range if the guard is one, after a comma, `and` or `or`. Returns false if something else follows.
static bool read_further_time(Parser *p, AstWhen when, Times *t)
{
    const AstExpr *lo;

    parser_advance(p);
    if (parser_find_when(&p->tok) == when && p->ahead.kind == TOK_NUMBER)
        parser_advance(p);
    if (p->tok.kind != TOK_NUMBER || t->n == TIMES_MAX)
        return false;
    lo = parse_number(p);
    if (when != AST_FROM) {
        add_time(t, lo, NULL);
        return true;
    }
    if (!hint_is_word(&p->tok, "to") || p->ahead.kind != TOK_NUMBER)
        return false;
    parser_advance(p);
    add_time(t, lo, parse_number(p));
    return true;
}

// Returns the condition that the list means. A time without a unit gets the unit of another time of the list, as in `at 1, 2 s`.
static const char *format_times(Parser *p, AstWhen when, const Times *t)
{
    const char *unit = "";
    Buf out;

    for (size_t i = 0; i < t->n; i++)
        if (t->lo[i]->unit != TIME_NONE)
            unit = time_unit_name(t->lo[i]->unit);
    buf_init(&out, p->arena);
    for (size_t i = 0; i < t->n; i++)
        buf_printf(&out, "%s%s%s%s", i ? " or " : "", format_comparison(p, when, t->lo[i], t->hi[i]), *unit && t->lo[i]->unit == TIME_NONE ? " " : "",
                   t->lo[i]->unit == TIME_NONE ? unit : "");
    return buf_text(&out);
}

// Reports a list of times, as in `at 1 s, 2 s:`. Returns false, and reports nothing, if something else follows.
static bool report_times(Parser *p, const AstExpr *e)
{
    const Span span = e->span;
    Times times = {0, 0, {NULL}, {NULL}};
    const char *comparisons;
    Diag *d;

    if ((e->when != AST_AT && e->when != AST_FROM) || !is_at_separator(p))
        return false;
    add_time(&times, e->a, e->b);
    while (is_at_separator(p))
        if (!read_further_time(p, e->when, &times))
            return false;
    if (p->tok.kind != TOK_COLON && p->tok.kind != TOK_LBRACE)
        return false;
    comparisons = format_times(p, e->when, &times);
    d = parser_fail(p, DIAG_when_joined, span, parser_text(p, span));
    diag_label(p->diags, d, DIAG_label_write, comparisons);
    if (times.units == times.n || times.units == 0)
        diag_edit(p->diags, d, parser_span_since(p, span.at), comparisons);
    return true;
}

static void report_joined_condition(Parser *p, const AstExpr *e)
{
    const char *comparison = format_comparison(p, e->when, e->a, e->b);
    Diag *d = parser_fail(p, DIAG_when_joined, e->span, parser_text(p, e->span));

    if (comparison) {
        diag_label(p->diags, d, DIAG_label_write, comparison);
        diag_edit(p->diags, d, e->span, comparison);
    } else if (p->tok.kind == TOK_COMMA) {
        diag_label(p->diags, d, DIAG_label_guard_each, parser_text(p, e->span));
    } else {
        diag_label(p->diags, d, DIAG_label_when_nest, parser_text(p, e->span));
    }
}

// Reports a decimal comma in a time, as in `at 0,5 s:`. Returns false, and reports nothing, if the comma separates two times.
static bool report_decimal_comma(Parser *p)
{
    const char *text = p->lex.src->text, *before, *after;
    Diag *d;

    if (p->tok.kind != TOK_COMMA || p->last.kind != TOK_NUMBER || !lex_is_digit(text[p->ahead.at]) || !hint_are_adjacent(&p->last, &p->tok) ||
        !hint_are_adjacent(&p->tok, &p->ahead) || text[p->ahead.at + p->ahead.len] == ',')
        return false;
    before = parser_text(p, parser_span(p, &p->last));
    after = parser_text(p, parser_span(p, &p->ahead));
    after = format_in(p->arena, "%.*s", (int)strspn(after, "0123456789"), after);         // without the s of 0,5s
    d = parser_fail(p, DIAG_decimal_comma, parser_token_span(p));
    diag_label(p->diags, d, DIAG_label_decimal_point, before, after);
    if (strcmp(before, "0") == 0)
        diag_edit(p->diags, d, parser_token_span(p), ".");
    return true;
}

// Reports a condition that is joined to a guard by time, as in `at 5 s and x > 3:` and `at 1 s, 2 s:`.
HintResult hint_report_joined_when(HintCase *c)
{
    Parser *p = c->p;
    AstExpr *e = c->e;

    if (!report_decimal_comma(p) && !report_times(p, e))
        report_joined_condition(p, e);
    e->kind = AST_ERROR;
    return HINT_SKIPPED;
}

// Reports a second time after `at 5 s` or `after 5 s`, as in `after 5 s to 6 s:` and `at 5 s until 6 s:`.
HintResult hint_report_second_time(HintCase *c)
{
    Parser *p = c->p;
    AstExpr *e = c->e;
    uint32_t at = p->ahead.at;
    Diag *d;

    if (e->when != AST_AT && e->when != AST_AFTER)
        return HINT_NONE;
    d = parser_fail(p, DIAG_when_joined, e->span, parser_text(p, e->span));
    diag_label(p->diags, d, DIAG_label_write, format_in(p->arena, "from %s to %s", parser_text(p, e->a->span), hint_read_value(p, &at)));
    diag_edit(p->diags, d, ast_op_span(e), "from");
    if (!hint_is_word(&p->tok, "to"))
        diag_edit(p->diags, d, parser_token_span(p), "to");
    e->kind = AST_ERROR;
    return HINT_SKIPPED;
}

// Returns the guard for a time that begins at `begin` and lasts as long as the number after the current word `for`.
static const char *format_duration(Parser *p, const AstExpr *begin)
{
    const AstExpr *length;
    const char *end = "...";

    parser_advance(p);
    length = parse_number(p);
    if (length->unit == begin->unit)
        end = format_in(p->arena, "%.12g%s%s", begin->number + length->number, begin->unit == TIME_NONE ? "" : " ",
                        begin->unit == TIME_NONE ? "" : time_unit_name(begin->unit));
    return format_in(p->arena, "from %s to %s", parser_text(p, begin->span), end);
}

// Reports a duration after a guard by time, as in `at 5 s for 1 s:`.
HintResult hint_report_duration_of_when(HintCase *c)
{
    Parser *p = c->p;
    AstExpr *e = c->e;
    uint32_t at = p->ahead.at;
    const char *const every = format_in(p->arena, "from 0 to %s { %s: ... }", hint_read_value(p, &at), parser_text(p, e->span));
    const char *const from = format_duration(p, e->a);
    Diag *d = parser_fail(p, DIAG_when_joined, e->span, parser_text(p, e->span));

    if (e->when != AST_FROM)
        diag_label(p->diags, d, DIAG_label_write, e->when == AST_EVERY ? every : from);
    e->kind = AST_ERROR;
    return HINT_SKIPPED;
}

// Reports `from 5 s` without `to` and a number.
HintResult hint_report_no_to(HintCase *c)
{
    Parser *p = c->p;
    AstExpr *e = c->e;
    Diag *d;

    if (report_decimal_comma(p)) {
        e->kind = AST_ERROR;
        return HINT_SKIPPED;
    }
    d = parser_fail(p, DIAG_from_without_to, parser_missing_span(p), parser_text(p, e->a->span), parser_describe_found(p));

    e->kind = AST_ERROR;
    if (p->tok.kind == TOK_COLON || p->tok.kind == TOK_LBRACE) {
        diag_label(p->diags, d, DIAG_label_write, format_in(p->arena, "after %s", parser_text(p, e->a->span)));
        diag_edit(p->diags, d, ast_op_span(e), "after");
    } else if (p->tok.kind == TOK_NAME && parser_is_before_number(p) && (hint_is_word(&p->tok, "until") || hint_is_word(&p->tok, "till"))) {
        diag_label(p->diags, d, DIAG_label_write, "to");
        diag_edit(p->diags, d, parser_token_span(p), "to");
    } else if (parser_is_word(p, "for") && parser_is_before_number(p)) {
        diag_label(p->diags, d, DIAG_label_write, format_duration(p, e->a));
    }
    return HINT_SKIPPED;
}

// Reports a guard by time that is part of another condition, as in `x > 3 and at 5 s:`. The name e is its word, and a number follows it.
HintResult hint_report_when_inside(HintCase *c)
{
    Parser *p = c->p;
    const AstWhen when = c->e->kind == AST_NAME ? parser_find_when(&p->last) : AST_WHENS;
    AstExpr *lo, *hi = NULL;
    const char *comparison;
    Span written;
    Diag *d;

    if (p->kind != FILE_SS || when == AST_WHENS || p->last.at != c->e->span.at)
        return HINT_NONE;
    lo = parse_number(p);
    if (when == AST_FROM && p->tok.kind == TOK_NAME && !p->tok.first && hint_is_word(&p->tok, "to") && p->ahead.kind == TOK_NUMBER) {
        parser_advance(p);
        hi = parse_number(p);
    }
    written = parser_span_since(p, c->e->span.at);
    comparison = format_comparison(p, when, lo, hi);
    d = parser_fail(p, DIAG_when_joined, written, parser_text(p, written));
    if (comparison) {
        diag_label(p->diags, d, DIAG_label_write, comparison);
        diag_edit(p->diags, d, written, comparison);
    } else {
        diag_label(p->diags, d, DIAG_label_when_nest, parser_text(p, written));
    }
    return HINT_SKIPPED;
}

// Returns the time after = or == at `at`, as in `at t = 5s`; "" if no such time is there.
const char *hint_read_equated(const Parser *p, uint32_t at)
{
    const char *text = p->lex.src->text, *value;
    size_t digits;

    at += (uint32_t)strspn(text + at, " \t");
    if (text[at] != '=')
        return "";
    at += text[at + 1] == '=' ? 2 : 1;
    value = hint_read_value(p, &at);
    digits = strspn(value, "0123456789.");
    if (digits == 0 || value[digits] == ' ' || !value[digits])
        return digits ? value : "";
    return time_unit_find(value + digits) == TIME_NONE ? "" : format_in(p->arena, "%.*s %s", (int)digits, value, value + digits);
}

// Reports something else than a number after the word of a guard by time, as in `at burnout:` and `at T + 5:`.
HintResult hint_report_when_without_number(HintCase *c)
{
    Parser *p = c->p;
    const AstWhen when = parser_find_when(&p->tok);
    const bool is_variable = p->ahead.kind == TOK_NAME && (when == AST_AT || when == AST_AFTER);
    const bool equals = is_variable && *hint_read_equated(p, p->ahead.at + p->ahead.len);
    const bool in_state = is_variable && strcmp(p->ahead.text->text, "T") == 0, is_time = is_variable && strcmp(p->ahead.text->text, "G") == 0;
    Diag *d;

    if (p->kind != FILE_SS || when == AST_WHENS || hint_is_operator_word(p->lex.src->text, p->ahead.at))
        return HINT_NONE;
    d = parser_fail(p, DIAG_when_without_number, parser_token_span(p), parser_when_words[when], parser_describe(p, &p->ahead));
    if (in_state)
        diag_label(p->diags, d, DIAG_label_when_in_state, when == AST_AT ? "T == 5 s" : "T >= 5 s", when == AST_AT ? "at 5 s" : "after 5 s");
    else if (equals)                                      // at t = 5 s
        diag_label(p->diags, d, DIAG_label_write,
                   format_in(p->arena, "%s %s", parser_when_words[when], hint_read_equated(p, p->ahead.at + p->ahead.len)));
    else if (is_variable && !is_time)
        diag_label(p->diags, d, DIAG_label_write, format_in(p->arena, "G %s %s", when == AST_AT ? "==" : ">=", p->ahead.text->text));
    else
        diag_label(p->diags, d, DIAG_label_write, format_in(p->arena, when == AST_FROM ? "from 5 s to 6 s" : "%s 5 s", parser_when_words[when]));
    return HINT_SKIPPED;
}

// Other words that users write before a time, and the guard that is meant; %s is the time; certain: the word has no other meaning.
static const struct { const char *word, *guard; bool certain; } time_words[] = {
    {"since", "after %s", true}, {"starting", "after %s", true}, {"each", "every %s", true},   {"on", "at %s", true},
    {"once", "at %s", false},    {"when", "at %s", true},        {"until", "from 0 to %s", false}, {"till", "from 0 to %s", false},
    {"before", "from 0 to %s", true}, {"during", "from 0 to %s", false}, {"between", "from %s to ...", false}, {"for", "from 0 to %s", false},
    {"while", "from 0 to %s", false}, {"wait", "after %s", false}, {"delay", "after %s", false}};

// Reports another word before a time at the start of a guard, as in `until 5 s:`.
static HintResult report_time_word(Parser *p, const char *guard, bool certain)
{
    const Span word = parser_token_span(p);
    Diag *d = parser_report(p, DIAG_foreign_word, word, p->tok.text->text);
    const AstExpr *time;
    const char *text;

    parser_advance(p);
    time = parse_number(p);
    text = format_in(p->arena, guard, parser_text(p, time->span));
    if (!certain && p->ahead.kind == TOK_NUMBER && (p->tok.kind == TOK_AND || parser_is_word(p, "to") || parser_is_word(p, "until"))) {
        uint32_t at = p->ahead.at;                        // between 5 s and 6 s, during 5 s to 6 s
        text = format_in(p->arena, "from %s to %s", parser_text(p, time->span), hint_read_value(p, &at));
    }
    diag_label(p->diags, d, DIAG_label_write, text);
    if (certain && (p->tok.kind == TOK_COLON || p->tok.kind == TOK_LBRACE))
        diag_edit(p->diags, d, parser_span_since(p, word.at), text);
    p->failed = true;
    return HINT_SKIPPED;
}

// Reports a guard by time in a machine, as in `after 2 s:`, and suggests a comparison with T. Proposes an edit only for `after`, which also means
// the time in the state in other languages.
static HintResult report_when_in_machine(Parser *p, AstWhen when)
{
    const Span word = parser_token_span(p);
    Diag *d = parser_report(p, DIAG_when_in_machine, word, p->tok.text->text);
    const char *lo, *hi = "", *text;

    parser_advance(p);
    lo = parser_text(p, parse_number(p)->span);
    if (when == AST_FROM && parser_is_word(p, "to") && p->ahead.kind == TOK_NUMBER) {
        parser_advance(p);
        hi = parser_text(p, parse_number(p)->span);
    }
    text = *hi ? format_in(p->arena, "%s <= T < %s", lo, hi) : format_in(p->arena, "T >= %s", lo);
    if (when == AST_EVERY)
        diag_label(p->diags, d, DIAG_label_every_in_machine, lo);
    else
        diag_label(p->diags, d, DIAG_label_write, text);
    if (when == AST_AFTER && (p->tok.kind == TOK_COLON || p->tok.kind == TOK_LBRACE))
        diag_edit(p->diags, d, parser_span_since(p, word.at), text);
    p->failed = true;
    return HINT_SKIPPED;
}

HintResult hint_report_time_word(HintCase *c)
{
    Parser *p = c->p;

    for (size_t i = 0; p->kind == FILE_SS && i < sizeof time_words / sizeof *time_words; i++)
        if (hint_is_word(&p->tok, time_words[i].word))
            return report_time_word(p, time_words[i].guard, time_words[i].certain);
    if (p->kind == FILE_SM && parser_find_when(&p->tok) != AST_WHENS)
        return report_when_in_machine(p, parser_find_when(&p->tok));
    return HINT_NONE;
}

// ---- after `state` ----

// Whether a value follows the word.
static bool is_before_value(const Parser *p, const Token *word)
{
    const char *text = p->lex.src->text;
    uint32_t at = word->at + word->len;

    while (text[at] == ' ' || text[at] == '\t')
        at++;
    return lex_is_letter(text[at]) || lex_is_digit(text[at]) || text[at] == '-' || text[at] == '.' || text[at] == '(';
}

bool hint_is_phrase(const Parser *p, const Token *word)
{
    return hint_is_operator_word(p->lex.src->text, word->at) && is_before_value(p, word);
}
