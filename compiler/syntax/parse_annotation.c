// SPDX-License-Identifier: Apache-2.0
// Annotations: @read_only and others, after declarations, the headers of states, and pins. annotations.def defines where each is allowed
// and what it takes. The checker handles their effects.
#include "compiler/syntax/hints.h"
#include "compiler/syntax/parser.h"

typedef enum Arguments { TAKES_NOTHING, TAKES_NAME, TAKES_NAMES, TAKES_NUMBER, TAKES_NUMBERS, TAKES_VALUE, TAKES_UNIT, TAKES_FINDING } Arguments;

#define ON(target) (1u << AST_ON_##target)
// Sets of the targets that each kind of file has. In a file that has none of its targets, an annotation is reported as unknown.
#define ON_MACHINES (ON(ELEMENT) | ON(SV_ELEMENT) | ON(LOCAL) | ON(STATE) | ON(ALL_STATES) | ON(DEFINITION))
#define ON_DATA ON(DATA)
#define ON_PINS (ON(ANALOG_INPUT) | ON(ANALOG_OUTPUT) | ON(DIGITAL_INPUT) | ON(DIGITAL_OUTPUT))

static const struct { const char *spelling; Arguments takes; unsigned where; } rows[] = {
#define ANNOTATION(name, spelling, takes, where) {spelling, TAKES_##takes, where},
#include "compiler/syntax/annotations.def"
#undef ANNOTATION
};

// The declaration, header or pin that the current annotations follow.
typedef struct Annotated {
    AstAnnotationTarget target;
    Str name;
    Span span;                // position of the name of the annotated declaration, state or element
    AstAnnotations *all;      // the annotations parsed so far
} Annotated;

// ---- the row of an annotation ----

static bool may_follow_target(int row, AstAnnotationTarget target) { return rows[row].where >> target & 1u; }

// Returns the row of the annotation `word` for this target, else a row for another target in the same kind of file; AST_ANNOTATION_COUNT: no
// such row exists.
static int find_annotation_row(Str word, AstAnnotationTarget target)
{
    const unsigned in_file = target == AST_ON_DATA ? ON_DATA : ON_PINS >> target & 1u ? ON_PINS : ON_MACHINES;
    int found = AST_ANNOTATION_COUNT;

    for (int i = AST_ANNOTATION_COUNT - 1; i >= 0; i--)
        if (strcmp(rows[i].spelling, word->text) == 0 && rows[i].where & in_file && (found == AST_ANNOTATION_COUNT || may_follow_target(i, target)))
            found = i;
    return found;
}

// Whether the annotation of this row can follow a state's header but not an element.
static bool is_for_states_only(int row)
{
    return row < AST_ANNOTATION_COUNT && may_follow_target(row, AST_ON_STATE) && !may_follow_target(row, AST_ON_ELEMENT);
}

// Reports an unknown annotation and skips its arguments.
static void report_unknown_annotation(Parser *p, AstAnnotationTarget target)
{
    Diag *d = parser_report(p, DIAG_annotation_unknown, parser_token_span(p), p->tok.text->text);
    const char *here[AST_ANNOTATION_COUNT];
    size_t n = 0;

    for (int i = 0; i < AST_ANNOTATION_COUNT; i++)
        if (may_follow_target(i, target))
            here[n++] = rows[i].spelling;
    parser_label_annotations(p, d, here, n);
    do
        parser_advance(p);
    while (!p->tok.first && p->tok.kind != TOK_ANNOTATION && p->tok.kind != TOK_TYPE && p->tok.kind != TOK_HEADER && p->tok.kind != TOK_LABEL);
}

// ---- where an annotation is allowed ----

static const char *get_pin_name(AstAnnotationTarget target)
{
    static const char *const name[] = {"an analog input", "an analog output", "a digital input", "a digital output"};

    return name[target - AST_ON_ANALOG_INPUT];
}

// Returns whether the annotation is allowed on its target, and reports it if not.
static bool check_annotation_target(Parser *p, const Annotated *o, const AstAnnotation *a)
{
    const char *word = rows[a->kind].spelling;

    if (may_follow_target((int)a->kind, o->target))
        return true;
    if (ON_PINS >> o->target & 1u) {
        Diag *d = parser_report(p, DIAG_annotation_on_pin, a->span, word, get_pin_name(o->target));
        const char *list = NULL;                  // the kinds of pins that the annotation is for
        for (AstAnnotationTarget k = AST_ON_ANALOG_INPUT; k <= AST_ON_DIGITAL_OUTPUT; k++)
            if (may_follow_target((int)a->kind, k))
                list = list ? format_in(p->arena, "%s or %s", list, get_pin_name(k)) : get_pin_name(k);
        diag_label(p->diags, d, DIAG_label_of_pins, list);
    } else if (a->kind == AST_EXCEPT || o->target == AST_ON_ALL_STATES)
        parser_report(p, DIAG_annotation_of_all_states, a->span, word, a->kind == AST_EXCEPT ? "only" : "not");
    else if (is_for_states_only((int)a->kind))
        diag_label(p->diags, parser_report(p, DIAG_annotation_of_states, a->span, word), DIAG_label_after_header, word);
    else if (o->target == AST_ON_STATE)
        parser_report(p, DIAG_annotation_on_state, a->span, word);
    else if (o->target == AST_ON_SV_ELEMENT)
        parser_report(p, DIAG_annotation_in_sv, a->span, word);
    else
        parser_report(p, DIAG_annotation_on_local, a->span, word,
                      a->kind == AST_ALLOW       ? "machines and state vectors"
                      : a->kind == AST_PARAMETER ? "locals of a machine"
                      : a->kind == AST_RANGE     ? "elements of the state vector and parameters"
                                                 : "elements of the state vector");
    return false;
}

// Returns false after reporting that the owner has this annotation already.
static bool check_not_repeated(Parser *p, const Annotated *o, const AstAnnotation *a)
{
    Diag *d;

    for (size_t i = 0; rows[a->kind].takes != TAKES_FINDING && i < o->all->n; i++)
        if (o->all->at[i].kind == a->kind && (a->kind != AST_REQ || o->all->at[i].name == a->name)) {
            d = parser_report(p, DIAG_annotation_repeated, a->span, rows[a->kind].spelling, o->name->text);
            diag_note(p->diags, d, o->all->at[i].span, DIAG_note_first_here);
            return false;
        }
    return true;
}

// ---- a name, numbers ----

static void parse_annotation_name(Parser *p, AstAnnotation *a)
{
    if (p->tok.kind == TOK_NAME) {
        a->name = p->tok.text;
        a->name_span = parser_token_span(p);
        if (a->kind == AST_ALIAS)
            str_declare(p->strings, a->name);
        parser_advance(p);
        return;
    }
    if (p->tok.kind == TOK_ERROR)
        p->failed = true;
    parser_fail(p, DIAG_annotation_without_name, parser_missing_span(p), rows[a->kind].spelling, parser_describe_found(p));
}

// Parses the text of a unit, as in @unit m/s^2. The checker reads it.
static void parse_unit(Parser *p, AstAnnotation *a)
{
    if (p->tok.kind == TOK_UNIT) {
        a->name = p->tok.text;
        a->name_span = parser_token_span(p);
        parser_advance(p);
        return;
    }
    if (p->tok.kind == TOK_ERROR)
        p->failed = true;
    parser_fail(p, DIAG_unit_missing, parser_missing_span(p), parser_describe_found(p));
}

// Parses the names after an annotation, on its line.
static void parse_annotation_names(Parser *p, AstAnnotation *a)
{
    if (p->tok.kind != TOK_NAME || p->tok.first) {
        if (p->tok.kind == TOK_ERROR)
            p->failed = true;
        parser_fail(p, DIAG_annotation_without_name, parser_missing_span(p), rows[a->kind].spelling, parser_describe_found(p));
        return;
    }
    a->names = ARENA_NEW(p->arena, AstNames);
    for (; p->tok.kind == TOK_NAME && !p->tok.first; parser_advance(p)) {
        vec_push(p->arena, &a->names->at, p->tok.text);
        vec_push(p->arena, &a->names->span, parser_token_span(p));
        if (p->ahead.kind == TOK_COMMA && !p->ahead.first) {
            parser_advance(p);
            diag_edit(p->diags, parser_report(p, DIAG_names_comma, parser_token_span(p), rows[a->kind].spelling), parser_token_span(p), "");
        }
    }
}

// Parses a number with or without a sign; false: there is none.
bool parse_signed_number(Parser *p, AstNumber *into)
{
    uint32_t at = p->tok.at;
    bool minus = p->tok.kind == TOK_MINUS;

    if (minus || p->tok.kind == TOK_PLUS)
        parser_advance(p);
    if (p->tok.kind == TOK_ERROR)
        p->failed = true;
    if (p->tok.kind != TOK_NUMBER)
        return false;
    into->value = minus ? sm_neg(p->tok.number) : p->tok.number;
    parser_advance(p);
    into->span = parser_span_since(p, at);
    return true;
}

// Reads a number at `at`, without an exponent. Returns its end; `at` if something else is there.
static uint32_t skip_plain_number(const char *text, uint32_t at)
{
    uint32_t end = at + (text[at] == '-' || text[at] == '+');

    if (!lex_is_digit(text[end]))
        return at;
    while (lex_is_digit(text[end]) || (text[end] == '.' && lex_is_digit(text[end + 1])))
        end++;
    return lex_is_letter(text[end]) ? at : end;
}

// If two numbers with other signs between them follow @range, which ends at `at`, labels d with the range in the right
// form, as in @range 0 5, and proposes it as an edit; else labels d with the form in general.
static void label_range(Parser *p, Diag *d, uint32_t at)
{
    const char *text = p->lex.src->text;
    const uint32_t from = at + (uint32_t)strspn(text + at, " \t[("), middle = skip_plain_number(text, from);
    const uint32_t second = middle + (uint32_t)strspn(text + middle, " \t,;:.~"), end = skip_plain_number(text, second);
    const bool is_doubtful = (text[middle] == ',' && text[middle + 1] != ' ') || text[end] == ',' || text[end] == ';';        // 0,5 can mean 0.5
    const char *range;

    if (middle == from || end == second || second == middle || is_doubtful) {
        diag_label(p->diags, d, DIAG_label_range_form);
        return;
    }
    range = format_in(p->arena, "%.*s %.*s", (int)(middle - from), text + from, (int)(end - second), text + second);
    diag_label(p->diags, d, DIAG_label_write, format_in(p->arena, "@range %s", range));
    diag_edit(p->diags, d, (Span){p->lex.src, from, end + (uint32_t)strspn(text + end, "])") - from}, range);
}

// Parses the lower or upper bound (`which`) of a @range, whose word ends at `at`.
static void parse_bound(Parser *p, AstNumber *into, const char *which, uint32_t at)
{
    Diag *d;
    bool is_unit;

    if (parse_signed_number(p, into))
        return;
    is_unit = p->tok.kind == TOK_NAME && hint_is_time_unit(p->tok.text->text);
    d = parser_fail(p, DIAG_range_value, parser_missing_span(p), which, parser_describe_found(p));
    if (is_unit)
        diag_label(p->diags, d, DIAG_label_range_of_times);
    else
        label_range(p, d, at);
}

// Parses the argument of an annotation that takes a NUMBER, or a VALUE (`accepts_truth`): also true or false.
static void parse_annotation_value(Parser *p, AstAnnotation *a, bool accepts_truth)
{
    if (accepts_truth && (p->tok.kind == TOK_TRUE || p->tok.kind == TOK_FALSE)) {
        a->is_truth = true;
        a->lo.value = sm_from_i32(p->tok.kind == TOK_TRUE);
        a->lo.span = parser_token_span(p);
        parser_advance(p);
    } else if (!parse_signed_number(p, &a->lo)) {
        parser_fail(p, DIAG_annotation_without_number, parser_missing_span(p), rows[a->kind].spelling, parser_describe_found(p));
    }
}

// ---- @allow(name, "reason") ----

static void report_allow_syntax(Parser *p, const char *expected)
{
    if (p->tok.kind == TOK_ERROR)
        p->failed = true;
    diag_label(p->diags, parser_fail(p, DIAG_allow_form, parser_missing_span(p), expected, parser_describe_found(p)), DIAG_label_allow_form);
}

// Consumes the next token of an @allow if it is of this kind. Otherwise reports what was expected, and returns false.
static bool expect_token(Parser *p, TokenKind kind, const char *expected)
{
    if (p->tok.kind != kind) {
        report_allow_syntax(p, expected);
        return false;
    }
    parser_advance(p);
    return true;
}

// Reports a name in @allow that is not the name of a warning. For a code such as W0408, proposes the name of that warning.
static void report_unknown_flag(Parser *p, const AstAnnotation *a)
{
    const char *word = a->name->text, *near, **names = ARENA_ARRAY(p->arena, const char *, diag_flag_count);
    const DiagInfo *code = diag_find(word);
    Diag *d = parser_report(p, DIAG_allow_unknown, a->name_span, word);

    for (size_t i = 0; i < diag_flag_count; i++)
        names[i] = diag_flag[i].name;
    near = code ? code->flag : str_nearest(word, names, diag_flag_count);
    if (near) {
        diag_label(p->diags, d, DIAG_label_did_you_mean, near);
        if (code)
            diag_edit(p->diags, d, a->name_span, near);
    } else if (code)
        diag_label(p->diags, d, DIAG_label_error_stays);
}

// Whether t can be part of a warning's name: words with dashes between them. Some of the words, such as `if`, are reserved.
static bool is_part_of_flag(const Token *t)
{
    return t->kind == TOK_MINUS || (t->text && t->kind != TOK_TEXT && t->kind != TOK_HEADER && t->kind != TOK_LABEL &&
                                    t->kind != TOK_ANNOTATION);
}

// Parses the name of a warning in an `allow` annotation.
static void parse_flag(Parser *p, AstAnnotation *a)
{
    uint32_t at = p->tok.at;

    if (!is_part_of_flag(&p->tok) || p->tok.kind == TOK_MINUS) {
        report_allow_syntax(p, "the name of a warning");
        return;
    }
    while (is_part_of_flag(&p->tok))
        parser_advance(p);
    a->name_span = parser_span_since(p, at);
    a->name = str_intern(p->strings, p->lex.src->text + at, a->name_span.len);
    if (!p->failed && !diag_find_flag(a->name->text))
        report_unknown_flag(p, a);
}

// Parses the quoted reason of an `allow` annotation; reports one that is missing or blank.
static void parse_reason(Parser *p, AstAnnotation *a)
{
    if (p->tok.kind == TOK_RPAREN || (p->tok.kind == TOK_TEXT && strspn(p->tok.text->text, " \t") == p->tok.text->len)) {
        diag_label(p->diags, parser_report(p, DIAG_allow_without_reason, parser_token_span(p)), DIAG_label_allow_form);
        a->reason = str_c(p->strings, "");
        if (p->tok.kind == TOK_TEXT)
            parser_advance(p);
        return;
    }
    a->reason = p->tok.text;
    expect_token(p, TOK_TEXT, "a reason between quotes");
}

// Parses the parentheses of an `allow` annotation: the name of a warning and the reason.
static void parse_finding(Parser *p, AstAnnotation *a)
{
    if (!expect_token(p, TOK_LPAREN, "'('"))
        return;
    parse_flag(p, a);
    if (!p->failed && p->tok.kind != TOK_RPAREN)
        expect_token(p, TOK_COMMA, "a comma");
    if (!p->failed)
        parse_reason(p, a);
    if (!p->failed)
        expect_token(p, TOK_RPAREN, "')'");
}

// ---- arguments ----

static void parse_annotation_arguments(Parser *p, AstAnnotation *a)
{
    const uint32_t end = p->last.at + p->last.len;

    switch (rows[a->kind].takes) {
    case TAKES_NOTHING: break;
    case TAKES_NAME:    parse_annotation_name(p, a); break;
    case TAKES_NAMES:   parse_annotation_names(p, a); break;
    case TAKES_NUMBER:  parse_annotation_value(p, a, false); break;
    case TAKES_NUMBERS:
        parse_bound(p, &a->lo, "lowest", end);
        if (a->lo.span.src)
            parse_bound(p, &a->hi, "highest", end);
        break;
    case TAKES_VALUE:   parse_annotation_value(p, a, true); break;
    case TAKES_UNIT:    parse_unit(p, a); break;
    case TAKES_FINDING: parse_finding(p, a); break;
    }
}

// Skips (name, "reason") of an @allow that is not allowed: parse_finding stops at the first error.
static void skip_allow_arguments(Parser *p)
{
    while (!p->tok.first && p->tok.kind != TOK_ANNOTATION && p->tok.kind != TOK_TYPE && p->tok.kind != TOK_HEADER)
        parser_advance(p);
}

// ---- all of them ----

static void parse_annotation(Parser *p, const Annotated *o)
{
    AstAnnotation a = {0};
    bool first = p->tok.first, allowed, begins_another;
    int row = find_annotation_row(p->tok.text, o->target);

    if (row == AST_ANNOTATION_COUNT) {
        report_unknown_annotation(p, o->target);
        return;
    }
    a.kind = (AstAnnotationKind)row;
    a.span = parser_token_span(p);
    allowed = check_annotation_target(p, o, &a);
    parser_advance(p);
    first = first && !p->tok.first;
    p->failed = !allowed;                     // if the annotation is not allowed, errors in its arguments are not reported
    if (!allowed && rows[row].takes == TAKES_FINDING)
        skip_allow_arguments(p);
    else
        parse_annotation_arguments(p, &a);
    p->failed = p->failed && allowed;
    a.span = parser_span_since(p, a.span.at);
    if (p->failed)
        return;
    begins_another = ON_PINS >> o->target & 1u ? p->tok.kind == TOK_NAME && p->ahead.kind == TOK_NUMBER : p->tok.kind == TOK_TYPE;
    if (first && !p->tok.first && begins_another)            // the annotation belongs to the declaration on the line above
        diag_note(p->diags, parser_report(p, DIAG_annotation_above, a.span, rows[a.kind].spelling, o->name->text),
                  o->span, DIAG_note_declared_here, o->name->text);
    if (check_not_repeated(p, o, &a) && allowed)
        vec_push(p->arena, o->all, a);
}

// Parses all annotations that follow; `owner` is the name of the annotated declaration, state or pin's element.
void parse_annotations(Parser *p, AstAnnotationTarget target, Str owner, Span owner_span, AstAnnotations *into)
{
    Annotated o = {target, owner, owner_span, into};

    while (!p->failed && p->tok.kind == TOK_ANNOTATION && !(target == AST_ON_DATA && p->tok.first))
        parse_annotation(p, &o);
}

// ---- where annotations are not allowed ----

void parser_report_annotation_before_decl(Parser *p)
{
    const char *word = p->tok.text->text;

    if (is_for_states_only(find_annotation_row(p->tok.text, AST_ON_ELEMENT)))
        diag_label(p->diags, parser_fail(p, DIAG_annotation_of_states, parser_token_span(p), word), DIAG_label_after_header, word);
    else
        parser_fail(p, DIAG_annotation_before, parser_token_span(p), word);
}

bool parser_is_allow(const Token *t)
{
    return t->kind == TOK_ANNOTATION && strcmp(t->text->text, rows[AST_ALLOW].spelling) == 0;
}

const AstAnnotation *parse_allow(Parser *p)
{
    AstAnnotation *a = ARENA_NEW(p->arena, AstAnnotation);
    Span span = parser_token_span(p);

    a->kind = AST_ALLOW;
    parser_advance(p);
    parse_finding(p, a);
    a->span = parser_span_since(p, span.at);
    return p->failed ? NULL : a;
}

void parser_report_annotation_in_block(Parser *p)
{
    static const char *const script_words[] = {"assert", "stop", "fail", "expect", "print"};
    const char *word = p->tok.text->text, *near = str_nearest(word, script_words, sizeof script_words / sizeof *script_words);
    Diag *d = parser_fail(p, DIAG_annotation_here, parser_token_span(p), word);

    if (is_for_states_only(find_annotation_row(p->tok.text, AST_ON_STATE)))
        diag_label(p->diags, d, DIAG_label_after_header, word);
    else if (parser_is_allow(&p->tok))
        diag_label(p->diags, d, DIAG_label_not_in_script);
    else if (near && p->kind == FILE_SS)
        diag_label(p->diags, d, DIAG_label_did_you_mean, format_in(p->arena, "@%s", near));
}
