// SPDX-License-Identifier: Apache-2.0
#include "compiler/syntax/hint_lines.h"

#include <string.h>

#include "compiler/syntax/lexer.h"

enum {
    STATEMENTS_MAX = 16,      // on one line; a line with more gets no edit
    LINE_MAX = 1000           // bytes; a longer line gets no hint, so that hostile text cannot cost time quadratic in its length
};

typedef struct HintLine {
    const Source *src;
    const char *text;         // of the source
    uint32_t from, end;       // end: without the line end and blanks before it
    const char *line_end;     // the line end of this line
} HintLine;

static uint32_t skip_blanks(const HintLine *l, uint32_t p)
{
    while (p < l->end && is_space_or_tab(l->text[p]))
        p++;
    return p;
}

static uint32_t skip_word(const HintLine *l, uint32_t p)
{
    while (p < l->end && lexer_is_word(l->text[p]))
        p++;
    return p;
}

static uint32_t before_blanks(const HintLine *l, uint32_t p)
{
    while (p > l->from && is_space_or_tab(l->text[p - 1]))
        p--;
    return p;
}

static bool has_text(const HintLine *l, uint32_t at, uint32_t end, const char *word)
{
    return end - at == strlen(word) && memcmp(l->text + at, word, end - at) == 0;
}

// The line of `at`, or as much of it as LINE_MAX allows.
static HintLine line_of(const Source *src, uint32_t at)
{
    HintLine l = {src, src->text, at, at, "\n"};

    while (l.from > 0 && l.text[l.from - 1] != '\n' && at - l.from < LINE_MAX)
        l.from--;
    while (l.end < src->len && l.text[l.end] != '\n' && l.end - at < LINE_MAX)
        l.end++;
    if (l.end > l.from && l.text[l.end - 1] == '\r') {
        l.line_end = "\r\n";
        l.end--;
    }
    l.end = before_blanks(&l, l.end);
    return l;
}

// A line end followed by the indentation of l, plus `levels`.
static const char *new_line(Arena *arena, const HintLine *l, unsigned levels)
{
    const uint32_t indent = skip_blanks(l, l->from) - l->from;
    const bool tabs = memchr(l->text + l->from, '\t', indent) != NULL;
    const char *text = format_in(arena, "%s%.*s", l->line_end, (int)indent, l->text + l->from);

    while (levels-- > 0)
        text = format_in(arena, "%s%s", text, tabs ? "\t" : "    ");
    return text;
}

static bool is_too_long(const HintLine *l) { return l->end - l->from >= LINE_MAX; }
static Span span_of(const HintLine *l, uint32_t at, uint32_t end) { return (Span){l->src, at, end - at}; }

// Whether x = 1, -> Idle, @assert or @stop begins at p.
static bool begins_statement(const HintLine *l, uint32_t p)
{
    uint32_t sign;

    if (l->text[p] == '-')
        return p + 1 < l->end && l->text[p + 1] == '>';
    if (l->text[p] == '@')
        return has_text(l, p + 1, skip_word(l, p + 1), "assert") || has_text(l, p + 1, skip_word(l, p + 1), "stop");
    if (!lex_is_letter(l->text[p]))
        return false;
    sign = skip_blanks(l, skip_word(l, p));
    return sign < l->end && l->text[sign] == '=' && (sign + 1 == l->end || (l->text[sign + 1] != '=' && l->text[sign + 1] != '>'));
}

// Whether F64 x begins at p.
static bool begins_declaration(const HintLine *l, uint32_t p)
{
    const uint32_t end = skip_word(l, p);

    for (int t = 0; t < SM_TYPE_COUNT; t++)
        if (has_text(l, p, end, sm_type_info[t].spelling))
            return true;
    return false;
}

// ---- lines below ----

// Moves l to the next line; false at the end of the source.
static bool next_line(HintLine *l)
{
    uint32_t p = l->end;

    while (p < l->src->len && l->text[p] != '\n')
        p++;
    if (p == l->src->len)
        return false;
    *l = line_of(l->src, p + 1);
    return true;
}

static bool is_empty_line(const HintLine *l)
{
    const uint32_t p = skip_blanks(l, l->from);

    return p == l->end || l->text[p] == '#';
}

static uint32_t indentation(const HintLine *l) { return skip_blanks(l, l->from) - l->from; }

// Whether l begins with the indentation of `outer`.
static bool is_indented_like(const HintLine *l, const HintLine *outer)
{
    const uint32_t indent = indentation(outer);

    return l->end - l->from > indent && memcmp(l->text + l->from, outer->text + outer->from, indent) == 0;
}

// The same, and a blank follows that indentation.
static bool is_deeper(const HintLine *l, const HintLine *outer)
{
    return is_indented_like(l, outer) && is_space_or_tab(l->text[l->from + indentation(outer)]);
}

// The next line that is not empty is indented more: perhaps it depends on the same condition.
static bool continues_below(const HintLine *l)
{
    HintLine next = *l;

    while (next_line(&next))
        if (!is_empty_line(&next))
            return is_deeper(&next, l);
    return false;
}

// ---- the preceding statement ----

// The statement before `at`, as far as its line shows.
typedef struct PriorStatement {
    enum { PLAIN, GUARDED, UNKNOWN } is;      // GUARDED: after a condition's colon on this line
    uint32_t colon;
    uint32_t begin;           // of the statement
    bool braces;              // opened on this line and still open
} PriorStatement;

static PriorStatement find_prior_statement(const HintLine *l, uint32_t at)
{
    PriorStatement b = {UNKNOWN, 0, l->from, false};
    uint32_t depth = 0;
    bool colon = false, lost = false;         // lost: earlier text on the line is not a statement, perhaps a condition

    for (uint32_t p = l->from; p < at; p++)
        switch (l->text[p]) {
        case '(': depth++; break;
        case ')': depth -= depth > 0; break;
        case '{': case '}':
            b.begin = p + 1;
            b.braces = l->text[p] == '{';
            colon = false;
            break;
        case ':':
            b.colon = p;
            b.begin = p + 1;
            colon = depth == 0;
            break;
        case ';':
            if (depth > 0 || colon)
                break;
            b.begin = skip_blanks(l, b.begin);
            lost = lost || !(begins_statement(l, b.begin) || begins_declaration(l, b.begin));
            b.begin = p + 1;
            break;
        case '"':
            while (p + 1 < at && l->text[p + 1] != '"')
                p++;
            p++;
            break;
        default: break;
        }
    b.begin = skip_blanks(l, b.begin);
    if (lost)
        return b;
    if (b.begin < at && begins_statement(l, b.begin))
        b.is = colon ? GUARDED : PLAIN;
    else if (begins_declaration(l, b.begin))
        b.is = PLAIN;
    return b;
}

// ---- statements of one line ----

typedef struct LineStatements {
    size_t n;
    uint32_t gap[STATEMENTS_MAX], begin[STATEMENTS_MAX];  // gap: start of the separator before each statement; begin: its first byte
    uint32_t end;             // of the last one
    uint32_t trailing;        // end of a ';' after it; 0 if none
    bool clear;               // the line contains nothing else
} LineStatements;

// No statement after -> or @stop is executed, so the user meant something else by a statement that follows one on its line.
static bool leaves_block(const HintLine *l, uint32_t p)
{
    return l->text[p] == '-' || (l->text[p] == '@' && has_text(l, p + 1, skip_word(l, p + 1), "stop"));
}

// Splits the statements from p on, up to a }, an else, a comment or the end of the line.
static LineStatements split_statements(const HintLine *l, uint32_t p)
{
    LineStatements s = {.end = p};
    uint32_t depth = 0, gap = 0, next;
    bool strong = false;              // the gap contains a sign or word that no expression contains

    for (p = skip_blanks(l, p); p < l->end; p = skip_blanks(l, next)) {
        const char c = l->text[p];
        next = lexer_is_word(c) ? skip_word(l, p) : p + 1;
        if (depth == 0 && (c == '}' || c == '#' || has_text(l, p, next, "else")))
            break;
        if (strchr(":{}?\"[", c) || (c == '@' && !begins_statement(l, p)))
            return s;
        if (depth == 0 && begins_statement(l, p)) {
            if (s.n == STATEMENTS_MAX)
                return s;
            s.gap[s.n] = gap ? gap : s.end;
            s.begin[s.n++] = p;
            next = c == '-' ? p + 2 : c == '@' ? skip_word(l, p + 1) : next;
        } else if (depth == 0 && s.n > 0 &&
                   (c == ';' || c == ',' || c == '&' || has_text(l, p, next, "and") || has_text(l, p, next, "then"))) {
            gap = gap ? gap : s.end;
            strong = strong || c == ';' || c == ',' || has_text(l, p, next, "then");
            s.trailing = c == ';' ? next : 0;
            continue;
        } else if (strong || s.n == 0) {
            return s;
        }
        depth += c == '(';
        depth -= c == ')' && depth > 0;
        gap = 0;
        strong = false;
        s.trailing = 0;
        s.end = next;
    }
    s.clear = s.n > 1 && depth == 0 && (gap == 0 || s.trailing > 0);
    for (size_t i = 0; i + 1 < s.n; i++)
        s.clear = s.clear && !leaves_block(l, s.begin[i]);
    return s;
}

// Changes   condition: a; b   to   condition { a b } on lines of their own.
static void edit_into_braces(Diags *diags, Diag *d, const HintLine *l, const PriorStatement *b, const LineStatements *s)
{
    const uint32_t end = s->trailing ? s->trailing : s->end, after = skip_blanks(l, end), colon = before_blanks(l, b->colon);
    const bool last = after == l->end || l->text[after] == '#';
    const char *inner = new_line(diags->arena, l, b->braces + 1u), *outer = new_line(diags->arena, l, b->braces);

    diag_edit(diags, d, span_of(l, colon, s->begin[0]), format_in(diags->arena, " {%s", inner));
    for (size_t i = 1; i < s->n; i++)
        diag_edit(diags, d, span_of(l, s->gap[i], s->begin[i]), inner);
    if (s->trailing)
        diag_edit(diags, d, span_of(l, s->end, s->trailing), "");
    diag_edit(diags, d, last ? span_of(l, l->end, l->end) : span_of(l, end, after),
              format_in(diags->arena, "%s}%s", outer, last ? "" : " "));
}

// Changes   a; b   to two lines.
static void edit_onto_lines(Diags *diags, Diag *d, const HintLine *l, const PriorStatement *b, uint32_t at)
{
    const LineStatements s = split_statements(l, b->begin);

    for (size_t i = 1; i < s.n; i++)
        if (s.gap[i] <= at && s.begin[i] >= at && !leaves_block(l, s.begin[i - 1]))
            diag_edit(diags, d, span_of(l, s.gap[i], s.begin[i]), new_line(diags->arena, l, b->braces));
}

// Whether a -> follows p, perhaps after a comma or words.
static bool is_transition(const HintLine *l, uint32_t p)
{
    while (p < l->end && !begins_statement(l, p))
        p++;
    return p < l->end && l->text[p] == '-';
}

uint32_t hint_label_shared_line(Diags *diags, Diag *d, const Source *src, uint32_t at, HintSeparator separator)
{
    const HintLine l = line_of(src, at);
    const PriorStatement b = find_prior_statement(&l, at);
    LineStatements s;

    if (b.is == UNKNOWN || is_too_long(&l))
        return 0;
    // Without a ';' the transition may belong to a condition that lost its sign: mode = 2 -> Abort.
    if (b.is == PLAIN && separator == HINT_OTHER && is_transition(&l, at)) {
        diag_label(diags, d, DIAG_label_transition_alone);
        return at;
    }
    if (b.is == PLAIN) {
        diag_label(diags, d, DIAG_label_own_line);
        edit_onto_lines(diags, d, &l, &b, at);
        return at;
    }
    diag_label(diags, d, DIAG_label_all_in_braces);
    s = split_statements(&l, b.begin);
    if (s.clear && !continues_below(&l))
        edit_into_braces(diags, d, &l, &b, &s);
    return s.clear ? (s.trailing ? s.trailing : s.end) : l.end;
}

bool hint_is_first_of_several(const Source *src, uint32_t at)
{
    const HintLine l = line_of(src, at);
    uint32_t p = at, depth = 0;

    for (; p < l.end && l.text[p] != '#' && l.text[p] != '}'; p++) {
        depth += l.text[p] == '(';
        depth -= l.text[p] == ')' && depth > 0;
        if (l.text[p] == ';' && depth == 0) {
            const uint32_t next = skip_blanks(&l, p + 1);
            if (next < l.end && l.text[next] != '#' && l.text[next] != '}' && !has_text(&l, next, skip_word(&l, next), "else"))
                return true;
        }
    }
    return is_too_long(&l) || continues_below(&l);
}

// ---- lines below a colon ----

enum { LEVELS_MAX = 16 };     // of indentation; a block with more gets no edit

// The indentations of a block, each deeper than the one before.
typedef struct IndentLevels {
    size_t n;
    uint32_t at[LEVELS_MAX];
} IndentLevels;

// Returns false if the line's indentation is between two earlier depths: it is unclear which condition the line belongs to.
static bool enter_indent(IndentLevels *levels, uint32_t indent)
{
    while (levels->n > 0 && levels->at[levels->n - 1] > indent)
        if (--levels->n == 0 || levels->at[levels->n - 1] < indent)
            return false;
    if (levels->n == LEVELS_MAX)
        return false;
    if (levels->n == 0 || levels->at[levels->n - 1] < indent)
        levels->at[levels->n++] = indent;
    return true;
}

// Whether the line below a block clearly does not belong to it. Such a line is indented like the condition or less, an else exactly like
// it.
static bool ends_block(const HintLine *l, const HintLine *guard, uint32_t colon)
{
    const uint32_t p = skip_blanks(l, l->from);

    if (!has_text(l, p, skip_word(l, p), "else"))
        return is_indented_like(l, guard) || is_indented_like(guard, l);
    return is_indented_like(l, guard) && indentation(l) == indentation(guard) &&
           !memchr(guard->text + guard->from, ':', colon - guard->from);
}

// The number of parentheses open at the end of the line.
static uint32_t open_parens(const HintLine *l, uint32_t depth)
{
    for (uint32_t p = l->from; p < l->end && l->text[p] != '#'; p++) {
        depth += l->text[p] == '(';
        depth -= l->text[p] == ')' && depth > 0;
    }
    return depth;
}

// The number of braces that the line opens, minus those that it closes.
static int count_braces(const HintLine *l)
{
    int n = 0;

    for (uint32_t p = l->from; p < l->end && l->text[p] != '#'; p++)
        n += l->text[p] == '{' ? 1 : l->text[p] == '}' ? -1 : 0;
    return n;
}

uint32_t hint_brace_indented_lines(Diags *diags, Diag *d, const Source *src, uint32_t colon)
{
    const HintLine guard = line_of(src, colon);
    HintLine l = guard, last = guard;
    const uint32_t after = skip_blanks(&guard, colon + 1), from = before_blanks(&guard, colon);
    int braces = 0;
    uint32_t parens = 0;
    IndentLevels levels = {0};

    if (is_too_long(&guard) || (after < guard.end && guard.text[after] != '#'))
        return 0;
    while (next_line(&l)) {
        const char c = l.text[skip_blanks(&l, l.from)];
        if (is_empty_line(&l))
            continue;
        if (!is_deeper(&l, &guard)) {
            if (!ends_block(&l, &guard, colon))
                return 0;
            break;
        }
        if (is_too_long(&l) || (parens == 0 && !enter_indent(&levels, indentation(&l))))
            return 0;
        parens = open_parens(&l, parens);
        if (strchr("{.[", c) || (braces += count_braces(&l)) < 0)
            return 0;
        last = l;
    }
    if (last.from == guard.from || braces != 0 || parens != 0)
        return 0;
    diag_edit(diags, d, span_of(&guard, from, colon + 1), " {");
    diag_edit(diags, d, span_of(&last, last.end, last.end), format_in(diags->arena, "%s}", new_line(diags->arena, &guard, 0)));
    return last.end;
}
