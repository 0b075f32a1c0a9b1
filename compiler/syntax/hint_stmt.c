// SPDX-License-Identifier: Apache-2.0
// Hints for statements: a guard without its body, a value where a statement should be, statements of other languages. See hint_expr.c.
#include <string.h>

#include "compiler/syntax/hint_lines.h"
#include "compiler/syntax/hint_unit.h"
#include "compiler/syntax/hint_words.h"
#include "compiler/syntax/parser.h"

// ---- expressions used as statements ----

// T > 5 s: ...
static bool unit_in_guard(Parser *p)
{
    if (p->last.kind != TOK_NUMBER || p->tok.kind != TOK_NAME ||
        (p->ahead.kind != TOK_COLON && p->ahead.kind != TOK_LBRACE))
        return false;
    if (!(p->lex.src->text[p->tok.at] & 0x80))         // 5° is already reported
        hint_unit(p->diags, parser_report(p, DIAG_expected_end, parser_here(p), parser_describe(p, &p->tok)),
                  parser_text(p, parser_span(p, &p->last)), p->tok.text->text);
    p->failed = true;
    return true;
}

// `then` and `do`.
static void colon_word(Parser *p)
{
    uint32_t from = p->last.at + p->last.len;
    Diag *d = parser_report(p, DIAG_foreign_word, parser_here(p), p->tok.text->text);

    if (p->ahead.first) {
        diag_label(p->diags, d, DIAG_label_braces_instead);
    } else {
        diag_label(p->diags, d, DIAG_label_colon_instead);
        if (p->ahead.kind != TOK_NUMBER && (p->ahead.kind == TOK_COLON || !hint_is_first_of_several(p->lex.src, p->ahead.at)))
            diag_edit(p->diags, d, (Span){p->lex.src, from, p->tok.at + p->tok.len - from}, p->ahead.kind == TOK_COLON ? "" : ":");
    }
    parser_next(p);
    if (p->tok.kind == TOK_COLON && !p->tok.first)
        parser_next(p);
}

// Returns the word or number after blanks at *at, and moves *at to its end; returns "" if there is none.
static const char *take_word(const Parser *p, uint32_t *at)
{
    const char *text = p->lex.src->text;
    uint32_t from, end;

    for (from = *at; text[from] == ' '; from++)
        ;
    for (end = from; is_letter(text[end]) || is_digit(text[end]) || text[end] == '.'; end++)
        ;
    *at = end;
    return parser_text(p, (Span){p->lex.src, from, end - from});
}

// x between a and b, where `between` is the current token.
static const char *between_text(const Parser *p, const AstExpr *e)
{
    uint32_t at = p->ahead.at;
    const char *lo = take_word(p, &at);
    const bool known = strcmp(take_word(p, &at), "and") == 0;
    const char *hi = known ? take_word(p, &at) : "";

    return format_in(p->arena, "write %s <= %s <= %s", *hi ? lo : "3", parser_text(p, e->span), *hi ? hi : "5");
}

// The text after the guard on its line is not a statement: a colon would not help.
static bool prose_in_guard(Parser *p, AstExpr *e)
{
    Diag *d;

    if (p->tok.kind == TOK_COMMA && e->kind != AST_NAME && p->ahead.kind == TOK_NAME)
        d = parser_fail(p, DIAG_guard_without_body, parser_gap(p), parser_found(p));
    else if (p->tok.kind == TOK_NAME && p->ahead.kind != TOK_ASSIGN && hint_is_guard(p))
        d = parser_fail(p, DIAG_guard_without_body, parser_here(p), parser_found(p));
    else
        return false;
    if (p->tok.kind == TOK_COMMA)
        diag_label(p->diags, d, DIAG_label_colon_instead);
    else if (hint_is_word(&p->tok, "between"))
        diag_label(p->diags, d, DIAG_label_text, between_text(p, e));
    return true;
}

// p > 5 => Idle: the lexer has also reported the missing colon.
static bool is_foreign_arrow(const Parser *p) { return p->tok.kind == TOK_ARROW && p->lex.src->text[p->tok.at] == '='; }

// No edit if more statements follow: after a colon all of them would depend on the condition.
static void edit_colon(Parser *p, Diag *d)
{
    if (!hint_is_first_of_several(p->lex.src, p->tok.at))
        diag_edit(p->diags, d, parser_gap(p), ":");
}

// Another statement follows the guard on its line, or a word that other languages require there.
static bool missing_colon(Parser *p, AstExpr *e)
{
    Diag *d;

    if (p->tok.first)
        return false;
    if (hint_is_word(&p->tok, "then") || hint_is_word(&p->tok, "do")) {
        colon_word(p);
        return true;
    }
    if (unit_in_guard(p) || prose_in_guard(p, e))
        return true;
    if (p->tok.kind != TOK_ARROW && p->tok.kind != TOK_NAME && p->tok.kind != TOK_ANNOTATION && p->tok.kind != TOK_IF)
        return false;
    if (is_foreign_arrow(p))
        return true;
    d = parser_report(p, DIAG_guard_without_body, parser_gap(p), parser_found(p));
    diag_label(p->diags, d, DIAG_label_insert_colon);
    edit_colon(p, d);
    return true;
}

static void assign_to_expression(Parser *p, const AstExpr *e)
{
    if (hint_is_guard(p)) {
        hint_assign(p, e, parser_here(p));
        p->failed = true;
    } else {
        parser_fail(p, DIAG_assign_target, e->span, parser_text(p, e->span));
    }
}

static void no_effect(Parser *p, AstExpr *e)
{
    Diag *d;

    if (e->kind == AST_NAME && hint_is_label(e->name->text) && !e->name->declared) {
        d = parser_report(p, DIAG_label_without_dot, e->span, e->name->text);
        diag_edit(p->diags, d, (Span){e->span.src, e->span.at, 0}, ".");
        e->kind = AST_ERROR;
        return;
    }
    e->alone = p->kind == FILE_SM && (e->kind == AST_NAME || e->kind == AST_CALL);
    if (e->alone)
        return;
    d = parser_report(p, DIAG_no_effect, e->span);
    if (p->tok.kind == TOK_AND || p->tok.kind == TOK_OR) {         // the next line continues the guard
        diag_label(p->diags, d, DIAG_label_line_break);
        do
            parser_next(p);
        while (!p->tok.first && p->tok.kind != TOK_RBRACE);
    } else if (e->kind == AST_BINARY && p->kind == FILE_SS)
        diag_label(p->diags, d, DIAG_label_text, format_in(p->arena, "to check this, write @assert %s", parser_text(p, e->span)));
    else if (e->kind == AST_BINARY && e->op == SM_OP_EQ && e->a->kind == AST_NAME)
        diag_label(p->diags, d, DIAG_label_store,
                   format_in(p->arena, "%s = %s", e->a->name->text, parser_text(p, e->b->span)));
    else
        diag_label(p->diags, d, DIAG_label_statements);
}

// Reports two names in a row: prose, or text of another language.
static void no_statement(Parser *p, AstExpr *e)
{
    Diag *d = parser_fail(p, DIAG_no_statement, e->span, e->name->text);

    if (hint_is_word(&p->tok, "between"))
        diag_label(p->diags, d, DIAG_label_text, between_text(p, e));
    else
        diag_label(p->diags, d, DIAG_label_statements);
    e->kind = AST_ERROR;
}

void hint_expression(Parser *p, AstExpr *e, bool has_if)
{
    if (p->failed)
        return;
    if (p->tok.kind == TOK_ASSIGN && !p->tok.first)
        assign_to_expression(p, e);
    else if (!has_if && e->kind == AST_NAME && p->tok.kind == TOK_NAME && !p->tok.first && !hint_is_word(&p->tok, "then"))
        no_statement(p, e);
    else if (missing_colon(p, e))
        return;
    else if (!parser_at_end_of_statement(p))
        hint_at_end(p);
    else if (has_if)
        diag_label(p->diags, parser_fail(p, DIAG_guard_without_body, parser_gap(p), parser_found(p)), DIAG_label_text,
                   "insert '{', and write '}' below the statements that depend on it");
    else
        no_effect(p, e);
}

void hint_colon(Parser *p, AstExpr *guard, Span colon)
{
    const char *before = guard ? parser_text(p, guard->span) : "else";
    Diag *d;

    if (guard && guard->kind == AST_NAME && hint_is_label(guard->name->text) && !guard->name->declared && p->tok.first) {
        d = parser_report(p, DIAG_label_without_dot, guard->span, guard->name->text);
        diag_edit(p->diags, d, (Span){colon.src, guard->span.at, 0}, ".");
        diag_edit(p->diags, d, colon, "");
        guard->kind = AST_ERROR;
        return;
    }
    d = parser_report(p, DIAG_colon_line_break, colon, guard ? "the condition" : "'else'", parser_found(p));
    if (p->tok.first && p->tok.kind != TOK_ELSE && !parser_at_end_of_block(p)) {
        diag_label(p->diags, d, DIAG_label_braces_instead);
        const uint32_t end = hint_indented_lines(p->diags, d, colon.src, colon.at);
        p->indented = end > p->indented ? end : p->indented;
    } else {
        diag_label(p->diags, d, DIAG_label_statement_here);
    }
    diag_note(p->diags, d, (Span){0}, DIAG_note_write_braces, before);
}

// x: = 1
void hint_colon_assign(Parser *p, const AstExpr *guard, Span colon)
{
    Diag *d = parser_fail(p, DIAG_expected_statement, parser_here(p), "'='");

    if (guard && guard->kind == AST_NAME) {
        diag_label(p->diags, d, DIAG_label_store, format_in(p->arena, "%s = ...", guard->name->text));
        diag_edit(p->diags, d, colon, "");
    }
}

// -> [Idle]
bool hint_bracketed_state(Parser *p)
{
    Diag *d;

    if (p->tok.kind != TOK_HEADER || p->tok.first)
        return false;
    d = parser_report(p, DIAG_transition_without_state, parser_here(p), parser_describe(p, &p->tok));
    diag_label(p->diags, d, DIAG_label_write, p->tok.text->text);
    diag_edit(p->diags, d, parser_here(p), p->tok.text->text);
    parser_next(p);
    return true;
}

void hint_else(Parser *p)
{
    Diag *d;

    if (is_foreign_arrow(p))
        return;
    d = parser_report(p, DIAG_else_without_body, parser_gap(p), parser_found(p));
    if (p->tok.first || parser_at_end_of_block(p))
        return;
    diag_label(p->diags, d, DIAG_label_insert_colon);
    edit_colon(p, d);
}

// ---- statements of other languages ----

// `-- …` where an expression is impossible: a comment.
bool hint_remark(Parser *p)
{
    const Source *src = p->lex.src;
    Span sign = parser_here(p);
    Diag *d;

    if (p->tok.kind != TOK_MINUS || p->ahead.kind != TOK_MINUS || !hint_touches(&p->tok, &p->ahead) || hint_is_guard(p))
        return false;
    sign.len = 2;
    d = parser_fail(p, DIAG_foreign_comment, sign, "--");
    diag_label(p->diags, d, DIAG_label_comment);
    diag_edit(p->diags, d, sign, "#");
    while (p->lex.at < src->len && src->text[p->lex.at] != '\n')
        p->lex.at++;
    parser_next(p);
    return true;
}

// Whether the rest of the statement is the current sign and one operand.
static bool ends_after_operand(const Parser *p)
{
    const char *text = p->lex.src->text;
    uint32_t end = hint_skip_operand(text, p->tok.at + p->tok.len);

    end += (uint32_t)strspn(text + end, " \t\r");
    return !text[end] || strchr("\n#;}", text[end]) != NULL;
}

void hint_op_assign(Parser *p, Span name)
{
    const char *sign = parser_text(p, parser_here(p));
    Diag *d = parser_report(p, DIAG_op_assign, parser_here(p), sign);

    diag_label(p->diags, d, DIAG_label_write,
               format_in(p->arena, ends_after_operand(p) ? "%s = %s %c ..." : "%s = %s %c (...)", parser_text(p, name), parser_text(p, name), sign[0]));
}

static const char wait_text[] = "put what follows in braces, under a limit to the time in the state: T >= 100 { ... }";

typedef enum HintEffect { HINT_IF, HINT_ELSE, HINT_ARROW, HINT_DROP, HINT_SKIP } HintEffect;

// `does`: how the word is read; SKIP: the statement is given up.
static const struct { const char *word; HintEffect does; const char *say; } foreign_words[] = {
    {"if", HINT_IF, "if"}, {"when", HINT_IF, "if"}, {"elif", HINT_IF, "else if"}, {"elseif", HINT_IF, "else if"},
    {"elsif", HINT_IF, "else if"}, {"iff", HINT_IF, "if"},
    {"else", HINT_ELSE, "else"}, {"otherwise", HINT_ELSE, "else"},
    {"goto", HINT_ARROW, "->"}, {"go", HINT_ARROW, "->"}, {"transition", HINT_ARROW, "->"},
    {"let", HINT_DROP, NULL}, {"set", HINT_DROP, NULL}, {"var", HINT_DROP, NULL}, {"const", HINT_DROP, NULL},
    {"while", HINT_SKIP, "there are no loops: write 'if' instead; .step runs again in every step"},
    {"for", HINT_SKIP, "there are no loops: .step runs again in every step"},
    {"repeat", HINT_SKIP, "there are no loops: .step runs again in every step"},
    {"loop", HINT_SKIP, "there are no loops: .step runs again in every step"},
    {"until", HINT_SKIP, "there are no loops: write 'if not (...)' instead; .step runs again in every step"},
    {"unless", HINT_SKIP, "write the opposite condition: if not (...)"},
    {"switch", HINT_SKIP, "write it as if ... else if ... else"}, {"case", HINT_SKIP, "write it as if ... else if ... else"},
    {"return", HINT_SKIP, "put what follows into an 'else'"}, {"break", HINT_SKIP, "put what follows into an 'else'"},
    {"wait", HINT_SKIP, wait_text}, {"delay", HINT_SKIP, wait_text}, {"sleep", HINT_SKIP, wait_text},
    {"end", HINT_SKIP, "close braces with }"}, {"endif", HINT_SKIP, "close braces with }"},
    {"assert", HINT_SKIP, "write @assert"}, {"stop", HINT_SKIP, "write @stop"}};

// Whether the word is used as in another language, and not as a name of this one.
static bool stands_foreign(const Parser *p, HintEffect does)
{
    const Token *next = &p->ahead;

    if (next->first)
        return does == HINT_SKIP && next->kind != TOK_LBRACE;     // `stop` with { on the next line is a guard
    if (does == HINT_ELSE)
        return next->kind == TOK_IF || next->kind == TOK_NAME || next->kind == TOK_ARROW;     // ELSE: can be a guard
    return hint_begins_value(next) && (next->kind != TOK_LPAREN || does == HINT_IF || does == HINT_SKIP);
}

// Whether the token after a statement's first word allows any word to be foreign. After a name of this language it is mostly `=`.
static bool may_follow_foreign(const Token *next)
{
    return next->first || hint_begins_value(next) || next->kind == TOK_IF || next->kind == TOK_ARROW;
}

// Returns the text after the name of a declaration among statements: "" or "= 3".
static const char *value_of_decl(const Parser *p, uint32_t at)
{
    const char *text = p->lex.src->text;
    uint32_t end;

    while (text[at] == ' ' || text[at] == '\t')
        at++;
    end = at + (uint32_t)strcspn(text + at, "#;}\r\n");
    while (end > at && (text[end - 1] == ' ' || text[end - 1] == '\t'))
        end--;
    return text[at] == '=' && end > at + 1 ? parser_text(p, (Span){p->lex.src, at, end - at}) : "";
}

static bool is_number_text(const char *s)
{
    return strcmp(s, "true") == 0 || strcmp(s, "false") == 0 || (*s && s[strspn(s, "-+.0123456789eE_")] == '\0');
}

// The declaration of a variable among statements: U8 x, int x = 3, const U8 x = 3. Its value would be assigned every time it is executed;
// the initial value of a local is not.
static void misplaced_decl(Parser *p)
{
    Diag *d = parser_fail(p, DIAG_decl_in_state, parser_here(p));
    const bool word = p->tok.kind == TOK_NAME && (hint_is_word(&p->tok, "const") || hint_is_word(&p->tok, "var"));
    uint32_t at = p->ahead.at;
    const char *type = word ? take_word(p, &at) : p->tok.text->text, *name = take_word(p, &at);
    const char *value = value_of_decl(p, at), *initial;

    if (parse_foreign_type(type))
        type = parse_foreign_type(type);
    if (!is_identifier(name, strlen(name)))
        return;
    initial = *value && is_number_text(value + 1 + strspn(value + 1, " ")) ? value : "= 0";
    if (word && hint_is_word(&p->tok, "const") && initial == value)
        diag_label(p->diags, d, DIAG_label_decl_constant, type, name, value);
    else if (*value)
        diag_label(p->diags, d, DIAG_label_decl_and_store, type, name, initial, format_in(p->arena, "%s %s", name, value));
    else
        diag_label(p->diags, d, DIAG_label_decl, type, name);
}

// goto Idle, go to Idle, transition to Idle
static void replace_arrow(Parser *p)
{
    Diag *d = parser_report(p, DIAG_foreign_word, parser_here(p), p->tok.text->text);
    uint32_t at = p->tok.at;

    if (hint_is_word(&p->ahead, "to") && !p->ahead.first)
        parser_next(p);
    diag_label(p->diags, d, DIAG_label_write, "->");
    diag_edit(p->diags, d, (Span){p->lex.src, at, p->tok.at + p->tok.len - at}, "->");
    p->tok.kind = TOK_ARROW;
}

// wait(200), delay(200), sleep(2): the message repeats that number. In other languages delay takes milliseconds and sleep takes seconds.
static const char *waited(const Parser *p)
{
    uint32_t at = p->ahead.at + (p->ahead.kind == TOK_LPAREN);
    const char *number = p->ahead.first ? "" : take_word(p, &at), *unit = "if 'G' counts milliseconds";

    if (!is_digit(*number))
        return wait_text;
    if (hint_is_word(&p->tok, "sleep"))
        number = hint_milliseconds(p->arena, number, "s");
    else if (!hint_is_word(&p->tok, "delay"))
        unit = "in the unit of 'G'";
    return number ? format_in(p->arena, "put what follows in braces: T >= %s { ... }, %s", number, unit) : wait_text;
}

// for (...; ...; ...): skips the parentheses, which are already reported.
static void skip_header_of_loop(Parser *p)
{
    const char *text = p->lex.src->text;
    uint32_t at = p->ahead.at, depth = 0;

    if (p->ahead.kind != TOK_LPAREN || p->ahead.first)
        return;
    for (; text[at] && text[at] != '\n'; at++) {
        depth += text[at] == '(' ? 1u : 0;
        if (text[at] == ')' && --depth == 0) {
            p->lex.at = at;
            return;
        }
    }
}

static bool apply_hint(Parser *p, HintEffect does, const char *say)
{
    Diag *d;

    switch (does) {
    case HINT_IF:    hint_replace_word(p, say, TOK_IF); return false;
    case HINT_ELSE:  hint_replace_word(p, say, TOK_ELSE); p->lost_body = true; return false;
    case HINT_ARROW: replace_arrow(p); return false;
    case HINT_DROP:  break;
    case HINT_SKIP:
        d = parser_fail(p, DIAG_foreign_word, parser_here(p), p->tok.text->text);
        diag_label(p->diags, d, DIAG_label_text, say == wait_text ? waited(p) : say);
        skip_header_of_loop(p);
        parser_next(p);
        return true;
    }
    d = parser_report(p, DIAG_foreign_word, parser_here(p), p->tok.text->text);
    diag_label(p->diags, d, DIAG_label_leave_out);
    diag_edit(p->diags, d, (Span){p->lex.src, p->tok.at, p->ahead.at - p->tok.at}, "");
    parser_next(p);
    return false;
}

// U8 x, int x, const U8 x
static bool is_decl(const Parser *p)
{
    const bool name = p->ahead.kind == TOK_NAME, type = p->ahead.kind == TOK_TYPE;

    if (p->ahead.first || (!name && !type))
        return false;
    return (p->tok.kind == TOK_TYPE && name) || (p->tok.kind == TOK_NAME && (name ? parse_foreign_type(p->tok.text->text) != NULL
                                                                              : hint_is_word(&p->tok, "const") || hint_is_word(&p->tok, "var")));
}

bool hint_statement(Parser *p)
{
    if (hint_remark(p))
        return true;
    if (is_decl(p)) {
        misplaced_decl(p);
        return true;
    }
    if (p->tok.kind != TOK_NAME || !may_follow_foreign(&p->ahead))
        return false;
    for (size_t i = 0; i < sizeof foreign_words / sizeof *foreign_words; i++)
        if (hint_is_word(&p->tok, foreign_words[i].word) && stands_foreign(p, foreign_words[i].does))
            return apply_hint(p, foreign_words[i].does, foreign_words[i].say);
    return false;
}
