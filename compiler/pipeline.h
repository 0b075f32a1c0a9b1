// SPDX-License-Identifier: Apache-2.0
// The data flow of the compiler, one call per stage. Read pipeline.c first.
#ifndef SMC_PIPELINE_H
#define SMC_PIPELINE_H

#include "compiler/diag/diag.h"
#include "compiler/emit/c/emit_c.h"
#include "compiler/ir/ir.h"
#include "compiler/script/script.h"
#include "compiler/sema/check.h"
#include "compiler/syntax/ast.h"

// One compilation. All its results live in its arena.
typedef struct Session {
    Arena arena;
    Arena work, scratch;          // freed when a stage ends, and when a part of a stage ends
    StrPool strings;
    Diags diags;
    const char *print_after;      // session_ir prints the machine to print_to after this optimiser pass;
    Buf *print_to;                // "build": before the first pass; NULL: no printing
    bool check_passes;            // session_ir verifies the machine after every pass, not only the last: a third of a build's time
    unsigned warnings;            // 1u << DiagGroup of each group that session_analyse checks
    uint64_t step;                // how much G advances from step to step, for session_analyse; 0: unknown
    IrMachine *built;             // the machine that session_analyse analysed last, for session_ir; or NULL
    bool hide_locals;             // locals are not observable between steps: session_ir marks them as hidden
} Session;

// The sources and options of one machine's compilation.
typedef struct MachineInput {
    const Source *sm;
    const Source *sv;             // or NULL
    const Map *written_outside;   // see check_machine; or NULL
    int opt_level;                // 0, 1, 2
} MachineInput;

void session_init(Session *s, SmcAllocFn alloc, void *context, jmp_buf *oom);
void session_free(Session *s);

// Each returns NULL if there were errors, which are then in s->diags.
AstFile *session_parse(Session *s, const Source *src, FileKind kind);
StateVec *session_state_vector(Session *s, const Source *sv);
// The pins of `io`; also returns NULL if the state vector has errors.
IoMap *session_io(Session *s, const Source *io, const Source *sv);
Program *session_program(Session *s, const MachineInput *in);
// Returns the machine that runs state scripts: in->written_outside names the locals that they write. `flown` is the machine as it flies.
// It is compiled from the same sources without those names and has already been analysed; findings, costs and images come from it.
// Returns `flown` itself if the scripts write no local.
Program *session_program_for_scripts(Session *s, const MachineInput *in, Program *flown);
// Compiles an application and everything that it names, analyses included. app_files of its tree lists the required files; the caller
// supplies their contents. Returns NULL if any of them had errors.
App *session_app(Session *s, const AstFile *app, AppFiles *files);
IrMachine *session_ir(Session *s, const Program *p, int opt_level);
Script *session_script(Session *s, const Source *ss, const Program *p);
void session_analyse(Session *s, const Program *p);           // reports warnings for a machine without errors

// Several machines over one state vector form one image.
typedef struct ImageOptions {
    bool debug;               // with names and lines
    const IoMap *io;          // the pins that the image contains; or NULL
} ImageOptions;
bool session_image(Session *s, IrMachine *const *m, size_t n, const ImageOptions *o, Buf *out);

// Emits C (emit_c.h): one machine or one state vector, each self-contained; pins, for runtime-c; an image as an array.
void session_emit_c(Session *s, const IrMachine *m, const EmitCOptions *o, Buf *header, Buf *code);
void session_emit_c_io(Session *s, const IoMap *io, const EmitCOptions *o, Buf *header, Buf *code);
void session_emit_c_image(Session *s, const char *name, const Buf *image, const EmitCOptions *o, Buf *out);
void session_emit_c_state_vector(Session *s, const StateVec *sv, const EmitCOptions *o, Buf *header, Buf *code);

#endif
