// SPDX-License-Identifier: Apache-2.0
// Prints the syntax tree, for --emit=ast and for tests. Each section and statement is one line, indented below its owner; each expression
// is on one line with every operation in parentheses.
#include <string.h>

#include "compiler/syntax/ast_app.h"
#include "compiler/syntax/ast_net.h"
#include "compiler/syntax/ast_rq.h"

static void print_stmts(Buf *out, const AstStmts *s, unsigned depth);

static void print_line_start(Buf *out, unsigned depth) { buf_spaces(out, depth * 2); }

// ---- expressions ----

static void print_name(Buf *out, Str name) { buf_put(out, name ? name->text : "?", name ? name->len : 1); }

// Prints the source text unchanged, so that the dump shows how a literal was written.
static void print_source(Buf *out, Span span) { buf_put(out, span.src->text + span.at, span.len); }

static void print_expr(Buf *out, const AstExpr *e)
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
        print_source(out, e->span);
        break;
    case AST_NAME:
        print_name(out, e->name);
        break;
    case AST_UNARY:
        buf_printf(out, "(%s ", sm_op_info[e->op].spelling);
        print_expr(out, e->a);
        buf_char(out, ')');
        break;
    case AST_BINARY:
        buf_char(out, '(');
        print_expr(out, e->a);
        buf_printf(out, " %s ", sm_op_info[e->op].spelling);
        print_expr(out, e->b);
        buf_char(out, ')');
        break;
    case AST_PAREN:
        buf_str(out, "(paren ");
        print_expr(out, e->a);
        buf_char(out, ')');
        break;
    case AST_STATE_NAME:
        buf_str(out, "state ");
        print_name(out, e->name);
        break;
    case AST_WHEN:
        print_source(out, ast_op_span(e));
        buf_char(out, ' ');
        print_expr(out, e->a);
        buf_str(out, e->b ? " to " : "");
        if (e->b)
            print_expr(out, e->b);
        break;
    case AST_IMPLIES:
        buf_char(out, '(');
        print_expr(out, e->a);
        buf_str(out, " implies ");
        print_expr(out, e->b);
        buf_char(out, ')');
        break;
    case AST_STEPS:
        print_expr(out, e->a);
        buf_str(out, " steps");
        break;
    case AST_CALL:
        print_name(out, e->name);
        buf_char(out, '(');
        for (size_t i = 0; i < e->args->n; i++) {
            buf_str(out, i ? ", " : "");
            print_expr(out, e->args->at[i]);
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

static void print_annotation(Buf *out, const AstAnnotation *a)
{
    buf_printf(out, "@%s", annotation_words[a->kind]);
    if (a->kind == AST_ALLOW) {
        buf_printf(out, "(%s, \"%s\")", a->name->text, a->reason->text);
    } else if (a->kind == AST_RANGE) {
        buf_char(out, ' ');
        print_source(out, a->lo.span);
        buf_char(out, ' ');
        print_source(out, a->hi.span);
    } else if (a->lo.span.src) {
        buf_char(out, ' ');
        print_source(out, a->lo.span);
    } else if (a->kind == AST_EXCEPT) {
        for (size_t i = 0; i < a->names->at.n; i++) {
            buf_char(out, ' ');
            print_name(out, a->names->at.at[i]);
        }
    } else if (a->name) {
        buf_char(out, ' ');
        print_name(out, a->name);
    }
}

static void print_annotations(Buf *out, const AstAnnotations *all)
{
    for (size_t i = 0; i < all->n; i++) {
        buf_char(out, ' ');
        print_annotation(out, &all->at[i]);
    }
}

// ---- statements ----

// Prints the marks of a statement, and ends its line.
static void end_stmt(Buf *out, const AstStmt *s)
{
    for (size_t i = 0; s->marks && i < s->marks->at.n; i++)
        buf_printf(out, " @req %s", s->marks->at.at[i]->text);
    buf_char(out, '\n');
}

// Prints the text and the requirement of an item of a script; r can be NULL.
static void print_remark(Buf *out, const AstRemark *r)
{
    if (r && r->text)
        buf_printf(out, " \"%s\"", r->text->text);
    if (r && r->requirement)
        buf_printf(out, " @req %s", r->requirement->text);
}

// Prints an @fail, @expect or @print.
static void print_item(Buf *out, const AstStmt *s)
{
    buf_str(out, s->kind == AST_FAIL ? "@fail" : s->kind == AST_EXPECT ? "@expect " : "@print ");
    if (s->value)
        print_expr(out, s->value);
    if (s->kind == AST_EXPECT && s->remark->within) {
        buf_str(out, " within ");
        print_expr(out, s->remark->within);
    }
    for (size_t i = 0; i < s->remark->values.n; i++) {
        buf_str(out, i ? ", " : "");
        print_expr(out, s->remark->values.at[i]);
    }
    print_remark(out, s->remark);
}

static void print_stmt(Buf *out, const AstStmt *s, unsigned depth)
{
    print_line_start(out, depth);
    switch (s->kind) {
    case AST_STMT_ERROR:
        buf_str(out, "error\n");
        break;
    case AST_ASSIGN:
        print_name(out, s->name);
        buf_str(out, " = ");
        print_expr(out, s->value);
        end_stmt(out, s);
        break;
    case AST_TRANSITION:
        buf_str(out, "-> ");
        print_name(out, s->name);
        end_stmt(out, s);
        break;
    case AST_ALLOWED:
        print_annotation(out, s->allow);
        buf_char(out, '\n');
        break;
    case AST_IF:
        buf_str(out, "if ");
        print_expr(out, s->value);
        buf_str(out, s->arms->braces ? " {}" : " :");
        end_stmt(out, s);
        print_stmts(out, &s->arms->then, depth + 1);
        if (!s->arms->has_else)
            break;
        print_line_start(out, depth);
        buf_str(out, s->arms->else_braces ? "else {}\n" : "else :\n");
        print_stmts(out, &s->arms->otherwise, depth + 1);
        break;
    case AST_ASSERT:
        buf_str(out, "@assert ");
        print_expr(out, s->value);
        print_remark(out, s->remark);
        buf_char(out, '\n');
        break;
    case AST_STOP:
        buf_str(out, "@stop\n");
        break;
    case AST_FAIL: case AST_EXPECT: case AST_PRINT:
        print_item(out, s);
        buf_char(out, '\n');
        break;
    }
}

static void print_stmts(Buf *out, const AstStmts *s, unsigned depth)
{
    for (size_t i = 0; i < s->n; i++)
        print_stmt(out, s->at[i], depth);
}

// ---- sections ----

static void print_decl(Buf *out, const AstDecl *d)
{
    buf_printf(out, "  %s ", d->type < SM_TYPE_COUNT ? sm_type_info[d->type].spelling : "?");
    print_name(out, d->name);
    if (d->value) {
        buf_str(out, " = ");
        print_expr(out, d->value);
    }
    print_annotations(out, &d->annotations);
    buf_char(out, '\n');
}

static void print_option(Buf *out, const AstOption *o)
{
    buf_str(out, "  ");
    print_name(out, o->name);
    if (o->number || o->word) {
        buf_char(out, ' ');
        if (o->number && o->word)
            buf_printf(out, "%s ", o->word->text);
        print_source(out, o->value_span);
    }
    buf_char(out, '\n');
}

static void print_pin(Buf *out, const AstPin *p)
{
    buf_printf(out, "  %s ", p->output ? "o" : "i");
    print_source(out, p->number.span);
    buf_char(out, ' ');
    print_name(out, p->element);
    print_annotations(out, &p->annotations);
    buf_char(out, '\n');
}

static void print_definition(Buf *out, const AstDefinition *d)
{
    buf_str(out, "  ");
    print_name(out, d->name);
    buf_str(out, " = ");
    print_expr(out, d->value);
    buf_char(out, '\n');
}

static void print_data_setting(Buf *out, const AstDataSetting *s)
{
    buf_str(out, "  ");
    print_name(out, s->word);
    if (s->text) {
        buf_char(out, ' ');
        print_source(out, s->text_span);
    }
    if (s->value) {
        buf_char(out, ' ');
        print_name(out, s->value);
    }
    buf_char(out, '\n');
}

static void print_data_line(Buf *out, const AstDataLine *line)
{
    buf_str(out, line->is_compare ? "  @compare " : "  ");
    print_name(out, line->element);
    buf_str(out, line->is_compare ? " " : " = ");
    print_source(out, line->column_span);
    if (line->tolerance.span.src) {
        buf_str(out, " tolerance ");
        print_source(out, line->tolerance.span);
    }
    if (line->delay) {
        buf_str(out, " delay ");
        print_source(out, line->delay->span);
    }
    print_annotations(out, &line->annotations);
    buf_char(out, '\n');
}

static void print_data(Buf *out, const AstData *d)
{
    for (int i = 0; i < AST_DATA_SLOTS; i++)
        if (d->setting[i].word)
            print_data_setting(out, &d->setting[i]);
    for (size_t i = 0; i < d->line.n; i++)
        print_data_line(out, &d->line.at[i]);
}

static void print_section(Buf *out, const AstSection *s)
{
    static const char *const kind[] = {
        [AST_STATE_VECTOR] = "state_vector", [AST_LOCAL] = "local", [AST_DEFINE] = "define", [AST_OPTIONS] = "options", [AST_REGION] = "region",
        [AST_STATE] = "state", [AST_DATA] = "data", [AST_ALL_STATES] = "all", [AST_SCRIPT_STATE] = "script", [AST_PINS] = "pins",
        [AST_IGNORED] = "ignored"};
    static const char *const label[AST_LABEL_COUNT] = {".entry", ".step", ".exit"};

    buf_printf(out, "%s ", kind[s->kind]);
    print_name(out, s->name);
    print_annotations(out, &s->annotations);
    buf_char(out, '\n');
    for (size_t i = 0; i < s->decls.n; i++)
        print_decl(out, &s->decls.at[i]);
    for (size_t i = 0; i < s->definitions.n; i++)
        print_definition(out, &s->definitions.at[i]);
    for (size_t i = 0; i < s->options.n; i++)
        print_option(out, &s->options.at[i]);
    if (s->data)
        print_data(out, s->data);
    for (size_t i = 0; i < s->pins.n; i++)
        print_pin(out, &s->pins.at[i]);
    for (int i = 0; i < AST_LABEL_COUNT; i++)
        if (s->block[i].present) {
            buf_printf(out, "  %s\n", label[i]);
            print_stmts(out, &s->block[i].stmts, 2);
        }
    print_stmts(out, &s->items, 1);
}

// Prints a word and an operand after it, if there is one.
static void print_operand(Buf *out, const char *word, const AstExpr *e)
{
    if (!e)
        return;
    buf_str(out, word);
    print_expr(out, e);
}

static void print_requirement(Buf *out, const AstRequirement *r)
{
    const bool after = r->kind == AST_NEVER_AFTER;

    buf_printf(out, "%s \"%s\" %s ", r->id->text, r->text->text, r->kind == AST_ALWAYS || r->kind == AST_LEADS_TO ? "always" : "never");
    print_expr(out, r->a);
    print_operand(out, after ? " after " : r->kind == AST_LEADS_TO ? " leads to " : " before ", r->b);
    print_operand(out, " without ", r->c);
    print_operand(out, " within ", r->within);
    buf_char(out, '\n');
}

void ast_print(const AstFile *f, Buf *out)
{
    for (size_t i = 0; i < f->includes.n; i++) {
        buf_str(out, "include ");
        print_source(out, f->includes.at[i].span);
        buf_char(out, '\n');
    }
    for (size_t i = 0; i < f->sections.n; i++)
        print_section(out, f->sections.at[i]);
    if (f->app)
        ast_print_app(f->app, out);
    if (f->net)
        ast_print_net(f->net, out);
    for (size_t i = 0; f->requirements && i < f->requirements->at.n; i++)
        print_requirement(out, &f->requirements->at.at[i]);
}
