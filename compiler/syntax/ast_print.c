// SPDX-License-Identifier: Apache-2.0
// Prints the syntax tree, for --emit=ast and for tests. Each section and statement is one line, indented below its owner; each expression
// is on one line with every operation in parentheses.
#include <string.h>

#include "compiler/syntax/ast_app.h"

static void put_stmts(Buf *out, const AstStmts *s, unsigned depth);

static void put_line_start(Buf *out, unsigned depth) { buf_spaces(out, depth * 2); }

// ---- expressions ----

static void put_name(Buf *out, Str name) { buf_put(out, name ? name->text : "?", name ? name->len : 1); }

// Prints the source text unchanged, so that nothing is lost.
static void put_source(Buf *out, Span span) { buf_put(out, span.src->text + span.at, span.len); }

static void put_expr(Buf *out, const AstExpr *e)
{
    if (!e) {
        buf_str(out, "?");
        return;
    }
    switch (e->kind) {
    case AST_ERROR:
        buf_str(out, "error");
        break;
    case AST_NUMBER:
        put_source(out, e->span);
        break;
    case AST_NAME:
        put_name(out, e->name);
        break;
    case AST_UNARY:
        buf_printf(out, "(%s ", sm_op_info[e->op].spelling);
        put_expr(out, e->a);
        buf_char(out, ')');
        break;
    case AST_BINARY:
        buf_char(out, '(');
        put_expr(out, e->a);
        buf_printf(out, " %s ", sm_op_info[e->op].spelling);
        put_expr(out, e->b);
        buf_char(out, ')');
        break;
    case AST_PAREN:
        buf_str(out, "(paren ");
        put_expr(out, e->a);
        buf_char(out, ')');
        break;
    case AST_CALL:
        put_name(out, e->name);
        buf_char(out, '(');
        for (size_t i = 0; i < e->args->n; i++) {
            buf_str(out, i ? ", " : "");
            put_expr(out, e->args->at[i]);
        }
        buf_char(out, ')');
        break;
    }
}

// ---- annotations ----

static const char *const annotation_words[] = {
#define ANNOTATION(name, spelling, takes, where) spelling,
#include "compiler/syntax/annotations.def"
#undef ANNOTATION
};

static void put_annotation(Buf *out, const AstAnnotation *a)
{
    buf_printf(out, "@%s", annotation_words[a->kind]);
    if (a->kind == AST_ALLOW) {
        buf_printf(out, "(%s, \"%s\")", a->name->text, a->reason->text);
    } else if (a->kind == AST_RANGE) {
        buf_char(out, ' ');
        put_source(out, a->lo.span);
        buf_char(out, ' ');
        put_source(out, a->hi.span);
    } else if (a->lo.span.src) {
        buf_char(out, ' ');
        put_source(out, a->lo.span);
    } else if (a->name) {
        buf_char(out, ' ');
        put_name(out, a->name);
    }
}

static void put_annotations(Buf *out, const AstAnnotations *all)
{
    for (size_t i = 0; i < all->n; i++) {
        buf_char(out, ' ');
        put_annotation(out, &all->at[i]);
    }
}

// ---- statements ----

static void put_if(Buf *out, const AstStmt *s, unsigned depth)
{
    buf_str(out, "if ");
    put_expr(out, s->value);
    buf_str(out, s->arms->braces ? " {}\n" : " :\n");
    put_stmts(out, &s->arms->then, depth + 1);
    if (!s->arms->has_else)
        return;
    put_line_start(out, depth);
    buf_str(out, s->arms->else_braces ? "else {}\n" : "else :\n");
    put_stmts(out, &s->arms->otherwise, depth + 1);
}

static void put_stmt(Buf *out, const AstStmt *s, unsigned depth)
{
    put_line_start(out, depth);
    switch (s->kind) {
    case AST_STMT_ERROR:
        buf_str(out, "error\n");
        break;
    case AST_ASSIGN:
        put_name(out, s->name);
        buf_str(out, " = ");
        put_expr(out, s->value);
        buf_char(out, '\n');
        break;
    case AST_TRANSITION:
        buf_str(out, "-> ");
        put_name(out, s->name);
        buf_char(out, '\n');
        break;
    case AST_ALLOWED:
        put_annotation(out, s->allow);
        buf_char(out, '\n');
        break;
    case AST_IF:
        put_if(out, s, depth);
        break;
    case AST_ASSERT:
        buf_str(out, "@assert ");
        put_expr(out, s->value);
        buf_char(out, '\n');
        break;
    case AST_STOP:
        buf_str(out, "@stop\n");
        break;
    }
}

static void put_stmts(Buf *out, const AstStmts *s, unsigned depth)
{
    for (size_t i = 0; i < s->n; i++)
        put_stmt(out, s->at[i], depth);
}

// ---- sections ----

static void put_decl(Buf *out, const AstDecl *d)
{
    buf_printf(out, "  %s ", d->type < SM_TYPE_COUNT ? sm_type_info[d->type].spelling : "?");
    put_name(out, d->name);
    if (d->value) {
        buf_str(out, " = ");
        put_expr(out, d->value);
    }
    put_annotations(out, &d->annotations);
    buf_char(out, '\n');
}

static void put_option(Buf *out, const AstOption *o)
{
    buf_str(out, "  ");
    put_name(out, o->name);
    if (o->number || o->word) {
        buf_char(out, ' ');
        put_source(out, o->value_span);
    }
    buf_char(out, '\n');
}

static void put_pin(Buf *out, const AstPin *p)
{
    buf_printf(out, "  %s ", p->output ? "o" : "i");
    put_source(out, p->number.span);
    buf_char(out, ' ');
    put_name(out, p->element);
    put_annotations(out, &p->annotations);
    buf_char(out, '\n');
}

static void put_blocks(Buf *out, const AstSection *s)
{
    static const char *const label[AST_LABEL_COUNT] = {".entry", ".step", ".exit"};

    for (int i = 0; i < AST_LABEL_COUNT; i++)
        if (s->block[i].present) {
            buf_printf(out, "  %s\n", label[i]);
            put_stmts(out, &s->block[i].stmts, 2);
        }
}

static void put_section(Buf *out, const AstSection *s)
{
    static const char *const kind[] = {"state_vector", "local", "options", "region", "state", "script", "pins", "ignored"};

    buf_printf(out, "%s ", kind[s->kind]);
    put_name(out, s->name);
    put_annotations(out, &s->annotations);
    buf_char(out, '\n');
    for (size_t i = 0; i < s->decls.n; i++)
        put_decl(out, &s->decls.at[i]);
    for (size_t i = 0; i < s->options.n; i++)
        put_option(out, &s->options.at[i]);
    for (size_t i = 0; i < s->pins.n; i++)
        put_pin(out, &s->pins.at[i]);
    put_blocks(out, s);
    put_stmts(out, &s->items, 1);
}

void ast_print(const AstFile *f, Buf *out)
{
    for (size_t i = 0; i < f->sections.n; i++)
        put_section(out, f->sections.at[i]);
    if (f->app)
        ast_print_app(f->app, out);
}
