// SPDX-License-Identifier: Apache-2.0
// The files of a script: those that it includes, and itself (language.md 8.27 to 8.30).
#ifndef SMC_SOURCE_FILES_H
#define SMC_SOURCE_FILES_H

#include "compiler/session.h"

// The files in the order in which their sections run: an included file precedes the file that includes it, so the script itself is the last.
typedef struct ScriptFiles {
    const Source **at;
    const Span *include;      // by file: the line of the script itself that includes the file, directly or through others
    size_t n;
} ScriptFiles;

// Finds the files of a script with s->finder.  Reports files that cannot be found and cycles, unless `is_silent`; the list then lacks them.
ScriptFiles session_script_files(Session *s, const Source *script, bool is_silent);

#endif
