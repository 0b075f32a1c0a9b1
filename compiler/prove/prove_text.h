// SPDX-License-Identifier: Apache-2.0
// Writes the verdicts on requirements for an engineer, and for programs.
#ifndef SMC_PROVE_TEXT_H
#define SMC_PROVE_TEXT_H

#include "compiler/base/buf.h"
#include "compiler/prove/prove.h"

const char *prove_verdict_name(ProveVerdict v);       // "proved", "vacuous", "violated", "undecided", "interrupted", "violated-alone"
const char *prove_verdict_words(ProveVerdict v);      // "proved", "vacuous", "violated", "no violation found", "not decided", "violated alone"
// Returns what is true after each step in a state, as a sentence; NULL: nothing is known.
const char *prove_invariant_text(Arena *arena, const ProveInvariant *i);
// Returns the script that shows a violation; NULL: none can be written.
const char *prove_script(Arena *arena, const Program *p, const ProveOf *of);
// Appends the lines that support a verdict: assumptions and what is true in each state, a script that violates it, or how much was tried.
void prove_write_reason(Arena *arena, const Program *p, const ProveOf *of, size_t indent, Buf *out);
// The two parts of prove_write_text: what precedes the verdicts, and the verdict on requirement n, which only has to be complete up to there.
void prove_write_head(const Program *p, const ProveResult *r, Buf *out);
void prove_write_verdict(Arena *arena, const Program *p, const ProveResult *r, uint32_t n, Buf *out);
void prove_write_text(Arena *arena, const Program *p, const ProveResult *r, Buf *out);
void prove_write_json(Arena *arena, const Program *p, const ProveResult *r, Buf *out);

#endif
