// SPDX-License-Identifier: Apache-2.0
// Hints in expressions: operators in words, = for ==, functions without parentheses, values that are missing.
#include "compiler/syntax/hint_lines.h"
#include "compiler/syntax/hint_rules.h"
#include "compiler/syntax/hint_text.h"
#include "compiler/syntax/hint_words.h"
#include "compiler/syntax/lexer.h"
#include "compiler/syntax/time_unit.h"

// ---- words ----

// Reports that the current word is spelled `native` in this language, and reads it as that token.
Diag *hint_replace_word(Parser *p, const char *native, TokenKind kind)
{
    Diag *d = parser_report(p, DIAG_foreign_word, parser_token_span(p), p->tok.text->text);

    diag_label(p->diags, d, DIAG_label_write, native);
    diag_edit(p->diags, d, parser_token_span(p), native);
    p->tok.kind = kind;
    return d;
}

// If an operator in words (`is not`) begins at the current word and a value follows it, returns the operator, and its end in *end; else
// NULL.
static const HintPhrase *find_infix(const Parser *p, uint32_t *end)
{
    const HintPhrase *phrase = p->tok.kind == TOK_NAME ? hint_find_phrase(p->lex.src->text, p->tok.at, end) : NULL;

    if (!phrase)
        return NULL;
    if (*end == p->tok.at + p->tok.len)
        return hint_begins_value(&p->ahead) ? phrase : NULL;
    return hint_skip_operand(p->lex.src->text, *end) > *end ? phrase : NULL;
}

// ---- before an operand ----

// Reads NOT x as not x. Does not propose an edit if the operand depends on the language, as in NOT a > b; suggests parentheses instead.
HintResult hint_read_negation(HintCase *c)
{
    Parser *p = c->p;

    if (p->ahead.first && p->parens == 0)
        return HINT_NONE;
    if (hint_is_negated_alone(p->lex.src->text, p->tok.at + p->tok.len)) {
        hint_replace_word(p, "not", TOK_NOT);
    } else {
        diag_label(p->diags, parser_fail(p, DIAG_foreign_word, parser_token_span(p), p->tok.text->text), DIAG_label_write, "not (...)");
        p->tok.kind = TOK_NOT;
    }
    return HINT_READ;
}

// Turns the IF of a spreadsheet's IF(a; b; c) into the token `if`. No value begins with `if`, so hint_report_choice then reports an error.
HintResult hint_read_if_call(HintCase *c)
{
    c->p->tok.kind = TOK_IF;
    return HINT_READ;
}

// ---- after a name ----

// Returns the number of the built-in function, or SM_FN_COUNT if no function has that name.
static int find_function(Str name)
{
    int i = 0;

    while (i < SM_FN_COUNT && strcmp(name->text, sm_builtin_info[i].name) != 0)
        i++;
    return i;
}

// Whether the current word can follow a value in an item of a script or in a requirement.
static bool is_at_word_after_value(const Parser *p)
{
    static const char *const words[] = {"within", "implies", "leads", "before", "after", "without"};
    const size_t n = p->kind == FILE_RQ ? sizeof words / sizeof *words : p->kind == FILE_SS ? 1 : 0;

    for (size_t i = 0; i < n; i++)
        if (parser_is_word(p, words[i]))
            return true;
    return false;
}

// Reports a function without parentheses, as in `abs x`. The current token is x. This is an error even if an element is named `abs`, because
// no operand can follow a name, but for the word `steps` (language.md 7.25).
HintResult hint_report_missing_call(HintCase *c)
{
    Parser *p = c->p;
    const AstExpr *name = c->e;
    const Span operand = parser_token_span(p);
    const uint32_t name_end = name->span.at + name->span.len;
    const int fn = find_function(name->name);
    uint32_t end;
    Diag *d;

    if (p->ahead.kind == TOK_ASSIGN || fn == SM_FN_COUNT || parser_is_steps(p) || is_at_word_after_value(p) || find_infix(p, &end) ||
        hint_is_word(&p->tok, "then") || hint_is_word(&p->tok, "do") || hint_is_word(&p->tok, "between"))
        return HINT_NONE;
    d = parser_report(p, DIAG_function_without_call, name->span, name->name->text, name->name->text, sm_builtin_info[fn].usage);
    parser_advance(p);
    if (sm_builtin_info[fn].arguments != 1 ||
        (!p->tok.first && (p->tok.kind == TOK_NAME || p->tok.kind == TOK_NUMBER || p->tok.kind == TOK_LPAREN))) {
        p->failed = true;
        return HINT_SKIPPED;
    }
    if (!p->tok.first && (p->tok.kind == TOK_PLUS || p->tok.kind == TOK_MINUS || p->tok.kind == TOK_STAR || p->tok.kind == TOK_SLASH))
        return HINT_SKIPPED;                           // no edit, because abs x - y can mean abs(x - y)
    diag_edit(p->diags, d, (Span){operand.src, name_end, operand.at - name_end}, "(");
    diag_edit(p->diags, d, (Span){operand.src, operand.at + operand.len, 0}, ")");
    return HINT_SKIPPED;
}

// Whether the name is an operand of before, after or without, where a state's name stands alone. The current token is the name.
static bool is_at_state_operand(const Parser *p, const AstExpr *word)
{
    static const char *const words[] = {"before", "after", "without"};
    const char *text = p->lex.src->text;
    uint32_t end = word->span.at, begin;

    while (end > 0 && (text[end - 1] == ' ' || text[end - 1] == '\t'))
        end--;
    for (begin = end; begin > 0 && lexer_is_word(text[begin - 1]); begin--) {}
    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        if ((end - begin == strlen(words[i]) && memcmp(text + begin, words[i], end - begin) == 0) || hint_is_word(&p->ahead, words[i]))
            return true;
    return false;
}

// Reports `state Abort` in a requirement. The current token is Abort.
HintResult hint_report_state_word(HintCase *c)
{
    Parser *p = c->p;
    const Span both = span_join(c->e->span, parser_token_span(p));
    const char *name = p->tok.text->text, *text;
    Diag *d;

    if (p->kind != FILE_RQ || strcmp(c->e->name->text, "state") != 0 || is_at_word_after_value(p) || parser_is_steps(p) ||
        strcmp(name, "in") == 0)
        return HINT_NONE;
    text = is_at_state_operand(p, c->e) ? name : format_in(p->arena, "S == %s", name);
    d = parser_report(p, DIAG_foreign_word, c->e->span, "state");
    diag_label(p->diags, d, DIAG_label_write, text);
    diag_edit(p->diags, d, both, text);
    parser_advance(p);
    return HINT_SKIPPED;
}

// Labels d with what to write instead of a call such as Serial.println(x), time.sleep(1) or valve.open().
static void label_method(Parser *p, Diag *d, const char *before, const char *after)
{
    static const char *const printers[] = {"Serial", "console", "System", "logging", "logger", "log", "sys"};
    bool prints = false;

    for (size_t i = 0; i < sizeof printers / sizeof *printers; i++)
        prints = prints || strcmp(before, printers[i]) == 0;
    if (prints)
        diag_label(p->diags, d, DIAG_label_print_in_script);
    else if (strcmp(after, "sleep") == 0)
        diag_label(p->diags, d, DIAG_label_wait, time_unit_format_call(p->arena, p->lex.src->text + p->ahead.at));
    else
        diag_label(p->diags, d, DIAG_label_store_truth);
}

// Labels d with a name without a dot: for `a.b`, that is a_b; b if a is no part of it, as in self.valve and math.sqrt.
static void label_dotted_name(Parser *p, Diag *d, const char *before, const char *after)
{
    static const char *const owners[] = {"self", "this", "math", "Math", "np", "numpy", "std", "obj"};
    const bool is_call = p->ahead.kind == TOK_LPAREN && !p->ahead.first;
    bool is_owner = false;

    for (size_t i = 0; i < sizeof owners / sizeof *owners; i++)
        is_owner = is_owner || strcmp(before, owners[i]) == 0;
    if (is_call && !is_owner)
        label_method(p, d, before, after);
    else
        diag_label(p->diags, d, DIAG_label_write, is_owner ? after : format_in(p->arena, "%s_%s", before, after));
}

// Reports a name with a dot, as in tank.pressure. The current token is `.pressure`.
HintResult hint_report_dotted_name(HintCase *c)
{
    Parser *p = c->p;
    Span name = parser_span(p, &p->last);

    if (!hint_are_adjacent(&p->last, &p->tok) || hint_is_label(p->tok.text->text))
        return HINT_NONE;
    name.len += p->tok.len;
    label_dotted_name(p, parser_fail(p, DIAG_name_with_dot, name, parser_text(p, name)), p->last.text->text, p->tok.text->text);
    parser_advance(p);
    return HINT_SKIPPED;
}

// ---- after an operand ----

// Whether e is `not x`. In some languages `not` has lower precedence than in this language: `not x is 3` negates all of `x is 3`.
static bool is_negation(const AstExpr *e) { return e && e->kind == AST_UNARY && e->op == SM_OP_NOT; }

// Whether the current token is a colon that may separate two assignments, as in `valve = true: pump = true`.
static bool is_colon_before_assignment(const Parser *p)
{
    const char *text = p->lex.src->text;
    uint32_t at = p->tok.at + 1;

    if (p->tok.kind != TOK_COLON || p->tok.first)
        return false;
    at += (uint32_t)strspn(text + at, " \t");
    while (lex_is_letter(text[at]) || lex_is_digit(text[at]))
        at++;
    at += (uint32_t)strspn(text + at, " \t");
    return text[at] == '=' && text[at + 1] != '=' && text[at + 1] != '>';
}

// Reports the = or =! at `sign` in a condition, and suggests == or !=. `left`: its left operand, or NULL.
void hint_report_assign_in_guard(Parser *p, const AstExpr *left, Span sign)
{
    const char *text = p->lex.src->text;
    bool assigns_in_c;                        // in C the = would be an assignment here, as in `x = (p = 9)`
    Diag *d;

    if (text[sign.at + 1] == '!') {
        sign.len = 2;
        diag_label(p->diags, parser_report(p, DIAG_absent_operator, sign, "=!"), DIAG_label_did_you_mean, "!=");
        return;
    }
    d = parser_report(p, DIAG_assign_in_guard, sign);
    diag_label(p->diags, d, DIAG_label_write, "==");
    assigns_in_c = p->parens > 0 && (!(p->is_guard || hint_line_is_guard(p)) || hint_stores_in_parens(text, sign.at));
    if (text[sign.at] == '=' && !is_negation(left) && !assigns_in_c &&
        !hint_is_doubtful_comparison(text, sign.at + sign.len) && !is_colon_before_assignment(p))
        diag_edit(p->diags, d, sign, "==");
}

// Whether the current `and` joins two statements, as in x = 1 and then -> Idle.
bool hint_is_and_then(const Parser *p)
{
    const char *s = p->lex.src->text + p->ahead.at + p->ahead.len;

    if (p->tok.kind != TOK_AND || !hint_is_word(&p->ahead, "then") || p->ahead.first)
        return false;
    s += strspn(s, " \t");
    return lex_is_letter(*s) || (s[0] == '-' && s[1] == '>');
}

// Reads an operator in words, as in `x is 3`. If the intended operands are unclear, skips the rest of the condition.
HintResult hint_read_phrase(HintCase *c)
{
    Parser *p = c->p;
    uint32_t end;
    const HintPhrase *phrase = find_infix(p, &end);
    Span words;
    Diag *d;

    if (!phrase)
        return HINT_NONE;
    words = (Span){p->lex.src, p->tok.at, end - p->tok.at};
    if (phrase->kind != TOK_AND && phrase->kind != TOK_OR && (is_negation(c->e) || hint_is_doubtful_comparison(p->lex.src->text, end))) {
        d = parser_fail(p, DIAG_foreign_word, words, parser_text(p, words));
        diag_label(p->diags, d, DIAG_label_comparisons);
        return HINT_READ;
    }
    d = parser_report(p, DIAG_foreign_word, words, parser_text(p, words));
    diag_label(p->diags, d, DIAG_label_write, phrase->native);
    diag_edit(p->diags, d, words, phrase->native);
    while (p->tok.at + p->tok.len < end)
        parser_advance(p);
    p->tok.kind = phrase->kind;
    return hint_is_and_then(p) ? HINT_SKIPPED : HINT_READ;
}

// Reads = as == where two values are compared, as in if x = y.
HintResult hint_read_comparison(HintCase *c)
{
    Parser *p = c->p;

    if (!p->is_guard && p->parens == 0)
        return HINT_NONE;
    if (p->last.first && p->parens)                    // a new statement begins, because an earlier parenthesis was never closed
        return HINT_NONE;
    hint_report_assign_in_guard(p, c->e, parser_token_span(p));
    p->tok.kind = TOK_EQ;
    return HINT_READ;
}

// Ends the expression at `and` in x = 1 and then -> Idle.
HintResult hint_end_at_and_then(HintCase *c) { return hint_is_and_then(c->p) ? HINT_SKIPPED : HINT_NONE; }

// Reports an assignment before a colon, as in `x = 5: ...`: it is meant as the condition x == 5.
HintResult hint_report_assignment_as_guard(HintCase *c)
{
    hint_report_assign_in_guard(c->p, NULL, c->p->assign_operator);
    return HINT_READ;
}

// ---- where a value is missing ----

// Reports an increment or decrement: x++ or x--.
HintResult hint_report_increment(HintCase *c)
{
    Parser *p = c->p;
    const char *text = p->lex.src->text;
    uint32_t at = p->last.at;
    char sign[2] = "?";
    const char *name = "x";
    uint32_t end, from;
    Diag *d;

    if (at == 0 || text[at - 1] != text[at])
        return HINT_NONE;
    for (end = at - 1; end > 0 && text[end - 1] == ' '; end--) {}
    for (from = end; from > 0 && lexer_is_word(text[from - 1]); from--) {}
    if (end > from && lex_is_letter(text[from]))
        name = format_in(p->arena, "%.*s", (int)(end - from), text + from);
    sign[0] = text[at];
    d = parser_fail(p, DIAG_op_assign, (Span){p->lex.src, at - 1, 2}, format_in(p->arena, "%s%s", sign, sign));
    if (p->kind == FILE_RQ)
        diag_label(p->diags, d, DIAG_label_changes_nothing);
    else
        diag_label(p->diags, d, DIAG_label_write, format_in(p->arena, "%s = %s %s 1", name, name, sign));
    return HINT_SKIPPED;
}

// Reports an expression whose line ends with an operator. Skips the next line if it looks like the operand, because any error in that line
// would follow from this one.
HintResult hint_report_line_break(HintCase *c)
{
    Parser *p = c->p;

    diag_label(p->diags, hint_report_general(c), DIAG_label_line_break);
    while (hint_begins_value(&p->tok) && p->ahead.kind != TOK_ASSIGN && !hint_line_is_guard(p)) {
        parser_advance(p);
        while (!p->tok.first)
            parser_advance(p);
        if (p->last.kind != TOK_AND && p->last.kind != TOK_OR && p->last.kind != TOK_PLUS && p->last.kind != TOK_MINUS)
            break;
    }
    return HINT_READ;
}

// Reports a transition that is written as an operand, as in `x = 1 and -> Idle`.
HintResult hint_report_and_arrow(HintCase *c)
{
    Parser *p = c->p;
    Diag *d = hint_report_general(c);

    if (p->last.kind == TOK_OR || !hint_label_line_sharing(p, d, p->last.at))
        diag_label(p->diags, d, DIAG_label_condition_or_colon, p->last.kind == TOK_AND ? "and" : "or");
    return HINT_READ;
}

// Reports a comparison without its left operand, as in x > 5 and < 6.
HintResult hint_report_comparison_without_left(HintCase *c)
{
    diag_label(c->p->diags, hint_report_general(c), DIAG_label_repeat_name, parser_text(c->p, parser_token_span(c->p)));
    return HINT_READ;
}

// Reports a list, which the language does not have, as in x = [1, 2].
HintResult hint_report_list(HintCase *c)
{
    diag_label(c->p->diags, hint_report_general(c), DIAG_label_list);
    parser_advance(c->p);
    return HINT_READ;
}

// Reports a repeated `if`, as in if if x.
HintResult hint_report_second_if(HintCase *c)
{
    const Token *first = &c->p->last;
    Diag *d = hint_report_general(c);

    diag_label(c->p->diags, d, DIAG_label_leave_out);
    diag_edit(c->p->diags, d, (Span){c->p->lex.src, first->at, c->p->tok.at - first->at}, "");
    return HINT_READ;
}

// Reports a conditional that is used as a value, as in `x = if y ...`.
HintResult hint_report_choice(HintCase *c)
{
    diag_label(c->p->diags, hint_report_general(c), DIAG_label_text, hint_no_choice);
    if (!c->p->ahead.first)
        hint_skip_choice(&c->p->lex);
    return HINT_READ;
}
