// SPDX-License-Identifier: Apache-2.0
#include "compiler/script/watch.h"

#include <string.h>

enum { OPERANDS_MOST = 8 };           // the most operands of one leaf

// ---- the nodes of a statement ----

// The expression of a statement as a list of nodes, while it is built.
typedef struct Nodes {
    Arena *arena;
    VEC(WatchNode) node;
    uint32_t leaf;            // index of the leaf whose operands are being added
} Nodes;

bool watch_same_span(Span a, Span b) { return a.src == b.src && a.at == b.at && a.len == b.len; }

bool watch_is_relation(const Expr *e)
{
    if (e->kind != EX_BINARY)
        return e->kind == EX_CHAIN;
    return sm_op_info[e->op].op_class == SM_CLASS_RELATION || sm_op_info[e->op].op_class == SM_CLASS_EQUALITY;
}

// Whether the checker composed e from operations for one call in the source, such as rising(x): all parts of e then have the position of the call.
static bool is_composed(const Expr *e) { return e->n > 0 && watch_same_span(e->arg[e->n - 1]->span, e->span); }

static bool is_join(const Expr *e) { return e->kind == EX_BINARY && (e->op == SM_OP_AND || e->op == SM_OP_OR) && !is_composed(e); }

// Whether an expression is a comparison, `not`, or a combination of conditions by `and` or `or`.
static bool is_decision(const Expr *e)
{
    return is_join(e) || watch_is_relation(e) || (e->kind == EX_UNARY && e->op == SM_OP_NOT);
}

bool watch_is_run(const Expr *e) { return e->kind == EX_ROLL && (1u << e->stat & SM_STATS_OF_RUNS) != 0; }

const Expr *watch_held_run(const Expr *e)
{
    return e->kind == EX_BINARY && e->op == SM_OP_GE && watch_is_run(e->arg[0]) ? e->arg[0] : NULL;
}

static bool has_text_of(Span a, Span b)
{
    return a.len == b.len && a.src && b.src && memcmp(a.src->text + a.at, b.src->text + b.at, a.len) == 0;
}

// Whether the leaf or one of its operands has the same source as e, so that e needs no node.
static bool is_listed(const Nodes *n, const Expr *e)
{
    for (uint32_t i = n->leaf; i < n->node.n; i++)
        if (has_text_of(n->node.at[i].e->span, e->span))
            return true;
    return n->node.n - n->leaf > OPERANDS_MOST;
}

// Adds an expression to those whose values are recorded when the statement runs.
static void add_node(Nodes *n, const Expr *e, WatchKind kind, unsigned depth)
{
    const WatchNode node = {e, kind, (uint8_t)(depth < 255 ? depth : 255), (uint32_t)n->node.n + 1};

    vec_push(n->arena, &n->node, node);
}

// Adds the operands that explain the value of a leaf: the variables and calls in it, and the sides of comparisons; no calls inside another operand.
static void add_operands(Nodes *n, const Expr *e, unsigned depth, bool is_compared, bool in_call)
{
    // the number was written as the name of a definition
    const bool is_named = e->kind == EX_NUMBER && e->span.len && !strchr("0123456789.", e->span.src->text[e->span.at]);
    const bool explains = is_named || e->kind == EX_VAR || e->kind == EX_ROLL || is_compared || watch_held_run(e) || (e->kind == EX_CALL && !in_call);

    if (e->kind == EX_NUMBER && !is_named)
        return;
    if (watch_is_run(e) || (explains && !is_listed(n, e)))
        add_node(n, e, WATCH_OPERAND, depth);
    for (uint32_t i = 0; i < e->n && e->kind != EX_ROLL; i++)
        add_operands(n, e->arg[i], depth, watch_is_relation(e) && !is_composed(e) && !watch_held_run(e),
                     in_call || e->kind == EX_CALL || is_compared);
}

static void add_leaf(Nodes *n, const Expr *e, unsigned depth)
{
    n->leaf = (uint32_t)n->node.n;
    add_node(n, e, WATCH_LEAF, depth);
    add_operands(n, e, depth + 1, false, false);
}

// Adds the nodes of e.  `joined_by`: the operator of the node that has e as an operand: `a and b and c` becomes one node with three operands.
static void add_expression(Nodes *n, const Expr *e, unsigned depth, SmOperator joined_by)
{
    const uint32_t at = (uint32_t)n->node.n;

    if (is_join(e)) {
        if (joined_by != e->op)
            add_node(n, e, e->op == SM_OP_AND ? WATCH_AND : WATCH_OR, depth++);
        add_expression(n, e->arg[0], depth, e->op);
        add_expression(n, e->arg[1], depth, e->op);
        if (joined_by == e->op)
            return;                                   // no node was added for e itself, so node[at] belongs to its first operand
    } else if (e->kind == EX_UNARY && e->op == SM_OP_NOT && !is_composed(e) && is_join(e->arg[0])) {
        add_node(n, e, WATCH_NOT, depth);
        add_expression(n, e->arg[0], depth + 1, SM_OP_COUNT);
    } else {
        add_leaf(n, e, depth);
    }
    n->node.at[at].end = (uint32_t)n->node.n;
}

// ---- the statements of a machine ----

static void add_statements(Watch *w, Arena *arena, const Stmts *list, const WatchStmt *place);

static void add_statement(Watch *w, Arena *arena, const Stmt *stmt, const WatchStmt *place)
{
    WatchStmt *s = &w->stmt[stmt->number], inner;
    Nodes n = {.arena = arena};

    *s = *place;
    s->stmt = stmt;
    s->is_recorded = true;
    s->base = s->parent ? s->parent->base + s->parent->nodes : 0;
    if (stmt->value)
        add_expression(&n, stmt->value, 0, SM_OP_COUNT);
    s->node = n.node.at;
    s->nodes = (uint32_t)n.node.n;
    s->value = ARENA_ARRAY(arena, uint64_t, s->base + s->nodes);
    s->since = ARENA_ARRAY(arena, uint64_t, s->nodes);
    s->since_g = ARENA_ARRAY(arena, uint64_t, s->nodes);
    inner = *place;
    inner.parent = s;
    inner.in_else = false;
    add_statements(w, arena, &stmt->then, &inner);
    inner.in_else = true;
    add_statements(w, arena, &stmt->otherwise, &inner);
}

static void add_statements(Watch *w, Arena *arena, const Stmts *list, const WatchStmt *place)
{
    for (size_t i = 0; i < list->n; i++)
        add_statement(w, arena, list->at[i], place);
}

// ---- recording ----

static uint64_t bits_of(double x)
{
    uint64_t bits;

    memcpy(&bits, &x, sizeof bits);
    return bits;
}

double watch_number(const WatchStmt *s, const uint64_t *value, uint32_t i)
{
    const uint64_t bits = value[s->base + i];
    double x;

    if (s->node[i].e->kind == EX_VAR)
        return ref_read(s->node[i].e->var->type, bits);
    memcpy(&x, &bits, sizeof x);
    return x;
}

bool watch_truth(const WatchStmt *s, const uint64_t *value, uint32_t i) { return ref_true(watch_number(s, value, i)); }

bool watch_is_decision(const WatchStmt *s) { return s->stmt->kind == ST_IF || (s->nodes && is_decision(s->node[0].e)); }

// Returns the value of node i.  The values of the nodes after it must have been recorded.
static uint64_t evaluate_node(const WatchStmt *s, uint32_t i, const RefView *r)
{
    const WatchNode *n = &s->node[i];
    bool result = n->kind == WATCH_AND;

    if (n->kind == WATCH_LEAF || n->kind == WATCH_OPERAND)
        return n->e->kind == EX_VAR ? r->cell[n->e->var->index] : bits_of(ref_eval(n->e, r->cell, r->windows));
    if (n->kind == WATCH_NOT)
        return bits_of(!watch_truth(s, s->value, i + 1));
    for (uint32_t k = i + 1; k < n->end; k = s->node[k].end)
        result = n->kind == WATCH_AND ? result && watch_truth(s, s->value, k) : result || watch_truth(s, s->value, k);
    return bits_of(result);
}

// Records the values of the nodes of a statement, the last one first.
static void record_nodes(Watch *w, WatchStmt *s, const RefView *r)
{
    const bool continues = s->step && s->step == w->previous;

    for (uint32_t i = s->nodes; i-- > 0; ) {
        const bool was = continues && watch_truth(s, s->value, i);
        s->value[s->base + i] = evaluate_node(s, i, r);
        if (!continues || was != watch_truth(s, s->value, i)) {
            s->since[i] = w->step;
            s->since_g[i] = w->g;
        }
    }
}

// Records a transition that is taken, in a ring buffer of the last ones.
static void record_passage(Watch *w, const WatchStmt *s)
{
    WatchPassage *to = &w->passage[w->passages % w->passages_most];

    to->step = w->step;
    to->g = w->g;
    to->by = s;
    memcpy(to->value, s->value, (s->base + s->nodes) * sizeof *s->value);
    w->passages++;
}

// Called before each statement: records the values of its expressions, and since when each has been true or false.
static void watch_stmt(RefObserver *o, const RefView *r, const Stmt *stmt)
{
    Watch *w = (Watch *)o;
    WatchStmt *s = &w->stmt[stmt->number];

    if (!s->is_recorded && w->step < w->from)
        return;
    if (s->parent)
        memcpy(s->value, s->parent->value, s->base * sizeof *s->value);
    record_nodes(w, s, r);
    s->step = w->step;
    s->g = w->g;
    if (stmt->kind == ST_ASSIGN)
        w->stored_by[stmt->var->index] = s;
    if (stmt->kind == ST_TRANSITION && w->passages_most)
        record_passage(w, s);
}

static void watch_step(RefObserver *o, const RefView *r)
{
    Watch *w = (Watch *)o;

    w->previous = w->step;
    w->step = *w->steps + 1;
    w->g = r->g;
    w->state = r->state;
    w->is_first = r->is_first;
    if (r->is_first) {
        w->entered = w->step;
        w->entered_g = w->g;
    }
    w->last_run[r->state->number - 1] = w->step;
    w->last_run_g[r->state->number - 1] = w->g;
}

// ---- the watch ----

Watch *watch_new(Arena *arena, const Program *p, const uint64_t *steps, uint32_t passages_most)
{
    Watch *w = ARENA_NEW(arena, Watch);
    uint32_t most = 0;

    w->observer = (RefObserver){watch_step, watch_stmt};
    w->p = p;
    w->steps = steps;
    w->stmt = ARENA_ARRAY(arena, WatchStmt, p->stmts + 1);
    w->stored_by = ARENA_ARRAY(arena, WatchStmt *, p->var.n);
    w->last_run = ARENA_ARRAY(arena, uint64_t, p->state.n);
    w->last_run_g = ARENA_ARRAY(arena, uint64_t, p->state.n);
    for (size_t i = 0; i < p->state.n; i++)
        for (int b = 0; b < BLOCK_COUNT; b++) {
            const WatchStmt place = {.state = p->state.at[i], .block = (BlockKind)b};
            add_statements(w, arena, &p->state.at[i]->block[b], &place);
        }
    for (uint32_t i = 0; i <= p->stmts; i++)
        if (w->stmt[i].stmt && w->stmt[i].stmt->kind == ST_TRANSITION && most < w->stmt[i].base)
            most = w->stmt[i].base;
    w->passages_most = passages_most;
    w->passage = ARENA_ARRAY(arena, WatchPassage, passages_most);
    for (uint32_t i = 0; i < passages_most; i++)
        w->passage[i].value = ARENA_ARRAY(arena, uint64_t, most);
    return w;
}

void watch_restrict(Watch *w, const Var *const *stored, size_t n, uint64_t from)
{
    w->from = from;
    for (uint32_t i = 0; i <= w->p->stmts; i++)
        w->stmt[i].is_recorded = false;
    for (uint32_t i = 0; i <= w->p->stmts; i++)
        for (size_t k = 0; k < n && w->stmt[i].stmt; k++)
            if (w->stmt[i].stmt->kind == ST_ASSIGN && w->stmt[i].stmt->var == stored[k])
                for (const WatchStmt *s = &w->stmt[i]; s; s = s->parent)
                    w->stmt[s->stmt->number].is_recorded = true;
}

void watch_attach(Watch *w, Engine *ref) { engine_ref_observe(ref, &w->observer); }

const WatchPassage *watch_passage(const Watch *w, uint32_t i)
{
    return i < w->passages && i < w->passages_most ? &w->passage[(w->passages - 1 - i) % w->passages_most] : NULL;
}
