// SPDX-License-Identifier: Apache-2.0
// Several threads compile, run and draw at the same time, each with its own session, with the same results as one thread.  One thread cancels
// another.
#include <pthread.h>
#include <stdlib.h>
#include <string.h>

#include "compiler/library/smc.h"
#include "tests/test.h"

enum { THREADS = 4, ROUNDS = 6 };

static const char machine[] = "[state_vector]\nU64 G\nU32 S\nF64 p\nbool v\n[local]\nU32 n = 0\n[A]\n.step\n    n = n + 1\n    v = roll_median(p, 9) > 5\n    T > 100: -> B\n[B]\n.step\n    v = false\n    T > 50: -> A\n";
static const char endless[] = "[options]\ndelta_t 1\n[all_states]\nG < 0: @stop\n";

typedef struct Output { char *text; uint64_t size; } Output;

static Output produce(int number)
{
    SmcSession *s;
    uint32_t sm;
    const char *text;
    Output out = {NULL, 0};

    if (smc_open(NULL, 0, &s) != SMC_OK)
        return out;
    smc_option_set(s, SMC_OPTION_REVIEW, 1);
    smc_option_set(s, SMC_OPTION_STEP, (uint64_t)number + 1);
    smc_source_add(s, SMC_KIND_SM, "a.sm", machine, strlen(machine), &sm);
    if (smc_compile(s) == SMC_OK && smc_report(s, sm, SMC_REPORT_HTML, &text, &out.size) == SMC_OK && (out.text = malloc((size_t)out.size)) != NULL)
        memcpy(out.text, text, (size_t)out.size);
    smc_close(s);
    return out;
}

static Output expected[THREADS];

static void *work(void *argument)
{
    const int number = (int)((Output *)argument - expected);
    int equal = 0;

    for (int i = 0; i < ROUNDS; i++) {
        const Output out = produce(number);
        equal += out.text && out.size == expected[number].size && memcmp(out.text, expected[number].text, (size_t)out.size) == 0;
        free(out.text);
    }
    return equal == ROUNDS ? argument : NULL;
}

static void *cancel(void *session)
{
    smc_cancel(session, 1);
    return NULL;
}

static void test_cancelling_a_run(void)
{
    SmcSession *s;
    uint32_t sm, ss;
    pthread_t thread;

    CHECK(smc_open(NULL, 0, &s) == SMC_OK);
    smc_source_add(s, SMC_KIND_SM, "a.sm", machine, strlen(machine), &sm);
    smc_source_add(s, SMC_KIND_SS, "a.ss", endless, strlen(endless), &ss);
    CHECK(smc_compile(s) == SMC_OK);
    CHECK(pthread_create(&thread, NULL, cancel, s) == 0);
    CHECK(smc_run(s, ss, SMC_ENGINE_VM, UINT64_MAX) == SMC_E_CANCELLED);         // without cancelling, this call would not end
    CHECK(pthread_join(thread, NULL) == 0);
    CHECK(smc_run(s, ss, SMC_ENGINE_VM, 1000) == SMC_E_FAILED && smc_run_outcome(s, ss) == SMC_OUTCOME_ENDLESS);
    CHECK(smc_close(s) == SMC_OK);
}

int main(void)
{
    pthread_t thread[THREADS];

    for (int i = 0; i < THREADS; i++) {
        expected[i] = produce(i);
        CHECK(expected[i].text != NULL && expected[i].size > 1000);
    }
    for (int i = 0; i < THREADS; i++)
        CHECK(pthread_create(&thread[i], NULL, work, &expected[i]) == 0);
    for (int i = 0; i < THREADS; i++) {
        void *result = NULL;
        CHECK(pthread_join(thread[i], &result) == 0 && result == &expected[i]);
    }
    for (int i = 0; i < THREADS; i++)
        free(expected[i].text);
    test_cancelling_a_run();
    return test_end("threads");
}
