// SPDX-License-Identifier: Apache-2.0
// Sessions of libsmc: opening and closing, sources and options, and the guard around every call that compiles or runs something.
#include <string.h>

#include "compiler/base/utf8.h"
#include "compiler/library/library.h"
#include "compiler/library/library_locale.h"
#include "compiler/version.h"

#define LIBRARY_MAGIC UINT64_C(0x736d635f6f70656e)

#if defined(__GNUC__)
#define atomic_read(at) __atomic_load_n((at), __ATOMIC_ACQUIRE)
#define atomic_write(at, value) __atomic_store_n((at), (value), __ATOMIC_RELEASE)
#define atomic_swap(at, value) __atomic_exchange_n((at), (value), __ATOMIC_ACQ_REL)
#else         // no atomic accesses: how soon smc_cancel of another thread is seen depends on the compiler's volatile
#define atomic_read(at) (*(volatile int *)(at))
#define atomic_write(at, value) (*(volatile int *)(at) = (value))
static int atomic_swap(int *at, int value)
{
    const int was = atomic_read(at);

    atomic_write(at, value);
    return was;
}
#endif

// ---- results and versions ----

const char *smc_result_text(SmcResult result)
{
    static const struct { SmcResult result; const char *text; } row[] = {
        {SMC_OK, "ok"},
        {SMC_E_ARGUMENT, "an argument is NULL, or has none of the values that the function accepts"},
        {SMC_E_HANDLE, "no open session, or no open machine of this session"},
        {SMC_E_MEMORY, "out of memory"},
        {SMC_E_STATE, "the session has not compiled what the call needs"},
        {SMC_E_SOURCE, "the sources have errors"},
        {SMC_E_INDEX, "no item has this number or name"},
        {SMC_E_SIZE, "a size is not that of the value, or exceeds a limit"},
        {SMC_E_IMAGE, "not an image that this version can run"},
        {SMC_E_REFUSED, "refused: nothing has changed"},
        {SMC_E_FAILED, "the script did not pass"},
        {SMC_E_CANCELLED, "cancelled"},
        {SMC_E_BUSY, "another call of this session has not returned"},
        {SMC_E_INTERNAL, "smc has a bug; please report it"}};

    for (size_t i = 0; i < sizeof row / sizeof *row; i++)
        if (row[i].result == result)
            return row[i].text;
    return "unknown result";
}

uint32_t smc_api_version(void) { return SMC_API_VERSION; }
const char *smc_version(void) { return SMC_VERSION; }

// ---- errors and memory ----

bool library_is_open(const SmcSession *s) { return s && s->magic == LIBRARY_MAGIC; }

// Copies as many whole characters as fit into `room` bytes, and a NUL.  A byte that is not UTF-8 becomes '?'.
static void copy_utf8(char *to, size_t room, const char *from)
{
    size_t n = strlen(from), length;
    uint32_t code;

    for (; n > 0; from += length, n -= length) {
        const bool is_character = (length = utf8_decode(from, n, &code)) > 0;
        length = is_character ? length : 1;
        if (length >= room)
            break;
        memcpy(to, is_character ? from : "?", length);
        to += length;
        room -= length;
    }
    *to = '\0';
}

// Writes to the session although `s` is const: a call that only reads it can fail, too, and its error text is stored there.
SmcResult library_fail(const SmcSession *s, SmcResult r, const char *text)
{
    copy_utf8(((SmcSession *)(uintptr_t)s)->error, ERROR_TEXT_MAX, text ? text : smc_result_text(r));
    return r;
}

const char *smc_error_text(const SmcSession *s) { return library_is_open(s) ? s->error : ""; }
uint64_t smc_memory_used(const SmcSession *s) { return library_is_open(s) ? s->memory.used : 0; }
uint64_t smc_memory_peak(const SmcSession *s) { return library_is_open(s) ? s->memory.peak : 0; }

void *library_alloc(SmcSession *s, uint64_t size) { return library_memory_alloc(&s->memory, NULL, size ? size : 1); }

void library_release(SmcSession *s, void *memory)
{
    if (memory)
        library_memory_alloc(&s->memory, memory, 0);
}

// Returns a copy of `size` bytes and a NUL, which library_release frees.
char *library_copy(SmcSession *s, const void *bytes, uint64_t size)
{
    char *copy = size < UINT64_MAX ? library_alloc(s, size + 1) : NULL;

    if (!copy)
        return NULL;
    if (size)
        memcpy(copy, bytes, (size_t)size);
    copy[size] = '\0';
    return copy;
}

void *library_compiler_alloc(void *context, void *old, size_t size)
{
    SmcSession *s = context;

    if (size > 0 && s->is_guarded && library_is_cancelled(s))
        return NULL;
    return library_memory_alloc(&s->memory, old, size);
}

// ---- guarded calls ----

bool library_is_cancelled(void *session) { return atomic_read(&((SmcSession *)session)->is_cancelled) != 0; }

SmcResult smc_cancel(SmcSession *s, int32_t on)
{
    if (!library_is_open(s))
        return SMC_E_HANDLE;
    if (on != 0 && on != 1)
        return SMC_E_ARGUMENT;
    atomic_write(&s->is_cancelled, on);
    return SMC_OK;
}

// Makes the compiler usable again after a stage was left by longjmp.
static void recover(SmcSession *s)
{
    arena_free(&s->words_arena);
    arena_free(&s->of.next_shown_arena);
    if (s->has_layer)
        library_drop_layer(s);
    if (!s->of.is_compiled)
        library_drop_results(s);
}

// Begins a layer: s->compiler allocates in a new arena, for what one call computes from the results of smc_compile.  Between two calls of the
// compiler its trees, work and scratch are not needed, so the layer begins without them: what it frees at its end is its own.
void library_begin_layer(SmcSession *s)
{
    Session *c = &s->compiler;

    arena_free(&c->tree);
    arena_free(&c->work);
    arena_free(&c->scratch);
    c->built = NULL;                              // a layer that needs the IR builds its own: its passes change it in place
    s->below = *c;
    s->has_layer = true;
    arena_init(&c->arena, library_compiler_alloc, s, &s->oom);
    c->strings.slot = arena_copy(&c->arena, c->strings.slot, c->strings.cap * sizeof *c->strings.slot);
    diags_clear(&c->diags);
}

static void end_layer(SmcSession *s)
{
    arena_free(&s->compiler.tree);
    arena_free(&s->compiler.work);
    arena_free(&s->compiler.scratch);
    s->compiler = s->below;
    s->has_layer = false;
}

void library_keep_layer(SmcSession *s, Arena *in)
{
    const Arena layer = s->compiler.arena;

    arena_free(in);
    *in = layer;
    end_layer(s);
}

void library_drop_layer(SmcSession *s)
{
    arena_free(&s->compiler.arena);
    end_layer(s);
}

// Returns why a stage was left by longjmp.
static SmcResult report_exit(SmcSession *s, bool can_cancel)
{
    if (s->has_compiler && s->compiler.bug)
        return library_fail(s, SMC_E_INTERNAL, s->compiler.bug);
    return library_fail(s, can_cancel && library_is_cancelled(s) ? SMC_E_CANCELLED : SMC_E_MEMORY, NULL);
}

static SmcResult run_guarded(SmcSession *s, LibraryWork *work, void *argument, bool can_cancel)
{
    void *own_locale;
    SmcResult r;

    if (atomic_swap(&s->is_busy, 1))
        return SMC_E_BUSY;
    own_locale = library_locale_enter(s->locale);
    s->is_guarded = can_cancel;
    if (setjmp(s->oom) != 0) {
        r = report_exit(s, can_cancel);
        recover(s);
    } else if (can_cancel && library_is_cancelled(s)) {
        r = library_fail(s, SMC_E_CANCELLED, NULL);
    } else {
        r = work(s, argument);
    }
    s->is_guarded = false;
    library_locale_leave(own_locale);
    if (r == SMC_E_CANCELLED)
        atomic_write(&s->is_cancelled, 0);
    atomic_write(&s->is_busy, 0);
    return r;
}

SmcResult library_guard(SmcSession *s, LibraryWork *work, void *argument) { return run_guarded(s, work, argument, true); }

// Returns an array of pointers or structures with room for one more item: `old`, or a copy of its n items in an array twice as large, which
// replaces it.  NULL: out of memory.
void *library_grow(SmcSession *s, void *old, uint32_t n, uint32_t *cap, size_t item)
{
    const uint64_t room = *cap ? UINT64_C(2) * *cap : 8;
    void *more;

    if (n < *cap)
        return old;
    if (room > UINT32_MAX || (more = library_alloc(s, room * item)) == NULL)
        return NULL;
    if (n)
        memcpy(more, old, n * item);
    library_release(s, old);
    *cap = (uint32_t)room;
    return more;
}

// ---- opening and closing ----

SmcResult smc_open(void *memory, uint64_t size, SmcSession **s)
{
    LibraryMemory m;
    SmcSession *new;

    if (!s)
        return SMC_E_ARGUMENT;
    library_memory_init(&m, memory, size);
    if ((new = library_memory_alloc(&m, NULL, sizeof *new)) == NULL)
        return SMC_E_MEMORY;
    memset(new, 0, sizeof *new);
    if ((new->locale = library_locale_new()) == NULL) {
        library_memory_alloc(&m, new, 0);
        return SMC_E_MEMORY;
    }
    new->memory = m;
    new->magic = LIBRARY_MAGIC;
    arena_init(&new->words_arena, library_compiler_alloc, new, &new->oom);
    new->option[SMC_OPTION_LEVEL] = 2;
    new->option[SMC_OPTION_WARNINGS] = 1;
    *s = new;
    return SMC_OK;
}

static void free_sources(SmcSession *s)
{
    for (uint32_t i = 0; i < s->sources; i++) {
        library_release(s, s->source[i].name);
        library_release(s, s->source[i].text);
    }
    library_release(s, s->source);
    s->source = NULL;
    s->sources = s->sources_cap = s->free_source = 0;
}

static void free_words(SmcSession *s)
{
    for (uint32_t i = 0; i < s->words; i++)
        library_release(s, s->word[i]);
    library_release(s, s->word);
    s->word = NULL;
    s->words = s->words_cap = 0;
}

SmcResult smc_close(SmcSession *s)
{
    LibraryMemory m;

    if (!library_is_open(s))
        return SMC_E_HANDLE;
    if (atomic_swap(&s->is_busy, 1))
        return SMC_E_BUSY;
    library_drop_results(s);
    library_close_machines(s);
    library_release(s, s->swap);
    free_sources(s);
    free_words(s);
    library_release(s, s->prefix);
    library_locale_free(s->locale);
    s->magic = 0;
    m = s->memory;
    library_memory_alloc(&m, s, 0);
    return SMC_OK;
}

// ---- sources ----

// Whether messages and comments of emitted C can contain the name.
static bool is_valid_name(const char *name)
{
    for (const char *at = name; *at; at++)
        if ((unsigned char)*at < ' ' || *at == 0x7f)
            return false;
    return *name != '\0';
}

static SmcResult check_text(const SmcSession *s, const char *text, uint64_t size)
{
    if (!text && size > 0)
        return library_fail(s, SMC_E_ARGUMENT, NULL);
    if (size > SOURCE_MAX)
        return library_fail(s, SMC_E_SIZE, "a source can have at most 1 GB");
    return SMC_OK;
}

// Returns a free number for a source.  s->source has room for a new one.
static uint32_t take_number(SmcSession *s)
{
    uint32_t number;

    if (!s->free_source)
        return s->sources++;
    number = s->free_source - 1;
    s->free_source = s->source[number].next_free;
    return number;
}

SmcResult smc_source_add(SmcSession *s, int32_t kind, const char *name, const char *text, uint64_t size, uint32_t *source)
{
    LibrarySource new, *more;
    SmcResult r;

    if (!library_is_open(s))
        return SMC_E_HANDLE;
    if (!name || !source || kind < SMC_KIND_SV || kind > SMC_KIND_DATA)
        return library_fail(s, SMC_E_ARGUMENT, NULL);
    if (!is_valid_name(name))
        return library_fail(s, SMC_E_ARGUMENT, "the name of a source cannot be empty or contain a control character");
    if ((r = check_text(s, text, size)) != SMC_OK)
        return r;
    if ((more = library_grow(s, s->source, s->sources, &s->sources_cap, sizeof *more)) == NULL)
        return library_fail(s, SMC_E_MEMORY, NULL);
    s->source = more;
    new.next_free = new.machine = 0;
    new.kind = kind;
    new.size = (size_t)size;
    new.name = library_copy(s, name, strlen(name));
    new.text = library_copy(s, text, size);
    if (!new.name || !new.text) {
        library_release(s, new.name);
        library_release(s, new.text);
        return library_fail(s, SMC_E_MEMORY, NULL);
    }
    *source = take_number(s);
    s->source[*source] = new;
    return SMC_OK;
}

// Whether a source has this number.
static bool has_source(const SmcSession *s, uint32_t source) { return source < s->sources && s->source[source].kind != KIND_REMOVED; }

SmcResult smc_source_remove(SmcSession *s, uint32_t source)
{
    LibrarySource *own;

    if (!library_is_open(s))
        return SMC_E_HANDLE;
    if (!has_source(s, source))
        return library_fail(s, SMC_E_INDEX, NULL);
    own = &s->source[source];
    library_release(s, own->name);
    library_release(s, own->text);
    *own = (LibrarySource){KIND_REMOVED, NULL, NULL, 0, s->free_source, 0};
    s->free_source = source + 1;
    for (uint32_t i = 0; i < s->sources; i++)
        if (s->source[i].machine == source + 1)
            s->source[i].machine = 0;
    return SMC_OK;
}

SmcResult smc_script_assign(SmcSession *s, uint32_t script, uint32_t machine)
{
    if (!library_is_open(s))
        return SMC_E_HANDLE;
    if (!has_source(s, script) || !has_source(s, machine))
        return library_fail(s, SMC_E_INDEX, NULL);
    if (s->source[script].kind != SMC_KIND_SS || s->source[machine].kind != SMC_KIND_SM)
        return library_fail(s, SMC_E_ARGUMENT, "only a script can be assigned, and only to a machine");
    s->source[script].machine = machine + 1;
    return SMC_OK;
}

SmcResult smc_source_replace(SmcSession *s, uint32_t source, const char *text, uint64_t size)
{
    char *copy;
    SmcResult r;

    if (!library_is_open(s))
        return SMC_E_HANDLE;
    if (!has_source(s, source))
        return library_fail(s, SMC_E_INDEX, NULL);
    if ((r = check_text(s, text, size)) != SMC_OK)
        return r;
    if ((copy = library_copy(s, text, size)) == NULL)
        return library_fail(s, SMC_E_MEMORY, NULL);
    library_release(s, s->source[source].text);
    s->source[source].text = copy;
    s->source[source].size = (size_t)size;
    return SMC_OK;
}

SmcResult smc_sources_clear(SmcSession *s)
{
    if (!library_is_open(s))
        return SMC_E_HANDLE;
    library_drop_results(s);
    free_sources(s);
    return SMC_OK;
}

uint32_t smc_source_count(const SmcSession *s) { return library_is_open(s) ? s->sources : 0; }

const char *smc_source_name(const SmcSession *s, uint32_t source)
{
    return library_is_open(s) && has_source(s, source) ? s->source[source].name : "";
}

int32_t smc_source_kind(const SmcSession *s, uint32_t source)
{
    return library_is_open(s) && has_source(s, source) ? s->source[source].kind : -1;
}

// ---- options ----

SmcResult smc_option_set(SmcSession *s, int32_t option, uint64_t value)
{
    static const uint64_t most[OPTION_COUNT] = {2, UINT64_MAX, UINT32_MAX, UINT32_MAX, UINT32_MAX, 1, 1, 1, 1, 1, 1, 1};      // by option

    if (!library_is_open(s))
        return SMC_E_HANDLE;
    if (option < 0 || option >= OPTION_COUNT || value > most[option])
        return library_fail(s, SMC_E_ARGUMENT, NULL);
    s->option[option] = value;
    return SMC_OK;
}

uint64_t smc_option(const SmcSession *s, int32_t option)
{
    return library_is_open(s) && option >= 0 && option < OPTION_COUNT ? s->option[option] : 0;
}

SmcResult smc_prefix_set(SmcSession *s, const char *prefix)
{
    char *copy = NULL;

    if (!library_is_open(s))
        return SMC_E_HANDLE;
    if (!prefix)
        return library_fail(s, SMC_E_ARGUMENT, NULL);
    if (*prefix && emit_c_prefix_error(prefix))
        return library_fail(s, SMC_E_ARGUMENT, emit_c_prefix_error(prefix));
    if (*prefix && (copy = library_copy(s, prefix, strlen(prefix))) == NULL)
        return library_fail(s, SMC_E_MEMORY, NULL);
    library_release(s, s->prefix);
    s->prefix = copy;
    return SMC_OK;
}

// Checks a word by itself.
static SmcResult check_word(SmcSession *s, void *word)
{
    const char *one = word, *wrong;
    const DiagSelection only = {&one, 1, false};
    SmcResult r;

    wrong = diag_selection_error(&s->words_arena, &only);
    r = wrong ? library_fail(s, SMC_E_ARGUMENT, wrong) : SMC_OK;
    arena_free(&s->words_arena);
    return r;
}

SmcResult smc_warning_select(SmcSession *s, const char *word)
{
    char *copy, **more;
    SmcResult r;

    if (!library_is_open(s))
        return SMC_E_HANDLE;
    if (!word)
        return library_fail(s, SMC_E_ARGUMENT, NULL);
    if ((r = run_guarded(s, check_word, (void *)(uintptr_t)word, false)) != SMC_OK)
        return r;
    if ((more = library_grow(s, s->word, s->words, &s->words_cap, sizeof *more)) == NULL)
        return library_fail(s, SMC_E_MEMORY, NULL);
    s->word = more;
    if ((copy = library_copy(s, word, strlen(word))) == NULL)
        return library_fail(s, SMC_E_MEMORY, NULL);
    s->word[s->words++] = copy;
    return SMC_OK;
}

SmcResult smc_warnings_reset(SmcSession *s)
{
    if (!library_is_open(s))
        return SMC_E_HANDLE;
    free_words(s);
    return SMC_OK;
}

// ---- tables ----

uint32_t smc_warning_count(void) { return (uint32_t)diag_flag_count; }
const char *smc_warning_name(uint32_t warning) { return warning < diag_flag_count ? diag_flag[warning].name : ""; }
const char *smc_warning_group(uint32_t warning) { return warning < diag_flag_count ? diag_group_name[diag_flag[warning].group] : ""; }
const char *smc_warning_sentence(uint32_t warning) { return warning < diag_flag_count ? diag_flag[warning].sentence : ""; }

const char *smc_explain(const char *code)
{
    const DiagInfo *row = code ? diag_find(code) : NULL;

    return row && row->page ? row->page : "";
}
