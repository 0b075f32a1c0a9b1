// SPDX-License-Identifier: Apache-2.0
// An application as C: a header that declares the functions the user writes, and a source file of static tables on top of runtime-c, whose
// headers document their contents.  The file's own names have no underscore, or are a user's name followed by Step, Init, Safe, Self or
// Copy, so that no two clash.
#include "compiler/emit/c/app.h"

#include <string.h>

#include "bytecode-vm/image.h"
#include "compiler/emit/c/emit_c.h"
#include "compiler/emit/c/unit.h"
#include "stdlib/convert.h"
#include "stdlib/roll.h"

// The names of the application's parts.
typedef struct Emitter {
    Arena *arena;
    const App *app;
    const char *prefix;           // rocket, in rocket_app
    const char *sv;               // rocket, in rocket_vector
    const char *io;               // rocket, in rocket_inputs, rocket_io.h
    CUnit vector;                 // with the names of the vector's members
    CVectorNames names;           // of the elements' numbers
    const Buf *const *image;      // by machine; NULL if the machine is emitted as C
    Buf *out;
} Emitter;

static const char *identifier(Arena *arena, const char *name) { return c_identifier(arena, name, strlen(name)); }

static void begin(Emitter *e, Arena *arena, const App *app, Buf *out)
{
    memset(e, 0, sizeof *e);
    e->arena = arena;
    e->app = app;
    e->out = out;
    e->prefix = identifier(arena, app->name->text);
    e->sv = identifier(arena, app->sv->name->text);
    if (app->io)
        e->io = identifier(arena, app->io_name->text);
    c_vector_names(arena, app->sv, &e->vector);
    names_runtime(arena, &e->vector.names, app->sv, &e->names);
}

static const char *element_of(const Emitter *e, const Element *x)
{
    return format_in(e->arena, "&%s_element[%s]", e->sv, e->names.element[x->index]);
}

static void title(const Emitter *e)
{
    buf_printf(e->out, "// The application %s.  Made by smc from %s.app: change that, not this file.\n", e->app->name->text,
               e->app->name->text);
}

// ---- the header ----

static void write_includes(const Emitter *e)
{
    buf_printf(e->out, "#include \"runtime-c/sm.h\"\n#include \"%s.h\"\n", e->app->sv->name->text);
}

static void write_prototype(const Emitter *e, const AppTask *t, uint64_t period)
{
    buf_printf(e->out, "\n// Every %s%s%s.\n", app_time_text(e->arena, period), t->mode ? ", as its mode says: " : "",
               t->mode ? t->mode->name->text : "");
    if (t->has_init)
        buf_printf(e->out, "SmResult %s_init(void);\n", t->name->text);
    buf_printf(e->out, "SmResult %s_step(const SmTick *tick);\n", t->name->text);
    if (t->has_safe)
        buf_printf(e->out, "SmResult %s_safe(const SmTick *tick);\n", t->name->text);
}

static void write_user_prototypes(const Emitter *e)
{
    for (size_t x = 0; x < e->app->executor.n; x++)
        for (size_t r = 0; r < e->app->executor.at[x]->rate.n; r++) {
            const AppRate *rate = e->app->executor.at[x]->rate.at[r];
            for (size_t t = 0; t < rate->task.n; t++)
                if (rate->task.at[t]->kind == AST_TASK_task)
                    write_prototype(e, rate->task.at[t], rate->period);
        }
}

static void write_header(const Emitter *e)
{
    const char *macro = c_macro_name(e->arena, e->prefix);

    title(e);
    buf_printf(e->out, "#ifndef %s_APP_H_INCLUDED\n#define %s_APP_H_INCLUDED\n\n", macro, macro);
    write_includes(e);
    buf_str(e->out, "\n#ifdef __cplusplus\nextern \"C\" {\n#endif\n\n");
    buf_printf(e->out, "extern SmApp %s_app;\n\n// ---- you write these: runtime-c/task.h documents them ----\n",
               e->prefix);
    write_user_prototypes(e);
    buf_str(e->out, "\n#ifdef __cplusplus\n}\n#endif\n\n#endif\n");
}

// ---- machines ----

static const char *type_of_machine(const Emitter *e, const AppMachine *m)
{
    return c_machine_type(e->arena, identifier(e->arena, m->program->name->text), e->vector.names.sv_type);
}

static bool is_guarded(const Emitter *e) { return e->app->sv->lock; }

static void write_one_machine(const Emitter *e, const AppMachine *m)
{
    const char *n = m->name->text, *type = format_in(e->arena, "%s_machine", identifier(e->arena, m->program->name->text));

    buf_printf(e->out, "    {.name = \"%s\", .type = &%s, .self = &%sSelf, .sv = &%s_vector, .events = &events", n,
               m->bytecode ? "smvm_machine_type" : type, n, e->sv);
    if (is_guarded(e))
        buf_printf(e->out, ", .copy = %sCopy", n);
    if (m->initial)
        buf_printf(e->out, ", .initial = %u", (unsigned)m->initial->number);
    if (m->resume)
        buf_printf(e->out, ", .resume = true, .restored = &%s_app.restored", e->prefix);
    buf_printf(e->out, ", .number = %u},\n", (unsigned)m->number);
}

// ---- a machine that runs on the VM: its image as a constant, and its memory ----

static unsigned window_words(const SmvmMachine *m)
{
    unsigned words = 0;

    for (uint32_t w = 0; w < m->windows; w++) {
        uint32_t entry = smvm_window(m->image, m->windows_at, w);
        words += sm_roll_words(entry & SMVM_WINDOW_SIZE_MASK, entry >> SMVM_WINDOW_SIZE_BITS);
    }
    return words;
}

static void write_app_image(const AppMachine *m, const Buf *image, Buf *out)
{
    const char *n = m->name->text;
    SmvmMachine vm;

    smvm_machine((const uint8_t *)image->at, 0, &vm);
    buf_printf(out, "static const uint8_t %sImage[] SMVM_IMAGE_IN = {        // %s.sm as bytecode", n, m->program->name->text);
    emit_c_bytes(image, out);
    buf_printf(out,
               "\n};\nstatic uint64_t %sMemory[SMVM_WORDS(%u, %u, %u, %u)];"
               "        // windows, their words, bytes of locals, outputs\n",
               n, (unsigned)vm.windows, window_words(&vm), (unsigned)vm.locals, (unsigned)vm.outputs);
    buf_printf(out,
               "static SmvmTarget %sSelf = {.image = SMVM_IMAGE(%sImage), .size = sizeof %sImage, "
               ".memory = %sMemory, .memory_size = sizeof %sMemory};\n",
               n, n, n, n, n);
}

static void write_machines(const Emitter *e)
{
    if (e->app->machine.n == 0)
        return;
    buf_str(e->out, "\n// ---- machines ----\n\n");
    for (size_t i = 0; i < e->app->machine.n; i++) {
        const AppMachine *m = e->app->machine.at[i];
        if (m->bytecode)
            write_app_image(m, e->image[i], e->out);
        else
            buf_printf(e->out, "static %s %sSelf;\n", type_of_machine(e, m), m->name->text);
        if (is_guarded(e))
            buf_printf(e->out, "static uint64_t %sCopy[(sizeof(%s) + 7) / 8];        // its snapshot of the state vector\n",
                       m->name->text, e->vector.names.sv_type);
    }
    buf_str(e->out, "\nstatic SmMachine machines[] = {\n");
    for (size_t i = 0; i < e->app->machine.n; i++)
        write_one_machine(e, e->app->machine.at[i]);
    buf_str(e->out, "};\n");
}

// ---- log, saved state vector ----

static bool has_task(const Emitter *e, AstAppTaskKind kind)
{
    for (size_t i = 0; i < e->app->task.n; i++)
        if (e->app->task.at[i]->kind == kind)
            return true;
    return false;
}

static unsigned packed_size(const StateVec *sv)
{
    unsigned size = 0;

    for (size_t i = 0; i < sv->region.n; i++)
        size += sv->region.at[i]->packed_size;
    return size;
}

// Escapes a text for a C string literal.
static const char *quoted(const Emitter *e, Str text)
{
    Buf b;

    buf_init(&b, e->arena);
    for (size_t i = 0; i < text->len; i++) {
        unsigned char c = (unsigned char)text->text[i];
        if (c == '"' || c == '\\' || c == '?')
            buf_printf(&b, "\\%c", c);
        else if (c < 0x20 || c >= 0x7f)
            buf_printf(&b, "\\%03o", c);
        else
            buf_char(&b, (char)c);
    }
    return buf_text(&b);
}

static void write_name_table(const Emitter *e, const char *table, bool tasks)
{
    size_t n = tasks ? e->app->task.n : e->app->executor.n;

    buf_printf(e->out, "static const char *const %s[] = {\n", table);
    for (size_t i = 0; i < n; i++)
        buf_printf(e->out, "    \"%s\",\n", tasks ? e->app->task.at[i]->name->text : e->app->executor.at[i]->name->text);
    buf_str(e->out, "};\n");
}

static void write_log(const Emitter *e)
{
    const App *a = e->app;

    if (!has_task(e, AST_TASK_log))
        return;
    buf_str(e->out, "\n// ---- the flight log ----\n\n");
    if (a->machine.n) {
        buf_str(e->out, "static const SmMachine *const logged[] = {\n");
        for (size_t i = 0; i < a->machine.n; i++)
            buf_printf(e->out, "    &machines[%u],\n", (unsigned)i);
        buf_str(e->out, "};\n");
    }
    write_name_table(e, "taskNames", true);
    write_name_table(e, "executorNames", false);
    buf_printf(e->out, "static uint8_t logBuffer[%u];\n", (unsigned)a->log_room);
    buf_printf(e->out, "static SmLog flightLog = {\n    .file = \"%s\", .sv = &%s_vector, .names = &%s_names, .events = &events,\n",
               quoted(e, a->log), e->sv, e->sv);
    if (a->machine.n)
        buf_printf(e->out, "    .machine = logged, .machines = %u,\n", (unsigned)a->machine.n);
    buf_printf(e->out, "    .task = taskNames, .tasks = %u, .executor = executorNames, .executors = %u,\n", (unsigned)a->task.n,
               (unsigned)a->executor.n);
    buf_str(e->out, "    .buffer = logBuffer, .room = sizeof logBuffer\n};\n");
}

static void write_keep(const Emitter *e)
{
    if (!has_task(e, AST_TASK_keep))
        return;
    buf_str(e->out, "\n// ---- the saved state vector ----\n\n");
    buf_printf(e->out, "static uint8_t keepBuffer[2 * SM_KEEP_SIZE(%uu)];\n", packed_size(e->app->sv));
    buf_printf(e->out, "static SmKeep keeper = {.memory = \"%s\", .sv = &%s_vector, .buffer = keepBuffer};\n",
               quoted(e, e->app->keep), e->sv);
}

// ---- tasks ----

static void write_trampoline(const Emitter *e, const char *name, const char *end, const char *call)
{
    bool init = strcmp(end, "Init") == 0;

    buf_printf(e->out, "static SmResult %s%s(void *context%s)\n{\n    (void)context;\n    return %s_%s;\n}\n", name, end,
               init ? "" : ", const SmTick *tick", name, call);
}

static void write_trampolines(const Emitter *e)
{
    for (size_t i = 0; i < e->app->task.n; i++) {
        const AppTask *t = e->app->task.at[i];
        if (t->kind != AST_TASK_task)
            continue;
        buf_char(e->out, '\n');
        if (t->has_init)
            write_trampoline(e, t->name->text, "Init", "init()");
        write_trampoline(e, t->name->text, "Step", "step(tick)");
        if (t->has_safe)
            write_trampoline(e, t->name->text, "Safe", "safe(tick)");
    }
}

// .init, .step, .safe and .context of a task.
static void write_functions(const Emitter *e, const AppTask *t)
{
    const char *n = t->name->text;

    switch (t->kind) {
    case AST_TASK_task:
        if (t->has_init)
            buf_printf(e->out, ".init = %sInit, ", n);
        buf_printf(e->out, ".step = %sStep", n);
        if (t->has_safe)
            buf_printf(e->out, ", .safe = %sSafe", n);
        break;
    case AST_TASK_machine:
        buf_printf(e->out, ".init = sm_machine_init, .step = sm_machine_step, .context = &machines[%u]",
                   (unsigned)t->machine->number);
        break;
    case AST_TASK_inputs:
        buf_printf(e->out, ".init = sm_inputs_init, .step = sm_inputs_step, .context = &%s_inputs", e->io);
        break;
    case AST_TASK_outputs:
        buf_printf(e->out, ".init = sm_outputs_init, .step = sm_outputs_step, .safe = sm_outputs_safe, .context = &%s_outputs",
                   e->io);
        break;
    case AST_TASK_log:
        buf_str(e->out, ".init = sm_log_init, .step = sm_log_step, .context = &flightLog");
        break;
    case AST_TASK_keep:
        buf_str(e->out, ".step = sm_keep_step, .context = &keeper");
        break;
    case AST_APP_TASK_COUNT:
        break;
    }
}

static void write_task(const Emitter *e, const AppTask *t)
{
    buf_printf(e->out, "    {.name = \"%s\", ", t->name->text);
    write_functions(e, t);
    if (t->mode)
        buf_printf(e->out, ", .mode = %s", element_of(e, t->mode));
    buf_printf(e->out, ", .number = %u},\n", (unsigned)t->number);
}

static void write_tasks(const Emitter *e)
{
    buf_str(e->out, "\n// ---- tasks, in source order ----\n");
    write_trampolines(e);
    buf_str(e->out, "\nstatic SmTask tasks[] = {\n");
    for (size_t i = 0; i < e->app->task.n; i++)
        write_task(e, e->app->task.at[i]);
    buf_str(e->out, "};\n\nstatic SmTask *const order[] = {\n");
    for (size_t i = 0; i < e->app->task.n; i++)
        buf_printf(e->out, "    &tasks[%u],        // %s\n", (unsigned)i, e->app->task.at[i]->name->text);
    buf_str(e->out, "};\n");
}

// ---- executors ----

static void write_rates(const Emitter *e)
{
    size_t task = 0;

    buf_str(e->out, "\n// ---- executors ----\n\nstatic const SmRate rates[] = {\n");
    for (size_t x = 0; x < e->app->executor.n; x++)
        for (size_t r = 0; r < e->app->executor.at[x]->rate.n; r++) {
            const AppRate *rate = e->app->executor.at[x]->rate.at[r];
            buf_printf(e->out, "    {.every = %u, .tasks = %u, .task = &order[%u]},        // [%s] every %s\n",
                       (unsigned)rate->every, (unsigned)rate->task.n, (unsigned)task, e->app->executor.at[x]->name->text,
                       app_time_text(e->arena, rate->period));
            task += rate->task.n;
        }
    buf_str(e->out, "};\n");
}

static void write_vitals(const Emitter *e, const AppExecutor *x)
{
    static const char *const names[APP_STATISTICS] = {".ticks", ".overruns", ".skipped", ".late", ".busy"};
    const char *before = "     .vitals = {";

    for (int i = 0; i < APP_STATISTICS; i++)
        if (x->statistic[i]) {
            buf_printf(e->out, "%s%s = %s", before, names[i], element_of(e, x->statistic[i]));
            before = ", ";
        }
    if (*before == ',')
        buf_str(e->out, "},\n");
}

static void write_executor(const Emitter *e, const AppExecutor *x, size_t number, size_t first_rate)
{
    buf_printf(e->out, "    {.name = \"%s\", .period = %lluu, .rate = &rates[%u], .rates = %u", x->name->text,
               (unsigned long long)x->period,
               (unsigned)first_rate, (unsigned)x->rate.n);
    if (x->priority)
        buf_printf(e->out, ", .priority = %u", (unsigned)x->priority);
    if (x->catch_up)
        buf_printf(e->out, ", .overrun = SM_CATCH_UP, .most = %u", (unsigned)x->most);
    buf_str(e->out, ",\n");
    write_vitals(e, x);
    if (e->app->time)
        buf_printf(e->out, "     .time = %s, .unit = %lluu,\n", element_of(e, e->app->time), (unsigned long long)e->app->unit);
    buf_printf(e->out, "     .sv = &%s_vector, .events = &events, .number = %u},\n", e->sv, (unsigned)number);
}

static void write_executors(const Emitter *e)
{
    size_t rate = 0;

    write_rates(e);
    buf_str(e->out, "\nstatic SmExecutor executors[] = {\n");
    for (size_t x = 0; x < e->app->executor.n; x++) {
        write_executor(e, e->app->executor.at[x], x, rate);
        rate += e->app->executor.at[x]->rate.n;
    }
    buf_str(e->out, "};\n\nstatic SmExecutor *const threads[] = {\n");
    for (size_t x = 0; x < e->app->executor.n; x++)
        buf_printf(e->out, "    &executors[%u],\n", (unsigned)x);
    buf_str(e->out, "};\n");
}

// ---- initial values ----

// Bits, so that a number is the same whatever `double` is.  The bits of an integer are its value.
static void c_write_value(const Emitter *e, const AppStart *s)
{
    const Element *x = s->element;

    buf_printf(e->out, "    sm_cell_store(SM_%s, &sv->%s, 0x%llxu);        // %s\n",
               x->type == SM_BOOL ? "BOOL" : sm_type_info[x->type].spelling,
               (const char *)map_find(&e->vector.names.element, x->name), (unsigned long long)s->cell,
               const_text(e->arena, sm_cell_to_f64(x->type, s->cell)));
}

static void write_start(const Emitter *e)
{
    if (e->app->start.n == 0)
        return;
    buf_printf(e->out,
               "\n// ---- the values of elements before the first step ----\n\n"
               "static void setValues(void *vector)\n{\n    %s *sv = (%s *)vector;\n\n",
               e->vector.names.sv_type, e->vector.names.sv_type);
    for (size_t i = 0; i < e->app->start.n; i++)
        c_write_value(e, &e->app->start.at[i]);
    buf_str(e->out, "}\n");
}

// ---- the application ----

static void write_app(const Emitter *e)
{
    buf_printf(e->out,
               "\n// ---- the application ----\n\nSmApp %s_app = {\n    .name = \"%s\", .sv = &%s_vector, .events = &events,\n"
               "    .executor = threads, .executors = %u,\n", e->prefix, e->app->name->text, e->sv, (unsigned)e->app->executor.n);
    if (e->app->start.n)
        buf_str(e->out, "    .set = setValues,\n");
    if (has_task(e, AST_TASK_keep))
        buf_str(e->out, "    .keep = &keeper,\n");
    if (has_task(e, AST_TASK_log))
        buf_str(e->out, "    .log = &flightLog,\n");
    if (has_task(e, AST_TASK_keep) || has_task(e, AST_TASK_log))
        buf_str(e->out, "    .writing = &sm_writing,\n");
    if (has_task(e, AST_TASK_inputs))
        buf_printf(e->out, "    .inputs = &%s_inputs,\n", e->io);
    if (has_task(e, AST_TASK_outputs))
        buf_printf(e->out, "    .outputs = &%s_outputs,\n", e->io);
    if (e->app->watchdog)
        buf_printf(e->out, "    .watchdog = %lluu,\n", (unsigned long long)e->app->watchdog);
    buf_str(e->out, "};\n\n#ifndef SM_NO_MAIN\nint main(void)\n{\n");
    buf_printf(e->out, "    return sm_app_main(&%s_app);\n}\n#endif\n", e->prefix);
}

static void write_code_includes(const Emitter *e)
{
    bool bytecode = false;

    buf_printf(e->out, "#include \"%s_app.h\"\n\n", e->app->name->text);
    if (e->app->io)
        buf_printf(e->out, "#include \"%s_io.h\"\n", e->app->io_name->text);
    for (size_t i = 0; i < e->app->machine.n; i++) {
        bytecode = bytecode || e->app->machine.at[i]->bytecode;
        if (!e->app->machine.at[i]->bytecode)
            buf_printf(e->out, "#include \"%s.h\"\n", e->app->machine.at[i]->program->name->text);
    }
    if (bytecode)
        buf_str(e->out, "#include \"bytecode-vm/target/machine.h\"\n");
    if (e->app->start.n)
        buf_str(e->out, "#include \"stdlib/convert.h\"\n");
}

void emit_c_app(Arena *arena, const App *app, const Buf *const *image, Buf *header, Buf *code)
{
    Emitter e;

    begin(&e, arena, app, header);
    write_header(&e);
    e.out = code;
    e.image = image;
    title(&e);
    write_code_includes(&e);
    buf_printf(code, "\nstatic SmEvent ring[%u];\nstatic SmEvents events = {.at = ring, .room = %u, .guarded = %s};\n",
               (unsigned)app->events,
               (unsigned)app->events, is_guarded(&e) ? "true" : "false");
    write_machines(&e);
    write_log(&e);
    write_keep(&e);
    write_tasks(&e);
    write_executors(&e);
    write_start(&e);
    write_app(&e);
}
