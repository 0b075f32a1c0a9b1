// SPDX-License-Identifier: Apache-2.0
// The files that a compilation produces, as bytes: its last stage, and the texts of --emit=tokens and ast, which stop before checking.
#ifndef SMC_ARTEFACTS_H
#define SMC_ARTEFACTS_H

#include "compiler/compile.h"

// One call of compile_sources.
typedef struct Compilation {
    Session *s;
    const CompileInput *in;
    const CompileOptions *o;
    Compiled *out;
    const Program **program;      // of all machines without errors
    size_t programs;
    IoMap *image_pins;            // in->pins, or NULL
} Compilation;

// Adds the output of --emit=tokens or ast: the tokens or the syntax tree of every source.
void artefacts_add_syntax_dump(Compilation *c);
// Emits what options->emit requests of machines, state vectors and pins without errors.
void artefacts_emit(Compilation *c);
// Emits the C of an application: its own, and that of its state vector, its machines that are C, and its pins.
void artefacts_emit_app(Compilation *c, const App *a);

#endif
