// SPDX-License-Identifier: Apache-2.0
// libsmc: the compiler, its reports and its machines as a C library.  docs/library.md has whole programs in C, C++, Python, Rust and C#.
//
//     SmcSession *s;
//     uint32_t tank;
//     SmcMachine m;
//     if (smc_open(NULL, 0, &s) != SMC_OK)
//         fail();
//     smc_source_add(s, SMC_KIND_SM, "tank.sm", text, size, &tank);
//     if (smc_compile(s) == SMC_OK && smc_machine_open(s, tank, &m) == SMC_OK)
//         smc_machine_step(s, m, 10);
//     for (uint32_t i = 0; i < smc_diag_count(s); i++)
//         show(smc_diag_message(s, i));
//     smc_close(s);
//
// The library opens no file, prints nothing, never exits and has no global state.  Numbers look the same in every locale.  If it
// finds that one of its own passes has broken a program, which is a bug of smc, it returns SMC_E_INTERNAL rather than a wrong program.
//
// **Threads.**  Any number of threads can call it at once, each with sessions of its own.  Only smc_cancel may be called while another thread
// uses the session.  A call uses up to 1 MB of stack (x86-64; conditionals nested 2000 levels deep).
//
// **Stability.**  A program that is compiled with one version runs with every later one of the same SMC_API_VERSION.  Functions and constants are
// only added.  Handle an unknown value of a list, such as a new kind of source, as "other".
//
// **Bad input.**  Every function checks its arguments.  What it returns is one of these, unless its description says otherwise:
//
//   - a function of type SmcResult: SMC_E_ARGUMENT if a pointer is NULL or a value is not in its list, SMC_E_HANDLE if `s` is not an open
//     session or `m` is not an open machine of it, SMC_E_INDEX if no item has that number or name.  Then no result is stored.
//   - a function that returns a text: "".  One that returns a number: 0.
//
// Only a pointer to memory that the program has freed, or that is shorter than it says, is undefined.  A session that was closed is freed memory,
// unless the program provided its memory.
//
// **Texts** end with a NUL.  They are UTF-8, unless a name that the program passed is not.  Every pointer that a function returns or stores belongs
// to the session, and is valid until the next smc_close, smc_compile, smc_emit, smc_run, smc_report, or smc_source_* call that changes something.
// Exceptions:
//
//   - smc_render, smc_apply_edits and smc_diagram each store one text, which is also valid only until the next call of the same function;
//   - smc_error_text: until the next call that does not return SMC_OK;
//   - smc_swap_item_name: until the next smc_swap_compare or smc_machine_continue that returns SMC_OK, or smc_close;
//   - texts and the state vector of a machine: until smc_machine_close, however often the session compiles, or smc_close.
//
// **Memory**: The session stores one result of each kind, so repeated calls do not use more and more memory.  A function that runs out of memory
// returns SMC_E_MEMORY, and the session stays usable.  After smc_compile ran out of memory, nothing is compiled; after any other function,
// everything is as before the call.
#ifndef SMC_H
#define SMC_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif
#ifdef SMC_LIBRARY            // defined while the library is built, which exports these functions
#pragma GCC visibility push(default)
#endif

#define SMC_API_VERSION 1

// ---- results ----

// Values of the enumerations below are passed as int32_t or uint32_t, so the size of an enumeration does not matter.
typedef int32_t SmcResult;
enum SmcResultCode {
    SMC_OK = 0,
    SMC_E_ARGUMENT = -1,          // a pointer is NULL, or a value is not in its list
    SMC_E_HANDLE = -2,            // no open session, or no open machine of this session
    SMC_E_MEMORY = -3,            // out of memory, or beyond the limit of smc_open
    SMC_E_STATE = -4,             // the session has not compiled what the call needs
    SMC_E_SOURCE = -5,            // the sources have errors, which the diagnostics describe
    SMC_E_INDEX = -6,             // no item has this number or name
    SMC_E_SIZE = -7,              // a size is not that of the value, or exceeds a limit
    SMC_E_IMAGE = -8,             // the bytes are no image that a VM can run: smc_error_text has the reason
    SMC_E_REFUSED = -9,           // G did not advance, or a swap is not allowed here; nothing has changed
    SMC_E_FAILED = -10,           // a script ran and did not pass: smc_run_outcome
    SMC_E_CANCELLED = -11,        // smc_cancel ended the call
    SMC_E_BUSY = -12,             // another call of this session has not returned
    SMC_E_INTERNAL = -13          // smc has a bug: smc_error_text names the pass.  The session is as after SMC_E_MEMORY
};

// The sentence of a result: "out of memory"; "unknown result" for an unknown number.  Static.
const char *smc_result_text(SmcResult result);
// SMC_API_VERSION of the library that runs.
uint32_t smc_api_version(void);
// The version of smc, such as "0.1.0".  Static.
const char *smc_version(void);

// ---- sessions ----

typedef struct SmcSession SmcSession;

// Opens a session and stores it in *s.  If `memory` is NULL, the session takes its memory from malloc, at most `size` bytes; a size of 0 is no
// limit.  Otherwise it uses only the `size` bytes at `memory`, which must stay valid until smc_close.  A small machine takes about 200 KB to
// compile, and 500 KB with its report.
// SMC_E_MEMORY: that is not enough for an empty session.
SmcResult smc_open(void *memory, uint64_t size, SmcSession **s);
// Closes the session and its machines, and frees its memory.
SmcResult smc_close(SmcSession *s);
// A sentence about the last call that did not return SMC_OK, more precise than smc_result_text where there is more to say.
const char *smc_error_text(const SmcSession *s);
// The bytes that the session uses now, and the most that it has used so far.
uint64_t smc_memory_used(const SmcSession *s);
uint64_t smc_memory_peak(const SmcSession *s);
// With `on` 1, the call that compiles, runs, draws or renders something now returns SMC_E_CANCELLED soon; if none runs, the next one does.
// 0 withdraws that.  Any thread can call it at any time before smc_close, and so can a signal handler.
SmcResult smc_cancel(SmcSession *s, int32_t on);

// ---- sources ----

enum SmcKind {    // a kind of source; later versions can have more
    SMC_KIND_SV = 0,              // a state vector, .sv
    SMC_KIND_SM = 1,              // a machine, .sm
    SMC_KIND_SS = 2,              // a state script, .ss
    SMC_KIND_IO = 3,              // pins, .io
    SMC_KIND_APP = 4,             // an application, .app; it comes with the files that it names
    SMC_KIND_NET = 5,             // messages, .net
    SMC_KIND_RQ = 6,              // requirements, .rq
    SMC_KIND_DATA = 7             // recorded data that scripts read: CSV, of any name.  The library opens no file
};

// Adds a source of `size` bytes, which are copied, and stores its number in *source: 0, 1, 2 …, or that of a removed source.  Diagnostics show
// `name`, which can be a path.
// The file name in it, without folders and suffix, names what is generated.  An application finds its files by their names, written as in
// the application.  A script finds the scripts that it includes by their names, which are paths relative to the folder in its own name.  A
// script that another one includes does not run by itself.  A script finds its recorded data in the same way, as a source of SMC_KIND_DATA.  `text`
// can be NULL if `size` is 0.
// SMC_E_ARGUMENT: the name is empty, or contains a control character.  SMC_E_SIZE: the text is longer than 1 GB.
SmcResult smc_source_add(SmcSession *s, int32_t kind, const char *name, const char *text, uint64_t size, uint32_t *source);
// Replaces the text of a source, which keeps its number, its name and its place in the order of machines.  What was compiled stays as it is until
// the next smc_compile: diagnostics with their places, outputs and runs are those of the compiled text, not of the new one.
SmcResult smc_source_replace(SmcSession *s, uint32_t source, const char *text, uint64_t size);
// Removes a source.  The others keep their numbers, and a later smc_source_add uses its number again.  What was compiled stays as it is until the
// next smc_compile, as after smc_source_replace.  Machines stay open.
SmcResult smc_source_remove(SmcSession *s, uint32_t source);
// Makes a script one of this machine, from the next smc_compile on.  Where there is exactly one machine, each script is one of it without this call.
// Removing the machine ends that.  SMC_E_ARGUMENT: `script` is not SMC_KIND_SS, or `machine` is not SMC_KIND_SM.
SmcResult smc_script_assign(SmcSession *s, uint32_t script, uint32_t machine);
// Removes all sources, and everything that was compiled from them.  Machines stay open.
SmcResult smc_sources_clear(SmcSession *s);
// One more than the largest number that a source has had since smc_open or smc_sources_clear.  smc_source_kind is -1 where one was removed.
uint32_t smc_source_count(const SmcSession *s);
const char *smc_source_name(const SmcSession *s, uint32_t source);
int32_t smc_source_kind(const SmcSession *s, uint32_t source);       // -1: there is no such source

// ---- options ----

enum SmcOption {
    SMC_OPTION_LEVEL = 0,         // of optimisation: 0, 1 or 2; initially 2.  Scripts and machines have the level of smc_compile
    SMC_OPTION_STEP = 1,          // by how much G advances in a step, for warnings about machines outside applications; 0: the step that the
                                  //   machine declares, or else the delta_t of its scripts, if all have the same.  A machine that declares
                                  //   another step has an error
    SMC_OPTION_MAX_RAM = 2,       // limits of a machine on the VM, which must not be exceeded: bytes of RAM,
    SMC_OPTION_MAX_STEP = 3,      //   instructions of the longest step,
    SMC_OPTION_MAX_CYCLES = 4,    //   cycles of the longest step on an ATmega328P.  0: no limit
    SMC_OPTION_NAMES = 5,         // 1: images contain names and lines, as with smc build -g
    SMC_OPTION_SOFT = 6,          // 1: C for chips whose double is not a binary64, as with --soft
    SMC_OPTION_RUNTIME = 7,       // 1: C for the flight runtime, as with --runtime
    SMC_OPTION_TRACK = 8,         // 1: C whose machine records which elements a step stored, as with --track-stores
    SMC_OPTION_WARNINGS = 9,      // 0: no warnings, as with -w; initially 1
    SMC_OPTION_REVIEW = 10,       // 1: smc_compile also does what smc_report needs: it searches for everything that any warning finds
    SMC_OPTION_TRACE = 11         // 1: smc_run records smc_run_trace
};

// Sets an option for the calls that follow.  SMC_E_ARGUMENT: there is no such option, or it cannot have this value.
SmcResult smc_option_set(SmcSession *s, int32_t option, uint64_t value);
uint64_t smc_option(const SmcSession *s, int32_t option);
// Sets the prefix of every name in C; "": the name of the machine.  SMC_E_ARGUMENT: it is no valid prefix, and smc_error_text has the reason.
SmcResult smc_prefix_set(SmcSession *s, const char *prefix);

// Selects warnings as an option -W does, given without the -W: "flight", "no-dead-code", "error=output-left-on".  Later words override earlier
// ones.  SMC_E_ARGUMENT: no warning has this name; smc_error_text proposes one.
SmcResult smc_warning_select(SmcSession *s, const char *word);
SmcResult smc_warnings_reset(SmcSession *s);      // forgets the words

// All warnings: their names as after -W, their groups ("all", "extra", "flight"), and what each finds.  Static.
uint32_t smc_warning_count(void);
const char *smc_warning_name(uint32_t warning);
const char *smc_warning_group(uint32_t warning);
const char *smc_warning_sentence(uint32_t warning);
// The page of a diagnostic, by its code or its name: "E0204", "unused-element".  Static.
const char *smc_explain(const char *code);

// ---- compiling ----

// Compiles all sources, in the order of their numbers: checks them, and searches for what the selected warnings find.  An application is
// compiled with the files that it names.
// Without one, a state vector is that of every machine and of the pins, pins are checked against it, and scripts are those of the one machine
// or of the machine that smc_script_assign named.  Other scripts are only parsed.  Requirements are those of the one machine: smc_run judges
// them after each step of its scripts, and a violation ends the script as failed.  With several machines they are only parsed.
// SMC_E_SOURCE: there are errors, or warnings that are selected as errors.  What has none of its own is compiled nevertheless.
// SMC_E_STATE: the sources do not fit together (two applications, two state vectors, or two .io files); smc_error_text has the reason.
SmcResult smc_compile(SmcSession *s);

// The files that the compiled application names: those that it needs as sources, also those of which the session has no source.  So compile an
// application alone, add these files, and compile again.  The name is written as in the application.  SMC_KIND_…; -1: there is no such file.
uint32_t smc_app_file_count(const SmcSession *s);
const char *smc_app_file_name(const SmcSession *s, uint32_t file);
int32_t smc_app_file_kind(const SmcSession *s, uint32_t file);

enum SmcEmit {    // what smc_emit generates
    SMC_EMIT_IMAGE = 1,           // one image of all machines, with the pins
    SMC_EMIT_ARRAY = 2,           // the image of SMC_EMIT_IMAGE as a C array
    SMC_EMIT_C = 3,               // C of each machine, state vector and pins; of an application, all its parts
    SMC_EMIT_IR = 4,              // for developers of smc: the optimised IR, the syntax tree, and the tokens, as text
    SMC_EMIT_AST = 5,
    SMC_EMIT_TOKENS = 6
};

// Generates output files in memory, in place of those of the last smc_emit, also if there are errors.  It needs an smc_compile without errors,
// except for SMC_EMIT_AST and SMC_EMIT_TOKENS; else SMC_E_STATE.  SMC_E_SOURCE: there are new errors, for example because the image is too large.
SmcResult smc_emit(SmcSession *s, int32_t what);
uint32_t smc_output_count(const SmcSession *s);
const char *smc_output_name(const SmcSession *s, uint32_t output);        // its default file name: "tank.smb", "tank.h"
// Stores the address and the size of an output file.
SmcResult smc_output(const SmcSession *s, uint32_t output, const void **bytes, uint64_t *size);

// ---- diagnostics ----
//
// The diagnostics of the last smc_compile, then those of the last smc_emit and of the last run of each script since.  They are numbered from 0.
// Warnings that an @allow covers follow after smc_diag_count, smc_diag_allowed_count of them.

enum SmcSeverity { SMC_SEVERITY_ERROR = 0, SMC_SEVERITY_WARNING = 1, SMC_SEVERITY_NOTE = 2 };

uint32_t smc_diag_count(const SmcSession *s);
uint32_t smc_diag_allowed_count(const SmcSession *s);
int32_t smc_diag_severity(const SmcSession *s, uint32_t diag);            // -1: there is no such diagnostic
const char *smc_diag_code(const SmcSession *s, uint32_t diag);            // "E0204"
const char *smc_diag_warning(const SmcSession *s, uint32_t diag);         // the name after -W: "unused-element"; "" for an error
const char *smc_diag_message(const SmcSession *s, uint32_t diag);
const char *smc_diag_label(const SmcSession *s, uint32_t diag);           // what text output prints beside the underlined characters; or ""
const char *smc_diag_allowed(const SmcSession *s, uint32_t diag);         // the reason of the @allow that covers it; or ""

// Its notes.  A step above 0 is the position of the note on the path that leads to the finding.
uint32_t smc_diag_note_count(const SmcSession *s, uint32_t diag);
const char *smc_diag_note(const SmcSession *s, uint32_t diag, uint32_t note);
uint32_t smc_diag_note_step(const SmcSession *s, uint32_t diag, uint32_t note);

// The edits that fix it: each replaces the characters at its place.  They belong together.
uint32_t smc_diag_edit_count(const SmcSession *s, uint32_t diag);
const char *smc_diag_edit(const SmcSession *s, uint32_t diag, uint32_t edit);

enum SmcPart { SMC_PART_DIAG = 0, SMC_PART_NOTE = 1, SMC_PART_EDIT = 2 };
enum SmcColumn { SMC_COLUMN_BYTES = 0, SMC_COLUMN_UTF16 = 1 };
enum SmcPlace {    // what smc_diag_place returns
    SMC_PLACE_SOURCE = 0,         // number of the source
    SMC_PLACE_LINE = 1,           // lines and columns count from 1
    SMC_PLACE_COLUMN = 2,
    SMC_PLACE_END_LINE = 3,       // the end is after the last character
    SMC_PLACE_END_COLUMN = 4,
    SMC_PLACE_OFFSET = 5,         // in bytes, from 0
    SMC_PLACE_LENGTH = 6          // in bytes
};

// Returns one number of the place of a diagnostic, or of its note or edit number `item`.  `columns`: how columns are counted; a byte that is
// not UTF-8 counts as one.  -1: the diagnostic is about no source, or an argument is not valid.
int64_t smc_diag_place(const SmcSession *s, uint32_t diag, int32_t part, uint32_t item, int32_t place, int32_t columns);

enum SmcRender { SMC_RENDER_TEXT = 0, SMC_RENDER_COLOR = 1, SMC_RENDER_JSON = 2, SMC_RENDER_SARIF = 3 };

// Stores all diagnostics as smc prints them: as text, as text with colours for a terminal, as one JSON object per line, as a SARIF 2.1.0 document.
SmcResult smc_render(SmcSession *s, int32_t form, const char **text, uint64_t *size);
// Stores the text of a source with all edits applied, as smc fix writes it, and how many diagnostics were fixed.
SmcResult smc_apply_edits(SmcSession *s, uint32_t source, const char **text, uint64_t *size, uint32_t *fixed);

// ---- running scripts ----

enum SmcEngine {    // engines; add them to run several in lock step
    SMC_ENGINE_VM = 1,            // the VM that flies
    SMC_ENGINE_REF = 2,           // the reference interpreter
    SMC_ENGINE_VM_SOFT = 4        // the VM with soft numbers, as on a chip without binary64
};
enum SmcOutcome {
    SMC_OUTCOME_NONE = 0,         // it has not run
    SMC_OUTCOME_PASSED = 1,
    SMC_OUTCOME_FAILED = 2,       // an assert was false
    SMC_OUTCOME_ENDLESS = 3,      // it did not stop within the limit of steps
    SMC_OUTCOME_TIME_OVER = 4,    // G cannot advance any further
    SMC_OUTCOME_BROKEN = 5,       // an engine failed
    SMC_OUTCOME_DIFFERENT = 6     // two engines disagree
};

enum SmcRequirement {
    SMC_REQUIREMENT_UNJUDGED = 0, // no step could have violated it
    SMC_REQUIREMENT_MET = 1,
    SMC_REQUIREMENT_VIOLATED = 2, // then the run has ended, as SMC_OUTCOME_FAILED
    SMC_REQUIREMENT_UNDECIDED = 3 // it was still open when the run ended
};

// The requirements of a compiled machine, in the order of their files.  0, or "", if the machine has no requirements.
uint32_t smc_requirement_count(const SmcSession *s, uint32_t machine);
const char *smc_requirement_id(const SmcSession *s, uint32_t machine, uint32_t requirement);
const char *smc_requirement_text(const SmcSession *s, uint32_t machine, uint32_t requirement);

// Runs a script on its compiled machine for at most `max_steps` steps; 0: 1,000,000.  SMC_OK: it passed.  SMC_E_FAILED: it did not.  Its
// diagnostics replace those of its last run.  A run with the same engines and limits as the last one is not repeated.
// SMC_E_SOURCE: the script or the machine has errors.  SMC_E_STATE: nothing is compiled, or the script has no machine
// (smc_script_assign).  SMC_E_INDEX: there is no script of this number, or another script includes it.
SmcResult smc_run(SmcSession *s, uint32_t script, uint32_t engines, uint64_t max_steps);
int32_t smc_run_outcome(const SmcSession *s, uint32_t script);
uint64_t smc_run_steps(const SmcSession *s, uint32_t script);
uint64_t smc_run_asserts(const SmcSession *s, uint32_t script);       // how many asserts passed
// What a run found about a requirement of the script's machine, by its number among smc_requirement_count.  SMC_REQUIREMENT_UNJUDGED also if
// there is no such run or requirement.
int32_t smc_run_requirement(const SmcSession *s, uint32_t script, uint32_t requirement);
uint64_t smc_run_judged(const SmcSession *s, uint32_t script, uint32_t requirement);  // in how many steps it was judged
const char *smc_run_report(const SmcSession *s, uint32_t script);     // the report that smc test prints
// CSV with a row for each step, as smc test --trace writes it; "" unless SMC_OPTION_TRACE was set.
const char *smc_run_trace(const SmcSession *s, uint32_t script);

// ---- diagrams and reports ----

enum SmcDiagram { SMC_DIAGRAM_SVG = 0, SMC_DIAGRAM_DOT = 1, SMC_DIAGRAM_MERMAID = 2 };
enum SmcReport { SMC_REPORT_HTML = 0, SMC_REPORT_TEXT = 1, SMC_REPORT_JSON = 2 };

// Stores the state diagram of a compiled machine, with a mark at each finding, and with the counts of the scripts that have run.
// SMC_E_STATE: the machine is not compiled, or has errors.
SmcResult smc_diagram(SmcSession *s, uint32_t machine, int32_t form, const char **text, uint64_t *size);
// Stores the page for a design review, as smc report writes it.  Scripts that have not run are run for it, and
// have run even if it then fails.
// SMC_E_STATE: the machine is not compiled, there are errors, there are several machines, or SMC_OPTION_REVIEW was not set when it was compiled.
SmcResult smc_report(SmcSession *s, uint32_t machine, int32_t form, const char **text, uint64_t *size);

// ---- the structure of a compiled machine ----
//
// What the last smc_compile found in a source that is a machine, also one of an application.  A source that is none, or has errors, has no states,
// transitions, variables or uses.  States have the numbers that S has, from 1; transitions are in the order of the states, and of the statements
// that a state runs.  Lines count from 1.
//
// A statement of [all_states] belongs to every state where the section runs: a transition there is one from each of these states, all with the
// same line.  A definition is no item: a state that uses it reads what its expression reads.

enum SmcBlock { SMC_BLOCK_ENTRY = 0, SMC_BLOCK_STEP = 1, SMC_BLOCK_EXIT = 2 };
enum SmcAccess { SMC_ACCESS_READ = 1, SMC_ACCESS_WRITE = 2 };

uint32_t smc_model_state_count(const SmcSession *s, uint32_t machine);
const char *smc_model_state_name(const SmcSession *s, uint32_t machine, uint32_t state);
uint32_t smc_model_state_marks(const SmcSession *s, uint32_t machine, uint32_t state);     // a sum of SMC_MARK_…
uint32_t smc_model_state_line(const SmcSession *s, uint32_t machine, uint32_t state);      // the line of its header; 0: there is no such state

uint32_t smc_model_transition_count(const SmcSession *s, uint32_t machine);
uint32_t smc_model_transition_from(const SmcSession *s, uint32_t machine, uint32_t transition);      // 0: there is no such transition
uint32_t smc_model_transition_to(const SmcSession *s, uint32_t machine, uint32_t transition);        // 0: there is no such transition
int32_t smc_model_transition_block(const SmcSession *s, uint32_t machine, uint32_t transition);      // SMC_BLOCK_…; -1: no such transition
uint32_t smc_model_transition_line(const SmcSession *s, uint32_t machine, uint32_t transition);      // 0: there is no such transition
// The conditions around it, as diagrams show them: "pressure > 800 and not (valveOpen)"; "" if it is unconditional.  At most the four innermost.
const char *smc_model_transition_guard(const SmcSession *s, uint32_t machine, uint32_t transition);

// The variables, without T (the time in the state).  A machine that smc_machine_open starts numbers them the same way, but has the constants
// after all others.
uint32_t smc_model_variable_count(const SmcSession *s, uint32_t machine);
const char *smc_model_variable_name(const SmcSession *s, uint32_t machine, uint32_t variable);
int32_t smc_model_variable_type(const SmcSession *s, uint32_t machine, uint32_t variable);           // SMC_TYPE_…; -1: no such variable
int32_t smc_model_variable_kind(const SmcSession *s, uint32_t machine, uint32_t variable);           // SMC_VARIABLE_…; -1: no such variable
uint32_t smc_model_variable_line(const SmcSession *s, uint32_t machine, uint32_t variable);          // 0: there is no such variable

// Which state reads or writes which variable: one item for each pair, sorted by state, then by variable.  What a window samples is read by the
// states that read the window.
uint32_t smc_model_use_count(const SmcSession *s, uint32_t machine);
uint32_t smc_model_use_state(const SmcSession *s, uint32_t machine, uint32_t use);         // 0: there is no such item
int64_t smc_model_use_variable(const SmcSession *s, uint32_t machine, uint32_t use);       // -1: there is no such item
uint32_t smc_model_use_access(const SmcSession *s, uint32_t machine, uint32_t use);        // a sum of SMC_ACCESS_…; 0: no such item

// ---- machines ----
//
// A machine that runs on the VM, with a state vector of its own.  It does not depend on what the session compiles later.

typedef uint64_t SmcMachine;      // 0 is never a machine; no number is used twice by a session

// Starts a compiled machine in its first state.  SMC_E_STATE: it is not compiled, or has errors.
SmcResult smc_machine_open(SmcSession *s, uint32_t source, SmcMachine *m);
// Starts machine `number`, counted from 0, of an image, which is verified and copied.  Its variables have names only if the image has
// (SMC_OPTION_NAMES, smc build -g).  SMC_E_IMAGE: the verifier refuses it.  SMC_E_INDEX: it has no such machine.
// SMC_E_SIZE: it is longer than any image can be.
SmcResult smc_machine_open_image(SmcSession *s, const void *image, uint64_t size, uint32_t number, SmcMachine *m);
// Stores how many machines an image has; at least 1.  SMC_E_IMAGE: the verifier refuses it.  SMC_E_SIZE: it is longer than any image can be.
SmcResult smc_image_machine_count(SmcSession *s, const void *image, uint64_t size, uint32_t *count);
SmcResult smc_machine_close(SmcSession *s, SmcMachine m);

// Starts the machine again in state `state`, 1 to smc_machine_state_count: the state vector is zero, locals have their initial values, windows
// are empty.  SMC_E_INDEX: there is no such state.
SmcResult smc_machine_start(SmcSession *s, SmcMachine m, uint32_t state);
// Sets G to `g` and runs a step.  SMC_E_REFUSED: g is not above that of the last step.
SmcResult smc_machine_step(SmcSession *s, SmcMachine m, uint64_t g);
// The name of the machine, which is that of its file without the suffix; "" if its image has no names.
const char *smc_machine_name(const SmcSession *s, SmcMachine m);
uint32_t smc_machine_state(const SmcSession *s, SmcMachine m);            // the state that the next step runs, from 1
uint32_t smc_machine_state_count(const SmcSession *s, SmcMachine m);
const char *smc_machine_state_name(const SmcSession *s, SmcMachine m, uint32_t state);
// SWAP: the state is marked @swap or @safe.  FINAL: no transition leads to another state; only smc_model_state_marks returns it.
enum SmcMark { SMC_MARK_SAFE = 1, SMC_MARK_ABORT = 2, SMC_MARK_SWAP = 4, SMC_MARK_FINAL = 8 };
uint32_t smc_machine_state_marks(const SmcSession *s, SmcMachine m, uint32_t state);       // a sum of these; without names no ABORT
uint64_t smc_machine_time(const SmcSession *s, SmcMachine m);             // T

enum SmcType {    // types, with the numbers that images use
    SMC_TYPE_I8 = 0, SMC_TYPE_I16 = 1, SMC_TYPE_I32 = 2, SMC_TYPE_I64 = 3, SMC_TYPE_U8 = 4, SMC_TYPE_U16 = 5, SMC_TYPE_U32 = 6, SMC_TYPE_U64 = 7,
    SMC_TYPE_F32 = 8, SMC_TYPE_F64 = 9, SMC_TYPE_BOOL = 10
};
// CONSTANT: a local that never changes, only in smc_model_variable_kind.
enum SmcVariableKind { SMC_VARIABLE_ELEMENT = 0, SMC_VARIABLE_LOCAL = 1, SMC_VARIABLE_CONSTANT = 2 };

// The elements that the machine lists, by their names in the state vector, and its locals that are not constants.  Sorted by name.
uint32_t smc_machine_variable_count(const SmcSession *s, SmcMachine m);
SmcResult smc_machine_find(const SmcSession *s, SmcMachine m, const char *name, uint32_t *variable);
const char *smc_machine_variable_name(const SmcSession *s, SmcMachine m, uint32_t variable);
int32_t smc_machine_variable_type(const SmcSession *s, SmcMachine m, uint32_t variable);       // -1: there is no such variable
int32_t smc_machine_variable_kind(const SmcSession *s, SmcMachine m, uint32_t variable);       // -1: there is no such variable
// Its offset in bytes in the state vector, or among the locals.
uint32_t smc_machine_variable_offset(const SmcSession *s, SmcMachine m, uint32_t variable);
// 1: the last step stored this element; 0: it did not, or the variable is no output.
int32_t smc_machine_variable_stored(const SmcSession *s, SmcMachine m, uint32_t variable);

// The value as a machine reads and stores it (language.md 2): a stored NaN reads as 0; a number beyond an integer type becomes its limit.
// A parameter (language.md 5.77) is a local.  It can be set before the first step, within its range: SMC_E_ARGUMENT otherwise, with the reason in
// smc_error_text, and nothing has changed.  smc_machine_start returns it to the value in the image.
SmcResult smc_machine_get(const SmcSession *s, SmcMachine m, uint32_t variable, double *value);
SmcResult smc_machine_set(SmcSession *s, SmcMachine m, uint32_t variable, double value);
// The value in its own type, such as an int16_t for I16; a bool is one byte.  SMC_E_SIZE: `size` is not that of the type.
SmcResult smc_machine_read(const SmcSession *s, SmcMachine m, uint32_t variable, void *value, uint32_t size);
SmcResult smc_machine_write(SmcSession *s, SmcMachine m, uint32_t variable, const void *value, uint32_t size);

// Runs `rows` steps on columns: arrays with one value for each step.  Step i, from 0:
//
//   1. stores in variable input[k] the value from[k][i], like smc_machine_set, for k from 0 to inputs - 1;
//   2. sets G to g[i] and runs a step;
//   3. copies variable output[k] to to[k][i], like smc_machine_get, for k from 0 to outputs - 1, and the state to states[i], like
//      smc_machine_state.  `states` can be NULL.
//
// A column has room for `rows` values.  A column of outputs can be the same array as one of inputs.  *done is set to the number of steps that have
// run; the rows from there on are not written.  A machine that has run is in the same state as one that has been stepped, and continues from there.
// SMC_E_REFUSED: g[*done] is not above G of the last step.  SMC_E_CANCELLED: smc_cancel ended the run.  In both cases, the steps before are complete.
// SMC_E_ARGUMENT: a needed pointer or a column is NULL, or G or a parameter is an input.  SMC_E_INDEX: there is no variable of one of the numbers.
// SMC_E_SIZE: no array can have so many rows.  SMC_E_MEMORY: a run needs 16 bytes for each column.  With these four, *done is 0 and no step has run.
SmcResult smc_machine_run(SmcSession *s, SmcMachine m, uint64_t rows, const uint64_t *g, uint32_t inputs, const uint32_t *input,
                          const double *const *from, uint32_t outputs, const uint32_t *output, double *const *to, uint32_t *states, uint64_t *done);

enum SmcInfo {
    SMC_INFO_VECTOR = 0,          // bytes of the state vector
    SMC_INFO_LAYOUT = 1,          // the hash of its layout: machines run only on a vector of the same hash
    SMC_INFO_MEMORY = 2,          // bytes of memory that the VM needs for the machine
    SMC_INFO_DECODED = 3,         // bytes of memory for its decoded form
    SMC_INFO_IMAGE = 4,           // bytes of its image
    SMC_INFO_LONGEST_STEP = 5     // instructions of the longest step
};
uint64_t smc_machine_info(const SmcSession *s, SmcMachine m, int32_t what);
// The state vector: SMC_INFO_VECTOR bytes, which the program can read and write between two calls.  NULL: there is no such machine.
void *smc_machine_vector(SmcSession *s, SmcMachine m);

// ---- swaps: one machine continues where another one is (docs/swapping.md) ----

// Lets `to` continue where `from` is: `to` receives the state vector, and the state, T, locals and samples that both have by name.  `from` does
// not change.  Both need names.  Stores the same list as smc_swap_compare.
// SMC_E_REFUSED: the layouts differ, an image has no names, `from` is in a state that is marked neither @swap nor @safe, or `to` has no state of
// that name; smc_error_text has the reason.  SMC_E_ARGUMENT: they are the same machine.
SmcResult smc_machine_continue(SmcSession *s, SmcMachine from, SmcMachine to);
// Lists what `to` would keep of `from`, whatever state `from` is in.  The list replaces that of the last call.  Neither machine changes.  Errors are
// those of smc_machine_continue.
SmcResult smc_swap_compare(SmcSession *s, SmcMachine from, SmcMachine to);

enum SmcSwapKind { SMC_SWAP_STATE = 0, SMC_SWAP_LOCAL = 1, SMC_SWAP_WINDOW = 2 };
enum SmcSwapFate {
    SMC_SWAP_KEPT = 0,            // both machines have the variable
    SMC_SWAP_ADDED = 1,           // only `to` has the variable: a local begins at its initial value, a window empty
    SMC_SWAP_REMOVED = 2,         // only `from` has the variable or state.  While `from` is in a removed state, `to` cannot continue
    SMC_SWAP_CHANGED = 3          // both have the variable, with different types: it begins as if only `to` had it
};

// The list of the last smc_swap_compare or smc_machine_continue that returned SMC_OK: states, locals and windows of `to`, then those that only
// `from` has.  Elements of the state vector are not listed, because all are kept.  The list remains valid after the machines are closed.
uint32_t smc_swap_item_count(const SmcSession *s);
int32_t smc_swap_item_kind(const SmcSession *s, uint32_t item);           // -1: there is no such item
int32_t smc_swap_item_fate(const SmcSession *s, uint32_t item);           // -1: there is no such item
const char *smc_swap_item_name(const SmcSession *s, uint32_t item);       // "Hold", "count", "roll(tankPressure + 1, 10)"
// What a fate means, as a sentence; "" for an unknown fate.  Static.
const char *smc_swap_fate_text(int32_t fate);

#ifdef SMC_LIBRARY
#pragma GCC visibility pop
#endif
#ifdef __cplusplus
}
#endif
#endif
