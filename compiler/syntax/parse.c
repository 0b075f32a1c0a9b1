// SPDX-License-Identifier: Apache-2.0
// Parses a file: its sections, and the labels and blocks of a state.
#include "compiler/syntax/ast_app.h"
#include "compiler/syntax/ast_net.h"
#include "compiler/syntax/ast_rq.h"
#include "compiler/syntax/hints.h"
#include "compiler/syntax/lexer.h"
#include "compiler/syntax/parser.h"
#include "compiler/syntax/parser_app.h"

// ---- tokens ----

void parser_advance(Parser *p)
{
    p->last = p->tok;
    p->tok = p->ahead;
    if (!p->stopped)
        lex_next(&p->lex, &p->ahead);
}

// Ends parsing: every further token is TOK_END, and nothing is reported.
void parser_stop(Parser *p)
{
    Token end = {TOK_END, true, p->tok.at, 0, NULL, SM_TYPE_COUNT, 0};

    p->stopped = true;
    p->tok = p->ahead = end;
}

Span parser_span(const Parser *p, const Token *t) { return (Span){p->lex.src, t->at, t->len}; }
Span parser_token_span(const Parser *p) { return parser_span(p, &p->tok); }

// Returns the empty position directly after the last token.
Span parser_gap_span(const Parser *p) { return (Span){p->lex.src, p->last.at + p->last.len, 0}; }

// Returns the position of the next token, or the end of the line before it.
Span parser_missing_span(const Parser *p) { return p->tok.first ? parser_gap_span(p) : parser_token_span(p); }

// Returns the range from `at` to the end of the last token.
Span parser_span_since(const Parser *p, uint32_t at)
{
    uint32_t end = p->last.at + p->last.len;

    return (Span){p->lex.src, at, end > at ? end - at : 0};
}

// Whether the next token is }, a label, a header or the end.
bool parser_at_end_of_block(const Parser *p)
{
    TokenKind k = p->tok.kind;

    return k == TOK_RBRACE || k == TOK_LABEL || k == TOK_HEADER || k == TOK_END;
}

// Whether the next token begins a line or ends the block, or the last one is }.
bool parser_at_end_of_statement(const Parser *p)
{
    return p->tok.first || parser_at_end_of_block(p) || p->last.kind == TOK_RBRACE;
}

// Whether the next tokens are `include` and a text.  Only in a script is there a text after this word.
bool parser_at_include(const Parser *p)
{
    return p->tok.kind == TOK_NAME && p->ahead.kind == TOK_TEXT && !p->ahead.first && strcmp(p->tok.text->text, "include") == 0;
}

void parser_report_late_include(Parser *p)
{
    parser_fail(p, DIAG_include_late, parser_token_span(p));
    parser_advance(p);
}

void parser_skip_line(Parser *p)
{
    while (!p->tok.first && p->tok.kind != TOK_HEADER && p->tok.kind != TOK_END)
        parser_advance(p);
}

// Skips to the next line that begins with a header, without reading tokens.
void parser_skip_section(Parser *p)
{
    const Source *src = p->lex.src;
    uint32_t line = source_position(src, p->tok.at).line;

    if (p->tok.kind == TOK_HEADER || p->tok.kind == TOK_END)
        return;
    for (; line < src->lines; line++) {                              // find the next line that begins with a bracket
        uint32_t len;
        const char *s = source_line(src, line + 1, &len);
        while (len && (*s == ' ' || *s == '\t'))
            s++, len--;
        if (len && *s == '[')
            break;
    }
    lex_skip_to(&p->lex, line < src->lines ? src->line[line] : src->len);
    lex_next(&p->lex, &p->tok);
    lex_next(&p->lex, &p->ahead);
}

// ---- diagnostics ----

static Diag *report_unless_failed(Parser *p, DiagCode code, Span span, va_list args)
{
    bool muted = p->diags->muted;
    Diag *d;

    p->diags->muted = muted || p->failed || p->stopped;
    d = diag_report_list(p->diags, code, span, args);
    p->diags->muted = muted;
    return d;
}

// Like diag_report, but does nothing while p->failed is set.
Diag *parser_report(Parser *p, DiagCode code, Span span, ...)
{
    va_list args;
    Diag *d;

    va_start(args, span);
    d = report_unless_failed(p, code, span, args);
    va_end(args);
    return d;
}

// Reports like parser_report, and sets p->failed.
Diag *parser_fail(Parser *p, DiagCode code, Span span, ...)
{
    va_list args;
    Diag *d;

    va_start(args, span);
    d = report_unless_failed(p, code, span, args);
    va_end(args);
    if (!p->failed && span.src == p->lex.src && span.at >= p->lex.line_start)
        lexer_mark_line_reported(&p->lex);                // quoted text later in a wrong statement is no second mistake
    p->failed = true;
    return d;
}

const char *parser_text_of_line(const Parser *p, uint32_t at)
{
    const char *text = p->lex.src->text;
    uint32_t end = at + (uint32_t)strcspn(text + at, "#\r\n");

    while (end > at && (text[end - 1] == ' ' || text[end - 1] == '\t'))
        end--;
    return parser_text(p, (Span){p->lex.src, at, end - at});
}

// Returns the source text, cut to a readable length.
const char *parser_text(const Parser *p, Span span)
{
    enum { MOST = 60 };
    const char *s = p->lex.src->text + span.at;
    uint32_t len = 0;

    while (len < span.len && len < MOST && s[len] != '\n' && s[len] != '\r')
        len++;
    return format_in(p->arena, "%.*s%s", (int)len, s, len < span.len ? "..." : "");
}

// Describes a token for a diagnostic: "'>='", "the end of the line", "the section [Idle]".
const char *parser_describe(const Parser *p, const Token *t)
{
    const char *text = parser_text(p, parser_span(p, t));

    switch ((int)t->kind) {
    case TOK_END:    return "the end of the file";
    case TOK_HEADER: return format_in(p->arena, "the section %s", text);
    case TOK_LABEL:  return format_in(p->arena, "the label '%s'", text);
    case TOK_NUMBER: return format_in(p->arena, "the number %s", text);
    case TOK_TYPE:   return format_in(p->arena, "the type '%s'", text);
    default:         return format_in(p->arena, "'%s'", text);
    }
}

// Describes the next token, or the end of the line before it, for a diagnostic.
const char *parser_describe_found(const Parser *p)
{
    return p->tok.first && p->tok.kind != TOK_END ? "the end of the line" : parser_describe(p, &p->tok);
}

// Labels d, which reports that the current annotation is unknown, with the most similar of the n annotations in `here`, which are allowed at
// this position.
void parser_label_annotations(Parser *p, Diag *d, const char *const *here, size_t n)
{
    const char *word = p->tok.text->text, *near = str_nearest(word, here, n), *list = "";

    for (size_t i = 0; i < n; i++)
        list = format_in(p->arena, "%s%s@%s", list, i == 0 ? "" : i + 1 < n ? ", " : " and ", here[i]);
    if (near)
        diag_label(p->diags, d, DIAG_label_did_you_mean, format_in(p->arena, "@%s", near));
    else
        diag_label(p->diags, d, DIAG_label_allowed_here, list);
}

// ---- a state ----

static const char *const labels[AST_LABEL_COUNT] = {"entry", "step", "exit"};

// Returns the AstLabel of the word; -1 if it is no label.
static int find_label(const char *word)
{
    for (int i = 0; i < AST_LABEL_COUNT; i++)
        if (strcmp(word, labels[i]) == 0)
            return i;
    return -1;
}

// Returns the block that the current label begins; NULL after reporting a repeated label. Reports an unknown label, and returns the block
// that the user probably meant; NULL if no block has a similar name or the state already has that block.
static AstBlock *open_block(Parser *p, AstSection *s)
{
    const char *word = p->tok.text->text;
    int i = find_label(word);
    const bool known = i >= 0;

    if (!known) {
        const char *synonym = hint_find_synonym(HINT_LABELS, word), *meant = synonym ? synonym : str_nearest(word, labels, AST_LABEL_COUNT);
        Diag *d = parser_report(p, DIAG_label_unknown, parser_token_span(p), word);
        if (!meant)
            return NULL;
        diag_label(p->diags, d, DIAG_label_did_you_mean, format_in(p->arena, ".%s", meant));
        i = find_label(meant);
    }
    if (s->block[i].present) {
        if (known) {
            Diag *d = parser_report(p, DIAG_label_repeated, parser_token_span(p), labels[i], s->name->text);
            diag_note(p->diags, d, s->block[i].label, DIAG_note_first_here);
        }
        return NULL;
    }
    s->block[i].present = true;
    s->block[i].label = parser_token_span(p);
    return &s->block[i];
}

static void parse_labelled(Parser *p, AstSection *s)
{
    AstStmts ignored = {0};
    AstBlock *b;

    p->failed = false;
    b = open_block(p, s);
    parser_advance(p);
    if (p->tok.kind == TOK_COLON && !p->tok.first) {
        Diag *d = parser_report(p, DIAG_label_colon, parser_token_span(p), parser_text(p, parser_span(p, &p->last)));
        diag_label(p->diags, d, DIAG_label_leave_out);
        diag_edit(p->diags, d, parser_token_span(p), "");
        parser_advance(p);
    }
    parse_block(p, b ? &b->stmts : &ignored);
}

// Parses statements or other text between a header and the first label, where none is allowed. Reports this misplaced text only if no
// error inside it has been reported.
static void parse_unlabelled(Parser *p, AstSection *s)
{
    AstStmts ignored = {0};
    size_t errors = p->diags->errors;
    bool reported = p->tok.kind == TOK_ERROR;
    const bool assigns = p->tok.kind == TOK_NAME && p->ahead.kind == TOK_ASSIGN, colon = p->tok.kind == TOK_COLON;
    Span here = parser_token_span(p);
    Diag *d = NULL;

    p->failed = false;
    if (p->tok.first)
        parse_block(p, &ignored);
    else
        parser_skip_line(p);
    if (p->diags->errors == errors && !reported && lex_is_header_name(s->name->text, s->name->len))        // an invalid header is reported instead
        d = parser_report(p, DIAG_code_before_label, here, s->name->text);
    if (d)
        d->follows = p->is_foreign_header;
    parse_block(p, &ignored);
    if (d && colon)
        diag_label(p->diags, d, DIAG_label_leave_out);
    else if (d && p->tok.kind == TOK_LABEL)
        diag_label(p->diags, d, DIAG_label_after_label);
    else if (d && assigns)
        diag_label(p->diags, d, DIAG_label_constants);
}

// Whether the name of a section is in brackets. That of `state Hold {`, which is reported, is not.
static bool is_in_brackets(Span name)
{
    uint32_t at = name.at;

    while (at > 0 && (name.src->text[at - 1] == ' ' || name.src->text[at - 1] == '\t'))
        at--;
    return at > 0 && name.src->text[at - 1] == '[';
}

// Parses the annotations and blocks of a state, or of [all_states]. Annotations after the header can continue on further lines.
static void parse_state(Parser *p, AstSection *s)
{
    parse_annotations(p, s->kind == AST_STATE ? AST_ON_STATE : AST_ON_ALL_STATES, s->name, s->name_span, &s->annotations);
    if (p->failed)
        parser_skip_line(p);
    p->failed = false;
    p->is_foreign_header = !is_in_brackets(s->name_span);
    if (!parser_at_end_of_block(p) || p->tok.kind == TOK_RBRACE)
        parse_unlabelled(p, s);
    while (p->tok.kind == TOK_LABEL)
        parse_labelled(p, s);
}

// Passes the parsed items to the visitor, and frees them.
void parser_visit_items(Parser *p)
{
    for (size_t i = 0; i < p->visited->n; i++)
        p->visitor->item(p->visitor->context, p->visited->at[i]);
    *p->visited = (AstStmts){0};
    arena_free(p->visitor->items);
}

static void parse_script_items(Parser *p, AstSection *s)
{
    p->reported_unguarded = false;
    parse_block(p, &s->items);
    while (p->tok.kind == TOK_LABEL) {
        parser_report(p, DIAG_label_in_script, parser_token_span(p));
        parser_advance(p);
        parse_block(p, &s->items);
    }
}

static void parse_script_section(Parser *p, AstSection *s)
{
    Arena *arena = p->arena;

    if (!p->visitor) {
        parse_script_items(p, s);
        return;
    }
    p->visitor->section(p->visitor->context, s);
    p->arena = p->visitor->items;
    p->visited = &s->items;
    parse_script_items(p, s);
    parser_visit_items(p);
    p->visited = NULL;
    p->arena = arena;
}

// ---- sections ----

static bool is_section_named(const AstSection *s, const char *name) { return strcmp(s->name->text, name) == 0; }

static AstSectionKind find_section_kind(FileKind file, const AstSection *s)
{
    switch (file) {
    case FILE_SV: return is_section_named(s, "options") ? AST_OPTIONS : AST_REGION;
    case FILE_SM:
        if (is_section_named(s, "state_vector") || is_section_named(s, "local"))
            return is_section_named(s, "local") ? AST_LOCAL : AST_STATE_VECTOR;
        if (is_section_named(s, "options"))
            return AST_OPTIONS;
        return is_section_named(s, "all_states") ? AST_ALL_STATES : AST_STATE;
    case FILE_IO: return is_section_named(s, "analog") || is_section_named(s, "digital") ? AST_PINS : AST_IGNORED;
    case FILE_SS: case FILE_APP: case FILE_NET: case FILE_RQ: case FILE_KINDS: break;
    }
    if (is_section_named(s, "options"))
        return AST_OPTIONS;
    if (is_section_named(s, "local"))
        return AST_LOCAL;
    return is_section_named(s, "state_vector") ? AST_IGNORED : AST_SCRIPT_STATE;
}

// Reports section s if f already contains a section of this kind and a file can have only one.
static void check_repeated(Parser *p, const AstFile *f, const AstSection *s)
{
    const bool is_single = s->kind == AST_STATE_VECTOR || s->kind == AST_PINS ||
        ((s->kind == AST_LOCAL || s->kind == AST_OPTIONS) && f->kind != FILE_SS);

    if (!is_single)
        return;
    for (size_t i = 0; i < f->sections.n; i++)
        if (f->sections.at[i]->kind == s->kind && f->sections.at[i]->digital == s->digital) {
            Diag *d = parser_report(p, DIAG_section_repeated, s->header, s->name->text);
            diag_note(p->diags, d, f->sections.at[i]->header, DIAG_note_first_here);
            return;
        }
}

// ---- misnamed sections ----

// Decides whether [define] contains definitions (language.md 5.61). If it does not begin with one in a script, or is empty or begins with a
// label or an annotation in a machine, it belongs to a state of that name.
static void find_define_kind(Parser *p, AstSection *s)
{
    const bool begins_definition = p->tok.kind == TOK_NAME && p->ahead.kind == TOK_ASSIGN;
    const bool is_state = p->tok.kind == TOK_LABEL || p->tok.kind == TOK_ANNOTATION || p->tok.kind == TOK_HEADER || p->tok.kind == TOK_END;

    if (is_section_named(s, "define") && ((s->kind == AST_STATE && !is_state) || (s->kind == AST_SCRIPT_STATE && begins_definition)))
        s->kind = AST_DEFINE;
}

// Decides whether [data] of a script contains recorded data (language.md 8.54). Otherwise it belongs to a state of that name.
static void find_data_kind(Parser *p, AstSection *s)
{
    if (s->kind == AST_SCRIPT_STATE && is_section_named(s, "data") && parser_at_data(p))
        s->kind = AST_DATA;
}

// Whether the line at the next token declares a variable with an initial value.
static bool at_local(const Parser *p)
{
    const char *line = p->lex.src->text + p->tok.at;                 // terminated by a NUL

    return p->tok.kind == TOK_TYPE && p->ahead.kind == TOK_NAME && line[strcspn(line, "=\n#")] == '=';
}

// Corrects the kind of a section whose first line shows that its name is misspelt, and reports the name. A "state" that begins with a
// declaration is [state_vector] or [local]; a section of a script that begins with an option is [options], or [local] with a declaration.
static void correct_section_kind(Parser *p, AstSection *s)
{
    static const char *const names[] = {[AST_STATE_VECTOR] = "state_vector", [AST_LOCAL] = "local", [AST_OPTIONS] = "options"};
    AstSectionKind kind = s->kind;
    Diag *d;

    if (kind == AST_STATE && p->tok.kind == TOK_TYPE && p->ahead.kind == TOK_NAME)
        kind = at_local(p) ? AST_LOCAL : AST_STATE_VECTOR;
    else if (kind == AST_SCRIPT_STATE && at_local(p))
        kind = AST_LOCAL;
    else if (kind == AST_SCRIPT_STATE && p->tok.kind == TOK_NAME && !p->ahead.first &&
             (p->ahead.kind == TOK_NUMBER || p->ahead.kind == TOK_NAME) &&
             (strcmp(p->tok.text->text, "delta_t") == 0 || strcmp(p->tok.text->text, "init_state") == 0))
        kind = AST_OPTIONS;
    if (kind == s->kind)
        return;
    s->kind = kind;
    if (!lex_is_header_name(s->name->text, s->name->len))             // the lexer has reported the header
        return;
    d = parser_report(p, DIAG_section_misspelt, s->header, s->name->text, kind == AST_OPTIONS ? "options" : "declarations");
    diag_label(p->diags, d, DIAG_label_did_you_mean, format_in(p->arena, "[%s]", names[kind]));
}

static void check_state_name(Parser *p, const AstSection *s)
{
    TokenKind reserved;

    if (!lex_is_header_name(s->name->text, s->name->len))             // reported by the lexer, or a state of a machine, as in [deploy.Idle]
        return;
    if (lex_find_reserved(s->name, &reserved))
        parser_report(p, DIAG_state_name_reserved, s->name_span, s->name->text);
    else if (!lex_is_identifier(s->name->text, s->name->len))
        parser_report(p, DIAG_state_name, s->name_span, s->name->text);
}

static AstSection *new_section(Parser *p, FileKind file)
{
    AstSection *s = ARENA_NEW(p->arena, AstSection);
    const Token *t = &p->tok;

    s->name = t->text;
    s->header = parser_token_span(p);
    s->name_span = (Span){p->lex.src, t->at + 1, t->len > 1 ? t->len - 1 : 0};
    if (t->len > 1 && p->lex.src->text[t->at + t->len - 1] == ']')
        s->name_span.len--;
    s->kind = find_section_kind(file, s);
    s->digital = s->kind == AST_PINS && is_section_named(s, "digital");
    s->all_states = file == FILE_SS && is_section_named(s, "all_states");
    return s;
}

static void parse_section(Parser *p, AstFile *f)
{
    AstSection *s = new_section(p, f->kind);

    p->failed = false;
    check_repeated(p, f, s);
    vec_push(p->arena, &f->sections, s);
    parser_advance(p);
    find_define_kind(p, s);
    find_data_kind(p, s);
    correct_section_kind(p, s);
    switch (s->kind) {
    case AST_STATE_VECTOR: case AST_LOCAL: case AST_REGION:
        parse_decls(p, s);
        break;
    case AST_DEFINE:
        parse_definitions(p, s);
        break;
    case AST_OPTIONS:
        parse_options(p, s);
        break;
    case AST_DATA:
        parse_data(p, s);
        break;
    case AST_STATE:
        check_state_name(p, s);
        parse_state(p, s);
        break;
    case AST_ALL_STATES:
        parse_state(p, s);
        for (int i = 0; i < AST_LABEL_COUNT; i++)
            if (s->block[i].present && i != AST_STEP)
                diag_label(p->diags, parser_report(p, DIAG_all_states_label, s->block[i].label, labels[i]), DIAG_label_all_states_label, labels[i]);
        break;
    case AST_SCRIPT_STATE:
        check_state_name(p, s);
        parse_script_section(p, s);
        break;
    case AST_PINS:
        parse_pins(p, s);
        break;
    case AST_IGNORED:
        if (f->kind == FILE_IO)
            parser_report_pin_section(p, s);
        else
            parser_report(p, DIAG_section_not_in_script, s->header, s->name->text);
        parser_skip_section(p);
        break;
    }
    if (p->visitor && s->kind != AST_SCRIPT_STATE)
        p->visitor->section(p->visitor->context, s);
}

// ---- includes ----

// Parses the lines `include "plant.ss"` at the start of a script.
static void parse_includes(Parser *p, AstFile *f)
{
    while (parser_at_include(p)) {
        p->failed = false;
        parser_advance(p);
        vec_push(p->arena, &f->includes, ((AstInclude){p->tok.text, parser_token_span(p)}));
        parser_advance(p);
        if (!p->tok.first)
            hint_explain(p, HINT_AT_END, NULL);
        parser_skip_line(p);
    }
    p->failed = false;
}

// ---- a file ----

// Finds the kind of a file from its name; returns false if the name has no known ending.
bool file_kind(const char *path, FileKind *kind)
{
    static const char *const ending[] = {".sv", ".sm", ".ss", ".io", ".app", ".net", ".rq"};          // ending[FileKind]
    const size_t n = strlen(path);

    for (size_t i = 0; i < sizeof ending / sizeof *ending; i++) {
        const size_t m = strlen(ending[i]);
        if (n >= m && strcmp(path + n - m, ending[i]) == 0) {
            *kind = (FileKind)i;
            return true;
        }
    }
    return false;
}

static void init_parser(Parser *p, Arena *arena, StrPool *strings, Diags *diags, const Source *src, FileKind kind)
{
    memset(p, 0, sizeof *p);
    p->arena = arena;
    p->strings = strings;
    p->diags = diags;
    p->kind = kind;
    lex_init(&p->lex, strings, diags, src);
    hint_init_index(&p->hints);
    p->lex.config = kind == FILE_IO || kind == FILE_APP || kind == FILE_NET;
    p->lex.addresses = kind == FILE_NET;
    p->lex.script = kind == FILE_SS;
    p->lex.requirements = kind == FILE_RQ;
    lex_next(&p->lex, &p->tok);
    lex_next(&p->lex, &p->ahead);
}

// first_section[kind of file] is the label of the report of text before the first section.
static const char *const first_section[] = {
    [FILE_SV] = "elements are declared in sections, as in [Tank]",
    [FILE_SM] = "a machine begins with [state_vector]",
    [FILE_SS] = "options belong in [options], tests in a section with the name of a state, as [Idle]",
    [FILE_IO] = "pins belong in [analog] and [digital]",
    [FILE_APP] = "options belong in [options], tasks in a section with the name of an executor",
    [FILE_NET] = "", [FILE_RQ] = ""                                    // these kinds of files have no sections
};

static AstFile *parse_visited(Arena *arena, StrPool *strings, Diags *diags, const Source *src, FileKind kind, const ScriptVisitor *v)
{
    AstFile *f = ARENA_NEW(arena, AstFile);
    size_t before = diags->errors_seen;
    Parser p;

    f->kind = kind;
    f->src = src;
    if (kind == FILE_APP)
        f->app = ARENA_NEW(arena, AstApp);
    init_parser(&p, arena, strings, diags, src, kind);
    if (kind == FILE_NET) {
        f->net = ARENA_NEW(arena, AstNet);
        parse_net(&p, f->net);
        return f;
    }
    if (kind == FILE_RQ) {
        f->requirements = ARENA_NEW(arena, AstRequirements);
        parse_requirements(&p, f->requirements);
        return f;
    }
    p.visitor = v;
    if (kind == FILE_SS)
        parse_includes(&p, f);
    if (p.tok.kind != TOK_HEADER && p.tok.kind != TOK_END) {
        if (p.tok.kind != TOK_ERROR)
            diag_label(diags, parser_report(&p, DIAG_text_before_section, parser_token_span(&p)), DIAG_label_text, first_section[kind]);
        parser_skip_section(&p);
    }
    while (p.tok.kind == TOK_HEADER)
        if (kind == FILE_APP)
            parse_app_section(&p, f->app);
        else
            parse_section(&p, f);
    if (f->app)
        f->app->lost = f->app->lost || diags->errors_seen > before;
    return f;
}

// Parses a source.  Always returns a tree, with error nodes where the source has errors, which are in `diags`.
AstFile *parse_file(Arena *arena, StrPool *strings, Diags *diags, const Source *src, FileKind kind)
{
    return parse_visited(arena, strings, diags, src, kind, NULL);
}

// Parses only the includes of a script.
AstFile *parse_script_includes(Arena *arena, StrPool *strings, Diags *diags, const Source *src)
{
    AstFile *f = ARENA_NEW(arena, AstFile);
    Parser p;

    f->kind = FILE_SS;
    f->src = src;
    init_parser(&p, arena, strings, diags, src, FILE_SS);
    parse_includes(&p, f);
    return f;
}

void parse_bindings(Arena *arena, StrPool *strings, Diags *diags, const Source *src, AstBindings *into)
{
    Parser p;

    init_parser(&p, arena, strings, diags, src, FILE_APP);
    while (p.tok.kind != TOK_END && app_parse_binding(&p, into))
        if (p.tok.kind == TOK_COMMA)
            parser_advance(&p);
}

// Parses a script.  The sections of the returned tree have no items, because `v` has received them.
AstFile *parse_script(Arena *arena, StrPool *strings, Diags *diags, const Source *src, const ScriptVisitor *v)
{
    return parse_visited(arena, strings, diags, src, FILE_SS, v);
}
