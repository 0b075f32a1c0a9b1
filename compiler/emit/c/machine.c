// SPDX-License-Identifier: Apache-2.0
// The functions of a machine: one for each block that has code, and those that the user calls.
#include <string.h>

#include "compiler/emit/c/fn.h"

// Limits on the number of states in one switch, because compile time grows faster than the switch.  gcc inlines a function that is called once
// until the caller reaches 2,700 of its size units: with a hundred states of ten statements each, it inlined less than half.  A machine of a
// thousand states took 1.4 times as long to compile with one switch as with parts of 32 states.
enum { STATES_IN_ONE_SWITCH = 100, STATES_PER_PART = 32 };

// The block functions of a state.
typedef struct CStateBlocks {
    CSignature block[BLOCK_COUNT];
    bool has[BLOCK_COUNT];        // the function was written
} CStateBlocks;

static const char *const block_name[BLOCK_COUNT] = { "entry", "step", "exit" };

// ---- blocks ----

static const char *file_base_name(const char *path)
{
    const char *slash = strrchr(path, '/'), *back = strrchr(path, '\\');

    if (back && (!slash || back > slash))
        slash = back;
    return slash ? slash + 1 : path;
}

// Returns `, tank.sm:12`, or "" if the source is unknown.
static const char *source_location(const CUnit *u, Span s)
{
    if (!s.src)
        return "";
    return format_in(u->arena, ", %s:%u", file_base_name(s.src->name), (unsigned)source_position(s.src, s.at).line);
}

static const char *block_comment(const CUnit *u, size_t state, BlockKind k)
{
    const Program *p = u->m->program;
    const Span none = { 0 };

    return format_in(u->arena, "// [%s] .%s%s\n", u->m->state.at[state].name->text, block_name[k],
                     source_location(u, p ? p->state.at[state]->block_span[k] : none));
}

// Writes the function of a block.  A .exit is not written if the state has no transition.
static void write_state_block(CUnit *u, size_t i, BlockKind k, CStateBlocks *s, Buf *out)
{
    const IrFn *f = u->m->state.at[i].block[k];
    CFunction what = { f, facts_at_begin(u->facts, i, (int)k), NULL, NULL };
    const bool never = k == BLOCK_EXIT && !s->block[BLOCK_ENTRY].returns_state && !s->block[BLOCK_STEP].returns_state;

    if (!f || never)
        return;
    what.name = format_in(u->arena, "%s_%s_%s", u->names.prefix, u->names.state[i], block_name[k]);
    what.comment = block_comment(u, i, k);
    s->block[k] = c_write_function(u, &what, out);
    s->has[k] = true;
}

static CStateBlocks *write_blocks(CUnit *u, Buf *out)
{
    CStateBlocks *s = ARENA_ARRAY(u->arena, CStateBlocks, u->m->state.n);

    for (size_t i = 0; i < u->m->state.n; i++)
        for (int k = 0; k < BLOCK_COUNT; k++)
            write_state_block(u, i, (BlockKind)k, &s[i], out);
    return s;
}

const char *c_state_type(const CUnit *u)
{
    return !u->soft || u->m->state.n > UINT16_MAX ? "uint32_t" : u->m->state.n > UINT8_MAX ? "uint16_t" : "uint8_t";
}

static const char *result_type(const CUnit *u, const CSignature *s) { return s->returns_state ? c_state_type(u) : "void"; }

// Writes the argument list of a call of a function with signature s.
static void write_arguments(const CSignature *s, Buf *out)
{
    buf_printf(out, "(%s%s%s);\n", s->m ? "m" : "", s->m && s->sv ? ", " : "", s->sv ? "sv" : "");
}

static void write_parameters(const CUnit *u, const CSignature *s, Buf *out)
{
    buf_printf(out, "(%s *m%s%s%s)", u->names.type, s->sv ? ", " : "", s->sv ? u->names.sv_type : "", s->sv ? " *sv" : "");
}

// ---- init ----

static void write_initial_values(CUnit *u, Buf *out)
{
    for (size_t v = 0; v < u->m->var.n; v++) {
        const IrVar *var = &u->m->var.at[v];
        if (var->space != IR_LOCAL)
            continue;
        buf_printf(out, "    m->%s = ", u->names.var[v]);
        literal_write(u, out, var->type, var->init);
        buf_str(out, ";\n");
    }
}

static void write_init(CUnit *u, Buf *out)
{
    const CNames *n = &u->names;
    const char *s = n->var[u->m->s];

    buf_printf(out, "%sStatus %s_init(%s *m, %s *sv, uint32_t state)\n{\n", n->type, n->prefix, n->type, n->sv_type);
    buf_printf(out, "    m->state_ = 0;\n    m->first_ = false;\n    m->gate_ = 0;\n%s    m->start_ = UINT64_MAX;\n",
               u->soft ? "" : "    m->left_ = UINT64_MAX;\n");
    if (u->fit)
        buf_printf(out, "    if (!%s()) {\n        return %s_UNFIT;\n    }\n", u->fit, n->macro);
    buf_printf(out, "    if (state < 1 || state > %s_STATES) {\n        return %s_NO_STATE;\n    }\n", n->macro, n->macro);
    buf_printf(out, "    m->state_ = %s%s%sstate;\n    m->first_ = true;\n", u->soft ? "(" : "", u->soft ? c_state_type(u) : "", u->soft ? ")" : "");
    write_initial_values(u, out);
    c_write_empty_windows(u, out);
    buf_str(out, u->track_stores ? "    memset(&m->stored, 0, sizeof m->stored);\n" : "");
    buf_printf(out, "    sv->%s = state;\n    return %s_OK;\n}\n\n", s, n->macro);
}

// ---- the blocks of the current state ----

// Returns the signature of a function that can call the blocks of a kind of all states.
static CSignature common_signature(const CUnit *u, const CStateBlocks *s, BlockKind k)
{
    CSignature all = { false, true, false };

    for (size_t i = 0; i < u->m->state.n; i++) {
        all.returns_state |= s[i].has[k] && s[i].block[k].returns_state;
        all.sv |= s[i].has[k] && s[i].block[k].sv;
    }
    return all;
}

// Whether a state has a block of kind k.
static bool has_block_of_kind(const CUnit *u, const CStateBlocks *s, BlockKind k)
{
    for (size_t i = 0; i < u->m->state.n; i++)
        if (s[i].has[k])
            return true;
    return false;
}

// Writes the case of state i, which calls its block.  `as`: signature of the function around the switch.
static void write_case(const CUnit *u, size_t i, BlockKind k, const CStateBlocks *s, CSignature as, Buf *out)
{
    const CSignature *b = &s[i].block[k];

    if (!s[i].has[k])
        return;
    buf_printf(out, "    case %s_STATE_%s:\n        %s%s_%s_%s", u->names.macro, u->names.state[i], b->returns_state ? "return " : "",
               u->names.prefix, u->names.state[i], block_name[k]);
    write_arguments(b, out);
    buf_str(out, b->returns_state ? "" : as.returns_state ? "        return 0;\n" : "        break;\n");
}

// Writes a function with a switch that calls the block of the current state, for states `from` to `to` - 1.
static void write_dispatch_switch(const CUnit *u, const char *name, BlockKind k, const CStateBlocks *s, size_t from, size_t to, CSignature as, Buf *out)
{
    buf_printf(out, "static %s %s", result_type(u, &as), name);
    write_parameters(u, &as, out);
    buf_str(out, "\n{\n    switch (m->state_) {\n");
    for (size_t i = from; i < to; i++)
        write_case(u, i, k, s, as, out);
    buf_printf(out, "    default:\n        %s;\n    }\n}\n\n", as.returns_state ? "return 0" : "break");
}

// Writes the dispatch for more than STATES_IN_ONE_SWITCH states: several functions with a switch, called through a table of pointers, because
// compilers would inline direct calls.
static void write_split_dispatch(const CUnit *u, const char *name, BlockKind k, const CStateBlocks *s, CSignature as, Buf *out)
{
    const size_t n = u->m->state.n;

    for (size_t i = 0; i < n; i += STATES_PER_PART) {
        const size_t end = i + STATES_PER_PART < n ? i + STATES_PER_PART : n;
        buf_printf(out, "// States %u to %u.\n", (unsigned)i + 1, (unsigned)end);
        write_dispatch_switch(u, format_in(u->arena, "%s_%u", name, (unsigned)i + 1), k, s, i, end, as, out);
    }
    buf_printf(out, "static %s (*const %ss[])", result_type(u, &as), name);
    write_parameters(u, &as, out);
    buf_str(out, " = {\n");
    for (size_t i = 0; i < n; i += STATES_PER_PART)
        buf_printf(out, "    %s_%u,\n", name, (unsigned)i + 1);
    buf_printf(out, "};\n\nstatic %s %s", result_type(u, &as), name);
    write_parameters(u, &as, out);
    buf_printf(out, "\n{\n    %s%ss[(m->state_ - 1) / %d]", as.returns_state ? "return " : "", name, STATES_PER_PART);
    write_arguments(&as, out);
    buf_str(out, "}\n\n");
}

// Returns the name of the function that calls the block of a kind of the current state.
static const char *dispatch_name(const CUnit *u, BlockKind k)
{
    return format_in(u->arena, "%s_%s", u->names.prefix, k == BLOCK_ENTRY ? "enter" : k == BLOCK_STEP ? "run" : "leave");
}

// Writes the function that calls the block of kind k of the current state, unless no state has one.  Returns its signature.
static CSignature write_dispatch(const CUnit *u, BlockKind k, const CStateBlocks *s, Buf *out)
{
    const CSignature as = common_signature(u, s, k);

    if (!has_block_of_kind(u, s, k))
        return as;
    buf_printf(out, "// The .%s of the state%s.\n", block_name[k], as.returns_state ? "; returns the next state, or 0" : "");
    if (u->m->state.n > STATES_IN_ONE_SWITCH)
        write_split_dispatch(u, dispatch_name(u, k), k, s, as, out);
    else
        write_dispatch_switch(u, dispatch_name(u, k), k, s, 0, u->m->state.n, as, out);
    return as;
}

// ---- step ----

// What the step function calls.
typedef struct CStepParts {
    bool has[BLOCK_COUNT];        // a state has a block of this kind
    CSignature dispatch[BLOCK_COUNT];     // the functions that write_dispatch wrote
    const CSignature *sample;     // NULL: no windows to sample
    bool first;                   // the step must know whether it is a state's first
    bool transition;              // a block can make a transition
} CStepParts;

// Writes the functions that call the blocks of the current state.  Returns what the step function has to call.
static CStepParts write_dispatch_functions(CUnit *u, const CStateBlocks *s, const CSignature *sample, Buf *out)
{
    CStepParts w = { { false }, { { false, false, false } }, sample, false, false };

    for (int k = 0; k < BLOCK_COUNT; k++) {
        w.dispatch[k] = write_dispatch(u, (BlockKind)k, s, out);
        w.has[k] = has_block_of_kind(u, s, (BlockKind)k);
    }
    w.first = w.has[BLOCK_ENTRY] || u->track_stores;
    w.transition = w.dispatch[BLOCK_ENTRY].returns_state || w.dispatch[BLOCK_STEP].returns_state;
    return w;
}

// Writes the check that time has advanced, and the start of a first step.  `left`, the time until time ends, is compared with m->gate_.
static void write_time_check(const CUnit *u, const CStepParts *w, Buf *out)
{
    const CNames *n = &u->names;

    buf_str(out, "\n    // The gate is 0 before a state's first step, and if init has not succeeded.\n"
                 "    if (left >= m->gate_) {\n        if (!m->first_ || left >= m->left_) {\n");
    buf_printf(out, "            return m->state_ == 0 ? %s_NO_STATE : %s_REFUSED;\n        }\n", n->macro, n->macro);
    buf_printf(out, "        m->first_ = false;\n%s        m->start_ = sv->%s;\n        sv->%s = m->state_;\n    }\n    m->gate_ = left;\n",
               w->first ? "        first = true;\n" : "", n->var[u->m->g], n->var[u->m->s]);
}

// As write_time_check, for soft numbers: tests the flag m->first_ first, which an 8-bit chip does faster than comparing 64 bits.
static void write_soft_time_check(const CUnit *u, const CStepParts *w, Buf *out)
{
    const CNames *n = &u->names;

    buf_printf(out, "\n    if (m->state_ == 0 || !sm_soft_advance(&m->gate_, &sv->%s)) {\n", n->var[u->m->g]);
    buf_printf(out, "        return m->state_ == 0 ? %s_NO_STATE : %s_REFUSED;\n    }\n", n->macro, n->macro);
    buf_printf(out, "    if (m->first_) {\n        m->first_ = false;\n%s        m->start_ = sv->%s;\n        sv->%s = m->state_;\n    }\n",
               w->first ? "        first = true;\n" : "", n->var[u->m->g], n->var[u->m->s]);
}

// Writes the step function up to where blocks run: the check of time, and the start of a first step.
static void write_step_head(const CUnit *u, const CStepParts *w, Buf *out)
{
    const CNames *n = &u->names;

    buf_printf(out, "%sStatus %s_step(%s *m, %s *sv)\n{\n", n->type, n->prefix, n->type, n->sv_type);
    if (!u->soft)
        buf_printf(out, "    const uint64_t left = UINT64_MAX - 1 - sv->%s;      // until time ends; the largest value when it has\n", n->var[u->m->g]);
    buf_str(out, w->first ? "    bool first = false;\n" : "");
    if (w->transition)
        buf_printf(out, "    %s next = 0;      // the next state\n", c_state_type(u));
    (u->soft ? write_soft_time_check : write_time_check)(u, w, out);
    if (u->track_stores)
        buf_printf(out, "    memset(&m->stored, 0, sizeof m->stored);\n    m->stored.%s = first;\n", n->var[u->m->s]);
}

static void write_dispatch_call(const CUnit *u, const CStepParts *w, BlockKind k, const char *result, Buf *out)
{
    buf_printf(out, "%s%s", result, dispatch_name(u, k));
    write_arguments(&w->dispatch[k], out);
}

// Writes the rest of the step function: runs the blocks and takes the transition.
static void write_step_blocks(const CUnit *u, const CStepParts *w, Buf *out)
{
    if (w->has[BLOCK_ENTRY]) {
        buf_str(out, "    if (first) {\n        ");
        write_dispatch_call(u, w, BLOCK_ENTRY, w->dispatch[BLOCK_ENTRY].returns_state ? "next = " : "", out);
        buf_str(out, "    }\n");
    }
    if (w->has[BLOCK_STEP]) {
        const bool guarded = w->has[BLOCK_ENTRY] && w->dispatch[BLOCK_ENTRY].returns_state;
        buf_str(out, guarded ? "    if (next == 0) {\n        " : "    ");
        write_dispatch_call(u, w, BLOCK_STEP, w->dispatch[BLOCK_STEP].returns_state ? "next = " : "", out);
        buf_str(out, guarded ? "    }\n" : "");
    }
    if (w->transition) {
        buf_str(out, "    if (next != 0) {\n");
        if (w->has[BLOCK_EXIT]) {
            buf_str(out, "        ");
            write_dispatch_call(u, w, BLOCK_EXIT, "", out);
        }
        buf_printf(out, "        m->state_ = next;\n        m->first_ = true;\n%s    }\n", u->soft ? "" : "        m->left_ = left;\n        m->gate_ = 0;\n");
    }
    buf_printf(out, "    return %s_OK;\n}\n\n", u->names.macro);
}

static void write_step(CUnit *u, const CStateBlocks *s, const CSignature *sample, Buf *out)
{
    const CStepParts w = write_dispatch_functions(u, s, sample, out);

    write_step_head(u, &w, out);
    if (w.sample) {
        buf_printf(out, "    %s_sample", u->names.prefix);
        write_arguments(w.sample, out);
    }
    write_step_blocks(u, &w, out);
}

// ---- state, T and state_name ----

static void write_queries(const CUnit *u, Buf *out)
{
    const CNames *n = &u->names;

    buf_printf(out, "uint32_t %s_state(const %s *m)\n{\n    return m->state_;\n}\n\n", n->prefix, n->type);
    buf_printf(out, "uint64_t %s_T(const %s *m)\n{\n", n->prefix, n->type);
    buf_str(out, u->soft ? "    return m->gate_ - 1 - m->start_;\n}\n\n"
                         : "    const uint64_t left = m->first_ ? m->left_ : m->gate_;\n\n    return UINT64_MAX - 1 - left - m->start_;\n}\n\n");
    buf_printf(out, "const char *%s_state_name(uint32_t state)\n{\n    static const char *const name[] = {\n        \"\",\n", n->prefix);
    for (size_t i = 0; i < u->m->state.n; i++)
        buf_printf(out, "        \"%s\",\n", u->m->state.at[i].name->text);
    buf_printf(out, "    };\n\n    return state <= %s_STATES ? name[state] : \"\";\n}\n", n->macro);
}

void c_write_machine(CUnit *u, Buf *out)
{
    CSignature sample = { 0 };
    CStateBlocks *s;
    Buf code;

    buf_init(&code, u->arena);
    if (u->m->sample) {
        const CFunction what = { u->m->sample, facts_at_begin_of_sample(u->facts), format_in(u->arena, "%s_sample", u->names.prefix),
                                 "// Adds the sample of this step to every rolling window.\n" };
        sample = c_write_function(u, &what, &code);
    }
    for (size_t w = 0; w < u->m->window.n; w++)
        u->window_sample[w] = UINT32_MAX;
    s = write_blocks(u, &code);
    c_write_statistic_functions(u, out);
    buf_str(out, "// ---- the states.  A block returns the number of the next state, or 0 to stay. ----\n\n");
    buf_str(out, buf_text(&code));
    buf_str(out, "// ---- the machine ----\n\n");
    write_init(u, out);
    write_step(u, s, u->m->sample ? &sample : NULL, out);
    write_queries(u, out);
}
