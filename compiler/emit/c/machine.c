// SPDX-License-Identifier: Apache-2.0
// The functions of a machine: one for each block that does something, and those that the user calls.
#include <string.h>

#include "compiler/emit/c/fn.h"

enum { CUT_FROM = 400, PART = 100 };      // states

// What the step must know of a state.
typedef struct CState {
    CSignature block[BLOCK_COUNT];
    bool has[BLOCK_COUNT];
} CState;

static const char *const block_name[BLOCK_COUNT] = { "entry", "step", "exit" };

// ---- blocks ----

static const char *base_name(const char *path)
{
    const char *slash = strrchr(path, '/'), *back = strrchr(path, '\\');

    if (back && (!slash || back > slash))
        slash = back;
    return slash ? slash + 1 : path;
}

// tank.sm:12, or nothing where the source is not known.
static const char *place(const CUnit *u, Span s)
{
    if (!s.src)
        return "";
    return format_in(u->arena, ", %s:%u", base_name(s.src->name), (unsigned)source_position(s.src, s.at).line);
}

static const char *block_comment(const CUnit *u, size_t state, BlockKind k)
{
    const Program *p = u->m->program;
    const Span none = { 0 };

    return format_in(u->arena, "// [%s] .%s%s\n", u->m->state.at[state].name->text, block_name[k],
                     place(u, p ? p->state.at[state]->block_span[k] : none));
}

static void put_state_block(CUnit *u, size_t i, BlockKind k, CState *s, Buf *out)
{
    const IrFn *f = u->m->state.at[i].block[k];
    const bool never = k == BLOCK_EXIT && !s->block[BLOCK_ENTRY].returns_state && !s->block[BLOCK_STEP].returns_state;

    if (!f || never)
        return;
    s->block[k] = put_function(u, f, format_in(u->arena, "%s_%s_%s", u->names.prefix, u->names.state[i], block_name[k]),
                               block_comment(u, i, k), out);
    s->has[k] = true;
}

static CState *put_blocks(CUnit *u, Buf *out)
{
    CState *s = ARENA_ARRAY(u->arena, CState, u->m->state.n);

    for (size_t i = 0; i < u->m->state.n; i++)
        for (int k = 0; k < BLOCK_COUNT; k++)
            put_state_block(u, i, (BlockKind)k, &s[i], out);
    return s;
}

static void put_call_of(const char *name, CSignature s, Buf *out)
{
    buf_printf(out, "%s%s(%s%s%s);\n", s.returns_state ? "next = " : "", name, s.m ? "m" : "", s.m && s.sv ? ", " : "", s.sv ? "sv" : "");
}

// ---- init ----

static void put_initial_values(CUnit *u, Buf *out)
{
    for (size_t v = 0; v < u->m->var.n; v++) {
        const IrVar *var = &u->m->var.at[v];
        if (var->space != IR_LOCAL)
            continue;
        buf_printf(out, "    m->%s = ", u->names.var[v]);
        literal_put(u, out, var->type, var->init);
        buf_str(out, ";\n");
    }
}

static void put_empty_windows(CUnit *u, Buf *out)
{
    for (size_t w = 0; w < u->m->window.n; w++) {
        const bool sorted = (u->m->window.at[w].stats & 1u << SM_STAT_MEDIAN) != 0;
        const char *name = u->window[w];
        buf_printf(out, "    %s(&m->%s, m->%s_slot_, %s%s%s, %u);\n", helper_use(u, "sm_roll_begin"), name, name,
                   sorted ? "m->" : "NULL", sorted ? name : "", sorted ? "_sorted_" : "", u->m->window.at[w].size);
    }
}

static void put_init(CUnit *u, Buf *out)
{
    const CNames *n = &u->names;
    const char *s = n->var[u->m->s];

    buf_printf(out, "%sStatus %s_init(%s *m, %s *sv, uint32_t state)\n{\n", n->type, n->prefix, n->type, n->sv_type);
    buf_printf(out, "    m->state_ = 0;\n"
                    "    if (!%s()) {\n        return %s_UNFIT;\n    }\n", u->fit, n->macro);
    buf_printf(out, "    if (state < 1 || state > %s_STATES) {\n        return %s_NO_STATE;\n    }\n", n->macro, n->macro);
    buf_str(out, "    m->state_ = state;\n    m->first_ = true;\n    m->ran_ = false;\n    m->start_ = 0;\n    m->last_ = 0;\n"
                 "    m->T = 0;\n");
    put_initial_values(u, out);
    put_empty_windows(u, out);
    buf_printf(out, "    memset(&m->stored, 0, sizeof m->stored);\n"
                    "    sv->%s = state;\n    return %s_OK;\n}\n\n", s, n->macro);
}

// ---- step ----

static void put_case(const CUnit *u, size_t i, const CState *s, Buf *out)
{
    const char *name = format_in(u->arena, "%s_%s_", u->names.prefix, u->names.state[i]);
    const bool guarded = s->has[BLOCK_ENTRY] && s->block[BLOCK_ENTRY].returns_state;

    if (!s->has[BLOCK_ENTRY] && !s->has[BLOCK_STEP])
        return;
    buf_printf(out, "    case %s_STATE_%s:\n", u->names.macro, u->names.state[i]);
    if (s->has[BLOCK_ENTRY]) {
        buf_str(out, "        if (first) {\n            ");
        put_call_of(format_in(u->arena, "%sentry", name), s->block[BLOCK_ENTRY], out);
        buf_str(out, "        }\n");
    }
    if (s->has[BLOCK_STEP]) {
        buf_str(out, guarded ? "        if (next == 0) {\n            " : "        ");
        put_call_of(format_in(u->arena, "%sstep", name), s->block[BLOCK_STEP], out);
        buf_str(out, guarded ? "        }\n" : "");
    }
    if (s->has[BLOCK_EXIT]) {
        buf_str(out, "        if (next != 0) {\n            ");
        put_call_of(format_in(u->arena, "%sexit", name), s->block[BLOCK_EXIT], out);
        buf_str(out, "        }\n");
    }
    buf_str(out, "        break;\n");
}

// Compilers choke on a function of ten thousand states.  Above some hundreds the switch is cut into functions that a table
// leads to, for what is called directly would be put together again.
static bool is_cut(const CUnit *u) { return u->m->state.n > CUT_FROM; }

typedef struct CMachineUse { bool transition, any; } CMachineUse;

static CMachineUse machine_use(const CUnit *u, const CState *s)
{
    CMachineUse use = { 0 };

    for (size_t i = 0; i < u->m->state.n; i++) {
        use.any |= s[i].has[BLOCK_ENTRY] || s[i].has[BLOCK_STEP];
        use.transition |= s[i].block[BLOCK_ENTRY].returns_state || s[i].block[BLOCK_STEP].returns_state;
    }
    return use;
}

static void put_step_start(const CUnit *u, CMachineUse use, Buf *out)
{
    const CNames *n = &u->names;
    const char *s = n->var[u->m->s];

    buf_printf(out, "%sStatus %s_step(%s *m, %s *sv)\n{\n", n->type, n->prefix, n->type, n->sv_type);
    buf_printf(out, "    const uint64_t now = sv->%s;\n    const bool first = m->first_;\n%s\n", n->var[u->m->g],
               use.transition ? "    uint32_t next = 0;      // the state to go to\n" : "");
    buf_printf(out, "    if (m->state_ == 0%s) {\n        return %s_NO_STATE;\n    }\n",
               is_cut(u) ? format_in(u->arena, " || m->state_ > %s_STATES", n->macro) : "", n->macro);
    buf_printf(out, "    if (now == UINT64_MAX || (m->ran_ && now <= m->last_)) {\n        return %s_REFUSED;\n    }\n", n->macro);
    buf_str(out, "    m->ran_ = true;\n    m->last_ = now;\n    memset(&m->stored, 0, sizeof m->stored);\n");
    buf_printf(out, "    if (first) {\n        m->start_ = now;\n        sv->%s = m->state_;\n        m->stored.%s = true;\n    }\n", s, s);
    buf_str(out, "    m->T = now - m->start_;\n");
}

static void put_switch(const CUnit *u, const CState *s, size_t from, size_t to, Buf *out)
{
    buf_str(out, "    switch (m->state_) {\n");
    for (size_t i = from; i < to; i++)
        put_case(u, i, &s[i], out);
    buf_str(out, "    default:\n        break;\n    }\n");
}

static void put_parts(const CUnit *u, const CState *s, Buf *out)
{
    const size_t n = u->m->state.n;

    for (size_t i = 0; i < n; i += PART) {
        const size_t end = i + PART < n ? i + PART : n;
        buf_printf(out, "// States %u to %u.\nstatic uint32_t %s_run_%u(%s *m, %s *sv, bool first)\n{\n    uint32_t next = 0;\n\n"
                        "    (void)sv;\n    (void)first;\n", (unsigned)i + 1, (unsigned)end, u->names.prefix, (unsigned)i + 1,
                   u->names.type, u->names.sv_type);
        put_switch(u, s, i, end, out);
        buf_str(out, "    return next;\n}\n\n");
    }
    buf_printf(out, "static uint32_t (*const %s_run[])(%s *m, %s *sv, bool first) = {\n", u->names.prefix, u->names.type, u->names.sv_type);
    for (size_t i = 0; i < n; i += PART)
        buf_printf(out, "    %s_run_%u,\n", u->names.prefix, (unsigned)i + 1);
    buf_str(out, "};\n\n");
}

static void put_step(const CUnit *u, const CState *s, const CSignature *sample, Buf *out)
{
    CMachineUse use = machine_use(u, s);

    use.transition |= is_cut(u);
    if (is_cut(u))
        put_parts(u, s, out);
    put_step_start(u, use, out);
    if (sample) {
        buf_str(out, "    ");
        put_call_of(format_in(u->arena, "%s_sample", u->names.prefix), *sample, out);
    }
    if (is_cut(u))
        buf_printf(out, "    next = %s_run[(m->state_ - 1) / %d](m, sv, first);\n", u->names.prefix, PART);
    else if (use.any)
        put_switch(u, s, 0, u->m->state.n, out);
    if (use.transition)
        buf_str(out, "    m->first_ = next != 0;\n    if (next != 0) {\n        m->state_ = next;\n    }\n");
    else
        buf_str(out, "    m->first_ = false;\n");
    buf_printf(out, "    return %s_OK;\n}\n\n", u->names.macro);
}

// ---- the rest ----

static void put_state(const CUnit *u, Buf *out)
{
    const CNames *n = &u->names;

    buf_printf(out, "uint32_t %s_state(const %s *m)\n{\n    return m->state_;\n}\n\n", n->prefix, n->type);
    buf_printf(out, "const char *%s_state_name(uint32_t state)\n{\n    static const char *const name[] = {\n        \"\",\n", n->prefix);
    for (size_t i = 0; i < u->m->state.n; i++)
        buf_printf(out, "        \"%s\",\n", u->m->state.at[i].name->text);
    buf_printf(out, "    };\n\n    return state <= %s_STATES ? name[state] : \"\";\n}\n", n->macro);
}

void put_machine(CUnit *u, Buf *out)
{
    CSignature sample = { 0 };
    CState *s;

    if (u->m->sample)
        sample = put_function(u, u->m->sample, format_in(u->arena, "%s_sample", u->names.prefix),
                              "// Gives every rolling window its sample of this step.  Its memory is set anew each time, so that a copy of the machine\n"
                              "// uses its own.\n", out);
    for (size_t w = 0; w < u->m->window.n; w++)
        u->window_sample[w] = UINT32_MAX;
    s = put_blocks(u, out);
    buf_str(out, "// ---- the machine ----\n\n");
    put_init(u, out);
    put_step(u, s, u->m->sample ? &sample : NULL, out);
    put_state(u, out);
}
