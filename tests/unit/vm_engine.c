// SPDX-License-Identifier: Apache-2.0
// The VM as an engine: the images that it accepts for a program, and the results of writes, refused steps and init.  conformance/ and tests/diff
// check that it computes the same as the reference.
#include <stdlib.h>
#include <string.h>

#include "bytecode-vm/image.h"
#include "compiler/compile.h"
#include "compiler/script/engine.h"
#include "tests/heap.h"
#include "tests/test.h"

static const char counter[] = "[state_vector]\nU64 G\nU32 S\nI8 in @read_only\nU16 out\n[local]\nF64 half = 0.5 @read_only\nU8 n = 3\n"
                              "[A]\n.step\n n = n + in\n out = n\n n > 10: -> B\n[B]\n";
static const char other[] = "[state_vector]\nU64 G\nU32 S\nI8 inn @read_only\nU16 out\n[local]\nU8 n = 3\n[A]\n.step\n n = n + inn\n out = n\n n > 10: -> B\n[B]\n";
static const char one_state[] = "[state_vector]\nU64 G\nU32 S\nI8 in @read_only\nU16 out\n[local]\nU8 n = 3\n[A]\n.step\n n = n + in\n out = n\n";

static Program *compile_program(Session *s, const char *text)
{
    MachineInput in;

    memset(&in, 0, sizeof in);
    in.sm = source_new(&s->arena, "folder/to\\t.sm", text, strlen(text));
    return session_program(s, &in);
}

static Buf emit_image_of(Session *s, const Program *p, bool debug)
{
    IrMachine *m = session_ir(s, p, 1);
    ImageOptions o = {debug, NULL};
    Buf out;

    buf_init(&out, &s->arena);
    CHECK(session_image(s, &m, 1, &o, &out));
    return out;
}

// An image contains the name of the source without its folders.
static void test_source_is_named_without_folders(Session *s)
{
    Buf b = emit_image_of(s, compile_program(s, counter), true);
    SmvmMachine m;
    SmvmName n;

    CHECK(smvm_machine((const uint8_t *)b.at, 0, &m));
    n = smvm_name(&m, SMVM_NAME_SOURCE);
    CHECK(n.size == 4 && memcmp(b.at + n.at, "t.sm", 4) == 0);
}

static bool is_refused(Session *s, const Program *p, Buf b, uint32_t machine, const char *words)
{
    const char *error = NULL;
    Engine *e = engine_vm_open(&s->arena, p, (const uint8_t *)b.at, b.n, machine, &error);

    if (!e && !strstr(error, words))
        fprintf(stderr, "%s\n", error);
    return !e && strstr(error, words);
}

static void test_wrong_images_are_refused(Session *s)
{
    Program *p = compile_program(s, counter), *q = compile_program(s, other), *r = compile_program(s, one_state);
    Buf b = emit_image_of(s, p, true);

    CHECK(is_refused(s, p, b, 1, "no machine number 1"));
    CHECK(is_refused(s, q, b, 0, "another state vector"));
    CHECK(is_refused(s, r, b, 0, "another machine"));
    CHECK(is_refused(s, p, emit_image_of(s, p, false), 0, "no local named 'n'"));
    b.at[b.n - 1] ^= 1;
    CHECK(is_refused(s, p, b, 0, "rule 4"));
    b.n = 3;
    CHECK(is_refused(s, p, b, 0, "rule 3"));
}

static uint32_t find_element(const Program *p, const char *name)
{
    for (uint32_t i = 0; i < p->var.n; i++)
        if (strcmp(p->var.at[i]->name->text, name) == 0)
            return i;
    return 0;
}

static void test_engine_runs(Session *s)
{
    Program *p = compile_program(s, counter);
    Buf b = emit_image_of(s, p, true);
    const char *error = NULL;
    Engine *e = engine_vm_open(&s->arena, p, (const uint8_t *)b.at, b.n, 0, &error);
    uint32_t n = find_element(p, "n"), in = find_element(p, "in"), out = find_element(p, "out"), half = find_element(p, "half");
    EngineStep a;

    CHECK(e != NULL);
    if (!e)
        return;
    engine_step_init(&a, &s->arena, p);
    CHECK(e->init(e, 3, &a) == ENGINE_BROKEN && e->error);
    CHECK(e->init(e, 2, &a) == ENGINE_OK && a.next_state == 2 && a.cell[p->s->index] == 2 && a.cell[n] == 3);
    CHECK(e->init(e, 1, &a) == ENGINE_OK && a.next_state == 1 && a.next_is_first && a.cell[half] == 0x3fe0000000000000 && !a.stored[p->s->index]);
    CHECK(e->step(e, &(EngineWrite){in, 0xff}, 1, &a) == ENGINE_OK);             // -1
    CHECK(a.cell[n] == 2 && a.cell[out] == 2 && a.cell[in] == 0xff && a.stored[out] && a.stored[p->s->index] && !a.stored[in] && !a.next_is_first);
    CHECK(e->step(e, &(EngineWrite){in, 5}, 1, &a) == ENGINE_REFUSED && a.cell[n] == 2 && a.cell[in] == 5 && !a.stored[out]);
    CHECK(e->step(e, (const EngineWrite[]){{p->g->index, 9}, {n, 200}}, 2, &a) == ENGINE_OK);
    CHECK(a.cell[n] == 205 && a.cell[p->t->index] == 9 && a.next_state == 2 && a.next_is_first && a.cell[p->s->index] == 1);
    CHECK(!a.stored[p->s->index] && a.stored[out]);
    e->close(e);
}

int main(void)
{
    jmp_buf oom;
    Session s;

    session_init(&s, heap_alloc, NULL, &oom);
    test_wrong_images_are_refused(&s);
    test_source_is_named_without_folders(&s);
    test_engine_runs(&s);
    session_free(&s);
    return test_end("vm_engine");
}
