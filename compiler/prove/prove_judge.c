// SPDX-License-Identifier: Apache-2.0
#include "compiler/prove/prove_make.h"

// Copies condition a, b or c (0, 1, 2) of the requirement to the current block, and continues in one of two blocks.
static void judge_condition(ProveMaker *k, int condition, IrBlkRef then, IrBlkRef otherwise)
{
    const IrFn *from = k->condition[condition];
    IrRef *copy = prove_new_copies(k, from);

    prove_copy_block(k, from, &from->blk.at[0], copy);
    prove_branch_from(k, k->b, copy[from->blk.at[0].jump.cond], then, otherwise);
}

// Makes block b the current one.  There, the step could have violated the requirement.
static void begin_premise(ProveMaker *k, IrBlkRef b)
{
    k->b = b;
    prove_emit_set(k, k->model->premise, 1);
}

// never a; always b; always a implies b
static void judge_each_step(ProveMaker *k, IrBlkRef met, IrBlkRef violated)
{
    const Requirement *r = k->model->what;
    const IrBlkRef premise = prove_new_block(k);

    if (r->kind == REQUIREMENT_ALWAYS && r->a)
        judge_condition(k, 0, premise, met);
    else
        prove_jump_from(k, k->b, premise);
    begin_premise(k, premise);
    if (r->kind == REQUIREMENT_NEVER)
        judge_condition(k, 0, violated, met);
    else
        judge_condition(k, 1, met, violated);
}

// never a before b: `seen` is whether an earlier step had b.
static void judge_before(ProveMaker *k, IrBlkRef met, IrBlkRef violated)
{
    const IrBlkRef premise = prove_new_block(k), update = prove_new_block(k), first = prove_new_block(k);

    judge_condition(k, 0, premise, update);
    begin_premise(k, premise);
    prove_branch_if_above(k, k->seen, 0, update, violated);
    k->b = update;
    judge_condition(k, 1, first, met);
    k->b = first;
    prove_emit_set(k, k->seen, 1);
    prove_jump_from(k, first, met);
}

// never a after b without c: `seen` is whether an earlier step had b, `open` whether no step since the last one with b had c.
static void judge_after(ProveMaker *k, IrBlkRef met, IrBlkRef violated)
{
    const IrBlkRef had_b = prove_new_block(k), premise = prove_new_block(k), update = prove_new_block(k), with_b = prove_new_block(k),
        without = prove_new_block(k), with_c = prove_new_block(k);

    judge_condition(k, 0, had_b, update);
    k->b = had_b;
    prove_branch_if_above(k, k->seen, 0, premise, update);
    begin_premise(k, premise);
    prove_branch_if_above(k, k->open, 0, violated, update);
    k->b = update;
    judge_condition(k, 1, with_b, without);
    k->b = with_b;
    prove_emit_set(k, k->seen, 1);
    prove_emit_set(k, k->open, 1);
    prove_jump_from(k, with_b, met);
    k->b = without;
    judge_condition(k, 2, with_c, met);
    k->b = with_c;
    prove_emit_set(k, k->open, 0);
    prove_jump_from(k, with_c, met);
}

// Ends the current block: continues in `then` if more than `x` has passed since the requirement is open.  Both `age` and T + `offset` are this
// time.  Facts about `age` are exact while it has few values.  Facts about T + `offset` have the bounds of T in the state.
static void branch_if_older(ProveMaker *k, double x, IrBlkRef then, IrBlkRef otherwise)
{
    const IrRef age = prove_emit(k, IR_gt, prove_emit_load(k, k->age), prove_emit_number(k, x));
    const IrRef sum = prove_emit(k, IR_add, prove_emit_load(k, k->model->machine->t), prove_emit_load(k, k->offset));

    prove_branch_from(k, k->b, prove_emit(k, IR_and, age, prove_emit(k, IR_gt, sum, prove_emit_number(k, x))), then, otherwise);
}

// Ends the current block: stores what an open requirement needs in the next step, which begins delta_t later, in this state or with T = 0 in
// another one.
static void stay_open(ProveMaker *k, IrBlkRef met)
{
    const double delta = (double)k->model->delta_t;
    const IrBlkRef leaves = prove_new_block(k);

    prove_emit_store(k, k->age, prove_emit(k, IR_add, prove_emit_load(k, k->age), prove_emit_number(k, delta)));
    prove_branch_if_above(k, k->model->next, 0, leaves, met);
    k->b = leaves;
    prove_emit_store(k, k->offset, prove_emit(k, IR_add,
                                              prove_emit(k, IR_add, prove_emit_load(k, k->offset), prove_emit_load(k, k->model->machine->t)),
                                              prove_emit_number(k, delta)));
    prove_jump_from(k, leaves, met);
}

// always a leads to b within t
static void judge_leads_to(ProveMaker *k, IrBlkRef met, IrBlkRef violated)
{
    const double within = (double)k->model->what->within, delta = (double)k->model->delta_t;
    const IrBlkRef closed = prove_new_block(k), opens = prove_new_block(k), is_open = prove_new_block(k), has_b = prove_new_block(k),
        closes = prove_new_block(k), waits = prove_new_block(k),
                   stays = prove_new_block(k);

    prove_branch_if_above(k, k->open, 0, is_open, closed);
    k->b = closed;
    judge_condition(k, 0, opens, met);
    begin_premise(k, opens);
    prove_emit_set(k, k->open, 1);
    prove_emit_set(k, k->age, 0);
    prove_emit_store(k, k->offset, prove_emit(k, IR_sub, prove_emit_number(k, 0), prove_emit_load(k, k->model->machine->t)));
    prove_jump_from(k, opens, is_open);
    k->b = is_open;
    judge_condition(k, 1, has_b, waits);
    k->b = has_b;
    branch_if_older(k, within, violated, closes);
    k->b = closes;
    prove_emit_set(k, k->open, 0);
    prove_emit_set(k, k->age, 0);
    prove_emit_set(k, k->offset, 0);
    prove_jump_from(k, closes, met);
    k->b = waits;
    branch_if_older(k, within - delta, violated, stays);
    k->b = stays;
    stay_open(k, met);
}

// Emits the judgement of the step, and its two ends.
void prove_judge_requirement(ProveMaker *k)
{
    const IrBlkRef start = k->b, met = prove_new_block(k), violated = prove_new_block(k);

    k->end.at[met] = PROVE_END_MET;
    k->end.at[violated] = PROVE_END_VIOLATED;
    k->b = met;
    prove_emit_set(k, k->sampled, 1);
    k->b = start;
    switch (k->model->what->kind) {
    case REQUIREMENT_NEVER:
    case REQUIREMENT_ALWAYS: judge_each_step(k, met, violated); break;
    case REQUIREMENT_BEFORE: judge_before(k, met, violated); break;
    case REQUIREMENT_AFTER: judge_after(k, met, violated); break;
    case REQUIREMENT_LEADS_TO: judge_leads_to(k, met, violated); break;
    }
}
