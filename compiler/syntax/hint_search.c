// SPDX-License-Identifier: Apache-2.0
// Searches the rows of hints.def for the parser. Contains the tests that several rules share.
#include "compiler/syntax/hint_lines.h"
#include "compiler/syntax/hint_rules.h"

// ---- rows ----

// Sets of token kinds, for the columns `before`, `here` and `after` of a row of hints.def.
#define T(kind) (UINT64_C(1) << TOK_##kind)
#define ANY (T(COUNT) - 1)
#define OPERAND (T(NAME) | T(NUMBER) | T(LPAREN) | T(TRUE) | T(FALSE) | T(NOT) | T(BANG))
#define COMPARISON (T(LT) | T(LE) | T(GT) | T(GE) | T(EQ) | T(NE))
#define FIRST (UINT64_C(1) << 62)         // added to a set: the token must be the first on its line
#define SAME_LINE (UINT64_C(1) << 63)     // added to a set: the token must not be the first on its line
typedef char tokens_fit_a_set[TOK_COUNT < 62 ? 1 : -1];

typedef struct Hint {
    HintContext context;
    uint64_t before, here, after;         // sets of token kinds for the last token, the next token and the one after it
    const char *word;                     // the text of the next token; case does not matter. NULL: any text
    HintResult (*rule)(HintCase *c);      // NULL: report the general diagnostic with `label`
    DiagCode label;
    const char *text;                     // argument of the label; or NULL
} Hint;

static const Hint hints[] = {
#define HINT(context, before, here, word, after, rule) {HINT_##context, before, here, after, word, hint_##rule, DIAG_COUNT, NULL},
#define HINT_LABEL(context, before, here, word, after, label, text) {HINT_##context, before, here, after, word, NULL, DIAG_##label, text},
#include "compiler/syntax/hints.def"
};
enum { HINT_ROWS = sizeof hints / sizeof *hints };

// Whether the kind of t is in the set. If the set contains FIRST, t must also be the first token on its line; if SAME_LINE, it must not.
static bool is_token_in(uint64_t set, const Token *t)
{
    return (set >> t->kind & 1u) && !((set & FIRST) && !t->first) && !((set & SAME_LINE) && t->first);
}

// Reports the general diagnostic of the context, such as "expected a value", unless that was done for this case already.  Returns the
// diagnostic, so that the caller can add labels and edits.
Diag *hint_report_general(HintCase *c)
{
    Parser *p = c->p;

    if (c->general)
        return c->general;
    switch (c->context) {
    case HINT_AT_VALUE:
        c->general = parser_fail(p, DIAG_expected_value, parser_missing_span(p),
                                 parser_text(p, parser_span(p, &p->last)), parser_describe_found(p));
        break;
    case HINT_AT_LONE_VALUE:
        c->general = parser_report(p, DIAG_no_effect, c->e->span);
        break;
    case HINT_AT_PIN_NUMBER:
        c->general = parser_fail(p, DIAG_pin_number, parser_missing_span(p), parser_describe_found(p));
        break;
    case HINT_AT_OPTION:
        c->general = parser_fail(p, DIAG_option_unknown, parser_token_span(p), p->tok.text->text);
        break;
    case HINT_AT_DEFINITION_VALUE:
        c->general = parser_fail(p, DIAG_definition_without_value, parser_missing_span(p),
                                 parser_text(p, parser_span(p, &p->last)), parser_describe_found(p));
        break;
    case HINT_AT_END: case HINT_AT_ELEMENT_END: case HINT_AT_PIN_END:
        c->general = parser_fail(p, DIAG_expected_end, parser_token_span(p), parser_describe(p, &p->tok));
        break;
    default:                              // the other contexts have no general diagnostic
        break;
    }
    return c->general;
}

void hint_init_index(HintIndex *index)
{
    static const HintContext with_message[] = {HINT_AT_VALUE, HINT_AT_LONE_VALUE, HINT_AT_END, HINT_AT_ELEMENT_END, HINT_AT_PIN_NUMBER,
                                             HINT_AT_PIN_END, HINT_AT_OPTION, HINT_AT_DEFINITION_VALUE};      // the contexts with a general diagnostic

    memset(index, 0, sizeof *index);
    for (size_t i = 0; i < sizeof with_message / sizeof *with_message; i++)
        index->tokens[with_message[i]] = ANY;
    for (size_t row = HINT_ROWS; row > 0; row--) {
        index->tokens[hints[row - 1].context] |= hints[row - 1].here;
        index->first_row[hints[row - 1].context] = (uint8_t)(row - 1);
    }
}

// Reports the first row of the context that matches, or else the general diagnostic.
HintResult hint_explain_by_rows(Parser *p, HintContext context, AstExpr *e)
{
    HintCase c = {p, context, e, NULL};
    HintResult result = HINT_NONE;

    for (size_t i = p->hints.first_row[context]; i < HINT_ROWS && hints[i].context == context && result == HINT_NONE; i++) {
        const Hint *h = &hints[i];
        if (!is_token_in(h->here, &p->tok) || !is_token_in(h->before, &p->last) || !is_token_in(h->after, &p->ahead) ||
            (h->word && !hint_is_word(&p->tok, h->word)))
            continue;
        if (h->rule) {
            result = h->rule(&c);
        } else {
            diag_label(p->diags, hint_report_general(&c), h->label, h->text);
            result = HINT_READ;
        }
    }
    if (result == HINT_NONE)
        hint_report_general(&c);
    return result;
}

// ---- tokens ----

// Whether t is a name that equals `lower`; case does not matter.
bool hint_is_word(const Token *t, const char *lower)
{
    const char *a;

    if (t->kind != TOK_NAME)
        return false;
    for (a = t->text->text; *a && *lower; a++, lower++)
        if ((*a >= 'A' && *a <= 'Z' ? *a - 'A' + 'a' : *a) != *lower)
            return false;
    return !*a && !*lower;
}
bool hint_begins_value(const Token *t) { return is_token_in(OPERAND, t); }

// Whether no space is between the tokens.
bool hint_are_adjacent(const Token *a, const Token *b) { return a->at + a->len == b->at; }

// Whether the word is entry, step or exit.
bool hint_is_label(const char *s)
{
    return strcmp(s, "entry") == 0 || strcmp(s, "step") == 0 || strcmp(s, "exit") == 0;
}

// ---- lines ----

// Whether the current line is a guard: it contains a : or a { after the current token, or the next line begins with a {.
bool hint_line_is_guard(const Parser *p)
{
    const Source *s = p->lex.src;
    uint32_t depth = 0, i = p->tok.at;
    bool below = false;                                // the current character is on a following line

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

// Labels d with what to do about two statements on one line, of which the first ends before `at`.  Returns false if none ends there.
bool hint_label_line_sharing(Parser *p, Diag *d, uint32_t at)
{
    const uint32_t until = hint_label_shared_line(p->diags, d, p->lex.src, at, HINT_OTHER);

    if (until > 0)
        p->lex.hinted = until;
    return until > 0;
}

// ---- synonyms ----

// Whether two words are the same; case does not matter.
static bool is_same_word(const char *a, const char *b)
{
    for (; *a && *b; a++, b++)
        if ((*a >= 'A' && *a <= 'Z' ? *a - 'A' + 'a' : *a) != (*b >= 'A' && *b <= 'Z' ? *b - 'A' + 'a' : *b))
            return false;
    return *a == *b;
}

const char *hint_find_synonym(HintWords of, const char *word)
{
    static const struct { HintWords of; const char *word, *ours; } synonyms[] = {
#define HINT_SYNONYM(of, word, ours) {HINT_##of, word, ours},
#include "compiler/syntax/hints.def"
    };

    for (size_t i = 0; i < sizeof synonyms / sizeof *synonyms; i++)
        if (synonyms[i].of == of && (of == HINT_TYPES ? is_same_word(word, synonyms[i].word) : strcmp(word, synonyms[i].word) == 0))
            return synonyms[i].ours;
    return NULL;
}
