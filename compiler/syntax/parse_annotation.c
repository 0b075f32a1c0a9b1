// SPDX-License-Identifier: Apache-2.0
// Annotations: @read_only and others, after declarations, the headers of states, and pins. annotations.def defines where each is allowed
// and what it takes. The checker handles their effects.
#include "compiler/syntax/parser.h"

typedef enum Arguments { TAKES_NOTHING, TAKES_NAME, TAKES_NUMBER, TAKES_NUMBERS, TAKES_VALUE, TAKES_FINDING } Arguments;

#define ON(place) (1u << AST_ON_##place)
#define ON_PINS (ON(ANALOG_INPUT) | ON(ANALOG_OUTPUT) | ON(DIGITAL_INPUT) | ON(DIGITAL_OUTPUT))

static const struct { const char *spelling; Arguments takes; unsigned where; } rows[] = {
#define ANNOTATION(name, spelling, takes, where) {spelling, TAKES_##takes, where},
#include "compiler/syntax/annotations.def"
#undef ANNOTATION
};

// The places of one sort of file. An annotation that is allowed at none of them is unknown in such a file.
static const unsigned families[] = {ON(ELEMENT) | ON(SV_ELEMENT) | ON(LOCAL) | ON(STATE), ON_PINS};

// The declaration, header or pin that the current annotations follow.
typedef struct Annotated {
    AstPlace place;
    Str name;
    Span span;                // of the name
    AstAnnotations *all;      // the annotations found so far
} Annotated;

// ---- the row of an annotation ----

static unsigned find_family(AstPlace place)
{
    for (size_t i = 0; i < sizeof families / sizeof *families; i++)
        if (families[i] >> place & 1u)
            return families[i];
    return 0;
}

static bool may_be_on(int row, AstPlace place) { return rows[row].where >> place & 1u; }

// Returns the row of that name for this place, else one for the same sort of file; AST_ANNOTATION_COUNT if there is none.
static int find_row(Str word, AstPlace place)
{
    int found = AST_ANNOTATION_COUNT;

    for (int i = AST_ANNOTATION_COUNT - 1; i >= 0; i--)
        if (strcmp(rows[i].spelling, word->text) == 0 && rows[i].where & find_family(place) &&
            (found == AST_ANNOTATION_COUNT || may_be_on(i, place)))
            found = i;
    return found;
}

static bool is_for_states_only(int row)
{
    return row < AST_ANNOTATION_COUNT && may_be_on(row, AST_ON_STATE) && !may_be_on(row, AST_ON_ELEMENT);
}

static size_t list_words(unsigned places, const char *words[AST_ANNOTATION_COUNT])
{
    size_t n = 0;

    for (int i = 0; i < AST_ANNOTATION_COUNT; i++)
        if (rows[i].where & places)
            words[n++] = rows[i].spelling;
    return n;
}

static bool ends_arguments(const Parser *p)
{
    return p->tok.first || p->tok.kind == TOK_ANNOTATION || p->tok.kind == TOK_TYPE || p->tok.kind == TOK_HEADER ||
           p->tok.kind == TOK_LABEL;
}

static void report_unknown_annotation(Parser *p, AstPlace place)
{
    Diag *d = parser_report(p, DIAG_annotation_unknown, parser_here(p), p->tok.text->text);
    const char *here[AST_ANNOTATION_COUNT];
    size_t n = list_words(1u << place, here);

    if (strncmp(p->tok.text->text, "unit", 4) == 0)
        diag_label(p->diags, d, DIAG_label_text, "a unit belongs in a comment");
    else
        parser_label_annotations(p, d, here, n);
    parser_next(p);
    while (!ends_arguments(p))
        parser_next(p);
}

// ---- whether it is allowed there ----

static const char *pin_name(AstPlace place)
{
    static const char *const name[] = {"an analog input", "an analog output", "a digital input", "a digital output"};

    return name[place - AST_ON_ANALOG_INPUT];
}

// Names the pins that the annotation is for.
static void report_annotation_of_other_pins(Parser *p, const Annotated *o, const AstAnnotation *a)
{
    Diag *d = parser_report(p, DIAG_annotation_on_pin, a->span, rows[a->kind].spelling, pin_name(o->place));
    const char *list = NULL;

    for (AstPlace k = AST_ON_ANALOG_INPUT; k <= AST_ON_DIGITAL_OUTPUT; k++)
        if (may_be_on((int)a->kind, k))
            list = list ? format_in(p->arena, "%s or %s", list, pin_name(k)) : pin_name(k);
    diag_label(p->diags, d, DIAG_label_of_pins, list);
}

// Returns false after a message.
static bool check_place(Parser *p, const Annotated *o, const AstAnnotation *a)
{
    const char *word = rows[a->kind].spelling;

    if (may_be_on((int)a->kind, o->place))
        return true;
    if (ON_PINS >> o->place & 1u)
        report_annotation_of_other_pins(p, o, a);
    else if (is_for_states_only((int)a->kind))
        diag_label(p->diags, parser_report(p, DIAG_annotation_of_states, a->span, word), DIAG_label_after_header, word);
    else if (o->place == AST_ON_STATE)
        parser_report(p, DIAG_annotation_on_state, a->span, word);
    else if (o->place == AST_ON_SV_ELEMENT)
        parser_report(p, DIAG_annotation_in_sv, a->span, word);
    else
        parser_report(p, DIAG_annotation_on_local, a->span, word);
    return false;
}

static bool is_first_of_its_kind(Parser *p, const Annotated *o, const AstAnnotation *a)
{
    Diag *d;

    for (size_t i = 0; rows[a->kind].takes != TAKES_FINDING && i < o->all->n; i++)
        if (o->all->at[i].kind == a->kind) {
            d = parser_report(p, DIAG_annotation_repeated, a->span, rows[a->kind].spelling, o->name->text);
            diag_note(p->diags, d, o->all->at[i].span, DIAG_note_first_here);
            return false;
        }
    return true;
}

// Line ends count as blanks. An annotation that looks as if it belonged to the declaration after it belongs to the one above.
static void report_annotation_above(Parser *p, const Annotated *o, const AstAnnotation *a)
{
    Diag *d = parser_report(p, DIAG_annotation_above, a->span, rows[a->kind].spelling, o->name->text);

    diag_note(p->diags, d, o->span, DIAG_note_declared_here, o->name->text);
}

// ---- a name, numbers ----

static void parse_annotation_name(Parser *p, AstAnnotation *a)
{
    if (p->tok.kind == TOK_NAME) {
        a->name = p->tok.text;
        a->name_span = parser_here(p);
        if (a->kind == AST_ALIAS)
            str_declare(p->strings, a->name);
        parser_next(p);
        return;
    }
    if (p->tok.kind == TOK_ERROR)
        p->failed = true;
    parser_fail(p, DIAG_annotation_without_name, parser_where_missing(p), rows[a->kind].spelling, parser_found(p));
}

bool parse_signed_number(Parser *p, AstNumber *into)
{
    uint32_t at = p->tok.at;
    bool minus = p->tok.kind == TOK_MINUS;

    if (minus || p->tok.kind == TOK_PLUS)
        parser_next(p);
    if (p->tok.kind == TOK_ERROR)
        p->failed = true;
    if (p->tok.kind != TOK_NUMBER)
        return false;
    into->value = minus ? sm_neg(p->tok.number) : p->tok.number;
    parser_next(p);
    into->span = parser_since(p, at);
    return true;
}

static void parse_bound(Parser *p, AstNumber *into, const char *which)
{
    Diag *d;

    if (parse_signed_number(p, into))
        return;
    d = parser_fail(p, DIAG_range_value, parser_where_missing(p), which, parser_found(p));
    diag_label(p->diags, d, DIAG_label_range_form);
}

// Parses one number; for a VALUE also true or false.
static void parse_annotation_value(Parser *p, AstAnnotation *a, bool truth)
{
    if (truth && (p->tok.kind == TOK_TRUE || p->tok.kind == TOK_FALSE)) {
        a->is_truth = true;
        a->lo.value = sm_from_i32(p->tok.kind == TOK_TRUE);
        a->lo.span = parser_here(p);
        parser_next(p);
    } else if (!parse_signed_number(p, &a->lo)) {
        parser_fail(p, DIAG_annotation_without_number, parser_where_missing(p), rows[a->kind].spelling, parser_found(p));
    }
}

// ---- @allow(name, "reason") ----

static void report_allow_form(Parser *p, const char *expected)
{
    if (p->tok.kind == TOK_ERROR)
        p->failed = true;
    diag_label(p->diags, parser_fail(p, DIAG_allow_form, parser_where_missing(p), expected, parser_found(p)), DIAG_label_allow_form);
}

static bool expect_sign(Parser *p, TokenKind kind, const char *expected)
{
    if (p->tok.kind != kind) {
        report_allow_form(p, expected);
        return false;
    }
    parser_next(p);
    return true;
}

static const char *nearest_flag(Parser *p, const char *word)
{
    const char **names = ARENA_ARRAY(p->arena, const char *, diag_flag_count);
    const DiagInfo *code = diag_find(word);

    if (code)
        return code->flag;
    for (size_t i = 0; i < diag_flag_count; i++)
        names[i] = diag_flag[i].name;
    return str_nearest(word, names, diag_flag_count);
}

static void report_unknown_flag(Parser *p, const AstAnnotation *a)
{
    const char *near = nearest_flag(p, a->name->text);
    const DiagInfo *code = diag_find(a->name->text);
    Diag *d = parser_report(p, DIAG_allow_unknown, a->name_span, a->name->text);

    if (near) {
        diag_label(p->diags, d, DIAG_label_did_you_mean, near);
        if (code)
            diag_edit(p->diags, d, a->name_span, near);
    } else if (code)
        diag_label(p->diags, d, DIAG_label_error_stays);
}

// A warning's name consists of words with dashes between them; some of the words are words of the language.
static bool is_part_of_flag(const Token *t)
{
    return t->kind == TOK_MINUS || (t->text && t->kind != TOK_TEXT && t->kind != TOK_HEADER && t->kind != TOK_LABEL &&
                                    t->kind != TOK_ANNOTATION);
}

static void parse_flag(Parser *p, AstAnnotation *a)
{
    uint32_t at = p->tok.at;

    if (!is_part_of_flag(&p->tok) || p->tok.kind == TOK_MINUS) {
        report_allow_form(p, "the name of a warning");
        return;
    }
    while (is_part_of_flag(&p->tok))
        parser_next(p);
    a->name_span = parser_since(p, at);
    a->name = str_intern(p->strings, p->lex.src->text + at, a->name_span.len);
    if (!p->failed && !diag_find_flag(a->name->text))
        report_unknown_flag(p, a);
}

static void parse_reason(Parser *p, AstAnnotation *a)
{
    if (p->tok.kind == TOK_RPAREN || (p->tok.kind == TOK_TEXT && strspn(p->tok.text->text, " \t") == p->tok.text->len)) {
        diag_label(p->diags, parser_report(p, DIAG_allow_without_reason, parser_here(p)), DIAG_label_allow_form);
        a->reason = str_c(p->strings, "");
        if (p->tok.kind == TOK_TEXT)
            parser_next(p);
        return;
    }
    a->reason = p->tok.text;
    expect_sign(p, TOK_TEXT, "a reason between quotes");
}

static void parse_finding(Parser *p, AstAnnotation *a)
{
    if (!expect_sign(p, TOK_LPAREN, "'('"))
        return;
    parse_flag(p, a);
    if (!p->failed && p->tok.kind != TOK_RPAREN)
        expect_sign(p, TOK_COMMA, "a comma");
    if (!p->failed)
        parse_reason(p, a);
    if (!p->failed)
        expect_sign(p, TOK_RPAREN, "')'");
}

// ---- arguments ----

static void parse_annotation_arguments(Parser *p, AstAnnotation *a)
{
    switch (rows[a->kind].takes) {
    case TAKES_NOTHING: break;
    case TAKES_NAME:    parse_annotation_name(p, a); break;
    case TAKES_NUMBER:  parse_annotation_value(p, a, false); break;
    case TAKES_NUMBERS:
        parse_bound(p, &a->lo, "lowest");
        if (a->lo.span.src)
            parse_bound(p, &a->hi, "highest");
        break;
    case TAKES_VALUE:   parse_annotation_value(p, a, true); break;
    case TAKES_FINDING: parse_finding(p, a); break;
    }
}

// ---- all of them ----

// Whether the next token begins a declaration of the owner's kind.
static bool begins_another(const Parser *p, AstPlace place)
{
    if (ON_PINS >> place & 1u)
        return p->tok.kind == TOK_NAME && p->ahead.kind == TOK_NUMBER;
    return p->tok.kind == TOK_TYPE;
}

static void parse_annotation(Parser *p, const Annotated *o)
{
    AstAnnotation a = {0};
    bool first = p->tok.first, allowed;
    int row = find_row(p->tok.text, o->place);

    if (row == AST_ANNOTATION_COUNT) {
        report_unknown_annotation(p, o->place);
        return;
    }
    a.kind = (AstAnnotationKind)row;
    a.span = parser_here(p);
    allowed = check_place(p, o, &a);
    parser_next(p);
    first = first && !p->tok.first;
    p->failed = !allowed;                     // then whether its arguments are correct is irrelevant
    parse_annotation_arguments(p, &a);
    p->failed = p->failed && allowed;
    a.span = parser_since(p, a.span.at);
    if (p->failed)
        return;
    if (first && !p->tok.first && begins_another(p, o->place))
        report_annotation_above(p, o, &a);
    if (is_first_of_its_kind(p, o, &a) && allowed)
        vec_push(p->arena, o->all, a);
}

void parse_annotations(Parser *p, AstPlace place, Str owner, Span owner_span, AstAnnotations *into)
{
    Annotated o = {place, owner, owner_span, into};

    while (!p->failed && p->tok.kind == TOK_ANNOTATION)
        parse_annotation(p, &o);
}

// ---- where annotations are not allowed ----

void parser_report_annotation_before_decl(Parser *p)
{
    const char *word = p->tok.text->text;

    if (is_for_states_only(find_row(p->tok.text, AST_ON_ELEMENT)))
        diag_label(p->diags, parser_fail(p, DIAG_annotation_of_states, parser_here(p), word), DIAG_label_after_header, word);
    else
        parser_fail(p, DIAG_annotation_before, parser_here(p), word);
}

bool parser_is_allow(const Token *t)
{
    return t->kind == TOK_ANNOTATION && strcmp(t->text->text, rows[AST_ALLOW].spelling) == 0;
}

const AstAnnotation *parse_allow(Parser *p)
{
    AstAnnotation *a = ARENA_NEW(p->arena, AstAnnotation);
    Span span = parser_here(p);

    a->kind = AST_ALLOW;
    parser_next(p);
    parse_finding(p, a);
    a->span = parser_since(p, span.at);
    return p->failed ? NULL : a;
}

void parser_report_annotation_in_block(Parser *p)
{
    static const char *const script_words[] = {"assert", "stop"};
    const char *word = p->tok.text->text, *near = str_nearest(word, script_words, 2);
    Diag *d = parser_fail(p, DIAG_annotation_here, parser_here(p), word);

    if (is_for_states_only(find_row(p->tok.text, AST_ON_STATE)))
        diag_label(p->diags, d, DIAG_label_after_header, word);
    else if (parser_is_allow(&p->tok))
        diag_label(p->diags, d, DIAG_label_not_in_script);
    else if (near && p->kind == FILE_SS)
        diag_label(p->diags, d, DIAG_label_did_you_mean, format_in(p->arena, "@%s", near));
}
