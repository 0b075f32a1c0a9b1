// SPDX-License-Identifier: Apache-2.0
// Whole numbers beyond 2^53, which F64 cannot distinguish: literals whose value differs from their digits, and sums whose
// smaller operand is always lost in rounding.
#include "compiler/analysis/analysis.h"
#include "stdlib/math.h"

// ---- literals ----

// The value of a literal that is a whole number of digits.  Returns false for other literals, and from 2^64 on.
static bool read_digits(Span span, uint64_t *out)
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

// F64 has 53 binary digits.  The largest values of U64 and I64 are stored as written.
static bool is_kept(uint64_t n)
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

static const char *digits_of(Arena *arena, SmF64 x)
{
    return x < 18446744073709551616.0 ? format_in(arena, "%llu", (unsigned long long)x) : const_text(arena, x);
}

static void look_at_number(Expr *e, void *context)
{
    Analysis *a = context;
    uint64_t n;

    if (e->kind == EX_NUMBER && e->span.src && read_digits(e->span, &n) && !is_kept(n))
        diag_report(a->diags, DIAG_number_rounded, e->span, source_text(a->arena, e->span), digits_of(a->arena, e->number));
}

static void look_at_stmt(const Stmt *stmt, void *context)
{
    if (stmt->value)
        expr_walk(stmt->value, look_at_number, context);
}

// ---- sums ----

static SmF64 least_size(Fact f) { return f.lo > 0 ? f.lo : f.hi < 0 ? sm_neg(f.hi) : sm_from_i32(0); }
static SmF64 largest_size(Fact f) { return sm_max(sm_abs(f.lo), sm_abs(f.hi)); }

// A lower bound of the distance between two adjacent numbers of magnitude x or more.
static SmF64 spacing(SmF64 x)
{
    SmF64 step = sm_from_i32(1);

    while (x >= sm_mul(FACT_EXACT, step) && step < 1e300)
        step = sm_mul(step, sm_from_i32(2));
    return step;
}

// A whole number smaller than the spacing at the other operand is lost or changed.
static bool is_lost(Fact large, Fact small)
{
    const SmF64 size = least_size(large);

    return size >= FACT_EXACT && size < 1e300 && !small.nan && small.whole && least_size(small) > 0 &&
           largest_size(small) < spacing(size);
}

static void look_at_sum(Analysis *a, const FactFlow *flow, const IrIns *i)
{
    const Fact x = flow->of[i->a], y = flow->of[i->b];

    if (is_lost(x, y) || is_lost(y, x))
        diag_report(a->diags, DIAG_sum_rounded, i->span);
}

static void look_at_flow(Analysis *a, const FlowPlace *at, void *context)
{
    (void)context;
    for (size_t b = 0; b < at->f->blk.n; b++)
        for (size_t n = 0; at->flow.reached[b] && n < at->f->blk.at[b].ins.n; n++) {
            const IrIns *i = &at->f->ins.at[at->f->blk.at[b].ins.at[n]];
            if (i->op == IR_add || i->op == IR_sub)
                look_at_sum(a, &at->flow, i);
        }
}

static void look_at_literals(Analysis *a)
{
    for (size_t i = 0; i < a->p->var.n; i++)
        if (a->p->var.at[i]->init_value)
            expr_walk(a->p->var.at[i]->init_value, look_at_number, a);
    each_stmt(a->p, look_at_stmt, a);
}

void analyse_precision_loss(Analysis *a)
{
    if (a->p->large_numbers)
        look_at_literals(a);
    if (a->large_sums)
        each_flow(a, look_at_flow, NULL);
}
