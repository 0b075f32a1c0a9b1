// SPDX-License-Identifier: Apache-2.0
// Rolling windows of samples in emitted C: an array of words for each window, and calls of stdlib/roll.h.  Size and kind of the window are
// constant arguments, so that a compiler specialises each call.  A kind is the type of the samples and a bit for each statistic.
#include "compiler/emit/c/fn.h"
#include "stdlib/roll.h"
#include "stdlib/soft_cells.h"

static const IrWindow *get_window(const CUnit *u, size_t w) { return &u->m->window.at[w]; }

// Returns the kind of a window, as roll.h encodes it.
static uint32_t roll_kind(const IrWindow *w) { return sm_roll_kind(w->type, w->stats); }

// Writes the kind as `SM_ROLL_F32 | SM_ROLL_AVG | SM_ROLL_MAX`.
static void write_kind(const IrWindow *w, Buf *out)
{
    static const char *const type[] = {
#define SM_TYPE(name, wire, spelling, ctype, bytes, kind) [wire] = #name,
#include "stdlib/types.def"
#undef SM_TYPE
    };
    static const char *const stat[SM_STAT_COUNT] = { "AVG", "MEDIAN", "MIN", "MAX", "RANGE", "OLDEST", "NEWEST", "CHANGE", "ELAPSED", "RUN_STEPS",
                                                    "RUN_TIME" };

    buf_printf(out, "SM_ROLL_%s", type[roll_kind(w) & SM_ROLL_TYPE]);
    for (int s = 0; s < SM_STAT_COUNT; s++)
        if (w->stats >> s & 1)
            buf_printf(out, s == SM_STAT_MEDIAN && w->size == 3 ? " | SM_ROLL_MEDIAN_OF_3" : " | SM_ROLL_%s", stat[s]);
}

// These return the number of words of a window without its ring, which is a separate member, as compiled normally and with SM_ROLL_SMALL.
static unsigned window_words(const CUnit *u, size_t w) { return sm_roll_words(get_window(u, w)->size, roll_kind(get_window(u, w))) - 1; }
static unsigned small_window_words(const CUnit *u, size_t w) { return c_small_roll_words(get_window(u, w)->size, roll_kind(get_window(u, w))) - 1; }

static void write_window_sizes(const CUnit *u, bool small, Buf *out)
{
    for (size_t w = 0; w < u->m->window.n; w++)
        if (window_words(u, w) != small_window_words(u, w))
            buf_printf(out, "#define %s_WORDS_%s %u\n", u->names.macro, u->window[w], small ? small_window_words(u, w) : window_words(u, w));
}

// Writes a macro for the size of each window whose size depends on SM_ROLL_SMALL.
void c_write_window_sizes(const CUnit *u, Buf *out)
{
    Buf small;

    buf_init(&small, u->arena);
    write_window_sizes(u, true, &small);
    if (small.n == 0)
        return;
    buf_printf(out, "// Words of rolling windows.\n#if SM_ROLL_SMALL\n%s#else\n", buf_text(&small));
    write_window_sizes(u, false, out);
    buf_str(out, "#endif\n\n");
}

// Returns the declarator of the window's member: its name and its size in words, as in `altitude_last_9[12]`.
const char *c_window_declaration(const CUnit *u, size_t w)
{
    if (window_words(u, w) == small_window_words(u, w))
        return format_in(u->arena, "%s[%u]", u->window[w], window_words(u, w));
    return format_in(u->arena, "%s[%s_WORDS_%s]", u->window[w], u->names.macro, u->window[w]);
}

// Returns the first window that shares the ring of window w, which all windows of its size use.  A window of times has a ring of its own.
size_t c_ring_owner(const CUnit *u, size_t w)
{
    size_t i = 0;

    if (ir_stores_times(get_window(u, w)))
        return w;
    while (get_window(u, i)->size != get_window(u, w)->size || ir_stores_times(get_window(u, i)))
        i++;
    return i;
}

bool c_begins_ring(const CUnit *u, size_t w) { return c_ring_owner(u, w) == w; }

// Writes the statements of init that empty all windows.
void c_write_empty_windows(const CUnit *u, Buf *out)
{
    for (size_t w = 0; w < u->m->window.n; w++) {
        if (c_begins_ring(u, w))
            buf_printf(out, "    m->%s = 0;\n", u->ring[w]);
        buf_printf(out, "    memset(m->%s, 0, sizeof m->%s);\n", u->window[w], u->window[w]);
    }
}

// ---- samples: every step adds one to every window, so windows of one size share a ring ----

void c_write_ring_steps(CUnit *u, Buf *out)
{
    for (size_t w = 0; w < u->m->window.n; w++) {
        const unsigned n = (unsigned)get_window(u, w)->size;
        if (c_begins_ring(u, w) && !ir_stores_times(get_window(u, w)))
            buf_printf(out, "    const SmRollAt sm_at_%u = %s(&m->%s, %u);\n", n, helper_require(u, "sm_roll_advance"), u->ring[w], n);
    }
}

// Whether the function that adds sample i to its rolling window reads a NaN as 0, so that the caller need not check for it.
bool c_window_reads_nan_as_zero(const CFn *fn, const IrIns *i)
{
    const uint32_t type = roll_kind(get_window(fn->u, i->var)) & SM_ROLL_TYPE;

    return (type == SM_ROLL_F32 || type == SM_ROLL_F64) && (uint32_t)fn->f->ins.at[i->a].type == type;
}

// Writes sample r, converted to the window's type, as the integer key that roll.h stores in its place and orders by.  An integer is its own key.
static void write_sample_key(CFn *fn, IrRef r, SmType type)
{
    const SmType from = fn->f->ins.at[r].type;
    const IrIns converted = {.op = IR_cvt, .type = type, .a = r, .b = IR_NONE};
    const bool real = type == SM_F32 || type == SM_F64;

    if (real)
        buf_printf(&fn->line, "%s(", helper_require(fn->u, type == SM_F32 ? "sm_roll_of_f32" : "sm_roll_of_f64"));
    if (from == type || (!real && from != SM_F32 && from != SM_F64))
        c_write_value(fn, r, PREC_ANY);
    else
        c_write_conversion(fn, &converted, PREC_ANY);
    if (real)
        buf_char(&fn->line, ')');
}

// Returns the name of the function of roll.h that adds a sample.
static const char *push_function(const IrWindow *w)
{
    if (w->stats & 1u << SM_STAT_MEDIAN)
        return w->size <= SM_ROLL_SHORT ? "sm_roll_push_sorted" : "sm_roll_push_blocks";
    return "sm_roll_push";
}

// Returns the width of the signed integers that can represent all keys of a type of samples.
static unsigned key_bits(uint32_t type)
{
    switch (type) {
    case SM_ROLL_F64:
    case SM_ROLL_U32: return 64;
    case SM_ROLL_F32:
    case SM_ROLL_I32:
    case SM_ROLL_U16: return 32;
    default: return 16;
    }
}

// Writes `NAME(m->WINDOW, SIZE, KIND`; the caller closes the parenthesis.
static void begin_roll_call(CUnit *u, const char *name, size_t w, Buf *out)
{
    const unsigned bits = key_bits(roll_kind(get_window(u, w)) & SM_ROLL_TYPE);

    u->key_bits = u->key_bits < bits ? bits : u->key_bits;
    buf_printf(out, "%s(m->%s, %u, ", helper_require(u, name), u->window[w], (unsigned)get_window(u, w)->size);
    write_kind(get_window(u, w), out);
}

// Writes the statement that adds an event to a window of times.
static void write_event(CFn *fn, const IrIns *i)
{
    const IrWindow *w = get_window(fn->u, i->var);
    const char *function = w->stats & 1u << SM_STAT_ELAPSED ? "sm_roll_push_time" : "sm_roll_extend_run";

    buf_printf(&fn->line, "%s(m->%s, %u, &m->%s, ", helper_require(fn->u, function), fn->u->window[i->var], (unsigned)w->size, fn->u->ring[i->var]);
    write_sample_key(fn, i->a, SM_U32);
    buf_str(&fn->line, ", ");
    c_write_member(fn, fn->u->m->g);
    buf_str(&fn->line, ");");
    c_end_line(fn);
}

// Writes the statement that adds a sample to a rolling window.
void c_write_sample(CFn *fn, const IrIns *i)
{
    const IrWindow *w = get_window(fn->u, i->var);

    fn->uses_m = fn->writes_m = true;
    if (ir_stores_times(w)) {
        write_event(fn, i);
        return;
    }
    begin_roll_call(fn->u, push_function(w), i->var, &fn->line);
    buf_printf(&fn->line, ", sm_at_%u, ", (unsigned)w->size);
    write_sample_key(fn, i->a, (SmType)(roll_kind(w) & SM_ROLL_TYPE));
    buf_str(&fn->line, ");");
    c_end_line(fn);
    if (sm_roll_node_partials(w->size, roll_kind(w)) == 0)
        return;
    begin_roll_call(fn->u, "sm_roll_combine", i->var, &fn->line);
    buf_printf(&fn->line, ", sm_at_%u);", (unsigned)w->size);
    c_end_line(fn);
}

// ---- statistics: one function for each, called wherever it is read ----

static const char *const stat_name[SM_STAT_COUNT] = { "avg", "median", "min", "max", "range", "oldest", "newest", "change", "elapsed", "run_steps",
                                                     "run_time" };

// Writes the call that reads a statistic of a rolling window, whose value is temporary r.
void c_write_statistic_call(CFn *fn, IrRef r)
{
    const IrIns *i = c_ins(fn, r);
    CUnit *u = fn->u;

    fn->uses_m = true;
    u->window_stats_read[i->var] |= 1u << i->stat;
    if (fn->ins[r].sign_free_uses != fn->ins[r].uses)
        u->window_zeros_differ[i->var] |= 1u << i->stat;
    buf_printf(&fn->line, "%s_%s_%s(m)", u->names.prefix, u->window[i->var], stat_name[i->stat]);
}

// Writes `sm_roll_STAT(…)` for a statistic of a window of times.
static void write_statistic_of_times(CUnit *u, size_t w, int stat, Buf *out)
{
    buf_printf(out, "%s(", helper_require(u, format_in(u->arena, "sm_roll_%s", stat_name[stat])));
    if (stat != SM_STAT_RUN_STEPS)
        buf_printf(out, "m->%s, ", u->window[w]);
    if (stat == SM_STAT_ELAPSED)
        buf_printf(out, "%u, ", (unsigned)get_window(u, w)->size);
    buf_printf(out, "&m->%s)", u->ring[w]);
}

// Whether a statistic of window w may be a zero of the wrong sign, because no use distinguishes 0 from -0.  Its function is then faster.
static bool has_any_zero(const CUnit *u, size_t w, int stat)
{
    const IrWindow *window = get_window(u, w);
    const bool by_value = (window->stats & 1u << SM_STAT_MEDIAN) == 0
        ? stat == SM_STAT_MIN || stat == SM_STAT_MAX : stat == SM_STAT_MEDIAN && window->size == 3;

    return by_value && ir_is_float(window->type) && (u->window_zeros_differ[w] >> stat & 1) == 0;
}

// Returns the name of the function of roll.h that reads a statistic of a window of samples.
static const char *statistic_function(const CUnit *u, size_t w, int stat)
{
    if (stat == SM_STAT_AVG && u->soft && get_window(u, w)->type == SM_F32 && get_window(u, w)->size <= SM_SOFT_SUM_MOST)
        return "sm_roll_avg_of_f32";
    return stat == SM_STAT_MEDIAN && get_window(u, w)->size == 3 ? "sm_roll_median_of_3" : format_in(u->arena, "sm_roll_%s", stat_name[stat]);
}

// A further bit of window_stats_read, after those of the statistics: the code reads the median without its fraction.
enum { WHOLE_MEDIAN = SM_STAT_COUNT };

// If r is the median of integers of at most 16 bits, writes it as an integer of type `to`, without its fraction. The
// emitted code then needs no soft numbers.
bool c_try_write_whole_median(CFn *fn, SmType to, IrRef r)
{
    const IrIns *i = &fn->f->ins.at[r];
    CUnit *u = fn->u;

    if (i->op != IR_stat || i->stat != SM_STAT_MEDIAN || fn->ins[r].variable)
        return false;
    switch (roll_kind(get_window(u, i->var)) & SM_ROLL_TYPE) {
    case SM_ROLL_I8: case SM_ROLL_I16: case SM_ROLL_U8: case SM_ROLL_U16: break;
    default: return false;
    }
    fn->uses_m = true;
    u->window_stats_read[i->var] |= 1u << WHOLE_MEDIAN;
    buf_printf(&fn->line, "(%s)%s_%s_whole_median(m)", c_type_of(u, to), u->names.prefix, u->window[i->var]);
    return true;
}

static void write_whole_median_function(CUnit *u, size_t w, Buf *out)
{
    buf_printf(out, "static int32_t %s_%s_whole_median(const %s *m)\n{\n    return ", u->names.prefix, u->window[w], u->names.type);
    begin_roll_call(u, "sm_roll_whole_median", w, out);
    buf_printf(out, ", %s(&m->%s));\n}\n\n", helper_require(u, "sm_roll_count"), u->ring[w]);
}

static void write_statistic_function(CUnit *u, size_t w, int stat, Buf *out)
{
    buf_printf(out, "static %s %s_%s_%s(const %s *m)\n{\n    return ", c_type_of(u, SM_F64), u->names.prefix, u->window[w],
               stat_name[stat], u->names.type);
    if (ir_stores_times(get_window(u, w))) {
        write_statistic_of_times(u, w, stat, out);
    } else {
        begin_roll_call(u, statistic_function(u, w, stat), w, out);
        buf_str(out, has_any_zero(u, w, stat) ? " | SM_ROLL_ANY_ZERO" : "");
        if (stat < SM_STAT_OLDEST)
            buf_printf(out, ", %s(&m->%s))", helper_require(u, "sm_roll_count"), u->ring[w]);
        else
            buf_printf(out, ", &m->%s)", u->ring[w]);
    }
    buf_str(out, ";\n}\n\n");
}

// Writes a function for each statistic that window_stats_read lists.
void c_write_statistic_functions(CUnit *u, Buf *out)
{
    bool any = false;

    for (size_t w = 0; w < u->m->window.n; w++)
        for (int stat = 0; stat <= WHOLE_MEDIAN; stat++)
            if (u->window_stats_read[w] >> stat & 1) {
                buf_str(out, any ? "" : "// ---- statistics of rolling windows ----\n\n");
                any = true;
                if (stat == WHOLE_MEDIAN)
                    write_whole_median_function(u, w, out);
                else
                    write_statistic_function(u, w, stat, out);
            }
}
