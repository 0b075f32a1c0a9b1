// SPDX-License-Identifier: Apache-2.0
// Hints about characters: typographic and mathematical symbols, letters of other alphabets, quotation marks.
#include <string.h>

#include "compiler/base/utf8.h"
#include "compiler/syntax/hint_text.h"
#include "compiler/syntax/hint_words.h"

// Unicode characters that word processors and mathematical texts use where this language has an ASCII operator. TOK_END: the character is a space.
static const struct { uint32_t code; const char *ascii; TokenKind kind; } lookalikes[] = {
    {0xa0, " ", TOK_END}, {0x2007, " ", TOK_END}, {0x2009, " ", TOK_END}, {0x202f, " ", TOK_END},
    {0x2010, "-", TOK_MINUS}, {0x2011, "-", TOK_MINUS}, {0x2012, "-", TOK_MINUS}, {0x2013, "-", TOK_MINUS},
    {0x2014, "-", TOK_MINUS}, {0x2212, "-", TOK_MINUS}, {0xd7, "*", TOK_STAR}, {0xb7, "*", TOK_STAR},
    {0x22c5, "*", TOK_STAR}, {0x2217, "*", TOK_STAR}, {0xf7, "/", TOK_SLASH}, {0x2044, "/", TOK_SLASH},
    {0x2215, "/", TOK_SLASH}, {0x2264, "<=", TOK_LE}, {0x2a7d, "<=", TOK_LE}, {0x2265, ">=", TOK_GE},
    {0x2a7e, ">=", TOK_GE}, {0x2260, "!=", TOK_NE}, {0x2192, "->", TOK_ARROW}, {0x21d2, "->", TOK_ARROW},
    {0xac, "!", TOK_BANG}, {0x2227, "and", TOK_AND}, {0x2228, "or", TOK_OR}, {0xff1a, ":", TOK_COLON},
    {0x2236, ":", TOK_COLON}, {0xff1d, "=", TOK_ASSIGN}, {0xff08, "(", TOK_LPAREN}, {0xff09, ")", TOK_RPAREN},
    {0xff1e, ">", TOK_GT}, {0xff1c, "<", TOK_LT}, {0xff0b, "+", TOK_PLUS}, {0xff0d, "-", TOK_MINUS}, {0xff0a, "*", TOK_STAR},
    {0xff0f, "/", TOK_SLASH}, {0xff5b, "{", TOK_LBRACE}, {0xff5d, "}", TOK_RBRACE}, {0xff0c, ",", TOK_COMMA}, {0x3000, " ", TOK_END}};

enum { NO_LOOKALIKE = sizeof lookalikes / sizeof *lookalikes };

// ---- characters that are not allowed ----

// Returns the row of `lookalikes` with this character; NO_LOOKALIKE: none.
static size_t find_lookalike(uint32_t code)
{
    size_t i = 0;

    while (i < NO_LOOKALIKE && lookalikes[i].code != code)
        i++;
    return i;
}

// Whether the code point is an ASCII, typographic or angle quotation mark.
static bool is_quote(uint32_t code)
{
    return code == '"' || code == '\'' || (code >= 0x2018 && code <= 0x201f) || code == 0xab || code == 0xbb;
}

// Returns the length in bytes of the letter at p if it is of another alphabet, such as ö; else 0.
static size_t skip_foreign_letter(const Lexer *l, uint32_t p)
{
    uint32_t code = 0;
    size_t len = utf8_decode(l->src->text + p, l->src->len - p, &code);

    return len > 1 && find_lookalike(code) == NO_LOOKALIKE && !is_quote(code) && !utf8_is_hidden(code) ? len : 0;
}

// Whether the character at `at`, row `like` of lookalikes, is a dash directly before `>`: then the user means the arrow ->.
static bool is_long_arrow(const Lexer *l, uint32_t at, uint32_t len, size_t like)
{
    return like < NO_LOOKALIKE && lookalikes[like].kind == TOK_MINUS && lexer_byte(l, at + len) == '>';
}

// Whether the character, row `like` of lookalikes, is a dash after the first number of an annotation, as in @range 0 – 5. Such a dash
// does not negate the second number.
static bool is_dash_of_range(const Lexer *l, size_t like)
{
    return l->annotated && !l->first && l->last == TOK_NUMBER && like < NO_LOOKALIKE && lookalikes[like].kind == TOK_MINUS;
}

// Whether the character is part of a number, as in 0·5 or in 60 000 with a no-break space. Such a character must not be replaced with the
// operator or space that it resembles.
static bool is_inside_number(const Lexer *l, uint32_t at, uint32_t len, uint32_t code)
{
    const bool may_be = code == 0xb7 || code == 0x22c5 || code == 0xa0 || code == 0x2007 || code == 0x2009 || code == 0x202f;

    return may_be && at > 0 && lex_is_digit(l->src->text[at - 1]) && lex_is_digit(lexer_byte(l, at + len)) && l->last == TOK_NUMBER;
}

// What to write instead of a character that has no operator in its place.
static const struct { uint32_t code; const char *write; } instead[] = {
    {0xb2, "x * x, or pow(x, 2)"}, {0xb3, "pow(x, 3)"}, {0x221a, "sqrt(x)"}, {0x3c0, "3.14159265"}, {0x2248, "abs(a - b) < 0.001"},
    {0x221e, "a number beyond every real value, such as 1e9"}, {0xb1, "a - 0.1 < x < a + 0.1"}, {0x2208, "x == A or x == B"},
    {0xbd, "0.5"}, {0xbc, "0.25"}, {0xbe, "0.75"}};

// Whether the character is a full-width letter or digit, as East Asian keyboards type it.
static bool is_full_width(uint32_t code) { return code >= 0xff10 && code <= 0xff5a; }

// Returns the text of `instead` for a character; NULL: none.
static const char *find_instead(uint32_t code)
{
    for (size_t i = 0; i < sizeof instead / sizeof *instead; i++)
        if (instead[i].code == code)
            return instead[i].write;
    return NULL;
}

static void report_code_point(Lexer *l, uint32_t at, uint32_t len, uint32_t code)
{
    const char *shown = utf8_is_hidden(code) || code == 0xa0 ? format_in(l->diags->arena, "U+%04X", (unsigned)code)
                                                              : lexer_text(l, at, at + len);
    size_t like = find_lookalike(code);
    const char *ascii = like < NO_LOOKALIKE ? lookalikes[like].ascii : NULL, *edit = NULL;
    Diag *d;

    if (!ascii && !lexer_mark_line_reported(l))
        return;
    if (is_long_arrow(l, at, len, like)) {
        ascii = "->";
        len++;
    }
    if (like < NO_LOOKALIKE && lookalikes[like].kind == TOK_ARROW && !l->stores && hint_follows_value(l, l->first))
        ascii = ": ->";                         // the user wrote `x > 5 → Vent`
    d = diag_report(l->diags, DIAG_not_ascii, lexer_span(l, at, len), shown);
    if (!ascii && find_instead(code))
        diag_label(l->diags, d, DIAG_label_write, find_instead(code));
    else if (!ascii && is_full_width(code))
        diag_label(l->diags, d, DIAG_label_full_width);
    else if (!ascii && code == 0xb0 && !lex_is_letter(lexer_byte(l, at + len)))
        diag_label(l->diags, d, DIAG_label_degrees);
    else if (!ascii && l->last == TOK_NUMBER && !l->first)
        diag_label(l->diags, d, DIAG_label_no_unit, "the value in", lexer_text(l, at, lexer_skip_word(l, at + len)));
    else if (skip_foreign_letter(l, at))
        diag_label(l->diags, d, DIAG_label_name_ascii);
    if (!ascii)
        return;
    if (is_dash_of_range(l, like) || is_inside_number(l, at, len, code)) {
        diag_label(l->diags, d, l->annotated ? DIAG_label_range_dash : DIAG_label_in_number);
        return;
    }
    if (lex_is_letter(*ascii))
        edit = format_in(l->diags->arena, "%s%s%s", at > 0 && l->src->text[at - 1] == ' ' ? "" : " ", ascii,
                         lexer_byte(l, at + len) == ' ' ? "" : " ");
    if (*ascii == '!' && !ascii[1] && !hint_is_negated_alone(l->src->text, at + len)) {
        diag_label(l->diags, d, DIAG_label_write, "not (...)");
        return;
    }
    if (*ascii == ' ' && !ascii[1])
        diag_label(l->diags, d, DIAG_label_plain_space);
    else
        diag_label(l->diags, d, DIAG_label_write, ascii);
    diag_edit(l->diags, d, lexer_span(l, at, len), edit ? edit : ascii);
}

// Reports the character at `at`, which is not ASCII; returns its length.
uint32_t hint_report_non_ascii(Lexer *l, uint32_t at)
{
    uint32_t code = 0;
    size_t len = utf8_decode(l->src->text + at, l->src->len - at, &code);

    if (len > 0) {
        report_code_point(l, at, (uint32_t)len, code);
        return (uint32_t)len;
    }
    return lexer_report_not_utf8(l, at);
}

// ---- text that begins no token ----

// Returns the position of the quote that closes the text from p on, and its length in *len; the end of the line and 0 if no quote closes it.
// `plain`: only a " can close the text.
static uint32_t find_closing_quote(const Lexer *l, uint32_t p, bool plain, uint32_t *len)
{
    uint32_t code = 0;

    *len = 0;
    for (; p < l->src->len && l->src->text[p] != '\n'; p += *len ? *len : 1) {
        *len = (uint32_t)utf8_decode(l->src->text + p, l->src->len - p, &code);
        if (*len && (plain ? code == '"' : is_quote(code)))
            return p;
    }
    *len = 0;
    return p;
}

// Reports the reason of an @allow, or a file name, that is in quotes other than " or is not closed on its line. Reads it as TOK_ERROR.
static void read_misquoted_text(Lexer *l, Token *t, uint32_t quote_len)
{
    bool plain = l->src->text[l->at] == '"';
    uint32_t from = l->at + quote_len, closing = 0, end = find_closing_quote(l, from, plain, &closing);
    Diag *d = diag_report(l->diags, l->config ? DIAG_file_quotes : DIAG_reason_quotes, lexer_span(l, l->at, end + closing - l->at));

    if (closing) {
        diag_edit(l->diags, d, lexer_span(l, l->at, quote_len), "\"");
        diag_edit(l->diags, d, lexer_span(l, end, closing), "\"");
    }
    t->text = str_intern(l->strings, l->src->text + from, end - from);
    lexer_check_comment(l, from, end);
    lexer_finish_token(l, t, TOK_ERROR, end + closing);
}

// Quoted text can be a remark after a complete statement: @assert p > 5, "too low". If the text, which ends at `end`, is such a remark and
// the last on its line, returns where the spaces and the comma before the quote begin; else 0, as for init_state "Idle".
static uint32_t find_remark_start(const Lexer *l, uint32_t end)
{
    const char *s = l->src->text;
    uint32_t from = l->at, second = l->line_start;

    while (is_space_tab_or_return(s[end]))
        end++;
    while (from > 0 && (is_space_tab_or_return(s[from - 1]) || s[from - 1] == ','))
        from--;
    while (is_space_tab_or_return(s[second]))
        second++;
    for (second = lexer_skip_word(l, second); is_space_tab_or_return(s[second]); second++)
        ;
    if (l->parens > 0 || second >= from || (s[end] != '\n' && end != l->src->len))
        return 0;
    return l->last == TOK_NAME || l->last == TOK_NUMBER || l->last == TOK_RPAREN || l->last == TOK_TRUE || l->last == TOK_FALSE ||
           l->last == TOK_COMMA ? from : 0;
}

// Whether the quote at l->at is the first argument of a function or statement that prints, as in print("on") and echo "on".
static bool is_printed(const Lexer *l)
{
    static const char *const functions[] = {"print", "printf", "println", "log", "disp", "puts", "echo", "fprintf", "error", "warning"};
    const char *s = l->src->text;
    uint32_t end = l->at, from;

    if (end > 0 && (s[end - 1] == 'f' || s[end - 1] == 'r') && !(end > 1 && lexer_is_word(s[end - 2])))
        end--;                                                // print(f"{x}")
    if (end > 0 && s[end - 1] == '(')
        end--;
    while (end > 0 && is_space_tab_or_return(s[end - 1]))
        end--;
    for (from = end; from > 0 && lexer_is_word(s[from - 1]); from--) {}
    for (size_t i = 0; i < sizeof functions / sizeof *functions; i++)
        if (end - from == strlen(functions[i]) && memcmp(s + from, functions[i], end - from) == 0)
            return true;
    return false;
}

static void label_quoted_text(Lexer *l, Diag *d, uint32_t from, uint32_t end, uint32_t closing)
{
    const Span whole = lexer_span(l, l->at, end + closing - l->at);
    const uint32_t remark = find_remark_start(l, end + closing);
    const char *text = lexer_text(l, from, end);
    const bool is_word = lex_is_identifier(l->src->text + from, end - from);

    if (is_printed(l)) {
        diag_label(l->diags, d, l->script ? DIAG_label_print_value : DIAG_label_print_in_script);
    } else if (remark) {
        text = format_in(l->diags->arena, "  # %.*s", (int)(end - from), l->src->text + from);
        diag_label(l->diags, d, DIAG_label_quoted_remark);
        diag_edit(l->diags, d, lexer_span(l, remark, end + closing - remark), text);
    } else if (is_word && (l->last == TOK_ARROW || hint_knows_word(l, from, end))) {
        diag_label(l->diags, d, DIAG_label_write, text);
        diag_edit(l->diags, d, whole, text);
    } else if (is_word) {
        diag_label(l->diags, d, DIAG_label_no_quotes, text);
    } else if (l->annotated) {
        diag_label(l->diags, d, DIAG_label_quoted_annotation);
    } else {
        diag_label(l->diags, d, DIAG_label_quoted_text);
    }
}

// Reports the text of an item of a script that has no closing quote on its line, and reads it as that text.
static void read_unclosed_text(Lexer *l, Token *t, uint32_t end)
{
    diag_label(l->diags, diag_report(l->diags, DIAG_text_unclosed, lexer_span(l, l->at, end - l->at)), DIAG_label_close_text);
    t->text = str_intern(l->strings, l->src->text + l->at + 1, end - l->at - 1);
    lexer_check_comment(l, l->at + 1, end);
    lexer_finish_token(l, t, TOK_TEXT, end);
}

// Reports a text in quotes other than ", and reads it as that text.
static void read_text_in_other_quotes(Lexer *l, Token *t, uint32_t quote_len, uint32_t end, uint32_t closing)
{
    const uint32_t from = l->at + quote_len;
    Diag *d = diag_report(l->diags, DIAG_text_quotes, lexer_span(l, l->at, end + closing - l->at));

    t->text = str_intern(l->strings, l->src->text + from, end - from);
    diag_label(l->diags, d, DIAG_label_write, format_in(l->diags->arena, "\"%s\"", lexer_text(l, from, end)));
    diag_edit(l->diags, d, lexer_span(l, l->at, quote_len), "\"");
    diag_edit(l->diags, d, lexer_span(l, end, closing), "\"");
    lexer_check_comment(l, from, end);
    lexer_finish_token(l, t, TOK_TEXT, end + closing);
}

bool hint_read_escaped_quote(Lexer *l, uint32_t from, uint32_t at)
{
    uint32_t closing;
    Diag *d;

    if (at == from || l->src->text[at - 1] != '\\')
        return false;
    find_closing_quote(l, at + 1, true, &closing);
    if (!closing)
        return false;
    d = diag_report(l->diags, DIAG_text_escape, lexer_span(l, at - 1, 2));
    diag_label(l->diags, d, DIAG_label_write, "'");
    diag_edit(l->diags, d, lexer_span(l, at - 1, 2), "'");
    return true;
}

// Whether the quote at l->at is assigned to a state, as in state = "Hold". Then the assignment is the mistake, and the checker reports it.
static bool is_assigned_to_state(const Lexer *l)
{
    uint32_t at = l->at;

    while (at > 0 && is_space_tab_or_return(l->src->text[at - 1]))
        at--;
    if (l->last != TOK_ASSIGN || at == 0)
        return false;
    at -= at > 1 && l->src->text[at - 2] == ':' ? 2 : 1;
    return hint_follows_state(l, at);
}

// Reports text in three quotes, which is a comment of several lines in Python, and skips it. Returns false if no such text is here.
static bool skip_triple_quoted(Lexer *l)
{
    const char *s = l->src->text;
    const char quote[] = {s[l->at], s[l->at], s[l->at], '\0'};
    const char *end;

    if (!l->first || l->config || (quote[0] != '"' && quote[0] != '\'') || strncmp(s + l->at, quote, 3) != 0 || !(end = strstr(s + l->at + 3, quote)))
        return false;
    diag_label(l->diags, diag_report(l->diags, DIAG_foreign_comment, lexer_span(l, l->at, 3), quote), DIAG_label_comment_lines);
    while (l->at < (uint32_t)(end - s) + 3)
        if (s[l->at] == '\n')
            lexer_end_line(l);
        else
            l->at++;
    return true;
}

// Reports quoted text where the grammar allows none. The token ends at the closing quote or at the end of the line.
static void read_quoted_text(Lexer *l, Token *t, uint32_t quote_len)
{
    const bool is_plain = l->src->text[l->at] == '"';
    uint32_t closing = 0, p = find_closing_quote(l, l->at + quote_len, is_plain && lexer_may_be_remark(l), &closing);

    if (l->allow != LEX_NO_ALLOW || l->config) {
        read_misquoted_text(l, t, quote_len);
        return;
    }
    if (!closing && is_plain && lexer_may_be_remark(l)) {
        read_unclosed_text(l, t, p);
        return;
    }
    if (closing && is_plain && l->requirements) {          // the parser reports what precedes it, as in 1. "no fire"
        t->text = str_intern(l->strings, l->src->text + l->at + quote_len, p - l->at - quote_len);
        lexer_finish_token(l, t, TOK_TEXT, p + closing);
        return;
    }
    if (closing && !is_plain && (l->data || lexer_may_be_remark(l))) {
        read_text_in_other_quotes(l, t, quote_len, p, closing);
        return;
    }
    if (closing && lex_is_identifier(l->src->text + l->at + quote_len, p - l->at - quote_len) && is_assigned_to_state(l)) {
        t->text = str_intern(l->strings, l->src->text + l->at + quote_len, p - l->at - quote_len);
        lexer_finish_token(l, t, TOK_NAME, p + closing);
        return;
    }
    if (lexer_mark_line_reported(l))
        label_quoted_text(l, diag_report(l->diags, DIAG_string, lexer_span(l, l->at, p + closing - l->at)), l->at + quote_len, p, closing);
    lexer_finish_token(l, t, TOK_ERROR, p + closing);
}

// Reads a character that resembles an operator as that operator. Skips one that resembles a space, and a byte that is not UTF-8.
static HintResult read_lookalike(Lexer *l, Token *t, uint32_t code)
{
    size_t like = find_lookalike(code);
    uint32_t len = hint_report_non_ascii(l, l->at);
    const bool arrow = is_long_arrow(l, l->at, len, like);

    if (like == NO_LOOKALIKE || lookalikes[like].kind == TOK_END || is_dash_of_range(l, like)) {
        l->at += len;
        return HINT_SKIPPED;
    }
    lexer_finish_token(l, t, arrow ? TOK_ARROW : lookalikes[like].kind, l->at + len + arrow);
    return HINT_READ;
}

// Reports the letters of other alphabets in a name, as in größe, which begin at `end`; returns the end of the name.
uint32_t hint_skip_foreign_letters(Lexer *l, uint32_t end)
{
    while ((unsigned char)lexer_byte(l, end) >= 0x80 && skip_foreign_letter(l, end))   // reports all letters of the word
        end = lexer_skip_word(l, end + hint_report_non_ascii(l, end));
    return end;
}

// Reports text that cannot begin a token, and reads past it or returns what the user meant.  Never returns HINT_NONE.
HintResult hint_read_stray_text(Lexer *l, Token *t)
{
    unsigned char c = (unsigned char)l->src->text[l->at];
    uint32_t code = c;
    size_t len = utf8_decode(l->src->text + l->at, l->src->len - l->at, &code);

    if (skip_triple_quoted(l))
        return HINT_SKIPPED;
    if (len && is_quote(code)) {
        read_quoted_text(l, t, (uint32_t)len);
        return HINT_READ;
    }
    if (skip_foreign_letter(l, l->at)) {
        lexer_read_word(l, t);
        return HINT_READ;
    }
    if (c >= 0x80)
        return read_lookalike(l, t, code);
    if (c < 0x20 || c == 0x7f)
        lexer_report_control(l, l->at);
    else if (lexer_mark_line_reported(l))
        diag_report(l->diags, DIAG_stray_character, lexer_span(l, l->at, 1), lexer_text(l, l->at, l->at + 1));
    l->at++;
    return HINT_SKIPPED;
}
