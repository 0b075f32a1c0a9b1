// SPDX-License-Identifier: Apache-2.0
// Prints IR as text, in the format that ir_read.c parses.  One item per line; `#` starts a comment; extra spaces are ignored.
//
//     machine "tank"                              its name
//     vector "tank" size 32 hash 0x1c0ffee5       the state vector it is bound to
//
//     element U64 time at 0 is G                  type, name, offset; "is G" and "is S" mark these two
//     element U32 state at 8 is S
//     element F64 tankPressure at 16
//     element bool valveOpen writable at 24       the machine stores to this one
//     local U64 counter writable = 0              initial value; "outside", "hidden", "parameter LO HI default VALUE": see ir.h
//     time U64 T
//     window w0 F64 size 10 stats avg max
//
//     sample {                                    the function that samples every window
//     b0:
//         %0 = load F64 tankPressure
//         sample w0, %0
//         ret
//     }
//     state Vent safe                             states are numbered from 1; this one is marked @safe; also "swap", "abort"
//     step {                                      entry, step, exit
//     b0:
//         %0 = stat avg w0
//         %1 = const F64 775
//         %2 = gt F64 %0, %1
//         br %2, b1, b2
//     b1:
//         %3 = const bool 1
//         store bool valveOpen, %3
//         goto Idle
//     b2:
//         ret
//     }
//
// The type after an operation is the type of its result; after a comparison, the type of its operands.  Logic, statistics and samples
// have no type in the text, because each of them has only one.  Temporaries are numbered in order of appearance, blocks by their index.
// A constant is a whole number, as `-3`, or its bit cell in hexadecimal, as 0x3fb999999999999a, which preserves every bit.
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compiler/ir/ir.h"
#include "compiler/ir/text.h"

const char *const ir_stat_name[SM_STAT_COUNT] = {"avg", "median", "min", "max", "range", "oldest", "newest", "change", "elapsed", "run_steps",
                                                 "run_time"};
const char *const ir_block_name[BLOCK_COUNT] = {"entry", "step", "exit"};

// Prints d with the fewest digits from which the same number of this type can be read back.
static void print_shortest(Buf *out, SmType type, double d)
{
    char text[40];
    int digits = type == SM_F32 ? 6 : 15;
    double back;

    do {
        snprintf(text, sizeof text, "%.*g", digits++, d);
        back = strtod(text, NULL);
    } while (digits <= 17 && (type == SM_F32 ? (float)back != (float)d : back != d));
    buf_str(out, text);
}

// Prints a whole number in decimal.  Prints any other number as its bits in hexadecimal, followed by a comment with the number in decimal.
// `comment`: whether a comment shows the number if its cell is printed.
static void print_float(Buf *out, SmType type, uint64_t cell, bool comment)
{
    uint32_t low = (uint32_t)cell;
    float f;
    double d;

    if (type == SM_F32) {
        memcpy(&f, &low, sizeof f);
        d = f;
    } else
        memcpy(&d, &cell, sizeof d);
    if (d > -1e15 && d < 1e15 && d == (double)(int64_t)d && (d != 0 || cell == 0)) {      // -0 is printed as its cell
        buf_printf(out, "%.0f", d);
        return;
    }
    buf_printf(out, "0x%0*llx", type == SM_F32 ? 8 : 16, (unsigned long long)cell);
    if (comment) {
        buf_str(out, "  # ");
        print_shortest(out, type, d);
    }
}

static void print_cell(Buf *out, SmType type, uint64_t cell, bool comment)
{
    unsigned unused = 64 - 8u * sm_type_info[type].bytes;

    switch (sm_type_info[type].kind) {
    case SM_KIND_FLOAT: print_float(out, type, cell, comment); break;
    case SM_KIND_UNSIGNED:
    case SM_KIND_BOOL: buf_printf(out, "%llu", (unsigned long long)cell); break;
    case SM_KIND_SIGNED:
        if (cell << unused >> 63)
            buf_printf(out, "-%llu", (unsigned long long)((~cell + 1) << unused >> unused));
        else
            buf_printf(out, "%llu", (unsigned long long)cell);
        break;
    }
}

static void print_value(Buf *out, SmType type, uint64_t cell) { print_cell(out, type, cell, true); }

static void print_quoted(Buf *out, Str text)
{
    buf_char(out, '"');
    for (uint32_t i = 0; text && i < text->len; i++) {
        char c = text->text[i];
        if (c == '"' || c == '\\' || (unsigned char)c < ' ')
            buf_printf(out, "\\%02x", (unsigned)(unsigned char)c);
        else
            buf_char(out, c);
    }
    buf_char(out, '"');
}

// ---- declarations ----

static void print_var(const IrMachine *m, uint32_t index, Buf *out)
{
    static const char *const word[] = {"element", "local", "time"};
    const IrVar *v = &m->var.at[index];

    buf_printf(out, "%s %s %s%s%s%s", word[v->space], sm_type_info[v->type].spelling, v->name->text, v->writable ? " writable" : "",
               v->outside ? " outside" : "", v->hidden ? " hidden" : "");
    if (v->space == IR_ELEMENT)
        buf_printf(out, " at %lu", (unsigned long)v->offset);
    if (index == m->g)
        buf_str(out, " is G");
    if (index == m->s)
        buf_str(out, " is S");
    if (v->parameter) {
        buf_str(out, " parameter ");
        print_cell(out, SM_F64, sm_bits(v->parameter->lo), false);
        buf_char(out, ' ');
        print_cell(out, SM_F64, sm_bits(v->parameter->hi), false);
        buf_str(out, " default ");
        print_cell(out, v->type, v->parameter->standard, false);
    }
    if (v->space == IR_LOCAL) {
        buf_str(out, " = ");
        print_value(out, v->type, v->init);
    }
    buf_char(out, '\n');
}

static void print_declarations(const IrMachine *m, Buf *out)
{
    buf_str(out, "machine ");
    print_quoted(out, m->name);
    buf_str(out, "\nvector ");
    print_quoted(out, m->sv_name);
    buf_printf(out, " size %lu hash 0x%08lx\n\n", (unsigned long)m->sv_size, (unsigned long)m->sv_hash);
    for (uint32_t v = 0; v < m->var.n; v++)
        print_var(m, v, out);
    for (uint32_t w = 0; w < m->window.n; w++) {
        const IrWindow *window = &m->window.at[w];
        buf_printf(out, "window w%lu %s size %lu stats", (unsigned long)w, sm_type_info[window->type].spelling,
                   (unsigned long)window->size);
        for (int stat = 0; stat < SM_STAT_COUNT; stat++)
            if (window->stats >> stat & 1)
                buf_printf(out, " %s", ir_stat_name[stat]);
        buf_char(out, '\n');
    }
}

// ---- functions ----

typedef struct IrPrinter {
    const IrMachine *m;
    const IrFn *f;
    uint32_t *number;                 // by IrRef: the number under which the temporary is printed
    uint32_t next;                    // the number of the next temporary
    Buf *out;
} IrPrinter;

static void print_temp(const IrPrinter *p, IrRef ref)
{
    buf_printf(p->out, "%%%lu", (unsigned long)p->number[ref]);
}

static void print_operands(const IrPrinter *p, const IrIns *i)
{
    if (ir_op_info[i->op].operands > 0)
        print_temp(p, i->a);
    if (ir_op_info[i->op].operands > 1) {
        buf_str(p->out, ", ");
        print_temp(p, i->b);
    }
}

static void print_type(const IrPrinter *p, SmType type)
{
    buf_printf(p->out, "%s ", sm_type_info[type].spelling);
}

// Prints one instruction on a line.  Its result gets the next number, because temporaries are numbered in order of appearance.
static void print_ins(IrPrinter *p, IrRef ref)
{
    const IrIns *i = &p->f->ins.at[ref];

    buf_str(p->out, "    ");
    if (!ir_op_info[i->op].effect) {               // an operation has an effect or a result, never both
        p->number[ref] = p->next++;
        print_temp(p, ref);
        buf_str(p->out, " = ");
    }
    buf_printf(p->out, "%s ", ir_op_info[i->op].name);
    switch (ir_op_info[i->op].types) {
    case IR_T_CONST: print_type(p, i->type); print_value(p->out, i->type, i->bits); break;
    case IR_T_CONVERT:
    case IR_T_SAME: print_type(p, i->type); print_operands(p, i); break;
    case IR_T_COMPARE: print_type(p, p->f->ins.at[i->a].type); print_operands(p, i); break;
    case IR_T_LOGIC: print_operands(p, i); break;
    case IR_T_LOAD: print_type(p, i->type); buf_str(p->out, p->m->var.at[i->var].name->text); break;
    case IR_T_STORE:
        print_type(p, i->type);
        buf_printf(p->out, "%s, ", p->m->var.at[i->var].name->text);
        print_operands(p, i);
        break;
    case IR_T_SAMPLE: buf_printf(p->out, "w%lu, ", (unsigned long)i->var); print_operands(p, i); break;
    case IR_T_STAT: buf_printf(p->out, "%s w%lu", ir_stat_name[i->stat], (unsigned long)i->var); break;
    }
    buf_char(p->out, '\n');
}

static void print_jump(const IrPrinter *p, const IrJump *j)
{
    switch (j->kind) {
    case IR_RET: buf_str(p->out, "    ret\n"); break;
    case IR_JMP: buf_printf(p->out, "    jmp b%lu\n", (unsigned long)j->then); break;
    case IR_BR:
        buf_str(p->out, "    br ");
        print_temp(p, j->cond);
        buf_printf(p->out, ", b%lu, b%lu\n", (unsigned long)j->then, (unsigned long)j->otherwise);
        break;
    case IR_GOTO: buf_printf(p->out, "    goto %s\n", p->m->state.at[j->state - 1].name->text); break;
    }
}

static void print_function(const IrMachine *m, const char *title, const IrFn *f, Buf *out)
{
    IrPrinter p = {m, f, NULL, 0, out};

    p.number = ARENA_ARRAY(out->arena, uint32_t, f->ins.n);
    buf_printf(out, "%s {\n", title);
    for (size_t b = 0; b < f->blk.n; b++) {
        buf_printf(out, "b%lu:\n", (unsigned long)b);
        for (size_t i = 0; i < f->blk.at[b].ins.n; i++)
            print_ins(&p, f->blk.at[b].ins.at[i]);
        print_jump(&p, &f->blk.at[b].jump);
    }
    buf_str(out, "}\n");
}

void ir_print(const IrMachine *m, Buf *out)
{
    print_declarations(m, out);
    if (m->sample) {
        buf_char(out, '\n');
        print_function(m, "sample", m->sample, out);
    }
    for (size_t s = 0; s < m->state.n; s++) {
        const IrState *state = &m->state.at[s];
        buf_printf(out, "\nstate %s%s%s%s\n", state->name->text, state->is_safe ? " safe" : "", state->allows_swap ? " swap" : "",
                   state->is_abort ? " abort" : "");
        for (int k = 0; k < BLOCK_COUNT; k++)
            if (state->block[k])
                print_function(m, ir_block_name[k], state->block[k], out);
    }
}
