// SPDX-License-Identifier: Apache-2.0
// Internals of the checker: offsets and hash of a state vector, constants, the content of a Program and of a Script, speed.
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "compiler/compile.h"
#include "compiler/sema/sema.h"
#include "stdlib/convert.h"
#include "stdlib/crc32.h"
#include "tests/heap.h"
#include "tests/test.h"

static jmp_buf oom;

static Source *text(Session *s, const char *name, const char *t)
{
    return source_new(&s->arena, name, t, strlen(t));
}

static Program *compile(Session *s, const char *sm)
{
    MachineInput in = {0};

    session_init(s, heap_alloc, NULL, &oom);
    in.sm = text(s, "dir/tank.v2.sm", sm);
    return session_program(s, &in);
}

static Var *var(Session *s, const Program *p, const char *name)
{
    return map_find(&p->by_name, str_c(&s->strings, name));
}

// ---- state vectors ----

static void test_layout(void)
{
    static const char sv_text[] = "[options]\nlock\n[A]\nU8 a I16 b\nF64 c bool d\n[B]\nU32 e\n[C]\nI8 f";
    static const char canonical[] = "[A]\nU8 a\nI16 b\nF64 c\nbool d\n[B]\nU32 e\n[C]\nI8 f\n";
    static const uint32_t offset[] = {0, 2, 8, 16, 24, 32};
    Session s;
    StateVec *sv;

    session_init(&s, heap_alloc, NULL, &oom);
    sv = session_state_vector(&s, text(&s, "app.sv", sv_text));
    CHECK(sv && sv->element.n == 6 && sv->region.n == 3);
    if (!sv)
        return;
    for (size_t i = 0; i < 6; i++)
        CHECK(sv->element.at[i]->offset == offset[i]);
    CHECK(sv->region.at[0]->offset == 0 && sv->region.at[0]->size == 17 && sv->region.at[0]->packed_size == 12);
    CHECK(sv->region.at[1]->offset == 24 && sv->region.at[1]->size == 4 && sv->region.at[1]->first == 4);
    CHECK(sv->region.at[2]->offset == 32 && sv->region.at[2]->count == 1);
    CHECK(sv->size == 40 && sv->lock && !sv->from_machine);
    CHECK(sv->hash == sm_crc32(canonical, strlen(canonical)));
    CHECK(strcmp(sv->name->text, "app") == 0);
    session_free(&s);
}

// ---- constants ----

// Returns the value of an expression, as the initial value of an F64.
static SmF64 value_of(const char *expression)
{
    Session s;
    Buf b;
    Program *p;
    SmF64 x = sm_from_i32(-12345);

    session_init(&s, heap_alloc, NULL, &oom);
    buf_init(&b, &s.arena);
    buf_printf(&b, "[state_vector]\nU64 G\nU32 S\n[local]\nF64 two = 2\nU8 big = 300\nF64 x = %s\n[A]\n", expression);
    p = session_program(&s, &(MachineInput){text(&s, "a.sm", buf_text(&b)), NULL, NULL, NULL});
    if (p)
        x = sm_cell_to_f64(SM_F64, var(&s, p, "x")->init);
    CHECK(p != NULL);
    session_free(&s);
    return x;
}

static void test_constants(void)
{
    CHECK(sm_eq(value_of("1 + 2 * 3 - 4 / 8"), 6.5));
    CHECK(sm_eq(value_of("10 - 4 - 3"), 3));
    CHECK(sm_eq(value_of("big + 1"), 256));              // the stored value, saturated
    CHECK(sm_eq(value_of("3 < 5 < 4"), 0));
    CHECK(sm_eq(value_of("(3 < 5) < 4"), 1));
    CHECK(sm_eq(value_of("1 < 2 <= 2 > 1 >= 1"), 1));
    CHECK(sm_eq(value_of("1 < 2 <= 2 > 1 >= 1.5"), 0));
    CHECK(sm_eq(value_of("not 0 + 1"), 2));
    CHECK(sm_eq(value_of("not (0 / 0)"), 1));
    CHECK(sm_eq(value_of("0 / 0 or 0"), 0));
    CHECK(sm_eq(value_of("-1 and 1e-300"), 1));
    CHECK(sm_eq(value_of("0 / 0 != 0 / 0"), 1));
    CHECK(sm_eq(value_of("0 / 0"), 0));                  // NaN is not stored
    CHECK(sm_bits(value_of("-0.0")) == 0x8000000000000000u);
    CHECK(sm_bits(value_of("0 - 0.0")) == 0);
    CHECK(sm_eq(value_of("+two - -two"), 4));
    CHECK(sm_eq(value_of("min(two, 3) + max(two, 3) * 10 + clamp(7, 0, 5) * 100"), 532));
    CHECK(sm_eq(value_of("round(-2.5) + floor(2.5) + ceil(2.5) + trunc(-2.5) + abs(-2) + sign(-9)"), 1));
    CHECK(sm_eq(value_of("sqrt(2) * sqrt(2) > 2"), 1));
}

// ---- programs ----

static const char machine[] =
    "[local]\nU16 n = 3\nF64 k = n + 1 @read_only\n"
    "[state_vector]\nU64 time @alias G\nU32 S\nF64 p @alias Q @read_only\nbool v\nF64 zz @alias aa\n"
    "[One]\n.step\n  v = roll_avg(roll_max(p, n), k) + roll_min(p, 2) > 1 < 2\n  ((p)): -> Two\n"
    "[Two]\n.exit\n zz = -(+p)\n";

static void test_program(void)
{
    Session s;
    Program *p = compile(&s, machine);
    const Expr *e;

    CHECK(p && s.diags.errors == 0 && s.diags.warnings == 0);
    if (!p)
        return;
    CHECK(strcmp(p->name->text, "tank.v2") == 0);
    CHECK(p->var.n == 8 && p->g == p->var.at[0] && p->s == p->var.at[1] && p->t == p->var.at[7]);
    CHECK(p->var.at[5]->kind == VAR_LOCAL && p->var.at[5]->index == 5 && !p->var.at[5]->is_constant);
    CHECK(p->var.at[6]->is_constant && p->var.at[6]->init == 0x4010000000000000u);
    CHECK(strcmp(var(&s, p, "G")->report_name->text, "G") == 0 && strcmp(var(&s, p, "zz")->report_name->text, "aa") == 0);
    CHECK(strcmp(var(&s, p, "Q")->report_name->text, "Q") == 0 && var(&s, p, "Q") == var(&s, p, "p"));
    CHECK(p->g->read_only && p->s->read_only && p->t->read_only && var(&s, p, "p")->read_only);
    CHECK(p->sv->from_machine && p->sv->size == 40 && var(&s, p, "zz")->element->offset == 32);
    CHECK(p->state.n == 2 && p->state.at[1]->number == 2);
    CHECK(p->window.n == 3 && p->window.at[0].size == 3 && p->window.at[1].size == 4 && p->window.at[2].size == 2);
    CHECK(p->window.at[1].sample->kind == EX_ROLL && p->window.at[1].sample->window == 0);   // inner before outer
    e = p->state.at[0]->block[BLOCK_STEP].at[0]->value;
    CHECK(e->kind == EX_CHAIN && e->n == 3 && expr_ops(e)[0] == SM_OP_GT && expr_ops(e)[1] == SM_OP_LT);
    CHECK(e->arg[0]->kind == EX_BINARY && e->arg[2]->kind == EX_NUMBER);
    CHECK(p->state.at[0]->block[BLOCK_STEP].at[1]->value->kind == EX_VAR);                   // parentheses are removed
    CHECK(p->state.at[0]->block[BLOCK_STEP].at[1]->then.at[0]->target == p->state.at[1]);
    e = p->state.at[1]->block[BLOCK_EXIT].at[0]->value;
    CHECK(e->kind == EX_UNARY && e->op == SM_OP_NEG && e->arg[0]->kind == EX_VAR);           // so is unary plus
    CHECK(var(&s, p, "v")->written && !var(&s, p, "v")->read && var(&s, p, "n")->read && !var(&s, p, "n")->written);
    session_free(&s);
}

static void test_written_outside(void)
{
    static const char script[] = "[options]\ndelta_t 5\n[all_states]\nG == 0 { k = 2\n p = 1 }\nG > 9: @stop\n";
    Session s;
    Map names;
    MachineInput in = {NULL, NULL, &names, NULL};
    Program *p;
    Script *ss;

    session_init(&s, heap_alloc, NULL, &oom);
    memset(&names, 0, sizeof names);
    names.arena = &s.arena;
    in.sm = text(&s, "tank.sm", machine);
    script_add_written_names(session_parse(&s, text(&s, "a.ss", script), FILE_SS), &names);
    p = session_program(&s, &in);
    CHECK(p && !var(&s, p, "k")->is_constant && var(&s, p, "k")->read_only);
    ss = p ? session_script(&s, text(&s, "a.ss", script), p) : NULL;
    CHECK(ss && ss->delta_t == 5 && ss->init_state == p->state.at[0] && ss->section.n == 1 && s.diags.warnings == 1);
    if (ss) {
        CHECK(ss->section.at[0].item.n == 2 && ss->section.at[0].item.at[0]->inputs.n == 2);
        CHECK(ss->section.at[0].item.at[1]->stop && !ss->section.at[0].state);
    }
    session_free(&s);
}

// ---- analyses ----

static bool warns(const Session *s, DiagCode code, const char *word)
{
    for (size_t i = 0; i < s->diags.list.n; i++)
        if (s->diags.list.at[i]->code == code && strstr(s->diags.list.at[i]->text, word))
            return true;
    return false;
}

static void test_analyses(void)
{
    Session s;
    Program *p = compile(&s, "[state_vector]\nU64 G\nU32 S\nF64 in\nF64 unused\nF64 out\n"
                             "[local]\nF64 a = 1\nF64 b = a\nF64 never = 1\nF64 pi = 3 @read_only\n"
                             "[One]\n.entry\n in > 1 { -> Two\n -> Three }\n out = 1\n b = 2\n"
                             "[Two]\n.step\n -> One\n[Three]\n.step\n -> Four\n[Four]\n[Five]\n.step\n-> Five\n");

    CHECK(p != NULL);
    if (!p)
        return;
    s.diags.list.n = 0;
    s.diags.warnings = 0;
    session_analyse(&s, p);
    CHECK(s.diags.warnings == 6);
    CHECK(warns(&s, DIAG_unused_element, "'unused'") && warns(&s, DIAG_unused_local, "'never'"));
    CHECK(warns(&s, DIAG_unread_local, "'b'"));
    CHECK(warns(&s, DIAG_never_written, "'a'") && warns(&s, DIAG_unused_local, "'pi'"));
    CHECK(warns(&s, DIAG_unreachable_state, "'Five'"));
    session_free(&s);
}

// ---- size ----

// 10,000 states, 16,000 locals, 100,000 statements; with `bad`, as many unknown names.
static void test_size(const char *bad, double most_seconds)
{
    Session s;
    Buf b;
    clock_t start;
    Program *p;

    session_init(&s, heap_alloc, NULL, &oom);
    buf_init(&b, &s.arena);
    buf_str(&b, "[state_vector]\nU64 G\nU32 S\n[local]\n");
    for (int i = 0; i < 16000; i++)
        buf_printf(&b, "F64 local_%d = %d\n", i, i);
    for (int i = 0; i < 10000; i++) {
        buf_printf(&b, "[State_%d]\n.step\n", i);
        for (int j = 0; j < 9; j++)
            buf_printf(&b, "local_%d%s = local_%d + %d\n", (i * 9 + j) % 16000, bad, i, j);
        buf_printf(&b, "T > 5: -> State_%d%s\n", (i + 1) % 10000, bad);
    }
    start = clock();
    p = session_program(&s, &(MachineInput){text(&s, "a.sm", buf_text(&b)), NULL, NULL, NULL});
    CHECK((double)(clock() - start) / CLOCKS_PER_SEC < most_seconds);
    CHECK(*bad ? !p && s.diags.errors == 26000 : p && p->state.n == 10000);
    session_free(&s);
}

int main(void)
{
    if (setjmp(oom))
        return 1;
    test_layout();
    test_constants();
    test_program();
    test_written_outside();
    test_analyses();
    test_size("", 2);
    test_size("_bad", 4);
    return test_end("sema");
}
