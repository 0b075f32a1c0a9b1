// SPDX-License-Identifier: Apache-2.0
// Parses the pins of a .io (config.md 9). A pin has a direction, a number, an element and annotations; it can continue on further lines.
#include "compiler/syntax/hints.h"
#include "compiler/syntax/parser.h"

// ---- sections ----

void parser_report_pin_section(Parser *p, const AstSection *s)
{
    static const char *const sections[] = {"analog", "digital"};
    const char *near = str_nearest(s->name->text, sections, 2);
    Diag *d;

    if (s->name->len == 0)                    // the lexer has reported the malformed header
        return;
    d = parser_report(p, DIAG_pin_section, s->header, s->name->text);
    if (near)
        diag_label(p->diags, d, DIAG_label_did_you_mean, format_in(p->arena, "[%s]", near));
}

// ---- one pin ----

// Whether the token is the direction of a pin: `i` (input) or `o` (output).
static bool is_direction(const Token *t)
{
    return t->kind == TOK_NAME && t->text->len == 1 && (t->text->text[0] == 'i' || t->text->text[0] == 'o');
}

// Whether a pin begins at the current token, which need not be the first on its line.
static bool is_at_pin(const Parser *p) { return is_direction(&p->tok) && p->ahead.kind == TOK_NUMBER; }

// Reports that the current pin does not begin with a direction. Returns true if a number follows; the number is then the current token.
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
    if (guess || !is_direction(&p->ahead) || p->ahead.first)
        return true;
    diag_label(p->diags, d, DIAG_label_write,                     // the parts are in the wrong order, as in `batt 0 i`
               format_in(p->arena, "%s %s %s", p->ahead.text->text, parser_text(p, parser_token_span(p)), p->last.text->text));
    p->failed = true;
    return false;
}

// Parses the number of the pin.  Returns false after reporting that no number follows.
static bool parse_pin_number(Parser *p, AstPin *pin)
{
    const Span at = parser_missing_span(p);
    const char *found = parser_describe_found(p);

    if (parse_signed_number(p, &pin->number))
        return true;
    if (p->tok.kind == TOK_NAME && p->last.kind == TOK_NAME)       // a word follows where the number should be, without a sign
        hint_explain(p, HINT_AT_PIN_NUMBER, NULL);
    else
        parser_fail(p, DIAG_pin_number, at, found);
    return false;
}

// Parses the name of the pin's element. Returns false after reporting that none follows, or that it is malformed.
static bool parse_pin_element(Parser *p, AstPin *pin)
{
    if (p->tok.kind == TOK_NAME && !(p->tok.first && is_at_pin(p))) {        // a name on the next line can begin another pin
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

static void parse_pin(Parser *p, AstSection *s)
{
    AstPin pin = {0};

    if (is_direction(&p->tok)) {
        pin.output = p->tok.text->text[0] == 'o';
        parser_advance(p);
    } else if (!recover_direction(p, &pin))
        return;
    if (s->digital)
        p->pin_target = pin.output ? AST_ON_DIGITAL_OUTPUT : AST_ON_DIGITAL_INPUT;
    else
        p->pin_target = pin.output ? AST_ON_ANALOG_OUTPUT : AST_ON_ANALOG_INPUT;
    if (!parse_pin_number(p, &pin) || !parse_pin_element(p, &pin))
        return;
    parse_annotations(p, p->pin_target, pin.element, pin.element_span, &pin.annotations);
    if (!p->failed && !p->tok.first && p->tok.kind != TOK_HEADER && p->tok.kind != TOK_END && !is_at_pin(p))
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
