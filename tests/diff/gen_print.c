// SPDX-License-Identifier: Apache-2.0
// Prints a program tree in any form that the grammar allows: with a colon or braces, with or without `if`, on one or more lines, with needless
// parentheses, comments and blanks.  The random choices never change the meaning of the program.
#include "tests/diff/gen.h"

#include <string.h>

typedef struct Printer {
    Gen *g;
    Buf *out;
    Rng rng;
    Rng units;                // random numbers for units alone, so that a program without units is printed the same
    uint32_t indent;
    uint32_t parens;          // number of enclosing ( )
    bool crlf;
} Printer;

static bool chance(Printer *p, uint32_t percent) { return rng_percent(&p->rng, percent) && !p->g->plain; }

static void put(Printer *p, const char *text) { buf_str(p->out, text); }

// Appends an @unit to half of the declarations, in half of the programs with additions. It is any unit, so that most values do not fit.  Only
// the unit of a parameter is in an image, so that it belongs to the program written out by hand as well.
static void print_unit(Printer *p, SmType type, bool is_parameter)
{
    static const char *const unit[] = {
        "m", "ft", "km", "m/s", "m/s^2", "s", "ms", "us", "bar", "psi", "Pa", "degC", "degF", "K", "deg", "rad", "percent", "1", "gn", "N", "lbf", "kg",
        "J/(kg*K)", "V/Hz^0.5", "rpm", "Hz", "furlong",
    };
    const uint32_t which = rng_below(&p->units, sizeof unit / sizeof *unit);
    if (!rng_percent(&p->units, 50) || !p->g->units || (p->g->by_hand && !is_parameter) || type == SM_BOOL)
        return;
    buf_printf(p->out, " @unit %s", unit[which]);
    p->g->units_printed++;
}

static void comment(Printer *p)
{
    static const char *const text[] = {
        "", " a comment", " x = 1 }", " -> Nowhere", " 20 \xC2\xB0" "C", "# [no] \"header\" {",
    };
    put(p, "#");
    put(p, text[rng_below(&p->rng, sizeof text / sizeof *text)]);
}

static void line_end(Printer *p)
{
    if (chance(p, 6)) {
        put(p, "  ");
        comment(p);
    }
    put(p, p->crlf ? "\r\n" : "\n");
    if (chance(p, 5))
        put(p, p->crlf ? "\t\r\n" : "\n");
}

static void margin(Printer *p)
{
    if (chance(p, 4))
        return;
    for (uint32_t i = 0; i < p->indent; i++)
        put(p, chance(p, 3) ? "\t" : "    ");
}

// Prints what separates two tokens: mostly a blank, and inside parentheses sometimes a line end.
static void gap(Printer *p)
{
    if (p->parens > 0 && chance(p, 2)) {
        line_end(p);
        return;
    }
    if (!chance(p, 15) || p->g->plain)
        put(p, chance(p, 5) ? "  " : " ");
}

// ---- expressions ----

// Returns the level of precedence in the language reference, lowest first: or, and, equality, relation, sum, product, sign.
static int level_of(const GExpr *e)
{
    if (e->kind == G_NUMBER)
        return e->text[0] == '-' ? 7 : 8;
    if (e->kind == G_CHAIN)
        return 4;
    if (e->kind == G_UNARY)
        return 7;
    if (e->kind != G_BINARY)
        return 8;
    switch (e->op) {
    case SM_OP_OR: return 1;
    case SM_OP_AND: return 2;
    case SM_OP_EQ: case SM_OP_NE: return 3;
    case SM_OP_LT: case SM_OP_LE: case SM_OP_GT: case SM_OP_GE: return 4;
    case SM_OP_ADD: case SM_OP_SUB: return 5;
    case SM_OP_MUL: case SM_OP_DIV: return 6;
    case SM_OP_NOT: case SM_OP_NEG: case SM_OP_PLUS: case SM_OP_COUNT: break;
    }
    return 8;
}

static const char *op_text(Printer *p, SmOperator op)
{
    static const char *const text[SM_OP_COUNT] = {
        "or", "and", "==", "!=", "<", "<=", ">", ">=", "+", "-", "*", "/", "not ", "-", "+",
    };
    return op == SM_OP_NOT && chance(p, 30) ? "!" : text[op];
}

static void print_expr(Printer *p, const GExpr *e, int at_least);

static void print_binary_op(Printer *p, SmOperator op)
{
    const bool word = op == SM_OP_OR || op == SM_OP_AND;
    if (word)
        put(p, " ");
    gap(p);
    put(p, op_text(p, op));
    if (word)
        put(p, " ");
    gap(p);
}

// Operators of one level associate to the left, so that the right operand must be of a higher level.  For relations and equality the left
// operand must be, too: otherwise the result would be a chain.
static void print_binary(Printer *p, const GExpr *e)
{
    const int level = level_of(e);
    print_expr(p, e->arg[0], level == 3 || level == 4 ? level + 1 : level);
    print_binary_op(p, e->op);
    print_expr(p, e->arg[1], level + 1);
}

static void print_chain(Printer *p, const GExpr *e)
{
    print_expr(p, e->arg[0], 5);
    for (uint32_t i = 1; i < e->n; i++) {
        print_binary_op(p, e->ops[i - 1]);
        print_expr(p, e->arg[i], 5);
    }
}

static void print_bare(Printer *p, const GExpr *e);

static void print_call(Printer *p, const GExpr *e)
{
    put(p, sm_builtin_info[e->fn].name);
    if (chance(p, 3))
        put(p, " ");
    put(p, "(");
    p->parens++;
    for (uint32_t i = 0; i < e->n; i++) {
        if (i > 0) {
            put(p, ",");
            gap(p);
        }
        const uint32_t samples = p->g->by_hand && e->kind == G_ROLL && i == 1 ? gen_samples_in_time(e->arg[1]) : 0;
        if (samples != 0)
            buf_printf(p->out, "%u", (unsigned)samples);
        else if (e->arg[i]->kind == G_STEPS)
            print_bare(p, e->arg[i]);        // the printer never adds parentheses here
        else
            print_expr(p, e->arg[i], 1);
    }
    p->parens--;
    put(p, ")");
}

static void print_defined(Printer *p, const GDef *d)
{
    if (!p->g->by_hand) {
        put(p, d->name);
        return;
    }
    put(p, "(");
    p->parens++;
    print_expr(p, d->value, 1);
    p->parens--;
    put(p, ")");
}

// Returns the state, or the first remaining state if the reducer has removed it.
static const GState *left_state(const Gen *g, const GState *s)
{
    for (size_t i = 0; s->removed && i < g->state.n; i++)
        s = g->state.at[i]->removed ? s : g->state.at[i];
    return s;
}

static void print_state_name(Printer *p, const GState *s)
{
    uint32_t i = 0;
    s = left_state(p->g, s);
    while (p->g->state.at[i] != s)
        i++;
    if (p->g->by_hand)
        buf_printf(p->out, "%u", (unsigned)gen_state_number(p->g, i));
    else
        put(p, s->name);
}

static void print_steps(Printer *p, const GExpr *e)
{
    print_bare(p, e->arg[0]);
    if (!p->g->by_hand)
        put(p, chance(p, 10) ? "  steps" : " steps");
}

static void print_bare(Printer *p, const GExpr *e)
{
    switch (e->kind) {
    case G_NUMBER: put(p, e->text); break;
    case G_VAR: put(p, e->by_alias && e->var->alias != NULL ? e->var->alias : e->var->name); break;
    case G_TIME: put(p, "T"); break;
    case G_UNARY: put(p, op_text(p, e->op)); print_expr(p, e->arg[0], 7); break;
    case G_BINARY: print_binary(p, e); break;
    case G_CHAIN: print_chain(p, e); break;
    case G_CALL: case G_ROLL: print_call(p, e); break;
    case G_DEFINED: print_defined(p, e->def); break;
    case G_STATE: print_state_name(p, e->state); break;
    case G_SPAN: put(p, p->g->by_hand ? e->text : e->span); break;
    case G_STEPS: print_steps(p, e); break;
    }
}

static void print_expr(Printer *p, const GExpr *e, int at_least)
{
    const bool parens = level_of(e) < at_least || chance(p, 6);
    if (!parens) {
        print_bare(p, e);
        return;
    }
    put(p, "(");
    p->parens++;
    gap(p);
    print_bare(p, e);
    gap(p);
    p->parens--;
    put(p, ")");
}

// ---- statements ----

static void print_stmt(Printer *p, const GStmt *s);

static void print_stmts(Printer *p, const GStmts *list)
{
    for (size_t i = 0; i < list->n; i++) {
        margin(p);
        print_stmt(p, list->at[i]);
        if (list->at[i]->kind == G_IF && p->out->at[p->out->n - 1] == '}' && i + 1 < list->n && chance(p, 10))
            put(p, " ");      // another statement may follow the } on the same line
        else
            line_end(p);
    }
}

static void print_braces(Printer *p, const GStmts *list)
{
    if (chance(p, 10)) {
        line_end(p);
        margin(p);
    } else {
        put(p, " ");
    }
    put(p, "{");
    if (list->n == 1 && list->at[0]->kind != G_IF && chance(p, 20)) {
        put(p, " ");
        print_stmt(p, list->at[0]);
        put(p, " }");
        return;
    }
    line_end(p);
    p->indent++;
    print_stmts(p, list);
    p->indent--;
    margin(p);
    put(p, "}");
}

// Prints one statement after a colon, or braces.  A conditional after the colon would take the `else` that follows, so it gets braces.
static void print_body(Printer *p, const GStmts *list, bool else_follows)
{
    const bool colon = list->n == 1 && !(else_follows && list->at[0]->kind == G_IF) && chance(p, 75);
    if (!colon) {
        print_braces(p, list);
        return;
    }
    put(p, chance(p, 5) ? " : " : ": ");
    print_stmt(p, list->at[0]);
}

static void print_else(Printer *p, const GStmts *list)
{
    if (chance(p, 12)) {
        put(p, " ");
    } else {
        line_end(p);
        margin(p);
    }
    put(p, "else");
    if (list->n == 1 && list->at[0]->kind == G_IF && chance(p, 60)) {
        put(p, " ");
        print_stmt(p, list->at[0]);
    } else {
        print_body(p, list, false);
    }
}

static bool ends_in_word_else(const Printer *p)
{
    return p->out->n >= 5 && memcmp(p->out->at + p->out->n - 5, "else ", 5) == 0;
}

static void print_if(Printer *p, const GStmt *s)
{
    if (ends_in_word_else(p) || chance(p, 50) || p->g->plain)
        put(p, "if ");
    print_expr(p, s->value, 1);
    print_body(p, &s->then, s->has_else);
    if (s->has_else)
        print_else(p, &s->otherwise);
}

static void print_stmt(Printer *p, const GStmt *s)
{
    switch (s->kind) {
    case G_ASSIGN:
        put(p, s->by_alias && s->var->alias != NULL ? s->var->alias : s->var->name);
        gap(p);
        put(p, "=");
        gap(p);
        print_expr(p, s->value, 1);
        break;
    case G_GOTO:
        put(p, chance(p, 10) ? "->" : "-> ");
        put(p, left_state(p->g, s->target)->name);
        break;
    case G_IF:
        print_if(p, s);
        break;
    }
}

// ---- sections ----

static bool excepts(const GRule *r, const GState *s)
{
    bool found = false;
    for (size_t i = 0; i < r->except.n && !found; i++)
        found = r->except.at[i] == s;
    return found;
}

// Collects the statements that .step of a state has when rules are written out by hand: those of the rules, then its own.
static bool by_hand_step(Printer *p, const GState *s, GStmts *out)
{
    const Gen *g = p->g;
    memset(out, 0, sizeof *out);
    for (size_t i = 0; i < g->rule.n; i++)
        for (size_t k = 0; k < g->rule.at[i]->block.n && !g->rule.at[i]->removed && !excepts(g->rule.at[i], s); k++)
            vec_push(g->arena, out, g->rule.at[i]->block.at[k]);
    for (size_t k = 0; k < s->block[1].n && s->present[1]; k++)
        vec_push(g->arena, out, s->block[1].at[k]);
    return out->n > 0 || s->present[1];
}

static void print_rule(Printer *p, const GRule *r)
{
    const char *before = " @except ";
    put(p, "[all_states]");
    for (size_t i = 0; i < r->except.n; i++)
        if (!r->except.at[i]->removed) {
            buf_printf(p->out, "%s%s", before, r->except.at[i]->name);
            before = " ";
        }
    line_end(p);
    put(p, ".step");
    line_end(p);
    print_stmts(p, &r->block);
}

static void print_state(Printer *p, const GState *s)
{
    static const char *const label[] = { ".entry", ".step", ".exit" };
    const uint32_t turn = rng_below(&p->rng, 3);
    GStmts step = s->block[1];
    const bool has_step = p->g->by_hand ? by_hand_step(p, s, &step) : s->present[1];
    buf_printf(p->out, "[%s]", s->name);
    line_end(p);
    for (uint32_t i = 0; i < 3; i++) {
        const uint32_t b = (i + (chance(p, 100) ? turn : 0)) % 3;      // the order of blocks is free
        if (b == 1 ? !has_step : !s->present[b])
            continue;
        const GStmts *list = b == 1 ? &step : &s->block[b];
        put(p, label[b]);
        if (list->n > 0 && chance(p, 5))
            put(p, " ");
        else
            line_end(p);
        print_stmts(p, list);
    }
}

static void print_options(Printer *p)
{
    static const char *const unit[UNIT_COUNT] = { "us", "ms", "s" };
    const Gen *g = p->g;
    if (g->step == 0 && g->unit == UNIT_MS && !g->writes_unit)
        return;
    put(p, "[options]");
    line_end(p);
    if (g->unit != UNIT_MS || g->writes_unit) {
        buf_printf(p->out, "time_unit %s", unit[g->unit]);
        line_end(p);
    }
    if (g->step != 0) {
        buf_printf(p->out, g->writes_unit ? "step %u %s" : "step %u", (unsigned)g->step, unit[g->unit]);
        line_end(p);
    }
}

static void print_definitions(Printer *p)
{
    bool open = false;
    for (size_t i = 0; i < p->g->def.n; i++) {
        const GDef *d = p->g->def.at[i];
        if (d->removed)
            continue;
        if (!open || chance(p, 15)) {
            put(p, "[define]");
            line_end(p);
            open = true;
        }
        margin(p);
        put(p, d->name);
        gap(p);
        put(p, "=");
        gap(p);
        print_expr(p, d->value, 1);
        print_unit(p, SM_F64, false);
        line_end(p);
    }
}

static void print_element(Printer *p, const GVar *v)
{
    margin(p);
    put(p, sm_type_info[v->type].spelling);
    put(p, chance(p, 10) ? "\t" : " ");
    put(p, v->name);
    if (v->alias != NULL)
        buf_printf(p->out, "  @alias %s", v->alias);
    if (v->read_only && v->id > 1)
        put(p, " @read_only");
    print_unit(p, v->type, false);
    if (chance(p, 10))
        put(p, " ");          // several entries of a list may share a line
    else
        line_end(p);
}

static void print_local(Printer *p, const GVar *v)
{
    margin(p);
    buf_printf(p->out, "%s %s = ", sm_type_info[v->type].spelling, v->name);
    print_expr(p, v->init, 1);
    if (v->parameter && v->type != SM_BOOL)
        buf_printf(p->out, " @parameter @range %.17g %.17g", v->lo, v->hi);
    else if (v->parameter)
        put(p, " @parameter");
    else if (v->read_only)
        put(p, " @read_only");
    print_unit(p, v->type, v->parameter);
    line_end(p);
}

static void start(Printer *p, Gen *g, Buf *out, uint64_t which)
{
    *p = (Printer){ .g = g, .out = out, .rng = { rng_mix(g->layout, which) }, .units = { rng_mix(g->layout, which + 100) } };
    p->crlf = chance(p, 10);
    if (chance(p, 3))
        put(p, "\xEF\xBB\xBF");
    p->indent = 1;
}

void gen_print_sm(Gen *g, Buf *out)
{
    Printer p;
    start(&p, g, out, 0);
    if (!g->by_hand)
        print_options(&p);
    put(&p, "[state_vector]");
    line_end(&p);
    bool local = false;
    for (size_t i = 0; i < g->order.n; i++) {
        const GVar *v = g->order.at[i];
        if (v->removed)
            continue;
        if (v->is_local && !local) {
            line_end(&p);
            put(&p, "[local]");
            line_end(&p);
            local = true;
        }
        (v->is_local ? print_local : print_element)(&p, v);
    }
    line_end(&p);
    if (!g->by_hand)
        print_definitions(&p);
    for (size_t i = 0; i < g->state.n; i++) {
        for (size_t r = 0; r < g->rule.n && !g->by_hand; r++)
            if (g->rule.at[r]->before == i && !g->rule.at[r]->removed)
                print_rule(&p, g->rule.at[r]);
        if (!g->state.at[i]->removed)
            print_state(&p, g->state.at[i]);
    }
}

void gen_print_inits(Gen *g, Buf *out)
{
    Printer p;
    g->by_hand = true;
    start(&p, g, out, 2);
    put(&p, "[state_vector]\nU64 G\nU32 S\n[local]\n");
    for (size_t i = 0; i < g->var.n; i++)
        if (g->var.at[i]->is_local && !g->var.at[i]->removed)
            buf_printf(out, "%s %s = 0\n", sm_type_info[g->var.at[i]->type].spelling, g->var.at[i]->name);
    put(&p, "[Only]\n.entry\n");
    for (size_t i = 0; i < g->var.n; i++)
        if (g->var.at[i]->is_local && !g->var.at[i]->removed) {
            buf_printf(out, "%s = ", g->var.at[i]->name);
            print_expr(&p, g->var.at[i]->init, 1);
            line_end(&p);
        }
    g->by_hand = false;
}

void gen_print_sv(Gen *g, Buf *out)
{
    Printer p;
    start(&p, g, out, 1);
    if (chance(&p, 20))
        put(&p, "[options]\nlock\n");
    for (uint32_t r = 0; r < g->regions; r++) {
        bool open = false;
        for (size_t i = 0; i < g->sv_order.n; i++) {
            const GVar *v = g->sv_order.at[i];
            if (v->region != r || v->removed)
                continue;
            if (!open)
                buf_printf(out, "[%s]\n", g->region_name[r]);
            open = true;
            buf_printf(out, chance(&p, 10) ? "%s %s " : "%s %s\n", sm_type_info[v->type].spelling, v->name);
        }
        if (open)
            line_end(&p);
    }
}
