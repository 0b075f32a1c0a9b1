// SPDX-License-Identifier: Apache-2.0
// Text to tree.  The parser judges everything that can be judged without knowing what a name means: characters, numbers,
// grammar, sections and labels out of place, annotations, options, the shape of scripts.  Its diagnostics are E01xx and
// E03xx.  Left to the checker: names and types, values of options, transitions in .exit, what draws a warning.
#ifndef SMC_PARSE_H
#define SMC_PARSE_H

#include "compiler/diag/diag.h"
#include "compiler/syntax/ast.h"

// Always gives a tree; where the source was wrong it holds error nodes, and `diags` has said so.  Everything lives in
// `arena`; names are interned in `strings`.
AstFile *parse_file(Arena *arena, StrPool *strings, Diags *diags, const Source *src, FileKind kind);

// The tokens of a source as text, one a line, comments included: --emit=tokens.
void lex_print(StrPool *strings, Diags *diags, const Source *src, FileKind kind, Buf *out);

#endif
