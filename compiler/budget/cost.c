// SPDX-License-Identifier: Apache-2.0
// Finds the longest path through each function.  Jumps only go forward.  So one walk from the last instruction to the first computes,
// for each instruction, the cost of the longest path to the end of the function, separately for paths that end in the instruction
// `end` and in `goto`.  From the start, the path then follows the successor with the higher cost.
#include "compiler/budget/cost.h"

#include <string.h>

#include "bytecode-vm/image.h"
#include "bytecode-vm/smvm.h"
#include "compiler/budget/cycles.h"

enum { STATE_FUNCTIONS = 3 };           // .entry, .step and .exit, by CostPart

typedef enum PathEnd { PATH_ENDS, PATH_LEAVES, PATH_KINDS } PathEnd;        // the path ends in `end` (stays in the state), in `goto`

typedef struct ImageIns {
    uint32_t at;                  // offset of the instruction in the image
    uint8_t op;
    uint32_t to;                  // target of its jump, in the image; 0: not a jump
    uint32_t line, units;         // the source line of the instruction; the cost of this instruction alone
    uint32_t longest_from_here[PATH_KINDS];     // by kind of end: cost of the longest path, this instruction included; 0: there is no path
} ImageIns;

typedef struct ImageFn {
    ImageIns *ins;
    uint32_t n;
    uint32_t longest[PATH_KINDS];       // by kind of end: cost of the longest path; all zero for a function without code, which ends in `end`
    bool ends;                    // some path of the function ends in the instruction `end`
} ImageFn;

typedef struct ImageReader {
    Arena *arena;
    CostUnit unit;
    uint32_t always;              // the cost of a step besides that of the functions that it runs
    SmvmMachine m;
    Cycles cycles;                // state after the last instruction that was read
    SmvmLines lines;              // the first row of the line table that begins after the instruction being read
    bool more;                    // `lines` is valid: the table has such a row
    uint32_t line;                // source line of the instruction being read
    uint32_t functions;           // the elementary functions that the instructions call, as in Cost
} ImageReader;

static uint32_t larger(uint32_t a, uint32_t b) { return a > b ? a : b; }

// ---- reading a function ----

// Reads the instruction at this position into *out and returns the position of the next one.  `end`: position of the end of the function.  Positions
// must ascend from call to call, because the line table is read along with the instructions.
static uint32_t read_ins(ImageReader *r, uint32_t at, uint32_t end, ImageIns *out)
{
    const uint8_t op = smvm_u8(r->m.image, at);
    const bool jumps = smvm_shape(op) & SMVM_SHAPE_J;
    SmvmAt next = (SmvmAt)(at + 1);
    uint32_t number[2] = {0, 0};
    unsigned n = 0;

    while (r->more && r->lines.code <= at - r->m.code_at) {
        r->line = r->lines.line;
        r->more = smvm_next_line(&r->m, &r->lines);
    }
    while (next < end && n < 2 && smvm_u8(r->m.image, next) < SMVM_OP_FIRST)
        smvm_read_varint(r->m.image, &next, (SmvmAt)end, &number[n++]);
    *out = (ImageIns){at, op, 0, r->line, r->unit == COST_INSTRUCTIONS ? 1 : cycles_of_ins(&r->cycles, op, number, n), {0, 0}};
    if (op == SMVM_fn)
        r->functions |= UINT32_C(1) << number[0];
    if (jumps)                                        // the last number is the jump distance
        out->to = next + number[n - 1];
    return next;
}

// ---- the longest path ----

// Returns the index of the instruction at this position of the image, which must be in the function.
static uint32_t find_ins_at(const ImageFn *f, uint32_t at)
{
    uint32_t low = 0, high = f->n - 1;

    while (low < high) {
        const uint32_t middle = low + (high - low) / 2;
        if (f->ins[middle].at < at)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

static bool falls_through(const ImageIns *i) { return i->op != SMVM_end && i->op != SMVM_goto && i->op != SMVM_jmp; }

// Reads function `index` of the machine and computes its longest paths.
static ImageFn read_function(ImageReader *r, uint32_t index)
{
    const uint32_t begin = r->m.code_at + (index == 0 ? 0 : smvm_function_end(&r->m, index - 1));
    const uint32_t end = r->m.code_at + smvm_function_end(&r->m, index);
    uint32_t n = 0;
    ImageFn f;

    memset(&f, 0, sizeof f);
    for (uint32_t at = begin; at < end; at++)
        n += smvm_u8(r->m.image, at) >= SMVM_OP_FIRST;
    f.ins = ARENA_ARRAY(r->arena, ImageIns, n);
    for (uint32_t at = begin; at < end;)
        at = read_ins(r, at, end, &f.ins[f.n++]);
    for (uint32_t i = f.n; i-- > 0;) {
        ImageIns *ins = &f.ins[i];
        const ImageIns *next = falls_through(ins) ? ins + 1 : NULL, *target = ins->to ? &f.ins[find_ins_at(&f, ins->to)] : NULL;
        ins->longest_from_here[PATH_ENDS] = ins->op == SMVM_end ? ins->units : 0;
        ins->longest_from_here[PATH_LEAVES] = ins->op == SMVM_goto ? ins->units : 0;
        for (int p = 0; p < PATH_KINDS; p++) {
            const uint32_t most = larger(next ? next->longest_from_here[p] : 0, target ? target->longest_from_here[p] : 0);
            ins->longest_from_here[p] = most ? most + ins->units : ins->longest_from_here[p];
        }
    }
    for (int p = 0; p < PATH_KINDS && f.n; p++)
        f.longest[p] = f.ins[0].longest_from_here[p];
    f.ends = f.n == 0 || f.longest[PATH_ENDS] > 0;
    return f;
}

// ---- the path as source lines ----

// Appends the longest path of f to the path of the state, one entry for each run of instructions of the same line.
static void append_path(ImageReader *r, StateCost *s, const ImageFn *f, CostPart part, PathEnd path)
{
    for (uint32_t i = 0; i < f->n;) {
        const ImageIns *ins = &f->ins[i];
        CostLine *last = s->path.n ? &s->path.at[s->path.n - 1] : NULL, fresh = {part, ins->line, ins->units};
        if (last && last->part == part && last->line == ins->line)
            last->units += ins->units;
        else
            vec_push(r->arena, &s->path, fresh);
        if (ins->op == SMVM_end || ins->op == SMVM_goto)
            return;
        i = falls_through(ins) && ins[1].longest_from_here[path] + ins->units == ins->longest_from_here[path] ? i + 1 : find_ins_at(f, ins->to);
    }
}

// ---- a state ----

typedef struct LongestStep {
    uint32_t n;                   // the step's cost
    bool entry, step, exit;       // whether the step runs .entry, .step and .exit
    PathEnd entry_path, step_path;    // how .entry and .step end
} LongestStep;

// Replaces *best by s if s costs more.
static void update_longest(LongestStep *best, LongestStep s)
{
    if (s.n > best->n)
        *best = s;
}

// Updates *best with the longest step that begins like s and then runs .step, and .exit if .step leaves the state.
static void update_longest_with_step(LongestStep *best, const ImageFn *f, LongestStep s)
{
    const uint32_t before = s.n;

    s.step = true;
    s.n = before + f[COST_STEP].longest[PATH_ENDS];
    s.step_path = PATH_ENDS;
    if (f[COST_STEP].ends)
        update_longest(best, s);
    if (f[COST_STEP].longest[PATH_LEAVES]) {
        s.n = before + f[COST_STEP].longest[PATH_LEAVES] + f[COST_EXIT].longest[PATH_ENDS];
        s.step_path = PATH_LEAVES;
        s.exit = true;
        update_longest(best, s);
    }
}

// Returns the longest first step of a state with the functions f: .entry, then .step unless .entry leaves.
static LongestStep longest_first_step(const ImageFn *f)
{
    LongestStep best = {0, false, false, false, PATH_ENDS, PATH_ENDS};
    const LongestStep left = {
        f[COST_ENTRY].longest[PATH_LEAVES] + f[COST_EXIT].longest[PATH_ENDS], true, false, true, PATH_LEAVES, PATH_ENDS};
    const LongestStep ended = {f[COST_ENTRY].longest[PATH_ENDS], true, false, false, PATH_ENDS, PATH_ENDS};

    if (f[COST_ENTRY].longest[PATH_LEAVES])
        update_longest(&best, left);
    if (f[COST_ENTRY].ends)
        update_longest_with_step(&best, f, ended);
    return best;
}

// Computes the costs of the first and of later steps of a state, and the path of the most expensive step. sample: the function that runs in every
// step.
static void compute_state_cost(ImageReader *r, uint32_t state, const ImageFn *sample, StateCost *s)
{
    ImageFn f[STATE_FUNCTIONS];
    LongestStep first, later = {0, false, false, false, PATH_ENDS, PATH_ENDS};
    const LongestStep *worst;

    for (uint32_t b = 0; b < STATE_FUNCTIONS; b++)
        f[b] = read_function(r, 1 + STATE_FUNCTIONS * state + b);       // function 0 is the sample function
    first = longest_first_step(f);
    if (f[COST_ENTRY].ends && f[COST_STEP].ends)                // otherwise every path leaves the state in its first step
        update_longest_with_step(&later, f, later);
    s->first = r->always + sample->longest[PATH_ENDS] + first.n;
    s->later = f[COST_ENTRY].ends && f[COST_STEP].ends ? r->always + sample->longest[PATH_ENDS] + later.n : 0;
    s->worst = larger(s->first, s->later);
    worst = first.n >= later.n ? &first : &later;
    append_path(r, s, sample, COST_SAMPLE, PATH_ENDS);
    if (worst->entry)
        append_path(r, s, &f[COST_ENTRY], COST_ENTRY, worst->entry_path);
    if (worst->step)
        append_path(r, s, &f[COST_STEP], COST_STEP, worst->step_path);
    if (worst->exit)
        append_path(r, s, &f[COST_EXIT], COST_EXIT, PATH_ENDS);
}

// ---- bytes ----

// Fills in the sizes of *out: RAM, code, locals and windows.
static void fill_in_bytes(ImageReader *r, Cost *out)
{
    const SmvmMachine *m = &r->m;

    out->ram = smvm_ram_size_64(m);
    out->code = m->code_size;
    out->locals = m->locals;
    out->window_count = m->windows;
    out->window = ARENA_ARRAY(r->arena, CostWindow, m->windows);
    for (uint32_t w = 0; w < m->windows; w++) {
        const uint32_t entry = smvm_window(m->image, m->windows_at, w), kind = entry >> SMVM_WINDOW_SIZE_BITS;
        CostWindow *window = &out->window[w];
        window->size = entry & SMVM_WINDOW_SIZE_MASK;
        window->type = (SmType)(kind & SM_ROLL_TYPE);
        window->bytes = 8 * sm_roll_words(window->size, kind);
        out->windows += window->bytes;
        out->windows_small += 8 + (kind & SM_ROLL_MEDIAN ? 2 : 1) * sm_roll_row_bytes(sm_roll_slots(window->size, kind), kind);
    }
    out->own = out->ram - out->locals - out->windows;
}

// Computes the cost of machine `number`, counted from 0, of an image that the verifier has accepted.
void cost_of_machine(Arena *arena, const uint8_t *image, uint32_t number, CostUnit unit, Cost *out)
{
    ImageReader r;
    ImageFn sample;

    memset(&r, 0, sizeof r);
    memset(out, 0, sizeof *out);
    r.arena = arena;
    smvm_machine(image, number, &r.m);
    r.unit = unit;
    r.more = smvm_next_line(&r.m, &r.lines);
    if (unit != COST_INSTRUCTIONS)
        r.always = cycles_begin(&r.cycles, unit == COST_CYCLES_FLASH ? CYCLES_FLASH : CYCLES_EEPROM, &r.m);
    sample = read_function(&r, 0);
    out->sample = sample.longest[PATH_ENDS];
    out->states = r.m.states;
    out->state = ARENA_ARRAY(arena, StateCost, r.m.states);
    for (uint32_t s = 0; s < r.m.states; s++) {
        compute_state_cost(&r, s, &sample, &out->state[s]);
        if (out->state[s].worst > out->worst || s == 0) {
            out->worst = out->state[s].worst;
            out->worst_state = s + 1;
        }
    }
    out->functions = r.functions;
    fill_in_bytes(&r, out);
}

// Iterates over the entries of a state's path that have a source line, the most expensive first: returns the first one if `before` is NULL,
// else the one after it.
const CostLine *cost_next_most_expensive(const StateCost *s, const CostLine *before)
{
    const CostLine *most = NULL;

    for (size_t i = 0; i < s->path.n; i++) {
        const CostLine *l = &s->path.at[i];
        if (before && (l->units > before->units || (l->units == before->units && l <= before)))
            continue;
        if (l->line && (!most || l->units > most->units))
            most = l;
    }
    return most;
}
