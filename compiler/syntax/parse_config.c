// SPDX-License-Identifier: Apache-2.0
// Parses the pins of a .io (config.md 9): each has a direction, a number and an element, in which line ends count as spaces.
#include "compiler/syntax/hints.h"
#include "compiler/syntax/parser.h"

// ---- sections ----

void parser_report_pin_section(Parser *p, const AstSection *s)
{
    static const char *const sections[] = {"analog", "digital"};
    const char *near = str_nearest(s->name->text, sections, 2);
    Diag *d;

    if (s->name->len == 0)                    // the lexer has reported what is wrong with it
        return;
    d = parser_report(p, DIAG_pin_section, s->header, s->name->text);
    if (near)
        diag_label(p->diags, d, DIAG_label_did_you_mean, format_in(p->arena, "[%s]", near));
}

// ---- one pin ----

static bool is_direction(const Token *t)
{
    return t->kind == TOK_NAME && t->text->len == 1 && (t->text->text[0] == 'i' || t->text->text[0] == 'o');
}

// Labels d with the correct order if the user wrote `batt 0 i`; returns false otherwise. The current token is the number.
static bool label_wrong_order(Parser *p, Diag *d, const char *name)
{
    if (!is_direction(&p->ahead) || p->ahead.first)
        return false;
    diag_label(p->diags, d, DIAG_label_write,
               format_in(p->arena, "%s %s %s", p->ahead.text->text, parser_text(p, parser_token_span(p)), name));
    p->failed = true;
    return true;
}

// Reports that the current pin begins with another word. Returns true if a number follows anyway; it is then the current token.
static bool recover_direction(Parser *p, AstPin *pin)
{
    const char *guess = p->tok.kind == TOK_NAME ? hint_find_synonym(HINT_DIRECTIONS, p->tok.text->text) : NULL;
    bool number_follows = p->tok.kind == TOK_NAME && p->ahead.kind == TOK_NUMBER && !p->ahead.first;
    Diag *d;

    if (p->tok.kind == TOK_ERROR)
        p->failed = true;
    d = parser_report(p, DIAG_pin_direction, parser_token_span(p), parser_describe(p, &p->tok));
    if (guess) {
        diag_label(p->diags, d, DIAG_label_did_you_mean, guess);
        diag_edit(p->diags, d, parser_token_span(p), guess);
    }
    pin->output = guess && *guess == 'o';
    p->failed = p->failed || !number_follows;
    if (!number_follows)
        return false;
    parser_advance(p);
    return guess || !label_wrong_order(p, d, p->last.text->text);
}

static bool parse_direction(Parser *p, AstPin *pin)
{
    bool known = is_direction(&p->tok);

    if (!known)
        return recover_direction(p, pin);
    pin->output = p->tok.text->text[0] == 'o';
    parser_advance(p);
    return true;
}

// Whether the next pin begins here. The missing parts of this pin must not be searched for in that one.
static bool begins_next_pin(const Parser *p)
{
    return p->tok.first && is_direction(&p->tok) && p->ahead.kind == TOK_NUMBER;
}

static bool parse_pin_number(Parser *p, AstPin *pin)
{
    const Span at = parser_missing_span(p);
    const char *found = parser_describe_found(p);

    if (parse_signed_number(p, &pin->number))
        return true;
    if (p->tok.kind == TOK_NAME && p->last.kind == TOK_NAME)       // no + or - was read
        hint_explain(p, HINT_AT_PIN_NUMBER, NULL);
    else
        parser_fail(p, DIAG_pin_number, at, found);
    return false;
}

static bool parse_pin_element(Parser *p, AstPin *pin)
{
    if (p->tok.kind == TOK_NAME && !begins_next_pin(p)) {
        pin->element = p->tok.text;
        pin->element_span = parser_token_span(p);
        parser_advance(p);
        return hint_explain(p, HINT_AFTER_DECL_NAME, NULL) == HINT_NONE;
    }
    if (p->tok.kind == TOK_ERROR)
        p->failed = true;
    parser_fail(p, DIAG_pin_element, parser_missing_span(p), parser_text(p, pin->number.span), parser_describe_found(p));
    return false;
}

static AstAnnotationTarget find_pin_target(const AstSection *s, const AstPin *pin)
{
    if (s->digital)
        return pin->output ? AST_ON_DIGITAL_OUTPUT : AST_ON_DIGITAL_INPUT;
    return pin->output ? AST_ON_ANALOG_OUTPUT : AST_ON_ANALOG_INPUT;
}

static bool ends_pin(const Parser *p)
{
    return p->tok.first || p->tok.kind == TOK_HEADER || p->tok.kind == TOK_END || (is_direction(&p->tok) && p->ahead.kind == TOK_NUMBER);
}

static void parse_pin(Parser *p, AstSection *s)
{
    AstPin pin = {0};

    if (!parse_direction(p, &pin))
        return;
    p->pin_target = find_pin_target(s, &pin);
    if (!parse_pin_number(p, &pin) || !parse_pin_element(p, &pin))
        return;
    parse_annotations(p, p->pin_target, pin.element, pin.element_span, &pin.annotations);
    if (!p->failed && !ends_pin(p))
        hint_explain(p, HINT_AT_PIN_END, NULL);
    vec_push(p->arena, &s->pins, pin);
}

void parse_pins(Parser *p, AstSection *s)
{
    while (p->tok.kind != TOK_HEADER && p->tok.kind != TOK_END) {
        uint32_t at = p->tok.at;
        p->failed = false;
        parse_pin(p, s);
        if (p->failed && p->tok.at == at)
            parser_advance(p);
        if (p->failed)
            parser_skip_line(p);
    }
    p->failed = false;
}
