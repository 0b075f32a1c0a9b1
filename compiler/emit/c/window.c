// SPDX-License-Identifier: Apache-2.0
// Rolling windows in emitted C: an array of words for each, and calls into stdlib/roll.h.  Size and kind are constants, so that a compiler
// specialises each call for its window.
#include "compiler/emit/c/fn.h"
#include "stdlib/roll.h"

static const IrWindow *window(const CUnit *u, size_t w) { return &u->m->window.at[w]; }

static uint32_t kind_of(const IrWindow *w) { return sm_roll_kind(w->type, w->stats); }

// `SM_ROLL_F32 | SM_ROLL_AVG | SM_ROLL_MAX`
static void write_kind(const IrWindow *w, Buf *out)
{
    static const char *const type[] = {
#define SM_TYPE(name, wire, spelling, ctype, bytes, kind) [wire] = #name,
#include "stdlib/types.def"
#undef SM_TYPE
    };
    static const char *const stat[SM_STAT_COUNT] = { "AVG", "MEDIAN", "MIN", "MAX", "RANGE" };

    buf_printf(out, "SM_ROLL_%s", type[kind_of(w) & SM_ROLL_TYPE]);
    for (int s = 0; s < SM_STAT_COUNT; s++)
        if (w->stats >> s & 1)
            buf_printf(out, " | SM_ROLL_%s", stat[s]);
}

const char *c_window_declaration(const CUnit *u, size_t w)
{
    const uint32_t kind = kind_of(window(u, w)), n = window(u, w)->size;
    const unsigned words = (unsigned)sm_roll_words(n, kind), small = (unsigned)c_small_roll_words(n, kind);

    return words == small ? format_in(u->arena, "%s[%u]", u->window[w], words)
                          : format_in(u->arena, "%s[SM_ROLL_SMALL ? %u : %u]", u->window[w], small, words);
}

void c_write_empty_windows(const CUnit *u, Buf *out)
{
    for (size_t w = 0; w < u->m->window.n; w++)
        buf_printf(out, "    memset(m->%s, 0, sizeof m->%s);\n", u->window[w], u->window[w]);
}

bool c_window_reads_nan(const CFn *fn, const IrIns *i)
{
    const uint32_t type = kind_of(window(fn->u, i->var)) & SM_ROLL_TYPE;

    return (type == SM_ROLL_F32 || type == SM_ROLL_F64) && (uint32_t)fn->f->ins.at[i->a].type == type;
}

// Writes the key of a sample, which is a number of the window's type.  An integer is its own key.
static void write_key(CFn *fn, IrRef r, SmType type)
{
    const SmType from = fn->f->ins.at[r].type;
    const IrIns converted = {.op = IR_cvt, .type = type, .a = r, .b = IR_NONE};
    const bool real = type == SM_F32 || type == SM_F64;

    if (real)
        buf_printf(&fn->line, "%s(", helper_use(fn->u, type == SM_F32 ? "sm_roll_of_f32" : "sm_roll_of_f64"));
    if (from == type || (!real && from != SM_F32 && from != SM_F64))
        c_write_value(fn, r, PREC_ANY);
    else
        c_write_cvt(fn, &converted, PREC_ANY);
    if (real)
        buf_char(&fn->line, ')');
}

// The function of roll.h that adds a sample.
static const char *push_helper(const IrWindow *w)
{
    if (w->stats & 1u << SM_STAT_MEDIAN)
        return w->size <= SM_ROLL_SHORT ? "sm_roll_push_sorted" : "sm_roll_push_blocks";
    return "sm_roll_push";
}

// `NAME(m->WINDOW, SIZE, KIND`
static void write_call(CUnit *u, const char *name, size_t w, Buf *out)
{
    buf_printf(out, "%s(m->%s, %u, ", helper_use(u, name), u->window[w], (unsigned)window(u, w)->size);
    write_kind(window(u, w), out);
}

void c_write_sample(CFn *fn, const IrIns *i)
{
    const IrWindow *w = window(fn->u, i->var);

    fn->uses_m = fn->writes_m = true;
    write_call(fn->u, push_helper(w), i->var, &fn->line);
    buf_str(&fn->line, ", ");
    write_key(fn, i->a, (SmType)(kind_of(w) & SM_ROLL_TYPE));
    buf_str(&fn->line, ");");
    c_end_line(fn);
    if (sm_roll_node_partials(w->size, kind_of(w)) == 0)
        return;
    write_call(fn->u, "sm_roll_combine", i->var, &fn->line);
    buf_str(&fn->line, ");");
    c_end_line(fn);
}

// ---- statistics: one function for each, called wherever it is read ----

static const char *const stat_name[SM_STAT_COUNT] = { "avg", "median", "min", "max", "range" };

void c_write_stat(CFn *fn, const IrIns *i)
{
    CUnit *u = fn->u;

    fn->uses_m = true;
    u->window_asked[i->var] |= 1u << i->stat;
    buf_printf(&fn->line, "%s_%s_%s(m)", u->names.prefix, u->window[i->var], stat_name[i->stat]);
}

static void write_statistic(CUnit *u, size_t w, int stat, Buf *out)
{
    buf_printf(out, "static %s %s_%s_%s(const %s *m)\n{\n    return ", c_type_of(u, SM_F64), u->names.prefix, u->window[w],
               stat_name[stat], u->names.type);
    write_call(u, format_in(u->arena, "sm_roll_%s", stat_name[stat]), w, out);
    buf_str(out, ");\n}\n\n");
}

void c_write_statistics(CUnit *u, Buf *out)
{
    bool any = false;

    for (size_t w = 0; w < u->m->window.n; w++)
        for (int stat = 0; stat < SM_STAT_COUNT; stat++)
            if (u->window_asked[w] >> stat & 1) {
                buf_str(out, any ? "" : "// ---- statistics of rolling windows ----\n\n");
                any = true;
                write_statistic(u, w, stat, out);
            }
}
