// SPDX-License-Identifier: Apache-2.0
// Hints about lists and arrays: `S in (A, B)`, `S == A, B`, `F32 x[3]`. A condition compares one value at a time, and a name has one value.
#include <string.h>

#include "compiler/syntax/hint_lists.h"
#include "compiler/syntax/hint_rules.h"
#include "compiler/syntax/hint_words.h"
#include "compiler/syntax/lexer.h"

enum { MEMBERS_MAX = 16 };        // the most values in a list

// A value that is compared with several others.
typedef struct Membership {
    Span written;             // `S not in (A, B)`
    const char *left;         // `S`
    bool left_is_operand;     // an operator precedes the left value, as in `a + b in (1, 2)`, so `left` is only a part of the value
    bool is_negated, has_brackets, is_range;
    size_t n;
    Span member[MEMBERS_MAX];
} Membership;

// ---- characters of a line ----

static uint32_t skip_blanks(const char *text, uint32_t at)
{
    while (text[at] == ' ' || text[at] == '\t')
        at++;
    return at;
}

static uint32_t skip_blanks_back(const char *text, uint32_t at)
{
    while (at > 0 && (text[at - 1] == ' ' || text[at - 1] == '\t'))
        at--;
    return at;
}

// Returns the start of the name that ends at `end`, with the name of a machine before it, as in deploy.S.
static uint32_t start_of_name(const char *text, uint32_t end)
{
    while (end > 0 && (lexer_is_word(text[end - 1]) || text[end - 1] == '.'))
        end--;
    return end;
}

static uint32_t end_of_name(const char *text, uint32_t at)
{
    while (lexer_is_word(text[at]))
        at++;
    return at;
}

static const char *text_of(Arena *arena, Span at) { return format_in(arena, "%.*s", (int)at.len, at.src->text + at.at); }

static bool is_word_at(const char *text, uint32_t at, uint32_t end, const char *word)
{
    return end - at == strlen(word) && memcmp(text + at, word, end - at) == 0;
}

// If the word ends at *end, moves *end to its start, without the blanks before it, and returns true.
static bool drop_word_before(const char *text, uint32_t *end, const char *word)
{
    const uint32_t from = start_of_name(text, *end);

    if (!is_word_at(text, from, *end, word))
        return false;
    *end = skip_blanks_back(text, from);
    return true;
}

// ---- members ----

// Reads a member: a name, or a number with a sign and a unit of time. Returns its end; `at` if something else is there.
static uint32_t skip_member(const char *text, uint32_t at)
{
    uint32_t end = at, unit;

    if (text[end] == '-' || text[end] == '+')
        end++;
    if (!lexer_is_word(text[end]))
        return at;
    while (lexer_is_word(text[end]) || (text[end] == '.' && lexer_is_word(text[end + 1])))
        end++;
    unit = skip_blanks(text, end);
    if (lex_is_digit(text[at]) && unit > end && (strncmp(text + unit, "s", 1) == 0 || strncmp(text + unit, "ms", 2) == 0)) {
        unit += text[unit] == 'm' ? 2 : 1;
        return lexer_is_word(text[unit]) ? end : unit;
    }
    return end;
}

// Reads members that commas separate, up to `close`, or, if that is 0, to the last of them. Returns their end; 0 if something else is there.
static uint32_t read_members(Membership *m, uint32_t at, char close)
{
    const Source *src = m->written.src;
    const char *text = src->text;

    for (;;) {
        const uint32_t from = skip_blanks(text, at), end = skip_member(text, from);
        if (end == from || m->n == MEMBERS_MAX)
            return 0;
        m->member[m->n++] = (Span){src, from, end - from};
        at = skip_blanks(text, end);
        if (text[at] != ',')
            return !close ? end : text[at] == close ? at + 1 : 0;
        at++;
    }
}

// Reads `3 to 5` after `in`. Returns false if something else is there.
static bool read_range_in_words(Membership *m, uint32_t at)
{
    const Source *src = m->written.src;
    const char *text = src->text;
    const uint32_t lo = skip_member(text, at), word = skip_blanks(text, lo), second = skip_blanks(text, end_of_name(text, word));
    const uint32_t hi = skip_member(text, second);

    if (lo == at || hi == second || !is_word_at(text, word, end_of_name(text, word), "to"))
        return false;
    m->member[0] = (Span){src, at, lo - at};
    m->member[1] = (Span){src, second, hi - second};
    m->n = 2;
    m->written.len = hi - m->written.at;
    return true;
}

// Reads a range after `in`, as in 3..5. Returns false if something else is there.
static bool read_range(Membership *m, uint32_t at)
{
    const Source *src = m->written.src;
    const char *text = src->text;
    const uint32_t from = at + (uint32_t)strspn(text + at, "(["), lo = from + (uint32_t)strspn(text + from, "-0123456789");
    const uint32_t second = lo + (uint32_t)strspn(text + lo, ".:"), hi = second + (uint32_t)strspn(text + second, "-0123456789");

    if (lo == from || second < lo + 2 || hi == second || text[lo] != '.')
        return false;
    m->member[0] = (Span){src, from, lo - from};
    m->member[1] = (Span){src, second, hi - second};
    m->n = 2;
    m->written.len = hi + (uint32_t)strspn(text + hi, ")]") - m->written.at;
    return true;
}

// Reads what follows `in`, which ends at `at`.
static bool read_list(Membership *m, uint32_t at, bool is_enclosed)
{
    static const char brackets[] = "(){}[]";
    const char *text = m->written.src->text, *open;
    uint32_t end;

    at = skip_blanks(text, at);
    m->is_range = read_range(m, at) || read_range_in_words(m, at);
    if (m->is_range)
        return true;
    open = text[at] ? strchr(brackets, text[at]) : NULL;
    m->has_brackets = open && (open - brackets) % 2 == 0;
    end = read_members(m, at + m->has_brackets, m->has_brackets ? open[1] : '\0');
    if (!m->has_brackets && is_enclosed && m->n > 1) {       // the comma separates arguments of a call, so the list has one value
        m->n = 1;
        end = m->member[0].at + m->member[0].len;
    }
    m->written.len = end - m->written.at;
    return end > 0 && text[end] != '(';
}

// ---- what to write instead ----

// Whether the name is S, state, State or ends in .S: probably an element that contains the number of a state.
static bool is_state_element(const char *name)
{
    const size_t n = strlen(name);

    return strcmp(name, "S") == 0 || strcmp(name, "state") == 0 || strcmp(name, "State") == 0 || (n > 2 && strcmp(name + n - 2, ".S") == 0);
}

// Whether every member of the list is a number.
static bool are_numbers(const Membership *m)
{
    bool numbers = true;

    for (size_t i = 0; i < m->n; i++) {
        const char *member = m->written.src->text + m->member[i].at;
        numbers = numbers && (lex_is_digit(member[0]) || member[0] == '-' || member[0] == '+');
    }
    return numbers;
}

// Returns `S == A or S == B`, or `S != A and S != B`.
static const char *format_comparisons(Arena *arena, const Membership *m, const char *left)
{
    Buf out;

    buf_init(&out, arena);
    for (size_t i = 0; i < m->n; i++) {
        buf_printf(&out, "%s%s %s ", i == 0 ? "" : m->is_negated ? " and " : " or ", left, m->is_negated ? "!=" : "==");
        buf_put(&out, m->written.src->text + m->member[i].at, m->member[i].len);
    }
    return buf_text(&out);
}

// Whether the comparisons need parentheses where the membership is written.
static bool needs_parens(const Membership *m)
{
    const char *text = m->written.src->text;
    uint32_t before = skip_blanks_back(text, m->written.at), after = skip_blanks(text, m->written.at + m->written.len);
    const bool is_negation = drop_word_before(text, &before, "not") || (before > 0 && text[before - 1] == '!');

    if (m->n == 1)
        return is_negation;
    return is_negation || drop_word_before(text, &before, "and") || (before > 0 && text[before - 1] == '&') ||
           is_word_at(text, after, end_of_name(text, after), "and") || text[after] == '&';
}

// Adds the label that proposes to compare `left` with each value.
static void label_each(Diags *diags, Diag *d, const char *left)
{
    diag_label(diags, d, DIAG_label_compare_each, format_in(diags->arena, "%s == a or %s == b", left, left));
}

// Labels d with the comparisons, and proposes them if no other meaning is possible.
static void label_membership(Diags *diags, Diag *d, const Membership *m)
{
    const char *comparisons = format_comparisons(diags->arena, m, m->left);
    const bool is_state = is_state_element(m->left);

    if (m->left_is_operand) {
        label_each(diags, d, "x");
    } else if (m->is_range) {
        diag_label(diags, d, DIAG_label_write, format_in(diags->arena, m->is_negated ? "not (%s <= %s <= %s)" : "%s <= %s <= %s",
                                                         text_of(diags->arena, m->member[0]), m->left, text_of(diags->arena, m->member[1])));
    } else if (!is_state && are_numbers(m) && m->n == 2) {                    // [0, 5] can mean a list or a range
        diag_label(diags, d, DIAG_label_compare_or_range, comparisons,
                   format_in(diags->arena, "%s <= %s <= %s", text_of(diags->arena, m->member[0]), m->left, text_of(diags->arena, m->member[1])));
    } else if (!is_state && !are_numbers(m) && !m->is_negated) {              // `valve in Burn` can mean: while the machine is in state Burn
        const char *states = format_comparisons(diags->arena, m, "S");
        diag_label(diags, d, DIAG_label_compare_or_state, format_in(diags->arena, m->n > 1 ? "%s and (%s)" : "%s and %s", m->left, states),
                   comparisons);
    } else {
        const char *text = needs_parens(m) ? format_in(diags->arena, "(%s)", comparisons) : comparisons;
        diag_label(diags, d, DIAG_label_write, text);
        diag_edit(diags, d, m->written, text);
    }
}

// ---- S in (A, B) ----

// Returns the end of `in`, `not in`, `is in` or `is not in` at `at`; 0 if the text is anything else.
static uint32_t skip_in_operator(const char *text, uint32_t at, bool *is_negated)
{
    uint32_t end;

    *is_negated = false;
    for (;; at = skip_blanks(text, end)) {
        end = end_of_name(text, at);
        if (is_word_at(text, at, end, "in"))
            return end;
        if (!is_word_at(text, at, end, "is") && !is_word_at(text, at, end, "not"))
            return 0;
        *is_negated = *is_negated || text[at] == 'n';
    }
}

// Whether an operator before `at` takes the value there before a comparison does.
static bool follows_arithmetic(const char *text, uint32_t at)
{
    at = skip_blanks_back(text, at);
    if (at == 0 || (text[at - 1] == '=' && (at < 2 || !strchr("=<>!", text[at - 2]))))        // the list is assigned, as in `x = S in (A, B)`
        return false;
    return strchr("+-*/<>=", text[at - 1]) != NULL;
}

// Returns the name of the value on the left: S for the word `state`, unless it is declared.
static const char *name_of_left(Arena *arena, Span left, bool is_declared)
{
    const char *name = text_of(arena, left);

    return !is_declared && (strcmp(name, "state") == 0 || strcmp(name, "State") == 0) ? "S" : name;
}

// Reports a value that is compared with a list, as in `S in (A, B)`. The operand c->e is the value.
HintResult hint_report_membership(HintCase *c)
{
    Parser *p = c->p;
    const char *text = p->lex.src->text;
    const bool outer_not = c->e->kind == AST_UNARY && c->e->op == SM_OP_NOT;
    const AstExpr *left = outer_not ? c->e->a : c->e;
    Membership m = {.written = left->span};
    const uint32_t in = skip_in_operator(text, p->tok.at, &m.is_negated);
    Diag *d;

    if (in && p->is_expect && hint_is_word(&p->tok, "in") && p->ahead.kind == TOK_NUMBER) {         // @expect x == 1 in 5 s
        hint_replace_word(p, "within", TOK_NAME);
        p->tok.text = str_c(p->strings, "within");
        return HINT_SKIPPED;
    }
    if (!in)
        return HINT_NONE;
    if (p->ahead.kind == TOK_ERROR && !p->ahead.first) {       // `x in 3..5`: the lexer has reported 3..5 as a malformed number
        c->e->kind = AST_ERROR;
        p->failed = true;
        return HINT_SKIPPED;
    }
    m.left = name_of_left(p->arena, left->span, left->kind == AST_NAME && left->name->declared);
    m.left_is_operand = follows_arithmetic(text, left->span.at);
    d = parser_report(p, DIAG_foreign_word, (Span){p->lex.src, p->tok.at, in - p->tok.at},
                      parser_text(p, (Span){p->lex.src, p->tok.at, in - p->tok.at}));
    c->e->kind = AST_ERROR;
    if (!read_list(&m, in, p->parens > 0)) {
        label_each(p->diags, d, m.left_is_operand ? "x" : m.left);
        p->failed = true;
        return HINT_SKIPPED;
    }
    label_membership(p->diags, d, &m);
    while (p->tok.at < m.written.at + m.written.len && p->tok.kind != TOK_END)
        parser_advance(p);
    return HINT_READ;
}

// Reports a list in brackets after `in`, as in `S in [A, B]`, whose [ is at `at`. Returns false, and reports nothing, if the text is anything
// else.
static bool report_bracketed_members(Diags *diags, const Source *src, uint32_t at)
{
    const char *text = src->text;
    const uint32_t in = skip_blanks_back(text, at);
    uint32_t end = in;
    Membership m = {.written = {src, 0, 0}};
    Span word;
    Diag *d;

    if (in == at || !drop_word_before(text, &end, "in"))
        return false;
    m.is_negated = drop_word_before(text, &end, "not");
    drop_word_before(text, &end, "is");
    m.written.at = start_of_name(text, end);
    m.left = name_of_left(diags->arena, (Span){src, m.written.at, end - m.written.at}, false);
    m.left_is_operand = m.written.at == end || follows_arithmetic(text, m.written.at);
    word = (Span){src, skip_blanks(text, end), 0};
    word.len = in - word.at;
    d = diag_report(diags, DIAG_foreign_word, word, text_of(diags->arena, word));
    if (read_list(&m, in, false))
        label_membership(diags, d, &m);
    else
        label_each(diags, d, m.left_is_operand ? "x" : m.left);
    return true;
}

// ---- S == A, B ----

// Whether a list such as `A, B`, which ends at position `at`, ends a condition: then its members are values, not statements of their own.
static bool is_end_of_condition(const char *text, uint32_t at)
{
    at = skip_blanks(text, at);
    return !text[at] || strchr(":{\r\n#)\"@", text[at]);
}

// Labels d with the comparisons of a list after == or !=, and proposes them.
static void label_comparisons(Parser *p, Diag *d, const Membership *m)
{
    const char *comparisons = format_comparisons(p->arena, m, m->left);

    if (needs_parens(m))
        comparisons = format_in(p->arena, "(%s)", comparisons);
    diag_label(p->diags, d, DIAG_label_write, comparisons);
    diag_edit(p->diags, d, m->written, comparisons);
}

// Reports further values after a comparison, as in `S == A, B: ...`. The current token is the comma.
HintResult hint_report_listed_values(HintCase *c)
{
    Parser *p = c->p;
    const char *text = p->lex.src->text;
    uint32_t end = skip_blanks_back(text, p->tok.at), left;
    Membership m = {.written = {p->lex.src, 0, 0}};
    uint32_t first = start_of_name(text, end), at = skip_blanks_back(text, first);

    if (first == end || at < 2 || text[at - 1] != '=' || !strchr("=!", text[at - 2]))
        return HINT_NONE;
    m.is_negated = text[at - 2] == '!';
    at = skip_blanks_back(text, at - 2);
    left = start_of_name(text, at);
    m.written.at = left;
    end = read_members(&m, first, '\0');
    if (left == at || end == 0 || !is_end_of_condition(text, end))
        return HINT_NONE;
    m.written.len = end - left;
    m.left = text_of(p->arena, (Span){p->lex.src, left, at - left});
    m.left_is_operand = follows_arithmetic(text, left);
    if (c->context == HINT_AFTER_GUARD)
        c->general = parser_fail(p, DIAG_guard_without_body, parser_token_span(p), parser_describe(p, &p->tok));
    if (m.left_is_operand)
        label_each(p->diags, hint_report_general(c), "x");
    else
        label_comparisons(p, hint_report_general(c), &m);
    return HINT_SKIPPED;
}

// Reports a list after a comparison, as in S == (A, B). The current token is the first comma.
HintResult hint_report_listed_in_parens(HintCase *c)
{
    Parser *p = c->p;
    const char *text = p->lex.src->text;
    const uint32_t end = skip_blanks_back(text, p->tok.at), first = start_of_name(text, end), open = skip_blanks_back(text, first);
    const uint32_t sign = open > 0 && text[open - 1] == '(' ? skip_blanks_back(text, open - 1) : 0;
    Membership m = {.written = {p->lex.src, 0, 0}};
    uint32_t left;
    Diag *d;

    if (sign < 2 || text[sign - 1] != '=' || !strchr("=!", text[sign - 2]))
        return HINT_NONE;
    m.is_negated = text[sign - 2] == '!';
    left = skip_blanks_back(text, sign - 2);
    m.written.at = start_of_name(text, left);
    m.left = text_of(p->arena, (Span){p->lex.src, m.written.at, left - m.written.at});
    m.left_is_operand = m.written.at == left || follows_arithmetic(text, m.written.at);
    if (!read_list(&m, open - 1, false))
        return HINT_NONE;
    d = parser_fail(p, DIAG_paren_unclosed, parser_token_span(p), parser_describe(p, &p->tok));
    if (m.left_is_operand)
        label_each(p->diags, d, "x");
    else
        label_comparisons(p, d, &m);
    return HINT_SKIPPED;
}

// ---- arrays ----

static bool is_number(const char *text, size_t n)
{
    bool digits = n > 0;

    for (size_t i = 0; i < n; i++)
        digits = digits && lex_is_digit(text[i]);
    return digits;
}

// Whether text[from..end) is the name of a type.
static bool is_type(const char *text, uint32_t from, uint32_t end)
{
    bool found = false;

    for (int i = 0; i < SM_TYPE_COUNT; i++)
        found = found || is_word_at(text, from, end, sm_type_info[i].spelling);
    return found;
}

// Reports an array's declaration, as in bool a[3], or its element, as in a[3] and a[i + 1]. `whole`: `a[3]`, whose [ is at `open`.
static void report_array(Diags *diags, Span whole, uint32_t open)
{
    const char *text = whole.src->text, *name = text_of(diags->arena, (Span){whole.src, whole.at, open - whole.at});
    const size_t n = whole.at + whole.len - open - 2;
    const uint32_t type_end = skip_blanks_back(text, whole.at), type = start_of_name(text, type_end);
    Diag *d = diag_report(diags, DIAG_no_lists, whole, text_of(diags->arena, whole));

    if (is_type(text, type, type_end)) {
        const char *first = format_in(diags->arena, "%.*s %s1", (int)(type_end - type), text + type, name);
        diag_label(diags, d, DIAG_label_array, first, format_in(diags->arena, "%.*s2", (int)strlen(first) - 1, first));
    } else if (is_number(text + open + 1, n) && text[open + n + 2] != '[') {
        diag_label(diags, d, DIAG_label_index, format_in(diags->arena, "%s%.*s", name, (int)n, text + open + 1));
    } else {
        diag_label(diags, d, DIAG_label_computed_index);
    }
}

bool hint_report_brackets(Diags *diags, const Source *src, uint32_t at, uint32_t end)
{
    const uint32_t from = start_of_name(src->text, at);

    if (report_bracketed_members(diags, src, at))
        return true;
    if (from == at || !lex_is_letter(src->text[from]))
        return false;
    report_array(diags, (Span){src, from, end - from}, at);
    return true;
}

// Whether the header after a name is an index, as in a[3]. An unknown name can begin a section: `x = a[Idle]`.
static bool is_index(const Parser *p)
{
    const Str index = p->tok.text;

    return hint_are_adjacent(&p->last, &p->tok) && (!lex_is_identifier(index->text, index->len) || index->declared);
}

// Reports an index, as in a[3], unless the lexer has reported it.
HintResult hint_report_index(HintCase *c)
{
    Parser *p = c->p;
    Span both = parser_span(p, &p->last);

    if (!is_index(p))
        return HINT_NONE;
    both.len += p->tok.len;
    if (!p->failed && lex_is_header_name(p->tok.text->text, p->tok.text->len))
        report_array(p->diags, both, p->tok.at);
    p->failed = true;
    do
        parser_advance(p);
    while (p->tok.kind == TOK_HEADER && hint_are_adjacent(&p->last, &p->tok));       // further brackets, as in `a[1][2]`
    return HINT_SKIPPED;
}

// Reports and skips the declaration of an array, as in bool bad[5].
HintResult hint_report_array(HintCase *c)
{
    Parser *p = c->p;
    const Source *src = p->lex.src;
    Span both = parser_span(p, &p->last);

    if (!is_index(p))
        return HINT_NONE;
    both.len += p->tok.len;
    if (!p->failed && lex_is_header_name(p->tok.text->text, p->tok.text->len))
        report_array(p->diags, both, p->tok.at);
    p->failed = true;
    if (!p->ahead.first) {                    // skip the initial values of the array
        while (p->lex.at < src->len && src->text[p->lex.at] != '\n')
            p->lex.at++;
        parser_advance(p);
    }
    parser_advance(p);
    return HINT_SKIPPED;
}
