// SPDX-License-Identifier: Apache-2.0
// Runs the contract tests one after another: main [NAME...], all of them or only those named (own: the platform's own tests).
#include "tests/psl/suite.h"

static const struct {
    const char *name;
    Tally (*run)(void);
} contracts[] = {
    {"clock", contract_clock}, {"console", contract_console}, {"lock", contract_lock}, {"thread", contract_thread},
    {"nvm", contract_nvm}, {"log", contract_log}, {"serial", contract_serial}, {"socket", contract_socket},
    {"dio", contract_dio}, {"aio", contract_aio}, {"io", contract_io}, {"watchdog", contract_watchdog},
};

static bool is_wanted(const char *name, int argc, char *argv[])
{
    for (int i = 1; i < argc; i++)
        if (strcmp(argv[i], name) == 0)
            return true;
    return argc < 2;
}

static void add(Tally *all, Tally t)
{
    all->passed += t.passed;
    all->failed += t.failed;
}

int main(int argc, char *argv[])
{
    Tally all = {0, 0};

    bench_begin();
    for (size_t i = 0; i < COUNT(contracts); i++)
        if (is_wanted(contracts[i].name, argc, argv))
            add(&all, contracts[i].run());
    for (size_t i = 0; i < COUNT(bench.own); i++)
        if (bench.own[i] && is_wanted("own", argc, argv))
            add(&all, bench.own[i]());
    add(&all, bench_end());
    printf("psl-%s: %d passed, %d failed\n", bench.name, all.passed, all.failed);
    return all.failed != 0;
}
