// SPDX-License-Identifier: Apache-2.0
// The output files of a compilation, as bytes in memory.  Most are produced after all other stages; those of --emit=tokens and --emit=ast
// are produced before checking.
#ifndef SMC_ARTEFACTS_H
#define SMC_ARTEFACTS_H

#include "compiler/compile.h"

// The state of one call of compile_sources.
typedef struct Compilation {
    Session *s;
    const CompileInput *in;
    const CompileOptions *o;
    Compiled *out;
    const Program **program;      // the programs of the machines without errors, `programs` of them
    size_t programs;
    size_t only_machine;          // index of the machine in `in`; SIZE_MAX: there is not exactly one machine
} Compilation;

// Returns what code outside a machine does with its locals, if the machine becomes part of an image that these options produce.
SessionLocals artefacts_image_locals(const CompileOptions *o);
// Adds the output of --emit=tokens or ast: the tokens or the syntax tree of every source.
void artefacts_add_syntax_dump(Compilation *c);
// Emits the outputs that o->emit requests.  Call it only if no source has an error.
void artefacts_emit(Compilation *c);
// Emits the C of an application: its tables, its state vector, its machines without @bytecode, and its pins.
void artefacts_emit_app(Compilation *c, const App *a);

#endif
