// SPDX-License-Identifier: Apache-2.0
// Hints about operators of other languages, such as && for `and`, => for -> or >=, := for =, operators on bits (&, |, ~), and |x| for abs(x).
#include <string.h>

#include "compiler/syntax/hint_text.h"
#include "compiler/syntax/hint_words.h"

// ---- arrows ----

// Whether a name is the last word of the line after the operator t, and the next line with code does not begin with a brace.
static bool is_state_named_after(const Lexer *l, const Token *t)
{
    uint32_t from = hint_skip_spaces(l, t->at + t->len), end = lexer_skip_word(l, from), p = hint_skip_spaces(l, end);

    if (l->stores || l->annotated || l->parens || !lex_is_identifier(l->src->text + from, end - from) ||
        !(hint_ends_line(l, p) || lexer_byte(l, p) == '}'))
        return false;
    while (lexer_byte(l, p) == '\n' || lexer_byte(l, p) == '#') {
        p += (uint32_t)strcspn(l->src->text + p, "\n");
        p = lexer_byte(l, p) ? hint_skip_spaces(l, p + 1) : p;
    }
    return lexer_byte(l, p) != '{';
}

// ---- bits ----

// Whether t is certainly a bit operator, as in `fault & 4` or `~3`, which the language does not have: a number follows t, and no < or >
// follows the number. In `p > 5 & 3 < x` the & joins two comparisons.
static bool is_bit_operator(const Lexer *l, const Token *t)
{
    const uint32_t p = hint_skip_spaces(l, t->at + 1), after = hint_skip_spaces(l, lexer_skip_word(l, p));

    return t->len == 1 && strchr("&|~", l->src->text[t->at]) && lex_is_digit(lexer_byte(l, p)) && lexer_byte(l, after) != '<' &&
           lexer_byte(l, after) != '>' && lexer_byte(l, after) != '.';
}

// The text on one side of a & or |, up to the nearest operator in the same parentheses that joins conditions (&& || & | and or).
typedef struct ConditionSide {
    bool compares;            // the text contains a comparison
    enum { SIDE_END, SIDE_AND, SIDE_OR, SIDE_BIT_AND, SIDE_BIT_OR } until;
} ConditionSide;

static bool is_text_equal(const char *s, uint32_t at, uint32_t end, const char *word)
{
    return end - at == strlen(word) && memcmp(s + at, word, end - at) == 0;
}

// Returns which operator that joins conditions is at `p`, or SIDE_END if none is; *len: the length of the token at p.
static int find_join(const Lexer *l, uint32_t p, uint32_t *len)
{
    const char *s = l->src->text;
    const uint32_t end = lexer_skip_word(l, p);

    *len = end > p ? end - p : 1;
    if (end > p)
        return is_text_equal(s, p, end, "and") || is_text_equal(s, p, end, "AND")  ? SIDE_AND
               : is_text_equal(s, p, end, "or") || is_text_equal(s, p, end, "OR") ? SIDE_OR
                                                                      : SIDE_END;
    if (s[p] != '&' && s[p] != '|')
        return SIDE_END;
    *len = lexer_byte(l, p + 1) == s[p] ? 2 : 1;
    if (*len == 2)
        return s[p] == '&' ? SIDE_AND : SIDE_OR;
    return s[p] == '&' ? SIDE_BIT_AND : SIDE_BIT_OR;
}

// Whether a comparison operator is at position p.
static bool is_comparison_at(const char *s, uint32_t p)
{
    return s[p] == '<' || s[p] == '>' || (s[p] == '=' && (s[p + 1] == '=' || (p > 0 && s[p - 1] == '!')));
}

// Describes the operand on the right of an operator, which begins at p. Reads at most HINT_FAR bytes.
static ConditionSide scan_right_side(const Lexer *l, uint32_t p)
{
    const char *s = l->src->text;
    const uint32_t most = p + HINT_FAR;
    ConditionSide side = {false, SIDE_END};
    uint32_t depth = 0, len = 1;

    for (; p < most && p < l->src->len && !strchr(":{}#\n", s[p]); p += len) {
        int joined = find_join(l, p, &len);
        if (depth == 0 && (joined || s[p] == ')')) {
            side.until = (unsigned)joined;
            break;
        }
        depth += s[p] == '(';
        depth -= s[p] == ')';
        side.compares |= is_comparison_at(s, p);
    }
    return side;
}

// Describes the operand on the left of the operator at `at`. Begins at the enclosing parenthesis or at the start of the line, and reads at
// most HINT_FAR bytes.
static ConditionSide scan_left_side(const Lexer *l, uint32_t at)
{
    const char *s = l->src->text;
    uint32_t from = at, depth = 0, len = 1;
    ConditionSide side = {false, SIDE_END};

    while (from > l->line_start && at - from < HINT_FAR && !strchr(":{}", s[from - 1]) && (s[from - 1] != '(' || depth > 0)) {
        from--;
        depth += s[from] == ')';
        depth -= s[from] == '(';
    }
    depth = 0;
    for (uint32_t p = from; p < at; p += len) {
        int joined = find_join(l, p, &len);
        if (depth == 0 && joined)
            side = (ConditionSide){false, (unsigned)joined};
        depth += s[p] == '(';
        depth -= s[p] == ')' && depth > 0;
        side.compares |= is_comparison_at(s, p);
    }
    return side;
}

// Whether the user can have meant several things by the operator t, so that no edit is proposed: t can be a bit operator, as in
// `status & mask` or `x = ~mask`, or t is a | next to an `and`, whose relative precedence differs between languages.
static bool has_unclear_meaning(const Lexer *l, const Token *t)
{
    const char sign = l->src->text[t->at];
    ConditionSide left, right;

    if (t->len > 1 || sign == '~')
        return t->len == 1 && l->stores && !t->first;      // at the first token of a line, l->stores is still about the previous line
    if (sign != '&' && sign != '|')
        return false;
    left = scan_left_side(l, t->at);
    right = scan_right_side(l, t->at + 1);
    if (sign == '|' && (left.until == SIDE_AND || right.until == SIDE_AND))
        return true;
    return !left.compares || (!right.compares && right.until >= SIDE_BIT_AND);
}

// ---- one operator ----

// Whether the operator at `at` follows the name that begins the statement, as in x := 1.
static bool follows_target_only(const Lexer *l, uint32_t at)
{
    const char *s = l->src->text;

    while (at > l->line_start && is_space_tab_or_return(s[at - 1]))
        at--;
    while (at > l->line_start && lexer_is_word(s[at - 1]))
        at--;
    while (at > l->line_start && is_space_tab_or_return(s[at - 1]))
        at--;
    return at == l->line_start || strchr(":{};", s[at - 1]);
}

// Reports an operator that this language spells `native`, and proposes the edit if what the user meant is unambiguous.
static void report_foreign_spelling(Lexer *l, Token *t, const char *spelling, const char *native)
{
    const bool begins_statement = t->first || l->last == TOK_COLON || l->last == TOK_LBRACE || l->last == TOK_LABEL || l->last == TOK_HEADER;
    const uint32_t name = hint_skip_spaces(l, t->at + t->len);
    bool arrow = strcmp(spelling, "=>") == 0, needs_space;
    bool names_value = false;                 // the name after => is a declared variable, so => is probably meant as >=
    uint32_t from = t->at;
    Diag *d;

    if (arrow && l->requirements) {
        native = "implies";
        t->kind = TOK_NAME;
        t->text = str_c(l->strings, native);
    } else if (arrow && begins_statement) {
        native = "->";
    } else if (arrow && is_state_named_after(l, t)) {
        names_value = hint_is_declared(l, name, lexer_skip_word(l, name));
        if (!names_value)
            native = ": ->";
    }
    if (native[strlen(native) - 1] == '>')
        t->kind = TOK_ARROW;
    needs_space = lex_is_letter(*native);
    if (*spelling == '&' && t->len == 1 && l->last == TOK_ASSIGN && !t->first) {          // x = &y
        diag_label(l->diags, diag_report(l->diags, DIAG_absent_operator, lexer_span(l, t->at, t->len), spelling), DIAG_label_no_pointers);
        return;
    }
    d = diag_report(l->diags, DIAG_foreign_operator, lexer_span(l, t->at, t->len), spelling, native);
    if (has_unclear_meaning(l, t)) {
        diag_label(l->diags, d, DIAG_label_no_bits, native);
        return;
    }
    diag_label(l->diags, d, DIAG_label_write, native);
    if (names_value || (*native == 'n' && !hint_is_negated_alone(l->src->text, t->at + t->len)) ||
        (*spelling == ':' && !follows_target_only(l, t->at)))
        return;
    while (*native == ':' && from && is_space_tab_or_return(l->src->text[from - 1]))
        from--;
    diag_edit(l->diags, d, lexer_span(l, from, t->at + t->len - from),
              format_in(l->diags->arena, "%s%s%s", needs_space && t->at && lexer_is_word(l->src->text[t->at - 1]) ? " " : "",
                        native, needs_space && lexer_is_word(lexer_byte(l, t->at + t->len)) ? " " : ""));
}

// Returns held(c, 2 s) for the arguments of a timer, as in TON(IN := c, PT := T#2s), which begin at `at`; NULL if they are no such arguments.
static const char *format_timer(const Lexer *l, uint32_t at)
{
    const char *s = l->src->text;
    const uint32_t from = hint_skip_spaces(l, at), end = from + (uint32_t)strcspn(s + from, ",)\n");
    const char *time = strstr(s + end, "T#");
    const uint32_t line = end + (uint32_t)strcspn(s + end, "\n");
    uint32_t number, unit;

    if (s[end] != ',' || !time || time > s + line)
        return NULL;
    number = (uint32_t)(time - s) + 2;
    unit = number + (uint32_t)strspn(s + number, "0123456789.");
    return format_in(l->diags->arena, "held(%s, %s %s)", lexer_text(l, from, end), lexer_text(l, number, unit),
                     lexer_text(l, unit, lexer_skip_word(l, unit)));
}

// Reports the := of an argument, as in TON(IN := c, PT := T#2s), and skips the other arguments: a # in them begins no comment.
static void report_named_argument(Lexer *l, Token *t)
{
    const char *s = l->src->text, *timer = format_timer(l, t->at + t->len);
    uint32_t end = t->at, depth = 1;
    Diag *d = diag_report(l->diags, DIAG_absent_operator, lexer_span(l, t->at, t->len), ":=");

    for (; s[end] && s[end] != '\n'; end++) {
        depth += s[end] == '(';
        if (s[end] == ')' && --depth == 0)
            break;
    }
    if (timer)
        diag_label(l->diags, d, DIAG_label_write, timer);
    else
        diag_label(l->diags, d, DIAG_label_argument_names);
    lexer_finish_token(l, t, TOK_ERROR, end);
}

// Reports the operator t, which this language does not have. `native` is the equivalent of this language; if it is NULL, `label` explains
// what to write instead.
void hint_report_operator(Lexer *l, Token *t, const char *spelling, const char *native, const char *label)
{
    if (strcmp(spelling, ":=") == 0 && l->parens > 0) {
        report_named_argument(l, t);
    } else if (native && is_bit_operator(l, t)) {
        Diag *d = diag_report(l->diags, DIAG_absent_operator, lexer_span(l, t->at, t->len), spelling);
        if (*spelling == '~' && hint_follows_value(l, t->first))              // x ~ 5
            diag_label(l->diags, d, DIAG_label_write, "abs(a - b) < 0.001");
        else
            diag_label(l->diags, d, DIAG_label_bits);
        t->kind = *spelling == '~' ? TOK_MINUS : TOK_STAR;
    } else if (native) {
        report_foreign_spelling(l, t, spelling, native);
    } else if (label) {
        Diag *d = diag_report(l->diags, DIAG_absent_operator, lexer_span(l, t->at, t->len), spelling);
        diag_label(l->diags, d, DIAG_label_text, label);
    }
}

// ---- bars ----

// Reports |a - |b||, where it is ambiguous which bars form a pair, and skips up to the last bar of the line.
static void report_nested_bars(Lexer *l, Token *t)
{
    uint32_t at = l->at, end = at + 1;
    Diag *d;

    for (uint32_t p = end; !hint_ends_line(l, p); p++)
        if (lexer_byte(l, p) == '|')
            end = p + 1;
    d = diag_report(l->diags, DIAG_absent_operator, lexer_span(l, at, end - at), lexer_text(l, at, end));
    diag_label(l->diags, d, DIAG_label_write, "abs(x)");
    lexer_finish_token(l, t, TOK_ERROR, end);
}

// Whether the text from `at` to `end`, between two bars, is a single value or expression.
static bool is_single_value(const Lexer *l, uint32_t at, uint32_t end)
{
    const char *s = l->src->text;
    uint32_t depth = 0, last = end;

    at = hint_skip_spaces(l, at);
    while (last > at && is_space_tab_or_return(s[last - 1]))
        last--;
    if (last == at || !(lexer_is_word(s[last - 1]) || s[last - 1] == ')' || s[last - 1] == '.') ||
        !(lexer_is_word(s[at]) || strchr("(-+.", s[at])))
        return false;
    for (; at < last; at++) {
        depth += s[at] == '(';
        if (strchr(",;:{}\"", s[at]) || (s[at] == ')' && depth-- == 0))
            return false;
    }
    return depth == 0;
}

// Reads |x|, the absolute value in mathematics, as (x).
HintResult hint_read_bars(Lexer *l, Token *t)
{
    uint32_t at = l->at, end = at + t->len;
    const char *fixed;
    Diag *d;

    if (at == l->bar && at > 0) {
        lexer_finish_token(l, t, TOK_RPAREN, end);
        return HINT_READ;
    }
    if (hint_follows_value(l, t->first) || (lexer_byte(l, end) == '|' && is_space_tab_or_return(lexer_byte(l, end + 1))))
        return HINT_NONE;
    end += lexer_byte(l, end) == '|';                  // `||a| - b|` begins with two bars
    while (lexer_byte(l, end) != '|' && !hint_ends_line(l, end))
        end++;
    if (lexer_byte(l, end) != '|')
        return HINT_NONE;
    if (lexer_byte(l, at + 1) == '|' || lexer_byte(l, end + 1) == '|' || !is_single_value(l, at + 1, end)) {
        report_nested_bars(l, t);
        return HINT_READ;
    }
    fixed = format_in(l->diags->arena, "abs(%s)", lexer_text(l, at + 1, end));
    d = diag_report(l->diags, DIAG_absent_operator, lexer_span(l, at, end + 1 - at), lexer_text(l, at, end + 1));
    diag_label(l->diags, d, DIAG_label_write, fixed);
    diag_edit(l->diags, d, lexer_span(l, at, 1), at > 0 && lexer_is_word(l->src->text[at - 1]) ? " abs(" : "abs(");
    diag_edit(l->diags, d, lexer_span(l, end, 1), ")");
    l->bar = end;
    lexer_finish_token(l, t, TOK_LPAREN, at + 1);
    return HINT_READ;
}
