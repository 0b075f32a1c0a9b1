// SPDX-License-Identifier: Apache-2.0
// Hints: errors of users who know other languages, do not program, or type fast. Where the grammar does not allow the next token, these
// functions find the likeliest cause and report it instead of the expected token.
#include "compiler/syntax/hint_lines.h"
#include "compiler/syntax/hint_text.h"
#include "compiler/syntax/hint_unit.h"
#include "compiler/syntax/hint_words.h"
#include "compiler/syntax/parser.h"

// ---- words ----

static bool same_letters(const char *a, const char *lower)
{
    for (; *a && *lower; a++, lower++)
        if ((*a >= 'A' && *a <= 'Z' ? *a - 'A' + 'a' : *a) != *lower)
            return false;
    return !*a && !*lower;
}

bool hint_is_word(const Token *t, const char *lower) { return t->kind == TOK_NAME && same_letters(t->text->text, lower); }

bool hint_begins_value(const Token *t)
{
    return t->kind == TOK_NAME || t->kind == TOK_NUMBER || t->kind == TOK_LPAREN || t->kind == TOK_TRUE ||
           t->kind == TOK_FALSE || t->kind == TOK_NOT || t->kind == TOK_BANG;
}

// Reports our spelling of the current word and reads the word as that token.
void hint_replace_word(Parser *p, const char *native, TokenKind kind)
{
    Diag *d = parser_report(p, DIAG_foreign_word, parser_here(p), p->tok.text->text);

    diag_label(p->diags, d, DIAG_label_write, native);
    diag_edit(p->diags, d, parser_here(p), native);
    p->tok.kind = kind;
}

// ---- in expressions ----

// In some languages the operand of NOT is longer than here: NOT a > b.
void hint_prefix(Parser *p)
{
    const bool negates = hint_is_word(&p->tok, "not") && hint_begins_value(&p->ahead) && (p->parens || !p->ahead.first);

    if (negates && hint_is_negated_alone(p->lex.src->text, p->tok.at + p->tok.len)) {
        hint_replace_word(p, "not", TOK_NOT);
    } else if (negates) {
        diag_label(p->diags, parser_fail(p, DIAG_foreign_word, parser_here(p), p->tok.text->text), DIAG_label_write, "not (...)");
        p->tok.kind = TOK_NOT;
    }
}

// Returns the operator in words that begins with the current word, if a value follows it; *end: its end.
static const HintPhrase *find_infix(const Parser *p, uint32_t *end)
{
    const HintPhrase *phrase = p->tok.kind == TOK_NAME ? hint_phrase(p->lex.src->text, p->tok.at, end) : NULL;

    if (!phrase)
        return NULL;
    if (*end == p->tok.at + p->tok.len)
        return hint_begins_value(&p->ahead) ? phrase : NULL;
    return hint_skip_operand(p->lex.src->text, *end) > *end ? phrase : NULL;
}

// IF(a; b; c) of spreadsheets: no value begins like this.
bool hint_choice(const Parser *p) { return hint_is_word(&p->tok, "if") && p->ahead.kind == TOK_LPAREN && !p->ahead.first; }

const char *function_usage(const SmBuiltinInfo *fn)
{
    static const char *const usage[] = {"()", "(x)", "(a, b)", "(x, lo, hi)"};

    return fn->is_roll ? "(x, n)" : usage[fn->arguments];
}

static int find_function(Str name)
{
    int i = 0;

    while (i < SM_FN_COUNT && strcmp(name->text, sm_builtin_info[i].name) != 0)
        i++;
    return i;
}

// abs x, where the operand is the current token. An element named `abs` could not have one.
bool hint_operand(Parser *p, AstExpr *name)
{
    Span operand = parser_here(p);
    uint32_t end;
    Diag *d;
    int fn;

    if (p->tok.first || (p->tok.kind != TOK_NAME && p->tok.kind != TOK_NUMBER) || p->ahead.kind == TOK_ASSIGN)
        return false;
    fn = find_function(name->name);
    if (fn == SM_FN_COUNT || find_infix(p, &end) || hint_is_word(&p->tok, "then") || hint_is_word(&p->tok, "do") ||
        hint_is_word(&p->tok, "between"))
        return false;
    d = parser_report(p, DIAG_function_without_call, name->span, name->name->text, name->name->text,
                      function_usage(&sm_builtin_info[fn]));
    parser_next(p);
    if (sm_builtin_info[fn].arguments != 1 ||
        (!p->tok.first && (p->tok.kind == TOK_NAME || p->tok.kind == TOK_NUMBER || p->tok.kind == TOK_LPAREN))) {
        p->failed = true;
        return true;
    }
    if (!p->tok.first && (p->tok.kind == TOK_PLUS || p->tok.kind == TOK_MINUS || p->tok.kind == TOK_STAR || p->tok.kind == TOK_SLASH))
        return true;                                   // abs x - y can mean abs(x - y)
    diag_edit(p->diags, d, (Span){operand.src, name->span.at + name->span.len, operand.at - name->span.at - name->span.len}, "(");
    diag_edit(p->diags, d, (Span){operand.src, operand.at + operand.len, 0}, ")");
    return true;
}

// `x = (p = 9)`, `(x = p) > 3: ...`: in C both assign.
static bool stores_inside(const Parser *p, uint32_t at)
{
    return p->parens > 0 && (!(p->is_guard || hint_is_guard(p)) || hint_stores_in_parens(p->lex.src->text, at));
}

// not x is 3: in other languages the operand of `not` is longer than x.
static bool is_negated(const AstExpr *e) { return e && e->kind == AST_UNARY && e->op == SM_OP_NOT; }

// `valve = true: pump = true`, at the colon: if the colon separates statements, the first one assigns.
static bool separates_statements(const Parser *p)
{
    const char *text = p->lex.src->text;
    uint32_t at = p->tok.at + 1;

    if (p->tok.kind != TOK_COLON || p->tok.first)
        return false;
    at += (uint32_t)strspn(text + at, " \t");
    while (is_letter(text[at]) || is_digit(text[at]))
        at++;
    at += (uint32_t)strspn(text + at, " \t");
    return text[at] == '=' && text[at + 1] != '=' && text[at + 1] != '>';
}

// Handles `=` where two values are compared. `=!` was meant as `!=`, or as `=` and a negation.
void hint_assign(Parser *p, const AstExpr *left, Span sign)
{
    Diag *d;

    if (p->lex.src->text[sign.at + 1] == '!') {
        sign.len = 2;
        diag_label(p->diags, parser_report(p, DIAG_absent_operator, sign, "=!"), DIAG_label_did_you_mean, "!=");
        return;
    }
    d = parser_report(p, DIAG_assign_in_guard, sign);
    diag_label(p->diags, d, DIAG_label_write, "==");
    if (p->lex.src->text[sign.at] == '=' && !is_negated(left) && !stores_inside(p, sign.at) && !hint_is_doubtful_comparison(p->lex.src->text, sign.at + sign.len) && !separates_statements(p))
        diag_edit(p->diags, d, sign, "==");
}

// Reads the words up to `end` as the operator that they mean. If its operands are unclear, gives up the condition.
static void replace_phrase(Parser *p, const AstExpr *left, const HintPhrase *phrase, uint32_t end)
{
    const Span words = {p->lex.src, p->tok.at, end - p->tok.at};
    Diag *d;

    if (phrase->kind != TOK_AND && phrase->kind != TOK_OR && (is_negated(left) || hint_is_doubtful_comparison(p->lex.src->text, end))) {
        d = parser_fail(p, DIAG_foreign_word, words, parser_text(p, words));
        diag_label(p->diags, d, DIAG_label_text, "compare with == != < <= > or >=, and join comparisons with and, or");
        return;
    }
    d = parser_report(p, DIAG_foreign_word, words, parser_text(p, words));
    diag_label(p->diags, d, DIAG_label_write, phrase->native);
    diag_edit(p->diags, d, words, phrase->native);
    while (p->tok.at + p->tok.len < end)
        parser_next(p);
    p->tok.kind = phrase->kind;
}

void hint_infix(Parser *p, const AstExpr *left)
{
    if (p->tok.kind == TOK_NAME) {
        uint32_t end;
        const HintPhrase *phrase = find_infix(p, &end);
        if (phrase)
            replace_phrase(p, left, phrase, end);
        return;
    }
    if (p->tok.kind != TOK_ASSIGN || (!p->is_guard && p->parens == 0))
        return;
    if (p->last.first && p->parens)                    // a new statement: the parenthesis before it was never closed
        return;
    hint_assign(p, left, parser_here(p));
    p->tok.kind = TOK_EQ;
}

bool hint_unit_step(Parser *p)
{
    const char *text = p->lex.src->text;
    uint32_t at = p->last.at;
    char sign[2] = "?";
    Diag *d;

    if ((p->last.kind != TOK_PLUS && p->last.kind != TOK_MINUS) || at == 0 || text[at - 1] != text[at] || !p->tok.first)
        return false;
    sign[0] = text[at];
    d = parser_fail(p, DIAG_op_assign, (Span){p->lex.src, at - 1, 2}, format_in(p->arena, "%s%s", sign, sign));
    diag_label(p->diags, d, DIAG_label_write, format_in(p->arena, "x = x %s 1", sign));
    return true;
}

bool hint_touches(const Token *a, const Token *b) { return a->at + a->len == b->at; }

bool hint_is_label(const char *s)
{
    return strcmp(s, "entry") == 0 || strcmp(s, "step") == 0 || strcmp(s, "exit") == 0;
}

bool hint_dotted_name(Parser *p, Span name)
{
    if (!hint_touches(&p->last, &p->tok) || p->tok.kind != TOK_LABEL || hint_is_label(p->tok.text->text))
        return false;
    name.len += p->tok.len;
    parser_fail(p, DIAG_name_with_dot, name, parser_text(p, name));
    parser_next(p);
    return true;
}

void hint_after_name(Parser *p, AstExpr *name)
{
    Span both = name->span;

    if (!hint_touches(&p->last, &p->tok))
        return;
    both.len += p->tok.len;
    if (hint_dotted_name(p, name->span)) {
        name->kind = AST_ERROR;
    } else if (p->tok.kind == TOK_HEADER && !is_identifier(p->tok.text->text, p->tok.text->len)) {
        name->kind = AST_ERROR;
        parser_fail(p, DIAG_no_lists, both, parser_text(p, both));
        parser_next(p);
    }
}

void hint_equality_chain(Parser *p, const AstExpr *e)
{
    const AstExpr *a = e->a;
    Diag *d = parser_report(p, DIAG_equality_chain, ast_op_span(e), sm_op_info[a->op].spelling, sm_op_info[e->op].spelling);

    diag_label(p->diags, d, DIAG_label_did_you_mean,
               format_in(p->arena, "%s and %s %s %s", parser_text(p, a->span), parser_text(p, a->b->span),
                         sm_op_info[e->op].spelling, parser_text(p, e->b->span)));
}

static bool is_comparison(TokenKind k)
{
    return k == TOK_LT || k == TOK_LE || k == TOK_GT || k == TOK_GE || k == TOK_EQ || k == TOK_NE;
}

// Whether this is a guard: its line, which continues inside parentheses, contains a : or a {; or the next line has a {.
bool hint_is_guard(const Parser *p)
{
    const Source *s = p->lex.src;
    uint32_t depth = 0, i = p->tok.at;
    bool below = false;                                // after the line end, where only '{' may follow

    for (; i < s->len; i++) {
        const char c = s->text[i];
        if (c == '#')
            i += (uint32_t)strcspn(s->text + i, "\n") - 1;
        else if (c == '\n')
            below |= depth == 0;
        else if (below && c != ' ' && c != '\t' && c != '\r')
            return c == '{';
        else if (c == ':' || c == '{' || c == '}')
            return true;
        else if (c == '(' || (c == ')' && depth > 0))
            depth += c == '(' ? 1u : UINT32_MAX;
    }
    return false;
}

// The line ended with an operator and the next line looks like its operand. Skips that line, because the error is already reported.
static void skip_continuation(Parser *p)
{
    while (hint_begins_value(&p->tok) && p->ahead.kind != TOK_ASSIGN && !hint_is_guard(p)) {
        parser_next(p);
        while (!p->tok.first)
            parser_next(p);
        if (p->last.kind != TOK_AND && p->last.kind != TOK_OR && p->last.kind != TOK_PLUS && p->last.kind != TOK_MINUS)
            break;
    }
}

// The statement that ended before `at` shares its line with another. Returns false if no statement ended there.
static bool shares_line(Parser *p, Diag *d, uint32_t at)
{
    const uint32_t until = hint_shared_line(p->diags, d, p->lex.src, at, HINT_OTHER);

    if (until > 0)
        p->lex.hinted = until;
    return until > 0;
}

void hint_missing_value(Parser *p, Diag *d)
{
    if (p->tok.first && p->tok.kind != TOK_END && p->last.kind != TOK_ASSIGN) {
        diag_label(p->diags, d, DIAG_label_line_break);
        skip_continuation(p);
    } else if (p->last.kind == TOK_AND && p->tok.kind == TOK_ARROW && shares_line(p, d, p->last.at)) {
        return;
    } else if ((p->last.kind == TOK_AND || p->last.kind == TOK_OR) && p->tok.kind == TOK_ARROW) {
        diag_label(p->diags, d, DIAG_label_condition_or_colon, p->last.kind == TOK_AND ? "and" : "or");
    } else if ((p->last.kind == TOK_AND || p->last.kind == TOK_OR) && is_comparison(p->tok.kind)) {
        diag_label(p->diags, d, DIAG_label_repeat_name, parser_text(p, parser_here(p)));
    } else if (p->tok.kind == TOK_HEADER && !p->tok.first) {
        diag_label(p->diags, d, DIAG_label_text, "there are no lists: each value has an element of its own");
        parser_next(p);
    } else if (p->tok.kind == TOK_IF && p->last.kind == TOK_IF) {
        diag_label(p->diags, d, DIAG_label_leave_out);
        diag_edit(p->diags, d, (Span){p->lex.src, p->last.at, p->tok.at - p->last.at}, "");
    } else if (p->tok.kind == TOK_IF) {
        diag_label(p->diags, d, DIAG_label_text, hint_no_choice);
        if (!p->ahead.first)
            hint_skip_choice(&p->lex);
    } else if ((p->tok.kind == TOK_AND || p->tok.kind == TOK_OR) && p->ahead.kind == TOK_LPAREN) {
        diag_label(p->diags, d, DIAG_label_write, format_in(p->arena, "a %s b", p->tok.kind == TOK_AND ? "and" : "or"));
    } else if (p->last.kind == TOK_MINUS && p->tok.kind == TOK_GT && p->ahead.kind == TOK_NAME) {
        diag_label(p->diags, d, DIAG_label_write, "->");
    }
}

// ---- where a statement should end ----

// 60,000 can mean sixty thousand; 0,125 and 3,14 cannot.
static bool may_be_thousands(const Parser *p)
{
    return p->ahead.len == 3 && p->lex.src->text[p->last.at] != '0';
}

// 3,14
bool hint_decimal_comma(Parser *p)
{
    const char *before, *after;
    Diag *d;

    if (p->tok.kind != TOK_COMMA || p->last.kind != TOK_NUMBER || p->ahead.kind != TOK_NUMBER ||
        !hint_touches(&p->last, &p->tok) || !hint_touches(&p->tok, &p->ahead))
        return false;
    before = parser_text(p, parser_span(p, &p->last));
    after = parser_text(p, parser_span(p, &p->ahead));
    d = parser_fail(p, DIAG_decimal_comma, parser_here(p));
    if (may_be_thousands(p)) {
        diag_label(p->diags, d, DIAG_label_comma_in_number, before, after, before, after);
    } else {
        diag_label(p->diags, d, DIAG_label_write, format_in(p->arena, "%s.%s", before, after));
        diag_edit(p->diags, d, parser_here(p), ".");
    }
    return true;
}

// T > 5 ms
static bool unit_after_number(const Parser *p)
{
    return p->last.kind == TOK_NUMBER && p->tok.kind == TOK_NAME && (p->ahead.first || p->ahead.kind == TOK_COLON);
}

// At `and then`: no expression continues like this.
bool hint_is_and_then(const Parser *p)
{
    const char *s = p->lex.src->text + p->ahead.at + p->ahead.len;

    if (p->tok.kind != TOK_AND || !hint_is_word(&p->ahead, "then") || p->ahead.first)
        return false;
    s += strspn(s, " \t");
    return is_letter(*s) || (s[0] == '-' && s[1] == '>');
}

static bool is_item(const Token *t)
{
    return t->kind == TOK_ANNOTATION && (strcmp(t->text->text, "assert") == 0 || strcmp(t->text->text, "stop") == 0);
}

// x = true, y = true; x = true y = true; x = true -> Idle; x = true and then -> Idle
static bool begins_statement(const Parser *p)
{
    const bool next = !p->ahead.first && (p->ahead.kind == TOK_NAME || p->ahead.kind == TOK_ARROW || p->ahead.kind == TOK_ANNOTATION);

    return p->tok.kind == TOK_ARROW || is_item(&p->tok) || (p->tok.kind == TOK_COMMA && next) || (hint_is_word(&p->tok, "then") && next) || hint_is_and_then(p) ||
           (p->tok.kind == TOK_NAME && p->ahead.kind == TOK_ASSIGN && !p->ahead.first);
}

void hint_at_end(Parser *p)
{
    Diag *d;

    if (p->tok.kind == TOK_ERROR || (p->ahead.kind == TOK_ERROR && !p->ahead.first) ||
        (p->lex.src->text[p->tok.at] & 0x80) || (p->tok.kind == TOK_ELSE && p->last.at < p->lex.hinted)) {
        p->failed = true;                              // the line is already reported
        return;
    }
    if (hint_decimal_comma(p) || hint_remark(p))
        return;
    if (p->tok.kind == TOK_RPAREN) {
        parser_fail(p, DIAG_stray_paren, parser_here(p));
        return;
    }
    d = parser_fail(p, DIAG_expected_end, parser_here(p), parser_describe(p, &p->tok));
    if (p->tok.kind == TOK_ASSIGN)
        diag_label(p->diags, d, DIAG_label_one_assignment);
    else if (p->tok.kind == TOK_ELSE)
        diag_label(p->diags, d, DIAG_label_else_after_if);
    else if (unit_after_number(p))
        hint_unit(p->diags, d, parser_text(p, parser_span(p, &p->last)), p->tok.text->text);
    else if (p->tok.kind == TOK_IF || hint_is_word(&p->tok, "when"))
        diag_label(p->diags, d, DIAG_label_condition_first);
    else if (annotation_is_allow(&p->tok))
        diag_label(p->diags, d, DIAG_label_allow_before);
    else if (begins_statement(p) && !shares_line(p, d, p->last.at + p->last.len))
        diag_label(p->diags, d, DIAG_label_own_line_or_braces);
    else if (p->tok.kind == TOK_COLON)
        diag_label(p->diags, d, DIAG_label_text, "only one statement can follow ':'; put several in braces, each on a line of its own");
    else if (p->tok.kind == TOK_LPAREN && p->last.kind == TOK_ANNOTATION)
        diag_label(p->diags, d, DIAG_label_write, parser_text(p, parser_span(p, &p->last)));
    else if (p->tok.kind == TOK_LPAREN)
        diag_label(p->diags, d, DIAG_label_text, "to multiply, write *");
    else if (p->tok.kind == TOK_NUMBER && p->last.kind == TOK_NUMBER && p->tok.len == 3)
        diag_label(p->diags, d, DIAG_label_write, format_in(p->arena, "%s%s", parser_text(p, parser_span(p, &p->last)), parser_text(p, parser_here(p))));
}
