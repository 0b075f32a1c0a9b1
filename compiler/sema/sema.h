// SPDX-License-Identifier: Apache-2.0
// What the files of the checker share.  Inside sema/ only; others include check.h.
#ifndef SMC_SEMA_H
#define SMC_SEMA_H

#include "compiler/sema/check.h"

// Where an expression stands, which decides what it may use.
typedef enum ExprPlace {
    PLACE_STEP,               // it is evaluated in a step: everything
    PLACE_INITIAL,            // initial value of a local: earlier locals
    PLACE_SIZE                // size of a window: locals
} ExprPlace;

// A local that the size of a window depends on.
typedef struct SizeUse { Var *local; Span span; } SizeUse;

// What the parser's errors may have hidden of a file (lost.c).
typedef struct Lost {
    bool any;                 // there were errors
    bool names;               // some may have hidden declarations
    bool sections;            // some may have hidden whole sections
    Map word;                 // the words that may have been declared there
} Lost;

Lost *lost_names(const CheckContext *c, const AstFile *f);

// One machine or script being checked.
typedef struct Sema {
    Arena *arena;
    StrPool *strings;
    Diags *diags;
    const Program *p;         // the machine: being built, or the one that the script is for
    StateVec *sv;             // of a machine with a .sv: the elements it could list; else NULL
    Windows *windows;         // where roll calls go: the machine's or the script's
    bool in_script;
    Diag *unknown;            // in a script: the first report of a name that the machine has not
    bool knows;               // in a script: something that it names is in the machine, beside G, S and T
    const Lost *lost;
    Map functions;            // name to SmBuiltinInfo
    Map unknown_name, unknown_state, unknown_function;   // reported already (name to itself)
    bool functions_noted;         // the list of functions has been shown
    Map said;                 // names that a remark was made on, once
    Map doubtful;             // names declared twice: nothing more is said about them
    Map place;                // name or alias to the Span of its declaration
    unsigned guesses;         // how many more unknown names are compared with all known ones

    ExprPlace at;
    const Var *local;         // PLACE_INITIAL: whose initial value it is
    Str size_of;              // PLACE_SIZE: the function called
    const AstExpr *spine;     // the left operand of an operator that was already looked at for `not`
    bool no_elements;         // the machine lists none: that has been reported
    bool *no_value;           // by Var.index: a local whose initial value has an error
    VEC(SizeUse) size_use;
    BlockKind block;          // where the statement being checked stands
    uint32_t stmts;           // how many statements there have been
    uint32_t operators;       // of the value at hand, as in Stmt
    bool varies;
    Program *making;          // the machine being built; NULL of a script
} Sema;

void sema_init(Sema *s, const CheckContext *c, const Lost *lost, const Program *p, Windows *windows);
// The file's name without folders and ending.
Str sema_stem(StrPool *strings, const Source *src);

// ---- scope.c: names ----

Var *scope_find(const Sema *s, Str name);
bool scope_is_doubtful(const Sema *s, Str name);
// Reports a name that scope_find does not know; once.
void scope_report_unknown(Sema *s, Str name, Span span);
// The state, or NULL: then it was reported, once.
State *scope_find_state(Sema *s, Str name, Span span);
const SmBuiltinInfo *scope_find_function(const Sema *s, Str name);
void scope_report_unknown_function(Sema *s, Str name, Span span);
// A note at the declaration of a name of the machine.
void scope_note_declared(Sema *s, Diag *d, Str name);

// The nearest of several words to one that is unknown.
typedef struct Guess {
    Str wanted, best;         // best: NULL while nothing is near
    size_t limit;             // only what is nearer counts
} Guess;

Guess guess_start(Str wanted);
void guess_try(Guess *g, Str candidate);
void guess_label(Diags *diags, Diag *d, const Guess *g);   // "did you mean …?", if there is one

// ---- the chapters ----

// [state_vector] and [local] of a machine: its variables.
void check_declarations(Sema *s, Program *p, const AstFile *sm, StateVec *sv, const Map *written_outside);
// Each gives NULL when there was an error in it; that was reported.
Expr *check_expr(Sema *s, const AstExpr *e);
Expr *check_roll(Sema *s, const AstExpr *call, const SmBuiltinInfo *fn);
Stmt *check_assignment(Sema *s, const AstStmt *in);
void check_stmts(Sema *s, const AstStmts *in, Stmts *out);
void warn_of_unguarded_abort(Sema *s, const State *state, const AstSection *section, AstLabel label);   // check_unguarded.c
const char *sema_quote(Sema *s, Span span);     // a piece of the source for a message: one line, and no more than can be read
// Warns of windows whose size depends on a local that the machine assigns.
void check_size_uses(Sema *s);

// What @range among the annotations says of an element; NULL where it says nothing, or something wrong, which is reported.
bool has_annotation(const AstAnnotations *all, AstAnnotationKind kind);
const Range *check_range(const CheckContext *c, const AstAnnotations *all, Str name, SmType type);

// ---- check_allow.c: what @allow covers ----

// Those among the annotations of a declaration, of its .sv and of a machine.
void allow_in_sv(const CheckContext *c, StateVec *sv, const AstDecl *decl);
void allow_decl(Sema *s, const AstDecl *decl);
// Those behind the header of a state: `end` is where its section ends.
void allow_state(Sema *s, const AstSection *section, uint32_t end);
void allow_stmt(Sema *s, const AstAnnotation *a, const AstStmt *stmt);
// Those of the element in the .sv, which count where a machine lists it too.
void allow_listed(Sema *s, const Element *e, const AstDecl *listed);

Expr *expr_new(Sema *s, ExprKind kind, Span span, uint32_t args);

#endif
