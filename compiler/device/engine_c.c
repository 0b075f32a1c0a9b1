// SPDX-License-Identifier: Apache-2.0
#include "compiler/device/engine_c.h"

#include <string.h>

#include "compiler/base/os.h"
#include "compiler/base/os_process.h"
#include "compiler/compile.h"
#include "compiler/passes/pass.h"

typedef struct EngineC {
    Engine engine;
    EngineCBatch *batch;
    uint32_t machine;         // number of the machine in the batch
    Buf request;              // the requests that are being sent to both variants (VARIANTS)
    uint8_t *answer;          // memory for the answers of both variants, the first variant's first
} EngineC;

struct EngineCBatch {
    Arena *arena;
    OsPartner partner;
    EngineC *at;
    size_t n;
};

// Each machine is emitted in two variants, and both execute every step.  The first tracks which elements it stores, and its answer is the
// result of the engine.  The second does not track stores, as in flight, and must otherwise give the same answer.
enum { VARIANTS = 2 };

enum { PATH_LEN = 512, MESSAGE_MAX = 2000 };

// ---- building ----

// The temporary folder in which a program is built.
typedef struct BuildFolder {
    Arena *arena;
    char folder[PATH_LEN];    // path of the folder; "" before it exists
    const char **error;       // receives the reason of a failure
} BuildFolder;

// Stores the reason of a failure, `what` and `why` as one sentence; returns false.
static bool set_error(BuildFolder *w, const char *what, const char *why)
{
    *w->error = format_in(w->arena, "%s: %s", what, why);
    return false;
}

typedef VEC(const char *) CommandWords;

// Appends the words of a command, which are separated by whitespace.  Quotes and backslashes work as in a shell: a part in '…' or "…" belongs
// to one word, and a backslash outside '…' makes the next character ordinary.  Nothing is expanded.  False if a quote is not closed.
static bool split_words(Arena *a, const char *text, CommandWords *words)
{
    while (*(text += strspn(text, " \t\n")) != '\0') {
        Buf word;
        char quote = 0;
        buf_init(&word, a);
        for (; *text && (quote || !strchr(" \t\n", *text)); text++) {
            if (quote ? *text == quote : *text == '\'' || *text == '"')
                quote = quote ? 0 : *text;
            else if (*text == '\\' && quote != '\'' && text[1])
                buf_char(&word, *++text);
            else
                buf_char(&word, *text);
        }
        if (quote)
            return false;
        vec_push(a, words, buf_text(&word));
    }
    return true;
}

// Returns the diagnostics of the C compiler from its log file, cut off after MESSAGE_MAX bytes; a sentence with its exit code if the compiler wrote
// no diagnostics.
static const char *read_compiler_output(Arena *arena, const char *log, int exit_code)
{
    char *text;
    const char *why, *result;
    size_t len = 0;

    if (!os_read_file(log, 1 << 20, &text, &len, &why))
        text = NULL;
    if (len == 0)
        result = format_in(arena, "it ended with exit code %d and no message", exit_code);
    else
        result = format_in(arena, "%.*s%s", len > MESSAGE_MAX ? MESSAGE_MAX : (int)len, text, len > MESSAGE_MAX ? "…" : "");
    os_alloc(NULL, text, 0);
    return result;
}

// A 32-bit smc starts 32-bit programs.  On x86 emitted C needs SSE2 for them, because x87 registers would change results.
#if defined __i386__
#define DEFAULT_COMPILER "cc -msse2 -mfpmath=sse"
#else
#define DEFAULT_COMPILER "cc"
#endif

// Returns the command of the C compiler: its name and its first options.
static const char *compiler_command(void) { return os_getenv("CC") ? os_getenv("CC") : DEFAULT_COMPILER; }

static const char *no_compiler_message(Arena *arena, const char *compiler)
{
    return format_in(arena, "cannot run the C compiler %s (the variable CC names another)", compiler);
}

// Whether the compiler can be run; if not, *why is a sentence in arena.
bool engine_c_present(Arena *arena, const char **why)
{
    CommandWords argv = {0};
    const char *reason;
    int exit_code;

    if (!split_words(arena, compiler_command(), &argv) || argv.n == 0)
        return true;
    vec_push(arena, &argv, "--version");
    vec_push(arena, &argv, NULL);
    if (!os_run_program(argv.at, os_null_device, NULL, &exit_code, &reason))
        *why = format_in(arena, "%s: %s", no_compiler_message(arena, argv.at[0]), reason);
    else if (exit_code != 0)
        *why = format_in(arena, "%s: '%s --version' ended with exit code %d", no_compiler_message(arena, argv.at[0]), argv.at[0], exit_code);
    else
        return true;
    return false;
}

// Compiles the emitted C in the folder and starts the program.  Returns false after storing the reason of a failure.
static bool build_in_folder(BuildFolder *w, const Buf *code, OsPartner *partner)
{
    const char *cc = compiler_command(), *path, *why;
    const char *source = format_in(w->arena, "%s/machine.c", w->folder), *program = format_in(w->arena, "%s/machine", w->folder);
    const char *log = format_in(w->arena, "%s/log", w->folder), *const program_argv[] = {program, NULL};
    const OsOutput out = {source, code->at, code->n};
    CommandWords argv = {0};
    int exit_code;

    if (!os_write_files(&out, 1, &path, &why))
        return set_error(w, "cannot write the emitted C", why);
    if (!split_words(w->arena, cc, &argv))
        return set_error(w, format_in(w->arena, "the variable CC is %s", cc), "a quote in it is not closed");
    if (argv.n == 0)
        return set_error(w, "CC", "it names no compiler");
    if (!strstr(cc, " -O"))
        vec_push(w->arena, &argv, "-O1");
    vec_push(w->arena, &argv, "-o");
    vec_push(w->arena, &argv, program);
    vec_push(w->arena, &argv, source);
    vec_push(w->arena, &argv, NULL);
    if (!os_run_program(argv.at, log, w->folder, &exit_code, &why))
        return set_error(w, no_compiler_message(w->arena, argv.at[0]), why);
    if (exit_code != 0)
        return set_error(w, format_in(w->arena, "the C compiler %s does not accept the emitted C", argv.at[0]),
                         read_compiler_output(w->arena, log, exit_code));
    if (!os_partner_start(partner, program_argv, &why))
        return set_error(w, "cannot start the compiled machine", why);
    return true;
}

// Builds the program and starts it.  The folder is always removed, because a running program does not need its file.  If memory runs out,
// this function intercepts the longjmp, removes the folder, and passes the longjmp on to the outer target.  Returns false and sets *error if
// the program could not be built or started.
static bool build_and_start(Arena *arena, const Buf *code, OsPartner *partner, const char **error)
{
    BuildFolder *w = ARENA_NEW(arena, BuildFolder);
    jmp_buf *outer = arena->oom, here;
    const char *why;
    bool ok;

    w->arena = arena;
    w->error = error;
    if (setjmp(here) != 0) {
        if (w->folder[0])
            os_remove_folder(w->folder);
        arena->oom = outer;
        longjmp(*outer, 1);
    }
    arena->oom = &here;
    if (os_temp_folder(w->folder, sizeof w->folder, &why))
        ok = build_in_folder(w, code, partner);
    else
        ok = set_error(w, "cannot make a folder for the emitted C", why);
    if (w->folder[0])
        os_remove_folder(w->folder);
    arena->oom = outer;
    return ok;
}

// ---- the protocol (emit_c.h, emit_c_driver) ----

// Stores the reason of a failure; returns ENGINE_BROKEN.
static EngineStatus fail_engine(EngineC *e, const char *why)
{
    e->engine.error = format_in(e->batch->arena, "emitted C: %s", why);
    return ENGINE_BROKEN;
}

// Returns the number in `size` bytes, lowest byte first.
static uint64_t read_little_endian(const uint8_t *at, int size)
{
    uint64_t v = 0;

    while (size > 0)
        v = v << 8 | at[--size];
    return v;
}

// Begins a request to a variant (see VARIANTS): appends the variant's number and the command.  For the first variant, clears e->request.
static void begin_request(EngineC *e, uint32_t variant, uint32_t command)
{
    if (variant == 0)
        e->request.n = 0;
    buf_u32(&e->request, e->machine * VARIANTS + variant);
    buf_u32(&e->request, command);
}

// Bytes of an answer: three u32, then a u64 and a u8 for each variable.
enum { ANSWER_HEAD = 12, ANSWER_PER_VARIABLE = 9 };

// Returns the bytes of one answer for a machine.
static size_t answer_size(const Program *p) { return ANSWER_HEAD + ANSWER_PER_VARIABLE * p->var.n; }

// Sends the requests to both variants and decodes the answers, which must be equal except for the flags of stored elements.
static EngineStatus run_request(EngineC *e, EngineStep *out)
{
    const size_t vars = e->engine.program->var.n, size = answer_size(e->engine.program);
    const uint8_t *cell = e->answer + ANSWER_HEAD;
    const char *why;

    if (!os_partner_write(&e->batch->partner, e->request.at, e->request.n, &why) ||
        !os_partner_read(&e->batch->partner, e->answer, VARIANTS * size, &why))
        return fail_engine(e, why);
    if (memcmp(e->answer, e->answer + size, size - vars) != 0)
        return fail_engine(e, "with and without --track-stores it does not do the same");
    if (read_little_endian(e->answer, 4) > 1)
        return fail_engine(e, "it does not start: the C compiler or its options change what arithmetic means");
    out->status = read_little_endian(e->answer, 4) == 0 ? ENGINE_OK : ENGINE_REFUSED;
    out->next_state = (uint32_t)read_little_endian(e->answer + 4, 4);
    out->next_is_first = read_little_endian(e->answer + 8, 4) != 0;
    for (size_t i = 0; i < vars; i++)
        out->cell[i] = read_little_endian(cell + 8 * i, 8);
    memcpy(out->stored, cell + 8 * vars, vars);
    return out->status;
}

// Starts the machine in a state: sends the command to both variants (see VARIANTS).
static EngineStatus c_init(Engine *engine, uint32_t state, EngineStep *out)
{
    EngineC *e = engine->self;

    for (uint32_t variant = 0; variant < VARIANTS; variant++) {
        begin_request(e, variant, 0);
        buf_u32(&e->request, state);
    }
    return run_request(e, out);
}

// Runs a step after writing n elements: sends the command to both variants of the emitted machine, with and without
// tracked stores.
static EngineStatus c_step(Engine *engine, const EngineWrite *write, uint32_t n, EngineStep *out)
{
    EngineC *e = engine->self;

    for (uint32_t variant = 0; variant < VARIANTS; variant++) {
        begin_request(e, variant, 1);
        buf_u32(&e->request, n);
        for (uint32_t i = 0; i < n; i++) {
            buf_u32(&e->request, write[i].var);
            buf_u64(&e->request, write[i].cell);
        }
    }
    return run_request(e, out);
}

static void c_close_in_batch(Engine *engine) { (void)engine; }
static void c_close(Engine *engine) { engine_c_batch_close(((EngineC *)engine->self)->batch); }

// ---- opening ----

// Emits the program: both variants of each machine, one after the other, and the driver.  Returns NULL, or which pass has broken a machine.
static const char *emit_program(Arena *arena, const IrMachine *const *m, size_t n, bool soft, Buf *code)
{
    const IrMachine **variant = ARENA_ARRAY(arena, const IrMachine *, VARIANTS * n);
    bool *track_stores = ARENA_ARRAY(arena, bool, VARIANTS * n);
    const PassOptions o = {.soft = soft};
    const char *wrong;

    for (size_t i = 0; i < VARIANTS * n; i++) {
        variant[i] = i % VARIANTS == 0 ? passes_for_c(arena, m[i / VARIANTS], &o, &wrong) : variant[i - 1];
        if (!variant[i])
            return wrong;
        track_stores[i] = i % VARIANTS == 0;
    }
    emit_c_driver(arena, variant, track_stores, VARIANTS * n, soft, code);
    return NULL;
}

// Builds and starts one program with the emitted C of n machines. NULL if that fails; *error is then a sentence.
EngineCBatch *engine_c_batch_open(Arena *arena, const Program *const *p, const IrMachine *const *m, size_t n, bool soft, const char **error)
{
    EngineCBatch *b = ARENA_NEW(arena, EngineCBatch);
    EngineStep s;
    Buf code;

    b->arena = arena;
    b->at = ARENA_ARRAY(arena, EngineC, n);
    b->n = n;
    for (size_t i = 0; i < n; i++) {
        EngineC *e = &b->at[i];
        e->engine = (Engine){.name = soft ? "c-soft" : "c", .program = p[i], .self = e, .init = c_init, .step = c_step, .close = c_close_in_batch};
        e->batch = b;
        e->machine = (uint32_t)i;
        buf_init(&e->request, arena);
        e->answer = arena_alloc(arena, VARIANTS * answer_size(p[i]));
    }
    buf_init(&code, arena);
    if ((*error = emit_program(arena, m, n, soft, &code)) != NULL || !build_and_start(arena, &code, &b->partner, error))
        return NULL;
    if (n == 0)
        return b;
    // The program refuses every init if its self-test of arithmetic fails, so the init of one machine decides for all.
    engine_step_init(&s, arena, p[0]);
    if (c_init(&b->at[0].engine, 1, &s) == ENGINE_OK)
        return b;
    *error = b->at[0].engine.error;
    engine_c_batch_close(b);
    return NULL;
}

Engine *engine_c_batch_engine(EngineCBatch *b, size_t i) { return &b->at[i].engine; }

void engine_c_batch_close(EngineCBatch *b) { os_partner_end(&b->partner); }

// Opens an engine that runs emitted C.  `soft`: with numbers in software.  NULL if it cannot be built; *error is then a sentence.
Engine *engine_c_open(Arena *arena, const Program *p, const IrMachine *m, bool soft, const char **error)
{
    EngineCBatch *b = engine_c_batch_open(arena, &p, &m, 1, soft, error);

    if (!b)
        return NULL;
    b->at[0].engine.close = c_close;
    return &b->at[0].engine;
}
