// SPDX-License-Identifier: Apache-2.0
// The verdicts of `smc prove` on the requirements, each with what supports it.
#include "compiler/prove/prove_text.h"
#include "compiler/report/page.h"
#include "compiler/report/page_text.h"

const char *report_proof_tone(ProveVerdict v) { return v == PROVE_PROVED ? "good" : v == PROVE_VIOLATED ? "bad" : "note"; }

void report_add_proofs(Report *r, Doc *d)
{
    const Program *p = r->analysis.p;
    const ProveResult *all = r->proofs;

    if (!all)
        return;
    doc_add_section(d, "proofs", "Proofs");
    doc_add_paragraph(d, TEXT_PROOFS);
    for (uint32_t i = 0; i < all->n; i++) {
        const ProveOf *of = &all->of[i];
        DocPart *heading = doc_add_heading(d, NULL, format_in(r->arena, "%s: %s", of->what->id->text, of->what->text->text));
        Buf reason;

        heading->plain = true;
        heading->tone = report_proof_tone(of->verdict);
        heading->badge = prove_verdict_words(of->verdict);
        buf_init(&reason, r->arena);
        prove_write_reason(r->arena, p, of, 0, &reason);
        doc_add_lines(d, buf_text(&reason));
    }
}
