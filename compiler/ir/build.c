// SPDX-License-Identifier: Apache-2.0
// Translates a typed program to IR: variables, windows, and a function for each nonempty entry, step or exit block.
// Basic blocks are created in the order of control flow, so that every jump leads forward.
#include "compiler/ir/build.h"

#include <string.h>

// Starts a function with one empty block, which becomes the current one.
void build_begin_function(Builder *b)
{
    if (!b->f)
        b->f = ARENA_NEW(b->arena, IrFn);
    b->f->ins.n = b->f->blk.n = 0;
    b->b = ir_add_block(b->arena, b->f);
}

// Copies the function out of the buffer, with instructions numbered in the order of their blocks.  The instruction lists of all blocks
// share one allocation.  Each list is padded to the arena's alignment, like a separate allocation, so that vec_push can extend it.
IrFn *build_end_function(Builder *b)
{
    IrFn *f = arena_copy(b->arena, b->f, sizeof *f);
    size_t room = 0;
    IrRef *list, ref = 0;

    f->ins.at = arena_copy(b->arena, b->f->ins.at, f->ins.n * sizeof *f->ins.at);
    f->blk.at = arena_copy(b->arena, b->f->blk.at, f->blk.n * sizeof *f->blk.at);
    f->ins.cap = f->ins.n;
    f->blk.cap = f->blk.n;
    for (size_t k = 0; k < f->blk.n; k++)
        room += f->blk.at[k].ins.cap = vec_room(f->blk.at[k].ins.n, sizeof ref);
    list = ARENA_ARRAY(b->arena, IrRef, room);
    for (size_t k = 0; k < f->blk.n; list += f->blk.at[k++].ins.cap) {
        f->blk.at[k].ins.at = list;
        for (size_t i = 0; i < f->blk.at[k].ins.n; i++)
            list[i] = ref++;
    }
    for (; b->notes && b->noted < b->notes->n; b->noted++)
        b->notes->at[b->noted].fn = f;
    return f;
}

// ---- statements ----

// The blocks that end an arm of a conditional; the target of their jump is set when the block after the conditional exists.
typedef VEC(IrBlkRef) OpenBlocks;

static IrJump *jump_of(Builder *b, IrBlkRef blk)
{
    return &b->f->blk.at[blk].jump;
}

static bool build_stmts(Builder *b, const Stmts *list);

static void build_assign(Builder *b, const Stmt *s)
{
    IrIns i = {.op = IR_store, .type = s->var->type, .b = IR_NONE, .var = b->var[s->var->index], .span = s->span};

    b->stmt = s->number;
    i.a = build_for_store(b, s->value, s->var->type);
    build_emit(b, &i);
}

static void build_transition(Builder *b, const Stmt *s)
{
    IrJump *j = jump_of(b, b->b);

    j->kind = IR_GOTO;
    j->state = s->target->number;
    j->stmt = s->number;
    j->span = s->span;
}

// Ends the current block with a branch on the guard.  A new block becomes the current one and the target of the true edge.  Returns the
// old block: the caller sets the false edge of its branch (`otherwise`) when the target of that edge exists.
static IrBlkRef build_branch_on(Builder *b, const Expr *guard)
{
    IrRef cond = build_as_bool(b, guard);
    IrBlkRef from = b->b;
    IrJump *j;

    b->b = ir_add_block(b->arena, b->f);
    j = jump_of(b, from);
    j->kind = IR_BR;
    j->cond = cond;
    j->then = b->b;
    j->stmt = b->stmt;
    j->span = guard->span;
    return from;
}

// Ends the current block with a branch on the guard of conditional s, as build_branch_on does.
static IrBlkRef build_branch(Builder *b, const Stmt *s)
{
    b->stmt = s->number;
    return build_branch_on(b, s->value);
}

// Builds one arm.  If control can reach the arm's end, its last block is added to `ends`.
static void build_arm(Builder *b, const Stmts *list, OpenBlocks *ends)
{
    if (build_stmts(b, list))
        vec_push(b->arena, ends, b->b);
}

// Returns the conditional that is the only statement of the `else` arm of s; NULL if the arm is missing or contains anything else.
static const Stmt *find_else_if(const Stmt *s)
{
    return s->otherwise.n == 1 && s->otherwise.at[0]->kind == ST_IF ? s->otherwise.at[0] : NULL;
}

// Builds a conditional with its whole chain of `else if`, in a loop because the chain may be too long for recursion.  Returns false if
// control cannot reach the statement after it.
static bool build_if(Builder *b, const Stmt *s)
{
    OpenBlocks ends = {NULL, 0, 0};
    IrBlkRef skips = build_branch(b, s);          // the block whose branch has no false edge yet; IR_NONE: no such block

    build_arm(b, &s->then, &ends);
    while (s->otherwise.n > 0) {
        b->b = ir_add_block(b->arena, b->f);
        jump_of(b, skips)->otherwise = b->b;
        skips = IR_NONE;
        if (!find_else_if(s)) {
            build_arm(b, &s->otherwise, &ends);
            break;
        }
        s = find_else_if(s);
        skips = build_branch(b, s);
        build_arm(b, &s->then, &ends);
    }
    if (skips == IR_NONE && ends.n == 0)
        return false;
    b->b = ir_add_block(b->arena, b->f);          // the arms meet in a new block
    if (skips != IR_NONE)
        jump_of(b, skips)->otherwise = b->b;
    for (size_t i = 0; i < ends.n; i++) {
        jump_of(b, ends.at[i])->kind = IR_JMP;
        jump_of(b, ends.at[i])->then = b->b;
    }
    return true;
}

// Builds a list of statements up to the first one after which control never continues.  Returns false if there is such a statement.
static bool build_stmts(Builder *b, const Stmts *list)
{
    for (size_t i = 0; i < list->n; i++)
        switch (list->at[i]->kind) {
        case ST_ASSIGN: build_assign(b, list->at[i]); break;
        case ST_TRANSITION: build_transition(b, list->at[i]); return false;
        case ST_IF:
            if (!build_if(b, list->at[i]))
                return false;
            break;
        }
    return true;
}

static void build_state(Builder *b, const State *s)
{
    IrState state;

    memset(&state, 0, sizeof state);
    state.name = s->name;
    state.is_safe = s->is_safe;
    state.allows_swap = s->allows_swap;
    state.is_abort = s->is_abort;
    state.span = s->span;
    for (int k = 0; k < BLOCK_COUNT; k++) {
        if (s->block[k].n == 0)
            continue;
        build_begin_function(b);
        build_stmts(b, &s->block[k]);                         // the last block ends in IR_RET unless a statement sets its jump
        state.block[k] = build_end_function(b);
    }
    vec_push(b->arena, &b->m->state, state);
}

// ---- variables ----

static void build_vars(Builder *b)
{
    static const IrSpace space_of[] = {[VAR_ELEMENT] = IR_ELEMENT, [VAR_LOCAL] = IR_LOCAL, [VAR_TIME] = IR_TIME};
    const Program *p = b->p;

    b->var = ARENA_ARRAY(b->arena, uint32_t, p->var.n);
    for (size_t k = 0; k < p->var.n; k++) {
        const Var *v = p->var.at[k];
        IrVar out = {.space = space_of[v->kind], .name = v->name, .type = v->type, .init = v->init, .parameter = v->parameter, .span = v->span};
        out.writable = v->written;
        out.outside = v->outside;
        if (v->element)
            out.offset = v->element->offset, out.element = v->element->name;
        b->var[v->index] = v->is_constant ? IR_NONE : (uint32_t)b->m->var.n;
        if (!v->is_constant)
            vec_push(b->arena, &b->m->var, out);
    }
    b->m->g = b->var[p->g->index];
    b->m->s = b->var[p->s->index];
    b->m->t = b->var[p->t->index];
}

// Builds the unoptimised IR of a machine.
IrMachine *ir_build(Arena *arena, const Program *p) { return ir_build_noting(arena, p, NULL); }

// Like ir_build, and adds a note for each condition.
IrMachine *ir_build_noting(Arena *arena, const Program *p, IrNotes *notes)
{
    IrMachine *m = ARENA_NEW(arena, IrMachine);
    Builder b = {.arena = arena, .p = p, .m = m, .notes = notes, .noted = notes ? notes->n : 0};

    m->name = p->name;
    m->sv_name = p->sv->name;
    m->sv_size = p->sv->size;
    m->sv_hash = p->sv->hash;
    m->program = p;
    build_vars(&b);
    build_windows(&b);
    m->var_of = b.var;
    m->window_of = b.window;
    for (size_t s = 0; s < p->state.n; s++)
        build_state(&b, p->state.at[s]);
    return m;
}

// Builds a function that evaluates a condition.  Control reaches block 1 if the condition is true, else block 2.
IrFn *ir_build_guard(Arena *arena, const IrMachine *m, const Expr *guard)
{
    Builder b = {.arena = arena, .p = m->program, .var = (uint32_t *)m->var_of, .window = (uint32_t *)m->window_of};
    IrJump *j;

    build_begin_function(&b);
    j = jump_of(&b, build_branch_on(&b, guard));
    j->otherwise = ir_add_block(arena, b.f);
    return build_end_function(&b);
}
