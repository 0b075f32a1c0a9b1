// SPDX-License-Identifier: Apache-2.0
// The state of a session of libsmc (smc.h), and what its files share.
#ifndef SMC_LIBRARY_H
#define SMC_LIBRARY_H

#include "bytecode-vm/smvm.h"
#include "compiler/compile.h"
#include "compiler/library/smc.h"
#include "compiler/review.h"

enum { OPTION_COUNT = SMC_OPTION_TRACE + 1, ENGINE_COUNT = 3, ERROR_TEXT_MAX = 400, KIND_REMOVED = -1 };

// Memory of a session: blocks from malloc, or from one area that the program provided (library_memory.c).
typedef struct LibraryMemory {
    uint64_t limit;               // the most bytes that blocks can use, with their headers; 0: no limit
    uint64_t used, peak;          // bytes that blocks use now, with their headers; the most so far
    unsigned char *area, *end;    // begin and end of the program's area; NULL: blocks come from malloc
    unsigned char *search;        // the block of the area at which the search for a free one begins: none before it is free
} LibraryMemory;

typedef struct LibrarySource {
    int32_t kind;                 // SMC_KIND_…; KIND_REMOVED: the source was removed, so its number is free
    char *name, *text;            // text: `size` bytes and a NUL; both NULL if the number is free
    size_t size;
    uint32_t next_free;           // 1 + the next free number; 0: none
    uint32_t machine;             // a script: 1 + the number of its machine; 0: the only one
} LibrarySource;

// One script's last run.
typedef struct LibraryRun {
    bool is_done;                 // the fields below are valid
    Arena arena;                  // allocates everything below
    uint32_t engines;
    uint64_t max_steps;
    bool is_traced;
    ReportRun run;
    Buf report, trace;
} LibraryRun;

typedef struct LibraryVariable {
    const char *name;
    SmType type;
    int32_t kind;                 // SMC_VARIABLE_…
    uint32_t offset;              // in bytes, in the state vector or among the locals
    uint32_t output;              // 1 + its number among the machine's outputs; 0: it is not an output
} LibraryVariable;

typedef struct LibraryMachine {
    SmcMachine id;
    uint8_t *image;
    uint32_t image_size;
    SmvmMachine m;
    SmVm *vm;
    SmvmDecoded *decoded;
    uint8_t *vector;
    LibraryVariable *variable;    // sorted by name
    uint32_t variables;
    char *names;                  // the names of the machine, of variables and of states, each with a NUL
    const char *name;             // "": the image has none
    const char **state_name;
    bool has_names;
} LibraryMachine;

// A state, local or window in the comparison of two machines that can replace each other.
typedef struct LibrarySwapItem {
    int32_t kind, fate;           // SMC_SWAP_…
    const char *name;             // in the same block of memory, after the items
} LibrarySwapItem;

// Texts of which a session stores the last one, each in a separate arena.
enum { PAGE_RENDERED, PAGE_EDITED, PAGE_DIAGRAM, PAGE_REPORT, PAGE_COUNT };

// The structure of a compiled machine.
typedef struct LibraryTransition {
    uint32_t from, to;            // numbers of states, from 1
    int32_t block;                // SMC_BLOCK_…
    Span span;                    // the statement
    const char *guard;
} LibraryTransition;

typedef struct LibraryUse { uint32_t state, variable, access; } LibraryUse;

typedef struct LibraryModel {
    const Program *p;             // NULL: the source is no machine, or it has errors; then everything else is zero
    const Var **variable;         // the variables in the order of their numbers in smc.h
    uint32_t variables, transitions;
    LibraryTransition *transition;
    bool *is_left;                // by State.number - 1: a transition leads from the state to another one
    VEC(LibraryUse) use;
} LibraryModel;

typedef struct LibraryOutput {
    const char *name;
    const Buf *bytes;
} LibraryOutput;

typedef struct LibraryImage {
    char *bytes;                  // NULL: not built
    uint64_t size;
} LibraryImage;

// What runs the scripts of a machine.
typedef struct LibraryBench {
    Report *review;               // the report data to whose transitions the runs refer; NULL: no script has run
    Engine *engine[ENGINE_COUNT]; // by bit of SMC_ENGINE_…; NULL: not opened
    Arena engine_arena[ENGINE_COUNT], review_arena;
} LibraryBench;

// What the last smc_compile produced.  It is in the arenas of SmcSession.compiler, except for what has an arena here.  Zeroed when these are
// freed.
typedef struct LibraryResults {
    bool is_compiled;
    uint32_t sources;             // number of sources that were compiled; the arrays below are indexed by source
    const Source **text;          // NULL: no source had this number
    uint32_t *input;              // by source: 1 + its index in in.at; 0: it is only part of other inputs
    LibraryModel *model;
    LibraryRun *run;
    LibraryBench *bench;          // by source that is a machine: the engines for its scripts
    uint32_t *machine;            // by source that is a script: the source of its machine; UINT32_MAX: it has none
    LibraryImage *image;          // by source: the image of its machine, with names
    CompileInput in;
    CompileOptions o;
    DiagSelection selection;
    Compiled made;
    size_t errors;                // number of errors that smc_compile found, with warnings that count as errors
    Diags shown;                  // the diagnostics that the session shows, selected by the warnings: of smc_compile, smc_emit and runs
    Arena shown_arena, next_shown_arena;
    Arena page[PAGE_COUNT];
    Diags emitted;                // the diagnostics of the last smc_emit
    Arena output_arena;           // memory of `emitted` and `output`
    LibraryOutput *output;
    uint32_t outputs;
} LibraryResults;

struct SmcSession {
    uint64_t magic;               // LIBRARY_MAGIC while it is open
    LibraryMemory memory;
    jmp_buf oom;
    void *locale;                 // the locale "C", which every call sets for its thread (library_locale.h)
    int is_cancelled;             // accessed atomically
    int is_busy;                  // accessed atomically
    bool is_guarded;              // the running call can be cancelled, so a failed allocation may mean that it was
    bool has_layer;               // `compiler` allocates in a layer, memory that is freed at the end of one call (library_begin_layer)
    Session below;                // while there is a layer: the value of `compiler` before it
    Session compiler;
    bool has_compiler;
    LibrarySource *source;
    uint32_t sources, sources_cap;
    uint32_t free_source;         // 1 + the number that was freed last; 0: none is free
    uint64_t option[OPTION_COUNT];
    char *prefix;                 // of names in C (smc_prefix_set); NULL: none was set
    char **word;                  // the words that were passed to smc_warning_select
    uint32_t words, words_cap;
    Arena words_arena;            // for a message about a word; empty between two calls
    LibraryResults of;
    LibraryMachine **machine;     // open machines, sorted by id
    uint32_t machines, machines_cap;
    uint32_t next_machine;        // how many machines the session has opened: part of the handle of the newest one
    LibrarySwapItem *swap;        // the items of the last comparison; NULL: none
    uint32_t swap_items;
    char error[ERROR_TEXT_MAX];
};

// ---- library_memory.c ----

// Initialises m for the `size` bytes at `area`, or, if `area` is NULL, for malloc with at most `size` bytes (0: no limit).
void library_memory_init(LibraryMemory *m, void *area, uint64_t size);
// Works like realloc; size 0 frees `old`.  Blocks are aligned to 16 bytes.  NULL: out of memory.
void *library_memory_alloc(LibraryMemory *m, void *old, uint64_t size);

// ---- library_session.c ----

bool library_is_open(const SmcSession *s);
// returns the number of the parameter; UINT32_MAX: no parameter
uint32_t library_parameter(const LibraryMachine *own, const LibraryVariable *v);
// Records r with the sentence `text`, and returns r.  `text` NULL: the sentence of smc_result_text.
SmcResult library_fail(const SmcSession *s, SmcResult r, const char *text);
// Allocates memory outside the arenas; NULL: out of memory.
void *library_compiler_alloc(void *session, void *old, size_t size);      // the SmcAllocFn of the compiler's arenas
void *library_alloc(SmcSession *s, uint64_t size);
void library_release(SmcSession *s, void *memory);                        // frees it; it can be NULL
char *library_copy(SmcSession *s, const void *bytes, uint64_t size);      // the copy has a NUL after its last byte

// Returns an array with room for one more than n items of `item` bytes: `old`, or a larger copy that replaces it.  *cap: its allocated length.
void *library_grow(SmcSession *s, void *old, uint32_t n, uint32_t *cap, size_t item);

// Calls work(s, argument), which may allocate in a layer of s->compiler.  If memory runs out or smc_cancel was called, drops the layer, and the
// result is SMC_E_MEMORY or SMC_E_CANCELLED.
typedef SmcResult LibraryWork(SmcSession *s, void *argument);
SmcResult library_guard(SmcSession *s, LibraryWork *work, void *argument);
bool library_is_cancelled(void *session);

// A layer is memory for what one call computes from the results of smc_compile.  From library_begin_layer on, s->compiler allocates in a new
// arena and has an empty list of diagnostics.  Until the end of the layer, nothing outside of the layer may point into the arena.
void library_begin_layer(SmcSession *s);
// End the layer: s->compiler is as before.  The first moves its memory to *in, and frees what was there; the second frees it.
void library_keep_layer(SmcSession *s, Arena *in);
void library_drop_layer(SmcSession *s);

// ---- library_compile.c ----

void library_drop_results(SmcSession *s);
// Rebuilds of.shown from the diagnostics of smc_compile, of the last smc_emit, and of all runs: those of `script` are in *run if that is not NULL.
// If memory runs out, of.shown does not change.
void library_update_shown(SmcSession *s, const Diags *emitted, uint32_t script, const Diags *run);
// Returns what was compiled from a source, or NULL if it is not an input, was not compiled, or there is no such source.
CompiledSource *library_compiled(const SmcSession *s, uint32_t source);
// The number of the only machine that is compiled; UINT32_MAX if there is not exactly one.
uint32_t library_only_machine(const SmcSession *s);
const char *library_base_name(const char *path);

// ---- library_model.c ----

// Lists the structure of every machine that has been compiled.
void library_build_models(SmcSession *s);

// ---- library_machine.c ----

void library_close_machines(SmcSession *s);
// Returns an open machine of an open session, or NULL; and the result for a machine that is not one.
LibraryMachine *library_machine(const SmcSession *s, SmcMachine m);
SmcResult library_no_machine(const SmcSession *s);
// Starts a machine in a state.  SMC_E_INDEX: it has no such state.
SmcResult library_start_machine(LibraryMachine *m, uint32_t state);

#endif
