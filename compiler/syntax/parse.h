// SPDX-License-Identifier: Apache-2.0
// Converts text to a syntax tree. The parser checks everything that does not require the meaning of a name: characters, numbers, grammar,
// misplaced sections and labels, annotations, options, the shape of scripts. Its diagnostics are E01xx and E03xx. The checker handles
// the rest: names and types, values of options, transitions in .exit, all warnings.
#ifndef SMC_PARSE_H
#define SMC_PARSE_H

#include "compiler/diag/diag.h"
#include "compiler/syntax/ast.h"
#include "compiler/syntax/ast_app.h"

// Always returns a tree. Where the source has errors the tree contains error nodes, and the errors are in `diags`. The tree is allocated
// in `arena`; names are interned in `strings`.
AstFile *parse_file(Arena *arena, StrPool *strings, Diags *diags, const Source *src, FileKind kind);

// Receives the parts of a script in file order, so that the whole tree need not be in memory.
typedef struct ScriptVisitor {
    // Called for each section: before its items if it has items, otherwise after it has been parsed.
    void (*section)(void *context, const AstSection *s);
    void (*item)(void *context, const AstStmt *item);         // called for each item, which is freed after the call
    void *context;
    Arena *items;             // where items are allocated; the parser frees it, so it must contain nothing else
} ScriptVisitor;

// Parses a script. The sections of the returned tree have no items, because `v` has received them.
AstFile *parse_script(Arena *arena, StrPool *strings, Diags *diags, const Source *src, const ScriptVisitor *v);

// Parses only the includes at the start of a script. The returned tree has no sections.
AstFile *parse_script_includes(Arena *arena, StrPool *strings, Diags *diags, const Source *src);

// Parses bindings such as `fire = fireDrogue, armed = drogueArmed`, with commas, blanks or line ends between them.
void parse_bindings(Arena *arena, StrPool *strings, Diags *diags, const Source *src, AstBindings *into);

// Prints the tokens of a source, one per line, comments included: --emit=tokens.
void lex_print(StrPool *strings, Diags *diags, const Source *src, FileKind kind, Buf *out);

#endif
