// SPDX-License-Identifier: Apache-2.0
// The paragraphs of the page, by section.  They contain markup (doc.h).  Those with % are formats of format_in: their arguments are listed
// here and checked by the compiler.  Titles of columns are in the tables of page_*.c.
#ifndef SMC_PAGE_TEXT_H
#define SMC_PAGE_TEXT_H

// ---- chapters, in the order in which a review asks ----

#define TEXT_WHAT_IT_DOES         "What it does"
#define TEXT_WHAT_MUST_NOT_HAPPEN "What must never happen, and how we know"
#define TEXT_WHAT_WAS_TESTED      "What was tested, and what was not"
#define TEXT_WHAT_BREAKS_IT       "What breaks it"
#define TEXT_WHAT_IT_COSTS        "What it costs"
#define TEXT_APPENDIX             "Appendix"

#define TEXT_SHARED_VARIABLES \
    "Every machine that reads or writes an element of the state vector. An element that a machine reads and none writes comes from outside: from a " \
    "pin, a message, or a task in C. In a tick, machines run in the order of the columns, and each sees what those before it have stored."
#define TEXT_APP_ALONE \
    "Traceability is on the page of one machine: `smc report` with the file of the machine, its state vector (`--sv`) and its " \
    "bindings (`--bind`)."

#define TEXT_VERDICTS \
    "Passed: examined, and nothing speaks against it. Open: something is missing or has to be decided. " \
    "Failed: something is shown to be wrong."

// ---- outputs ----

#define TEXT_OUTPUTS \
    "What each output is after a step in which the machine stays in the state. Several values: which one depends on conditions or on the path " \
    "to the state. An expression: the step computes the output from it; parts that the state decides are left out. \"Computed\": from more than " \
    "fits here, or in an earlier step. \"Unchanged\": the state does not assign it, so it is what earlier states have left. \"Initial\": no state has assigned it " \
    "yet. Other machines, or a `[start]`, can set other values."

// ---- states ----

#define TEXT_STATES \
    "The machine runs in steps. In each step it executes the statements of its state from top to bottom, also in the step in which " \
    "it enters the state. The first transition whose condition is true is taken, and the statements after it are skipped. The next " \
    "step runs the state to which the transition leads. `T` is the time since the machine entered the state, `G` is the time."
#define TEXT_STATE_EMPTY "This state has no statements: the machine does nothing and stays."
#define TEXT_STATE_EMPTY_OF_ITS_OWN "This state has no statements of its own."

// ---- in all states ----

#define TEXT_ALL_STATES \
    "These statements belong to several states. In each step they run before the statements of the state's own `.step`, in the order of " \
    "the file. A transition ends the step."

// ---- transitions ----

#define TEXT_TRANSITIONS \
    "In the order of the file, which is their priority: if several can be taken in one step, the machine takes the first of them."
#define TEXT_TRANSITIONS_OF_ALL \
    "If several can be taken in one step, the machine takes the first of them: those in `.entry`, then those of all states, then those " \
    "in the state's own `.step`, each in the order of the file."
#define TEXT_TRANSITIONS_NONE "The machine has no transitions: it stays in its first state."

// ---- inputs, outputs and parameters ----

#define TEXT_DEFINITIONS "Names for expressions. A use of the name means the expression, computed where it is used."
#define TEXT_SETTINGS "Values that are set before the machine starts, without compiling it again. The findings are true of every value in the range."
#define TEXT_PARAMETERS "Named values that the machine never changes."
#define TEXT_LOCALS "Variables of the machine. They keep their values from step to step and from state to state."
#define TEXT_WINDOWS \
    "Every window takes a sample at the start of every step, in every state. Until it is full, its statistic covers the samples " \
    "taken so far."

// ---- requirements ----

#define TEXT_REQUIREMENTS \
    "Each requirement is judged after every step of every script in which it could be violated. `Times` is the number of these steps. One " \
    "that was never judged has not been tested, and one that is undecided has not been met."

// ---- proofs ----

#define TEXT_PROOF_SAME "The same lines as for `%s`."      // id of a requirement
#define TEXT_PROOF_CUT "%lu more lines. `smc prove` with the same files prints the whole script; save it as a `.ss` and run it with `smc test`."      // lines

#define TEXT_PROOFS \
    "`smc prove` decides whether any run can violate a requirement. A proof holds for all inputs, NaN and infinities included, with the " \
    "machine's step and the assumptions named. The lines after a proof are what is true after each step in a state. A script shows a " \
    "violation. Without a proof and without a violation, the requirement is only as good as its tests."

#define TEXT_PROOFS_OF_APP \
    "`smc prove` decides the requirements that one machine of the application decides alone. A proof holds whatever the other machines and tasks " \
    "write, in the ticks of the application. A run that violates a requirement is one of this machine alone: the others may never write what it " \
    "needs. What no machine decides alone is only as good as its tests."

// ---- traceability ----

#define TEXT_TRACEABILITY \
    "From requirements to the machine: each mark `@req`. From the machine to requirements: a part has those of its own marks, of the " \
    "conditionals around it, and of its state; a state without a mark has those of the marks inside it. A part without any is code that no " \
    "requirement asks for, or a mark is missing."
#define TEXT_NO_MARKS \
    "No state, transition or statement has a mark `@req`, so this page cannot say which requirement a part of the machine is for. " \
    "`@req R1` after a statement or the header of a state says it."
#define TEXT_NO_ASSERTS_WITH_REQUIREMENTS "No assert names a requirement."

// ---- mutation ----

#define TEXT_MUTATION_EQUIVALENT \
    " Without `--generate`, `smc mutate` can prove this of fewer changes, and counts the others."
#define TEXT_MUTATION \
    "The machine is changed in one place at a time, and all scripts run again. A change that no script notices is a fault that these tests " \
    "would not find. The most dangerous ones come first. On paper, long tables have their first 20 rows, and the inputs that would show a change are left out."
#define TEXT_MUTATION_STOPPED \
    "Stopped before it was complete: only %lu of %lu changes were tried, and the numbers are about these."        // tried, all

// ---- faults and sweeps ----

#define TEXT_FAULTS \
    "Each input is made faulty in each way, beginning in each state and at each transition that the scripts take, and the scripts run again. " \
    "The table has the most dangerous outcome of each input and fault, with its number in the lists below. The name of a requirement: it is " \
    "violated. `-> Abort`: the script ends in this state, and not where it does without the fault. The name of an output: it differs on the " \
    "way, or an assert fails. `no @stop`: the script does not stop. `assert`: only an assert fails. `+2`: two other effects as dangerous, " \
    "with another beginning of the fault. `-`: no effect. An empty cell: the input cannot have this fault. " \
    "Requirements are judged for what the machine reads and for the true values."
#define TEXT_FAULTS_INPUTS \
    "The table has the inputs with the worst outcomes, the worst first. %lu more inputs are left out: the worst of theirs is `%s`." // inputs, outcome
#define TEXT_FAULTS_SCRIPTS "Each numbered script reproduces its line without `smc faults`. It fails as long as the fault has this effect."
#define TEXT_FAULTS_NO_SCRIPTS "With `--scripts=DIR`, `smc report` writes a script for each line, which reproduces it."
#define TEXT_FAULTS_NOTHING "No fault of an input changes an output, a state or a result of the scripts."
#define TEXT_FAULTS_CUT "Not all faults were tried. `smc faults --max-runs=N` tries more."
#define TEXT_FAULTS_NO_REQUIREMENTS \
    "No requirement was judged, because no file of requirements (`.rq`) was named. Asserts of scripts describe a flight without faults, so one " \
    "that fails with a fault does not mean that the machine did something dangerous."
#define TEXT_SWEEP \
    "Each parameter is set to values over its whole range, the others stay as they are, and all scripts run again that do not set it " \
    "themselves. A margin is the distance from the current value of the machine to the nearest value at which something fails. Between neighbouring values with different results, the boundary was " \
    "searched by bisection. Not noticed: nothing fails at any value, so these scripts and requirements do not test the parameter. Only an assert: " \
    "no requirement is violated at the limit, and the assert may be the time line of one script."
#define TEXT_SWEEP_NONE "The machine has no parameter that can be set."
#define TEXT_SWEEP_STOPPED "Stopped before it was complete, so nothing is known of: %s."                // names of parameters
#define TEXT_SWEEP_LEFT_OUT "Left out, because they set the parameter themselves: %s."                  // names of scripts
#define TEXT_SWEEP_ALL_LEFT_OUT "Not changed, because all scripts set the parameter themselves: %s."    // names of scripts

// ---- messages ----

#define TEXT_MESSAGES \
    "What the application exchanges with other computers. A message is stored whole or not at all. Bytes are those on the wire, without " \
    "the headers of UDP or TCP."

// ---- findings ----

#define TEXT_FINDINGS_OPEN "Findings of all groups of warnings. `smc explain` with a name or code prints what a finding means and what to do."
#define TEXT_FINDINGS_ALLOWED "All findings are allowed, each with a reason."
#define TEXT_FINDINGS_OF_FILE "`%s` is also the file of `%s`, and the findings are the same."      // file; machine
#define TEXT_FINDINGS_NONE "The analyses of all groups found nothing."
#define TEXT_STEP_UNKNOWN "The time per step is unknown. With `--step` the analyses find more."
#define TEXT_STEP_DIFFERS \
    "The time per step is unknown, because the scripts do not all have the same `delta_t`. With `--step` the analyses find more."
#define TEXT_STEP_GIVEN "Time advances by %lu per step, the value of `--step`."               // time per step
#define TEXT_STEP_DECLARED "Time advances by %s per step, as the machine declares."          // "20 ms"
#define TEXT_STEP_OF_APP "Time advances in each step of a machine by the period with which the application runs it."
#define TEXT_STEP_OF_SCRIPTS "Time advances by %lu per step, the `delta_t` of the scripts."   // time per step
#define TEXT_FINDING_FIXABLE "`smc fix` can make the edit."

// ---- scripts ----

#define TEXT_COVERAGE \
    "A place is one outcome that a script can show. A transition is one place for each state from which it can be taken: one of all states " \
    "is several places, but one row in the tables of transitions. A guard and a condition are two places each, true and false. Places that no " \
    "run can reach are impossible, and are not counted."
#define TEXT_SEED "The random numbers have the seed %llu."

// ---- abort matrix ----

#define TEXT_ABORT \
    "From which states the machine can abort, and whether it still can if one sensor is dead, stuck or out of range: with commands, " \
    "and without. The steps are the worst case, from the step in which a condition becomes true to the first step of the abort " \
    "state. They do not include the time until the condition is true: \"after `held`\" and \"after its window\" mark conditions that `held` or " \
    "a rolling statistic delays. A counter or a timer delays its condition, too."
#define TEXT_ABORT_CAUSES \
    "The variables that the guards of aborts read. A state that has no `yes` where most others have one does not abort on that. " \
    "Compare it with what the state must do."
#define TEXT_ABORT_UNDECLARED \
    "No state is marked `@abort`, so the report cannot show how this machine aborts. Put the mark after the header of the state " \
    "that handles failures, as in `[Abort] @abort`."
#define TEXT_ABORT_UNBOUNDED \
    "\"Unbounded\": every path from the target state leads to an abort state, but before that the machine can wait for a condition that " \
    "may never become true."

// ---- costs ----

#define TEXT_COSTS \
    "VM instructions in the longest step of each state, computed from the image that flies. No step can take more. The first step of " \
    "a state also runs `.entry`, and a step that leaves the state also runs `.exit`. The cycles are those of the step that takes most cycles, " \
    "which can be another step than the one with most instructions."
#define TEXT_COSTS_SAMPLES \
    "Of each step, %s take the samples of windows. What a sample costs in addition to its instruction depends on the window."    // "5 instructions"
#define TEXT_COSTS_BOARD \
    "The longest step at 16 MHz. This is an estimate: for each instruction it assumes the highest cost that was measured on an " \
    "ATmega328P, for any operands. In tests, real steps took between a third and three quarters of the estimate. It is not proved that " \
    "no step can take longer. The cost of emitted C depends on the compiler and is not estimated."
#define TEXT_COSTS_MEMORY \
    "RAM of this machine on the VM of a 64-bit computer. A board with shorter pointers needs slightly less. The state vector is shared " \
    "with the application and is not included."

// ---- scripts ----

#define TEXT_SCRIPTS_NONE "No script was run. Name scripts after the machine, as in `smc report tank.sm tank.ss`."
#define TEXT_COVERED_ALL "Nothing: the scripts visit every state and take every transition."
#define TEXT_COVERED_ALL_EDGES "The scripts visit every state and go from each state to every state to which its transitions lead."
#define TEXT_SHARED \
    "If several transitions lead from one state to another, a run does not show which of them was taken:%s. Some of them may never " \
    "have been taken."                                          // " from ^A^ to ^B^ (lines 3, 5), from …"

// ---- source ----

#define TEXT_STATE_VECTOR "The elements that this machine lists are described above. The rest of the state vector is not part of this report."

#endif
