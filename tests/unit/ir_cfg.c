// SPDX-License-Identifier: Apache-2.0
// Reachability and postdominators, compared with their definitions on random functions.  For every block, the test removes another block and
// checks whether the end is still reachable.
#include <stdlib.h>
#include <string.h>

#include "compiler/ir/ir.h"
#include "tests/heap.h"
#include "tests/test.h"

enum { BLOCKS_MOST = 12, FUNCTIONS = 20000 };

static uint64_t state = 88172645463325252u;

static uint32_t random_below(uint32_t n)
{
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    return (uint32_t)(state >> 20) % n;
}

static void random_jump(IrJump *j, uint32_t b, uint32_t n)
{
    uint32_t behind = n - 1 - b;

    j->kind = behind == 0 ? IR_RET : (IrJumpKind)(random_below(6) < 3 ? IR_BR : random_below(4) < 3 ? IR_JMP : random_below(2) ? IR_RET : IR_GOTO);
    if (j->kind == IR_JMP || j->kind == IR_BR)
        j->then = b + 1 + random_below(behind);
    if (j->kind == IR_BR)
        j->otherwise = b + 1 + random_below(behind);
}

static IrFn *random_function(Arena *a)
{
    IrFn *f = ARENA_NEW(a, IrFn);
    uint32_t n = 1 + random_below(BLOCKS_MOST);

    for (uint32_t b = 0; b < n; b++) {
        ir_add_block(a, f);
        random_jump(&f->blk.at[b].jump, b, n);
    }
    return f;
}

// Whether a path from b reaches `to` (IR_NONE: the end) without passing through `without`.
static bool leads_to(const IrFn *f, IrBlkRef b, IrBlkRef to, IrBlkRef without)
{
    const IrJump *j = &f->blk.at[b].jump;

    if (b == without)
        return false;
    if (b == to)
        return true;
    switch (j->kind) {
    case IR_RET:
    case IR_GOTO: return to == IR_NONE;
    case IR_JMP: return leads_to(f, j->then, to, without);
    case IR_BR: return leads_to(f, j->then, to, without) || leads_to(f, j->otherwise, to, without);
    }
    return false;
}

// Returns the lowest-numbered block after b without which b cannot reach the end.
static IrBlkRef plain_postdominator(const IrFn *f, IrBlkRef b)
{
    for (IrBlkRef x = b + 1; x < f->blk.n; x++)
        if (!leads_to(f, b, IR_NONE, x))
            return x;
    return IR_NONE;
}

static void check_function(Arena *a)
{
    const IrFn *f = random_function(a);
    const IrBlkRef *post = ir_find_postdominators(a, f);
    const bool *reached = ir_find_reachable(a, f);

    for (IrBlkRef b = 0; b < f->blk.n; b++) {
        CHECK(post[b] == plain_postdominator(f, b));
        CHECK(reached[b] == leads_to(f, 0, b, IR_NONE));
    }
}

static void check_uses(Arena *a)
{
    IrFn *f = ARENA_NEW(a, IrFn);
    IrBlkRef b = ir_add_block(a, f);
    IrIns x = {.op = IR_const, .type = SM_BOOL, .a = IR_NONE, .b = IR_NONE};
    IrRef t = ir_emit(a, f, b, x), both, dead;
    uint32_t *uses;

    both = ir_emit(a, f, b, (IrIns){.op = IR_and, .type = SM_BOOL, .a = t, .b = t});
    dead = ir_emit(a, f, b, (IrIns){.op = IR_not, .type = SM_BOOL, .a = t, .b = IR_NONE});
    f->blk.at[b].jump.kind = IR_BR;
    f->blk.at[b].jump.cond = both;
    uses = ir_count_uses(a, f);
    CHECK(uses[t] == 3 && uses[both] == 1 && uses[dead] == 0);
    f->blk.at[b].ins.n--;                             // an instruction that is in no block uses no value
    CHECK(ir_count_uses(a, f)[t] == 2);
}

int main(void)
{
    jmp_buf oom;
    Arena a;

    if (setjmp(oom) != 0)
        return 3;
    for (int i = 0; i < FUNCTIONS; i++) {
        arena_init(&a, heap_alloc, NULL, &oom);
        check_function(&a);
        arena_free(&a);
    }
    arena_init(&a, heap_alloc, NULL, &oom);
    check_uses(&a);
    arena_free(&a);
    return test_end("ir_cfg");
}
