// SPDX-License-Identifier: Apache-2.0
// Reports whole numbers beyond 2^53, not all of which F64 can represent: literals whose value differs from their digits, and sums whose
// smaller operand is always lost in rounding.
#include "compiler/analysis/analysis.h"
#include "stdlib/math.h"

// ---- literals ----

// Reads a whole number, decimal or hexadecimal, into *out.  Returns false for other literals and for numbers from 2^64 on.
static bool read_whole_literal(Span span, uint64_t *out)
{
    const char *text = span.src->text + span.at;
    const bool hex = span.len > 2 && text[0] == '0' && (text[1] == 'x' || text[1] == 'X');
    const uint64_t base = hex ? 16 : 10;
    uint64_t n = 0;

    for (uint32_t i = hex ? 2 : 0; i < span.len; i++) {
        const char c = text[i];
        const uint64_t digit = c >= '0' && c <= '9' ? (uint64_t)(c - '0') : (uint64_t)((c | 0x20) - 'a' + 10);
        if (c == '_')
            continue;
        if (digit >= base || n > (UINT64_MAX - digit) / base)
            return false;
        n = n * base + digit;
    }
    *out = n;
    return true;
}

// Whether a store of the literal n stores exactly n, although n is converted to F64, which has 53 binary digits.  True for the largest
// values of U64 and I64: F64 rounds them up, and the store saturates to them.
static bool survives_f64(uint64_t n)
{
    if (n == UINT64_MAX || n == INT64_MAX)
        return true;
    while (n >= UINT64_C(1) << 53) {
        if (n & 1)
            return false;
        n >>= 1;
    }
    return true;
}

static void check_literal(Expr *e, void *context)
{
    Analysis *a = context;
    const char *stored;
    uint64_t n;

    if (e->kind != EX_NUMBER || !e->span.src || !read_whole_literal(e->span, &n) || survives_f64(n))
        return;
    stored = e->number < 18446744073709551616.0 ? format_in(a->arena, "%llu", (unsigned long long)e->number)
                                                : const_text(a->arena, e->number);
    diag_report(a->diags, DIAG_number_rounded, e->span, source_text(a->arena, e->span), stored);
}

static void check_literals(const Stmt *stmt, void *context)
{
    if (stmt->value)
        expr_walk(stmt->value, check_literal, context);
}

// ---- sums ----

static SmF64 smallest_magnitude(Fact f) { return f.lo > 0 ? f.lo : f.hi < 0 ? sm_neg(f.hi) : sm_from_i32(0); }

// Returns the distance between adjacent F64 numbers at magnitude x, which is at least 2^53.  Beyond x the distance is at least as large.
static SmF64 spacing_of_large_f64(SmF64 x)
{
    SmF64 step = sm_from_i32(1);

    while (x >= sm_mul(FACT_EXACT, step) && step < 1e300)
        step = sm_mul(step, sm_from_i32(2));
    return step;
}

// Whether a sum always loses or changes its operand `small`: `small` is a whole number other than 0 and smaller than the distance between
// adjacent F64 numbers at `large`.
static bool is_lost_in_sum(Fact large, Fact small)
{
    const SmF64 size = smallest_magnitude(large);

    return size >= FACT_EXACT && size < 1e300 && !small.nan && small.whole && smallest_magnitude(small) > 0 &&
           sm_max(sm_abs(small.lo), sm_abs(small.hi)) < spacing_of_large_f64(size);
}

static void check_sums(Analysis *a, const ReachableFn *r, void *context)
{
    (void)context;
    for (size_t b = 0; b < r->fn->blk.n; b++)
        for (size_t n = 0; r->flow.reached[b] && n < r->fn->blk.at[b].ins.n; n++) {
            const IrIns *i = &r->fn->ins.at[r->fn->blk.at[b].ins.at[n]];
            if ((i->op == IR_add || i->op == IR_sub) &&
                (is_lost_in_sum(r->flow.of[i->a], r->flow.of[i->b]) || is_lost_in_sum(r->flow.of[i->b], r->flow.of[i->a])))
                diag_report(a->diags, DIAG_sum_rounded, i->span);
        }
}

void analyse_precision_loss(Analysis *a)
{
    for (size_t i = 0; a->p->large_numbers && i < a->p->var.n; i++)
        if (a->p->var.at[i]->init_value)
            expr_walk(a->p->var.at[i]->init_value, check_literal, a);
    if (a->p->large_numbers)
        each_stmt(a->p, check_literals, a);
    if (a->large_sums)
        each_reachable_fn(a, check_sums, NULL);
}
