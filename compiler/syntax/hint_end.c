// SPDX-License-Identifier: Apache-2.0
// Hints for text on the line of a statement or declaration after its end, and for text where a declaration should begin.
#include "compiler/syntax/hint_lines.h"
#include "compiler/syntax/hint_rules.h"
#include "compiler/syntax/hint_unit.h"
#include "compiler/syntax/lexer.h"

// ---- after a statement ----

// Skips the line if the lexer or an earlier hint has already reported an error in it.
HintResult hint_skip_reported_line(HintCase *c)
{
    Parser *p = c->p;

    if (p->tok.kind != TOK_ERROR && !(p->ahead.kind == TOK_ERROR && !p->ahead.first) && !(p->lex.src->text[p->tok.at] & 0x80) &&
        !(p->tok.kind == TOK_ELSE && p->last.at < p->lex.hinted))
        return HINT_NONE;
    p->failed = true;
    return HINT_SKIPPED;
}

// Reports a decimal comma, as in 3,14.
HintResult hint_report_decimal_comma(HintCase *c)
{
    Parser *p = c->p;
    const char *before, *after;
    Diag *d;

    if (!hint_are_adjacent(&p->last, &p->tok) || !hint_are_adjacent(&p->tok, &p->ahead))
        return HINT_NONE;
    before = parser_text(p, parser_span(p, &p->last));
    after = parser_text(p, parser_span(p, &p->ahead));
    d = parser_fail(p, DIAG_decimal_comma, parser_token_span(p));
    if (strchr(before, '.')) {                         // 1.000,5
        Buf out;
        buf_init(&out, p->arena);
        for (const char *digit = before; *digit; digit++)
            if (*digit != '.')
                buf_char(&out, *digit);
        diag_label(p->diags, d, DIAG_label_write, format_in(p->arena, "%s.%s", buf_text(&out), after));
    } else if (p->ahead.len == 3 && *before != '0') {         // 60,000 can mean sixty thousand; 0,125 and 3,14 cannot
        diag_label(p->diags, d, DIAG_label_comma_in_number, before, after, before, after);
    } else {
        diag_label(p->diags, d, DIAG_label_write, format_in(p->arena, "%s.%s", before, after));
        diag_edit(p->diags, d, parser_token_span(p), ".");
    }
    return HINT_SKIPPED;
}

// Reports `-- …`, a comment in other languages, at a position where no expression can begin or continue, and skips it.
HintResult hint_report_foreign_comment(HintCase *c)
{
    Parser *p = c->p;
    const Source *src = p->lex.src;
    Span sign = parser_token_span(p);
    Diag *d;

    if (!hint_are_adjacent(&p->tok, &p->ahead) || hint_line_is_guard(p))
        return HINT_NONE;
    sign.len = 2;
    d = parser_fail(p, DIAG_foreign_comment, sign, "--");
    diag_label(p->diags, d, DIAG_label_comment);
    diag_edit(p->diags, d, sign, "#");
    while (p->lex.at < src->len && src->text[p->lex.at] != '\n')
        p->lex.at++;
    parser_advance(p);
    return HINT_SKIPPED;
}

HintResult hint_report_stray_paren(HintCase *c)
{
    parser_fail(c->p, DIAG_stray_paren, parser_token_span(c->p));
    return HINT_SKIPPED;
}

// Reports a comma at the end of a statement's line, as in x = 1, where the next line has another statement.
HintResult hint_report_comma_at_end(HintCase *c)
{
    const Span comma = parser_token_span(c->p);
    Diag *d = hint_report_general(c);

    diag_label(c->p->diags, d, DIAG_label_leave_out);
    diag_edit(c->p->diags, d, comma, "");
    return HINT_READ;
}

// Reports a unit after a number, as in x = 5 ms.
HintResult hint_report_unit(HintCase *c)
{
    const Parser *p = c->p;
    const Span number = parser_span(p, &p->last), unit = parser_token_span(p);

    hint_label_unit(p->diags, hint_report_general(c), parser_text(p, number), p->tok.text->text, span_join(number, unit));
    return HINT_READ;
}

// Reports a word after a number inside parentheses, as in held(x, 5 sec).
HintResult hint_report_unit_in_call(HintCase *c)
{
    Parser *p = c->p;
    const Span number = parser_span(p, &p->last), unit = parser_token_span(p);

    hint_label_unit(p->diags, parser_fail(p, DIAG_paren_unclosed, unit, parser_describe_found(p)), parser_text(p, number), p->tok.text->text,
                    span_join(number, unit));
    return HINT_SKIPPED;
}

// Reports the value after a type in parentheses, as in (float) x.
HintResult hint_report_cast(HintCase *c)
{
    const Parser *p = c->p;
    const char *text = p->lex.src->text;
    uint32_t end = p->last.at, from;

    while (end > 0 && text[end - 1] == ' ')
        end--;
    for (from = end; from > 0 && lexer_is_word(text[from - 1]); from--) {}
    if (from == 0 || text[from - 1] != '(' || !hint_find_synonym(HINT_TYPES, format_in(p->arena, "%.*s", (int)(end - from), text + from)))
        return HINT_NONE;
    diag_label(p->diags, hint_report_general(c), DIAG_label_no_conversion);
    return HINT_READ;
}

HintResult hint_report_allow_after(HintCase *c)
{
    if (!parser_is_allow(&c->p->tok))
        return HINT_NONE;
    diag_label(c->p->diags, hint_report_general(c), DIAG_label_allow_before);
    return HINT_READ;
}

// Reports a second statement on a line, as in x = true, y = true or x = true -> Idle.
HintResult hint_report_shared_line(HintCase *c)
{
    Diag *d = hint_report_general(c);

    if (!hint_label_line_sharing(c->p, d, c->p->last.at + c->p->last.len))
        diag_label(c->p->diags, d, DIAG_label_own_line_or_braces);
    return HINT_READ;
}

// Reports an @assert or @stop after a statement on its line, as in x = true @stop.
HintResult hint_report_item_on_line(HintCase *c)
{
    const char *word = c->p->tok.text->text;

    return strcmp(word, "assert") == 0 || strcmp(word, "stop") == 0 ? hint_report_shared_line(c) : HINT_NONE;
}

// Reports a second statement on a line after the words `and then`, as in x = true and then -> Idle.
HintResult hint_report_and_then_on_line(HintCase *c)
{
    Diag *d;

    if (!hint_is_and_then(c->p))
        return HINT_NONE;
    d = hint_report_general(c);
    if (!hint_label_line_sharing(c->p, d, c->p->last.at + c->p->last.len))
        diag_label(c->p->diags, d, DIAG_label_and_then);
    return HINT_READ;
}

// Reports parentheses after an annotation that has no argument: @stop().
HintResult hint_report_annotation_call(HintCase *c)
{
    diag_label(c->p->diags, hint_report_general(c), DIAG_label_write, parser_text(c->p, parser_span(c->p, &c->p->last)));
    return HINT_READ;
}

// Returns the end of the parentheses that open at the current token on its line; 0 if they do not close there.
static uint32_t end_of_arguments(const Parser *p)
{
    const char *text = p->lex.src->text;
    uint32_t depth = 0;

    for (uint32_t at = p->tok.at; text[at] && text[at] != '\n' && text[at] != '#'; at++) {
        depth += text[at] == '(';
        if (text[at] == ')' && --depth == 0)
            return at + 1;
    }
    return 0;
}

// Reports arguments of a transition: -> Burn(3).
HintResult hint_report_call_of_state(HintCase *c)
{
    Parser *p = c->p;
    const char *text = p->lex.src->text;
    const uint32_t end = end_of_arguments(p), open = p->tok.at;
    uint32_t arrow = p->last.at;
    Diag *d;

    while (arrow > 0 && (text[arrow - 1] == ' ' || text[arrow - 1] == '\t'))
        arrow--;
    if (arrow < 2 || strncmp(text + arrow - 2, "->", 2) != 0)
        return HINT_NONE;
    d = hint_report_general(c);
    if (end > open && strspn(text + open + 1, " \t") == end - open - 2) {
        diag_label(p->diags, d, DIAG_label_write, format_in(p->arena, "-> %s", parser_text(p, parser_span(p, &p->last))));
        diag_edit(p->diags, d, (Span){p->lex.src, open, end - open}, "");
    } else {
        diag_label(p->diags, d, DIAG_label_state_arguments, parser_text(p, parser_span(p, &p->last)));
    }
    return HINT_READ;
}

// Reports a condition after @stop, as in @stop G > 5.
HintResult hint_report_condition_of_stop(HintCase *c)
{
    Parser *p = c->p;
    const char *text = p->lex.src->text;
    uint32_t end = p->tok.at + (uint32_t)strcspn(text + p->tok.at, "#}\r\n"), at = p->tok.at;

    if (strcmp(p->last.text->text, "stop") != 0)
        return HINT_NONE;
    while (end > at && (text[end - 1] == ' ' || text[end - 1] == '\t'))
        end--;
    if (hint_is_word(&p->tok, "if") || p->tok.kind == TOK_IF || hint_is_word(&p->tok, "when"))
        at = p->ahead.at;
    diag_label(p->diags, hint_report_general(c), DIAG_label_as_in, format_in(p->arena, "%.*s: @stop", (int)(end > at ? end - at : 0), text + at));
    return HINT_READ;
}

// Returns the name of the state that the last token and the current one mean together: Tank_Vent or TankVent; NULL if neither is a state.
static const char *find_joined_state(const Parser *p)
{
    static const char *const between[] = {"_", ""};

    for (size_t i = 0; i < sizeof between / sizeof *between; i++) {
        const char *header = format_in(p->arena, "\n[%s%s%s]", p->last.text->text, between[i], p->tok.text->text);
        if (strstr(p->lex.src->text, header))
            return format_in(p->arena, "%s%s%s", p->last.text->text, between[i], p->tok.text->text);
    }
    return NULL;
}

// Reports a state's name of two words, as in -> Tank Vent.
HintResult hint_report_state_of_words(HintCase *c)
{
    Parser *p = c->p;
    const char *text = p->lex.src->text, *name;
    uint32_t arrow = p->last.at;
    Diag *d;

    while (arrow > 0 && (text[arrow - 1] == ' ' || text[arrow - 1] == '\t'))
        arrow--;
    if (arrow < 2 || strncmp(text + arrow - 2, "->", 2) != 0 || (!p->ahead.first && p->ahead.kind != TOK_RBRACE && p->ahead.kind != TOK_END))
        return HINT_NONE;
    d = hint_report_general(c);
    name = find_joined_state(p);
    if (name)
        diag_label(p->diags, d, DIAG_label_write, name);
    else
        diag_label(p->diags, d, DIAG_label_state_of_words, p->last.text->text, p->tok.text->text);
    return HINT_READ;
}

// Reports digits in groups, as in 60 000.
HintResult hint_report_digit_groups(HintCase *c)
{
    Parser *p = c->p;
    const char *before = parser_text(p, parser_span(p, &p->last));

    if (p->tok.len != 3)
        return HINT_NONE;
    diag_label(p->diags, hint_report_general(c), DIAG_label_write,
               format_in(p->arena, "%s%s", before, parser_text(p, parser_token_span(p))));
    return HINT_READ;
}

// ---- declarations ----

// Reports and skips `const`, as in const F64 limit = 5.
HintResult hint_skip_const(HintCase *c)
{
    Parser *p = c->p;
    const char *text = p->lex.src->text;
    uint32_t end = p->ahead.at + (uint32_t)strcspn(text + p->ahead.at, "#\r\n");
    Diag *d = parser_report(p, DIAG_foreign_word, parser_token_span(p), p->tok.text->text);

    while (text[end - 1] == ' ' || text[end - 1] == '\t')
        end--;
    diag_label(p->diags, d, DIAG_label_write,
               format_in(p->arena, "%s%s", parser_text(p, (Span){p->lex.src, p->ahead.at, end - p->ahead.at}),
                         memchr(text + p->ahead.at, '@', end - p->ahead.at) ? "" : " @read_only"));
    if (!memchr(text + p->ahead.at, '@', end - p->ahead.at) && !memchr(text + p->ahead.at, ';', end - p->ahead.at)) {
        diag_edit(p->diags, d, (Span){p->lex.src, p->tok.at, p->ahead.at - p->tok.at}, "");
        diag_edit(p->diags, d, (Span){p->lex.src, end, 0}, " @read_only");
    }
    parser_advance(p);
    return HINT_READ;
}

// Reports and skips a word before a declaration that has no meaning here, as in static F64 x = 5.
HintResult hint_skip_storage(HintCase *c)
{
    Parser *p = c->p;
    Diag *d = parser_report(p, DIAG_foreign_word, parser_token_span(p), p->tok.text->text);

    diag_label(p->diags, d, DIAG_label_leave_out);
    diag_edit(p->diags, d, (Span){p->lex.src, p->tok.at, p->ahead.at - p->tok.at}, "");
    parser_advance(p);
    return HINT_READ;
}

// Reports the two words of a type such as unsigned int, and reads them as one.
HintResult hint_skip_unsigned(HintCase *c)
{
    Parser *p = c->p;
    const char *second = hint_find_synonym(HINT_TYPES, p->ahead.text->text);
    const Span both = span_join(parser_token_span(p), parser_span(p, &p->ahead));
    const char *type;
    Diag *d;

    if (!second || second[0] != 'I')
        return HINT_NONE;
    type = format_in(p->arena, "U%s", second + 1);
    d = parser_report(p, DIAG_type_unknown, both, parser_text(p, both));
    diag_label(p->diags, d, DIAG_label_did_you_mean, type);
    parser_advance(p);
    p->tok.kind = TOK_TYPE;
    p->tok.type = SM_TYPE_COUNT;
    return HINT_READ;
}

// Reports a unit in brackets, as in F32 pressure [bar] @read_only, and skips it. The bracket does not begin a section.
HintResult hint_report_bracketed_unit(HintCase *c)
{
    Parser *p = c->p;

    if (p->ahead.first ? strcmp(p->tok.text->text, "local") == 0 : strcmp(p->ahead.text->text, "read_only") != 0)
        return HINT_NONE;
    diag_label(p->diags, parser_report(p, DIAG_expected_end, parser_token_span(p), parser_describe(p, &p->tok)), DIAG_label_unit_comment);
    parser_advance(p);
    return HINT_READ;
}

// ---- pins ----

// The pin number of A0 and the number of analog inputs, for Arduino Uno and Mega (docs/boards.md).
enum { UNO_A0 = 14, UNO_ANALOGS = 6, MEGA_A0 = 54, MEGA_ANALOGS = 16 };

// Reports a letter before the number of a pin, as in i A3 pressure: Arduino boards are labelled A3 or D3.
HintResult hint_report_printed_pin(HintCase *c)
{
    Parser *p = c->p;
    const char *name = p->tok.text->text, letter = (char)(*name & ~0x20), *digits = name + 1;          // in upper case, so that a3 is read as A3
    const bool analog_input = p->pin_target == AST_ON_ANALOG_INPUT;
    const size_t n = strspn(digits, "0123456789");

    if (n < 1 || n > 2 || digits[n] != '\0')
        return HINT_NONE;
    if (letter == (analog_input ? 'A' : 'D')) {
        diag_label(p->diags, hint_report_general(c), DIAG_label_printed_pin, digits, name);
    } else if (letter == 'A' && p->pin_target != AST_ON_ANALOG_OUTPUT) {
        const int number = n == 1 ? *digits - '0' : 10 * (*digits - '0') + digits[1] - '0';
        const char *mega = format_in(p->arena, "%d", MEGA_A0 + number);
        if (number < UNO_ANALOGS)
            diag_label(p->diags, hint_report_general(c), DIAG_label_analog_as_digital, format_in(p->arena, "%d", UNO_A0 + number), mega);
        else if (number < MEGA_ANALOGS)
            diag_label(p->diags, hint_report_general(c), DIAG_label_printed_pin, mega, name);
    }
    return c->general ? HINT_READ : HINT_NONE;
}
