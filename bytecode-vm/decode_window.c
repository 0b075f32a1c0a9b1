// SPDX-License-Identifier: Apache-2.0
// Samples and statistics in the decoded form.
#include "bytecode-vm/decode.h"

typedef struct DecodedWindow { uint32_t index, n, kind; } DecodedWindow;

// Unpacks entry w of the machine's table of rolling windows.
static DecodedWindow read_window(const DecodeState *d, uint32_t w)
{
    const uint32_t entry = smvm_window(d->m->image, d->m->windows_at, w);
    DecodedWindow v;

    v.index = w;
    v.n = entry & SMVM_WINDOW_SIZE_MASK;
    v.kind = entry >> SMVM_WINDOW_SIZE_BITS;
    return v;
}

// Emits the words that describe a rolling window to the fast interpreter.
static void emit_window(DecodeState *d, const DecodedWindow *w)
{
    if (d->out != NULL)
        smvm_next_word(d)->p = d->out->parts.window[w->index];
    d->words++;
    smvm_emit_integer(d, w->n);
    smvm_emit_integer(d, w->kind);
}

// Specialized instructions exist for windows of five types that are not long and that support only the median, only the average, or only
// extremes (smallest, largest, range).
enum { FOR_MEDIAN, FOR_AVG, FOR_EXTREMES, FOR_NONE };

// Returns which specialized instructions exist for a window (FOR_NONE: none), and in *type the index of its type among the five.
static unsigned find_specialized_use(const DecodedWindow *w, unsigned *type)
{
    static const uint8_t types[] = {SM_ROLL_I16, SM_ROLL_U16, SM_ROLL_I32, SM_ROLL_F32, SM_ROLL_F64};
    const uint32_t stats = w->kind & ~(uint32_t)SM_ROLL_TYPE;

    for (*type = 0; *type < sizeof types && (w->kind & SM_ROLL_TYPE) != types[*type];)
        ++*type;
    if (*type == sizeof types)
        return FOR_NONE;
    if (stats == SM_ROLL_AVG)
        return w->n <= SM_ROLL_SHORT || (w->kind & SM_ROLL_TYPE) < SM_ROLL_F32 ? FOR_AVG : FOR_NONE;
    if (stats == SM_ROLL_MEDIAN)
        return w->n <= SM_ROLL_SHORT ? FOR_MEDIAN : FOR_NONE;
    return (stats & SM_ROLL_ORDER) != 0 && (stats & (SM_ROLL_MEDIAN | SM_ROLL_AVG)) == 0 && w->n <= SM_ROLL_SCAN ? FOR_EXTREMES : FOR_NONE;
}

// Returns the opcode that samples a window.  from_memory: it reads the value from memory; otherwise from F.
static unsigned sample_op(const DecodedWindow *w, bool from_memory)
{
    static const uint16_t family[2][3] = {{FAST_PUSH_MEDIAN_I16_OP, FAST_PUSH_AVG_I16_OP, FAST_PUSH_EXTREMES_I16_OP},
                                          {FAST_PUSH_MEMORY_MEDIAN_I16_OP, FAST_PUSH_MEMORY_AVG_I16_OP, FAST_PUSH_MEMORY_EXTREMES_I16_OP}};
    unsigned type, use = find_specialized_use(w, &type);

    return use == FOR_NONE ? (unsigned)FAST_SAMPLE_OP : family[from_memory][use] + type;
}

// Returns the opcode that computes a statistic into F.  and_store: it also stores the result in an output.
static unsigned statistic_op(const DecodedWindow *w, uint32_t stat, bool and_store)
{
    static const uint16_t family[2][SM_STAT_COUNT] = {             // indexed by SmStat; 0: no such instruction
        {FAST_AVG_I16_OP, FAST_MEDIAN_I16_OP, FAST_SMALLEST_I16_OP, FAST_LARGEST_I16_OP, FAST_RANGE_I16_OP},
        {FAST_AVGN_I16_OP, FAST_MEDIANN_I16_OP, 0, 0, FAST_RANGEN_I16_OP}};
    unsigned type;

    return find_specialized_use(w, &type) == FOR_NONE || family[and_store][stat] == 0 ? (unsigned)FAST_STAT_OP : family[and_store][stat] + type;
}

// Translates the instruction that adds register X to a rolling window. A value in memory that has the window's type is sampled from there.
void smvm_decode_sample(DecodeState *d)
{
    const DecodedWindow w = read_window(d, d->n[0]);
    const DecodedValue *x = smvm_compute_x(d);
    const bool from_memory = is_memory(x) && x->kind == (w.kind & SM_ROLL_TYPE) && sample_op(&w, true) != FAST_SAMPLE_OP;

    if (!from_memory)
        smvm_move_x_to_f(d);
    smvm_emit_op(d, sample_op(&w, from_memory));
    emit_window(d, &w);
    if (from_memory)
        smvm_emit_operand(d, x);
}

// Emits code that loads the deferred statistic of X into F.
void smvm_emit_statistic(DecodeState *d)
{
    const DecodedWindow w = read_window(d, d->deferred.w);

    smvm_emit_op(d, statistic_op(&w, d->deferred.n, false));
    emit_window(d, &w);
    smvm_emit_integer(d, d->deferred.n);
}

// Emits one instruction that computes the deferred statistic of X and stores it in `to`.  Some statistics have such an instruction, for a
// destination that is one of the first 64 outputs and has the window's type.
bool smvm_try_emit_statistic_to(DecodeState *d, const StoreTarget *to)
{
    DecodedWindow w;

    if (d->x.kind != DEFERRED || d->deferred.op != SMVM_stat || !to->output || to->index >= 64)
        return false;
    w = read_window(d, d->deferred.w);
    if ((w.kind & SM_ROLL_TYPE) != to->to.kind || statistic_op(&w, d->deferred.n, true) == FAST_STAT_OP)
        return false;
    smvm_emit_op(d, statistic_op(&w, d->deferred.n, true));
    smvm_emit_integer(d, (uint64_t)1 << to->index);
    smvm_emit_operand(d, &to->to);
    emit_window(d, &w);
    smvm_emit_integer(d, d->deferred.n);
    d->x.kind = FAST_IN_F;
    return true;
}
