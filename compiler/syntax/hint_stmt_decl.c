// SPDX-License-Identifier: Apache-2.0
// Hints in statements: declarations of variables, which belong before the first state.
#include "compiler/syntax/hint_rules.h"
#include "compiler/syntax/lexer.h"

// Returns the initial value, as in "= 3", that follows the name of a declaration at `at`; "" if no initial value follows.
static const char *find_decl_value(const Parser *p, uint32_t at)
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

// Whether the current word begins declarations in other languages: const U8 x = 3, let x = 3.
static bool is_word_of_declaration(const Parser *p)
{
    return hint_is_word(&p->tok, "const") || hint_is_word(&p->tok, "var") || hint_is_word(&p->tok, "let") || hint_is_word(&p->tok, "auto");
}

// Whether such a word is followed by the name of a new variable and its value, as in let x = 3.
static bool is_untyped(const Parser *p)
{
    const Token *name = &p->ahead;

    return is_word_of_declaration(p) && name->kind == TOK_NAME && !name->text->declared && *find_decl_value(p, name->at + name->len);
}

// Skips the rest of the line, also a [3] on it, which would be a header.
static void skip_rest_of_line(Parser *p)
{
    hint_skip_to(p, p->tok.at + (uint32_t)strcspn(p->lex.src->text + p->tok.at, "#}\n"));
}

// Reports the declaration of a variable among statements: U8 x, int x = 3, const U8 x = 3, let x = 3. As a statement it would
// assign its value every time it is executed; the initial value of a local is assigned only once.
HintResult hint_report_decl_in_state(HintCase *c)
{
    Parser *p = c->p;
    Diag *d = parser_fail(p, DIAG_decl_in_state, parser_token_span(p));
    const bool word = p->tok.kind == TOK_NAME && is_word_of_declaration(p);
    uint32_t at = p->ahead.at;
    const char *type = is_untyped(p) ? "F64" : word ? hint_read_word(p, &at) : p->tok.text->text, *name = hint_read_word(p, &at);
    const char *value = find_decl_value(p, at), *initial = "= 0";

    if (hint_find_synonym(HINT_TYPES, type))
        type = hint_find_synonym(HINT_TYPES, type);
    if (!lex_is_identifier(name, strlen(name)))
        return HINT_SKIPPED;
    if (p->lex.src->text[at] == '[') {
        diag_label(p->diags, d, DIAG_label_decl_array, type, name, type, name);
        skip_rest_of_line(p);
        return HINT_SKIPPED;
    }
    if (*value && strpbrk(value, "\"'")) {
        diag_label(p->diags, d, DIAG_label_no_texts);
        return HINT_SKIPPED;
    }
    if (*value) {
        const char *number = value + 1 + strspn(value + 1, " ");
        const size_t digits = strspn(number, "-+.0123456789");
        if (digits > 0 && strspn(number + digits, "fFuUlL") == strlen(number + digits))           // 5.0f
            value = format_in(p->arena, "= %.*s", (int)digits, number);
        number = value + 1 + strspn(value + 1, " ");
        const bool is_truth = strcmp(number, "true") == 0 || strcmp(number, "false") == 0;
        if (is_truth || (*number && number[strspn(number, "-+.0123456789eE_")] == '\0'))
            initial = value;
        if (is_truth && is_untyped(p))
            type = "bool";
    }
    if (word && hint_is_word(&p->tok, "const") && initial == value)
        diag_label(p->diags, d, DIAG_label_decl_constant, type, name, value);
    else if (*value)
        diag_label(p->diags, d, DIAG_label_decl_and_store, type, name, initial, format_in(p->arena, "%s %s", name, value));
    else
        diag_label(p->diags, d, DIAG_label_decl, type, name);
    return HINT_SKIPPED;
}

// Reports a declaration of another language among statements, as int x = 3 or const U8 x = 3.
HintResult hint_report_foreign_decl(HintCase *c)
{
    const Parser *p = c->p;
    const bool has_type = p->ahead.kind == TOK_TYPE || hint_find_synonym(HINT_TYPES, p->ahead.text->text) != NULL;
    const bool is_decl = is_word_of_declaration(p) ? has_type || is_untyped(p) : hint_find_synonym(HINT_TYPES, p->tok.text->text) != NULL;

    return is_decl ? hint_report_decl_in_state(c) : HINT_NONE;
}

// Reports a declaration with a star, as in char *s.
HintResult hint_report_pointer(HintCase *c)
{
    Parser *p = c->p;
    const bool is_text = hint_is_word(&p->tok, "char"), in_state = c->context == HINT_AT_STATEMENT;
    Diag *d;

    if (!hint_find_synonym(HINT_TYPES, p->tok.text->text) || p->tok.text->declared)
        return HINT_NONE;
    d = in_state ? parser_report(p, DIAG_decl_in_state, parser_token_span(p))
                 : parser_report(p, DIAG_type_unknown, parser_token_span(p), parser_text(p, parser_token_span(p)));
    diag_label(p->diags, d, is_text ? DIAG_label_no_texts : DIAG_label_no_pointers);
    skip_rest_of_line(p);
    return HINT_SKIPPED;
}
