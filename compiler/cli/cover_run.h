// SPDX-License-Identifier: Apache-2.0
// smc cover: declarations shared by its files.
#ifndef SMC_COVER_RUN_H
#define SMC_COVER_RUN_H

#include "compiler/cli/cli.h"
#include "compiler/script/baseline.h"
#include "compiler/search/generated.h"
#include "compiler/search/goal_text.h"
#include "compiler/search/must_not.h"

#define COVER_MADE_BY "smc cover"           // in the first line of a script
enum { COVER_STEPS_MOST = 1000000 };        // a script that runs longer is ended
#define MUST_NOT_GOAL "Must not: "          // begins the goal of a script for a pair of states

// A script in the folder of -o that an earlier call of smc cover has written for this machine.
typedef struct OldScript {
    const char *path;
    const Source *src;
    enum { OLD_EDITED, OLD_VALID, OLD_STALE } verdict;
    const char *why;          // STALE: why the script is not used, as a phrase: "it fails"
    bool is_replaced;         // STALE: a new script with the same name replaces this one
} OldScript;

typedef struct NewScript {
    const char *path, *goal;  // goal: the sentence in the comment at the start of the script
    const char *text;
    size_t n;
    const char *also;         // the other goals that this script is the first to reach, as text; "": none
} NewScript;

// A pair of states without a transition between them.  path: a script in which the condition of a transition to the second state is true, and the
// machine stays in the first; NULL: none.
typedef struct CoverPair { const MustNot *pair; const char *path; } CoverPair;

typedef struct CoverRun {
    Cli *c;
    Arena *arena;
    const Program *p;         // the machine, or the application
    const char *folder;       // the folder of -o, to which scripts are written
    const char *file;         // the name of the file of p, without folders
    size_t machines;          // 1, or the number of the application's machines.  The next four have an entry for each:
    Cover **given;            // coverage by the scripts of the command line and by edited ones of the folder: what they do not cover are the goals
    Cover **all;              // coverage by all scripts, the new ones included
    GoalTexts **text;
    const SearchResult **result;      // of the last search for this machine's goals; NULL: there was nothing to search
    unsigned kinds;           // 1u << CoverKind of each kind that has goals
    VEC(const Script *) script;       // the scripts that the command line names
    Baseline given_run;               // the runs of these scripts and of the edited ones of the folder: those that fail are left out
    VEC(Scenario) recorded;           // the runs of the given scripts, as far as scenarios can express them
    VEC(OldScript) old;
    VEC(NewScript) new_one;
    VEC(CoverPair) pair;
    VEC(const char *) in_the_way;     // files of other origin that have the names of new scripts
    const char **name;        // `names` names of the files in the folder
    size_t names;
    bool was_interrupted;
} CoverRun;

// ---- cmd_cover.c ----

// Returns a new Cover for each machine.
Cover **cover_new_each(const CoverRun *r);
void cover_settle_each(const CoverRun *r, Cover *const *cover);

// ---- cover_search.c ----

typedef struct CoverSettings { uint64_t effort, memory, seed, delta_t; size_t format; } CoverSettings;

// Searches for inputs that reach the goals, and writes a script for each run that reaches one which no script of the folder does.
int cover_search(CoverRun *r, const CoverSettings *s);

// ---- cover_folder.c ----

// Runs a script that counts as given.  Returns whether it passes; if not, it is left out.
bool cover_accept_script(CoverRun *r, const char *name, const Script *s);
// Creates the folder, lists it, and reads the scripts that smc has written for this machine.  Adds them to the sources.
int cover_read_folder(CoverRun *r, CompileInput *in);
// Runs the scripts that cover_read_folder has read.  Scripts that pass and reach their goals count in r->all; edited ones also in r->given.
int cover_run_folder(CoverRun *r);
// Returns the path for a new script: STEM.ss, or with a number if a file has this name that is not stale.
const char *cover_new_path(CoverRun *r, const char *stem);

// ---- cover_output.c ----

typedef struct CoverTotals { unsigned long goals, reached, impossible, not_found; } CoverTotals;

bool cover_is_goal(const CoverRun *r, size_t machine, uint32_t place);
// Counts the goals of a machine.
CoverTotals cover_count(const CoverRun *r, size_t machine);
void cover_write_report(const CoverRun *r, Buf *out);
void cover_write_goals_json(const CoverRun *r, Buf *out);

#endif
