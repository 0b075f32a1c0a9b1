// SPDX-License-Identifier: Apache-2.0
// Parses lists of declarations and of options. A declaration or option can continue on further lines.
#include <string.h>

#include "compiler/syntax/hints.h"
#include "compiler/syntax/parser.h"

// ---- types ----

// Whether other languages have this word as the type of a text.
static bool is_type_of_text(const char *word)
{
    static const char *const words[] = {"string", "String", "STRING", "str", "text", "TEXT"};
    size_t i = 0;

    while (i < sizeof words / sizeof *words && strcmp(word, words[i]) != 0)
        i++;
    return i < sizeof words / sizeof *words;
}

static void report_unknown_type(Parser *p)
{
    static const char *const types[] = {
#define SM_TYPE(name, wire, spelling, ctype, bytes, kind) spelling,
#include "stdlib/types.def"
#undef SM_TYPE
    };
    const char *word = p->tok.text->text, *synonym = hint_find_synonym(HINT_TYPES, word);
    const char *near = synonym ? synonym : str_nearest(word, types, sizeof types / sizeof *types);
    Diag *d = parser_report(p, DIAG_type_unknown, parser_token_span(p), word);

    if (is_type_of_text(word))
        diag_label(p->diags, d, DIAG_label_no_texts);
    else if (near)
        diag_label(p->diags, d, DIAG_label_did_you_mean, near);
}

// Reports text that is not a type where a declaration should begin. Returns true if a name follows, so that parsing can continue.
static bool recover_type(Parser *p, const AstSection *s)
{
    if (p->tok.kind == TOK_NAME && p->ahead.kind == TOK_NAME && !p->ahead.first) {
        report_unknown_type(p);
        parser_advance(p);
        return true;
    }
    if (p->tok.kind == TOK_NAME) {
        Diag *d = parser_fail(p, DIAG_decl_without_type, parser_token_span(p), p->tok.text->text);
        diag_label(p->diags, d, DIAG_label_type_first, p->tok.text->text);
    } else if (p->tok.kind == TOK_LABEL) {
        parser_fail(p, DIAG_label_outside_state, parser_token_span(p), p->tok.text->text);
    } else if (p->tok.kind == TOK_ANNOTATION) {
        parser_report_annotation_before_decl(p);
    } else if (p->tok.kind == TOK_ERROR) {
        p->failed = true;
    } else {
        parser_fail(p, DIAG_expected_decl, parser_token_span(p), s->name->text, parser_describe(p, &p->tok));
    }
    parser_advance(p);
    return false;
}

// ---- declarations ----

// Parses the name of a declaration. Returns false after reporting that none follows, or that it is malformed.
static bool parse_decl_name(Parser *p, AstDecl *d)
{
    TokenKind reserved;

    d->name = p->tok.text;
    d->name_span = parser_token_span(p);
    if (p->tok.kind == TOK_NAME) {
        str_declare(p->strings, d->name);
        parser_advance(p);
        return hint_explain(p, HINT_AFTER_DECL_NAME, NULL) == HINT_NONE;
    }
    if (p->tok.kind == TOK_ERROR) {
        p->failed = true;
    } else if (p->tok.text && !p->tok.first && p->tok.kind != TOK_LABEL && p->tok.kind != TOK_ANNOTATION && p->tok.kind != TOK_HEADER &&
               lex_find_reserved(p->tok.text, &reserved)) {
        diag_label(p->diags, parser_fail(p, DIAG_name_reserved, parser_token_span(p), p->tok.text->text), DIAG_label_other_name,
                   p->tok.text->text);
        parser_advance(p);
    } else {
        parser_fail(p, DIAG_decl_without_name, parser_missing_span(p),
                    parser_text(p, parser_span(p, &p->last)), parser_describe_found(p));
    }
    return false;
}

static bool begins_value(const Parser *p)
{
    return p->tok.kind != TOK_HEADER && p->tok.kind != TOK_END && p->tok.kind != TOK_ANNOTATION && p->tok.kind != TOK_TYPE;
}

// Returns the type of the declaration as a word of this language, also if the user wrote a type of another language.
static const char *name_of_type(const Parser *p, const AstDecl *d)
{
    const char *written = parser_text(p, d->type_span), *synonym = hint_find_synonym(HINT_TYPES, written);

    return synonym ? synonym : written;
}

static void parse_initial_value(Parser *p, AstDecl *d)
{
    TokenKind kind = p->tok.kind;

    if (kind != TOK_ASSIGN && d->type == SM_TYPE_COUNT && !hint_find_synonym(HINT_TYPES, parser_text(p, d->type_span))) {
        p->failed = true;                      // the unknown type is reported; it may be no type, so nothing more is parsed
        return;
    }
    if (kind == TOK_COMMA && !p->tok.first) {                     // F64 i, j = 0
        diag_label(p->diags, parser_fail(p, DIAG_decl_comma, parser_token_span(p)), DIAG_label_decl_each);
        return;
    }
    if (kind == TOK_EQ && !p->tok.first) {
        Diag *x = parser_report(p, DIAG_foreign_operator, parser_token_span(p), "==", "=");
        diag_label(p->diags, x, DIAG_label_write, "=");
        diag_edit(p->diags, x, parser_token_span(p), "=");
        kind = TOK_ASSIGN;
    }
    if (kind != TOK_ASSIGN) {
        const char *const type = name_of_type(p, d);
        const bool has_value = !p->tok.first && (kind == TOK_NUMBER || kind == TOK_TRUE || kind == TOK_FALSE);
        Diag *x = parser_fail(p, DIAG_local_without_value, d->name_span, d->name->text);
        if (kind == TOK_MINUS && !p->tok.first && p->ahead.kind == TOK_NAME) {
            diag_label(p->diags, x, DIAG_label_name_joined, format_in(p->arena, "%s_%s", d->name->text, p->ahead.text->text));
        } else if (has_value) {
            diag_label(p->diags, x, DIAG_label_write,
                       format_in(p->arena, "%s %s = %s", type, d->name->text, parser_text(p, parser_token_span(p))));
            diag_edit(p->diags, x, (Span){p->lex.src, p->tok.at, 0}, "= ");
        } else {
            diag_label(p->diags, x, DIAG_label_local_value, type, d->name->text, d->type == SM_BOOL ? "false" : "0");
        }
        return;
    }
    parser_advance(p);
    d->value = begins_value(p) ? parse_expr(p, false) : parse_value_of(p, false);
}

// Whether the current token does not belong to the declaration d any more.
static bool ends_decl(const Parser *p, const AstSection *s, const AstDecl *d)
{
    if (p->tok.kind == TOK_HEADER || p->tok.kind == TOK_END || p->tok.first)
        return true;
    return p->tok.kind == TOK_TYPE && (s->kind != AST_LOCAL || d->annotations.n > 0 || p->last.kind == TOK_ANNOTATION);
}

// Reports text that follows declaration d and does not belong to it.
static void report_after_decl(Parser *p, const AstSection *s, const AstDecl *d)
{
    if (hint_explain(p, HINT_AT_DECL_END, NULL) != HINT_NONE)
        return;
    if (p->tok.kind == TOK_ASSIGN && s->kind != AST_LOCAL)
        diag_label(p->diags, parser_fail(p, DIAG_element_with_value, parser_token_span(p), d->name->text), DIAG_label_no_element_value);
    else if (p->tok.kind == TOK_COMMA)
        diag_label(p->diags, parser_fail(p, DIAG_decl_comma, parser_token_span(p)), DIAG_label_decl_each);
    else if (p->tok.kind == TOK_NAME && s->kind != AST_LOCAL && p->ahead.kind == TOK_NAME && !p->ahead.first)
        return;                                    // probably a declaration whose type is misspelt: the caller parses it
    else if (s->kind != AST_LOCAL && (p->tok.kind == TOK_NAME || p->tok.kind == TOK_LPAREN || p->tok.kind == TOK_MINUS))
        hint_explain(p, HINT_AT_ELEMENT_END, NULL);
    else
        hint_explain(p, HINT_AT_END, NULL);
}

static void parse_decl(Parser *p, AstSection *s)
{
    const AstAnnotationTarget target = s->kind == AST_REGION  ? AST_ON_SV_ELEMENT
                                       : s->kind == AST_LOCAL ? (p->kind == FILE_SS ? AST_ON_SCRIPT_LOCAL : AST_ON_LOCAL)
                                                              : AST_ON_ELEMENT;
    AstDecl d = {0};
    size_t errors;

    if (hint_explain(p, HINT_AT_DECL, NULL) == HINT_SKIPPED)
        return;
    d.type = p->tok.kind == TOK_TYPE ? p->tok.type : SM_TYPE_COUNT;
    d.type_span = parser_token_span(p);
    if (p->tok.kind == TOK_TYPE)
        parser_advance(p);
    else if (!recover_type(p, s))
        return;
    if (!parse_decl_name(p, &d))
        return;
    errors = p->diags->errors_seen;
    if (s->kind == AST_LOCAL)
        parse_initial_value(p, &d);
    if (!p->failed)
        hint_explain(p, HINT_AFTER_DECL, NULL);
    parse_annotations(p, target, d.name, d.name_span, &d.annotations);
    if (!p->failed && !ends_decl(p, s, &d))
        report_after_decl(p, s, &d);
    d.is_incomplete = p->failed || p->diags->errors_seen > errors;
    vec_push(p->arena, &s->decls, d);
}

void parse_decls(Parser *p, AstSection *s)
{
    while (p->tok.kind != TOK_HEADER && p->tok.kind != TOK_END) {
        p->failed = false;
        if (parser_at_include(p))
            parser_report_late_include(p);
        else
            parse_decl(p, s);
        if (p->failed)
            parser_skip_line(p);
    }
    p->failed = false;
}

// ---- definitions ----

// Reports text that begins no definition. If it is a declaration, skips the type and returns true, so that the rest is parsed as a definition.
static bool recover_definition(Parser *p)
{
    Diag *d;

    if (p->tok.kind == TOK_ERROR)
        p->failed = true;
    d = parser_report(p, DIAG_expected_definition, parser_token_span(p), parser_describe(p, &p->tok));
    p->failed = p->failed || p->tok.kind != TOK_TYPE || p->ahead.kind != TOK_NAME;
    if (!p->failed) {
        diag_label(p->diags, d, DIAG_label_definition_without_type);
        diag_edit(p->diags, d, (Span){p->lex.src, p->tok.at, p->ahead.at - p->tok.at}, "");
    }
    parser_advance(p);
    return !p->failed;
}

static void parse_definition(Parser *p, AstSection *s)
{
    AstDefinition d = {0};

    if (p->tok.kind != TOK_NAME && !recover_definition(p))
        return;
    d.name = p->tok.text;
    d.name_span = parser_token_span(p);
    str_declare(p->strings, d.name);
    parser_advance(p);
    if (p->tok.kind != TOK_ASSIGN || p->tok.first) {
        hint_explain(p, HINT_AT_DEFINITION_VALUE, NULL);
        return;
    }
    parser_advance(p);
    d.value = parse_value_of(p, false);
    if (!p->tok.first)
        parse_annotations(p, AST_ON_DEFINITION, d.name, d.name_span, &d.annotations);
    if (!p->failed && !p->tok.first && p->tok.kind != TOK_HEADER && p->tok.kind != TOK_END)
        hint_explain(p, HINT_AT_END, NULL);
    vec_push(p->arena, &s->definitions, d);
}

void parse_definitions(Parser *p, AstSection *s)
{
    while (p->tok.kind != TOK_HEADER && p->tok.kind != TOK_END) {
        p->failed = false;
        parse_definition(p, s);
        if (p->failed)
            parser_skip_line(p);
    }
    p->failed = false;
}

// ---- options ----

typedef enum OptionTakes { TAKES_NOTHING, TAKES_TIME, TAKES_UNIT, TAKES_COUNT, TAKES_NAME, TAKES_SETTING } OptionTakes;

// The options of all files. `in`: by FileKind, whether a file of this kind can have the option.
static const struct { const char *name; OptionTakes takes; bool in[FILE_KINDS]; } options[] = {
#define OPTION(name, takes, in_sv, in_sm, in_ss) {#name, TAKES_##takes, {[FILE_SV] = in_sv, [FILE_SM] = in_sm, [FILE_SS] = in_ss}},
#include "compiler/syntax/section_options.def"
#undef OPTION
};

static const char *const option_words[] = {
#define OPTION(name, takes, in_sv, in_sm, in_ss) #name,
#include "compiler/syntax/section_options.def"
#undef OPTION
};

// What is expected after an option, for a diagnostic, by OptionTakes.
static const char *const expected_value[] = {
    [TAKES_NOTHING] = "no value", [TAKES_TIME] = "a number without a sign", [TAKES_UNIT] = "us, ms or s",
    [TAKES_COUNT] = "a number without a sign", [TAKES_NAME] = "the name of a state", [TAKES_SETTING] = "the name of a parameter and its value"};

enum { OPTION_COUNT = sizeof option_words / sizeof *option_words };

// Parses the value of a parameter: a number with or without a sign and a unit of time, true or false. Returns false if no value follows.
static bool parse_setting_value(Parser *p, AstOption *o)
{
    const uint32_t at = p->tok.at;
    const bool minus = p->tok.kind == TOK_MINUS;

    if (minus || p->tok.kind == TOK_PLUS)
        parser_advance(p);
    if (p->tok.kind != TOK_NUMBER && (p->tok.at != at || (p->tok.kind != TOK_TRUE && p->tok.kind != TOK_FALSE)))
        return false;
    o->number = parse_number(p);
    if (minus) {
        AstExpr *negative = ARENA_NEW(p->arena, AstExpr);
        *negative = (AstExpr){.kind = AST_UNARY, .op = SM_OP_NEG, .depth = 2, .a = o->number};
        o->number = negative;
    }
    o->number->span = parser_span_since(p, at);
    o->value_span = o->number->span;
    return true;
}

// Parses NAME VALUE after `set`, with or without a '=' between them.
static bool parse_setting(Parser *p, AstOption *o)
{
    if (p->tok.kind != TOK_NAME || p->tok.first)
        return false;
    o->word = p->tok.text;
    o->word_span = parser_token_span(p);
    parser_advance(p);
    if (p->tok.kind == TOK_ASSIGN) {
        diag_edit(p->diags, parser_report(p, DIAG_option_sign, parser_token_span(p), parser_text(p, parser_token_span(p))), parser_token_span(p), "");
        parser_advance(p);
    }
    return parse_setting_value(p, o);
}

// Whether the next token is `file` of the option `delta_t file`: the length of each step comes from the rows of a recording.
static bool is_step_of_rows(const Parser *p, const AstOption *o)
{
    return p->kind == FILE_SS && strcmp(o->name->text, "delta_t") == 0 && !p->tok.first && strcmp(p->tok.text->text, "file") == 0;
}

// Parses the argument that follows the word of an option. Returns false, and reports nothing, if the text is no argument of this option.
static bool parse_option_argument(Parser *p, AstOption *o, OptionTakes takes)
{
    o->value_span = parser_token_span(p);
    if (takes == TAKES_SETTING)
        return parse_setting(p, o);
    if ((takes == TAKES_TIME || takes == TAKES_COUNT) && p->tok.kind == TOK_NUMBER) {
        o->number = parse_number(p);
        o->value_span = o->number->span;
        return true;
    }
    if (p->tok.kind != TOK_NAME || (takes == TAKES_TIME && !is_step_of_rows(p, o)) || takes == TAKES_COUNT ||
        (takes == TAKES_UNIT && !time_unit_counts(time_unit_find(p->tok.text->text))))
        return false;
    o->word = p->tok.text;
    parser_advance(p);
    return true;
}

static void parse_option_value(Parser *p, AstOption *o, OptionTakes takes)
{
    if (takes == TAKES_NOTHING && p->tok.kind == TOK_ASSIGN && !p->tok.first) {
        parser_fail(p, DIAG_option_value, parser_token_span(p), o->name->text, expected_value[takes], parser_describe_found(p));
        return;
    }
    if (p->tok.kind == TOK_ASSIGN || p->tok.kind == TOK_COLON) {
        Diag *d = parser_report(p, DIAG_option_sign, parser_token_span(p), parser_text(p, parser_token_span(p)));
        diag_edit(p->diags, d, parser_token_span(p), "");
        parser_advance(p);
    }
    if (takes == TAKES_NOTHING || parse_option_argument(p, o, takes))
        return;
    if (p->tok.kind == TOK_ERROR)
        p->failed = true;
    parser_fail(p, DIAG_option_value, parser_missing_span(p), o->name->text, expected_value[takes], parser_describe_found(p));
}

// Reports an option that belongs to a file of another kind.
static void report_wrong_file(Parser *p, const AstOption *o, const bool in[FILE_KINDS])
{
    static const struct { const char *what, *ending; } files[] = {
        [FILE_SV] = {"state vector", "sv"}, [FILE_SM] = {"state machine", "sm"}, [FILE_SS] = {"state script", "ss"}};
    FileKind owner = FILE_SV;

    while (!in[owner])
        owner++;
    parser_report(p, DIAG_option_wrong_file, o->name_span, o->name->text, files[owner].what, files[owner].ending);
}

static void parse_option(Parser *p, AstSection *s)
{
    AstOption o = {0};
    size_t i = 0;

    o.name = p->tok.text;
    o.name_span = parser_token_span(p);
    while (i < OPTION_COUNT && strcmp(option_words[i], o.name->text) != 0)
        i++;
    if (i == OPTION_COUNT) {
        const char *synonym = hint_find_synonym(HINT_OPTIONS, o.name->text);
        const char *near = synonym ? synonym : str_nearest(o.name->text, option_words, OPTION_COUNT);
        if (near)
            diag_label(p->diags, parser_fail(p, DIAG_option_unknown, o.name_span, o.name->text), DIAG_label_did_you_mean, near);
        else
            hint_explain(p, HINT_AT_OPTION, NULL);
        parser_advance(p);
        return;
    }
    if (!options[i].in[p->kind])
        report_wrong_file(p, &o, options[i].in);
    parser_advance(p);
    parse_option_value(p, &o, options[i].takes);
    if (!p->failed)
        vec_push(p->arena, &s->options, o);
}

void parse_options(Parser *p, AstSection *s)
{
    while (p->tok.kind != TOK_HEADER && p->tok.kind != TOK_END) {
        p->failed = false;
        if (parser_at_include(p)) {
            parser_report_late_include(p);
        } else if (p->tok.kind == TOK_NAME) {
            parse_option(p, s);
        } else {
            if (p->tok.kind == TOK_ERROR)
                p->failed = true;
            parser_fail(p, DIAG_expected_option, parser_token_span(p), parser_describe(p, &p->tok));
            parser_advance(p);
        }
        if (p->failed)
            parser_skip_line(p);
    }
    p->failed = false;
}
