// SPDX-License-Identifier: Apache-2.0
// Computes the inputs that values depend on, with a graph whose nodes are the variables and the guards.  A local depends on the values
// stored in it and on the guards around those stores; a guard depends on the variables that it reads and on the enclosing guards.  Sets
// of inputs propagate along these edges to a fixed point.  A set has at most INPUT_DEPS_MAX sensors, so it grows only a few times.
#include "compiler/analysis/input_deps.h"

typedef VEC(uint32_t) NodeNumbers;

typedef struct DepGraph {
    InputDepsTable *s;
    NodeNumbers *readers;         // by node: the nodes that depend on this node
    NodeNumbers waiting;          // a stack of nodes whose readers are to be visited
    bool *waits;                  // by node: whether the node is in `waiting`
} DepGraph;

static uint32_t node_of_guard(const InputDepsTable *s, const Stmt *stmt) { return (uint32_t)s->a->p->var.n + stmt->number; }

// ---- roles of elements ----

static bool is_only_read(const InputDepsTable *s, const Var *v)
{
    return v->kind == VAR_ELEMENT && !v->written && v != s->a->p->g && v != s->a->p->s;
}

// Whether v is a numeric element that the machine only reads, and not a command, G or S.
bool is_sensor(const InputDepsTable *s, const Var *v) { return is_only_read(s, v) && v->type != SM_BOOL && !s->command[v->index]; }

typedef struct UseCount { uint32_t *reads, *equalities; } UseCount;     // by Var.index: number of reads; number of those in == or != with a constant

// Counts the reads of a variable, and its comparisons with constants by == and !=.
static void count_use(Expr *e, void *context)
{
    UseCount *u = context;

    if (e->kind == EX_VAR)
        u->reads[e->var->index]++;
    if (e->kind == EX_BINARY && (e->op == SM_OP_EQ || e->op == SM_OP_NE))
        for (int side = 0; side < 2; side++)
            if (e->arg[side]->kind == EX_VAR && expr_is_constant(e->arg[1 - side]))
                u->equalities[e->arg[side]->var->index]++;
}

static void count_uses(const Stmt *stmt, void *context)
{
    if (stmt->value)
        expr_walk(stmt->value, count_use, context);
}

// Whether the author marks commands: the machine or the state vector file has an @command (language.md 4.16).
static bool has_marked_commands(const Program *p)
{
    bool any = false;

    for (size_t i = 0; i < p->var.n && !any; i++)
        any = p->var.at[i]->command;
    for (size_t i = 0; i < p->sv->element.n && !any; i++)
        any = p->sv->element.at[i]->command;
    return any;
}

// Finds elements that are marked @command. Without any mark, integers that are only compared with constants by == and != are commands, too.
static void find_commands(InputDepsTable *s)
{
    const Program *p = s->a->p;
    UseCount u = {ARENA_ARRAY(s->a->arena, uint32_t, p->var.n), ARENA_ARRAY(s->a->arena, uint32_t, p->var.n)};

    s->marks_commands = has_marked_commands(p);
    each_stmt(p, count_uses, &u);
    for (size_t i = 0; i < p->var.n; i++) {
        const Var *v = p->var.at[i];
        const bool whole = sm_type_info[v->type].kind != SM_KIND_FLOAT && v->type != SM_BOOL;
        s->command[i] = v->command || (!s->marks_commands && whole && u.reads[i] > 0 && u.reads[i] == u.equalities[i]);
    }
}

// ---- sets ----

// Whether the inputs include this sensor.
bool input_deps_include(const InputDeps *l, const Var *sensor)
{
    for (uint32_t i = 0; i < l->n; i++)
        if (l->sensor[i] == sensor)
            return true;
    return false;
}

static void add_sensor(InputDeps *l, const Var *v)
{
    uint32_t i = l->n;

    if (input_deps_include(l, v))
        return;
    if (l->n == INPUT_DEPS_MAX) {
        l->more = true;
        return;
    }
    for (; i > 0 && l->sensor[i - 1]->index > v->index; i--)
        l->sensor[i] = l->sensor[i - 1];
    l->sensor[i] = v;
    l->n++;
}

// Adds the inputs of `from` to *to.  Returns whether *to has changed.
static bool merge_deps(InputDeps *to, const InputDeps *from)
{
    const InputDeps was = *to;

    for (uint32_t i = 0; i < from->n; i++)
        add_sensor(to, from->sensor[i]);
    to->more |= from->more;
    to->time |= from->time;
    to->input |= from->input;
    to->command |= from->command;
    to->other |= from->other;
    return to->n != was.n || to->more != was.more || to->time != was.time || to->input != was.input || to->command != was.command ||
           to->other != was.other;
}

// Returns the set of v's own inputs: v itself if it is an input, else the empty set.
static InputDeps deps_of_var(const InputDepsTable *s, const Var *v)
{
    InputDeps l = {.n = 0};

    if (v->kind == VAR_TIME || v == s->a->p->g)
        l.time = true;
    else if (is_sensor(s, v))
        add_sensor(&l, v);
    else if (is_only_read(s, v)) {
        l.input = true;
        l.command = !s->marks_commands || s->command[v->index];
    } else if (v->kind == VAR_ELEMENT)
        l.other = true;
    return l;
}

// ---- the graph ----

// Queues a variable or statement whose set of inputs has changed.
static void push_node(DepGraph *g, uint32_t node)
{
    if (g->waits[node])
        return;
    g->waits[node] = true;
    vec_push(g->s->a->arena, &g->waiting, node);
}

static void add_edge(DepGraph *g, uint32_t node, uint32_t reader) { vec_push(g->s->a->arena, &g->readers[node], reader); }

static void add_edges_from_vars(DepGraph *g, const Expr *e, uint32_t reader)
{
    for (uint32_t i = 0; i < e->n; i++)
        add_edges_from_vars(g, e->arg[i], reader);
    if (e->kind == EX_VAR && !e->var->is_constant)
        add_edge(g, e->var->index, reader);
}

// Adds the edges into the node that a statement determines: the variable that it assigns, or its guard.
static void add_edges_of_stmt(const StmtLocation *at, void *context)
{
    DepGraph *g = context;
    const Stmt *stmt = at->stmt;
    uint32_t node;

    if (stmt->kind == ST_TRANSITION)
        return;
    node = stmt->kind == ST_IF ? node_of_guard(g->s, stmt) : stmt->var->index;
    if (stmt->kind == ST_ASSIGN && !g->s->store[node])
        g->s->store[node] = stmt;
    add_edges_from_vars(g, stmt->value, node);
    if (at->when)
        add_edge(g, node_of_guard(g->s, at->when->stmt), node);
}

static void propagate_deps(InputDepsTable *s)
{
    const Program *p = s->a->p;
    const size_t nodes = p->var.n + p->stmts + 1;
    DepGraph g = {s, ARENA_ARRAY(s->a->arena, NodeNumbers, nodes), {NULL, 0, 0}, ARENA_ARRAY(s->a->arena, bool, nodes)};

    each_stmt_location(s->a->arena, p, add_edges_of_stmt, &g);
    for (size_t v = 0; v < p->var.n; v++) {
        s->deps[v] = deps_of_var(s, p->var.at[v]);
        push_node(&g, (uint32_t)v);
    }
    while (g.waiting.n > 0) {
        const uint32_t node = g.waiting.at[--g.waiting.n];
        g.waits[node] = false;
        for (size_t k = 0; k < g.readers[node].n; k++)
            if (merge_deps(&s->deps[g.readers[node].at[k]], &s->deps[node]))
                push_node(&g, g.readers[node].at[k]);
    }
}

// ---- queries ----

// Returns the inputs on which `when` and its outer conditions depend.
InputDeps input_deps_of_condition(const InputDepsTable *s, const Condition *when)
{
    const InputDeps none = {.n = 0};

    return when ? s->deps[node_of_guard(s, when->stmt)] : none;
}

// Adds the inputs on which an expression depends to *out.
static void merge_deps_of_expr(const InputDepsTable *s, const Expr *e, InputDeps *out)
{
    for (uint32_t i = 0; i < e->n; i++)
        merge_deps_of_expr(s, e->arg[i], out);
    if (e->kind == EX_VAR && !e->var->is_constant)
        merge_deps(out, &s->deps[e->var->index]);
}

// Returns the inputs on which the value of e depends.
InputDeps input_deps_of_expr(const InputDepsTable *s, const Expr *e)
{
    InputDeps out = {.n = 0};

    merge_deps_of_expr(s, e, &out);
    return out;
}

// Returns the innermost of `when` and its outer conditions whose own guard depends on the sensor; NULL if no guard depends on it.
const Condition *input_deps_find_condition(const InputDepsTable *s, const Condition *when, const Var *sensor)
{
    for (; when; when = when->outer) {
        const InputDeps l = input_deps_of_expr(s, when->stmt->value);
        if (input_deps_include(&l, sensor))
            return when;
    }
    return NULL;
}

// Returns whether e reads the sensor directly.  If e reads a local that depends on the sensor, also sets *store to an assignment to that
// local, unless *store is already set.
static bool reads_sensor_itself(const InputDepsTable *s, const Expr *e, const Var *sensor, const Stmt **store)
{
    bool itself = e->kind == EX_VAR && e->var == sensor;

    for (uint32_t i = 0; i < e->n; i++)
        itself |= reads_sensor_itself(s, e->arg[i], sensor, store);
    if (!*store && e->kind == EX_VAR && e->var->kind == VAR_LOCAL && input_deps_include(&s->deps[e->var->index], sensor))
        *store = s->store[e->var->index];
    return itself;
}

// If e depends on the sensor only through locals, returns an assignment to such a local; otherwise NULL.
const Stmt *input_deps_find_indirect_store(const InputDepsTable *s, const Expr *e, const Var *sensor)
{
    const Stmt *store = NULL;

    return reads_sensor_itself(s, e, sensor, &store) ? NULL : store;
}

const InputDepsTable *input_deps_of(Analysis *a)
{
    Arena *arena = a->arena;
    const size_t n = a->p->var.n;
    InputDepsTable *s = ARENA_NEW(arena, InputDepsTable);

    s->a = a;
    s->command = ARENA_ARRAY(arena, bool, n);
    s->deps = ARENA_ARRAY(arena, InputDeps, n + a->p->stmts + 1);
    s->store = ARENA_ARRAY(arena, const Stmt *, n);
    find_commands(s);
    propagate_deps(s);
    return s;
}
