// SPDX-License-Identifier: Apache-2.0
// Compares the longest step that cost.h reports with the instructions counted while the VM runs.  No step takes more.  Where inputs can select
// the longest path, some step takes as many.
//
//     run [PROGRAMS]               PROGRAMS random programs (default 200), and the machines below
#include <setjmp.h>
#include <stdlib.h>
#include <string.h>

#include "bytecode-vm/smvm.h"
#include "compiler/budget/cost.h"
#include "tests/cost/config.h"
#include "tests/diff/subject.h"
#include "tests/test.h"

static uint32_t counted;

void cost_count_instruction(void) { counted++; }

// ---- one machine that runs ----

typedef struct Counted {
    Buf image;
    Cost cost;
    SmvmMachine m;
    SmvmVector sv;
    SmVm *vm;
    uint32_t *most_first, *most_later;            // by state: instructions of the longest step executed
} Counted;

static uint32_t sum_of_way(const StateCost *s)
{
    uint32_t n = 0;

    for (size_t i = 0; i < s->path.n; i++)
        n += s->path.at[i].units;
    return n;
}

static void check_cost(const Counted *c)
{
    uint32_t worst = 0;

    for (uint32_t s = 0; s < c->cost.states; s++) {
        CHECK(sum_of_way(&c->cost.state[s]) == c->cost.state[s].worst);
        worst = worst > c->cost.state[s].worst ? worst : c->cost.state[s].worst;
    }
    CHECK(worst == c->cost.worst && c->cost.state[c->cost.worst_state - 1].worst == worst);
    CHECK(c->cost.worst <= smvm_longest_step(&c->m));
    CHECK(c->cost.ram == smvm_ram_size(&c->m) && c->cost.own >= sizeof(SmVm));
}

// The same for cycles: each state has a path that is part of its longest step, and a path takes longer from EEPROM than from flash.
static void check_cycles(Arena *arena, const Counted *c)
{
    Cost flash, eeprom;

    cost_of_machine(arena, (const uint8_t *)c->image.at, 0, COST_CYCLES_FLASH, &flash);
    cost_of_machine(arena, (const uint8_t *)c->image.at, 0, COST_CYCLES_EEPROM, &eeprom);
    CHECK(flash.states == c->cost.states && flash.ram == c->cost.ram);
    for (uint32_t s = 0; s < c->cost.states; s++) {
        const uint32_t always = flash.state[s].worst - sum_of_way(&flash.state[s]);
        CHECK(always == flash.state[0].worst - sum_of_way(&flash.state[0]) && always > 0);
        CHECK((flash.state[s].path.n == 0) == (c->cost.state[s].worst == 0) && flash.state[s].worst < eeprom.state[s].worst);
    }
}

static bool open_machine(Counted *c, Session *s, const Program *p, int level, bool debug)
{
    const ImageOptions o = {debug, NULL};
    IrMachine *m = session_ir(s, p, level);

    buf_init(&c->image, &s->arena);
    if (!session_image(s, &m, 1, &o, &c->image))
        return false;
    smvm_machine((const uint8_t *)c->image.at, 0, &c->m);
    cost_of_machine(&s->arena, (const uint8_t *)c->image.at, 0, COST_INSTRUCTIONS, &c->cost);
    check_cost(c);
    check_cycles(&s->arena, c);
    c->sv = (SmvmVector){arena_alloc(&s->arena, p->sv->size), p->sv->size, p->sv->hash};
    c->vm = arena_alloc(&s->arena, smvm_ram_size(&c->m));
    c->most_first = ARENA_ARRAY(&s->arena, uint32_t, c->m.states);
    c->most_later = ARENA_ARRAY(&s->arena, uint32_t, c->m.states);
    return true;
}

static void start(Counted *c, uint32_t state)
{
    CHECK(smvm_init(c->vm, smvm_ram_size(&c->m), &c->m, &c->sv, state) == SM_OK);
}

// Runs one step, and compares the number of its instructions with the bounds.
static void step(Counted *c)
{
    const uint32_t state = smvm_state(c->vm) - 1;
    const bool first = c->vm->first;
    uint32_t *most = first ? &c->most_first[state] : &c->most_later[state];

    counted = 0;
    if (smvm_step(c->vm, c->sv.at) != SM_OK)
        return;
    *most = *most > counted ? *most : counted;
    CHECK(counted <= (first ? c->cost.state[state].first : c->cost.state[state].later));
}

// ---- random programs ----

static void put_cell(const Counted *c, const Var *v, uint64_t cell)
{
    if (v->kind == VAR_ELEMENT)
        memcpy((uint8_t *)c->sv.at + v->element->offset, &cell, sm_type_info[v->type].bytes);    // little-endian hosts
}

static void run_program(const Gen *g, const Subject *s, int level)
{
    EngineWrite write[GEN_VARS_MAX];
    Counted c;

    if (!open_machine(&c, (Session *)&s->session, s->program, level, false))
        return;
    start(&c, gen_state_number(g, g->first_state));
    for (uint32_t k = 0; k < g->steps; k++) {
        const uint32_t n = subject_writes(s, g, k, write);
        uint32_t state;
        if (gen_restarts(g, k, &state))
            start(&c, gen_state_number(g, state));
        for (uint32_t i = 0; i < n; i++)
            put_cell(&c, s->program->var.at[write[i].var], write[i].cell);
        step(&c);
    }
}

static void run_random(uint64_t seed)
{
    Arena arena;
    Subject s;
    Gen *g;

    diff_arena_init(&arena);
    g = gen_program(&arena, seed, 60);
    gen_plan_time(g);
    CHECK(subject_compile(&s, g, &arena) == NULL);
    if (s.program) {
        run_program(g, &s, 0);
        run_program(g, &s, 2);
    }
    subject_free(&s);
    arena_free(&arena);
}

// ---- machines whose longest steps can happen ----

#define HEAD "[state_vector]\nU64 G\nU32 S\nF64 x\nF64 y\nF64 z\nU8 a\n[local]\nU16 n = 0\n"

static const char *const reachable[] = {
    // an empty machine
    HEAD "[A]\n",
    // if, else, a jump over the rest
    HEAD "[A]\n.step\n if x > 1 { y = z + x * 2\n a = 3 }\n else: a = 4\n z > 5: -> B\n.exit\n n = n + 1\n a = n\n[B]\n.entry\n a "
         "= 9\n.step\n x < 1: -> A\n y = x\n",
    // a transition in .entry is the longest step; its state never executes a later step
    HEAD
    "[A]\n.entry\n x > 0 { y = x * x + z\n z = y / 3\n -> B }\n -> C\n.exit\n a = 1\n[B]\n.step\n x > 3: -> A\n[C]\n.step\n -> A\n",
    // windows are sampled in every step; statistics are computed where they are read
    HEAD "[A]\n.step\n roll_avg(x, 3) > 1 and roll_max(y, 4) < 2: -> B\n y = roll_median(x, 3)\n[B]\n.entry\n n = 0\n.step\n n = n "
         "+ 1\n n > 3: -> A\n",
    // nested conditionals
    HEAD "[A]\n.step\n if x > 0 {\n  if y > 0 { a = 1\n z = x + y + z }\n  else if z > 0 { a = 2 }\n  else { a = 3\n z = x - y\n y "
         "= z * x }\n }\n x > 2 and y > 2: -> B\n[B]\n.step\n -> A\n.exit\n z = 0\n",
};

static void put_random(const Counted *c, const Program *p, Rng *r, uint64_t now)
{
    static const double values[] = {-1, 0, 1, 1.5, 2.5, 4, 7};

    for (size_t i = 0; i < p->var.n; i++) {
        const Var *v = p->var.at[i];
        uint64_t cell;
        memcpy(&cell, &values[rng_below(r, 7)], sizeof cell);
        if (v == p->g)
            put_cell(c, v, now);
        else if (v->type == SM_F64)
            put_cell(c, v, cell);
    }
}

static void check_reached(const Counted *c)
{
    for (uint32_t s = 0; s < c->cost.states; s++) {
        CHECK(c->most_first[s] == c->cost.state[s].first);
        CHECK(c->most_later[s] == c->cost.state[s].later);
    }
}

static void run_reachable(const char *text, int level)
{
    jmp_buf out_of_memory;
    MachineInput in = {0};
    Rng r = {7};
    Arena lent;
    Session s;
    Counted c;
    Program *p;

    diff_arena_init(&lent);
    session_init(&s, lent.alloc, NULL, &out_of_memory);
    in.sm = source_new(&s.arena, "m.sm", text, strlen(text));
    p = session_program(&s, &in);
    CHECK(p && open_machine(&c, &s, p, level, true));
    for (uint64_t k = 0; p && k < 20000; k++) {
        if (k % 50 == 0)
            start(&c, 1 + rng_below(&r, c.m.states));
        put_random(&c, p, &r, k % 50);
        step(&c);
    }
    if (p)
        check_reached(&c);
    session_free(&s);
}

int main(int argc, char **argv)
{
    const unsigned long n = argc > 1 ? strtoul(argv[1], NULL, 10) : 200;

    for (size_t i = 0; i < sizeof reachable / sizeof *reachable; i++)
        for (int level = 0; level <= 2; level++)
            run_reachable(reachable[i], level);
    for (unsigned long seed = 1; seed <= n; seed++)
        run_random(seed);
    return test_end("cost");
}
