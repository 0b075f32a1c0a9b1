// SPDX-License-Identifier: Apache-2.0
// A parameter that an application sets for a machine.  The image and the C of that machine start with this value; the default does not change.
#include <stdlib.h>
#include <string.h>

#include "bytecode-vm/smvm.h"
#include "compiler/compile.h"
#include "compiler/sema/sema.h"
#include "tests/test.h"

static const char source[] = "[state_vector]\nU64 G\nU32 S\nF64 out\n[local]\nF64 limit = 450 @parameter @range -150 1000\nU8 n = 3 @parameter @range 1 9\n"
                             "F64 other = 1\n[A]\n.step\n other = other + 1\n out = limit + n + other\n";

static void *host(void *context, void *old, size_t n)
{
    (void)context;
    if (n)
        return realloc(old, n);
    free(old);
    return NULL;
}

static AstExpr number(const Program *p, double x) { return (AstExpr){.kind = AST_NUMBER, .number = x, .span = {p->src, 0, 1}}; }

static bool set(Sema *s, Program *p, const char *name, const AstExpr *value)
{
    return set_parameter_of_machine(s, p, str_c(s->strings, name), (Span){p->src, 20 + (uint32_t)strlen(name), 1}, value);
}

// Whether the session has a diagnostic with these words.
static bool is_reported(Session *c, const char *words)
{
    const DiagStyle plain = {false, 20};
    Buf text;

    buf_init(&text, &c->arena);
    diags_render_text(&c->diags, &plain, &text);
    return strstr(buf_text(&text), words) != NULL;
}

static void test_setting(Session *c, Sema *s, Program *p)
{
    AstExpr x = number(p, 300), negative = {.kind = AST_UNARY, .op = SM_OP_NEG, .a = &x, .span = {p->src, 1, 1}};
    AstExpr name = {.kind = AST_NAME, .span = {p->src, 15, 3}};

    CHECK(set(s, p, "limit", &x) && program_parameter(p, str_c(s->strings, "limit"))->init == sm_bits(300));
    CHECK(!set(s, p, "limit", &negative) && !set(s, p, "limit", &name) && !set(s, p, "n", &x) && !set(s, p, "other", &x) && !set(s, p, "none", &x));
    CHECK(c->diags.errors_seen == 5 && is_reported(c, "cannot set parameter 'limit' to -300: the value is below the range"));
    CHECK(is_reported(c, "cannot set parameter 'limit' to U64: the value is not a number") && is_reported(c, "the machine has no such parameter"));
    x = number(p, 100);
    CHECK(set(s, p, "limit", &negative) && program_parameter(p, str_c(s->strings, "limit"))->init == sm_bits(-100));
}

static void test_what_is_emitted(Session *c, Program *p)
{
    const ImageOptions o = {false, NULL};
    IrMachine *ir = session_ir(c, p, 2);
    Buf image, header, code;
    SmvmParameter q;
    SmvmMachine m;

    buf_init(&image, &c->arena);
    buf_init(&header, &c->arena);
    buf_init(&code, &c->arena);
    CHECK(session_image(c, &ir, 1, &o, &image) && smvm_machine((SmvmBytes)image.at, 0, &m));
    CHECK(smvm_parameter(&m, 0, &q) && q.value == -100 && q.standard == 450 && smvm_parameter(&m, 1, &q) && q.value == 3);
    session_emit_c(c, session_ir(c, p, 2), NULL, &header, &code);
    CHECK(strstr(buf_text(&code), "m->limit = -100.0;") != NULL);
}

int main(void)
{
    jmp_buf oom;
    Session c;
    MachineInput in;
    CheckContext context;
    AstFile none;
    Program *p;
    Sema s;

    if (setjmp(oom) != 0)
        return 1;
    session_init(&c, host, NULL, &oom);
    memset(&none, 0, sizeof none);
    memset(&in, 0, sizeof in);
    none.src = in.sm = source_new(&c.arena, "deploy.sm", source, strlen(source));
    p = session_program(&c, &in);
    CHECK(p != NULL);
    context = (CheckContext){.arena = &c.arena, .strings = &c.strings, .diags = &c.diags};
    sema_init(&s, &context, find_hidden_names(&context, &none), p, &p->window);
    test_setting(&c, &s, p);
    test_what_is_emitted(&c, p);
    session_free(&c);
    return test_end("sema_parameter");
}
