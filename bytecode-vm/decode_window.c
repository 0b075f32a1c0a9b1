// SPDX-License-Identifier: Apache-2.0
// Samples and statistics in the decoded form.
#include "bytecode-vm/decode.h"

static void put_window(Decode *d, uint32_t w)         // which, of what size and kind
{
    uint32_t entry = smvm_window(d->m->image, d->m->windows_at, w);

    if (d->out != NULL)
        smvm_word(d)->p = d->out->parts.window[w];
    d->words++;
    smvm_put_u(d, entry & SMVM_WINDOW_SIZE_MASK);
    smvm_put_u(d, entry >> SMVM_WINDOW_SIZE_BITS);
}

// The windows that instructions are made for: of five types, that keep nothing but what one statistic needs, or both ends.
enum { FOR_MEDIAN, FOR_AVG, FOR_ENDS, FOR_NONE };

static unsigned made_for(uint32_t kind, unsigned *type)
{
    static const uint8_t types[] = {SM_ROLL_I16, SM_ROLL_U16, SM_ROLL_I32, SM_ROLL_F32, SM_ROLL_F64};
    const uint32_t stats = kind & ~(uint32_t)SM_ROLL_TYPE;

    for (*type = 0; *type < sizeof types && (kind & SM_ROLL_TYPE) != types[*type];)
        ++*type;
    if (*type == sizeof types)
        return FOR_NONE;
    if (stats == SM_ROLL_MEDIAN || stats == SM_ROLL_AVG)
        return stats == SM_ROLL_AVG ? FOR_AVG : FOR_MEDIAN;
    return (stats & (SM_ROLL_MEDIAN | SM_ROLL_AVG)) == 0 && (stats & SM_ROLL_RANGE) != 0 ? FOR_ENDS : FOR_NONE;
}

static unsigned sampling(uint32_t kind, bool memory)
{
    static const uint16_t family[2][3] = {{FAST_PUSH_MEDIAN_I16_OP, FAST_PUSH_AVG_I16_OP, FAST_PUSH_ENDS_I16_OP},
                                          {FAST_TAKE_MEDIAN_I16_OP, FAST_TAKE_AVG_I16_OP, FAST_TAKE_ENDS_I16_OP}};
    unsigned type, use = made_for(kind, &type);

    return use == FOR_NONE ? (unsigned)FAST_SAMPLE_OP : family[memory][use] + type;
}

static unsigned asking(uint32_t kind, uint32_t stat, bool store)
{
    static const uint16_t family[2][3] = {{FAST_MEDIAN_I16_OP, FAST_AVG_I16_OP, FAST_RANGE_I16_OP},
                                          {FAST_MEDIANN_I16_OP, FAST_AVGN_I16_OP, FAST_RANGEN_I16_OP}};
    static const uint8_t made_to_ask[] = {SM_STAT_MEDIAN, SM_STAT_AVG, SM_STAT_RANGE};
    unsigned type, use = made_for(kind, &type);

    return use == FOR_NONE || stat != made_to_ask[use] ? (unsigned)FAST_STAT_OP : family[store][use] + type;
}

static uint32_t kind_of(const Decode *d, uint32_t w) { return smvm_window(d->m->image, d->m->windows_at, w) >> SMVM_WINDOW_SIZE_BITS; }

void smvm_decode_sample(Decode *d)
{
    uint32_t kind = kind_of(d, d->n[0]);
    const Value *x = smvm_x_of(d);
    bool memory = is_memory(x) && x->kind == (kind & SM_ROLL_TYPE) && sampling(kind, true) != FAST_SAMPLE_OP;

    if (!memory)
        smvm_load_x(d);
    smvm_put_op(d, sampling(kind, memory));
    put_window(d, d->n[0]);
    if (memory)
        smvm_put_value(d, x);
}

static void put_asked(Decode *d)                      // of which window what
{
    put_window(d, d->later.w);
    smvm_put_u(d, d->later.n);
}

void smvm_put_statistic(Decode *d)
{
    smvm_put_op(d, asking(kind_of(d, d->later.w), d->later.n, false));
    put_asked(d);
}

// Where there is an instruction for it: to one of the first 64 outputs.
bool smvm_put_statistic_to(Decode *d, const Place *to)
{
    uint32_t kind;

    if (d->x.kind != LATER || d->later.op != SMVM_stat || !to->output || to->index >= 64)
        return false;
    kind = kind_of(d, d->later.w);
    if ((kind & SM_ROLL_TYPE) != to->to.kind || asking(kind, d->later.n, true) == FAST_STAT_OP)
        return false;
    smvm_put_op(d, asking(kind, d->later.n, true));
    smvm_put_u(d, (uint64_t)1 << to->index);
    smvm_put_value(d, &to->to);
    put_asked(d);
    d->x.kind = FAST_A;
    return true;
}
