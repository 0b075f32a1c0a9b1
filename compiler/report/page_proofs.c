// SPDX-License-Identifier: Apache-2.0
// The verdicts of `smc prove` on the requirements, each with what supports it.
#include "compiler/prove/prove_app.h"
#include "compiler/prove/prove_text.h"
#include "compiler/report/page.h"
#include "compiler/report/page_text.h"

#include <string.h>

enum { LINES_SHOWN = 40, LINES_CUT_LEAST = 10 };      // most lines of a script; how many more it must have before it is cut

// Cuts a text after LINES_SHOWN lines, if many follow.  Returns how many were cut.
static size_t cut_lines(char *text)
{
    size_t lines = 0;
    char *end = NULL;

    for (char *at = text; *at; at++)
        if (*at == '\n' && ++lines == LINES_SHOWN)
            end = at;
    if (lines < LINES_SHOWN + LINES_CUT_LEAST)
        return 0;
    *end = '\0';
    return lines - LINES_SHOWN;
}

// A proof and the lines that support it.
typedef struct ProofLines { const ProveOf *of; const char *text; } ProofLines;

// Returns an earlier requirement that the same lines support; NULL: none.
static const Requirement *find_same(const ProofLines *lines, uint32_t n, const ProofLines *now)
{
    for (uint32_t i = 0; i < n; i++)
        if (now->of->verdict == PROVE_PROVED && lines[i].of->verdict == PROVE_PROVED && strcmp(lines[i].text, now->text) == 0)
            return lines[i].of->what;
    return NULL;
}

// Appends the lines that support a verdict; of an application, first which machine decides it.
static void write_reason(const Report *r, uint32_t i, Buf *out)
{
    const ProveApp *a = r->proofs_of_app;

    if (!a) {
        prove_write_reason(r->arena, r->analysis.p, &r->proofs->of[i], 0, out);
        return;
    }
    if (!a->why[i])
        buf_printf(out, "of the machine %s\n", r->member[a->decider[i]].of->name->text);
    prove_app_write_reason(a, i, 0, out);
}

const char *report_proof_tone(ProveVerdict v) { return v == PROVE_PROVED ? "good" : v == PROVE_VIOLATED ? "bad" : "note"; }

void report_add_proofs(Report *r, Doc *d)
{
    const ProveResult *all = r->proofs;
    ProofLines *lines;

    if (!all)
        return;
    doc_add_section(d, "proofs", "Proofs");
    doc_add_paragraph(d, r->proofs_of_app ? TEXT_PROOFS_OF_APP : TEXT_PROOFS);
    lines = ARENA_ARRAY(r->arena, ProofLines, all->n);
    for (uint32_t i = 0; i < all->n; i++) {
        const ProveOf *of = &all->of[i];
        DocPart *heading = doc_add_heading(d, NULL, format_in(r->arena, "%s: %s", of->what->id->text, of->what->text->text));
        const Requirement *same;
        Buf reason;
        char *text;
        size_t cut;

        heading->plain = true;
        heading->tone = report_proof_tone(of->verdict);
        heading->badge = prove_verdict_words(of->verdict);
        buf_init(&reason, r->arena);
        write_reason(r, i, &reason);
        text = arena_copy(r->arena, buf_text(&reason), reason.n + 1);
        cut = cut_lines(text);
        lines[i] = (ProofLines){of, text};
        same = strchr(text, '\n') ? find_same(lines, i, &lines[i]) : NULL;
        if (same)
            doc_add_paragraph(d, format_in(r->arena, TEXT_PROOF_SAME, same->id->text));
        else
            doc_add_lines(d, text);
        if (cut)
            doc_add_paragraph(d, format_in(r->arena, TEXT_PROOF_CUT, (unsigned long)cut));
    }
}
