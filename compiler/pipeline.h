// SPDX-License-Identifier: Apache-2.0
// The data flow of the compiler, one call a stage.  pipeline.c is the page to read first.
#ifndef SMC_PIPELINE_H
#define SMC_PIPELINE_H

#include "compiler/diag/diag.h"
#include "compiler/emit/c/emit_c.h"
#include "compiler/ir/ir.h"
#include "compiler/script/script.h"
#include "compiler/sema/check.h"
#include "compiler/syntax/ast.h"

// One compilation: everything it makes lives in its arena.
typedef struct Session {
    Arena arena;
    Arena work, scratch;          // given back when a stage ends, and when a part of it does
    StrPool strings;
    Diags diags;
    const char *print_after;      // session_ir prints the machine to print_to after this pass of the optimiser, or after
    Buf *print_to;                // "build" before the first; NULL: it does not
    bool check_passes;            // session_ir checks the machine after every pass, not only the last: a third of a build's time
    unsigned warnings;            // 1u << DiagGroup of each that session_analyse is to look for
    uint64_t step;                // how much G advances from step to step, for session_analyse; 0: not known
    IrMachine *built;             // what session_analyse has looked at last, for session_ir; or NULL
    bool hide_locals;             // nobody will look at locals between steps: session_ir marks them as hidden
} Session;

// What a machine is compiled from and with.
typedef struct MachineInput {
    const Source *sm;
    const Source *sv;             // or NULL
    const Map *written_outside;   // see check_machine; or NULL
    int opt_level;                // 0, 1, 2
} MachineInput;

void session_init(Session *s, SmcAllocFn alloc, void *context, jmp_buf *oom);
void session_free(Session *s);

// Each gives NULL when there were errors, which are then in s->diags.
AstFile *session_parse(Session *s, const Source *src, FileKind kind);
StateVec *session_state_vector(Session *s, const Source *sv);
// The pins of `io`; gives NULL too where the state vector has errors.
IoMap *session_io(Session *s, const Source *io, const Source *sv);
Program *session_program(Session *s, const MachineInput *in);
// The machine that runs state scripts: in->written_outside names the locals that they write.  `flown` is the machine as it flies,
// compiled from the same sources without them and analysed before; findings, costs and images come from that one.  Returns
// `flown` where no local is written.
Program *session_program_for_scripts(Session *s, const MachineInput *in, Program *flown);
// An application and all that it names, analyses included: app_files of its tree tells which files are wanted; who called has
// given their texts.  NULL when there were errors in any of them.
App *session_app(Session *s, const AstFile *app, AppFiles *files);
IrMachine *session_ir(Session *s, const Program *p, int opt_level);
Script *session_script(Session *s, const Source *ss, const Program *p);
void session_analyse(Session *s, const Program *p);           // warns of what looks wrong in a machine that is no error

// Several machines over one state vector make one image.
typedef struct ImageOptions {
    bool debug;               // with names and lines
    const IoMap *io;          // the pins that it carries; or NULL
} ImageOptions;
bool session_image(Session *s, IrMachine *const *m, size_t n, const ImageOptions *o, Buf *out);

// C (emit_c.h): one machine, or a state vector by itself, which stand alone; pins, for runtime-c; an image as an array.
void session_emit_c(Session *s, const IrMachine *m, const EmitCOptions *o, Buf *header, Buf *code);
void session_emit_c_io(Session *s, const IoMap *io, const EmitCOptions *o, Buf *header, Buf *code);
void session_emit_c_image(Session *s, const char *name, const Buf *image, const EmitCOptions *o, Buf *out);
void session_emit_c_state_vector(Session *s, const StateVec *sv, const EmitCOptions *o, Buf *header, Buf *code);

#endif
