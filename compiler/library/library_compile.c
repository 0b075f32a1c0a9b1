// SPDX-License-Identifier: Apache-2.0
// Compiles the sources of a session, and generates output files.
#include <stdlib.h>
#include <string.h>

#include "compiler/base/path.h"
#include "compiler/data/data_file.h"
#include "compiler/library/library.h"

// ---- results ----

// Returns what was compiled from a source, or NULL if it is not an input, was not compiled, or there is no such source.
CompiledSource *library_compiled(const SmcSession *s, uint32_t source)
{
    const LibraryResults *of = &s->of;

    return of->is_compiled && source < of->sources && of->input[source] ? &of->made.of[of->input[source] - 1] : NULL;
}

// Returns the number of the only machine; UINT32_MAX if there is not exactly one.
uint32_t library_only_machine(const SmcSession *s)
{
    uint32_t found = UINT32_MAX, n = 0;

    for (uint32_t i = 0; s->of.is_compiled && i < s->of.sources; i++)
        if (s->of.input[i] && s->of.in.at[s->of.input[i] - 1].kind == FILE_SM) {
            found = i;
            n++;
        }
    return n == 1 ? found : UINT32_MAX;
}

const char *library_base_name(const char *path)
{
    const char *slash = strrchr(path, '/');

    return slash ? slash + 1 : path;
}

static void free_bench(LibraryBench *b)
{
    for (int i = 0; i < ENGINE_COUNT; i++) {
        if (b->engine[i])
            b->engine[i]->close(b->engine[i]);
        arena_free(&b->engine_arena[i]);
    }
    arena_free(&b->review_arena);
}

// Frees what has a separate arena, except for benches.
static void free_arenas(LibraryResults *of)
{
    for (int i = 0; i < PAGE_COUNT; i++)
        arena_free(&of->page[i]);
    for (uint32_t i = 0; of->run && i < of->sources; i++)
        arena_free(&of->run[i].arena);
    arena_free(&of->output_arena);
    arena_free(&of->shown_arena);
    arena_free(&of->next_shown_arena);
}

// Frees everything that belongs to the last compilation: open engines, memory of the results, images.
void library_drop_results(SmcSession *s)
{
    for (uint32_t i = 0; s->of.bench && i < s->of.sources; i++)
        free_bench(&s->of.bench[i]);
    free_arenas(&s->of);
    for (uint32_t i = 0; s->of.image && i < s->of.sources; i++)
        library_release(s, s->of.image[i].bytes);
    if (s->has_compiler)
        session_free(&s->compiler);
    s->has_compiler = false;
    memset(&s->of, 0, sizeof s->of);
}

// ---- the diagnostics that are shown ----

// Adds copies of diagnostics to the list that is shown, selected by the warnings.  Reports and diagrams use the originals.
static void add_shown_diags(SmcSession *s, const Diags *from, Diags *shown)
{
    Arena *arena = shown->arena;
    Diags one = *from;

    one.arena = arena;
    one.list.at = arena_copy(arena, from->list.at, from->list.n * sizeof *from->list.at);
    one.list.cap = one.list.n;
    for (uint32_t i = 0; i < one.list.n; i++)
        one.list.at[i] = arena_copy(arena, from->list.at[i], sizeof *from->list.at[i]);
    diags_select(&one, &s->of.selection);
    diags_fold(&one);
    for (uint32_t i = 0; i < one.list.n; i++)
        vec_push(arena, &shown->list, one.list.at[i]);
    for (uint32_t i = 0; i < one.folded.n; i++)
        vec_push(arena, &shown->folded, one.folded.at[i]);
    for (uint32_t i = 0; i < one.allowed.n; i++)
        vec_push(arena, &shown->allowed, one.allowed.at[i]);
    shown->errors += one.errors;
    shown->warnings += one.warnings;
}

// Rebuilds of.shown from the diagnostics of smc_compile, of the last smc_emit, and of all runs: those of `script` are in *run if that is not
// NULL.
void library_update_shown(SmcSession *s, const Diags *emitted, uint32_t script, const Diags *run)
{
    const Diags *compiled = s->has_layer ? &s->below.diags : &s->compiler.diags;
    Arena *arena = &s->of.next_shown_arena;
    Diags shown;

    arena_init(arena, library_compiler_alloc, s, &s->oom);
    diags_init(&shown, arena);
    shown.files = compiled->files;
    add_shown_diags(s, compiled, &shown);
    add_shown_diags(s, emitted, &shown);
    for (uint32_t i = 0; i < s->of.sources; i++)
        if (run && i == script)
            add_shown_diags(s, run, &shown);
        else if (s->of.run[i].is_done)
            add_shown_diags(s, &s->of.run[i].run.diags, &shown);
    arena_free(&s->of.shown_arena);
    s->of.shown_arena = *arena;
    memset(arena, 0, sizeof *arena);
    shown.arena = &s->of.shown_arena;
    s->of.shown = shown;
}

// ---- sources to inputs ----

typedef struct KindCount { uint32_t of[SMC_KIND_DATA + 1], all; } KindCount;

// Counts the session's sources by kind and in all, without the removed ones.
static KindCount count_kinds(const SmcSession *s)
{
    KindCount n = {{0}, 0};

    for (uint32_t i = 0; i < s->sources; i++)
        if (s->source[i].kind != KIND_REMOVED) {
            n.of[s->source[i].kind]++;
            n.all++;
        }
    return n;
}

// Returns why the sources do not fit together; NULL: they do.
static const char *find_misfit(const SmcSession *s)
{
    const KindCount n = count_kinds(s);
    const bool is_shared = n.of[SMC_KIND_SM] + n.of[SMC_KIND_IO] + n.of[SMC_KIND_NET] > 0;

    if (n.all == 0)
        return "there is no source to compile";
    if (n.of[SMC_KIND_APP] > 1)
        return "there are two applications; compile each in a session of its own";
    if (n.of[SMC_KIND_APP] == 1)
        return NULL;
    if (is_shared && n.of[SMC_KIND_SV] > 1)
        return "there are two state vectors; machines, pins and messages have one";
    if (n.of[SMC_KIND_IO] > 1)
        return "there are two .io files; an image has one";
    return NULL;
}

static FileKind kind_of(int32_t source)
{
    static const FileKind kind[] = {FILE_SV, FILE_SM, FILE_SS, FILE_IO, FILE_APP, FILE_NET, FILE_RQ, FILE_KINDS};      // by SMC_KIND_…

    return kind[source];
}

// The files that the application names are sources of these names.
static void supply_app_files(SmcSession *s, const Source *app)
{
    CompileApp *a = ARENA_NEW(&s->compiler.arena, CompileApp);

    s->of.in.app = a;
    compile_open_app(&s->compiler, app, a);
    for (size_t f = 0; f < a->files.n; f++) {
        AppFile *file = &a->files.at[f];
        file->problem = "the session has no source of this name";
        for (uint32_t i = 0; i < s->sources && !file->wrong_kind; i++)
            if (s->of.text[i] && kind_of(s->source[i].kind) == file->kind && strcmp(s->source[i].name, file->name.text->text) == 0)
                file->src = s->of.text[i];
    }
}

// Finds the source that a script includes by its name, relative to the folder in the name of the script.
static const Source *find_included(void *context, const Source *from, const char *name, const char **problem)
{
    SmcSession *s = context;
    Arena *arena = &s->compiler.arena;
    const char *path = path_simplify(arena, path_beside(arena, from->name, name));

    *problem = format_in(arena, "the session has no source '%s'", path);
    for (uint32_t i = 0; i < s->of.sources; i++)
        if (s->of.text[i] && s->source[i].kind == SMC_KIND_SS && strcmp(path_simplify(arena, s->of.text[i]->name), path) == 0)
            return s->of.text[i];
    return NULL;
}

// Finds the source with recorded data that a script names.
static const DataFile *find_data(void *context, const Source *from, const char *name, const char **problem)
{
    SmcSession *s = context;
    Arena *arena = &s->compiler.arena;
    const char *path = path_simplify(arena, path_beside(arena, from->name, name));

    *problem = format_in(arena, "the session has no source '%s' with data", path);
    for (uint32_t i = 0; i < s->of.sources; i++)
        if (s->of.text[i] && s->source[i].kind == SMC_KIND_DATA && strcmp(path_simplify(arena, s->of.text[i]->name), path) == 0) {
            DataMemory *m = ARENA_NEW(arena, DataMemory);
            data_memory_init(m, s->of.text[i]->name, s->of.text[i]->text, s->of.text[i]->len);
            return &m->file;
        }
    return NULL;
}

static const Source *copy_source(Arena *arena, const LibrarySource *source, uint32_t number)
{
    char *text = arena_copy(arena, source->text, source->size + 1);
    Source *copy = source_new(arena, arena_copy(arena, source->name, strlen(source->name) + 1), text, source->size);

    copy->number = number;
    return copy;
}

// Records the machine of each script: the one that it was assigned to, or the only one.
static void assign_scripts(SmcSession *s, bool has_one_machine)
{
    LibraryResults *of = &s->of;
    uint32_t only = UINT32_MAX;

    for (uint32_t m = 0; has_one_machine && m < s->sources; m++)
        if (s->source[m].kind == SMC_KIND_SM)
            only = m;
    for (uint32_t i = 0; i < s->sources; i++) {
        of->machine[i] = s->source[i].machine - 1;            // UINT32_MAX: not assigned
        if (of->machine[i] == UINT32_MAX)
            of->machine[i] = only;
        if (of->input[i] && s->source[i].machine > 0)
            of->in.at[of->input[i] - 1].machine = of->input[s->source[i].machine - 1];
    }
}

// Copies the session's sources as the inputs of the next compilation.
static void list_inputs(SmcSession *s)
{
    const KindCount n = count_kinds(s);
    const bool has_app = n.of[SMC_KIND_APP] > 0, vector_is_shared = n.of[SMC_KIND_SM] + n.of[SMC_KIND_IO] + n.of[SMC_KIND_NET] > 0;
    LibraryResults *of = &s->of;
    Arena *arena = &s->compiler.arena;

    of->sources = s->sources;
    of->text = ARENA_ARRAY(arena, const Source *, s->sources);
    of->input = ARENA_ARRAY(arena, uint32_t, s->sources);
    of->run = ARENA_ARRAY(arena, LibraryRun, s->sources);
    of->image = ARENA_ARRAY(arena, LibraryImage, s->sources);
    of->bench = ARENA_ARRAY(arena, LibraryBench, s->sources);
    of->machine = ARENA_ARRAY(arena, uint32_t, s->sources);
    of->in.at = ARENA_ARRAY(arena, CompileSource, s->sources);
    for (uint32_t i = 0; i < s->sources; i++) {
        const LibrarySource *source = &s->source[i];
        if (source->kind == KIND_REMOVED)
            continue;
        of->text[i] = copy_source(arena, source, i);
        if (source->kind == SMC_KIND_DATA)
            continue;
        if (has_app ? source->kind != SMC_KIND_APP : source->kind == SMC_KIND_SV && vector_is_shared) {
            if (!has_app)
                of->in.vector = of->text[i];
            continue;
        }
        of->input[i] = (uint32_t)of->in.n + 1;
        of->in.at[of->in.n++] = (CompileSource){.text = of->text[i], .kind = kind_of(source->kind)};
    }
    if (has_app)
        supply_app_files(s, of->in.at[0].text);
    assign_scripts(s, n.of[SMC_KIND_SM] == 1);
}

// ---- compiling ----

static void set_options(SmcSession *s, CompileOptions *o, CompileEmit emit)
{
    memset(o, 0, sizeof *o);
    o->emit = emit;
    o->opt_level = (int)s->option[SMC_OPTION_LEVEL];
    o->warnings = s->option[SMC_OPTION_REVIEW] ? NULL : &s->of.selection;
    o->step = s->option[SMC_OPTION_STEP];
    o->limits.ram = (uint32_t)s->option[SMC_OPTION_MAX_RAM];
    o->limits.step = (uint32_t)s->option[SMC_OPTION_MAX_STEP];
    o->limits.cycles = (uint32_t)s->option[SMC_OPTION_MAX_CYCLES];
    o->names = s->option[SMC_OPTION_NAMES] != 0 || s->of.in.app;      // a log requires the names of an application
    o->soft = s->option[SMC_OPTION_SOFT] != 0;
}

// Copies the words that select warnings, so that they last as long as the results of this compilation.
static void copy_selection(SmcSession *s)
{
    DiagSelection *of = &s->of.selection;

    of->word = ARENA_ARRAY(&s->compiler.arena, const char *, s->words);
    of->n = s->words;
    of->none = s->option[SMC_OPTION_WARNINGS] == 0;
    for (uint32_t i = 0; i < s->words; i++)
        of->word[i] = arena_copy(&s->compiler.arena, s->word[i], strlen(s->word[i]) + 1);
}

static SmcResult compile(SmcSession *s, void *unused)
{
    const char *misfit = find_misfit(s);

    (void)unused;
    library_drop_results(s);
    if (misfit)
        return library_fail(s, SMC_E_STATE, misfit);
    session_init(&s->compiler, library_compiler_alloc, s, &s->oom);
    s->compiler.finder = (SourceFinder){find_included, find_data, s};
    s->has_compiler = true;
    list_inputs(s);
    copy_selection(s);
    set_options(s, &s->of.o, EMIT_NOTHING);
    compile_sources(&s->compiler, &s->of.in, &s->of.o, &s->of.made);
    library_build_models(s);
    diags_init(&s->of.emitted, NULL);
    library_update_shown(s, &s->of.emitted, 0, NULL);
    s->of.errors = s->of.shown.errors;
    s->of.is_compiled = true;
    return s->of.errors ? library_fail(s, SMC_E_SOURCE, NULL) : SMC_OK;
}

SmcResult smc_compile(SmcSession *s) { return library_is_open(s) ? library_guard(s, compile, NULL) : SMC_E_HANDLE; }

// ---- the files of an application ----

static const AppFile *app_file(const SmcSession *s, uint32_t file)
{
    const CompileApp *app = library_is_open(s) && s->of.is_compiled ? s->of.in.app : NULL;

    return app && file < app->files.n ? &app->files.at[file] : NULL;
}

// Returns how many files the compiled application names.
uint32_t smc_app_file_count(const SmcSession *s)
{
    return library_is_open(s) && s->of.is_compiled && s->of.in.app ? (uint32_t)s->of.in.app->files.n : 0;
}

const char *smc_app_file_name(const SmcSession *s, uint32_t file)
{
    const AppFile *f = app_file(s, file);

    return f ? f->name.text->text : "";
}

int32_t smc_app_file_kind(const SmcSession *s, uint32_t file)
{
    const AppFile *f = app_file(s, file);

    for (int32_t kind = SMC_KIND_SV; f && kind <= SMC_KIND_RQ; kind++)
        if (kind_of(kind) == f->kind)
            return kind;
    return -1;
}

// ---- output files ----

// Returns the source's file name without folders and without the part from the last dot on.
static const char *stem_of(SmcSession *s, const Source *src)
{
    const char *name = library_base_name(src->name), *dot = strrchr(name, '.');

    return format_in(&s->compiler.arena, "%.*s", (int)(dot && dot != name ? (size_t)(dot - name) : strlen(name)), name);
}

static void set_c_options(SmcSession *s, CompileSource *in, CompileEmit emit)
{
    memset(&in->c, 0, sizeof in->c);
    in->c.prefix = s->prefix;
    in->c.header = format_in(&s->compiler.arena, "%s%s", stem_of(s, in->text),
                             emit == EMIT_ARRAY ? "_image.h" : in->kind == FILE_IO ? "_io.h" : in->kind == FILE_NET ? "_net.h" : ".h");
    in->c.source = library_base_name(in->text->name);
    in->c.track_stores = s->option[SMC_OPTION_TRACK] != 0;
    in->c.soft = s->option[SMC_OPTION_SOFT] != 0;
    in->c.runtime = s->option[SMC_OPTION_RUNTIME] != 0;
}

// Returns the pin map of the first source that has one, or NULL.
static const IoMap *first_pins(const LibraryResults *of)
{
    for (size_t i = 0; i < of->in.n; i++)
        if (of->made.of[i].pins)
            return of->made.of[i].pins;
    return NULL;
}

// Returns the reason why this output cannot be generated from these sources; NULL: it can.
static const char *reason_against_output(const SmcSession *s, CompileEmit emit)
{
    const LibraryResults *of = &s->of;
    uint32_t machines = 0, units = 0;

    for (size_t i = 0; i < of->in.n; i++) {
        machines += of->in.at[i].kind == FILE_SM;
        units += of->in.at[i].kind != FILE_SS;
    }
    if (of->in.app && (emit == EMIT_C || emit == EMIT_AST || emit == EMIT_TOKENS))
        return s->prefix && emit == EMIT_C ? "the C of an application has no prefix" : NULL;
    if (of->in.app)
        return "an application becomes C, which contains its images";
    if (machines == 0 && (emit == EMIT_BYTECODE || emit == EMIT_ARRAY || emit == EMIT_IR))
        return "there is no machine";
    if (emit == EMIT_C && units > 1 && s->prefix)
        return "a prefix is for the C of one source";
    return NULL;
}

// Returns the file name of an output: the name that the compiler has given it, or the source's stem with a suffix.
static const char *output_name(SmcSession *s, const Artefact *a, CompileEmit emit)
{
    static const char *const dump[] = {"", "", "", "", ".ir", ".ast", ".tokens"};       // by CompileEmit

    if (a->name)
        return a->name;
    return format_in(&s->compiler.arena, "%s%s", stem_of(s, s->of.in.at[a->source].text), a->suffix ? a->suffix : dump[emit]);
}

typedef struct LibraryOutputs {
    LibraryOutput *at;
    uint32_t n;
} LibraryOutputs;

static int compare_outputs(const void *a, const void *b)
{
    return strcmp(((const LibraryOutput *)a)->name, ((const LibraryOutput *)b)->name);
}

// Whether two outputs have the same name, as those of two sources with one file name in different folders.
static bool has_duplicate_output(SmcSession *s, const LibraryOutputs *out)
{
    LibraryOutput *sorted = arena_copy(&s->compiler.arena, out->at, out->n * sizeof *out->at);

    qsort(sorted, out->n, sizeof *sorted, compare_outputs);
    for (uint32_t i = 1; i < out->n; i++)
        if (strcmp(sorted[i - 1].name, sorted[i].name) == 0)
            return true;
    return false;
}

static LibraryOutputs list_outputs(SmcSession *s, const Compiled *made, CompileEmit emit)
{
    LibraryOutputs out = {arena_array(&s->compiler.arena, made->artefact.n + 3u, sizeof *out.at), made->artefact.n};
    Buf soft[3];
    static const char *const soft_name[] = {"sm_soft.h", "sm_soft.c", "sm_soft_avr.S"};

    for (uint32_t i = 0; i < made->artefact.n; i++) {
        out.at[i].name = output_name(s, &made->artefact.at[i], emit);
        out.at[i].bytes = made->artefact.at[i].bytes;
    }
    if (emit != EMIT_C || s->of.in.app || !s->option[SMC_OPTION_SOFT] || s->option[SMC_OPTION_RUNTIME])
        return out;
    for (int i = 0; i < 3; i++)
        buf_init(&soft[i], &s->compiler.arena);
    emit_c_soft_library(&soft[0], &soft[1], &soft[2]);
    for (int i = 0; i < 3; i++) {
        out.at[out.n].name = soft_name[i];
        out.at[out.n++].bytes = arena_copy(&s->compiler.arena, &soft[i], sizeof soft[i]);
    }
    return out;
}

static SmcResult emit_outputs(SmcSession *s, void *argument)
{
    static const CompileEmit emit_of[] = {EMIT_NOTHING, EMIT_BYTECODE, EMIT_ARRAY, EMIT_C, EMIT_IR, EMIT_AST, EMIT_TOKENS};     // by SMC_EMIT_…
    const CompileEmit emit = emit_of[*(int32_t *)argument];
    const bool is_dump = emit == EMIT_AST || emit == EMIT_TOKENS;
    LibraryResults *of = &s->of;
    const char *missing;
    CompileOptions o;
    Compiled made = of->made;
    CompileInput in = of->in;
    LibraryOutputs out = {NULL, 0};
    Diags diags;
    SmcResult r;

    if (!is_dump && of->errors)
        return library_fail(s, SMC_E_STATE, "the sources have errors");
    if ((missing = reason_against_output(s, emit)) != NULL)
        return library_fail(s, SMC_E_STATE, missing);
    if (in.n == 0)                                            // as for recorded data or messages alone
        return library_fail(s, SMC_E_STATE, "there is no source of which anything is emitted");
    library_begin_layer(s);
    in.at = arena_copy(&s->compiler.arena, in.at, in.n * sizeof *in.at);
    for (size_t i = 0; i < in.n; i++)
        set_c_options(s, &in.at[i], emit);
    in.at[0].array = stem_of(s, in.at[0].text);
    set_options(s, &o, emit);
    made.image_pins = (IoMap *)(uintptr_t)first_pins(of);
    made.of = arena_copy(&s->compiler.arena, of->made.of, of->in.n * sizeof *made.of);
    r = compile_emit(&s->compiler, &in, &o, &made) ? SMC_OK : SMC_E_SOURCE;
    diags = s->compiler.diags;
    if (r == SMC_OK) {
        out = list_outputs(s, &made, emit);
        r = has_duplicate_output(s, &out) ? SMC_E_STATE : SMC_OK;
    }
    library_update_shown(s, &diags, 0, NULL);                 // the last call that can run out of memory: from here on results are stored
    library_keep_layer(s, &of->output_arena);
    of->emitted = diags;
    of->output = out.at;
    of->outputs = r == SMC_OK ? out.n : 0;
    return r == SMC_OK ? SMC_OK : library_fail(s, r, r == SMC_E_STATE ? "two sources have the same file name, so their outputs would, too" : NULL);
}

SmcResult smc_emit(SmcSession *s, int32_t what)
{
    SmcResult r;

    if (!library_is_open(s))
        return SMC_E_HANDLE;
    if (what < SMC_EMIT_IMAGE || what > SMC_EMIT_TOKENS)
        return library_fail(s, SMC_E_ARGUMENT, NULL);
    if (!s->of.is_compiled)
        return library_fail(s, SMC_E_STATE, NULL);
    r = library_guard(s, emit_outputs, &what);
    if (r == SMC_E_STATE)
        s->of.outputs = 0;
    return r;
}

uint32_t smc_output_count(const SmcSession *s) { return library_is_open(s) ? s->of.outputs : 0; }

const char *smc_output_name(const SmcSession *s, uint32_t output)
{
    return library_is_open(s) && output < s->of.outputs ? s->of.output[output].name : "";
}

SmcResult smc_output(const SmcSession *s, uint32_t output, const void **bytes, uint64_t *size)
{
    if (!library_is_open(s))
        return SMC_E_HANDLE;
    if (!bytes || !size)
        return library_fail(s, SMC_E_ARGUMENT, NULL);
    if (output >= s->of.outputs)
        return library_fail(s, SMC_E_INDEX, NULL);
    *bytes = buf_text(s->of.output[output].bytes);
    *size = s->of.output[output].bytes->n;
    return SMC_OK;
}
