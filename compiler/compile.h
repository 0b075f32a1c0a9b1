// SPDX-License-Identifier: Apache-2.0
// The compiler as a library: compile_sources turns sources into findings and output files (artefacts).  Every front end calls it.  It does
// no I/O: the caller reads the sources, prints the diagnostics and writes the artefacts.  compile.c begins with a drawing of the stages.
#ifndef SMC_COMPILE_H
#define SMC_COMPILE_H

#include "compiler/limits.h"
#include "compiler/session.h"

// ---- what to compile ----

typedef struct CompileSource {
    const Source *text;
    FileKind kind;
    EmitCOptions c;               // options of this source's C, for EMIT_C and EMIT_ARRAY
    const char *array;            // in the first source, for EMIT_ARRAY: the name of the C array
    size_t machine;               // the machine of a script or of requirements: 1 + its index in CompileInput.at; 0: the only machine
} CompileSource;

// An application and the files that it names, from compile_open_app.
typedef struct CompileApp {
    AstFile *tree;
    AppFiles files;
} CompileApp;

// The sources of one call, in the order that the user named them.  Some are only parsed, because what their check needs is missing:
// - a script or a file of requirements, if CompileSource.machine is 0 and `at` does not contain exactly one machine;
// - pins and messages, if `vector` is NULL;
// - an application, if `app` is NULL.
typedef struct CompileInput {
    CompileSource *at;
    size_t n;
    const Source *vector;         // the text of the state vector of every machine, of all pins and messages; or NULL
    const Source *pins;           // the pins that the image contains; or NULL
    const Source *messages;       // messages (.net) for a report; nothing else reads them; or NULL
    const MachineInstance *instance;      // the bindings of the only machine, with `vector`; or NULL
    CompileApp *app;              // the application if at[0] is one; every other source is then a script of it; or NULL
} CompileInput;

typedef enum CompileEmit {
    EMIT_NOTHING,
    EMIT_BYTECODE,                // one image of all machines
    EMIT_ARRAY,                   // the image of EMIT_BYTECODE as a C array
    EMIT_C,                       // C of each source; for an application, of everything that it names
    EMIT_IR, EMIT_AST, EMIT_TOKENS        // the result of a stage, as text
} CompileEmit;

typedef struct CompileOptions {
    CompileEmit emit;
    int opt_level;                        // level of optimisation: 0, 1 or 2
    const DiagSelection *warnings;        // NULL: every warning is found and stays in the list
    bool skip_analyses;                   // reports errors only, and the warnings of the checker
    uint64_t step;                        // how much G advances in a step; 0: the step that the machine declares, or else the delta_t of its
                                          // scripts, if all have the same
    CompileLimits limits;
    bool names;                           // the image contains names and lines; without them locals are not observable
    bool soft;                            // for the C of an application: EmitCOptions.soft
    bool measure;                         // builds an image to measure costs: CompiledSource.measured
    bool scripts_later;                   // only lists the locals that scripts write; the caller compiles the scripts with session_script
} CompileOptions;

// ---- what is compiled ----

// The results for one source.  A field is NULL if it does not apply to the kind of the source, was not requested, or had errors.
typedef struct CompiledSource {
    const Program *program;       // a machine as it will fly, without scripts
    const Program *scripted;           // the machine as scripts run it (session_program_for_scripts); for an application
                                  // with scripts, its machines joined (session_join)
    IrMachine *ir;                // the optimised IR of `program`
    const uint8_t *measured;      // an image of this machine alone, with lines, for cost_of_machine
    StateVec *vector;
    IoMap *pins;
    Network *net;
    Script *script;
    const Requirements *requirements;         // for a machine: the requirements of all files of requirements that belong to it
    bool is_included;             // another script of the call includes this one, so it does not run by itself
} CompiledSource;

// A file to write.
typedef struct Artefact {
    size_t source;                // index of the source from which the artefact is generated
    const char *name;             // the file's name, for the C of an application; otherwise NULL, and `suffix` determines the name:
    const char *suffix;           // the default name is the source's stem and suffix, such as ".smb"; NULL: for standard output
    Buf *bytes;
} Artefact;

typedef struct Compiled {
    CompiledSource *of;           // by index in CompileInput.at: its results
    const App *app;
    IoMap *image_pins;            // CompileInput.pins after checking; NULL if absent or with errors
    VEC(Artefact) artefact;       // complete only if compile_sources() returned true
} Compiled;

// Parses an application, and lists the files that it names in out->files.  The caller reads each file, sets its `src` or `problem`, and
// passes `out` to compile_sources.
void compile_open_app(Session *s, const Source *app, CompileApp *out);

// Compiles everything that `o` requests.  s->diags then has the diagnostics, sorted, without the allowed and the disabled ones.  Returns
// whether there was no error.
bool compile_sources(Session *s, const CompileInput *in, const CompileOptions *o, Compiled *out);

// Adds the artefacts of o->emit to those of an earlier compile_sources of the same input, which found no error; other options must be as they
// were then.  Parses and analyses nothing again, except for EMIT_AST and EMIT_TOKENS.  Reports errors, such as an image that is too large, and
// returns false if there was one.
bool compile_emit(Session *s, const CompileInput *in, const CompileOptions *o, Compiled *out);

#endif
