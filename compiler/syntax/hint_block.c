// SPDX-License-Identifier: Apache-2.0
// Hints about blocks of other languages that this language does not have: loops, switch, functions, try. The block is reported at its first
// word and skipped as a whole, because its statements have to be written in another form anyway. Also hints about headers without brackets.
#include <string.h>

#include "compiler/syntax/hint_rules.h"
#include "compiler/syntax/lexer.h"

// ---- the end of a block ----

static uint32_t end_of_line(const char *text, uint32_t at) { return at + (uint32_t)strcspn(text + at, "\n"); }

// Returns the offset after the spaces and tabs at `at`.
static uint32_t skip_blanks(const char *text, uint32_t at) { return at + (uint32_t)strspn(text + at, " \t\r"); }

// Returns the start of the next line after `at` that is neither empty nor a comment; the end of the text if no such line follows.
static uint32_t next_code_line(const char *text, uint32_t at)
{
    do {
        at = end_of_line(text, at);
        at += text[at] == '\n';
    } while (text[at] && strchr("\n#", text[skip_blanks(text, at)]) && text[skip_blanks(text, at)]);
    return at;
}

// Returns the { that opens the block whose first line contains `at`: on that line, or the first character of the next one; 0 if no brace is there.
static uint32_t find_brace(const char *text, uint32_t at)
{
    const uint32_t open = at + (uint32_t)strcspn(text + at, "{}#\n");
    uint32_t below;

    if (text[open] == '{')
        return open;
    if (text[open] == '}' || !text[open])
        return 0;
    below = skip_blanks(text, next_code_line(text, open));
    return text[below] == '{' ? below : 0;
}

// Returns the end of the braces that open at `open`, with the `while (...)` of a do loop and semicolons after them; 0 if they are not closed.
static uint32_t end_of_braces(const char *text, uint32_t open)
{
    uint32_t at = open, depth = 0;

    do {
        if (text[at] == '#')
            at = end_of_line(text, at);
        if (!text[at])
            return 0;
        depth += text[at] == '{';
        depth -= text[at] == '}';
        at++;
    } while (depth > 0);
    if (strncmp(text + skip_blanks(text, at), "while", 5) == 0)
        at += (uint32_t)strcspn(text + at, "#{}\n");
    while (text[skip_blanks(text, at)] == ';')
        at = skip_blanks(text, at) + 1;
    return at;
}

// Whether the word at `at` begins with `prefix`, which is in lower case; the case of the word does not matter.
static bool begins_with(const char *text, uint32_t at, const char *prefix)
{
    while (*prefix && (text[at] | 0x20) == *prefix)
        at++, prefix++;
    return *prefix == '\0';
}

// Whether the word at `at` closes a block in other languages: end, END_FOR, endwhile, until.
static bool is_closing_word(const char *text, uint32_t at) { return begins_with(text, at, "end") || begins_with(text, at, "until"); }

// Whether the word at `at` begins a case of a switch.
static bool is_case(const char *text, uint32_t at)
{
    return begins_with(text, at, "case") || begins_with(text, at, "otherwise") || begins_with(text, at, "default");
}

// Returns the end of the lines below `at` that are indented more than its line, which begins at `line`, and of the word that closes them. The
// cases of a switch can be indented like it.
static uint32_t end_of_indented(const char *text, uint32_t line, uint32_t at, bool is_switch)
{
    const uint32_t indent = skip_blanks(text, line) - line;
    uint32_t end = end_of_line(text, at), next = next_code_line(text, at), depth = 0;
    bool any = false;

    for (; text[next]; next = next_code_line(text, next)) {
        const uint32_t stop = end_of_line(text, next), first = skip_blanks(text, next);
        if (first - next <= indent && !(is_switch && first - next == indent && is_case(text, first)))
            break;
        for (uint32_t p = next; p < stop && text[p] != '#'; p++) {
            depth += text[p] == '{';
            if (text[p] == '}' && depth-- == 0)
                return end;
        }
        end = stop;
        any = true;
    }
    return any && text[next] && is_closing_word(text, skip_blanks(text, next)) ? end_of_line(text, next) : end;
}

uint32_t hint_end_of_block(const Parser *p)
{
    const char *text = p->lex.src->text;
    uint32_t line = p->tok.at, open;

    while (line > 0 && text[line - 1] != '\n')
        line--;
    if ((open = find_brace(text, p->tok.at)) != 0)
        return end_of_braces(text, open);
    return p->tok.first ? end_of_indented(text, line, p->tok.at, hint_is_word(&p->tok, "switch")) : 0;
}

void hint_cover_indented(Parser *p)
{
    const char *text = p->lex.src->text;
    uint32_t line = p->last.at, end;

    while (line > 0 && text[line - 1] != '\n')
        line--;
    end = end_of_indented(text, line, p->last.at, false);
    p->open_blocks++;
    if (end > p->lex.hinted)
        p->lex.hinted = end;
}

// ---- skipping ----

void hint_skip_to(Parser *p, uint32_t end)
{
    while (p->lex.at < end)
        if (p->lex.src->text[p->lex.at] == '\n')
            lexer_end_line(&p->lex);
        else
            p->lex.at++;
    while (p->tok.at < end && p->tok.kind != TOK_END)
        parser_advance(p);
}

void hint_skip_block(Parser *p)
{
    const uint32_t end = hint_end_of_block(p);

    p->lex.parens = p->lex.open_parens = 0;
    if (end > 0)
        hint_skip_to(p, end);
    else
        parser_advance(p);
    if (p->tok.first && (hint_is_word(&p->tok, "except") || hint_is_word(&p->tok, "catch") || hint_is_word(&p->tok, "finally")))
        hint_skip_block(p);                                   // parts of `try`
}

// Whether only spaces and line ends are between the statements of a reported condition without braces and `at`.
bool hint_follows_indented(const Parser *p, uint32_t at)
{
    const char *text = p->lex.src->text;

    return p->indented > 0 && p->indented <= at && p->indented + (uint32_t)strspn(text + p->indented, " \t\r\n") >= at;
}

// ---- a header without brackets ----

// Whether the next line of code after `at` is a label of a state.
static bool is_above_label(const Parser *p, uint32_t at)
{
    const char *text = p->lex.src->text;

    at = skip_blanks(text, next_code_line(text, at));
    if (text[at] != '.')
        return false;
    at++;
    return hint_is_label(hint_read_word(p, &at));
}

// Reads (Hold), {Hold}, <Hold>, Hold: and Hold as the header [Hold], if the name is alone on its line, and a label follows.
HintResult hint_read_plain_header(HintCase *c)
{
    Parser *p = c->p;
    const char *text = p->lex.src->text, *written;
    const bool is_enclosed = p->tok.kind != TOK_NAME;
    const uint32_t from = p->tok.at;
    Token name = is_enclosed ? p->ahead : p->tok;
    uint32_t end = name.at + name.len;
    Diag *d;

    if (p->kind != FILE_SM || p->braces > 0 || name.text->declared || hint_is_label(name.text->text) ||
        hint_find_synonym(HINT_LABELS, name.text->text))
        return HINT_NONE;
    if (text[end] && strchr(is_enclosed ? ")}>" : ":", text[end]))
        end++;
    else if (is_enclosed)
        return HINT_NONE;
    if (skip_blanks(text, end) < end_of_line(text, end) && text[skip_blanks(text, end)] != '#')
        return HINT_NONE;
    if (!is_above_label(p, end))
        return HINT_NONE;
    written = format_in(p->arena, "[%s]", name.text->text);
    d = parser_report(p, DIAG_expected_statement, (Span){p->lex.src, from, end - from},
                      format_in(p->arena, "'%.*s'", (int)(end - from), text + from));
    diag_label(p->diags, d, DIAG_label_write, written);
    diag_edit(p->diags, d, (Span){p->lex.src, from, end - from}, written);
    while (p->ahead.at < end)
        parser_advance(p);
    name.kind = TOK_HEADER;
    name.first = true;
    name.at--;                                // as if a bracket were before the name
    name.len++;
    p->tok = name;
    return HINT_SKIPPED;
}
