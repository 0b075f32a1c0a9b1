// SPDX-License-Identifier: Apache-2.0
// The syntax tree of a network configuration (.net) as written: endpoints and channels (docs/config.md 11). net.def lists the annotations.
// Lines with syntax errors have been reported and are missing in the tree.
#ifndef SMC_AST_NET_H
#define SMC_AST_NET_H

#include "compiler/syntax/ast_app.h"
#include "compiler/syntax/lex.h"

typedef enum AstNetAnnotationKind {
#define NET_ANNOTATION(name, takes, send, receive, part, example) AST_NET_##name,
#include "compiler/syntax/net.def"
    AST_NET_ANNOTATION_COUNT
} AstNetAnnotationKind;

typedef struct AstNetAnnotation {
    AstNetAnnotationKind kind;
    Span span;                // including its @ and its arguments
    AstWord word;             // the argument: an element, an address or a key; for @count the name of the counter
    AstWord element;          // for @count: the element that receives the counter
    AstAmount amount;         // for @timeout: the time; for @peers: the number
    AstNumber value;          // for @default and @safe: the value
    bool is_truth;            // `value` was written as true or false
} AstNetAnnotation;

typedef VEC(AstNetAnnotation) AstNetAnnotations;

// An element or a whole region between the braces.
typedef struct AstNetPart {
    bool is_region;           // the part is a whole region, written as [Region]
    AstWord name;
    AstNetAnnotations annotations;
} AstNetPart;

typedef enum AstNetSide { AST_NET_ON, AST_NET_TO, AST_NET_FROM } AstNetSide;

typedef struct AstNetChannel {
    bool is_send;
    AstWord name;
    AstAmount period;         // for a `send`: the time between two messages
    AstNetSide side;          // the word before the address
    Span side_span;
    bool is_tcp;
    AstWord where;            // the port, the address with its port, or the name of an endpoint, as written
    TokenKind where_kind;     // TOK_NUMBER: a port; TOK_ADDRESS: an address; TOK_NAME: an endpoint
    AstNetAnnotations annotations;
    VEC(AstNetPart) parts;
    Span braces;              // the opening brace
} AstNetChannel;

typedef struct AstNetEndpoint { AstWord name, address; } AstNetEndpoint;

typedef struct AstNet {
    VEC(AstNetEndpoint) endpoints;
    VEC(AstNetChannel) channels;
    bool lost;                // lines may be missing, because errors were reported
} AstNet;

const char *ast_net_annotation_name(AstNetAnnotationKind kind);
const AstNetAnnotation *ast_net_find(const AstNetAnnotations *all, AstNetAnnotationKind kind);      // NULL if it is absent
void ast_print_net(const AstNet *net, Buf *out);

#endif
