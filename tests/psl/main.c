// SPDX-License-Identifier: Apache-2.0
// Runs the contracts one after another: main [NAME...], all of them or those named.
#include "tests/psl/suite.h"

static const struct {
    const char *name;
    Tally (*run)(void);
} contracts[] = {
    {"clock", contract_clock}, {"console", contract_console}, {"lock", contract_lock}, {"thread", contract_thread},
};

static bool is_wanted(const char *name, int argc, char *argv[])
{
    for (int i = 1; i < argc; i++)
        if (strcmp(argv[i], name) == 0)
            return true;
    return argc < 2;
}

int main(int argc, char *argv[])
{
    Tally all = {0, 0};

    for (size_t i = 0; i < COUNT(contracts); i++)
        if (is_wanted(contracts[i].name, argc, argv)) {
            Tally t = contracts[i].run();

            all.passed += t.passed;
            all.failed += t.failed;
        }
    printf("psl-%s: %d passed, %d failed\n", bench.name, all.passed, all.failed);
    return all.failed != 0;
}
