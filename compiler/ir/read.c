// SPDX-License-Identifier: Apache-2.0
// Text to IR: reads the form that the head of print.c shows, line by line.  It settles names and numbers and nothing more;
// whether the machine makes sense is ir_verify's business.  The first thing it does not understand ends it with a message.
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "compiler/ir/ir.h"
#include "compiler/ir/text.h"

typedef struct PendingGoto { IrFn *f; IrBlkRef b; Str name; uint32_t line; } PendingGoto;

typedef struct Reader {
    Arena *arena;
    StrPool *strings;
    IrMachine *m;
    const char *at, *end;             // what is not read yet
    uint32_t line;
    const char *error;                // the first; nothing is read after it
    Map vars, states;                 // name to index + 1
    Map temps;                        // of the function being read: "%7" to instruction + 1
    IrFn *f;                          // the function being read
    bool open;                        // its last block still lacks a jump
    VEC(PendingGoto) gotos;           // states may be named before they are introduced
} Reader;

static bool fail(Reader *r, const char *format, ...)
{
    va_list args;
    Buf b;
    char text[160];

    if (r->error)
        return false;
    va_start(args, format);
    vsnprintf(text, sizeof text, format, args);
    va_end(args);
    buf_init(&b, r->arena);
    buf_printf(&b, "line %lu: %s", (unsigned long)r->line, text);
    r->error = buf_text(&b);
    return false;
}

// ---- characters and words ----

static void skip_blanks(Reader *r)
{
    while (r->at < r->end && (*r->at == ' ' || *r->at == '\t' || *r->at == '\r'))
        r->at++;
    if (r->at < r->end && *r->at == '#')
        while (r->at < r->end && *r->at != '\n')
            r->at++;
}

static bool at_line_end(Reader *r)
{
    skip_blanks(r);
    return r->at == r->end || *r->at == '\n';
}

// To the first word of the next line that has one; false at the end of the text.
static bool next_line(Reader *r)
{
    while (at_line_end(r) && r->at < r->end) {
        r->at++;
        r->line++;
    }
    return r->at < r->end;
}

static bool is_word_char(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '%' || c == '-' || c == '.';
}

// The next word of the line; NULL and an error when there is none.
static Str word(Reader *r, const char *expected)
{
    const char *start;

    skip_blanks(r);
    start = r->at;
    while (r->at < r->end && is_word_char(*r->at))
        r->at++;
    if (r->at == start) {
        fail(r, "expected %s", expected);
        return NULL;
    }
    return str_intern(r->strings, start, (size_t)(r->at - start));
}

static bool is(Str w, const char *text)
{
    return w && strcmp(w->text, text) == 0;
}

static bool optional_char(Reader *r, char c)
{
    skip_blanks(r);
    if (r->at == r->end || *r->at != c)
        return false;
    r->at++;
    return true;
}

static bool expect_char(Reader *r, char c)
{
    return optional_char(r, c) || fail(r, "expected '%c'", c);
}

// Takes the word `text` if it comes next.
static bool optional_word(Reader *r, const char *text)
{
    size_t n = strlen(text);

    skip_blanks(r);
    if ((size_t)(r->end - r->at) < n || memcmp(r->at, text, n) != 0 || (r->at + n < r->end && is_word_char(r->at[n])))
        return false;
    r->at += n;
    return true;
}

static bool expect_word(Reader *r, const char *text)
{
    return optional_word(r, text) || fail(r, "expected '%s'", text);
}

static int hex_digit(char c)
{
    if (c >= '0' && c <= '9')
        return c - '0';
    if (c >= 'a' && c <= 'f')
        return c - 'a' + 10;
    return -1;
}

static bool quoted(Reader *r, Str *out)
{
    Buf b;

    buf_init(&b, r->arena);
    if (!expect_char(r, '"'))
        return false;
    while (r->at < r->end && *r->at != '"' && *r->at != '\n') {
        char c = *r->at++;
        if (c == '\\') {
            if (r->end - r->at < 2 || hex_digit(r->at[0]) < 0 || hex_digit(r->at[1]) < 0)
                return fail(r, "expected two hexadecimal digits behind the backslash");
            c = (char)(unsigned char)(hex_digit(r->at[0]) * 16 + hex_digit(r->at[1]));
            r->at += 2;
        }
        buf_char(&b, c);
    }
    *out = str_intern(r->strings, buf_text(&b), b.n);
    return expect_char(r, '"');
}

// ---- numbers ----

static bool parse_number(const char *text, uint64_t *out)
{
    uint64_t base = 10, v = 0;

    if (text[0] == '0' && text[1] == 'x') {
        base = 16;
        text += 2;
    }
    if (!*text)
        return false;
    for (; *text; text++) {
        int digit = hex_digit(*text);
        if (digit < 0 || (uint64_t)digit >= base || v > (UINT64_MAX - (uint64_t)digit) / base)
            return false;
        v = v * base + (uint64_t)digit;
    }
    *out = v;
    return true;
}

static bool number32(Reader *r, const char *what, uint32_t *out)
{
    Str w = word(r, what);
    uint64_t v;

    if (!w)
        return false;
    if (!parse_number(w->text, &v) || v > UINT32_MAX)
        return fail(r, "expected %s, found '%.40s'", what, w->text);
    *out = (uint32_t)v;
    return true;
}

// `b7` or `w7`: the letter and a number.
static bool lettered(Reader *r, char letter, const char *what, uint32_t *out)
{
    Str w = word(r, what);
    uint64_t v;

    if (!w)
        return false;
    if (w->text[0] != letter || !parse_number(w->text + 1, &v) || v > UINT32_MAX)
        return fail(r, "expected %s, found '%.40s'", what, w->text);
    *out = (uint32_t)v;
    return true;
}

static bool find_type(Str w, SmType *out)
{
    for (int t = 0; t < SM_TYPE_COUNT; t++)
        if (is(w, sm_type_info[t].spelling)) {
            *out = (SmType)t;
            return true;
        }
    return false;
}

static bool type_word(Reader *r, SmType *out)
{
    Str w = word(r, "a type");

    return w && (find_type(w, out) || fail(r, "expected a type, found '%.40s'", w->text));
}

// The cell of a whole number; false when the type cannot hold it exactly.
static bool whole_cell(SmType type, bool negative, uint64_t magnitude, uint64_t *cell)
{
    unsigned bits = 8u * sm_type_info[type].bytes;
    double d = negative ? -(double)magnitude : (double)magnitude;
    float f = (float)d;
    uint32_t low;

    switch (sm_type_info[type].kind) {
    case SM_KIND_BOOL: *cell = magnitude; return !negative && magnitude <= 1;
    case SM_KIND_UNSIGNED: *cell = magnitude; return !negative && (bits == 64 || magnitude >> bits == 0);
    case SM_KIND_SIGNED:
        *cell = (negative ? ~magnitude + 1 : magnitude) & UINT64_MAX >> (64 - bits);
        return magnitude <= (UINT64_C(1) << (bits - 1)) - !negative;
    case SM_KIND_FLOAT:
        if (type == SM_F32) {
            memcpy(&low, &f, sizeof low);
            *cell = low;
            return magnitude <= UINT64_C(1) << 53 && (double)f == d;
        }
        memcpy(cell, &d, sizeof *cell);
        return magnitude <= UINT64_C(1) << 53;
    }
    return false;
}

static bool value(Reader *r, SmType type, uint64_t *cell)
{
    Str w = word(r, "a value");
    uint64_t v;
    bool negative, hex;

    if (!w)
        return false;
    negative = w->text[0] == '-';
    hex = w->text[0] == '0' && w->text[1] == 'x';
    if (!parse_number(w->text + negative, &v))
        return fail(r, "expected a value, found '%.40s'", w->text);
    if (hex)
        *cell = v;
    else if (!whole_cell(type, negative, v, cell))
        return fail(r, "%.40s is no value of type %s", w->text, sm_type_info[type].spelling);
    return true;
}

// ---- declarations ----

static bool read_machine(Reader *r)
{
    if (r->m->name)
        return fail(r, "the machine has a name already");
    return quoted(r, &r->m->name);
}

static bool read_vector(Reader *r)
{
    if (r->m->sv_name)
        return fail(r, "the state vector has a name already");
    return quoted(r, &r->m->sv_name) && expect_word(r, "size") && number32(r, "a size", &r->m->sv_size) && expect_word(r, "hash")
        && number32(r, "a hash", &r->m->sv_hash);
}

static bool read_role(Reader *r, uint32_t index)
{
    uint32_t *role;

    if (!optional_word(r, "is"))
        return true;
    if (optional_word(r, "G"))
        role = &r->m->g;
    else if (optional_word(r, "S"))
        role = &r->m->s;
    else
        return fail(r, "expected G or S");
    if (*role != IR_NONE)
        return fail(r, "there are two elements of this role");
    *role = index;
    return true;
}

static bool read_var_details(Reader *r, IrVar *v, uint32_t index)
{
    v->writable = optional_word(r, "writable");
    switch (v->space) {
    case IR_ELEMENT: return expect_word(r, "at") && number32(r, "an offset", &v->offset) && read_role(r, index);
    case IR_LOCAL: return expect_char(r, '=') && value(r, v->type, &v->init);
    case IR_TIME:
        if (r->m->t != IR_NONE)
            return fail(r, "there are two times");
        r->m->t = index;
        return true;
    }
    return false;
}

static bool read_var(Reader *r, IrSpace space)
{
    uint32_t index = (uint32_t)r->m->var.n;
    IrVar v;

    memset(&v, 0, sizeof v);
    v.space = space;
    if (!type_word(r, &v.type) || !(v.name = word(r, "a name")))
        return false;
    if (map_find(&r->vars, v.name))
        return fail(r, "there are two variables '%.40s'", v.name->text);
    if (!read_var_details(r, &v, index))
        return false;
    map_put(&r->vars, v.name, (void *)(uintptr_t)(index + 1));
    vec_push(r->arena, &r->m->var, v);
    return true;
}

static bool stat_word(Reader *r, SmStat *out)
{
    Str w = word(r, "a statistic");

    for (int s = 0; w && s < SM_STAT_COUNT; s++)
        if (is(w, ir_stat_name[s])) {
            *out = (SmStat)s;
            return true;
        }
    return w && fail(r, "expected a statistic, found '%.40s'", w->text);
}

static bool read_window(Reader *r)
{
    IrWindow w = {0, 0};
    uint32_t number;
    SmStat stat;

    if (!lettered(r, 'w', "a window", &number) || !expect_word(r, "size") || !number32(r, "a size", &w.size) || !expect_word(r, "stats"))
        return false;
    if (number != r->m->window.n)
        return fail(r, "windows are numbered in order: expected w%lu", (unsigned long)r->m->window.n);
    while (!at_line_end(r)) {
        if (!stat_word(r, &stat))
            return false;
        w.stats |= 1u << stat;
    }
    vec_push(r->arena, &r->m->window, w);
    return true;
}

// ---- instructions ----

static bool var_name(Reader *r, IrIns *i)
{
    Str w = word(r, "a variable");
    uintptr_t found = w ? (uintptr_t)map_find(&r->vars, w) : 0;

    if (!found)
        return w && fail(r, "there is no variable '%.40s'", w->text);
    i->var = (uint32_t)(found - 1);
    if (i->type != r->m->var.at[i->var].type)
        return fail(r, "'%.40s' is of type %s", w->text, sm_type_info[r->m->var.at[i->var].type].spelling);
    return true;
}

static bool temp(Reader *r, IrRef *out)
{
    Str w = word(r, "a temporary");
    uintptr_t found = w ? (uintptr_t)map_find(&r->temps, w) : 0;

    if (!found)
        return w && fail(r, "there is no temporary '%.40s' before this line", w->text);
    *out = (IrRef)(found - 1);
    return true;
}

static bool operands(Reader *r, IrIns *i)
{
    uint8_t n = ir_op_info[i->op].operands;

    if (n > 0 && !temp(r, &i->a))
        return false;
    return n < 2 || (expect_char(r, ',') && temp(r, &i->b));
}

static bool window_name(Reader *r, IrIns *i)
{
    if (!lettered(r, 'w', "a window", &i->var))
        return false;
    return i->var < r->m->window.n || fail(r, "there is no window w%lu", (unsigned long)i->var);
}

// The type that is written with a comparison is that of its operands.
static bool compare_operands(Reader *r, IrIns *i)
{
    SmType type = i->type;

    i->type = SM_BOOL;
    if (!operands(r, i))
        return false;
    return r->f->ins.at[i->a].type == type || fail(r, "the operands are not of type %s", sm_type_info[type].spelling);
}

static bool ins_details(Reader *r, IrIns *i)
{
    switch (ir_op_info[i->op].types) {
    case IR_T_CONST: return type_word(r, &i->type) && value(r, i->type, &i->bits);
    case IR_T_CONVERT:
    case IR_T_SAME: return type_word(r, &i->type) && operands(r, i);
    case IR_T_COMPARE: return type_word(r, &i->type) && compare_operands(r, i);
    case IR_T_LOGIC: i->type = SM_BOOL; return operands(r, i);
    case IR_T_LOAD: return type_word(r, &i->type) && var_name(r, i);
    case IR_T_STORE: return type_word(r, &i->type) && var_name(r, i) && expect_char(r, ',') && operands(r, i);
    case IR_T_SAMPLE: i->type = SM_F64; return window_name(r, i) && expect_char(r, ',') && operands(r, i);
    case IR_T_STAT: i->type = SM_F64; return stat_word(r, &i->stat) && window_name(r, i);
    }
    return false;
}

static bool find_op(Str w, IrOp *out)
{
    for (int op = 0; op < IR_OP_COUNT; op++)
        if (is(w, ir_op_info[op].name)) {
            *out = (IrOp)op;
            return true;
        }
    return false;
}

static bool read_ins(Reader *r, Str name, Str op)
{
    IrIns i;
    IrRef ref;

    memset(&i, 0, sizeof i);
    i.a = i.b = IR_NONE;
    if (!find_op(op, &i.op))
        return fail(r, "there is no operation '%.40s'", op->text);
    if (ir_op_info[i.op].effect == (name != NULL))
        return fail(r, name ? "'%.40s' gives no result" : "'%.40s' gives a result: a name and '=' must stand before it", op->text);
    if (!ins_details(r, &i))
        return false;
    ref = ir_emit(r->arena, r->f, (IrBlkRef)(r->f->blk.n - 1), i);
    if (name)
        map_put(&r->temps, name, (void *)(uintptr_t)(ref + 1));
    return true;
}

static bool read_result(Reader *r, Str name)
{
    Str op;

    if (map_find(&r->temps, name))
        return fail(r, "'%.40s' is given a value twice", name->text);
    return expect_char(r, '=') && (op = word(r, "an operation")) != NULL && read_ins(r, name, op);
}

// ---- jumps and blocks ----

static bool read_goto(Reader *r)
{
    PendingGoto g = {r->f, (IrBlkRef)(r->f->blk.n - 1), word(r, "a state"), r->line};

    if (!g.name)
        return false;
    vec_push(r->arena, &r->gotos, g);
    return true;
}

static bool read_branch(Reader *r, IrJump *j)
{
    return temp(r, &j->cond) && expect_char(r, ',') && lettered(r, 'b', "a block", &j->then) && expect_char(r, ',')
        && lettered(r, 'b', "a block", &j->otherwise);
}

static bool is_jump(Str w, IrJumpKind *kind)
{
    static const char *const name[] = {"ret", "jmp", "br", "goto"};       // in the order of IrJumpKind

    for (int k = 0; k < 4; k++)
        if (is(w, name[k])) {
            *kind = (IrJumpKind)k;
            return true;
        }
    return false;
}

static bool read_jump(Reader *r, IrJumpKind kind)
{
    IrJump *j = &r->f->blk.at[r->f->blk.n - 1].jump;

    r->open = false;
    j->kind = kind;
    switch (kind) {
    case IR_RET: return true;
    case IR_JMP: return lettered(r, 'b', "a block", &j->then);
    case IR_BR: return read_branch(r, j);
    case IR_GOTO: return read_goto(r);
    }
    return false;
}

static bool is_label(const Reader *r, Str w)
{
    const char *c = r->at;

    while (c < r->end && (*c == ' ' || *c == '\t'))
        c++;
    return w->text[0] == 'b' && c < r->end && *c == ':';
}

static bool read_label(Reader *r, Str w)
{
    uint64_t number;

    if (r->open)
        return fail(r, "the block before this one does not end in a jump");
    if (!parse_number(w->text + 1, &number) || number != r->f->blk.n)
        return fail(r, "blocks are numbered in order: expected b%lu", (unsigned long)r->f->blk.n);
    ir_block(r->arena, r->f);
    r->open = true;
    return expect_char(r, ':');
}

static bool read_code_line(Reader *r)
{
    Str w = word(r, "an instruction");
    IrJumpKind kind;

    if (!w)
        return false;
    if (is_label(r, w))
        return read_label(r, w);
    if (!r->open)
        return fail(r, "expected a block's label, as 'b%lu:'", (unsigned long)r->f->blk.n);
    if (is_jump(w, &kind))
        return read_jump(r, kind);
    return w->text[0] == '%' ? read_result(r, w) : read_ins(r, NULL, w);
}

static bool line_is_over(Reader *r)
{
    return at_line_end(r) || fail(r, "expected the end of the line");
}

static bool read_function(Reader *r, IrFn **out)
{
    if (*out)
        return fail(r, "this function stands twice");
    *out = r->f = ARENA_NEW(r->arena, IrFn);
    memset(&r->temps, 0, sizeof r->temps);
    r->temps.arena = r->arena;
    r->open = false;
    if (!expect_char(r, '{') || !line_is_over(r))
        return false;
    while (next_line(r)) {
        if (optional_char(r, '}'))
            return !r->open || fail(r, "the block before this line does not end in a jump");
        if (!read_code_line(r) || !line_is_over(r))
            return false;
    }
    return fail(r, "expected '}'");
}

// ---- the machine ----

static bool read_state(Reader *r)
{
    IrState s;

    memset(&s, 0, sizeof s);
    if (!(s.name = word(r, "a name")))
        return false;
    if (map_find(&r->states, s.name))
        return fail(r, "there are two states '%.40s'", s.name->text);
    vec_push(r->arena, &r->m->state, s);
    map_put(&r->states, s.name, (void *)(uintptr_t)r->m->state.n);
    return true;
}

static bool read_state_function(Reader *r, Str w)
{
    for (int k = 0; k < BLOCK_COUNT; k++)
        if (is(w, ir_block_name[k])) {
            if (r->m->state.n == 0)
                return fail(r, "expected a state before this function");
            return read_function(r, &r->m->state.at[r->m->state.n - 1].block[k]);
        }
    return fail(r, "'%.40s' begins nothing that may stand here", w->text);
}

static bool read_line(Reader *r)
{
    Str w = word(r, "a declaration or a function");

    if (!w)
        return false;
    if (is(w, "machine"))
        return read_machine(r);
    if (is(w, "vector"))
        return read_vector(r);
    if (is(w, "element"))
        return read_var(r, IR_ELEMENT);
    if (is(w, "local"))
        return read_var(r, IR_LOCAL);
    if (is(w, "time"))
        return read_var(r, IR_TIME);
    if (is(w, "window"))
        return read_window(r);
    if (is(w, "sample"))
        return read_function(r, &r->m->sample);
    if (is(w, "state"))
        return read_state(r);
    return read_state_function(r, w);
}

static bool settle_gotos(Reader *r)
{
    for (size_t i = 0; i < r->gotos.n; i++) {
        PendingGoto *g = &r->gotos.at[i];
        uintptr_t number = (uintptr_t)map_find(&r->states, g->name);
        r->line = g->line;
        if (!number)
            return fail(r, "there is no state '%.40s'", g->name->text);
        g->f->blk.at[g->b].jump.state = (uint32_t)number;
    }
    return true;
}

static bool is_complete(Reader *r)
{
    if (!r->m->name || !r->m->sv_name)
        return fail(r, "the text ends without %s", r->m->name ? "a vector" : "a machine");
    if (r->m->g == IR_NONE || r->m->s == IR_NONE || r->m->t == IR_NONE)
        return fail(r, "the text ends without an element that is G, one that is S and a time");
    return true;
}

IrMachine *ir_read(Arena *arena, StrPool *strings, const char *text, size_t len, const char **error)
{
    Reader r;
    bool ok = true;

    memset(&r, 0, sizeof r);
    r.arena = r.vars.arena = r.states.arena = arena;
    r.strings = strings;
    r.m = ARENA_NEW(arena, IrMachine);
    r.m->g = r.m->s = r.m->t = IR_NONE;
    r.at = text;
    r.end = text + len;
    r.line = 1;
    while (ok && next_line(&r))
        ok = read_line(&r) && line_is_over(&r);
    ok = ok && settle_gotos(&r) && is_complete(&r);
    *error = r.error;
    return ok ? r.m : NULL;
}
