// SPDX-License-Identifier: Apache-2.0
// The syntax tree of a file of requirements (.rq) as written (docs/requirements.md). A line with a syntax error has been reported and is
// missing in the tree.
#ifndef SMC_AST_RQ_H
#define SMC_AST_RQ_H

#include "compiler/syntax/ast.h"

typedef enum AstRequirementKind {
    AST_NEVER,                // never a
    AST_ALWAYS,               // always a
    AST_NEVER_BEFORE,         // never a before b
    AST_NEVER_AFTER,          // never a after b without c
    AST_LEADS_TO              // always a leads to b within t
} AstRequirementKind;

typedef struct AstRequirement {
    AstRequirementKind kind;
    Str id, text;
    Span id_span;
    Span span;                // the whole line
    AstExpr *a, *b, *c;       // the conditions; for NEVER_BEFORE and NEVER_AFTER each is the name of a state, or is in parentheses
    AstExpr *within;          // LEADS_TO: the time limit
} AstRequirement;

typedef struct AstRequirements {
    VEC(AstRequirement) at;   // in file order
    bool lost;                // an error has been reported: a requirement can be missing
} AstRequirements;

#endif
