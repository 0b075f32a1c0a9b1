// SPDX-License-Identifier: Apache-2.0
// Declarations shared by the files of the parser. parse.c: files, sections, blocks; parse_decl.c: declarations and options;
// parse_annotation.c: annotations; parse_config.c: pins; parse_stmt.c: statements; parse_expr.c: expressions; hint_expr.c and
// hint_stmt.c: hints, which guess what the user meant where something is wrong.
// An error is reported once: p->failed then silences everything up to the next statement, where it is cleared.
#ifndef SMC_PARSER_H
#define SMC_PARSER_H

#include <string.h>

#include "compiler/syntax/lex.h"
#include "compiler/syntax/parse.h"

typedef struct Parser {
    Lexer lex;
    Token tok, ahead;             // the next token and the one after it
    Token last;                   // the last token consumed
    Arena *arena;
    StrPool *strings;
    Diags *diags;
    FileKind kind;
    bool failed;                  // reports are dropped until the next statement
    bool lost_body;               // in this block a conditional lost statements, so its `else` will look misplaced
    bool stopped;                 // parsing was abandoned: every further token is END and nothing is reported
    unsigned braces;              // open
    bool told_unguarded;          // SS: this section's unguarded items have been reported
    unsigned nesting;             // of conditionals
    unsigned depth;               // of the current position in the expression
    unsigned parens;              // open at that position: line ends count as blanks
    uint32_t indented;            // lines before this position belong to a condition whose braces are missing
    bool is_guard;                // the current expression is a condition: an = in it was meant as ==
} Parser;

// ---- tokens ----

void parser_next(Parser *p);
void parser_stop(Parser *p);                            // stops reading and reporting
Span parser_span(const Parser *p, const Token *t);
Span parser_here(const Parser *p);                      // of the next token
Span parser_gap(const Parser *p);                       // directly after the last token
Span parser_since(const Parser *p, uint32_t at);        // from `at` to the end of the last token
bool parser_at_end_of_statement(const Parser *p);
bool parser_at_end_of_block(const Parser *p);           // } label header end

// ---- messages ----

// Like diag_report, but does nothing while p->failed is set.
Diag *parser_report(Parser *p, DiagCode code, Span span, ...);
// The same, and sets p->failed.
Diag *parser_fail(Parser *p, DiagCode code, Span span, ...);
const char *parser_text(const Parser *p, Span span);    // the source text, cut to a readable length
// A token as a message names it: "'>='", "the end of the line", "the section [Idle]".
const char *parser_describe(const Parser *p, const Token *t);
const char *parser_found(const Parser *p);              // describes the next token, or the end of the line before it
// Labels the current annotation, which is unknown, with the nearest one allowed here. If none is near, the label lists all of them.
void label_annotations(Parser *p, Diag *d, const char *const *here, size_t n);

// ---- grammar ----

AstExpr *parse_expr(Parser *p, bool is_guard);          // begins with the next token, on whatever line
AstExpr *parse_value_of(Parser *p, bool is_guard);      // the same, but must begin on this line
void parse_block(Parser *p, AstStmts *into);            // statements up to }, a label, a header or the end
void parse_decls(Parser *p, AstSection *s);
const char *parse_foreign_type(const char *word);       // our type for a type name of another language, or NULL
void parse_options(Parser *p, AstSection *s);
// Parses all annotations that follow; `owner` is the name of what they annotate.
void parse_annotations(Parser *p, AstPlace place, Str owner, Span owner_span, AstAnnotations *into);
bool parse_signed_number(Parser *p, AstNumber *into);   // a number with or without a sign; false: none found
void parse_pins(Parser *p, AstSection *s);
void refuse_pin_section(Parser *p, const AstSection *s);
bool annotation_is_allow(const Token *t);
const AstAnnotation *parse_allow(Parser *p);            // an @allow before a statement; NULL after a message
void annotation_before_decl(Parser *p);                 // reports the current annotation, where a declaration should begin
void annotation_in_block(Parser *p);                    // the same, where a statement should begin
void parse_app_section(Parser *p, struct AstApp *app);  // at its header
void skip_section(Parser *p);                           // to the next line that begins with a header; does not even read tokens
void skip_line(Parser *p);                              // to the next line, header or the end

// ---- hints: errors of users who know other languages, or type too fast ----

void hint_prefix(Parser *p);                            // NOT x
void hint_infix(Parser *p, const AstExpr *left);        // x AND y, x = y in a guard
void hint_assign(Parser *p, const AstExpr *left, Span sign);      // reports the = of such a guard; left may be NULL
bool hint_choice(const Parser *p);                      // IF(a; b; c)
bool hint_operand(Parser *p, AstExpr *name);            // abs x, after the name; true when reported
bool hint_remark(Parser *p);                            // -- x, where an expression is impossible; true when reported
bool hint_unit_step(Parser *p);                         // x++ where a value is missing; true when reported
void hint_missing_value(Parser *p, Diag *d);            // adds to the message that a value is missing here
bool hint_decimal_comma(Parser *p);                     // 3,14 at the comma; true when reported
bool hint_dotted_name(Parser *p, Span name);            // tank.pressure after `tank`; true when reported
void hint_after_name(Parser *p, AstExpr *name);   // tank.pressure, a[3]
bool hint_is_and_then(const Parser *p);                 // x = 1 and then -> Idle, at `and`
void hint_equality_chain(Parser *p, const AstExpr *e);  // a == b == c
// A statement is complete, but more text follows on its line. Reports it.
void hint_at_end(Parser *p);
// An expression appears alone where a statement is expected: x + 1, valveOpen == true, a guard without its colon.
void hint_expression(Parser *p, AstExpr *e, bool has_if);
void hint_op_assign(Parser *p, Span name);              // x += 1, at the sign
// Nothing follows the colon of a guard, or of `else` (guard is NULL).
void hint_colon(Parser *p, AstExpr *guard, Span colon);
void hint_colon_assign(Parser *p, const AstExpr *guard, Span colon);      // x: = 1, at the =
bool hint_bracketed_state(Parser *p);                   // -> [Idle] at the bracket; true when reported
void hint_else(Parser *p);                              // `else` is followed by neither : nor { nor if
// The next text does not begin a statement. If it looks like one of another language, reports it and returns true; otherwise returns
// false.
bool hint_statement(Parser *p);

// ---- shared by the two files of hints ----

bool hint_is_word(const Token *t, const char *lower);   // a name that is this word, in upper or lower case
bool hint_is_label(const char *word);                   // entry, step, exit
bool hint_touches(const Token *a, const Token *b);      // the two are adjacent
bool hint_begins_value(const Token *t);
bool hint_is_guard(const Parser *p);  // its line, which continues inside parentheses, contains a : or a {; or the next line has a {
void hint_replace_word(Parser *p, const char *native, TokenKind kind);  // reports a foreign word and turns it into a token of that kind

#endif
