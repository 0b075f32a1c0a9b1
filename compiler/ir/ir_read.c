// SPDX-License-Identifier: Apache-2.0
// Parses IR text, in the format described at the top of print.c, line by line.  It only resolves names and numbers; ir_verify checks
// the machine.  Parsing stops at the first error: the functions here return false after an error, which is then in IrScan.error.
#include <string.h>

#include "compiler/ir/ir.h"
#include "compiler/ir/scan.h"
#include "compiler/ir/text.h"

typedef struct PendingGoto { IrFn *f; IrBlkRef b; Str name; uint32_t line; } PendingGoto;

typedef struct IrReader {
    Arena *arena;
    IrScan scan;
    IrMachine *m;
    Map vars, states;                 // the name of a variable or state, to its index + 1
    Map temps;                        // the name of a temporary of the current function, such as "%7", to its instruction + 1
    IrFn *f;                          // the current function
    bool open;                        // the last block of f has no jump yet
    VEC(PendingGoto) gotos;           // transitions to resolve at the end, because they may name later states
} IrReader;

// ---- declarations ----

static bool read_vector(IrReader *r)
{
    if (r->m->sv_name)
        return scan_fail(&r->scan, "the state vector has a name already");
    return scan_quoted(&r->scan, &r->m->sv_name) && scan_expect_word(&r->scan, "size")
        && scan_number(&r->scan, "a size", &r->m->sv_size) && scan_expect_word(&r->scan, "hash") && scan_number(&r->scan, "a hash", &r->m->sv_hash);
}

// Reads the optional role of an element: `is G` (the time) or `is S` (the state).
static bool read_role(IrReader *r, uint32_t index)
{
    uint32_t *role;

    if (!scan_match_word(&r->scan, "is"))
        return true;
    if (scan_match_word(&r->scan, "G"))
        role = &r->m->g;
    else if (scan_match_word(&r->scan, "S"))
        role = &r->m->s;
    else
        return scan_fail(&r->scan, "expected G or S");
    if (*role != IR_NONE)
        return scan_fail(&r->scan, "there are two elements of this role");
    *role = index;
    return true;
}

// Reads the range and the default of a parameter.
static bool read_parameter(IrReader *r, IrVar *v)
{
    Parameter *p = ARENA_NEW(r->arena, Parameter);
    uint64_t lo, hi;

    if (!scan_value(&r->scan, SM_F64, &lo) || !scan_value(&r->scan, SM_F64, &hi) || !scan_expect_word(&r->scan, "default") ||
        !scan_value(&r->scan, v->type, &p->standard))
        return false;
    p->lo = sm_from_bits(lo);
    p->hi = sm_from_bits(hi);
    v->parameter = p;
    return true;
}

static bool read_var(IrReader *r, IrSpace space)
{
    uint32_t index = (uint32_t)r->m->var.n;
    IrVar v;
    bool ok = true;

    memset(&v, 0, sizeof v);
    v.space = space;
    if (!scan_type(&r->scan, &v.type) || !(v.name = scan_word(&r->scan, "a name")))
        return false;
    if (map_find(&r->vars, v.name))
        return scan_fail(&r->scan, "there are two variables '%.40s'", v.name->text);
    v.writable = scan_match_word(&r->scan, "writable");
    switch (space) {
    case IR_ELEMENT: ok = scan_expect_word(&r->scan, "at") && scan_number(&r->scan, "an offset", &v.offset) && read_role(r, index); break;
    case IR_LOCAL:
        v.outside = scan_match_word(&r->scan, "outside");
        v.hidden = scan_match_word(&r->scan, "hidden");
        if (scan_match_word(&r->scan, "parameter") && !read_parameter(r, &v))
            return false;
        ok = scan_expect_char(&r->scan, '=') && scan_value(&r->scan, v.type, &v.init);
        break;
    case IR_TIME:
        if (r->m->t != IR_NONE)
            return scan_fail(&r->scan, "there are two times");
        r->m->t = index;
        break;
    }
    if (!ok)
        return false;
    map_put(&r->vars, v.name, (void *)(uintptr_t)(index + 1));
    vec_push(r->arena, &r->m->var, v);
    return true;
}

static bool read_stat(IrReader *r, SmStat *out)
{
    Str w = scan_word(&r->scan, "a statistic");

    for (int s = 0; w && s < SM_STAT_COUNT; s++)
        if (scan_word_is(w, ir_stat_name[s])) {
            *out = (SmStat)s;
            return true;
        }
    return w && scan_fail(&r->scan, "expected a statistic, found '%.40s'", w->text);
}

static bool read_window(IrReader *r)
{
    IrWindow w = {SM_F64, 0, 0, NULL};
    uint32_t number;
    SmStat stat;

    if (!scan_lettered_number(&r->scan, 'w', "a window", &number) || !scan_type(&r->scan, &w.type) || !scan_expect_word(&r->scan, "size")
        || !scan_number(&r->scan, "a size", &w.size) || !scan_expect_word(&r->scan, "stats"))
        return false;
    if (number != r->m->window.n)
        return scan_fail(&r->scan, "windows are numbered in order: expected w%lu", (unsigned long)r->m->window.n);
    while (!scan_at_line_end(&r->scan)) {
        if (!read_stat(r, &stat))
            return false;
        w.stats |= 1u << stat;
    }
    vec_push(r->arena, &r->m->window, w);
    return true;
}

// ---- instructions ----

static bool read_var_ref(IrReader *r, IrIns *i)
{
    Str w = scan_word(&r->scan, "a variable");
    uintptr_t found = w ? (uintptr_t)map_find(&r->vars, w) : 0;

    if (!found)
        return w && scan_fail(&r->scan, "there is no variable '%.40s'", w->text);
    i->var = (uint32_t)(found - 1);
    if (i->type != r->m->var.at[i->var].type)
        return scan_fail(&r->scan, "'%.40s' is of type %s", w->text, sm_type_info[r->m->var.at[i->var].type].spelling);
    return true;
}

static bool read_temp(IrReader *r, IrRef *out)
{
    Str w = scan_word(&r->scan, "a temporary");
    uintptr_t found = w ? (uintptr_t)map_find(&r->temps, w) : 0;

    if (!found)
        return w && scan_fail(&r->scan, "there is no temporary '%.40s' before this line", w->text);
    *out = (IrRef)(found - 1);
    return true;
}

static bool read_operands(IrReader *r, IrIns *i)
{
    uint8_t n = ir_op_info[i->op].operands;

    if (n > 0 && !read_temp(r, &i->a))
        return false;
    return n < 2 || (scan_expect_char(&r->scan, ',') && read_temp(r, &i->b));
}

static bool read_window_ref(IrReader *r, IrIns *i)
{
    if (!scan_lettered_number(&r->scan, 'w', "a window", &i->var))
        return false;
    return i->var < r->m->window.n || scan_fail(&r->scan, "there is no window w%lu", (unsigned long)i->var);
}

// Reads the operands of a comparison.  In IR text a comparison names the type of its operands, not of its result.
static bool read_compare_operands(IrReader *r, IrIns *i)
{
    SmType type = i->type;

    i->type = SM_BOOL;
    if (!read_operands(r, i))
        return false;
    return r->f->ins.at[i->a].type == type || scan_fail(&r->scan, "the operands are not of type %s", sm_type_info[type].spelling);
}

static bool read_ins_type(IrReader *r, IrIns *i)
{
    SmType type;
    const bool good = scan_type(&r->scan, &type);

    if (good)
        i->type = type;
    return good;
}

// Reads the type, operands and other details after the operation's name.
static bool read_ins_details(IrReader *r, IrIns *i)
{
    SmStat stat;

    switch (ir_op_info[i->op].types) {
    case IR_T_CONST: return read_ins_type(r, i) && scan_value(&r->scan, i->type, &i->bits);
    case IR_T_CONVERT:
    case IR_T_SAME: return read_ins_type(r, i) && read_operands(r, i);
    case IR_T_COMPARE: return read_ins_type(r, i) && read_compare_operands(r, i);
    case IR_T_LOGIC: i->type = SM_BOOL; return read_operands(r, i);
    case IR_T_LOAD: return read_ins_type(r, i) && read_var_ref(r, i);
    case IR_T_STORE: return read_ins_type(r, i) && read_var_ref(r, i) && scan_expect_char(&r->scan, ',') && read_operands(r, i);
    case IR_T_SAMPLE: i->type = SM_F64; return read_window_ref(r, i) && scan_expect_char(&r->scan, ',') && read_operands(r, i);
    case IR_T_STAT:
        if (!read_stat(r, &stat))
            return false;
        i->type = SM_F64;
        i->stat = stat;
        return read_window_ref(r, i);
    }
    return false;
}

static IrOp find_op(Str w)             // returns IR_OP_COUNT if no operation has this name
{
    int op = 0;

    while (op < IR_OP_COUNT && !scan_word_is(w, ir_op_info[op].name))
        op++;
    return (IrOp)op;
}

// Reads the rest of an instruction whose operation is `op`.  `name` is the temporary to which the line assigns the result; NULL: none.
static bool read_ins(IrReader *r, Str name, Str op)
{
    IrIns i = {.op = find_op(op), .a = IR_NONE, .b = IR_NONE};
    IrRef ref;

    if (i.op == IR_OP_COUNT)
        return scan_fail(&r->scan, "there is no operation '%.40s'", op->text);
    if (ir_op_info[i.op].effect == (name != NULL))
        return name ? scan_fail(&r->scan, "'%.40s' has no result", op->text)
                    : scan_fail(&r->scan, "'%.40s' has a result: a name and '=' must precede it", op->text);
    if (!read_ins_details(r, &i))
        return false;
    ref = ir_emit(r->arena, r->f, (IrBlkRef)(r->f->blk.n - 1), i);
    if (name)
        map_put(&r->temps, name, (void *)(uintptr_t)(ref + 1));
    return true;
}

// ---- jumps and blocks ----

// Sets *kind to the kind of jump that w names; returns false if no kind has this name.
static bool find_jump_kind(Str w, IrJumpKind *kind)
{
    static const char *const name[] = {"ret", "jmp", "br", "goto"};       // in the order of IrJumpKind

    for (int k = 0; k < 4; k++)
        if (scan_word_is(w, name[k])) {
            *kind = (IrJumpKind)k;
            return true;
        }
    return false;
}

static bool read_jump(IrReader *r, IrJumpKind kind)
{
    IrBlkRef last = (IrBlkRef)(r->f->blk.n - 1);
    IrJump *j = &r->f->blk.at[last].jump;
    PendingGoto pending;

    r->open = false;
    j->kind = kind;
    switch (kind) {
    case IR_RET: return true;
    case IR_JMP: return scan_lettered_number(&r->scan, 'b', "a block", &j->then);
    case IR_BR:
        return read_temp(r, &j->cond) && scan_expect_char(&r->scan, ',') && scan_lettered_number(&r->scan, 'b', "a block", &j->then)
            && scan_expect_char(&r->scan, ',') && scan_lettered_number(&r->scan, 'b', "a block", &j->otherwise);
    case IR_GOTO:
        pending = (PendingGoto){r->f, last, scan_word(&r->scan, "a state"), r->scan.line};
        if (!pending.name)
            return false;
        vec_push(r->arena, &r->gotos, pending);
        return true;
    }
    return false;
}

// Whether w, the word just read, is a label: w begins with `b`, and a colon follows w.
static bool is_label(const IrReader *r, Str w)
{
    const char *c = r->scan.at;

    while (c < r->scan.end && (*c == ' ' || *c == '\t'))
        c++;
    return w->text[0] == 'b' && c < r->scan.end && *c == ':';
}

static bool read_label(IrReader *r, Str w)
{
    uint64_t number;

    if (r->open)
        return scan_fail(&r->scan, "the block before this one does not end in a jump");
    if (!scan_try_parse_number(w->text + 1, &number) || number != r->f->blk.n)
        return scan_fail(&r->scan, "blocks are numbered in order: expected b%lu", (unsigned long)r->f->blk.n);
    ir_add_block(r->arena, r->f);
    r->open = true;
    return scan_expect_char(&r->scan, ':');
}

// Reads a label, a jump or an instruction.
static bool read_code_line(IrReader *r)
{
    Str w = scan_word(&r->scan, "an instruction"), op;
    IrJumpKind kind;

    if (!w)
        return false;
    if (is_label(r, w))
        return read_label(r, w);
    if (!r->open)
        return scan_fail(&r->scan, "expected a block's label, as 'b%lu:'", (unsigned long)r->f->blk.n);
    if (find_jump_kind(w, &kind))
        return read_jump(r, kind);
    if (w->text[0] != '%')
        return read_ins(r, NULL, w);
    if (map_find(&r->temps, w))
        return scan_fail(&r->scan, "'%.40s' is assigned twice", w->text);
    return scan_expect_char(&r->scan, '=') && (op = scan_word(&r->scan, "an operation")) != NULL && read_ins(r, w, op);
}

static bool expect_line_end(IrReader *r)
{
    return scan_at_line_end(&r->scan) || scan_fail(&r->scan, "expected the end of the line");
}

static bool read_function(IrReader *r, IrFn **out)
{
    if (*out)
        return scan_fail(&r->scan, "duplicate function");
    *out = r->f = ARENA_NEW(r->arena, IrFn);
    memset(&r->temps, 0, sizeof r->temps);
    r->temps.arena = r->arena;
    r->open = false;
    if (!scan_expect_char(&r->scan, '{') || !expect_line_end(r))
        return false;
    while (scan_next_line(&r->scan)) {
        if (scan_match_char(&r->scan, '}'))
            return !r->open || scan_fail(&r->scan, "the block before this line does not end in a jump");
        if (!read_code_line(r) || !expect_line_end(r))
            return false;
    }
    return scan_fail(&r->scan, "expected '}'");
}

// ---- the machine ----

static bool read_state(IrReader *r)
{
    IrState s;

    memset(&s, 0, sizeof s);
    if (!(s.name = scan_word(&r->scan, "a name")))
        return false;
    if (map_find(&r->states, s.name))
        return scan_fail(&r->scan, "there are two states '%.40s'", s.name->text);
    s.is_safe = scan_match_word(&r->scan, "safe");
    s.allows_swap = scan_match_word(&r->scan, "swap");
    s.is_abort = scan_match_word(&r->scan, "abort");
    vec_push(r->arena, &r->m->state, s);
    map_put(&r->states, s.name, (void *)(uintptr_t)r->m->state.n);
    return true;
}

// Reads a declaration, or a function of the machine or of the last state.
static bool read_declaration(IrReader *r)
{
    Str w = scan_word(&r->scan, "a declaration or a function");

    if (!w)
        return false;
    if (scan_word_is(w, "machine"))
        return r->m->name ? scan_fail(&r->scan, "the machine has a name already") : scan_quoted(&r->scan, &r->m->name);
    if (scan_word_is(w, "vector"))
        return read_vector(r);
    if (scan_word_is(w, "element"))
        return read_var(r, IR_ELEMENT);
    if (scan_word_is(w, "local"))
        return read_var(r, IR_LOCAL);
    if (scan_word_is(w, "time"))
        return read_var(r, IR_TIME);
    if (scan_word_is(w, "window"))
        return read_window(r);
    if (scan_word_is(w, "sample"))
        return read_function(r, &r->m->sample);
    if (scan_word_is(w, "state"))
        return read_state(r);
    for (int k = 0; k < BLOCK_COUNT; k++)
        if (scan_word_is(w, ir_block_name[k]))
            return r->m->state.n > 0 ? read_function(r, &r->m->state.at[r->m->state.n - 1].block[k])
                                     : scan_fail(&r->scan, "expected a state before this function");
    return scan_fail(&r->scan, "'%.40s' is not allowed here", w->text);
}

// Sets the target state of each transition.  Runs after the last line, when all states are known.
static bool resolve_gotos(IrReader *r)
{
    for (size_t i = 0; i < r->gotos.n; i++) {
        PendingGoto *g = &r->gotos.at[i];
        uintptr_t number = (uintptr_t)map_find(&r->states, g->name);
        r->scan.line = g->line;
        if (!number)
            return scan_fail(&r->scan, "there is no state '%.40s'", g->name->text);
        g->f->blk.at[g->b].jump.state = (uint32_t)number;
    }
    return true;
}

static bool check_complete(IrReader *r)
{
    if (!r->m->name || !r->m->sv_name)
        return scan_fail(&r->scan, "the text ends without %s", r->m->name ? "a vector" : "a machine");
    if (r->m->g == IR_NONE || r->m->s == IR_NONE || r->m->t == IR_NONE)
        return scan_fail(&r->scan, "the text ends without an element that is G, one that is S and a time");
    return true;
}

// Parses the output of ir_print.  On a syntax error returns NULL and sets *error to a message ("line 7: …").
IrMachine *ir_read(Arena *arena, StrPool *strings, const char *text, size_t len, const char **error)
{
    IrReader r;
    bool ok = true;

    memset(&r, 0, sizeof r);
    r.arena = r.vars.arena = r.states.arena = arena;
    r.scan.arena = arena;
    r.scan.strings = strings;
    r.m = ARENA_NEW(arena, IrMachine);
    r.m->g = r.m->s = r.m->t = IR_NONE;
    r.scan.at = text;
    r.scan.end = text + len;
    r.scan.line = 1;
    while (ok && scan_next_line(&r.scan))
        ok = read_declaration(&r) && expect_line_end(&r);
    ok = ok && resolve_gotos(&r) && check_complete(&r);
    *error = r.scan.error;
    return ok ? r.m : NULL;
}
