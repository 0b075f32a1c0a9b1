// SPDX-License-Identifier: Apache-2.0
// Declarations shared by the files of the parser. parse.c: files, sections, blocks; parse_decl.c: declarations and options;
// parse_annotation.c: annotations; parse_config.c: pins; parse_stmt.c: statements; parse_expr.c: expressions; parse_when.c: guards by time. These
// files contain only the grammar. Where the source violates it, hints.h finds what the user meant.
// Errors that follow from a reported error are not reported: parser_fail sets p->failed, which silences reports up to the next statement.
#ifndef SMC_PARSER_H
#define SMC_PARSER_H

#include <string.h>

#include "compiler/syntax/hints.h"
#include "compiler/syntax/lex.h"
#include "compiler/syntax/parse.h"

typedef struct Parser {
    Lexer lex;
    Token tok, ahead;             // the next token (the current one, in comments), and the one after it
    Token last;                   // the last token consumed
    Arena *arena;
    StrPool *strings;
    Diags *diags;
    FileKind kind;
    const ScriptVisitor *visitor; // receives the items of a script; NULL: items become part of the tree
    AstStmts *visited;            // the items of the current section that the visitor has not received; NULL: there is no visitor
    bool failed;                  // an error was reported: further reports are dropped until the next statement
    bool lost_body;               // in this block a conditional lost statements, so its `else` will look misplaced
    bool stopped;                 // parsing was abandoned: every further token is TOK_END, and nothing more is reported
    unsigned braces;              // number of open braces
    unsigned brace_searches;      // how often a hint has searched for a missing }
    bool reported_unguarded;      // in a script: items without a guard have been reported for the current section
    unsigned nesting;             // number of conditionals around the current position
    unsigned depth;               // depth of the recursion in the current expression
    unsigned parens;              // open parentheses in the current expression; inside them line ends count as spaces
    bool has_if;                  // the current condition begins with `if`
    bool is_expect;               // the current expression is the condition of an @expect, which `within` ends

    // Only the hints use these fields.
    HintIndex hints;
    bool is_guard;                // the current expression is a condition, in which the user means == by =
    Span assign_operator;         // the operator of the last assignment
    bool is_foreign_header;       // the header of the current state is reported: `state Hold {`
    unsigned open_blocks;         // reported blocks of other languages, as `if x then`, whose closing word needs no further report
    AstAnnotationTarget pin_target;   // the kind of the current pin: from its section and direction
    uint32_t indented;            // end of the lines that belong to a condition whose missing braces are reported
} Parser;

// Called in `context` if the grammar does not allow the next tokens, or if another language gives them another meaning. Reports the
// likeliest cause.
static inline HintResult hint_explain(Parser *p, HintContext context, AstExpr *e)
{
    if (!(p->hints.tokens[context] >> p->tok.kind & 1u))         // no row can match: the usual case in valid sources
        return HINT_NONE;
    return hint_explain_by_rows(p, context, e);
}

// ---- tokens ----

void parser_advance(Parser *p);                         // consumes the next token
void parser_stop(Parser *p);                            // ends parsing: every further token is TOK_END, and nothing is reported
Span parser_span(const Parser *p, const Token *t);      // returns the position of a token
Span parser_token_span(const Parser *p);                // returns the position of the next token
Span parser_gap_span(const Parser *p);                       // returns the empty position directly after the last token
Span parser_missing_span(const Parser *p);             // returns the position of the next token, or of the end of the line before it
Span parser_span_since(const Parser *p, uint32_t at);        // returns the range from `at` to the end of the last token
bool parser_at_end_of_statement(const Parser *p);       // whether the next token begins a line or ends the block, or the last one is }
bool parser_at_end_of_block(const Parser *p);           // whether the next token is }, a label, a header or the end
bool parser_is_steps(const Parser *p);                  // whether the next token is the word `steps` that ends an argument (language.md 7.25)

// ---- diagnostics ----

// Like diag_report, but does nothing while p->failed is set.
Diag *parser_report(Parser *p, DiagCode code, Span span, ...);
// Reports like parser_report, and sets p->failed.
Diag *parser_fail(Parser *p, DiagCode code, Span span, ...);
const char *parser_text(const Parser *p, Span span);    // returns the source text, cut to a readable length
const char *parser_text_of_line(const Parser *p, uint32_t at);         // returns the text from `at` to a comment or the end of the line
// Describes a token for a diagnostic: "'>='", "the end of the line", "the section [Idle]".
const char *parser_describe(const Parser *p, const Token *t);
const char *parser_describe_found(const Parser *p);              // describes the next token, or the end of the line before it
// Labels d, which reports that the current annotation is unknown, with the most similar of the n annotations in `here`, which are allowed
// at this position. If none is similar, the label lists all of them.
void parser_label_annotations(Parser *p, Diag *d, const char *const *here, size_t n);

// ---- grammar ----

AstExpr *parse_expr(Parser *p, bool is_guard);          // parses an expression from the next token on, on this line or a later one
AstExpr *parse_number(Parser *p);                       // the next token is a number, true or false; a unit of time can follow
AstExpr *parse_value_of(Parser *p, bool is_guard);      // parses an expression that must begin on this line
bool parser_at_when(const Parser *p);                   // whether the next tokens begin a guard by time, as in `at 5 s:`
extern const char *const parser_when_words[AST_WHENS];
AstWhen parser_find_when(const Token *t);               // returns the word with which a guard by time begins; AST_WHENS: the token is no such word
bool parser_is_before_number(const Parser *p);          // whether a number, well formed or not, follows the next token on its line
AstExpr *parse_when(Parser *p);                         // parses a guard by time, as in `at 5 s`
bool parser_at_state(const Parser *p);                  // whether the next tokens are a value such as `state Burn`
AstExpr *parse_state_value(Parser *p);                      // parses a value such as `state Burn`
void parse_block(Parser *p, AstStmts *into);            // parses statements up to }, a label, a header or the end
void parser_visit_items(Parser *p);                     // passes the parsed items to the visitor, and frees them
void parse_decls(Parser *p, AstSection *s);
void parse_definitions(Parser *p, AstSection *s);
void parse_options(Parser *p, AstSection *s);
bool parser_at_data(const Parser *p);                   // whether the next tokens begin a line of [data]
void parse_data(Parser *p, AstSection *s);
// Parses all annotations that follow; `owner` is the name of the annotated declaration, state or pin's element.
void parse_annotations(Parser *p, AstAnnotationTarget target, Str owner, Span owner_span, AstAnnotations *into);
bool parse_signed_number(Parser *p, AstNumber *into);   // parses a number with or without a sign; false: there is none
void parse_pins(Parser *p, AstSection *s);
void parser_report_pin_section(Parser *p, const AstSection *s);
bool parser_at_include(const Parser *p);                // whether the next tokens are `include` and a text
void parser_report_late_include(Parser *p);             // reports an include that is inside a section
bool parser_is_allow(const Token *t);
const AstAnnotation *parse_allow(Parser *p);            // an @allow before a statement; NULL if it reported an error
void parser_report_annotation_before_decl(Parser *p);                 // reports an annotation where a declaration should begin
void parser_report_annotation_in_block(Parser *p);                    // reports an annotation where a statement should begin
void parse_app_section(Parser *p, struct AstApp *app);  // parses a section; the next token is its header
void parse_net(Parser *p, struct AstNet *net);          // parses a whole .net
void parse_requirements(Parser *p, struct AstRequirements *into);     // parses a whole .rq
bool parser_at_requirement(const Parser *p);            // whether the next tokens begin a requirement
AstExpr *parse_condition_of(Parser *p);                 // parses `e` or `a implies b`, which must begin on this line
bool parser_is_word(const Parser *p, const char *word); // whether the current token is this name, on the line of the last token
void parser_skip_section(Parser *p);                           // skips to the next line that begins with a header, without reading tokens
void parser_skip_line(Parser *p);                              // skips to the next line, header or the end of the file

#endif
