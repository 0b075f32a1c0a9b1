// SPDX-License-Identifier: Apache-2.0
// The functions of a machine: one for each block that has code, and those that the user calls.
#include <string.h>

#include "compiler/emit/c/fn.h"

// Limits on the number of states in one switch, because compile time grows faster than the switch.  gcc inlines a function that is called once
// until the caller reaches 2,700 of its size units: with a hundred states of ten statements each, it inlined less than half.  Compared
// with parts of 32 states, a machine of a thousand states took 1.4 times as long to compile with one switch, 1.9 times with a function per state.
// One of 250 states takes 1.1 s instead of 0.7 s, but a step is a fifth faster.
enum { STATES_IN_ONE_SWITCH = 256, STATES_PER_PART = 32 };

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

// Returns the comment line before the function of a state's block.
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

// Writes a C function for each entry, step and exit block.  Returns by state: which blocks have functions, and the signatures of these.
static CStateBlocks *write_blocks(CUnit *u, Buf *out)
{
    CStateBlocks *s = ARENA_ARRAY(u->arena, CStateBlocks, u->m->state.n);

    for (size_t i = 0; i < u->m->state.n; i++)
        for (int k = 0; k < BLOCK_COUNT; k++)
            write_state_block(u, i, (BlockKind)k, &s[i], out);
    return s;
}

// Returns the C type for a state's number or 0: the shortest that can represent all if numbers are soft.
const char *c_state_type(const CUnit *u)
{
    return !u->soft || u->m->state.n > UINT16_MAX ? "uint32_t" : u->m->state.n > UINT8_MAX ? "uint16_t" : "uint8_t";
}

// Writes the argument list of a call of a function with signature s.
static void write_arguments(const CSignature *s, Buf *out)
{
    buf_printf(out, "(%s%s%s);\n", s->m ? "m" : "", s->m && s->sv ? ", " : "", s->sv ? "sv" : "");
}

// ---- init ----

// Writes the assignments of initial values to the machine's locals.
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
    if (u->self_test)
        buf_printf(out, "    if (!sm_is_fit()) {\n        return %s_UNFIT;\n    }\n", n->macro);
    buf_printf(out, "    if (state < 1 || state > %s_STATES) {\n        return %s_NO_STATE;\n    }\n", n->macro, n->macro);
    buf_printf(out, "    m->state_ = %s%s%sstate;\n    m->first_ = true;\n", u->soft ? "(" : "", u->soft ? c_state_type(u) : "", u->soft ? ")" : "");
    write_initial_values(u, out);
    c_write_empty_windows(u, out);
    buf_str(out, u->track_stores ? "    memset(&m->stored, 0, sizeof m->stored);\n" : "");
    buf_printf(out, "    sv->%s = state;\n    return %s_OK;\n}\n\n", s, n->macro);
}

// ---- the blocks of the current state: a step dispatches once for all three ----

// The run function of a machine, PREFIX_run: it runs the blocks of the current state.
typedef struct CRun {
    bool any;                     // at least one state has a block, so the run function exists
    bool first;                   // the function has the parameter `first`: whether this is the state's first step
    CSignature as;                // the signature of the function without `first`
} CRun;

// Returns what the states' blocks need in common: whether any exists, is an entry block, returns a state, or uses m or sv.
static CRun describe_run(const CUnit *u, const CStateBlocks *s)
{
    CRun run = { false, false, { false, false, false } };

    for (size_t i = 0; i < u->m->state.n; i++)
        for (int k = 0; k < BLOCK_COUNT; k++) {
            run.any |= s[i].has[k];
            run.first |= s[i].has[k] && k == BLOCK_ENTRY;
            run.as.returns_state |= s[i].has[k] && s[i].block[k].returns_state;
            run.as.m |= s[i].has[k] && s[i].block[k].m;
            run.as.sv |= s[i].has[k] && s[i].block[k].sv;
        }
    return run;
}

// Writes the call of a block of state i, inside `if (condition)` unless that is NULL.  Its result, if any, becomes `next`.
static void write_block_call(const CUnit *u, const CStateBlocks *s, size_t i, BlockKind k, const char *condition, Buf *out)
{
    if (!s[i].has[k])
        return;
    if (condition)
        buf_printf(out, "        if (%s) {\n", condition);
    buf_printf(out, "%s%s%s_%s_%s", condition ? "            " : "        ", s[i].block[k].returns_state ? "next = " : "", u->names.prefix,
               u->names.state[i], block_name[k]);
    write_arguments(&s[i].block[k], out);
    buf_str(out, condition ? "        }\n" : "");
}

static void write_block_calls(const CUnit *u, const CStateBlocks *s, size_t i, Buf *out)
{
    const bool entry_leaves = s[i].has[BLOCK_ENTRY] && s[i].block[BLOCK_ENTRY].returns_state;

    write_block_call(u, s, i, BLOCK_ENTRY, "first", out);
    write_block_call(u, s, i, BLOCK_STEP, entry_leaves ? "next == 0" : NULL, out);
    write_block_call(u, s, i, BLOCK_EXIT, "next != 0", out);
}

// Returns the declarations of the run function's parameters that follow the first, the number of the state.
static const char *run_parameters(const CUnit *u, const CRun *run)
{
    const char *m = run->as.m ? format_in(u->arena, ", %s *m", u->names.type) : "";
    const char *sv = run->as.sv ? format_in(u->arena, ", %s *sv", u->names.sv_type) : "";

    return format_in(u->arena, "%s%s%s", m, sv, run->first ? ", bool first" : "");
}

// Returns the arguments for the parameters that run_parameters declares, for a call.
static const char *run_arguments(const CUnit *u, const CRun *run)
{
    return format_in(u->arena, "%s%s%s", run->as.m ? ", m" : "", run->as.sv ? ", sv" : "", run->first ? ", first" : "");
}

// Writes the head of the run function, or of one of its parts.  `part` is appended to the function's name.
static void write_run_head(const CUnit *u, const CRun *run, const char *noinline, const char *part, Buf *out)
{
    buf_printf(out, "static %s%s %s_run%s(%s state%s)\n{\n", noinline, run->as.returns_state ? c_state_type(u) : "void", u->names.prefix, part,
               c_state_type(u), run_parameters(u, run));
}

// Writes the body of a run function: a switch over the states `from` to `to` - 1.
static void write_run_switch(const CUnit *u, const CStateBlocks *s, const CRun *run, size_t from, size_t to, Buf *out)
{
    if (run->as.returns_state)
        buf_printf(out, "    %s next = 0;\n\n", c_state_type(u));
    buf_str(out, "    switch (state) {\n");
    for (size_t i = from; i < to; i++) {
        if (!s[i].has[BLOCK_ENTRY] && !s[i].has[BLOCK_STEP])
            continue;
        buf_printf(out, "    case %s_STATE_%s:\n", u->names.macro, u->names.state[i]);
        write_block_calls(u, s, i, out);
        buf_str(out, "        break;\n");
    }
    buf_printf(out, "    default:\n        break;\n    }\n%s}\n\n", run->as.returns_state ? "    return next;\n" : "");
}

static const char *part_name(const CUnit *u, size_t part) { return format_in(u->arena, "_%u", (unsigned)(part * STATES_PER_PART) + 1); }

// Writes the binary search for the part that has the current state, among the parts `from` to `to` - 1.
static void write_part_search(const CUnit *u, const CRun *run, size_t from, size_t to, const char *indent, Buf *out)
{
    const size_t middle = from + (to - from) / 2;
    const char *inner = format_in(u->arena, "%s    ", indent);

    if (to - from == 1) {
        buf_printf(out, "%s%s%s_run%s(state%s);\n", indent, run->as.returns_state ? "return " : "", u->names.prefix, part_name(u, from),
                   run_arguments(u, run));
        return;
    }
    buf_printf(out, "%sif (state <= %u) {\n", indent, (unsigned)(middle * STATES_PER_PART));
    write_part_search(u, run, from, middle, inner, out);
    buf_printf(out, "%s} else {\n", indent);
    write_part_search(u, run, middle, to, inner, out);
    buf_printf(out, "%s}\n", indent);
}

// Writes the run function for more than STATES_IN_ONE_SWITCH states: parts that each have a switch, and the function that calls them.
// Compilers must not inline the parts.
static void write_run_parts(CUnit *u, const CStateBlocks *s, const CRun *run, Buf *out)
{
    const size_t n = u->m->state.n, parts = (n + STATES_PER_PART - 1) / STATES_PER_PART;

    u->uses_noinline = true;
    for (size_t p = 0; p < parts; p++) {
        const size_t from = p * STATES_PER_PART, to = from + STATES_PER_PART < n ? from + STATES_PER_PART : n;
        buf_printf(out, "// States %u to %u.\n", (unsigned)from + 1, (unsigned)to);
        write_run_head(u, run, "SM_NOINLINE ", part_name(u, p), out);
        write_run_switch(u, s, run, from, to, out);
    }
    write_run_head(u, run, "", "", out);
    write_part_search(u, run, 0, parts, "    ", out);
    buf_str(out, "}\n\n");
}

// Writes the function that runs the blocks of the current state, unless no state has one.
static void write_run(CUnit *u, const CStateBlocks *s, const CRun *run, Buf *out)
{
    if (!run->any)
        return;
    buf_printf(out, "// Runs the blocks of the current state%s.\n", run->as.returns_state ? ".  Returns the next state, or 0 to stay" : "");
    if (u->m->state.n > STATES_IN_ONE_SWITCH) {
        write_run_parts(u, s, run, out);
        return;
    }
    write_run_head(u, run, "", "", out);
    write_run_switch(u, s, run, 0, u->m->state.n, out);
}

// ---- step ----

// What the step function calls.
typedef struct CStepParts {
    CRun run;
    const CSignature *sample;     // NULL: no windows to sample
    bool first;                   // the step function must know whether the step is the first one in its state
} CStepParts;

// Writes the check that time has advanced, and the start of a state's first step.  Emitted code compares `left`, how far G can still advance,
// with m->gate_.
static void write_time_check(const CUnit *u, const CStepParts *w, Buf *out)
{
    const CNames *n = &u->names;

    buf_str(out, "\n    // The gate is 0 before a state's first step, and if init has not succeeded.\n"
                 "    if (left >= m->gate_) {\n        if (!m->first_ || left >= m->left_) {\n");
    buf_printf(out, "            return state == 0 ? %s_NO_STATE : %s_REFUSED;\n        }\n", n->macro, n->macro);
    buf_printf(out, "        m->first_ = false;\n%s        m->start_ = sv->%s;\n        sv->%s = state;\n    }\n",
               w->first ? "        first = true;\n" : "", n->var[u->m->g], n->var[u->m->s]);
}

// Writes the check of write_time_check for soft numbers. Emitted code tests the flag m->first_ first, which is faster on an 8-bit chip than a
// comparison of 64 bits.
static void write_soft_time_check(const CUnit *u, const CStepParts *w, Buf *out)
{
    const CNames *n = &u->names;

    buf_printf(out, "\n    if (m->state_ == 0 || !sm_soft_advance(&m->gate_, &sv->%s)) {\n", n->var[u->m->g]);
    buf_printf(out, "        return m->state_ == 0 ? %s_NO_STATE : %s_REFUSED;\n    }\n", n->macro, n->macro);
    buf_str(out, w->first ? "    first = m->first_;\n    if (first) {\n" : "    if (m->first_) {\n");
    buf_printf(out, "        m->first_ = false;\n        m->start_ = sv->%s;\n        sv->%s = m->state_;\n    }\n", n->var[u->m->g],
               n->var[u->m->s]);
}

// Writes the step function up to where blocks run: the check of time, and the start of a first step.
static void write_step_head(const CUnit *u, const CStepParts *w, Buf *out)
{
    const CNames *n = &u->names;

    buf_printf(out, "%sStatus %s_step(%s *m, %s *sv)\n{\n", n->type, n->prefix, n->type, n->sv_type);
    if (!u->soft)
        buf_printf(out, "    const uint64_t left = UINT64_MAX - 1 - sv->%s;      // how far time can still advance; the largest value if it cannot\n",
                   n->var[u->m->g]);
    if (!u->soft)
        buf_printf(out, "    const %s state = m->state_;      // the state that this step runs; 0 if init has not succeeded\n", c_state_type(u));
    if (w->first)
        buf_printf(out, "    bool first%s;\n", u->soft ? "" : " = false");
    if (w->run.as.returns_state)
        buf_printf(out, "    %s next;      // the next state, or 0\n", c_state_type(u));
    (u->soft ? write_soft_time_check : write_time_check)(u, w, out);
    if (u->track_stores)
        buf_printf(out, "    memset(&m->stored, 0, sizeof m->stored);\n    m->stored.%s = first;\n", n->var[u->m->s]);
}

// Writes the rest of the step function: runs the blocks and takes the transition. m->gate_ is stored last, because it becomes `left` only
// without a transition.
static void write_step_blocks(const CUnit *u, const CStepParts *w, Buf *out)
{
    if (w->run.any)
        buf_printf(out, "    %s%s_run(%s%s);\n", w->run.as.returns_state ? "next = " : "", u->names.prefix, u->soft ? "m->state_" : "state",
                   run_arguments(u, &w->run));
    if (w->run.as.returns_state)
        buf_printf(out, "    if (next != 0) {\n        m->state_ = next;\n        m->first_ = true;\n%s    }\n",
                   u->soft ? "" : "        m->left_ = left;\n        m->gate_ = 0;\n    } else {\n        m->gate_ = left;\n");
    else if (!u->soft)
        buf_str(out, "    m->gate_ = left;\n");
    buf_printf(out, "    return %s_OK;\n}\n\n", u->names.macro);
}

static void write_step(CUnit *u, const CStateBlocks *s, const CSignature *sample, Buf *out)
{
    CStepParts w = { describe_run(u, s), sample, false };

    w.first = w.run.first || u->track_stores;
    write_run(u, s, &w.run, out);
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
    if (u->soft)
        return;
    buf_printf(out, "\nuint32_t %s_size(void)\n{\n    return (uint32_t)sizeof(%s);\n}\n\n", n->prefix, n->type);
    buf_printf(out, "uint32_t %s_sv_size(void)\n{\n    return (uint32_t)sizeof(%s);\n}\n", n->prefix, n->sv_type);
}

// Writes the functions of all blocks, then init, step, state, T and state_name.
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
    c_write_parameters(u, out);
    write_step(u, s, u->m->sample ? &sample : NULL, out);
    write_queries(u, out);
}
