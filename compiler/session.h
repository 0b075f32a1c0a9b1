// SPDX-License-Identifier: Apache-2.0
// One compilation, and a function for each of its stages.  compile_sources calls them in order; engines, tests and benchmarks call single
// stages.
#ifndef SMC_SESSION_H
#define SMC_SESSION_H

#include "compiler/diag/diag.h"
#include "compiler/emit/c/emit_c.h"
#include "compiler/ir/ir.h"
#include "compiler/script/script.h"
#include "compiler/sema/check.h"
#include "compiler/syntax/ast.h"

// What code outside a machine does with the machine's locals between two steps.
typedef enum SessionLocals {
    LOCALS_READ,              // scripts can read the locals; if the machine becomes C, any other C code can read them, too
    LOCALS_HIDDEN,            // nothing outside the machine reads the locals: an image without names
    LOCALS_SWAPPED            // a swap reads and writes the locals by name: an image with names (swapping.md 12)
} SessionLocals;

// Finds the files that scripts include.
typedef struct SourceFinder {
    // Returns the source that `from` includes as `name`, a path that is relative to the folder of `from`; the same pointer for the same file.
    // Returns NULL and sets *problem to a phrase if no such source exists.  The source lives as long as the session.  NULL: no file can be included.
    const Source *(*find)(void *context, const Source *from, const char *name, const char **problem);
    // Returns the file with recorded data that `from` names, a path as in `find`.  Returns NULL and sets *problem if there can be none.  The file
    // lives as long as the session; it is read when the script is compiled, and again in each run.  NULL: there can be no such files.
    const struct DataFile *(*find_data)(void *context, const Source *from, const char *name, const char **problem);
    void *context;
} SourceFinder;

// One compilation.  All its results live in its arena.
typedef struct Session {
    Arena arena;
    Arena tree;                   // memory for the syntax tree of the file that is being checked; freed after the check.  The tree of an .app is in
                                  // `arena`
    Arena work, scratch;          // `work` is freed when a stage ends, `scratch` when a part of a stage ends
    StrPool strings;
    Diags diags;
    const char *print_after;      // session_ir prints the machine to print_to after this optimiser pass;
    Buf *print_to;                // "build": before the first pass; NULL: no printing
    bool check_passes;            // session_ir verifies the IR after every pass, not only the last: takes a third of a build's time
    unsigned warnings;            // 1u << DiagGroup of each group that session_analyse checks
    bool has_requirements;        // session_requirements, not session_program, warns of definitions that nothing uses
    bool proposes_guards;         // session_script reports comparisons with G that a guard by time can replace
    uint64_t step;                // how much G advances from step to step, for session_analyse; 0: unknown
    bool pauses;                  // it can also advance more: the machine has an @mode
    IrMachine *built;             // the machine that session_analyse analysed last, for session_ir; or NULL
    SessionLocals locals;         // what code outside the machine does with its locals; session_ir sets IrVar.outside and IrVar.hidden for it
    SourceFinder finder;          // finds included files; its functions are NULL until the caller sets them
    const char *bug;              // a sentence in `arena` if a pass has broken a machine, with the name of the pass; else NULL
} Session;

// `alloc` with `context` provides all memory.  If it returns NULL, the session calls longjmp(*oom, 1); the caller then calls session_free.
// The session also does so if it finds that a pass has broken a machine, which is a bug of smc: `bug` is then a sentence, and otherwise NULL.
void session_init(Session *s, SmcAllocFn alloc, void *context, jmp_buf *oom);
void session_free(Session *s);

// ---- stages ----

// The sources and options of one machine's compilation.
typedef struct MachineInput {
    const Source *sm;
    const Source *sv;             // the state vector, or NULL
    const Map *written_outside;   // the locals that code outside the machine writes (check_machine); or NULL
    const MachineInstance *instance;      // the bindings of the machine, only if sv is set; or NULL
} MachineInput;

// Functions that parse or check return NULL after errors, which are then in s->diags.
AstFile *session_parse(Session *s, const Source *src, FileKind kind);
StateVec *session_state_vector(Session *s, const Source *sv);
// The messages of `net`; also returns NULL if the state vector has errors.
Network *session_net(Session *s, const Source *net, const Source *sv);

// The pins of `io`; also returns NULL if the state vector has errors.
IoMap *session_io(Session *s, const Source *io, const Source *sv);
Program *session_program(Session *s, const MachineInput *in);
// Returns the machine that runs state scripts: in->written_outside names the locals that they write. `flown` is the machine as it flies.
// It is compiled from the same sources without those names and has already been analysed; findings, costs and images come from it.
// Returns `flown` itself if the scripts write no local.
const Program *session_program_for_scripts(Session *s, const MachineInput *in, const Program *flown);
// Compiles an application and everything that it names, analyses included. app_list_files of its tree lists the required files; the caller
// supplies their contents. Returns NULL if any of them had errors.
App *session_app(Session *s, const AstFile *app, AppFiles *files);
// Joins the machines of an application, compiled by session_app, for its scripts, which write the names of `written` (language.md 8.71 to
// 8.83). Returns NULL after an error: the application has no machines.
const Program *session_join(Session *s, const App *a, const AppFiles *files, const Map *written);
// Adds the names of the locals and elements that a script, with the files that it includes, writes to `written`, and returns its delta_t in the unit
// `unit`; 0 if it has none, or errors.
uint64_t session_script_writes(Session *s, const Source *ss, TimeUnit unit, Map *written);
// Checks a script for the machine p.
Script *session_script(Session *s, const Source *ss, const Program *p);
// Checks the requirements of n files for the machine p, and the marks @req in p.
Requirements *session_requirements(Session *s, const Source *const *rq, size_t n, const Program *p);
// Checks the marks @req in a script of the same machine.
void session_check_requirements_of_script(Session *s, const Requirements *r, const Script *script);
// Reports warnings for a machine without errors. Leaves the IR that it builds in s->built.
void session_analyse(Session *s, const Program *p);
// Returns the optimised IR of p.  If s->built is the IR of p, it is optimised in place; else the IR is built first.
IrMachine *session_ir(Session *s, const Program *p, int opt_level);

typedef struct ImageOptions {
    bool debug;               // the image contains names and line numbers
    const IoMap *io;          // the pins that the image contains; or NULL
} ImageOptions;
// Emits an image with n machines, which share one state vector.  Returns false after reporting what exceeds the format.
bool session_image(Session *s, IrMachine *const *m, size_t n, const ImageOptions *o, Buf *out);

// Opens the VM, or the VM with soft numbers, on an image with names that is built for this engine.  Returns NULL and sets *error to a sentence if
// the image exceeds a limit, which is then also in s->diags, or if the VM cannot run it.
Engine *session_open_vm(Session *s, const Program *p, int opt_level, bool soft, const char **error);

// The C of one machine, self-contained (emit_c.h).
void session_emit_c(Session *s, const IrMachine *m, const EmitCOptions *o, Buf *header, Buf *code);

#endif
