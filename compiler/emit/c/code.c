// SPDX-License-Identifier: Apache-2.0
// Writes an IR function as a C function: statements, and conditionals nested as in the source.  Where basic blocks do not nest, or nest deeper
// than compilers accept, it writes forward gotos.
#include <string.h>

#include "compiler/emit/c/fn.h"

enum {
    LINE_MAX_LEN = 110,       // in characters; longer statements continue on the next line
    INDENT_MAX = 40,          // greatest nesting level of the written code; deeper arms of conditionals are reached by gotos
    CHAIN_MAX = 60            // maximum of else-ifs in a chain; compilers count each as a nesting level
};

// ---- lines ----

static void write_indent(CFn *fn) { buf_spaces(&fn->body, 4u * fn->indent); }

// Whether `text` starts with a binary operator (not an assignment), `?` or `:`, followed by a space.
static bool is_operator_at(const char *text)
{
    if (text[1] == ' ')
        return strchr("&|+-*/<>?:", text[0]) != NULL;
    return text[1] != '\0' && text[2] == ' ' && strchr(text[1] == '=' ? "<>=!" : text[1] == text[0] ? "&|<>" : "", text[0]) != NULL;
}

// Returns the cost of a line break before `text`: 0 after a comma, otherwise lower for operators that bind less tightly.
static unsigned break_cost(const char *text)
{
    static const char *const order = "||&&?:=!<>+-*/";
    const char *at = text[-2] == ',' ? order : strchr(order, text[0]);

    return at ? (unsigned)(at - order) / 2 : 0;
}

// Returns the index of the best space at which to break `text` within `width`: the least nested in parentheses, then the one with the least
// cost, then the last.  0 if the text has no such space.
static size_t find_line_break(const char *text, size_t len, size_t width)
{
    size_t best = 0;
    unsigned depth = 0, least = 0;

    for (size_t i = 1; i + 1 < len && (i <= width || best == 0); i++) {
        depth += (text[i] == '(') - (unsigned)(text[i] == ')');
        if (text[i] == ' ' && (text[i - 1] == ',' || is_operator_at(text + i + 1))) {
            const unsigned r = depth * 8 + break_cost(text + i + 1);
            if (best == 0 || best < width / 3 || r <= least) {
                best = i;
                least = r;
            }
        }
    }
    return best;
}

// Appends the statement in fn->line to fn->body, on several lines if it is long, and empties fn->line.
void c_end_line(CFn *fn)
{
    const char *text = buf_text(&fn->line);
    size_t len = fn->line.n, at, width = LINE_MAX_LEN - 4u * fn->indent % 80;

    write_indent(fn);
    while (len > width && (at = find_line_break(text, len, width)) > 0) {
        buf_put(&fn->body, text, at);
        buf_char(&fn->body, '\n');
        write_indent(fn);
        buf_str(&fn->body, "    ");
        text += at + 1;
        len -= at + 1;
        width = LINE_MAX_LEN - 4 - 4u * fn->indent % 80;
    }
    buf_put(&fn->body, text, len);
    buf_char(&fn->body, '\n');
    fn->line.n = 0;
}

static void write_line(CFn *fn, const char *text)
{
    buf_str(&fn->line, text);
    c_end_line(fn);
}

// ---- statements ----

// Writes the definition of a C variable for temporary r; only an assignment if declarations are hoisted.
static void write_variable_definition(CFn *fn, IrRef r)
{
    const SmType type = c_ins(fn, r)->type;
    const char *name = format_in(fn->u->arena, type == SM_BOOL ? "test%u" : "value%u", ++fn->values);

    if (fn->hoist)
        buf_printf(&fn->declarations, "    %s %s;\n", c_type_of(fn->u, type), name);
    else
        buf_printf(&fn->line, "const %s ", c_type_of(fn->u, type));
    buf_printf(&fn->line, "%s = ", name);
    c_write_assigned(fn, r);
    buf_str(&fn->line, ";");
    c_end_line(fn);
    fn->ins[r].variable = name;
}

// Writes a store.  If stores are tracked, adds the element to fn->stored, for write_stored_flags.
static void write_store(CFn *fn, const IrIns *i)
{
    if (!soft_try_write_count(fn, i)) {
        c_write_member(fn, i->var);
        buf_str(&fn->line, " = ");
        c_write_assigned(fn, i->a);
    }
    buf_str(&fn->line, ";");
    c_end_line(fn);
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

// Writes the statements that record which elements the current block has stored: `m->stored.a = m->stored.b = true;`
static void write_stored_flags(CFn *fn)
{
    for (size_t i = 0; i < fn->stored.n; i++) {
        buf_printf(&fn->line, "m->stored.%s = ", fn->u->names.var[fn->stored.at[i]]);
        if (i + 1 == fn->stored.n || fn->line.n + 4u * fn->indent > 80)
            write_line(fn, "true;");
    }
    fn->stored.n = 0;
}

static void write_statements(CFn *fn, uint32_t b)
{
    const IrBlk *blk = &fn->f->blk.at[b];

    fn->block = ++*fn->block_stamps;
    for (size_t p = 0; p < blk->ins.n; p++) {
        const IrRef r = blk->ins.at[p];
        if (fn->ins[r].form == C_VARIABLE)
            write_variable_definition(fn, r);
        else if (fn->ins[r].form == C_STATEMENT && c_ins(fn, r)->op == IR_store)
            write_store(fn, c_ins(fn, r));
        else if (fn->ins[r].form == C_STATEMENT)
            c_write_sample(fn, c_ins(fn, r));
    }
    write_stored_flags(fn);
}

static bool has_statements(const CFn *fn, uint32_t b)
{
    const IrBlk *blk = &fn->f->blk.at[b];

    for (size_t p = 0; p < blk->ins.n; p++)
        if (fn->ins[blk->ins.at[p]].form == C_VARIABLE || fn->ins[blk->ins.at[p]].form == C_STATEMENT)
            return true;
    return false;
}

// ---- control flow ----

// How control reaches block `to` from a position in the C code after which block `next` follows.
typedef enum CEdge {
    EDGE_FALLS,               // control falls through: `to` is `next`
    EDGE_LEAVES,              // control leaves by a return or goto
    EDGE_IS_NESTED            // the code of `to` is written at this position
} CEdge;

// Whether b is the virtual block at the end of the function.
static bool is_end(const CFn *fn, uint32_t b) { return b == fn->flow.n - 1; }

// Returns how control reaches `to` from the current position in the C code, after which `next` follows.
static CEdge classify_edge(const CFn *fn, uint32_t to, uint32_t next)
{
    if (to == next)
        return EDGE_FALLS;
    return is_end(fn, to) || fn->flow.preds[to] > 1 ? EDGE_LEAVES : EDGE_IS_NESTED;
}

// Writes a goto to block `to`, or a return if it is the end of the function.
static void write_jump(CFn *fn, uint32_t to)
{
    if (is_end(fn, to)) {
        write_line(fn, fn->returns_state ? "return 0;" : "return;");
        return;
    }
    fn->label[to] = fn->labels_used = true;
    buf_printf(&fn->line, "goto L%u;", (unsigned)to);
    c_end_line(fn);
}

static void write_label(CFn *fn, uint32_t b)
{
    if (fn->label[b])
        buf_printf(&fn->body, "L%u:;\n", (unsigned)b);
}

static void write_dominated_blocks(CFn *fn, uint32_t b, uint32_t next);

// Writes one arm of a conditional, inside its braces: block `to` and the blocks that it dominates, or a jump to `to` if they are written
// elsewhere.  Writes nothing if control reaches `to` by falling through.
static void write_arm(CFn *fn, uint32_t to, uint32_t next)
{
    fn->indent++;
    if (classify_edge(fn, to, next) == EDGE_IS_NESTED)
        write_dominated_blocks(fn, to, next);
    else if (classify_edge(fn, to, next) == EDGE_LEAVES)
        write_jump(fn, to);
    fn->indent--;
}

// Writes `if (cond) {` after `before`.
static void write_if_head(CFn *fn, const char *before, IrRef cond, bool negated)
{
    buf_str(&fn->line, before);
    buf_str(&fn->line, "if (");
    c_write_condition(fn, cond, negated, PREC_ANY);
    buf_str(&fn->line, ") {");
    c_end_line(fn);
}

// Whether block b, the other arm of a conditional, consists of a conditional alone, so that it can be written as `else if`.
static bool can_be_else_if(const CFn *fn, uint32_t b, uint32_t next)
{
    return classify_edge(fn, b, next) == EDGE_IS_NESTED && c_is_branch(fn, b) && fn->flow.kid[b] == IR_NONE && !has_statements(fn, b) &&
           classify_edge(fn, fn->flow.then[b], next) != EDGE_FALLS;
}

// Writes the conditional that ends block b as `if … else if … else …`.  Control then continues at `next`.
static void write_if_else(CFn *fn, uint32_t b, uint32_t next)
{
    const CFlow *w = &fn->flow;
    unsigned links = 0;

    write_if_head(fn, "", fn->f->blk.at[b].jump.cond, false);
    for (;;) {
        write_arm(fn, w->then[b], next);
        if (w->other[b] == next || !can_be_else_if(fn, w->other[b], next) || ++links >= CHAIN_MAX)
            break;
        b = w->other[b];
        write_if_head(fn, "} else ", fn->f->blk.at[b].jump.cond, false);
    }
    if (w->other[b] != next) {
        write_line(fn, "} else {");
        write_arm(fn, w->other[b], next);
    }
    write_line(fn, "}");
}

// Writes the conditional that ends block b with the arm `to` alone.
static void write_if_without_else(CFn *fn, uint32_t b, uint32_t to, bool negated, uint32_t next)
{
    write_if_head(fn, "", fn->f->blk.at[b].jump.cond, negated);
    write_arm(fn, to, next);
    write_line(fn, "}");
}

// Whether the arm `to` is written inside the conditional and control can reach its end.
static bool may_fall_through(const CFn *fn, uint32_t to, uint32_t next)
{
    return classify_edge(fn, to, next) == EDGE_IS_NESTED && fn->flow.falls[to];
}

// Writes the conditional that ends block b as a goto to one arm, followed by the other arm, without a further nesting level.  Returns the block
// whose code follows.
static uint32_t write_deep_branch(CFn *fn, uint32_t b, uint32_t next)
{
    const uint32_t then = fn->flow.then[b], other = fn->flow.other[b];
    const bool swap = classify_edge(fn, then, next) != EDGE_IS_NESTED;
    const uint32_t aside = swap ? then : other, here = swap ? other : then;

    write_if_head(fn, "", fn->f->blk.at[b].jump.cond, !swap);
    fn->indent++;
    write_jump(fn, aside);
    fn->indent--;
    write_line(fn, "}");
    if (classify_edge(fn, aside, next) != EDGE_IS_NESTED)
        return here;
    write_dominated_blocks(fn, here, aside);
    write_label(fn, aside);
    return aside;
}

// Writes the conditional that ends block b.  Returns the block whose code follows at the same level, or IR_NONE.  If control never reaches the
// end of one arm, the other arm is written after the conditional instead of as its `else`.
static uint32_t write_branch(CFn *fn, uint32_t b, uint32_t next)
{
    const uint32_t then = fn->flow.then[b], other = fn->flow.other[b];
    const bool then_falls = classify_edge(fn, then, next) == EDGE_FALLS, other_falls = classify_edge(fn, other, next) == EDGE_FALLS;

    if (fn->indent >= INDENT_MAX)
        return write_deep_branch(fn, b, next);
    if (may_fall_through(fn, then, next) && may_fall_through(fn, other, next)) {
        write_if_else(fn, b, next);
        return IR_NONE;
    }
    if (then_falls || (may_fall_through(fn, then, next) && !other_falls)) {
        write_if_without_else(fn, b, other, true, next);
        return then;
    }
    write_if_without_else(fn, b, then, false, next);
    return other;
}

// Writes the statements of block b and how it ends, without the join blocks that it dominates.  Returns the block whose code follows at the
// same level, or IR_NONE.
static uint32_t write_block(CFn *fn, uint32_t b, uint32_t next)
{
    uint32_t to = fn->flow.then[b];

    write_statements(fn, b);
    if (fn->f->blk.at[b].jump.kind == IR_GOTO) {
        buf_printf(&fn->line, "return %s_STATE_%s;", fn->u->names.macro, fn->u->names.state[fn->f->blk.at[b].jump.state - 1]);
        c_end_line(fn);
        return IR_NONE;
    }
    if (c_is_branch(fn, b))
        to = write_branch(fn, b, next);
    if (to == IR_NONE || classify_edge(fn, to, next) == EDGE_IS_NESTED)
        return to;
    if (classify_edge(fn, to, next) == EDGE_LEAVES)
        write_jump(fn, to);
    return IR_NONE;
}

// Writes block b and all blocks that it dominates; control then falls through to `next`.
static void write_dominated_blocks(CFn *fn, uint32_t b, uint32_t next)
{
    while (!is_end(fn, b)) {
        uint32_t kid = fn->flow.kid[b];
        const uint32_t follows = write_block(fn, b, kid == IR_NONE ? next : kid);
        if (kid == IR_NONE && follows == IR_NONE)
            return;
        if (kid == IR_NONE) {
            b = follows;
            continue;
        }
        if (follows != IR_NONE)
            write_dominated_blocks(fn, follows, kid);
        for (; fn->flow.sibling[kid] != IR_NONE; kid = fn->flow.sibling[kid]) {
            write_label(fn, kid);
            write_dominated_blocks(fn, kid, fn->flow.sibling[kid]);
        }
        write_label(fn, kid);
        b = kid;
    }
    if (b != next)
        write_jump(fn, b);
}

// ---- functions ----

// Whether a reachable block ends in a transition.
static bool has_transition(const IrFn *f, const CFlow *w)
{
    for (size_t b = 0; b < f->blk.n; b++)
        if (w->reached[b] && f->blk.at[b].jump.kind == IR_GOTO)
            return true;
    return false;
}

// Writes the definitions of the C variables that hold copies of elements or of T.
static void write_copy_definitions(CFn *fn)
{
    for (size_t i = 0; i < fn->copied.n; i++) {
        const uint32_t v = fn->copied.at[i];
        const SmType as = fn->var[v].copy_type, type = fn->u->m->var.at[v].type;
        buf_printf(&fn->line, "const %s %s = ", c_type_of(fn->u, as), fn->var[v].copy);
        if (fn->u->m->var.at[v].space == IR_TIME) {
            c_write_time(fn);
            write_line(fn, ";");
            continue;
        }
        buf_printf(&fn->line, "%s(", helper_require(fn->u, as == SM_F32 ? "sm_no_nan_f32" : type == SM_F32 ? "sm_read_f32" : "sm_read_f64"));
        c_write_member(fn, v);
        write_line(fn, ");");
    }
}

// Writes all blocks into fn->body.  A second call discards what the first has written.
static void write_body(CFn *fn)
{
    fn->body.n = fn->declarations.n = 0;
    fn->values = 0;
    for (size_t i = 0; i < fn->f->ins.n; i++)
        fn->ins[i].variable = NULL;
    write_dominated_blocks(fn, 0, fn->returns_state ? IR_NONE : fn->flow.n - 1);
}

// Returns a CFn for writing f, with the facts, the control flow and the form of each instruction computed.
static CFn *prepare_function(CUnit *u, const IrFn *f, const Env *begin)
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
    lower_find_facts(fn, begin);
    flow_build(fn);
    lower_choose_forms(fn);
    fn->returns_state = has_transition(f, &fn->flow);
    return fn;
}

// Whether an empty line separates the declarations from the statements.
static bool needs_line_after_declarations(const CFn *fn, const Buf *copies)
{
    return (copies->n || fn->declarations.n) && strncmp(buf_text(&fn->body), "    const ", 10) != 0;
}

// Writes the function as a static C function.
CSignature c_write_function(CUnit *u, const CFunction *what, Buf *out)
{
    CFn *fn = prepare_function(u, what->f, what->begin);
    Buf copies;
    CSignature s;

    write_copy_definitions(fn);
    copies = fn->body;
    buf_init(&fn->body, u->arena);
    write_body(fn);
    if (fn->labels_used && fn->values > 0) {          // C++ does not allow a goto past an initialisation
        fn->hoist = true;
        write_body(fn);
    }
    s.returns_state = fn->returns_state;
    s.m = fn->uses_m;
    s.sv = fn->uses_sv;
    buf_printf(out, "%sstatic %s %s(", what->comment, s.returns_state ? c_state_type(u) : "void", what->name);
    buf_printf(out, "%s%s%s%s", s.m ? fn->writes_m ? "" : "const " : "", s.m ? u->names.type : "", s.m ? " *m" : "",
               s.m && s.sv ? ", " : "");
    buf_printf(out, "%s%s%s", s.sv ? fn->writes_sv ? "" : "const " : "", s.sv ? u->names.sv_type : "", s.sv ? " *sv" : "");
    buf_printf(out, "%s)\n{\n", s.m || s.sv ? "" : "void");
    if (what->f == u->m->sample)
        c_write_ring_steps(u, out);
    buf_printf(out, "%s%s%s", buf_text(&copies), buf_text(&fn->declarations), needs_line_after_declarations(fn, &copies) ? "\n" : "");
    buf_printf(out, "%s}\n\n", buf_text(&fn->body));
    return s;
}
