// SPDX-License-Identifier: Apache-2.0
#include "compiler/syntax/hint_lines.h"

#include <string.h>

#include "compiler/syntax/lexer.h"

enum {
    STATEMENTS_MAX = 16,      // the most statements on a line; for a line with more, no edit is proposed
    LINE_MAX = 1000           // the most bytes of a line; a longer one gets no hint, so that hostile text cannot cost time quadratic in its length
};

typedef struct HintLine {
    const Source *src;
    const char *text;         // src->text
    uint32_t from, end;       // the line is text[from … end), without its line end and trailing spaces
    const char *line_end;     // "\n" or "\r\n", as this line ends
} HintLine;

static uint32_t skip_spaces(const HintLine *l, uint32_t p)
{
    while (p < l->end && is_space_or_tab(l->text[p]))
        p++;
    return p;
}

// Returns the end of the letters, digits and _ at p.
static uint32_t skip_word(const HintLine *l, uint32_t p)
{
    while (p < l->end && lexer_is_word(l->text[p]))
        p++;
    return p;
}

static uint32_t skip_spaces_back(const HintLine *l, uint32_t p)
{
    while (p > l->from && is_space_or_tab(l->text[p - 1]))
        p--;
    return p;
}

static bool is_text_equal(const HintLine *l, uint32_t at, uint32_t end, const char *word)
{
    return end - at == strlen(word) && memcmp(l->text + at, word, end - at) == 0;
}

// Returns the line that contains `at`, or as much of it as LINE_MAX allows.
static HintLine find_line(const Source *src, uint32_t at)
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
    l.end = skip_spaces_back(&l, l.end);
    return l;
}

// Returns a line end followed by the indentation of l and `levels` more levels of it.
static const char *format_line_break(Arena *arena, const HintLine *l, unsigned levels)
{
    const uint32_t indent = skip_spaces(l, l->from) - l->from;
    const bool tabs = memchr(l->text + l->from, '\t', indent) != NULL;
    const char *text = format_in(arena, "%s%.*s", l->line_end, (int)indent, l->text + l->from);

    while (levels-- > 0)
        text = format_in(arena, "%s%s", text, tabs ? "\t" : "    ");
    return text;
}

static bool is_too_long(const HintLine *l) { return l->end - l->from >= LINE_MAX; }
static Span line_span(const HintLine *l, uint32_t at, uint32_t end) { return (Span){l->src, at, end - at}; }

// Whether a statement such as x = 1, -> Idle, @assert or @stop begins at p.
static bool begins_statement(const HintLine *l, uint32_t p)
{
    uint32_t sign;

    if (l->text[p] == '-')
        return p + 1 < l->end && l->text[p + 1] == '>';
    if (l->text[p] == '@')
        return is_text_equal(l, p + 1, skip_word(l, p + 1), "assert") || is_text_equal(l, p + 1, skip_word(l, p + 1), "stop");
    if (!lex_is_letter(l->text[p]))
        return false;
    sign = skip_spaces(l, skip_word(l, p));
    return sign < l->end && l->text[sign] == '=' && (sign + 1 == l->end || (l->text[sign + 1] != '=' && l->text[sign + 1] != '>'));
}

// Whether a declaration such as F64 x begins at p: whether the word at p is a type.
static bool begins_declaration(const HintLine *l, uint32_t p)
{
    const uint32_t end = skip_word(l, p);

    for (int t = 0; t < SM_TYPE_COUNT; t++)
        if (is_text_equal(l, p, end, sm_type_info[t].spelling))
            return true;
    return false;
}

// ---- lines below ----

// Moves l to the next line; false at the end of the source.
static bool move_to_next_line(HintLine *l)
{
    uint32_t p = l->end;

    while (p < l->src->len && l->text[p] != '\n')
        p++;
    if (p == l->src->len)
        return false;
    *l = find_line(l->src, p + 1);
    return true;
}

// Whether the line contains nothing but blanks and a comment.
static bool is_empty_line(const HintLine *l)
{
    const uint32_t p = skip_spaces(l, l->from);

    return p == l->end || l->text[p] == '#';
}

static uint32_t measure_indentation(const HintLine *l) { return skip_spaces(l, l->from) - l->from; }

// Whether l begins with the indentation of `outer`.
static bool is_indented_like(const HintLine *l, const HintLine *outer)
{
    const uint32_t indent = measure_indentation(outer);

    return l->end - l->from > indent && memcmp(l->text + l->from, outer->text + outer->from, indent) == 0;
}

// Whether l begins with the indentation of `outer` and more.
static bool is_indented_deeper(const HintLine *l, const HintLine *outer)
{
    return is_indented_like(l, outer) && is_space_or_tab(l->text[l->from + measure_indentation(outer)]);
}

// Whether the next nonempty line is indented more than l. If so, it may be meant to depend on the condition of l.
static bool has_deeper_line_below(const HintLine *l)
{
    HintLine next = *l;

    while (move_to_next_line(&next))
        if (!is_empty_line(&next))
            return is_indented_deeper(&next, l);
    return false;
}

// ---- the preceding statement ----

// What the text before a statement on its line says about the statement.
typedef struct PriorStatement {
    enum { PLAIN, GUARDED, UNKNOWN } is;      // GUARDED: a condition's colon precedes the statement on its line
    uint32_t colon;           // GUARDED: position of that colon
    uint32_t begin;           // start of the statement
    bool braces;              // a brace opened on this line is still open before the statement
} PriorStatement;

// Returns the position of the quote that closes the text that begins at p.  If that quote is missing, returns `at` or a later position.
static uint32_t skip_quoted(const HintLine *l, uint32_t p, uint32_t at)
{
    while (p + 1 < at && l->text[p + 1] != '"')
        p++;
    return p + 1;
}

// Finds the last statement that begins before `at` on line l.
static PriorStatement find_prior_statement(const HintLine *l, uint32_t at)
{
    PriorStatement b = {UNKNOWN, 0, l->from, false};
    uint32_t depth = 0;                       // number of open parentheses
    bool after_colon = false;                 // a condition's colon precedes b.begin
    bool lost = false;                        // the line contains text that is not a statement, perhaps a condition

    for (uint32_t p = l->from; p < at; p++)
        switch (l->text[p]) {
        case '(': depth++; break;
        case ')': depth -= depth > 0; break;
        case '{': case '}':
            b.begin = p + 1;
            b.braces = l->text[p] == '{';
            after_colon = false;
            break;
        case ':':
            b.colon = p;
            b.begin = p + 1;
            after_colon = depth == 0;
            break;
        case ';':
            if (depth > 0 || after_colon)
                break;
            b.begin = skip_spaces(l, b.begin);
            lost = lost || !(begins_statement(l, b.begin) || begins_declaration(l, b.begin));
            b.begin = p + 1;
            break;
        case '"': p = skip_quoted(l, p, at); break;
        default: break;
        }
    b.begin = skip_spaces(l, b.begin);
    if (lost)
        return b;
    if (b.begin < at && begins_statement(l, b.begin))
        b.is = after_colon ? GUARDED : PLAIN;
    else if (begins_declaration(l, b.begin))
        b.is = PLAIN;
    return b;
}

// ---- statements of one line ----

typedef struct LineStatements {
    size_t n;
    uint32_t gap[STATEMENTS_MAX], begin[STATEMENTS_MAX];  // by statement: start of the separator before it; its first byte
    uint32_t end;             // end of the last statement
    uint32_t trailing;        // end of a ';' after the last statement; 0 if no ';' follows it
    bool clear;               // several statements, all of them executed, and nothing else follow
} LineStatements;

// Whether the statement at p is -> or @stop. No statement after it is executed, so if another statement follows on the line, it is unclear
// what the user means.
static bool leaves_block(const HintLine *l, uint32_t p)
{
    return l->text[p] == '-' || (l->text[p] == '@' && is_text_equal(l, p + 1, skip_word(l, p + 1), "stop"));
}

// Finds the statements from p on, up to a }, an else, a comment or the end of the line.
static LineStatements split_statements(const HintLine *l, uint32_t p)
{
    LineStatements s = {.end = p};
    uint32_t depth = 0, gap = 0, next;
    bool gap_ends_statement = false;  // the gap contains a separator that no expression contains: ; , or `then`

    for (p = skip_spaces(l, p); p < l->end; p = skip_spaces(l, next)) {
        const char c = l->text[p];
        next = lexer_is_word(c) ? skip_word(l, p) : p + 1;
        if (depth == 0 && (c == '}' || c == '#' || is_text_equal(l, p, next, "else")))
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
                   (c == ';' || c == ',' || c == '&' || is_text_equal(l, p, next, "and") || is_text_equal(l, p, next, "then"))) {
            gap = gap ? gap : s.end;
            gap_ends_statement = gap_ends_statement || c == ';' || c == ',' || is_text_equal(l, p, next, "then");
            s.trailing = c == ';' ? next : 0;
            continue;
        } else if (gap_ends_statement || s.n == 0) {
            return s;
        }
        depth += c == '(';
        depth -= c == ')' && depth > 0;
        gap = 0;
        gap_ends_statement = false;
        s.trailing = 0;
        s.end = next;
    }
    s.clear = s.n > 1 && depth == 0 && (gap == 0 || s.trailing > 0);
    for (size_t i = 0; i + 1 < s.n; i++)
        s.clear = s.clear && !leaves_block(l, s.begin[i]);
    return s;
}

// Proposes to replace `condition: a; b` with `condition { a b }`, with a and b on lines of their own.
static void propose_braces(Diags *diags, Diag *d, const HintLine *l, const PriorStatement *b, const LineStatements *s)
{
    const uint32_t end = s->trailing ? s->trailing : s->end, after = skip_spaces(l, end), colon = skip_spaces_back(l, b->colon);
    const bool last = after == l->end || l->text[after] == '#';
    const char *inner = format_line_break(diags->arena, l, b->braces + 1u), *outer = format_line_break(diags->arena, l, b->braces);

    diag_edit(diags, d, line_span(l, colon, s->begin[0]), format_in(diags->arena, " {%s", inner));
    for (size_t i = 1; i < s->n; i++)
        diag_edit(diags, d, line_span(l, s->gap[i], s->begin[i]), inner);
    if (s->trailing)
        diag_edit(diags, d, line_span(l, s->end, s->trailing), "");
    diag_edit(diags, d, last ? line_span(l, l->end, l->end) : line_span(l, end, after),
              format_in(diags->arena, "%s}%s", outer, last ? "" : " "));
}

// Labels d with what to do about the statement that follows, on its line, the one that ends before `at`.
uint32_t hint_label_shared_line(Diags *diags, Diag *d, const Source *src, uint32_t at, HintSeparator separator)
{
    const HintLine l = find_line(src, at);
    const PriorStatement b = find_prior_statement(&l, at);
    LineStatements s;

    if (b.is == UNKNOWN || is_too_long(&l))
        return 0;
    if (b.is == PLAIN && separator == HINT_OTHER) {
        uint32_t next = at;                            // start of the next statement, after any comma or words
        while (next < l.end && !begins_statement(&l, next))
            next++;
        // Without a ';' a transition may belong to a condition in which = was meant as ==: mode = 2 -> Abort.
        if (next < l.end && l.text[next] == '-') {
            diag_label(diags, d, DIAG_label_transition_alone);
            return at;
        }
    }
    if (b.is == PLAIN) {
        diag_label(diags, d, DIAG_label_own_line);
        s = split_statements(&l, b.begin);
        for (size_t i = 1; i < s.n; i++)               // replace the separator that contains `at` with a line break
            if (s.gap[i] <= at && s.begin[i] >= at && !leaves_block(&l, s.begin[i - 1]))
                diag_edit(diags, d, line_span(&l, s.gap[i], s.begin[i]), format_line_break(diags->arena, &l, b.braces));
        return at;
    }
    diag_label(diags, d, DIAG_label_all_in_braces);
    s = split_statements(&l, b.begin);
    if (s.clear && !has_deeper_line_below(&l))
        propose_braces(diags, d, &l, &b, &s);
    return s.clear ? (s.trailing ? s.trailing : s.end) : l.end;
}

// Whether more statements follow the statement at `at`: after a ';' on its line, or on a line below with more indentation.
bool hint_is_first_of_several(const Source *src, uint32_t at)
{
    const HintLine l = find_line(src, at);
    uint32_t p = at, depth = 0;

    for (; p < l.end && l.text[p] != '#' && l.text[p] != '}'; p++) {
        depth += l.text[p] == '(';
        depth -= l.text[p] == ')' && depth > 0;
        if (l.text[p] == ';' && depth == 0) {
            const uint32_t next = skip_spaces(&l, p + 1);
            if (next < l.end && l.text[next] != '#' && l.text[next] != '}' && !is_text_equal(&l, next, skip_word(&l, next), "else"))
                return true;
        }
    }
    return is_too_long(&l) || has_deeper_line_below(&l);
}

// Whether the text is a word that closes a conditional in another language.
static bool is_end_if(const HintLine *l, uint32_t at, uint32_t end)
{
    static const char *const words[] = {"end_if", "END_IF", "endif", "ENDIF", "EndIf", "end", "END"};

    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        if (is_text_equal(l, at, end, words[i]))
            return true;
    return false;
}

uint32_t hint_find_end_if(const Source *src, uint32_t at, uint32_t *end)
{
    const HintLine l = find_line(src, at);
    uint32_t semicolon = at, word, second;

    while (semicolon < l.end && !strchr(";#{}", l.text[semicolon]))
        semicolon++;
    word = skip_spaces(&l, semicolon + 1);
    if (semicolon >= l.end || l.text[semicolon] != ';' || !is_end_if(&l, word, skip_word(&l, word)))
        return 0;
    word = skip_word(&l, word);
    second = skip_spaces(&l, word);                       // end if
    if (is_text_equal(&l, second, skip_word(&l, second), "if") || is_text_equal(&l, second, skip_word(&l, second), "IF"))
        word = skip_word(&l, second);
    *end = l.text[word] == ';' ? word + 1 : word;
    second = skip_spaces(&l, *end);
    return second >= l.end || l.text[second] == '#' ? semicolon : 0;
}

// ---- lines below a colon ----

enum { LEVELS_MAX = 16 };     // the most levels of indentation; for a block with more, no edit is proposed

// The indentations of the current line and of the lines that enclose it, in bytes; each is larger than the previous one.
typedef struct IndentLevels {
    size_t n;
    uint32_t at[LEVELS_MAX];
} IndentLevels;

// Records the indentation of the next line. Returns false if there are too many levels, or if the indentation is between two recorded ones,
// because then it is unclear to which condition the line belongs.
static bool record_indent(IndentLevels *levels, uint32_t indent)
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

// Whether line l clearly does not belong to the block above it: l is indented as much as the condition's line `guard`, or less. An `else`
// must be indented exactly like the condition.
static bool ends_block(const HintLine *l, const HintLine *guard, uint32_t colon)
{
    const uint32_t p = skip_spaces(l, l->from);

    if (!is_text_equal(l, p, skip_word(l, p), "else"))
        return is_indented_like(l, guard) || is_indented_like(guard, l);
    return is_indented_like(l, guard) && measure_indentation(l) == measure_indentation(guard) &&
           !memchr(guard->text + guard->from, ':', colon - guard->from);
}

// Whether line l is a word that closes a block in other languages, as END_IF; sets *word to it.
static bool find_closing_word(const HintLine *l, Span *word)
{
    static const char *const words[] = {"END_IF", "end_if", "endif", "ENDIF", "end"};
    const uint32_t at = skip_spaces(l, l->from), end = skip_word(l, at);
    bool found = false;

    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        found = found || is_text_equal(l, at, end, words[i]);
    *word = line_span(l, at, end);
    return found;
}

// Proposes braces around the lines below a condition's colon, if they are indented more, so that they are probably its statements.
uint32_t hint_brace_indented_lines(Diags *diags, Diag *d, const Source *src, uint32_t colon, uint32_t len)
{
    const HintLine guard = find_line(src, colon);
    HintLine l = guard, last = guard;
    const uint32_t after = skip_spaces(&guard, colon + len), from = skip_spaces_back(&guard, colon);
    int braces = 0;                                    // braces opened since the colon minus braces closed
    uint32_t parens = 0;                               // open parentheses
    IndentLevels levels = {0};
    Span closing;

    if (is_too_long(&guard) || (after < guard.end && guard.text[after] != '#'))
        return 0;
    while (move_to_next_line(&l)) {
        const char c = l.text[skip_spaces(&l, l.from)];
        if (is_empty_line(&l))
            continue;
        if (!is_indented_deeper(&l, &guard)) {
            if (!ends_block(&l, &guard, colon))
                return 0;
            break;
        }
        if (is_too_long(&l) || (parens == 0 && !record_indent(&levels, measure_indentation(&l))))
            return 0;
        for (uint32_t p = l.from; p < l.end && l.text[p] != '#'; p++) {
            parens += l.text[p] == '(';
            parens -= l.text[p] == ')' && parens > 0;
            braces += l.text[p] == '{' ? 1 : l.text[p] == '}' ? -1 : 0;
        }
        if (strchr("{.[", c) || braces < 0)
            return 0;
        last = l;
    }
    if (last.from == guard.from || braces != 0 || parens != 0)
        return 0;
    diag_edit(diags, d, line_span(&guard, from, colon + len), " {");
    if (find_closing_word(&l, &closing))
        diag_edit(diags, d, closing, "}");
    else
        diag_edit(diags, d, line_span(&last, last.end, last.end), format_in(diags->arena, "%s}", format_line_break(diags->arena, &guard, 0)));
    return last.end;
}
