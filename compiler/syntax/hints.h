// SPDX-License-Identifier: Apache-2.0
// Hints: what the user meant by text that the grammar does not allow. Users know other languages (`&&`, `5 s`, `if x then`), write prose,
// or make typing errors. Lexer and parser contain only the grammar. For text that the grammar does not allow they call one of these
// functions, which searches hints.def for the likeliest cause, reports that cause instead of a general diagnostic, and proposes an edit if
// the meaning is unambiguous.
#ifndef SMC_HINTS_H
#define SMC_HINTS_H

#include "compiler/syntax/lex.h"

typedef enum HintResult {
    HINT_NONE,                // no row of hints.def matches the text
    HINT_READ,                // the text was reported and read as what the user meant: the caller continues normally
    HINT_SKIPPED              // the text was reported and skipped: the caller ends what it was parsing
} HintResult;

// ---- for the lexer ----

void hint_init(Lexer *l);     // called by lex_init

// Handles text of another language that the lexer could misread: `&&`, `// ...`, `state Hold:`. Called at the start of a token if
// l->first_hint has a row for the token's first character, or the last token is an annotation. After HINT_READ, t is the token meant.
HintResult hint_read_foreign_text(Lexer *l, Token *t);
// Reports a token of this kind that is well formed only up to `end`: 5psi, größe, [two words]. Returns the end of the malformed token.
uint32_t hint_report_malformed_token(Lexer *l, const Token *t, TokenKind kind, uint32_t end);
// Handles text that cannot begin a token. Never returns HINT_NONE.
HintResult hint_read_stray_text(Lexer *l, Token *t);
// Whether the quote at `at` is meant as a character of the text that begins at `from`, as \" is in other languages.  Reports it.
bool hint_read_escaped_quote(Lexer *l, uint32_t from, uint32_t at);

// ---- for the parser ----

// What the parser is doing at the error, and what the argument `e` of hint_explain is in this context. "general diagnostic" marks the
// contexts in which hint_explain reports one if no row matches, such as "expected a value".
typedef enum HintContext {
    HINT_AT_OPERAND,          // is at the start of an operand
    HINT_AFTER_NAME,          // has read a name in an expression: e. SKIPPED: e is wrong
    HINT_AT_OPERATOR,         // expects an operator after the operand e, or the end. SKIPPED: the expression ends here
    HINT_AT_VALUE,            // expects a value; general diagnostic
    HINT_AT_CLOSE,            // expects the ) of an expression in parentheses
    HINT_AT_STATEMENT,        // is at the start of a statement
    HINT_AT_ASSIGN,           // after the name of an assignment, whose operator is not =
    HINT_AFTER_ASSIGNMENT,    // after the assignment p->assign_operator, at a : or {
    HINT_AT_TARGET,           // expects the name of a state after ->
    HINT_AFTER_GUARD,         // expects : or { after the condition e
    HINT_AT_LONE_VALUE,       // has read the value e as a statement of its own; general diagnostic
    HINT_AFTER_ELSE,          // expects : or { after `else`
    HINT_AFTER_COLON,         // expects a statement directly after the colon of the condition e; after that of `else`, e is NULL
    HINT_AT_END,              // expects the end of a statement or of a requirement, whose condition is e; general diagnostic
    HINT_AFTER_WHEN,          // expects : or { after the guard by time e
    HINT_AT_TO,               // expects `to` and a number after the guard by time e, which has only its first number
    HINT_AT_DEFINITION_VALUE, // expects = after the name of a definition; general diagnostic
    HINT_AT_DEMAND,           // is at the start of a requirement's demand, which begins with never or always
    HINT_AT_DECL,             // is at the start of a declaration
    HINT_AFTER_DECL_NAME,     // has read the name of an element, variable or pin
    HINT_AFTER_DECL,          // expects annotations or the end of a declaration
    HINT_AT_DECL_END,         // expects the end of a declaration
    HINT_AT_ELEMENT_END,      // expects the end of an element's declaration, and no row of AT_DECL_END matched; general diagnostic
    HINT_AT_PIN_NUMBER,       // expects the number of a pin, and is at a word; general diagnostic
    HINT_AT_PIN_END,          // expects the end of a pin; general diagnostic
    HINT_AT_OPTION            // is at a word that is no option; general diagnostic
} HintContext;

enum { HINT_CONTEXTS = HINT_AT_OPTION + 1 };

// Computed from hints.def when a parser starts, so that valid sources need no search.
typedef struct HintIndex {
    // tokens[context]: the set of kinds of the next token that a row of the context accepts; all kinds if it has a general diagnostic.
    uint64_t tokens[HINT_CONTEXTS];
    uint8_t first_row[HINT_CONTEXTS];   // first_row[context]: the rows of a context are adjacent
} HintIndex;

struct Parser;
struct AstExpr;

void hint_init_index(HintIndex *index);

// Reports the likeliest cause of an error by the rows of a context; parsers call hint_explain of parser.h instead.
HintResult hint_explain_by_rows(struct Parser *p, HintContext context, struct AstExpr *e);

// Reports `{ x == 2 -> Abort }`, a transition whose condition is inside the braces, and skips it. The current token is the brace. Returns false,
// and reports nothing, if the braces contain something else.
bool hint_report_guard_in_braces(struct Parser *p);

// Whether the token is a word that another language has in place of an operator, with a value after it, as in `state is Burn`.
bool hint_is_phrase(const struct Parser *p, const Token *word);
// Called when a condition is reported that ends its line without a brace: the lines below that are indented more need no report about their
// semicolons, and the word that closes them in another language, such as `end`, none either.
void hint_cover_indented(struct Parser *p);
bool hint_is_time_unit(const char *word);         // whether users write the word for a unit of time

// Returns the word of this language for a word of another one, such as I32 for int; NULL if none is known.
typedef enum HintWords { HINT_TYPES, HINT_LABELS, HINT_OPTIONS, HINT_DIRECTIONS, HINT_UNITS } HintWords;
const char *hint_find_synonym(HintWords of, const char *word);

#endif
