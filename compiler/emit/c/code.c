// SPDX-License-Identifier: Apache-2.0
// IR functions as C functions: statements, and conditionals nested as in the source.  Where blocks do not nest, or nest deeper than
// compilers accept, forward gotos are used.
#include <string.h>

#include "compiler/emit/c/fn.h"

enum {
    LINE_MAX_LEN = 110,       // longer lines are broken
    INDENT_MAX = 40,          // arms nested deeper are not indented further but reached by jumps
    CHAIN_MAX = 60            // maximum of else-ifs in a chain; compilers count each as a nesting level
};

// ---- lines ----

static void put_indent(CFn *fn) { buf_spaces(&fn->body, 4u * fn->indent); }

static bool starts_operator(const char *text)
{
    const bool comment = (text[0] == '/' && text[1] == '*') || (text[0] == '*' && text[1] == '/');

    return strchr("&|+-*/<>=!?:", text[0]) && (text[1] == ' ' || (text[1] && text[2] == ' ')) && !(text[0] == '=' && text[1] == ' ') && !comment;
}

// The cost of a break before the operator at `text`: lower for operators that bind less tightly.
static unsigned reluctance(const char *text)
{
    static const char *const order = "||&&?:=!<>+-*/";
    const char *at = text[-2] == ',' ? order : strchr(order, text[0]);

    return at ? (unsigned)(at - order) / 2 : 0;
}

// The best blank at which to break `text` within `width`: outermost first, then latest.  0 if there is none.
static size_t break_at(const char *text, size_t len, size_t width)
{
    size_t best = 0;
    unsigned depth = 0, least = 0;

    for (size_t i = 1; i + 1 < len && (i <= width || best == 0); i++) {
        depth += (text[i] == '(') - (unsigned)(text[i] == ')');
        if (text[i] == ' ' && (text[i - 1] == ',' || starts_operator(text + i + 1))) {
            const unsigned r = depth * 8 + reluctance(text + i + 1);
            if (best == 0 || best < width / 3 || r <= least) {
                best = i;
                least = r;
            }
        }
    }
    return best;
}

// Ends the current line and writes it, broken if it is too long.
void end_line(CFn *fn)
{
    const char *text = buf_text(&fn->line);
    size_t len = fn->line.n, at, width = LINE_MAX_LEN - 4u * fn->indent % 80;

    put_indent(fn);
    while (len > width && (at = break_at(text, len, width)) > 0) {
        buf_put(&fn->body, text, at);
        buf_char(&fn->body, '\n');
        put_indent(fn);
        buf_str(&fn->body, "    ");
        text += at + 1;
        len -= at + 1;
        width = LINE_MAX_LEN - 4 - 4u * fn->indent % 80;
    }
    buf_put(&fn->body, text, len);
    buf_char(&fn->body, '\n');
    fn->line.n = 0;
}

static void put_line(CFn *fn, const char *text)
{
    buf_str(&fn->line, text);
    end_line(fn);
}

// ---- statements ----


// Sets a new variable from r, with its declaration unless that must be at the top.
static void put_variable(CFn *fn, IrRef r)
{
    const SmType type = c_ins(fn, r)->type;
    const char *name = format_in(fn->u->arena, type == SM_BOOL ? "test%u" : "value%u", ++fn->values);

    if (fn->hoist)
        buf_printf(&fn->declarations, "    %s %s;\n", c_type_of(fn->u, type), name);
    else
        buf_printf(&fn->line, "const %s ", c_type_of(fn->u, type));
    buf_printf(&fn->line, "%s = ", name);
    put_assigned(fn, r);
    buf_str(&fn->line, ";");
    end_line(fn);
    fn->ins[r].variable = name;
}

static void put_store(CFn *fn, const IrIns *i)
{
    if (!soft_put_count(fn, i)) {
        put_cell(fn, i->var);
        buf_str(&fn->line, " = ");
        put_assigned(fn, i->a);
    }
    buf_str(&fn->line, ";");
    end_line(fn);
    if (fn->u->m->var.at[i->var].space != IR_ELEMENT) {
        fn->writes_m = true;
        return;
    }
    fn->writes_sv = true;
    if (!fn->u->track_stores || fn->var[i->var].flag_stamp == fn->block)
        return;
    fn->uses_m = fn->writes_m = true;
    fn->var[i->var].flag_stamp = fn->block;
    vec_push(fn->u->arena, &fn->stored, i->var);
}

// Records which elements the statements of a block have stored: `m->stored.a = m->stored.b = true;`
static void put_stored(CFn *fn)
{
    for (size_t i = 0; i < fn->stored.n; i++) {
        buf_printf(&fn->line, "m->stored.%s = ", fn->u->names.var[fn->stored.at[i]]);
        if (i + 1 == fn->stored.n || fn->line.n + 4u * fn->indent > 80)
            put_line(fn, "true;");
    }
    fn->stored.n = 0;
}

static void put_statements(CFn *fn, uint32_t b)
{
    const IrBlk *blk = &fn->f->blk.at[b];

    fn->block = ++*fn->block_stamps;
    for (size_t p = 0; p < blk->ins.n; p++) {
        const IrRef r = blk->ins.at[p];
        if (fn->ins[r].how == C_VARIABLE)
            put_variable(fn, r);
        else if (fn->ins[r].how == C_EFFECT && c_ins(fn, r)->op == IR_store)
            put_store(fn, c_ins(fn, r));
        else if (fn->ins[r].how == C_EFFECT)
            put_sample(fn, c_ins(fn, r));
    }
    put_stored(fn);
}

static bool has_statements(const CFn *fn, uint32_t b)
{
    const IrBlk *blk = &fn->f->blk.at[b];

    for (size_t p = 0; p < blk->ins.n; p++)
        if (fn->ins[blk->ins.at[p]].how == C_VARIABLE || fn->ins[blk->ins.at[p]].how == C_EFFECT)
            return true;
    return false;
}

// ---- control flow ----

// How control reaches block `to` from a point that falls through to `next`.
typedef enum Way {
    WAY_FALL,                 // by falling through
    WAY_LEAVE,                // by return or goto
    WAY_HERE                  // its code is written here and nowhere else
} Way;

static bool is_end(const CFn *fn, uint32_t b) { return b == fn->flow.n - 1; }

static Way way_to(const CFn *fn, uint32_t to, uint32_t next)
{
    if (to == next)
        return WAY_FALL;
    return is_end(fn, to) || fn->flow.preds[to] > 1 ? WAY_LEAVE : WAY_HERE;
}

static void put_leave(CFn *fn, uint32_t to)
{
    if (is_end(fn, to)) {
        put_line(fn, fn->returns_state ? "return 0;" : "return;");
        return;
    }
    fn->label[to] = fn->labels_used = true;
    buf_printf(&fn->line, "goto L%u;", (unsigned)to);
    end_line(fn);
}

static void put_label(CFn *fn, uint32_t b)
{
    if (fn->label[b])
        buf_printf(&fn->body, "L%u:;\n", (unsigned)b);
}

static void put_transition(CFn *fn, uint32_t state)
{
    buf_printf(&fn->line, "return %s_STATE_%s;", fn->u->names.macro, fn->u->names.state[state - 1]);
    end_line(fn);
}

static void put_tree(CFn *fn, uint32_t b, uint32_t next);

// One arm of a conditional, inside its braces.
static void put_arm(CFn *fn, uint32_t to, uint32_t next)
{
    fn->indent++;
    if (way_to(fn, to, next) == WAY_HERE)
        put_tree(fn, to, next);
    else if (way_to(fn, to, next) == WAY_LEAVE)
        put_leave(fn, to);
    fn->indent--;
}

static void put_if(CFn *fn, const char *before, IrRef cond, bool negated)
{
    buf_str(&fn->line, before);
    buf_str(&fn->line, "if (");
    put_condition(fn, cond, negated, PREC_ANY);
    buf_str(&fn->line, ") {");
    end_line(fn);
}

static bool is_two_way(const CFn *fn, uint32_t b) { return !is_end(fn, b) && fn->flow.other[b] != IR_NONE; }

// Whether block b is only a conditional, so that it can become an `else if`.
static bool is_chain_link(const CFn *fn, uint32_t b, uint32_t next)
{
    return way_to(fn, b, next) == WAY_HERE && is_two_way(fn, b) && fn->flow.kid[b] == IR_NONE && !has_statements(fn, b) &&
           way_to(fn, fn->flow.then[b], next) != WAY_FALL;
}

// if … else if … else …, where both arms continue at `next`.
static void put_if_else(CFn *fn, uint32_t b, uint32_t next)
{
    const CFlow *w = &fn->flow;
    unsigned links = 0;

    put_if(fn, "", fn->f->blk.at[b].jump.cond, false);
    for (;;) {
        put_arm(fn, w->then[b], next);
        if (w->other[b] == next || !is_chain_link(fn, w->other[b], next) || ++links >= CHAIN_MAX)
            break;
        b = w->other[b];
        put_if(fn, "} else ", fn->f->blk.at[b].jump.cond, false);
    }
    if (w->other[b] != next) {
        put_line(fn, "} else {");
        put_arm(fn, w->other[b], next);
    }
    put_line(fn, "}");
}

static void put_if_alone(CFn *fn, uint32_t b, uint32_t to, bool negated, uint32_t next)
{
    put_if(fn, "", fn->f->blk.at[b].jump.cond, negated);
    put_arm(fn, to, next);
    put_line(fn, "}");
}

static bool goes_on(const CFn *fn, uint32_t to, uint32_t next)
{
    return way_to(fn, to, next) == WAY_HERE && fn->flow.falls[to];
}

// Beyond the depth that compilers accept: arms are written one after the other, with jumps around them.
static uint32_t put_deep_branch(CFn *fn, uint32_t b, uint32_t next)
{
    const uint32_t then = fn->flow.then[b], other = fn->flow.other[b];
    const bool swap = way_to(fn, then, next) != WAY_HERE;
    const uint32_t aside = swap ? then : other, here = swap ? other : then;

    put_if(fn, "", fn->f->blk.at[b].jump.cond, !swap);
    fn->indent++;
    put_leave(fn, aside);
    fn->indent--;
    put_line(fn, "}");
    if (way_to(fn, aside, next) != WAY_HERE)
        return here;
    put_tree(fn, here, aside);
    put_label(fn, aside);
    return aside;
}

// Writes the conditional that ends block b.  Returns the block whose code follows at the same level, or IR_NONE.  If one arm never falls
// through, the other needs no `else`.
static uint32_t put_branch(CFn *fn, uint32_t b, uint32_t next)
{
    const uint32_t then = fn->flow.then[b], other = fn->flow.other[b];
    const bool then_falls = way_to(fn, then, next) == WAY_FALL, other_falls = way_to(fn, other, next) == WAY_FALL;

    if (fn->indent >= INDENT_MAX)
        return put_deep_branch(fn, b, next);
    if (goes_on(fn, then, next) && goes_on(fn, other, next)) {
        put_if_else(fn, b, next);
        return IR_NONE;
    }
    if (then_falls || (goes_on(fn, then, next) && !other_falls)) {
        put_if_alone(fn, b, other, true, next);
        return then;
    }
    put_if_alone(fn, b, then, false, next);
    return other;
}

// Writes block b, without the dominated blocks that follow it.  Returns the block that follows at the same level, or IR_NONE.
static uint32_t put_block(CFn *fn, uint32_t b, uint32_t next)
{
    uint32_t to = fn->flow.then[b];

    put_statements(fn, b);
    if (fn->f->blk.at[b].jump.kind == IR_GOTO) {
        put_transition(fn, fn->f->blk.at[b].jump.state);
        return IR_NONE;
    }
    if (is_two_way(fn, b))
        to = put_branch(fn, b, next);
    if (to == IR_NONE || way_to(fn, to, next) == WAY_HERE)
        return to;
    if (way_to(fn, to, next) == WAY_LEAVE)
        put_leave(fn, to);
    return IR_NONE;
}

// Writes block b and all blocks that it dominates; control then falls through to `next`.
static void put_tree(CFn *fn, uint32_t b, uint32_t next)
{
    while (!is_end(fn, b)) {
        uint32_t kid = fn->flow.kid[b];
        const uint32_t follows = put_block(fn, b, kid == IR_NONE ? next : kid);
        if (kid == IR_NONE && follows == IR_NONE)
            return;
        if (kid == IR_NONE) {
            b = follows;
            continue;
        }
        if (follows != IR_NONE)
            put_tree(fn, follows, kid);
        for (; fn->flow.sibling[kid] != IR_NONE; kid = fn->flow.sibling[kid]) {
            put_label(fn, kid);
            put_tree(fn, kid, fn->flow.sibling[kid]);
        }
        put_label(fn, kid);
        b = kid;
    }
    if (b != next)
        put_leave(fn, b);
}

// ---- functions ----

static bool makes_transition(const IrFn *f, const CFlow *w)
{
    for (size_t b = 0; b < f->blk.n; b++)
        if (w->reached[b] && f->blk.at[b].jump.kind == IR_GOTO)
            return true;
    return false;
}

static void put_copies(CFn *fn)
{
    for (size_t i = 0; i < fn->copied.n; i++) {
        const uint32_t v = fn->copied.at[i];
        const SmType as = fn->var[v].copy_type, type = fn->u->m->var.at[v].type;
        buf_printf(&fn->line, "const %s %s = ", c_type_of(fn->u, as), fn->var[v].copy);
        if (fn->u->m->var.at[v].space == IR_TIME) {
            put_time(fn);
            put_line(fn, ";");
            continue;
        }
        buf_printf(&fn->line, "%s(", helper_use(fn->u, as == SM_F32 ? "sm_no_nan_f32" : type == SM_F32 ? "sm_read_f32" : "sm_read_f64"));
        put_cell(fn, v);
        put_line(fn, ");");
    }
}

static void put_body(CFn *fn)
{
    fn->body.n = fn->declarations.n = 0;
    fn->values = 0;
    for (size_t i = 0; i < fn->f->ins.n; i++)
        fn->ins[i].variable = NULL;
    put_tree(fn, 0, fn->returns_state ? IR_NONE : fn->flow.n - 1);
}

static CFn *fn_new(CUnit *u, const IrFn *f, const Env *begin)
{
    CFn *fn = ARENA_NEW(u->arena, CFn);

    fn->u = u;
    fn->f = f;
    fn->ins = ARENA_ARRAY(u->arena, CIns, f->ins.n);
    fn->var = u->var_use;
    fn->window_sample = u->window_sample;
    fn->stamp = ++u->stamps;
    fn->block_stamps = &u->stamps;
    fn->label = ARENA_ARRAY(u->arena, bool, f->blk.n + 1);
    fn->indent = 1;
    buf_init(&fn->body, u->arena);
    buf_init(&fn->line, u->arena);
    buf_init(&fn->declarations, u->arena);
    plan_facts(fn, begin);
    flow_init(fn);
    plan_function(fn);
    fn->returns_state = makes_transition(f, &fn->flow);
    return fn;
}

static bool ends_declarations(const CFn *fn, const Buf *copies)
{
    return (copies->n || fn->declarations.n) && strncmp(buf_text(&fn->body), "    const ", 10) != 0;
}

CSignature put_function(CUnit *u, const CFunction *what, Buf *out)
{
    CFn *fn = fn_new(u, what->f, what->begin);
    Buf copies;
    CSignature s;

    put_copies(fn);
    copies = fn->body;
    buf_init(&fn->body, u->arena);
    put_body(fn);
    if (fn->labels_used && fn->values > 0) {          // C++ does not allow a goto past an initialisation
        fn->hoist = true;
        put_body(fn);
    }
    s.returns_state = fn->returns_state;
    s.m = fn->uses_m;
    s.sv = fn->uses_sv;
    buf_printf(out, "%sstatic %s %s(", what->comment, s.returns_state ? c_state_type(u) : "void", what->name);
    buf_printf(out, "%s%s%s%s", s.m ? fn->writes_m ? "" : "const " : "", s.m ? u->names.type : "", s.m ? " *m" : "",
               s.m && s.sv ? ", " : "");
    buf_printf(out, "%s%s%s", s.sv ? fn->writes_sv ? "" : "const " : "", s.sv ? u->names.sv_type : "", s.sv ? " *sv" : "");
    buf_printf(out, "%s)\n{\n", s.m || s.sv ? "" : "void");
    buf_printf(out, "%s%s%s", buf_text(&copies), buf_text(&fn->declarations), ends_declarations(fn, &copies) ? "\n" : "");
    buf_printf(out, "%s}\n\n", buf_text(&fn->body));
    return s;
}
