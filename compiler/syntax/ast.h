// SPDX-License-Identifier: Apache-2.0
// The syntax tree, which represents the source exactly as written, for every kind of file. The parser builds it; no later stage changes it.
// Where the source has an error, the tree has an error node. Code that visits an error node reports nothing, because the parser has
// already reported the error.
#ifndef SMC_AST_H
#define SMC_AST_H

#include <stdbool.h>

#include "compiler/base/buf.h"
#include "compiler/base/source.h"
#include "compiler/base/str.h"
#include "compiler/base/vec.h"
#include "compiler/syntax/time_unit.h"
#include "stdlib/types.h"

// ---- expressions ----

typedef enum AstExprKind {
    AST_ERROR,        // text with an error, which is already reported
    AST_NUMBER,       // 5 0x1F true false; a time: 1.5 s
    AST_NAME,         // tankPressure
    AST_UNARY,        // op a
    AST_BINARY,       // a op b; a chain a < b <= c is stored as (a < b) <= c, without AST_PAREN
    AST_PAREN,        // ( a )
    AST_STEPS,        // a steps, as an argument: a count of steps
    AST_IMPLIES,      // a implies b, in requirements
    AST_CALL,         // name ( args )
    AST_STATE_NAME,   // state name, in a script: whether the machine is in that state
    AST_WHEN          // at a, from a to b, after a, every a: the whole guard of a conditional of a script
} AstExprKind;

// The word that begins a guard by time (language.md 8.39 to 8.44).
typedef enum AstWhen { AST_AT, AST_FROM, AST_AFTER, AST_EVERY, AST_WHENS } AstWhen;

typedef struct AstExpr AstExpr;
typedef VEC(AstExpr *) AstArgs;
struct AstExpr {
    AstExprKind kind;
    SmOperator op;            // UNARY, BINARY (only these kinds have this field; comments below begin with the kinds in the same way)
    uint32_t depth;           // 1 + the depth of the deepest operand; at most AST_DEPTH_MAX, so that recursion over trees is bounded
    bool alone;               // a name or call where a statement is expected; the checker reports it (E0327)
    Span span;                // the whole expression
    uint32_t op_at, op_len;   // offset and length of the operator (UNARY, BINARY, IMPLIES), the name (CALL, STATE_NAME) or the word (WHEN)
    AstWhen when;             // WHEN: the word that begins the guard
    TimeUnit unit;            // NUMBER: the unit after it; then op_at and op_len are the number alone
    SmF64 number;             // NUMBER: its value, without the unit
    Str name;                 // NAME, CALL: the name; STATE_NAME: the state's name
    AstExpr *a, *b;           // UNARY, PAREN, STEPS: the operand a; BINARY, IMPLIES: both operands; WHEN: the numbers, b only after `to`
    AstArgs *args;            // CALL: the arguments
};

static inline Span ast_op_span(const AstExpr *e) { return (Span){e->span.src, e->op_at, e->op_len}; }

enum { AST_DEPTH_MAX = 2000 };    // the greatest depth of expressions and of nested conditionals

// ---- annotations ----

// One constant for each row of annotations.def: AST_READ_ONLY, AST_ALIAS.
typedef enum AstAnnotationKind {
#define ANNOTATION(name, spelling, takes, where) AST_##name,
#include "compiler/syntax/annotations.def"
#undef ANNOTATION
    AST_ANNOTATION_COUNT
} AstAnnotationKind;

// What an annotation can follow, as in the column `where` of annotations.def.
typedef enum AstAnnotationTarget {
    AST_ON_ELEMENT,           // an element that a machine lists in [state_vector]
    AST_ON_SV_ELEMENT,        // a declaration of an element in a .sv
    AST_ON_LOCAL,             // a declaration of a local in a machine
    AST_ON_SCRIPT_LOCAL,      // a declaration of a local in a script
    AST_ON_STATE,             // the header of a state
    AST_ON_ALL_STATES,        // the header [all_states] of a machine
    AST_ON_DEFINITION,        // a line of [define]
    AST_ON_DATA,              // a line of [data] with a column
    AST_ON_ANALOG_INPUT, AST_ON_ANALOG_OUTPUT, AST_ON_DIGITAL_INPUT, AST_ON_DIGITAL_OUTPUT,       // a pin in a .io
    AST_ANNOTATION_TARGETS
} AstAnnotationTarget;

// A number with an optional sign, at a position where the grammar allows no expression.
typedef struct AstNumber { SmF64 value; Span span; } AstNumber;

typedef struct AstNames { VEC(Str) at; VEC(Span) span; } AstNames;       // names, and their positions

typedef struct AstAnnotation {
    AstAnnotationKind kind;
    Span span;                // the whole annotation, with its @ and its arguments
    AstNames *names;          // EXCEPT: the names of states
    Str name;                 // ALIAS: the other name; UNIT: its text; ALLOW: the name of the warning, as after -W; REQ: the requirement
    Span name_span;
    Str reason;               // ALLOW: the reason
    AstNumber lo, hi;         // RANGE: both; annotations with one number or a value: lo
    bool is_truth;            // `lo` was written as true or false
} AstAnnotation;

typedef VEC(AstAnnotation) AstAnnotations;

// ---- statements ----

typedef enum AstStmtKind {
    AST_STMT_ERROR,
    AST_ASSIGN,       // name = value
    AST_TRANSITION,   // -> name
    AST_ALLOWED,      // @allow(name, "reason"), for the next statement
    AST_IF,           // [if] value: … or { … }, else …
    AST_ASSERT,       // @assert value     (scripts)
    AST_FAIL,         // @fail "text"      (scripts)
    AST_EXPECT,       // @expect value within time     (scripts)
    AST_PRINT,        // @print value, …   (scripts)
    AST_STOP          // @stop             (scripts)
} AstStmtKind;

typedef struct AstStmt AstStmt;
typedef VEC(AstStmt *) AstStmts;
typedef struct AstArms {      // the branches of a conditional
    AstStmts then, otherwise;
    Span body_span, else_body_span;   // the statement after the colon, or { … } including the braces
    Span else_span;           // the word `else`
    bool braces, else_braces; // whether the body is in { } rather than after a colon
    bool has_else;
} AstArms;
// What follows an @assert, @fail, @expect or @print.
typedef struct AstRemark {
    Str text, requirement;    // NULL: none
    AstExpr *within;          // EXPECT: the time after `within`
    VEC(AstExpr *) values;    // PRINT: the values that it shows
} AstRemark;

struct AstStmt {
    AstStmtKind kind;
    bool flawed;              // an error in the statement has been reported
    Span span;                // the whole statement; IF: up to the end of its guard
    Str name;                 // ASSIGN: the assigned variable; TRANSITION: the target state
    Span name_span;
    const AstAnnotation *allow;       // ALLOWED: the @allow
    AstExpr *value;           // ASSIGN, ASSERT, EXPECT: the expression; IF: the guard
    const AstRemark *remark;  // ASSERT: or NULL if nothing follows; FAIL, EXPECT, PRINT
    AstArms *arms;            // IF: its branches
    AstNames *marks;          // the requirements that @req after the statement of a machine names; NULL: none
};

// ---- declarations and sections ----

typedef struct AstDecl {
    SmType type;
    Span type_span;
    Str name;
    Span name_span;
    AstExpr *value;           // the initial value of a local
    AstAnnotations annotations;
    bool is_incomplete;       // an error was reported after the name, so `value` or an annotation can be missing
} AstDecl;

// A line of [define]: name = value.
typedef struct AstDefinition {
    Str name;
    Span name_span;
    AstExpr *value;
    AstAnnotations annotations;
} AstDefinition;

// An entry of [options]: `lock`, `delta_t 10 ms`, `init_state Idle`, `set limit 40`.
typedef struct AstOption {
    Str name;
    Span name_span;
    AstExpr *number;          // delta_t, step, seed, set: the literal of its value
    Str word;                 // init_state: the name of the state; time_unit: the unit; set: the name of the parameter; `delta_t file`: the word
    Span word_span;           // set: the name
    Span value_span;
} AstOption;

// ---- [data] of a script ----

// The settings of [data], by the column `slot` of data_words.def: of two words with the same slot, a section can have only one.
typedef enum AstDataSlot { AST_DATA_FILE, AST_DATA_TIME, AST_DATA_BETWEEN, AST_DATA_BAD_TIME, AST_DATA_MISSING, AST_DATA_SLOTS } AstDataSlot;

// A setting, as in data_words.def: `time "t_ms" ms`.
typedef struct AstDataSetting {
    Str word;                 // "time"; NULL: the section lacks this setting
    Span span;                // position of the word
    Str text;                 // FILE, TIME: the text in quotes
    Span text_span;
    Str value;                // TIME: the unit; BAD_TIME, MISSING: the word that follows
    Span value_span;
} AstDataSetting;

// A line `P1 = "PT-101" @scale 0.1` or `@compare valveOpen "VALVE" tolerance 0 delay 20 ms`.
typedef struct AstDataLine {
    bool is_compare;
    Str element;
    Span element_span;
    Str column;
    Span column_span;
    AstNumber tolerance;      // absent if its span has no source
    AstExpr *delay;           // the literal after `delay`; or NULL
    AstAnnotations annotations;
} AstDataLine;

typedef struct AstData {
    AstDataSetting setting[AST_DATA_SLOTS];
    VEC(AstDataLine) line;
    bool is_lost;             // a line has an error, which is already reported
} AstData;

// A line of a .io: `i 0 tankPressure @scale 250`.
typedef struct AstPin {
    bool output;
    AstNumber number;         // the pin's number as written; not yet checked
    Str element;
    Span element_span;
    AstAnnotations annotations;
} AstPin;

typedef enum AstLabel { AST_ENTRY, AST_STEP, AST_EXIT, AST_LABEL_COUNT } AstLabel;

typedef struct AstBlock {
    bool present;
    Span label;               // position of the label, such as `.entry`
    AstStmts stmts;
} AstBlock;

typedef enum AstSectionKind {
    AST_STATE_VECTOR,         // [state_vector] of a machine: decls
    AST_LOCAL,                // [local] of .sm and .ss: decls
    AST_DEFINE,               // [define] of a machine or script: definitions
    AST_OPTIONS,              // [options] of .sv, .sm and .ss: options
    AST_REGION,               // [Region] of a .sv: decls
    AST_STATE,                // a state of a machine: blocks
    AST_ALL_STATES,           // [all_states] of a machine: annotations and the block .step
    AST_DATA,                 // [data] of a script: data
    AST_SCRIPT_STATE,         // a state's section in a script, or [all_states]: items
    AST_PINS,                 // [analog] and [digital] of a .io: pins
    AST_IGNORED               // a section that this kind of file cannot have; already reported
} AstSectionKind;

typedef struct AstSection {
    AstSectionKind kind;
    Str name;
    Span name_span;           // the text between the brackets
    Span header;              // including the brackets
    AstAnnotations annotations;   // STATE: the annotations after its header
    VEC(AstDecl) decls;
    VEC(AstDefinition) definitions;
    VEC(AstOption) options;
    VEC(AstPin) pins;
    AstData *data;            // DATA; else NULL
    bool digital;             // PINS: the section is [digital]
    AstBlock block[AST_LABEL_COUNT];
    AstStmts items;           // SCRIPT_STATE: conditionals (AST_IF)
    bool all_states;          // SCRIPT_STATE: it is [all_states]
} AstSection;

// docs/config.md defines .io, .app and .net, docs/requirements.md .rq
typedef enum FileKind { FILE_SV, FILE_SM, FILE_SS, FILE_IO, FILE_APP, FILE_NET, FILE_RQ, FILE_KINDS } FileKind;

// Finds the kind of a file from its name; returns false if the name has no known ending.
bool file_kind(const char *path, FileKind *kind);

// A line `include "plant.ss"` of a script.
typedef struct AstInclude { Str name; Span span; } AstInclude;      // span: the name with its quotes

typedef struct AstFile {
    FileKind kind;
    const Source *src;
    VEC(AstInclude) includes; // the includes at the start of a script
    VEC(AstSection *) sections;       // in file order
    struct AstApp *app;               // the tree of a .app, which has no AstSection (ast_app.h); else NULL
    struct AstNet *net;               // the tree of a .net, which has no AstSection (ast_net.h); else NULL
    struct AstRequirements *requirements;     // the tree of a .rq, which has no AstSection (ast_rq.h); else NULL
} AstFile;

void ast_print(const AstFile *f, Buf *out);      // prints the tree as text: the output of --emit=ast

#endif
