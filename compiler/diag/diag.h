// SPDX-License-Identifier: Apache-2.0
// Diagnostics: the compiler's messages to its user. Every message is defined in codes.def; this module collects them with their source
// positions. It prints nothing: renderers (render_text.c …) turn the list into text.
#ifndef SMC_DIAG_H
#define SMC_DIAG_H

#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "compiler/base/arena.h"
#include "compiler/base/buf.h"
#include "compiler/base/source.h"
#include "compiler/base/vec.h"

typedef enum DiagSeverity { DIAG_ERROR, DIAG_WARNING, DIAG_NOTE } DiagSeverity;

// A row of codes.def.  E0204 unknown_element is DIAG_unknown_element here.
typedef enum DiagCode {
#define DIAG(id, name, severity, flag, message, page) DIAG_##name,
#define DIAG_NOTE_TEXT(name, message) DIAG_##name,
#include "compiler/diag/codes.def"
    DIAG_COUNT
} DiagCode;

typedef struct DiagInfo {
    const char *id;           // "E0204"; NULL for the message of a note
    const char *name;         // its name in the code: "unknown_element"
    DiagSeverity severity;
    const char *flag;         // of a warning: the name after -W, as "unused-element"; else NULL
    const char *message;      // the message, in which each {} is replaced by an argument
    const char *page;         // what `smc explain` prints: the meaning, an example, what to do
} DiagInfo;

extern const DiagInfo diag_info[DIAG_COUNT];

// A row of flags.def.
typedef enum DiagGroup { DIAG_GROUP_ALL, DIAG_GROUP_EXTRA, DIAG_GROUP_FLIGHT, DIAG_GROUPS } DiagGroup;
#define DIAG_GROUPS_ALL ((1u << DIAG_GROUPS) - 1u)        // the set of all groups: 1u << DiagGroup for each
typedef enum DiagJudged {                                 // what a run must know to report an @allow of the warning as unused (flags.def)
    DIAG_JUDGED_ALWAYS, DIAG_JUDGED_VECTOR, DIAG_JUDGED_APP, DIAG_JUDGED_STEP, DIAG_JUDGED_TRIALS, DIAG_JUDGED_NO_STEP, DIAG_JUDGED_NEVER
} DiagJudged;
typedef enum DiagCopies { DIAG_COPIES_CODE, DIAG_COPIES_RUN } DiagCopies;      // findings on statements of [all_states] (flags.def)
typedef struct DiagFlag {
    const char *name;         // the name after -W, such as "unused-element"
    DiagGroup group;
    DiagJudged judged;
    DiagCopies copies;
    const char *sentence;
} DiagFlag;

extern const DiagFlag diag_flag[];
extern const size_t diag_flag_count;
const DiagFlag *diag_find_flag(const char *name);         // NULL if no warning has this name
extern const char *const diag_group_name[];               // by DiagGroup, as after -W: "all", "extra", "flight"

typedef struct DiagEdit { Span span; const char *text; } DiagEdit;     // replace span by text
typedef struct DiagNote {
    Span span;                // where the note points; span.src may be NULL
    const char *text;
    unsigned step;            // number of the step on the path that leads to the finding, from 1; 0: a plain note
} DiagNote;

// A declaration that a finding is about. If all of a finding's declarations of one subject have an @allow, the finding is allowed.
typedef enum DiagSubject { DIAG_SENSOR, DIAG_OUTPUTS, DIAG_OTHER_WRITER, DIAG_CONSTANT, DIAG_SUBJECTS } DiagSubject;
typedef struct DiagAbout { Span span; DiagSubject subject; } DiagAbout;

// @allow: the user knows and accepts the warnings of one flag in one part of a source.
typedef struct DiagAllow {
    const char *flag, *reason;
    Span span, covers;        // span: the annotation; covers: the part of the source that it applies to
    bool shared;              // other machines, or reports that come later, may need the @allow, so it is never reported as unused
    bool used;
} DiagAllow;

typedef struct Diag {
    DiagCode code;
    DiagSeverity severity;                // DIAG_ERROR also for a warning that -Werror made an error
    Span span;
    const char *text;                     // the message, arguments filled in
    const char *label;                    // printed after the caret, as "did you mean 'valveOpen'?"; or NULL
    VEC(DiagNote) notes;
    VEC(DiagEdit) edits;                  // all edits together are one proposed fix
    VEC(const char *) states;             // the states for which it was reported, where its statement belongs to several (Source.copy_of)
    VEC(const char *) machines;           // the machines for which it was reported while Diags.machine was set
    VEC(DiagAbout) about;                 // declarations where an @allow can cover this finding
    bool follows;                         // an error that an earlier one explains: diags_fold removes it
    bool allow_checked;                   // an earlier call of diags_apply_allows has examined it
    const char *allowed;                  // the reason given in the @allow that covers the finding; else NULL
} Diag;

typedef struct Diags {
    Arena *arena;
    VEC(Diag *) list;                     // in the order of the reports; diags_sort sorts them by position
    size_t errors, warnings;              // how many were reported; the list has at most DIAG_KEPT_MAX of each
    size_t errors_seen;                   // errors, including repeated and muted ones: if it grew during a check, the check failed
    VEC(DiagAllow) allow;
    VEC(Diag *) allowed;                  // removed from the list by diags_apply_allows
    VEC(Diag *) folded;                   // removed from the list by diags_fold; their edits are still proposed
    unsigned known;                       // what this run has checked besides the machine: a set of 1u << DiagJudged
    unsigned analysed;                    // the groups whose warnings have all been reported, because analyses have run: a set of 1u << DiagGroup
    bool muted;                           // while set, reports are dropped
    const char *machine;                  // the machine that is being compiled, where several are of one file; NULL: none
    Diag *dropped;                        // returned for every report that is not in the list; its fields are meaningless
    Diag *first;                          // the diagnostic in the list that the last dropped report repeats; NULL: none
    VEC(const Source *) files;            // sources of reports, in the order of their first report
    struct DiagPosition *position;        // positions already reported: a hash table with open addressing; its size is a power of two
    size_t position_cap, position_n;
} Diags;

enum { DIAG_KEPT_MAX = 10000 };

void diags_init(Diags *d, Arena *arena);
void diags_clear(Diags *d);               // removes all reports; every @allow still covers later reports

// Adds a diagnostic. One `const char *` argument follows for each {} of its message. Returns the diagnostic so that the caller can add
// notes, a label and edits; never NULL. A second report of one code at one position is dropped: notes and edits of the result are ignored.
Diag *diag_report(Diags *d, DiagCode code, Span span, ...);
Diag *diag_report_list(Diags *d, DiagCode code, Span span, va_list args);     // diag_report with a va_list
// Adds a note; `text` is a DIAG_NOTE_TEXT row, its arguments follow.
void diag_note(Diags *d, Diag *to, Span span, DiagCode text, ...);
// Adds a note that is the next numbered step of the path that leads to the finding.
void diag_note_step(Diags *d, Diag *to, Span span, DiagCode text, ...);
// Sets the text printed after the caret; `text` is a DIAG_NOTE_TEXT row.
void diag_label(Diags *d, Diag *to, DiagCode text, ...);
// Returns the text of a DIAG_NOTE_TEXT row with its arguments, to be an argument of another message.
const char *diag_text(Diags *d, DiagCode text, ...);
// Adds the declaration of a variable that the diagnostic names, for example as one of its outputs. If `to` was dropped because it repeats
// a diagnostic in the list, the declaration is added to that diagnostic.
void diag_note_declaration(Diags *d, Diag *to, DiagSubject subject, Span declaration);
// Proposes an edit that is certainly what the user meant: replaces `span` by a copy of `text`.
void diag_edit(Diags *d, Diag *to, Span span, const char *text);

// Removes the diagnostic at list.at[i], a warning.
void diags_remove_warning(Diags *d, size_t i);

// Adds an @allow. A shared one is never reported as unused, because another machine may need it.
void diag_allow(Diags *d, const char *flag, const char *reason, Span span, Span covers);
void diag_allow_shared(Diags *d, const char *flag, const char *reason, Span span, Span covers);
// Moves the warnings that are allowed from the list into `allowed`. If analyses have run and there is no error, it also reports every
// @allow that no warning needed. So first call it after the analyses. A later call examines only warnings reported since.
void diags_apply_allows(Diags *d);

// The -W options of the command line in order, each without its -W. The caller owns the words.
typedef struct DiagSelection {
    const char **word;
    size_t n;
    bool none;                            // -w was given: all warnings are dropped
} DiagSelection;

// Drops disabled warnings and turns those that -Werror names into errors (selection.c). Call it after diags_apply_allows, which covers
// warnings but no errors. A later call with the same words changes only what was reported since.
void diags_select(Diags *d, const DiagSelection *w);
// Returns the groups with at least one enabled warning: a set of 1u << DiagGroup.
unsigned diag_selection_groups(const DiagSelection *w);
bool diag_selection_enables(const DiagSelection *w, DiagCode code);       // whether the warning `code` is enabled
// Returns what is wrong with the words: "no warning is called 'x'; did you mean 'y'?"; NULL if they are correct.
const char *diag_selection_error(Arena *arena, const DiagSelection *w);

void diags_sort(Diags *d);                // by file in the order of Diags.files, then by position; stable

// Removes errors that another error in the list explains: the others on a line that is not understood, and the repetitions of a habit such
// as a semicolon after each statement, which a note then counts. Call it after diags_sort, and after the edits were applied. A second call
// changes nothing.
void diags_fold(Diags *d);

typedef struct DiagStyle {
    bool color;
    size_t most;                          // errors shown before the rest is only counted; 0 shows all
} DiagStyle;

// Renders the list for the user. "1 error, 2 warnings" follows if there are any.
void diags_render_text(const Diags *d, const DiagStyle *style, Buf *out);
// Appends text of a source in a form that is safe on a terminal; returns the number of columns.
size_t diag_put_printable(Buf *out, const char *s, size_t n);
// One JSON object per line.
void diags_render_json(const Diags *d, Buf *out);
void diag_plain_json(const char *severity, const char *message, Buf *out);    // for messages without a code, such as that a file cannot be read
typedef struct PlainMessage { const char *severity, *text; } PlainMessage;      // "error", "warning" or "note"
typedef VEC(PlainMessage) PlainMessages;
// One document of SARIF, with the messages that are not diagnostics.
void diags_render_sarif(const Diags *d, const PlainMessages *plain, const char *version, Buf *out);

// Recognises a finding again in a later version of its file.
typedef struct DiagFingerprint {
    uint64_t hash;
    unsigned long twin;                   // 1, 2, 3 … among findings with the same hash
} DiagFingerprint;

const DiagFingerprint *diags_fingerprints(const Diags *d, Arena *arena);  // one for each of d->list, then of d->allowed

// Returns the row whose id, or warning name, is `id`; case does not matter. NULL if no row has it.
const DiagInfo *diag_find(const char *id);

// Appends the text of src with the proposed edits applied. Edits that touch each other are skipped; those of one diagnostic are applied
// together. Returns the number of diagnostics whose edits were applied.
size_t diags_apply_edits(const Diags *d, const Source *src, Buf *out);

// All rows with their pages: docs/diagnostics.md.
void diags_write_markdown(Buf *out);
// A warning's name, what it finds, and how to switch it: the text before the pages of its codes.
void diag_put_flag(Buf *out, const DiagFlag *flag);
void diag_put_title(const DiagInfo *row, Buf *out);        // the message, with "..." for each argument
// What follows the message in text output: "E0204"; for a warning also its name: "W0503 unreachable-state".
const char *diag_code_and_name(const Diag *d, Arena *arena);

#endif
