// SPDX-License-Identifier: Apache-2.0
// Hint about definitions with arguments: f(x) = x * 2. A definition is an expression of elements and locals, so each use needs its own.
#include <string.h>

#include "compiler/syntax/hint_rules.h"
#include "compiler/syntax/lexer.h"

// The most arguments; the most errors in a file that search for uses, so that hostile text cannot cost quadratic time.
enum { ARGUMENTS_MAX = 4, SEARCHES_MAX = 20 };

// The names or values between the parentheses of a definition or of a use.
typedef struct ArgumentList {
    Span whole;               // position of the arguments with their parentheses, as in `(x, y)`
    Span at[ARGUMENTS_MAX];
    size_t n;
} ArgumentList;

static uint32_t skip_blanks(const char *text, uint32_t at)
{
    while (text[at] == ' ' || text[at] == '\t')
        at++;
    return at;
}

// Reads the arguments whose ( is at `open`. Returns false if the ( is not closed on its line, or if there are too many arguments.
static bool read_arguments(const Source *src, uint32_t open, ArgumentList *a)
{
    const char *text = src->text;
    uint32_t from = open + 1, depth = 1;

    *a = (ArgumentList){.whole = {src, open, 0}};
    for (uint32_t at = from; text[at] && text[at] != '\n' && text[at] != '#'; at++) {
        depth += text[at] == '(';
        depth -= text[at] == ')';
        if (depth == 0 || (depth == 1 && text[at] == ',')) {
            uint32_t end = at;
            from = skip_blanks(text, from);
            while (end > from && text[end - 1] == ' ')
                end--;
            if (a->n == ARGUMENTS_MAX)
                return false;
            a->at[a->n++] = (Span){src, from, end - from};
            from = at + 1;
        }
        if (depth == 0) {
            a->whole.len = at + 1 - open;
            return a->at[0].len > 0;
        }
    }
    return false;
}

// Finds the first use of the function after its arguments. Returns false if none has as many arguments.
static bool find_use(const Source *src, Str name, const ArgumentList *declared, ArgumentList *used)
{
    const char *text = src->text, *at = text + declared->whole.at;

    while ((at = strstr(at, name->text)) != NULL) {
        const uint32_t from = (uint32_t)(at - text), open = skip_blanks(text, from + (uint32_t)name->len);
        if (!lexer_is_word(text[from - 1]) && text[open] == '(' && read_arguments(src, open, used) && used->n == declared->n) {
            used->whole = (Span){src, from, used->whole.at + used->whole.len - from};
            return true;
        }
        at++;
    }
    return false;
}

// Returns the value that the use has for the declared argument whose name is at `at`; NULL if the word there is no declared argument.
static const Span *find_argument(const char *text, uint32_t at, uint32_t len, const ArgumentList *declared, const ArgumentList *used)
{
    for (size_t i = 0; i < declared->n; i++)
        if (declared->at[i].len == len && memcmp(text + declared->at[i].at, text + at, len) == 0)
            return &used->at[i];
    return NULL;
}

// Whether the text is one name or number, and not an expression that would need parentheses.
static bool is_one_operand(const char *text, uint32_t len)
{
    uint32_t n = 0;

    while (n < len && (lexer_is_word(text[n]) || text[n] == '.'))
        n++;
    return n == len;
}

// Appends the expression from `at` to the end of its line, with the arguments of the use.
static void write_body(Buf *out, const char *text, uint32_t at, const ArgumentList *declared, const ArgumentList *used)
{
    uint32_t end = at + (uint32_t)strcspn(text + at, "#\r\n");

    while (end > at && (text[end - 1] == ' ' || text[end - 1] == '\t'))
        end--;
    while (at < end) {
        uint32_t len = 0;
        const Span *argument;
        while (lexer_is_word(text[at + len]))
            len++;
        argument = len ? find_argument(text, at, len, declared, used) : NULL;
        if (argument) {
            const char *operand = text + argument->at;
            buf_printf(out, is_one_operand(operand, argument->len) ? "%.*s" : "(%.*s)", (int)argument->len, operand);
        } else {
            buf_put(out, text + at, len ? len : 1);
        }
        at += len ? len : 1;
    }
}

// Returns a name for the use: f_pressure for f(pressure), f_1 if the argument is no name or number.
static const char *name_of_use(Arena *arena, Str name, const ArgumentList *used)
{
    const char *text = used->at[0].src->text + used->at[0].at;
    const uint32_t len = used->at[0].len;

    if (used->n > 1 || len > 20 || !is_one_operand(text, len) || memchr(text, '.', len))
        return format_in(arena, "%s_1", name->text);
    return format_in(arena, "%s_%.*s", name->text, (int)len, text);
}

// Reports arguments of a definition, with the definition that its first use needs. The current token is the (.
HintResult hint_report_definition_arguments(HintCase *c)
{
    Parser *p = c->p;
    const Source *src = p->lex.src;
    const Str name = p->last.text;
    ArgumentList declared, used;
    uint32_t at;
    Buf out;

    if (p->diags->errors_seen > SEARCHES_MAX || !read_arguments(src, p->tok.at, &declared))
        return HINT_NONE;
    at = skip_blanks(src->text, declared.whole.at + declared.whole.len);
    if (src->text[at] != '=')
        return HINT_NONE;
    if (!find_use(src, name, &declared, &used)) {
        diag_label(p->diags, hint_report_general(c), DIAG_label_definition_without_arguments, name->text);
        return HINT_READ;
    }
    buf_init(&out, p->arena);
    buf_printf(&out, "%s = ", name_of_use(p->arena, name, &used));
    write_body(&out, src->text, skip_blanks(src->text, at + 1), &declared, &used);
    diag_label(p->diags, hint_report_general(c), DIAG_label_definition_arguments, buf_text(&out), name_of_use(p->arena, name, &used),
               parser_text(p, used.whole));
    return HINT_READ;
}
