// SPDX-License-Identifier: Apache-2.0
// Measures the memory of compiling, and of running a script, against budgets.  Counts the bytes that the compiler requests from its host: the
// same on every machine with pointers of 64 bits.  Budgets are for large inputs, so that fixed costs do not count.  An arena requests at most
// 16 MB at a time, so a measurement can exceed what is needed by that much.
//
//     memory
#include <stdio.h>
#include <stdlib.h>

#include "compiler/compile.h"
#include "tests/bench/shapes.h"
#include "tests/test.h"

typedef struct Budget {
    const char *shape;
    unsigned n;
    const char *unit;         // of which there are n
    double most;              // bytes for each unit, beside its source
    double least;             // a measurement below this is a mistake of the measurement
} Budget;

static const Budget budgets[] = {
    {"script_blocks", 400000, "block", 245, 125},
};

// ---- counting ----

static size_t used, most_used, of_sources;

typedef union Header { size_t size; double align; } Header;       // precedes each allocated block

// An SmcAllocFn that counts the bytes in use.
static void *count_alloc(void *context, void *old, size_t size)
{
    Header *was = old ? (Header *)old - 1 : NULL, *h;

    (void)context;
    used -= was ? was->size : 0;
    if (size == 0) {
        free(was);
        return NULL;
    }
    if ((h = realloc(was, sizeof *h + size)) == NULL)
        return NULL;
    h->size = size;
    used += size;
    most_used = used > most_used ? used : most_used;
    return h + 1;
}

// ---- measuring ----

// Compiles a machine with all warnings to an image, and runs its script if it has one.  Returns whether this is possible.
static bool compile(Session *s, const Shape *shape, unsigned n)
{
    const ScriptOptions run = {.max_steps = 1000, .is_compared = true};
    const Source *ss = shape_source(s, "m.ss", shape->ss, n);
    MachineInput in = {.sm = shape_source(s, "m.sm", shape->write, n)};
    const ImageOptions options = {false, NULL};
    Program *p;
    Script *script;
    IrMachine *m;
    Engine *ref;
    Buf image;

    of_sources = used;
    if ((p = session_program(s, &in)) == NULL)
        return false;
    s->warnings = 1u << DIAG_GROUP_ALL;
    session_analyse(s, p);
    m = session_ir(s, p, 2);
    buf_init(&image, &s->arena);
    if (!session_image(s, &m, 1, &options, &image))
        return false;
    if (!ss)
        return true;
    if ((script = session_script(s, ss, p)) == NULL)
        return false;
    ref = engine_ref_open(&s->arena, p);
    script_run(&s->arena, &s->diags, script, &ref, 1, &run);
    return true;
}

// Compares what a shape needs with its budget.
static void measure(const Budget *b)
{
    double bytes;
    jmp_buf oom;
    Session s;

    used = most_used = 0;
    session_init(&s, count_alloc, NULL, &oom);
    CHECK(setjmp(oom) == 0);
    CHECK(compile(&s, shape_find(b->shape), b->n));
    bytes = (double)(most_used - of_sources) / b->n;
    session_free(&s);
    CHECK(used == 0);
    printf("%s %u: %.0f bytes a %s, at most %.0f\n", b->shape, b->n, bytes, b->unit, b->most);
    CHECK(bytes <= b->most);
    CHECK(bytes >= b->least || sizeof(void *) < 8);
}

int main(void)
{
    for (size_t i = 0; i < sizeof budgets / sizeof budgets[0]; i++)
        measure(&budgets[i]);
    return test_end("memory");
}
